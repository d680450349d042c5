#include "study/study_runs.h"

#include <errno.h>
#include <inttypes.h>
#include <string.h>

#include "io/replace.h"

#include "base/banned.h"

enum { ENDED_BY_SIGNAL = 128 };

/* Columns in front of the variables, and between variables and results. */
static const char *const front[] = { "run", "script", "version" };
static const char *const middle[] = { "status", "seconds", "off", "error" };
enum { FRONT = sizeof front / sizeof *front, MIDDLE = sizeof middle / sizeof *middle };

void ts_study_runs_cell(struct ts_str *out, const char *text)
{
	if (!strpbrk(text, ",\"\n")) {
		ts_str_add(out, text);
		return;
	}
	ts_str_add(out, "\"");
	for (; *text; text++)
		ts_str_add_n(out, *text == '"' ? "\"\"" : *text == '\n' ? " " : text, *text == '"' ? 2 : 1);
	ts_str_add(out, "\"");
}

static enum ts_status add_name(struct ts_study_runs *r, const char ***list, size_t *n, size_t *capacity,
			       const char *name, struct ts_error *err)
{
	const char *copy = ts_arena_strdup(&r->arena, name);

	if (!copy || TS_GROW(*list, *capacity, *n + 1) != TS_OK)
		return ts_nomem(err);
	(*list)[(*n)++] = copy;
	return TS_OK;
}

enum ts_status ts_study_runs_add_variable(struct ts_study_runs *r, const char *name, struct ts_error *err)
{
	return add_name(r, &r->variable, &r->variables, &r->variable_capacity, name, err);
}

static enum ts_status add_result(struct ts_study_runs *r, const char *name, struct ts_error *err)
{
	return add_name(r, &r->result, &r->results, &r->result_capacity, name, err);
}

size_t ts_study_runs_result(const struct ts_study_runs *r, const char *name)
{
	for (size_t k = 0; k < r->results; k++)
		if (ts_streq(r->result[k], name))
			return k;
	return SIZE_MAX;
}

bool ts_study_runs_value(const struct ts_study_run *run, size_t result, double *out)
{
	return run->status == 0 && result < run->results && ts_parse_real(run->result[result], out);
}

enum ts_status ts_study_runs_add(struct ts_study_runs *r, const struct ts_study_run *run,
				 struct ts_error *err)
{
	struct ts_study_run *to;
	bool bad;

	if (TS_GROW(r->run, r->capacity, r->n + 1) != TS_OK)
		return ts_nomem(err);
	to = &r->run[r->n];
	*to = *run;
	to->script = ts_arena_strdup(&r->arena, run->script);
	to->version = ts_arena_strdup(&r->arena, run->version);
	to->error = ts_arena_strdup(&r->arena, run->error);
	to->value = ts_arena_alloc(&r->arena, r->variables + 1, sizeof *to->value);
	to->result = NULL;
	to->results = 0;
	bad = !to->script || !to->version || !to->error || !to->value;
	for (size_t k = 0; k < r->variables && !bad; k++)
		bad = !(to->value[k] = ts_arena_strdup(&r->arena, run->value[k]));
	if (bad)
		return ts_nomem(err);
	r->n++;
	return TS_OK;
}

/* Makes room in a row for all results. */
static enum ts_status widen(struct ts_study_runs *r, struct ts_study_run *run, struct ts_error *err)
{
	const char **more;

	if (run->results >= r->results)
		return TS_OK;
	more = ts_arena_alloc(&r->arena, r->results, sizeof *more);
	if (!more)
		return ts_nomem(err);
	for (size_t k = 0; k < r->results; k++)
		more[k] = k < run->results ? run->result[k] : "";
	run->result = more;
	run->results = r->results;
	return TS_OK;
}

enum ts_status ts_study_runs_set_result(struct ts_study_runs *r, const char *name, const char *value,
					struct ts_error *err)
{
	struct ts_study_run *run = &r->run[r->n - 1];
	struct ts_str numbered = { 0 };
	enum ts_status status = TS_OK;
	size_t k;

	ts_str_add(&numbered, name);
	for (int again = 2;; again++) {
		k = ts_study_runs_result(r, ts_str_text(&numbered));
		if (k >= run->results || !*run->result[k])
			break;
		ts_str_clear(&numbered);
		ts_str_addf(&numbered, "%s_%d", name, again);
	}
	if (numbered.failed)
		status = ts_nomem(err);
	if (status == TS_OK && k == SIZE_MAX) {
		k = r->results;
		status = add_result(r, ts_str_text(&numbered), err);
	}
	ts_str_release(&numbered);
	TS_TRY(status);
	TS_TRY(widen(r, run, err));
	run->result[k] = ts_arena_strdup(&r->arena, value);
	return run->result[k] ? TS_OK : ts_nomem(err);
}

size_t ts_study_runs_find(const struct ts_study_runs *r, const char *script, const char *version,
			  const char *const *value)
{
	for (size_t k = 0; k < r->n; k++) {
		const struct ts_study_run *run = &r->run[k];
		bool same = run->status < ENDED_BY_SIGNAL && ts_streq(run->script, script) &&
			    ts_streq(run->version, version);

		for (size_t v = 0; v < r->variables && same; v++)
			same = ts_streq(run->value[v], value[v]);
		if (same)
			return k;
	}
	return SIZE_MAX;
}

/* ---- the file */

static void add_row(const struct ts_study_runs *r, const struct ts_study_run *run, struct ts_str *out)
{
	ts_str_addf(out, "%" PRId64 ",", run->number);
	ts_study_runs_cell(out, run->script);
	ts_str_addf(out, ",%s", run->version);
	for (size_t k = 0; k < r->variables; k++) {
		ts_str_add(out, ",");
		ts_study_runs_cell(out, run->value[k]);
	}
	ts_str_addf(out, ",%d,%.3f,%d,", run->status, run->seconds, run->off);
	ts_study_runs_cell(out, run->error);
	for (size_t k = 0; k < r->results; k++) {
		ts_str_add(out, ",");
		ts_study_runs_cell(out, k < run->results ? run->result[k] : "");
	}
	ts_str_add(out, "\n");
}

static void add_names(const char *const *name, size_t n, struct ts_str *out)
{
	for (size_t k = 0; k < n; k++) {
		if (out->length)
			ts_str_add(out, ",");
		ts_study_runs_cell(out, name[k]);
	}
}

enum ts_status ts_study_runs_write(const struct ts_study_runs *r, struct tsim *sim, const char *path)
{
	struct ts_replace file = { 0 };
	struct ts_str text = { 0 };
	enum ts_status status;

	add_names(front, FRONT, &text);
	add_names(r->variable, r->variables, &text);
	add_names(middle, MIDDLE, &text);
	add_names(r->result, r->results, &text);
	ts_str_add(&text, "\n");
	for (size_t k = 0; k < r->n; k++)
		add_row(r, &r->run[k], &text);
	status = text.failed ? ts_nomem(&sim->error)
			     : ts_replace_begin(&file, sim, &(struct ts_place){ 0 }, path);
	if (status == TS_OK)
		status = ts_replace_write(&file, text.text, text.length);
	if (status == TS_OK)
		status = ts_replace_commit(&file, false);
	ts_replace_abandon(&file);
	ts_str_release(&text);
	return status;
}

/* A file that is read cell by cell. */
struct reader {
	struct ts_study_runs *runs;
	struct ts_error *err;
	struct ts_place where;
	char *at;	   /* next cell; NULL: end of the line */
	char *line;	   /* next line */
	const char **cell; /* [cells]: of the present line */
	size_t cells, capacity;
};

/* Takes a cell off the line, without its quotes. */
static char *next_cell(struct reader *f)
{
	char *begin = f->at, *to = begin, *from = begin;
	bool quoted = *from == '"';

	from += quoted;
	begin = to = from;
	while (*from && (quoted || *from != ',')) {
		if (quoted && *from == '"' && *++from != '"') {
			quoted = false;
			continue;
		}
		*to++ = *from++;
	}
	f->at = *from == ',' ? from + 1 : NULL;
	*to = '\0';
	return begin;
}

static enum ts_status next_line(struct reader *f, bool *more)
{
	char *end;

	*more = *f->line;
	if (!*more)
		return TS_OK;
	f->where.line++;
	f->at = f->line;
	end = f->line + strcspn(f->line, "\n");
	f->line = *end ? end + 1 : end;
	*end = '\0';
	if (end > f->at && end[-1] == '\r')
		end[-1] = '\0';
	for (f->cells = 0; f->at; f->cells++) {
		if (TS_GROW(f->cell, f->capacity, f->cells + 1) != TS_OK)
			return ts_nomem(f->err);
		f->cell[f->cells] = next_cell(f);
	}
	return TS_OK;
}

/* Compares the columns with the variables of the study; takes over the names of the results. */
static enum ts_status read_names(struct reader *f)
{
	struct ts_study_runs *r = f->runs;
	size_t k = FRONT, results = FRONT + r->variables + MIDDLE;
	bool good = f->cells >= FRONT + MIDDLE && ts_streq(f->cell[0], front[0]) &&
		    ts_streq(f->cell[1], front[1]);

	if (!good)
		return ts_fail(f->err, TS_DAMAGED, &f->where,
			       "this is no table of runs: its columns are not '%s', '%s' ...", front[0],
			       front[1]);
	for (size_t v = 0; v < r->variables && good; v++, k++)
		good = k < f->cells && ts_streq(f->cell[k], r->variable[v]);
	for (size_t m = 0; m < MIDDLE && good; m++, k++)
		good = k < f->cells && ts_streq(f->cell[k], middle[m]);
	if (!good)
		return ts_fail(f->err, TS_STATE, &f->where,
			       "the table has runs of a study with other variables, in another order, or set "
			       "by other -var than this one: give this one another folder, -results FOLDER");
	for (k = results; k < f->cells; k++)
		TS_TRY(add_result(r, f->cell[k], f->err));
	return TS_OK;
}

static enum ts_status read_row(struct reader *f)
{
	struct ts_study_runs *r = f->runs;
	size_t v = r->variables, results = FRONT + v + MIDDLE;
	const char **cell = f->cell, **last = cell + FRONT + v;
	struct ts_study_run run = { .script = cell[1], .version = cell[2], .value = cell + FRONT };
	int64_t status = 0, off = 0;

	if (f->cells != results + r->results)
		return ts_fail(f->err, TS_DAMAGED, &f->where, "expected %zu cells, found %zu",
			       results + r->results, f->cells);
	if (!ts_parse_int(cell[0], &run.number) || !ts_parse_int(last[0], &status) ||
	    !ts_parse_real(last[1], &run.seconds) || !ts_parse_int(last[2], &off))
		return ts_fail(f->err, TS_DAMAGED, &f->where,
			       "expected numbers in the columns run, status, seconds and off");
	run.status = (int)status;
	run.off = (int)off;
	run.error = last[3];
	TS_TRY(ts_study_runs_add(r, &run, f->err));
	TS_TRY(widen(r, &r->run[r->n - 1], f->err));
	for (size_t k = 0; k < r->results; k++)
		if (!(r->run[r->n - 1].result[k] = ts_arena_strdup(&r->arena, cell[results + k])))
			return ts_nomem(f->err);
	return TS_OK;
}

static enum ts_status read_text(struct ts_study_runs *runs, const char *path, char *text,
				struct ts_error *err)
{
	struct reader f = { .runs = runs, .err = err, .where = { .file = path }, .line = text };
	bool more = true;
	enum ts_status status = next_line(&f, &more);

	if (status == TS_OK && more)
		status = read_names(&f);
	while (status == TS_OK && more) {
		status = next_line(&f, &more);
		if (status == TS_OK && more)
			status = read_row(&f);
	}
	ts_free(f.cell);
	return status;
}

enum ts_status ts_study_runs_read(struct ts_study_runs *runs, struct tsim *sim, const char *path)
{
	struct ts_error *err = &sim->error;
	FILE *file = ts_files_open(NULL, path, "r");
	struct ts_str text = { 0 };
	char bytes[4096];
	enum ts_status status;
	size_t n;
	bool bad;

	if (!file && errno == ENOENT)
		return TS_OK;
	if (!file)
		return ts_fail(err, TS_IO, NULL, "cannot read '%s': %s", path, strerror(errno));
	ts_str_add(&text, "");
	while ((n = fread(bytes, 1, sizeof bytes, file)) > 0)
		ts_str_add_n(&text, bytes, n);
	bad = ferror(file) != 0;
	fclose(file);
	if (bad)
		status = ts_fail(err, TS_IO, NULL, "reading '%s' failed", path);
	else
		status = text.failed || !text.text
				 ? ts_nomem(err)
				 : read_text(runs, ts_pool_get(sim->pool, path), text.text, err);
	ts_str_release(&text);
	return status;
}

void ts_study_runs_release(struct ts_study_runs *r)
{
	ts_free(r->variable);
	ts_free(r->result);
	ts_free(r->run);
	ts_arena_release(&r->arena);
	*r = (struct ts_study_runs){ 0 };
}
