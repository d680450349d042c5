#include "report/rows.h"

#include <math.h>

#include "base/alloc.h"

#include "base/banned.h"

struct ts_rows_span {
	double lo, hi; /* NaN: no finite number */
	bool falls;    /* the greatest number came first */
};

enum ts_status ts_rows_begin(struct ts_rows *rows, size_t columns)
{
	ts_rows_release(rows);
	rows->span = ts_alloc(TS_ROWS_MOST * columns, sizeof *rows->span);
	rows->sum = ts_alloc(columns, sizeof *rows->sum);
	rows->columns = columns;
	rows->each = 1;
	return rows->span && rows->sum ? TS_OK : TS_NOMEM;
}

static void merge_span(struct ts_rows_span *a, const struct ts_rows_span *b)
{
	if (isnan(a->lo)) {
		*a = *b;
		return;
	}
	if (isnan(b->lo))
		return;
	if (b->hi > a->hi) {
		a->falls = b->lo < a->lo && b->falls;
		a->hi = b->hi;
	} else if (b->lo < a->lo) {
		a->falls = true;
	}
	a->lo = fmin(a->lo, b->lo);
}

static void merge_rows(struct ts_rows *rows, size_t to, size_t from)
{
	rows->x[to][1] = rows->x[from][1];
	rows->merged[to] += rows->merged[from];
	for (size_t c = 0; c < rows->columns; c++)
		merge_span(&rows->span[to * rows->columns + c], &rows->span[from * rows->columns + c]);
}

static void copy_row(struct ts_rows *rows, size_t to, size_t from)
{
	rows->x[to][0] = rows->x[from][0];
	rows->x[to][1] = rows->x[from][1];
	rows->merged[to] = rows->merged[from];
	for (size_t c = 0; c < rows->columns; c++)
		rows->span[to * rows->columns + c] = rows->span[from * rows->columns + c];
}

/* Merges neighbours, so that half of the places are free. */
static void merge_pairs(struct ts_rows *rows)
{
	for (size_t k = 0; k < TS_ROWS_MOST / 2; k++) {
		copy_row(rows, k, 2 * k);
		merge_rows(rows, k, 2 * k + 1);
	}
	rows->n = TS_ROWS_MOST / 2;
	rows->each *= 2;
}

static void add_to_sum(struct ts_rows_sum *sum, double value)
{
	if (!isfinite(value)) {
		sum->odd++;
		return;
	}
	if (!sum->finite++)
		sum->first = sum->least = sum->greatest = value;
	sum->last = value;
	sum->least = fmin(sum->least, value);
	sum->greatest = fmax(sum->greatest, value);
}

void ts_rows_add(struct ts_rows *rows, double x, const double *values)
{
	const bool joins = rows->n && rows->merged[rows->n - 1] < rows->each;
	size_t at;

	if (!joins && rows->n == TS_ROWS_MOST)
		merge_pairs(rows);
	at = joins ? rows->n - 1 : rows->n++;
	if (!joins) {
		rows->x[at][0] = x;
		rows->merged[at] = 0;
	}
	rows->x[at][1] = x;
	rows->merged[at]++;
	rows->count++;
	for (size_t c = 0; c < rows->columns; c++) {
		const double value = isfinite(values[c]) ? values[c] : NAN;
		const struct ts_rows_span one = { value, value, false };

		if (joins)
			merge_span(&rows->span[at * rows->columns + c], &one);
		else
			rows->span[at * rows->columns + c] = one;
		add_to_sum(&rows->sum[c], values[c]);
	}
}

size_t ts_rows_curve(const struct ts_rows *rows, size_t column, double *x, double *y)
{
	size_t n = 0;

	for (size_t k = 0; k < rows->n; k++) {
		const struct ts_rows_span *s = &rows->span[k * rows->columns + column];
		const bool two = s->lo < s->hi;

		x[n] = rows->x[k][0];
		y[n++] = s->falls ? s->hi : s->lo;
		if (!two)
			continue;
		x[n] = rows->x[k][1];
		y[n++] = s->falls ? s->lo : s->hi;
	}
	return n;
}

bool ts_rows_is_constant(const struct ts_rows *rows, size_t column)
{
	const struct ts_rows_sum *s = &rows->sum[column];

	return s->finite < 2 || !(s->least < s->greatest);
}

void ts_rows_release(struct ts_rows *rows)
{
	ts_free(rows->span);
	ts_free(rows->sum);
	*rows = (struct ts_rows){ 0 };
}
