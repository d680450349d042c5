#include "study/study_runs.h"

#include <errno.h>
#include <inttypes.h>
#include <string.h>

#include "io/csv.h"
#include "io/csv_read.h"
#include "io/replace.h"

#include "base/banned.h"

enum { ENDED_BY_SIGNAL = 128 };

/* Columns in front of the variables, and between variables and results. */
static const char *const front[] = { "run", "script", "version" };
static const char *const middle[] = { "status", "seconds", "off", "error" };
enum { FRONT = sizeof front / sizeof *front, MIDDLE = sizeof middle / sizeof *middle };

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

/* Whether another column than a result has this name. */
static bool is_taken(const struct ts_study_runs *r, const char *name)
{
	bool taken = false;

	for (size_t k = 0; k < FRONT; k++)
		taken |= ts_streq(front[k], name);
	for (size_t k = 0; k < MIDDLE; k++)
		taken |= ts_streq(middle[k], name);
	for (size_t k = 0; k < r->variables; k++)
		taken |= ts_streq(r->variable[k], name);
	return taken;
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
		if ((k >= run->results || !*run->result[k]) && !is_taken(r, ts_str_text(&numbered)))
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
	ts_csv_add_cell(out, run->script);
	ts_str_addf(out, ",%s", run->version);
	for (size_t k = 0; k < r->variables; k++) {
		ts_str_add(out, ",");
		ts_csv_add_cell(out, run->value[k]);
	}
	ts_str_addf(out, ",%d,%.3f,%d,", run->status, run->seconds, run->off);
	ts_csv_add_cell(out, run->error);
	for (size_t k = 0; k < r->results; k++) {
		ts_str_add(out, ",");
		ts_csv_add_cell(out, k < run->results ? run->result[k] : "");
	}
	ts_str_add(out, "\n");
}

static void add_names(const char *const *name, size_t n, struct ts_str *out)
{
	for (size_t k = 0; k < n; k++) {
		if (out->length)
			ts_str_add(out, ",");
		ts_csv_add_cell(out, name[k]);
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

/* A file that is read row by row. */
struct reader {
	struct ts_study_runs *runs;
	struct ts_error *err;
	struct ts_csv csv;
};

/* Compares the columns with the variables of the study; takes over the names of the results. */
static enum ts_status read_names(struct reader *f)
{
	struct ts_study_runs *r = f->runs;
	size_t k = FRONT, results = FRONT + r->variables + MIDDLE;
	bool good = f->csv.cells >= FRONT + MIDDLE && ts_streq(f->csv.cell[0], front[0]) &&
		    ts_streq(f->csv.cell[1], front[1]);

	if (!good)
		return ts_fail(f->err, TS_DAMAGED, &f->csv.where,
			       "this is no table of runs: its columns are not '%s', '%s' ...", front[0],
			       front[1]);
	for (size_t v = 0; v < r->variables && good; v++, k++)
		good = k < f->csv.cells && ts_streq(f->csv.cell[k], r->variable[v]);
	for (size_t m = 0; m < MIDDLE && good; m++, k++)
		good = k < f->csv.cells && ts_streq(f->csv.cell[k], middle[m]);
	if (!good)
		return ts_fail(f->err, TS_STATE, &f->csv.where,
			       "the table has runs of a study with other variables, in another order, or set "
			       "by other -var than this one: give this one another folder, -results FOLDER");
	for (k = results; k < f->csv.cells; k++)
		TS_TRY(add_result(r, f->csv.cell[k], f->err));
	return TS_OK;
}

static enum ts_status read_row(struct reader *f)
{
	struct ts_study_runs *r = f->runs;
	size_t v = r->variables, results = FRONT + v + MIDDLE;
	const char **cell = f->csv.cell, **last = cell + FRONT + v;
	struct ts_study_run run = { .script = cell[1], .version = cell[2], .value = cell + FRONT };
	int64_t status = 0, off = 0;

	if (f->csv.cells != results + r->results)
		return ts_fail(f->err, TS_DAMAGED, &f->csv.where, "expected %zu cells, found %zu",
			       results + r->results, f->csv.cells);
	if (!ts_parse_int(cell[0], &run.number) || !ts_parse_int(last[0], &status) ||
	    !ts_parse_real(last[1], &run.seconds) || !ts_parse_int(last[2], &off))
		return ts_fail(f->err, TS_DAMAGED, &f->csv.where,
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

static enum ts_status read_rows(struct reader *f)
{
	bool more;

	TS_TRY(ts_csv_next(&f->csv, &more));
	if (more)
		TS_TRY(read_names(f));
	while (more) {
		TS_TRY(ts_csv_next(&f->csv, &more));
		if (more)
			TS_TRY(read_row(f));
	}
	return TS_OK;
}

enum ts_status ts_study_runs_read(struct ts_study_runs *runs, struct tsim *sim, const char *path)
{
	struct reader f = { .runs = runs, .err = &sim->error };
	struct stat about;
	enum ts_status status;

	if (ts_files_stat(NULL, path, &about) != 0 && errno == ENOENT)
		return TS_OK;
	path = ts_pool_get(sim->pool, path);
	status = path ? ts_csv_open(&f.csv, NULL, f.err, path) : ts_nomem(f.err);
	if (status == TS_OK)
		status = read_rows(&f);
	ts_csv_close(&f.csv);
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
