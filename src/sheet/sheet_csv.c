/* Comma-separated values: names in the first line. */
#include <string.h>

#include "io/csv_read.h"
#include "sheet/internal.h"

#include "base/banned.h"

static enum ts_status read_all(struct ts_sheet_reader *r, struct ts_csv *csv)
{
	struct ts_sheet_names names = { 0 };
	enum ts_status status;
	bool more;

	TS_TRY(ts_csv_next(csv, &more));
	status = TS_OK;
	for (size_t k = 0; k < csv->cells && status == TS_OK; k++)
		status = ts_sheet_add_name(r, &names, csv->cell[k], strlen(csv->cell[k]));
	if (status == TS_OK)
		status = ts_sheet_begin(r, &names, names.n, "");
	ts_free(names.name);
	while (status == TS_OK && more) {
		status = ts_csv_next(csv, &more);
		if (status != TS_OK || !more)
			break;
		if (csv->cells != names.n)
			return ts_fail(r->err, TS_SYNTAX, &csv->where,
				       "the row has %zu cells, expected %zu as the first line", csv->cells,
				       names.n);
		status = ts_sheet_add_row(r, csv->cell, csv->where.line);
	}
	return status;
}

enum ts_status ts_sheet_read_csv(struct ts_sheet_reader *r)
{
	struct ts_csv csv = { 0 };
	enum ts_status status;

	if (ts_ends_with(r->sheets->path, ".gz"))
		return ts_fail(r->err, TS_SYNTAX, NULL,
			       "comma-separated values are not read compressed: gunzip '%s'",
			       r->sheets->path);
	status = ts_csv_open(&csv, r->files, r->err, r->sheets->path);
	if (status == TS_OK)
		status = read_all(r, &csv);
	ts_csv_close(&csv);
	return status;
}
