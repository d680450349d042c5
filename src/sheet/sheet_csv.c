/* Comma-separated values: names in the first line, unless all its cells are numbers; then the columns are 1, 2 ... */
#include <stdio.h>
#include <string.h>

#include "io/csv_read.h"
#include "sheet/internal.h"

#include "base/banned.h"

static bool are_numbers(const struct ts_csv *csv)
{
	double value;

	for (size_t k = 0; k < csv->cells; k++)
		if (!ts_parse_real(csv->cell[k], &value))
			return false;
	return csv->cells > 0;
}

static enum ts_status add_names(struct ts_sheet_reader *r, const struct ts_csv *csv, bool numbered,
				struct ts_sheet_names *names)
{
	enum ts_status status = TS_OK;
	char number[24];

	for (size_t k = 0; k < csv->cells && status == TS_OK; k++) {
		snprintf(number, sizeof number, "%zu", k + 1);
		status = ts_sheet_add_name(r, names, numbered ? number : csv->cell[k],
					   strlen(numbered ? number : csv->cell[k]));
	}
	return status;
}

static enum ts_status read_all(struct ts_sheet_reader *r, struct ts_csv *csv)
{
	struct ts_sheet_names names = { 0 };
	enum ts_status status;
	bool more, numbered;

	TS_TRY(ts_csv_next(csv, &more));
	numbered = are_numbers(csv);
	status = add_names(r, csv, numbered, &names);
	if (status == TS_OK)
		status = ts_sheet_begin(r, &names, names.n, "");
	ts_free(names.name);
	if (status == TS_OK && numbered)
		status = ts_sheet_add_row(r, csv->cell, csv->where.line);
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
