/* Rows of the log, given to the program; tables in files. */
#include "library/library.h"

#include <inttypes.h>

#include "particle/particles.h"
#include "sheet/sheet_read.h"
#include "thermo/thermo.h"

#include "base/banned.h"

static enum ts_status tell_row(struct tsim *sim)
{
	struct ts_library_rows_told *told = &sim->library->row;
	const struct ts_thermo *t = sim->thermo;
	struct tsim_row row = { .size = sizeof row, .step = sim->clock.step, .time = ts_sim_time(sim) };
	int code;

	if (TS_GROW(told->name, told->name_capacity, t->n) != TS_OK ||
	    TS_GROW(told->value, told->capacity, t->n) != TS_OK)
		return ts_nomem(&sim->error);
	for (size_t k = 0; k < t->n; k++) {
		told->name[k] = t->column[k].title;
		told->value[k] = t->column[k].value;
	}
	row.columns = t->n;
	row.names = told->name;
	row.values = told->value;
	code = told->fn(told->data, &row);
	if (!code)
		return TS_OK;
	return ts_fail(&sim->error, TS_STOPPED, NULL,
		       "the function of tsim_on_row ended the run at step %" PRId64 " with code %d",
		       sim->clock.step, code);
}

void tsim_on_row(struct tsim *sim, tsim_row_fn *fn, void *data)
{
	if (!sim)
		return;
	sim->library->row.fn = fn;
	sim->library->row.data = data;
	sim->row_listener.call = fn ? tell_row : NULL;
}

int tsim_tables(struct tsim *sim, const char *path, size_t *n)
{
	TS_LIBRARY_NEEDS(sim, sim);
	TS_LIBRARY_NEEDS(sim, path);
	TS_LIBRARY_NEEDS(sim, n);

	struct ts_sheets *sheets = &sim->library->sheets;
	enum ts_status status;

	*n = 0;
	ts_sheets_release(sheets);
	*sheets = (struct ts_sheets){ 0 };
	status = ts_sheets_read(sheets, &sim->files, &sim->error, sim->pool, path);
	if (status != TS_OK)
		ts_sheets_release(sheets);
	else
		*n = sheets->n;
	if (status == TS_OK && sheets->torn)
		ts_warn(&sim->log,
			&(struct ts_place){ .file = sheets->path, .text = "", .line = sheets->torn },
			"the last row is not complete; it is left out");
	return ts_library_result(sim, status);
}

static enum ts_status find_table(struct tsim *sim, size_t k, const struct ts_sheet **out)
{
	const struct ts_sheets *sheets = &sim->library->sheets;

	if (k >= sheets->n)
		return ts_fail(&sim->error, TS_UNKNOWN, NULL, "there is no table %zu: %zu tables were read",
			       k, sheets->n);
	*out = &sheets->sheet[k];
	return TS_OK;
}

int tsim_table(struct tsim *sim, size_t k, struct tsim_sheet *out)
{
	TS_LIBRARY_NEEDS(sim, sim);
	TS_LIBRARY_NEEDS(sim, out);

	const struct ts_sheet *table = NULL;
	enum ts_status status = find_table(sim, k, &table);
	struct tsim_sheet full;

	if (status != TS_OK)
		return ts_library_result(sim, status);
	full = (struct tsim_sheet){ .title = table->title, .rows = table->rows, .columns = table->columns };
	ts_library_copy_struct(out, &full, sizeof full);
	return TSIM_OK;
}

int tsim_table_column(struct tsim *sim, size_t k, size_t c, const char **name, const double **values)
{
	TS_LIBRARY_NEEDS(sim, sim);

	const struct ts_sheet *table = NULL;
	enum ts_status status = find_table(sim, k, &table);

	if (status == TS_OK && c >= table->columns)
		status = ts_fail(&sim->error, TS_UNKNOWN, NULL, "the table has no column %zu: it has %zu", c,
				 table->columns);
	if (status != TS_OK)
		return ts_library_result(sim, status);
	if (name)
		*name = table->column[c].name;
	if (values)
		*values = table->column[c].value;
	return TSIM_OK;
}
