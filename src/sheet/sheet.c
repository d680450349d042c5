#include "sheet/sheet.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "sheet/internal.h"

#include "base/banned.h"

size_t ts_sheet_find(const struct ts_sheet *table, const char *name)
{
	int64_t number;

	for (size_t k = 0; k < table->columns; k++)
		if (ts_streq(table->column[k].name, name))
			return k;
	if (ts_parse_int(name, &number) && number >= 1 && (size_t)number <= table->columns)
		return (size_t)number - 1;
	return SIZE_MAX;
}

bool ts_sheet_alike(const struct ts_sheet *a, const struct ts_sheet *b)
{
	for (size_t k = 0; a->columns == b->columns && k < a->columns; k++)
		if (!ts_streq(a->column[k].name, b->column[k].name))
			return false;
	return a->columns == b->columns;
}

void ts_sheet_release(struct ts_sheet *table)
{
	for (size_t k = 0; k < table->columns; k++) {
		ts_free(table->column[k].value);
		ts_free(table->column[k].cell);
	}
	table->columns = table->rows = 0;
}

void ts_sheets_release(struct ts_sheets *t)
{
	for (size_t k = 0; k < t->n; k++)
		ts_sheet_release(&t->sheet[k]);
	ts_free(t->sheet);
	ts_arena_release(&t->arena);
	*t = (struct ts_sheets){ 0 };
}

/* ---- for the readers */

enum ts_status ts_sheet_add_name(struct ts_sheet_reader *r, struct ts_sheet_names *names, const char *name,
				 size_t bytes)
{
	char *copy = ts_arena_alloc(&r->sheets->arena, bytes + 1, 1);

	if (!copy || TS_GROW(names->name, names->capacity, names->n + 1) != TS_OK)
		return ts_nomem(r->err);
	memcpy(copy, name, bytes);
	names->name[names->n++] = copy;
	return TS_OK;
}

/* The name of column k; with a number if one before it has the same. */
static const char *name_column(struct ts_sheet_reader *r, const struct ts_sheet_names *names, size_t k)
{
	struct ts_str text = { 0 };
	const char *copy;
	size_t same = 1;

	for (size_t j = 0; names && j < k; j++)
		same += ts_streq(names->name[j], names->name[k]);
	if (!names)
		ts_str_addf(&text, "%zu", k + 1);
	else if (same > 1)
		ts_str_addf(&text, "%s(%zu)", names->name[k], same);
	else
		ts_str_add(&text, names->name[k]);
	copy = text.failed ? NULL : ts_arena_strdup(&r->sheets->arena, text.text);
	ts_str_release(&text);
	return copy;
}

enum ts_status ts_sheet_begin(struct ts_sheet_reader *r, const struct ts_sheet_names *names, size_t n,
			      const char *title)
{
	struct ts_sheets *t = r->sheets;
	struct ts_sheet table = { .title = ts_arena_strdup(&t->arena, title),
				  .column = ts_arena_alloc(&t->arena, n, sizeof *table.column),
				  .columns = n };

	if (!table.title || !table.column || TS_GROW(t->sheet, t->capacity, t->n + 1) != TS_OK)
		return ts_nomem(r->err);
	t->sheet[t->n++] = table;
	for (size_t k = 0; k < n; k++) {
		table.column[k].name = name_column(r, names, k);
		if (!table.column[k].name)
			return ts_nomem(r->err);
	}
	return TS_OK;
}

bool ts_sheet_number(const char *word, double *out)
{
	static const char *const missing[] = { "",    "-",    "nan", "-nan", "NaN", "NAN",	"NA",
					       "inf", "-inf", "Inf", "-Inf", "?",   "infinity", "-infinity" };

	if (ts_parse_real(word, out))
		return true;
	*out = NAN;
	for (size_t k = 0; k < sizeof missing / sizeof *missing; k++)
		if (ts_streq(word, missing[k]))
			return true;
	return false;
}

static enum ts_status keep_cell(struct ts_sheet_reader *r, struct ts_sheet_column *c, size_t row,
				const char *cell)
{
	if (TS_GROW(c->cell, c->cell_capacity, row + 1) != TS_OK)
		return ts_nomem(r->err);
	c->cell[row] = ts_arena_strdup(&r->sheets->arena, cell);
	return c->cell[row] ? TS_OK : ts_nomem(r->err);
}

enum ts_status ts_sheet_add_row(struct ts_sheet_reader *r, const char *const *cell, int line)
{
	struct ts_sheet *t = &r->sheets->sheet[r->sheets->n - 1];

	for (size_t k = 0; k < t->columns; k++) {
		struct ts_sheet_column *c = &t->column[k];

		if (TS_GROW(c->value, c->capacity, t->rows + 1) != TS_OK)
			return ts_nomem(r->err);
		if (r->sheets->kind == TS_SHEET_CSV)
			TS_TRY(keep_cell(r, c, t->rows, cell[k]));
		if (ts_sheet_number(cell[k], &c->value[t->rows]) || c->text)
			continue;
		c->text = ts_arena_strdup(&r->sheets->arena, cell[k]);
		c->text_line = line;
		if (!c->text)
			return ts_nomem(r->err);
	}
	t->rows++;
	return TS_OK;
}

bool ts_sheet_is_row(const struct ts_lines *l)
{
	double value;

	for (size_t k = 0; k < l->nwords; k++)
		if (!ts_sheet_number(l->word[k], &value))
			return false;
	return l->nwords > 0;
}
