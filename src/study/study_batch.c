#include "study/study_batch.h"

#include <errno.h>
#include <inttypes.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "base/clock.h"
#include "base/mkdirs.h"
#include "io/replace.h"
#include "study/study_output.h"

#include "base/banned.h"

enum { MOST_JOBS = 1024, LOOK = 3 /* ms */, PATIENCE = 3 /* s */ };

static const char *keep(struct ts_study *s, struct ts_str *text)
{
	const char *kept = text->failed ? NULL : ts_arena_strdup(&s->arena, ts_str_text(text));

	ts_str_release(text);
	return kept;
}

static const char *path_in(struct ts_study *s, const char *name)
{
	struct ts_str text = { 0 };

	ts_str_addf(&text, "%s/%s", s->folder, name);
	return keep(s, &text);
}

void ts_study_name_values(const struct ts_study *s, const char *const *value, struct ts_str *out)
{
	const char *blank = "";

	for (size_t k = 0; k < s->words.variables; k++) {
		if (s->words.variable[k].role == TS_STUDY_FIXED || !*value[k])
			continue;
		ts_str_addf(out, "%s%s=%s", blank, s->words.variable[k].name, value[k]);
		blank = " ";
	}
}

enum ts_status ts_study_tie(struct ts_study *s, const char **value)
{
	for (size_t k = 0; k < s->words.variables; k++) {
		const struct ts_study_variable *v = &s->words.variable[k];
		double number;

		if (v->role != TS_STUDY_TIED)
			continue;
		if (v->factor == 1) /* exactly: any word, not only numbers */
			value[k] = value[v->tied];
		else if (!ts_parse_real(value[v->tied], &number))
			return ts_study_misuse(s, "'%s' is a multiple of '%s', whose value '%s' is no number",
					       v->name, s->words.variable[v->tied].name, value[v->tied]);
		else
			value[k] = ts_study_words_number(&s->words, v->factor * number);
		if (!value[k])
			return ts_nomem(&s->sim->error);
	}
	return TS_OK;
}

enum ts_status ts_study_write(struct ts_study *s, const char *name, const struct ts_str *text)
{
	struct ts_replace file = { 0 };
	const char *path = path_in(s, name);
	enum ts_status status = path && !text->failed
					? ts_replace_begin(&file, s->sim, &(struct ts_place){ 0 }, path)
					: ts_nomem(&s->sim->error);

	if (status == TS_OK)
		status = ts_replace_write(&file, ts_str_text(text), text->length);
	if (status == TS_OK)
		status = ts_replace_commit(&file, false);
	ts_replace_abandon(&file);
	return status;
}

/* ---- one run */

struct running {
	struct ts_process process;
	struct ts_study_task *task; /* NULL: free */
	int64_t number;
	const char *screen;
};

/* The words that start a script with values of the variables. `folder`: of its log and its variable out; NULL:
 * -check. */
static const char **make_command(struct ts_study *s, const struct ts_study_task *task, const char *folder)
{
	const struct ts_study_input *in = s->in;
	size_t most = 2 * s->words.variables + in->vars.n + in->own.n + 16, n = 0;
	const char **word = ts_arena_alloc(&s->arena, most, sizeof *word);
	struct ts_str log = { 0 };

	if (!word)
		return NULL;
	word[n++] = s->program;
	word[n++] = "-in";
	word[n++] = s->script[task->script].path;
	for (size_t k = 0; k < s->words.variables; k++) {
		if (s->words.variable[k].role == TS_STUDY_FIXED || !*task->value[k])
			continue;
		word[n++] = "-var";
		word[n++] = s->words.variable[k].name;
		word[n++] = task->value[k];
	}
	for (size_t k = 0; k < in->vars.n; k++)
		word[n++] = in->vars.word[k].text;
	for (size_t k = 0; k < in->own.n; k++)
		word[n++] = in->own.word[k].text;
	if (folder ? s->sets_out[task->script] : ts_study_words_find(&s->words, "out") == SIZE_MAX) {
		word[n++] = "-var";
		word[n++] = "out";
		word[n++] = folder ? folder : s->folder;
	}
	if (!folder) {
		word[n++] = "-check";
		return word;
	}
	ts_str_addf(&log, "%s/log", folder);
	word[n++] = "-restart-on-signal";
	word[n++] = "none";
	word[n++] = "-log";
	word[n++] = in->no_log ? "none" : keep(s, &log);
	ts_str_release(&log);
	return word[n - 1] ? word : NULL;
}

static enum ts_status start(struct ts_study *s, struct running *r, struct ts_study_task *task)
{
	struct ts_str text = { 0 };
	const char *folder;

	ts_str_addf(&text, "%s/%" PRId64, s->folder, s->last + 1);
	folder = keep(s, &text);
	if (folder && ts_mkdirs(NULL, folder) != 0)
		return ts_fail(&s->sim->error, TS_IO, NULL, "cannot create the folder '%s': %s", folder,
			       strerror(errno));
	ts_str_addf(&text, "%s/screen", folder ? folder : "");
	*r = (struct running){ .number = ++s->last, .screen = keep(s, &text) };
	if (!folder || !r->screen)
		return ts_nomem(&s->sim->error);
	r->process = (struct ts_process){ .output = r->screen, .follows = true };
	r->process.words = make_command(s, task, folder);
	if (!r->process.words)
		return ts_nomem(&s->sim->error);
	s->started++;
	TS_TRY(ts_process_start(&r->process, &s->sim->error));
	r->task = task;
	return TS_OK;
}

static void print_row(struct ts_study *s, const struct ts_study_run *run, size_t left)
{
	struct ts_str text = { 0 };

	ts_str_addf(&text, "%" PRId64 "  ", run->number);
	if (s->scripts > 1)
		ts_str_addf(&text, "%s  ", run->script);
	ts_study_name_values(s, run->value, &text);
	ts_str_addf(&text, "  %.3g s ", run->seconds);
	if (run->status)
		ts_str_addf(&text, " failed (%d): %s", run->status, run->error);
	else
		for (size_t k = 0, shown = 0; k < run->results && shown < 6; k++)
			if (*run->result[k])
				ts_str_addf(&text, " %s %s%s", s->runs.result[k], run->result[k],
					    ++shown == 6 ? " ..." : "");
	ts_log(&s->sim->log, "%s%s\n", ts_str_text(&text), run->off ? "  off" : "");
	ts_str_release(&text);
	if (left)
		return;
	fflush(s->sim->log.screen);
}

/* The run has ended: its row is added and the table is written. */
static enum ts_status finish(struct ts_study *s, struct running *r, size_t left)
{
	const struct ts_study_script *script = &s->script[r->task->script];
	struct ts_study_run row = { .number = r->number,
				    .script = script->path,
				    .version = script->version,
				    .value = r->task->value,
				    .status = r->process.status,
				    .seconds = r->process.seconds,
				    .error = "" };

	TS_TRY(ts_study_runs_add(&s->runs, &row, &s->sim->error));
	r->task->run = s->runs.n - 1;
	TS_TRY(ts_study_output_read(&s->runs, s->sim, r->screen));
	TS_TRY(ts_study_runs_write(&s->runs, s->sim, s->table));
	print_row(s, &s->runs.run[s->runs.n - 1], left);
	r->task = NULL;
	return TS_OK;
}

static bool any_runs(struct running *r, int n)
{
	for (int k = 0; k < n; k++)
		if (r[k].process.child > 0 && !ts_process_ended(&r[k].process))
			return true;
	return false;
}

static void wait_a_moment(void)
{
	nanosleep(&(struct timespec){ .tv_nsec = LOOK * 1000000L }, NULL);
}

/* Ends all processes: asks first, then insists. */
static void end_all(struct running *r, int n)
{
	double begin = ts_clock();

	for (int k = 0; k < n; k++)
		ts_process_signal(&r[k].process, SIGTERM);
	while (any_runs(r, n) && ts_clock() - begin < PATIENCE)
		wait_a_moment();
	for (int k = 0; k < n; k++)
		ts_process_signal(&r[k].process, SIGKILL);
	while (any_runs(r, n))
		wait_a_moment();
}

static int count_jobs(const struct ts_study *s)
{
	long processors = sysconf(_SC_NPROCESSORS_ONLN);
	int jobs = s->in->jobs ? s->in->jobs : (int)processors / (s->sim->threads > 0 ? s->sim->threads : 1);

	return jobs < 1 ? 1 : jobs > MOST_JOBS ? MOST_JOBS : jobs;
}

static void find_known(const struct ts_study *s, struct ts_study_task *task)
{
	const struct ts_study_script *script = &s->script[task->script];

	task->run = ts_study_runs_find(&s->runs, script->path, script->version, task->value);
}

/* Whether the run is under way for another task. */
static bool is_under_way(const struct ts_study *s, const struct running *slot, int jobs,
			 const struct ts_study_task *task)
{
	for (int k = 0; k < jobs; k++) {
		bool same = slot[k].task && slot[k].task->script == task->script;

		for (size_t v = 0; v < s->words.variables && same; v++)
			same = ts_streq(slot[k].task->value[v], task->value[v]);
		if (same)
			return true;
	}
	return false;
}

/* Empties the values of variables that the script does not use, so that its runs are not repeated for them. */
static void drop_unused(struct ts_study *s, struct ts_study_task *task)
{
	for (size_t k = 0; k < s->words.variables; k++)
		if (!s->uses[task->script * s->words.variables + k])
			task->value[k] = "";
}

/* Starts tasks in free slots. */
static enum ts_status fill_slots(struct ts_study *s, struct running *slot, int jobs,
				 struct ts_study_task *task, size_t n, size_t *next)
{
	for (int k = 0; k < jobs; k++) {
		if (slot[k].task)
			continue;
		for (; *next < n; ++*next) {
			find_known(s, &task[*next]);
			if (task[*next].run == SIZE_MAX && !is_under_way(s, slot, jobs, &task[*next]))
				break;
		}
		if (*next < n)
			TS_TRY(start(s, &slot[k], &task[(*next)++]));
	}
	return TS_OK;
}

static enum ts_status run_slots(struct ts_study *s, struct running *slot, int jobs,
				struct ts_study_task *task, size_t n)
{
	size_t next = 0;
	bool busy = true;

	while (busy) {
		TS_TRY(fill_slots(s, slot, jobs, task, n, &next));
		if (s->sim->requests.stop)
			return ts_fail(&s->sim->error, TS_STOPPED, NULL,
				       "interrupted; the runs that have ended are in %s: the same command "
				       "goes on",
				       s->table);
		busy = next < n;
		for (int k = 0; k < jobs; k++) {
			if (!slot[k].task)
				continue;
			busy = true;
			if (ts_process_ended(&slot[k].process))
				TS_TRY(finish(s, &slot[k], n - next));
		}
		if (busy)
			wait_a_moment();
	}
	return TS_OK;
}

enum ts_status ts_study_run_all(struct ts_study *s, struct ts_study_task *task, size_t n)
{
	int jobs = count_jobs(s);
	struct running *slot = ts_alloc((size_t)jobs, sizeof *slot);
	enum ts_status status;

	if (!slot)
		return ts_nomem(&s->sim->error);
	for (size_t k = 0; k < n; k++) {
		drop_unused(s, &task[k]);
		task[k].run = SIZE_MAX;
	}
	status = run_slots(s, slot, jobs, task, n);
	end_all(slot, jobs);
	for (size_t k = 0; k < n && status == TS_OK; k++)
		if (task[k].run == SIZE_MAX) /* another task has made the same run */
			find_known(s, &task[k]);
	ts_free(slot);
	return status;
}

/* ---- the study */

/* Whether a script uses the variable: -check finds that it does, or, as it may end early with the first values, the
 * name stands in the text. */
static enum ts_status find_use(struct ts_study *s, size_t script, const char *screen, const char *name,
			       bool *uses)
{
	bool unused = false;

	TS_TRY(ts_study_output_unused(s->sim, screen, name, &unused));
	*uses = !unused || ts_study_script_mentions(&s->script[script], name);
	return TS_OK;
}

/* Runs have one working folder; only `out` keeps their files apart. */
static enum ts_status doubt_files(struct ts_study *s, size_t script, const char *screen)
{
	bool writes;

	TS_TRY(ts_study_output_writes(s->sim, screen, &writes));
	if (writes && !s->sets_out[script])
		ts_warn(&s->sim->log, NULL,
			"%s: %s has no variable `out`, so that all runs write the same files; let their "
			"names begin "
			"with ${out}/, which is the folder of the run",
			s->option, s->script[script].path);
	return TS_OK;
}

/* Runs a script with -check: its errors, and the variables it uses. */
static enum ts_status check_script(struct ts_study *s, size_t script, const char *const *first)
{
	struct ts_study_task task = { .script = script, .value = (const char **)first };
	struct ts_process p = { .output = path_in(s, "check.screen"), .follows = true };
	bool *uses = s->uses + script * s->words.variables;
	struct ts_str text = { 0 };
	enum ts_status status;

	p.words = p.output ? make_command(s, &task, NULL) : NULL;
	if (!p.words)
		return ts_nomem(&s->sim->error);
	TS_TRY(ts_process_run(&p, &s->sim->error));
	if (s->sim->requests.stop)
		return ts_fail(&s->sim->error, TS_STOPPED, NULL, "interrupted");
	if (p.status) {
		status = ts_study_output_error(s->sim, p.output, &text);
		if (status == TS_OK)
			status = ts_fail(&s->sim->error, TS_SYNTAX, NULL, "%s: %s does not pass -check: %s",
					 s->option, s->script[script].path, ts_str_text(&text));
		ts_str_release(&text);
		return status;
	}
	for (size_t k = 0; k < s->words.variables; k++)
		TS_TRY(find_use(s, script, p.output, s->words.variable[k].name, &uses[k]));
	TS_TRY(find_use(s, script, p.output, "out", &s->sets_out[script]));
	TS_TRY(doubt_files(s, script, p.output));
	s->sets_out[script] &= ts_study_words_find(&s->words, "out") == SIZE_MAX;
	ts_files_remove(NULL, p.output);
	return TS_OK;
}

/* Each variable is used by one of the scripts. */
static enum ts_status check_variables(struct ts_study *s)
{
	for (size_t k = 0; k < s->words.variables; k++) {
		struct ts_str more = { 0 };
		bool used = false;
		enum ts_status status;

		for (size_t f = 0; f < s->scripts; f++)
			used |= s->uses[f * s->words.variables + k];
		if (used)
			continue;
		ts_study_script_suggest(&s->script[0], s->words.variable[k].name, &more);
		status = ts_study_misuse(s, "%s does not use the variable '%s'%s",
					 s->scripts > 1 ? "none of the scripts" : s->script[0].path,
					 s->words.variable[k].name, ts_str_text(&more));
		ts_str_release(&more);
		return status;
	}
	return TS_OK;
}

static enum ts_status read_scripts(struct ts_study *s)
{
	if (!s->in->scripts.n)
		return ts_study_misuse(s, "%s needs a script: -in FILE", s->option);
	if (s->in->scripts.n > TS_STUDY_MOST_SCRIPTS)
		return ts_study_misuse(s, "%s: at most %d scripts", s->option, TS_STUDY_MOST_SCRIPTS);
	for (size_t k = 0; k < s->in->scripts.n; k++) {
		for (size_t j = 0; j < k; j++)
			if (ts_streq(s->in->scripts.word[j].text, s->in->scripts.word[k].text))
				return ts_study_misuse(s, "%s: the script '%s' is given twice", s->option,
						       s->in->scripts.word[k].text);
		TS_TRY(ts_study_script_read(&s->script[s->scripts++], s->in->scripts.word[k].text, s->sim,
					    &s->arena));
	}
	return TS_OK;
}

/* Reads the table. Rows of another version of a script are no rows of this study. */
static enum ts_status read_table(struct ts_study *s)
{
	for (size_t k = 0; k < s->words.variables; k++)
		TS_TRY(ts_study_runs_add_variable(&s->runs, s->words.variable[k].name, &s->sim->error));
	TS_TRY(ts_study_runs_read(&s->runs, s->sim, s->table));
	for (size_t k = 0; k < s->runs.n; k++) {
		const struct ts_study_run *run = &s->runs.run[k];

		s->last = run->number > s->last ? run->number : s->last;
		for (size_t f = 0; f < s->scripts; f++)
			if (ts_streq(run->script, s->script[f].path) &&
			    !ts_streq(run->version, s->script[f].version))
				return ts_fail(&s->sim->error, TS_STATE, NULL,
					       "%s has runs of '%s' as it was before it was changed: give "
					       "this study another folder, -results FOLDER, or remove the "
					       "old table",
					       s->table, run->script);
	}
	if (s->runs.n)
		ts_log(&s->sim->log, "%zu runs are in %s\n", s->runs.n, s->table);
	return TS_OK;
}

/* Two studies must not write the same table. The lock ends with the process. */
static enum ts_status lock_folder(struct ts_study *s)
{
	const char *path = path_in(s, "lock");

	if (ts_mkdirs(NULL, s->folder) != 0)
		return ts_fail(&s->sim->error, TS_IO, NULL, "cannot create the folder '%s': %s", s->folder,
			       strerror(errno));
	s->lock = path ? ts_files_open(NULL, path, "a") : NULL;
	if (!s->lock)
		return ts_fail(&s->sim->error, TS_IO, NULL, "cannot write in the folder '%s': %s", s->folder,
			       strerror(errno));
	if (lockf(fileno(s->lock), F_TLOCK, 0) != 0 && (errno == EACCES || errno == EAGAIN))
		return ts_fail(&s->sim->error, TS_STATE, NULL,
			       "another study is running in the folder '%s': wait for its end, or give this "
			       "one another folder, -results FOLDER",
			       s->folder);
	return TS_OK;
}

enum ts_status ts_study_open(struct ts_study *s, const char *const *first)
{
	struct ts_str program = { 0 };

	s->folder = s->in->results ? s->in->results : "results";
	s->table = path_in(s, "runs.csv");
	ts_process_self(s->in->called, &program);
	s->program = keep(s, &program);
	TS_TRY(read_scripts(s));
	s->uses = ts_arena_alloc(&s->arena, s->scripts * s->words.variables + 1, sizeof *s->uses);
	if (!s->table || !s->program || !s->uses)
		return ts_nomem(&s->sim->error);
	TS_TRY(lock_folder(s));
	TS_TRY(read_table(s));
	for (size_t k = 0; k < s->scripts; k++)
		TS_TRY(check_script(s, k, first));
	return check_variables(s);
}

int ts_study_end(struct ts_study *s, enum ts_status status, int verdict)
{
	int result = status == TS_OK ? verdict : s->misused ? TS_STUDY_USAGE : EXIT_FAILURE;

	ts_study_release(s);
	return result;
}

void ts_study_release(struct ts_study *s)
{
	if (s->lock)
		fclose(s->lock);
	for (size_t k = 0; k < s->scripts; k++)
		ts_study_script_release(&s->script[k]);
	ts_study_words_release(&s->words);
	ts_study_runs_release(&s->runs);
	ts_arena_release(&s->arena);
}
