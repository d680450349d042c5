#include "crosscheck/crosscheck.h"

#include <inttypes.h>
#include <string.h>

#include "base/process.h"
#include "core/arg.h"
#include "crosscheck/difference_report.h"
#include "crosscheck/folder.h"
#include "crosscheck/inputs.h"
#include "crosscheck/meaning.h"
#include "crosscheck/outputs.h"
#include "explain/price.h"

#include "base/banned.h"

enum { MOST_WORDS = 600, LAST_LINES = 6 };

struct options {
	int program;
	const char *peer, *keep;
	double tolerance, statistics;
	int64_t until;
	bool legacy;
};

/* Commands by which the other program is started, and its Debian package. */
static const char *const program_names[] = { "liggghts", "lammps", NULL };
static const struct {
	const char *const *commands, *package;
	const char *legacy; /* word after -legacy for its results, or NULL */
} peers[] = {
	{ (const char *const[]){ "liggghts", "lmp_liggghts", "lmp_auto", NULL }, "liggghts", NULL },
	{ (const char *const[]){ "lmp", "lmp_serial", "lmp_mpi", "lammps", NULL }, "lammps", "lammps" },
};

static const struct ts_arg rows[] = {
	TS_ENUM("program", struct options, program, program_names, .flags = TS_POSITIONAL,
		.help = "the program to compare with"),
	TS_REAL("tolerance", struct options, tolerance, .fallback = "1e-6", .unit = "", .range = TS_POSITIVE,
		.help = "largest difference, relative to the range of the column, up to which runs agree"),
	TS_INT("until", struct options, until, .flags = TS_OPTIONAL, .unit = "step", .range = TS_NOT_NEGATIVE,
	       .help = "runs that diverge after this step agree if their statistics do"),
	TS_REAL("statistics", struct options, statistics, .fallback = "0.05", .unit = "",
		.range = TS_POSITIVE,
		.help = "largest difference of mean, standard deviation and distribution in that case"),
	TS_BOOL("legacy", struct options, legacy, .fallback = "yes",
		.help = "run tsim with -legacy, with lammps with `-legacy lammps`"),
	TS_WORD("peer", struct options, peer, .flags = TS_OPTIONAL,
		.help = "file or command of the other program, if its name is not a usual one"),
	TS_WORD("keep", struct options, keep, .flags = TS_OPTIONAL,
		.help = "new folder in which the files of both runs are kept; default: they are removed"),
	TS_ARGS_END,
};

struct crosscheck {
	struct tsim *sim;
	const struct ts_crosscheck_input *in;
	struct options o;
	struct ts_str *text;
	struct ts_arena arena;
	struct ts_meanings meanings;
	struct ts_inputs inputs;
	struct ts_outputs outputs;
	struct ts_pairing thermo;
	const char *name[TS_NPROGRAMS], *command[TS_NPROGRAMS], *place[TS_NPROGRAMS], *screen[TS_NPROGRAMS];
	struct ts_process process[TS_NPROGRAMS];
	const char *root;
	int64_t diverged_at;	    /* first step at which an output diverges; -1: none, or no step known */
	const char *diverged_in[2]; /* its column and output; NULL: none */
};

static enum ts_status keep_text(struct crosscheck *c, struct ts_str *text, const char **out)
{
	*out = text->failed ? NULL : ts_arena_strdup(&c->arena, ts_str_text(text));
	ts_str_clear(text);
	return *out ? TS_OK : ts_nomem(&c->sim->error);
}

static bool find_peer(struct crosscheck *c, struct ts_str *path)
{
	const char *const *command = peers[c->o.program].commands;

	if (c->o.peer)
		return ts_process_find(c->o.peer, path);
	while (*command && !ts_process_find(*command, path))
		command++;
	return *command != NULL;
}

static void report_absent(struct crosscheck *c)
{
	const char *const *command = peers[c->o.program].commands;

	if (c->o.peer) {
		ts_str_addf(c->text, "program '%s' not found\n", c->o.peer);
		return;
	}
	ts_str_addf(c->text, "%s is not installed: not found in the PATH:", c->name[TS_PEER]);
	for (; *command; command++)
		ts_str_addf(c->text, " %s%s", *command, command[1] ? "," : "");
	ts_str_addf(c->text, "; install it (apt-get install %s) or give its path: -crosscheck %s peer FILE\n",
		    peers[c->o.program].package, c->name[TS_PEER]);
}

/* A program that MPI_Abort ends loses its buffered output; stdbuf makes it line-buffered. */
static enum ts_status make_command(struct crosscheck *c, int who)
{
	const struct ts_crosscheck_input *in = c->in;
	const char **words = ts_arena_alloc(&c->arena, MOST_WORDS + 12, sizeof *words);
	struct ts_str path = { 0 };
	size_t n = 0;

	if (!words)
		return ts_nomem(&c->sim->error);
	if (who == TS_PEER && ts_process_find("stdbuf", &path)) {
		TS_TRY(keep_text(c, &path, &words[n++]));
		words[n++] = "-oL";
	}
	ts_str_release(&path);
	words[n++] = c->command[who];
	words[n++] = "-in";
	words[n++] = in->script;
	for (size_t k = 0; k < in->vars.n && n < MOST_WORDS; k++)
		words[n++] = in->vars.word[k].text;
	for (size_t k = 0; who == TS_SELF && k < in->own.n && n < MOST_WORDS; k++)
		words[n++] = in->own.word[k].text;
	if (who == TS_SELF && c->o.legacy) {
		words[n++] = "-legacy";
		if (peers[c->o.program].legacy)
			words[n++] = peers[c->o.program].legacy;
	}
	c->process[who].words = words;
	return TS_OK;
}

/* Appends the last lines that a program printed; if there are error messages, from the first of them on. */
static enum ts_status add_last_output(struct crosscheck *c, int who)
{
	struct ts_lines l = { 0 };
	const char *last[LAST_LINES] = { NULL };
	size_t n = 0, errors = 0;
	enum ts_status status;
	bool more = true;

	status = ts_lines_open(&l, NULL, &c->sim->error, c->sim->pool, NULL, c->screen[who]);
	while (status == TS_OK && more) {
		struct ts_str line = { 0 };
		bool error;

		status = ts_lines_next_filled(&l, &more);
		if (status != TS_OK || !more)
			break;
		ts_str_addf(&line, "%*s", l.nwords ? 4 + (int)(l.word[0] - l.line) : 0, "");
		for (size_t k = 0; k < l.nwords; k++)
			ts_str_addf(&line, "%s%s", k ? " " : "", l.word[k]);
		error = strstr(ts_str_text(&line), "ERROR") || strstr(ts_str_text(&line), "error:");
		if (error && !errors)
			n = 0;
		errors += error;
		if (error || !errors || n < 3)
			status = keep_text(c, &line, &last[n++ % LAST_LINES]);
		ts_str_release(&line);
	}
	ts_lines_close(&l);
	for (size_t k = n > LAST_LINES ? n - LAST_LINES : 0; k < n && status == TS_OK; k++)
		ts_str_addf(c->text, "%s\n", last[k % LAST_LINES]);
	return status;
}

/* Runs a program in the folder ROOT/PROGRAM, with copies of the input files of the script. */
static enum ts_status run_program(struct crosscheck *c, int who)
{
	struct ts_str text = { 0 };
	struct ts_process *p = &c->process[who];
	const char *base;
	enum ts_status status;

	ts_str_addf(&text, "%s/%s", c->root, c->name[who]);
	status = keep_text(c, &text, &base);
	if (status == TS_OK)
		status = ts_inputs_copy(&c->inputs, base, &text);
	if (status == TS_OK)
		status = keep_text(c, &text, &c->place[who]);
	ts_str_addf(&text, "%s/%s.screen", c->root, c->name[who]);
	if (status == TS_OK)
		status = keep_text(c, &text, &c->screen[who]);
	ts_str_release(&text);
	TS_TRY(status);
	*p = (struct ts_process){ .folder = c->place[who], .output = c->screen[who] };
	TS_TRY(make_command(c, who));
	TS_TRY(ts_process_run(p, &c->sim->error));
	ts_str_addf(c->text, "%-10s %s in %.2f s\n", c->name[who], p->status ? "failed" : "ran", p->seconds);
	if (!p->status)
		return TS_OK;
	ts_str_addf(c->text, "    exit status %d; last lines of output:\n", p->status);
	return add_last_output(c, who);
}

/* Pairs the thermo outputs on the screens, then the output files. */
static enum ts_status pair_outputs(struct crosscheck *c)
{
	struct ts_outputs *o = &c->outputs;
	struct ts_pairing *thermo = &c->thermo;

	*thermo = (struct ts_pairing){ .name = "thermo", .kind = TS_FRAMES_THERMO };
	for (int who = 0; who < TS_NPROGRAMS; who++) {
		const char **files = ts_arena_alloc(&c->arena, 2, sizeof *files);
		struct ts_str name = { 0 };

		if (!files)
			return ts_nomem(&c->sim->error);
		ts_str_addf(&name, "%s.screen", c->name[who]);
		TS_TRY(keep_text(c, &name, &files[0]));
		ts_str_release(&name);
		thermo->folder[who] = c->root;
		thermo->file[who] = files;
		TS_TRY(ts_folder_list(c->place[who], TS_INPUT_DATE, &o->listing[who], c->sim->pool,
				      &c->sim->error));
	}
	return ts_outputs_pair(o, c->place, &c->sim->error, c->sim->pool);
}

static struct ts_pairing *output_pairing(struct crosscheck *c, size_t k)
{
	return k ? &c->outputs.pairing[k - 1] : &c->thermo;
}

static void update_divergence(struct crosscheck *c, const struct ts_pairing *p, int64_t step,
			      const char *column)
{
	if (p->lines ? c->diverged_in[0] != NULL : c->diverged_at >= 0 && step >= c->diverged_at)
		return;
	c->diverged_at = p->lines ? -1 : step;
	c->diverged_in[0] = column;
	c->diverged_in[1] = p->name;
}

/* The first step at which an output diverges; -1: none. */
static int64_t first_divergence(struct crosscheck *c, const struct ts_pairing *p)
{
	int64_t first = p->unmatched_at;

	if (p->unmatched_at >= 0)
		update_divergence(c, p, p->unmatched_at, "rows");
	for (size_t k = 0; k < p->columns; k++) {
		const struct ts_compared *column = &p->column[k];

		if (!column->diverged || column->differs_on_purpose)
			continue;
		update_divergence(c, p, column->diverged_at, column->name);
		first = first < 0 || column->diverged_at < first ? column->diverged_at : first;
	}
	return first;
}

static enum ts_status compare_all(struct crosscheck *c)
{
	struct ts_error *err = &c->sim->error;
	size_t n = c->outputs.n + 1;
	int64_t *first = ts_arena_alloc(&c->arena, n, sizeof *first);

	if (!first)
		return ts_nomem(err);
	c->diverged_at = -1;
	for (size_t k = 0; k < n; k++) {
		output_pairing(c, k)->meanings = &c->meanings;
		TS_TRY(ts_compare(output_pairing(c, k), c->o.tolerance, err, c->sim->pool));
		first[k] = first_divergence(c, output_pairing(c, k));
	}
	for (size_t k = 0; k < n; k++) {
		struct ts_pairing *p = output_pairing(c, k);
		int64_t from = p->lines ? first[k] : c->diverged_at;

		if (from >= 0)
			TS_TRY(ts_compare_statistics(p, from, err, c->sim->pool));
	}
	return TS_OK;
}

static void list_files(const char *what, const char **name, size_t n, struct ts_str *out)
{
	for (size_t k = 0; k < n && k < 10; k++)
		ts_str_addf(out, "%s%s", k ? ", " : what, name[k]);
	if (n > 10)
		ts_str_addf(out, " and %zu more", n - 10);
	if (n)
		ts_str_add(out, "\n");
}

/* Whether the statistics of all columns agree within the tolerance; *worst: the largest difference. */
static bool statistics_agree(struct crosscheck *c, struct ts_str *worst)
{
	double most = 0;

	for (size_t k = 0; k <= c->outputs.n; k++) {
		const struct ts_pairing *p = output_pairing(c, k);

		for (size_t m = 0; m < p->columns; m++) {
			const struct ts_compared *column = &p->column[m];
			double far = fmax(column->mean, fmax(column->deviation, column->quantiles));

			if (far <= most || column->differs_on_purpose)
				continue;
			most = far;
			ts_str_clear(worst);
			ts_str_addf(worst, "%.2g (%s of %s)", far, column->name, p->name);
		}
	}
	return most <= c->o.statistics;
}

static enum ts_verdict judge_statistics(struct crosscheck *c)
{
	struct ts_str worst = { 0 };
	bool agree = statistics_agree(c, &worst);
	bool good = agree && c->o.until != INT64_MIN && c->diverged_at > c->o.until;

	ts_str_addf(c->text, "%s: %s of %s differs by more than %g of its range", good ? "agree" : "differ",
		    c->diverged_in[0], c->diverged_in[1], c->o.tolerance);
	if (c->diverged_at >= 0)
		ts_str_addf(c->text, " at step %" PRId64, c->diverged_at);
	ts_str_addf(c->text, "; statistics from there differ by at most %s\n",
		    worst.length ? ts_str_text(&worst) : "0");
	ts_str_release(&worst);
	return good ? TS_AGREE : TS_DIFFER;
}

static bool columns_missing(struct crosscheck *c)
{
	for (size_t k = 0; k <= c->outputs.n; k++) {
		const struct ts_pairing *p = output_pairing(c, k);

		for (size_t m = 0; m < p->columns; m++)
			if (ts_compare_lacks(&p->column[m], TS_SELF) ||
			    ts_compare_lacks(&p->column[m], TS_PEER))
				return true;
	}
	return false;
}

static enum ts_verdict judge(struct crosscheck *c)
{
	struct ts_outputs *o = &c->outputs;
	size_t columns = 0;
	bool lost = o->nonly[TS_SELF] || o->nonly[TS_PEER];

	for (size_t k = 0; k <= o->n; k++)
		columns += output_pairing(c, k)->columns;
	ts_str_add(c->text, "\n");
	list_files("only tsim wrote ", o->only[TS_SELF], o->nonly[TS_SELF], c->text);
	list_files(c->o.program ? "only lammps wrote " : "only liggghts wrote ", o->only[TS_PEER],
		   o->nonly[TS_PEER], c->text);
	list_files("left empty by tsim, not compared: ", o->empty[TS_SELF], o->nempty[TS_SELF], c->text);
	list_files(c->o.program ? "left empty by lammps, not compared: "
				: "left empty by liggghts, not compared: ",
		   o->empty[TS_PEER], o->nempty[TS_PEER], c->text);
	list_files("not plain text, not compared: ", o->skipped, o->nskipped, c->text);
	if (!columns) {
		ts_str_add(c->text, "failed: no outputs to compare\n");
		return TS_FAILED;
	}
	if (lost) {
		ts_str_add(c->text, "failed: outputs are missing\n");
		return TS_FAILED;
	}
	if (columns_missing(c)) {
		ts_str_add(c->text, "failed: columns are missing\n");
		return TS_FAILED;
	}
	if (!c->diverged_in[0]) {
		ts_str_addf(c->text, "agree: %zu columns within %g of their range\n", columns,
			    c->o.tolerance);
		return TS_AGREE;
	}
	return judge_statistics(c);
}

static enum ts_verdict compare_runs(struct crosscheck *c)
{
	if (c->process[TS_SELF].status || c->process[TS_PEER].status) {
		ts_str_addf(c->text, "failed: %s\n",
			    !c->process[TS_PEER].status	  ? "tsim did not complete the script"
			    : !c->process[TS_SELF].status ? "the other program did not complete the script"
							  : "neither program completed the script");
		return TS_FAILED;
	}
	if (pair_outputs(c) != TS_OK || compare_all(c) != TS_OK)
		return TS_FAILED;
	for (size_t k = 0; k <= c->outputs.n; k++)
		if (output_pairing(c, k)->columns || k)
			ts_report_pairing(output_pairing(c, k), c->diverged_in[0] != NULL, c->name[TS_PEER],
					  c->text);
	return judge(c);
}

static enum ts_verdict run_and_compare(struct crosscheck *c, struct ts_str *path)
{
	struct ts_error *err = &c->sim->error;
	enum ts_verdict verdict;

	if (!find_peer(c, path)) {
		report_absent(c);
		return TS_ABSENT;
	}
	if (keep_text(c, path, &c->command[TS_PEER]) != TS_OK)
		return TS_FAILED;
	ts_process_self(c->in->called, path);
	if (keep_text(c, path, &c->command[TS_SELF]) != TS_OK ||
	    ts_inputs_find(&c->inputs, c->in->script, c->in->vars) != TS_OK)
		return TS_FAILED;
	if (c->o.keep)
		c->root = ts_folder_new(c->o.keep, err) == TS_OK ? c->o.keep : NULL;
	else if (ts_folder_scratch(path, err) != TS_OK || keep_text(c, path, &c->root) != TS_OK)
		c->root = NULL;
	if (!c->root)
		return TS_FAILED;
	verdict = run_program(c, TS_SELF) == TS_OK && run_program(c, TS_PEER) == TS_OK ? compare_runs(c)
										       : TS_FAILED;
	if (c->o.keep)
		ts_str_addf(c->text, "files kept in %s\n", c->root);
	else
		ts_folder_remove(c->root);
	return verdict;
}

enum ts_verdict ts_crosscheck(struct tsim *sim, const struct ts_crosscheck_input *input, struct ts_str *text)
{
	struct crosscheck c = { .sim = sim,
				.in = input,
				.text = text,
				.meanings = { .err = &sim->error, .pool = sim->pool },
				.inputs = {
					.err = &sim->error, .pool = sim->pool, .meanings = &c.meanings } };
	struct ts_place where = { .file = "-crosscheck" };
	struct ts_str path = { 0 };
	enum ts_verdict verdict = TS_USAGE;

	if (!input->script) {
		ts_fail(&sim->error, TS_SYNTAX, NULL, "-crosscheck needs a script: -in FILE");
	} else if (ts_args_parse(sim, "-crosscheck", rows, input->words, &where, &c.arena, &c.o) == TS_OK) {
		c.name[TS_SELF] = "tsim";
		c.name[TS_PEER] = program_names[c.o.program];
		verdict = run_and_compare(&c, &path);
	}
	ts_str_release(&path);
	ts_inputs_release(&c.inputs);
	ts_meanings_release(&c.meanings);
	ts_outputs_release(&c.outputs);
	ts_compare_release(&c.thermo);
	ts_arena_release(&c.arena);
	return verdict;
}

void ts_crosscheck_help(struct ts_str *out)
{
	for (const struct ts_arg *row = rows + 1; row->type != TS_ARG_END; row++) {
		struct ts_str synopsis = { 0 };

		ts_arg_synopsis(row, &synopsis);
		ts_str_addf(out, "  %-22s %s", ts_str_text(&synopsis), row->help);
		ts_str_addf(out, row->fallback ? " (%s)\n" : "\n", row->fallback);
		out->failed |= synopsis.failed;
		ts_str_release(&synopsis);
	}
}
