#include "film/grid_lu.h"

#include <math.h>
#include <string.h>

#include "base/alloc.h"

#include "base/banned.h"

enum { SMALLEST_PART = 4 }; /* cells along the longer side of a part that is not divided further */

int ts_grid_lu_neighbour(const struct ts_grid_lu *lu, int cell, int k)
{
	int at[2] = { cell % lu->n[0], cell / lu->n[0] }, d = k / 2;

	at[d] += k % 2 ? 1 : -1;
	if (at[d] < 0 || at[d] >= lu->n[d]) {
		if (!lu->periodic[d])
			return -1;
		at[d] = at[d] < 0 ? lu->n[d] - 1 : 0;
	}
	return at[1] * lu->n[0] + at[0];
}

/* ---- order of elimination */

struct box {
	int lo[2], hi[2]; /* lo <= index < hi */
};

static void number_cells(struct ts_grid_lu *lu, const bool *unknown, const struct box *b)
{
	for (int j = b->lo[1]; j < b->hi[1]; j++)
		for (int i = b->lo[0]; i < b->hi[0]; i++)
			if (unknown[j * lu->n[0] + i]) {
				lu->number[j * lu->n[0] + i] = (int)lu->unknowns;
				lu->cell[lu->unknowns++] = j * lu->n[0] + i;
			}
}

/* Both halves of a box come before the line of cells that separates them. */
static void dissect(struct ts_grid_lu *lu, const bool *unknown, struct box b)
{
	int d = b.hi[1] - b.lo[1] > b.hi[0] - b.lo[0], middle = (b.lo[d] + b.hi[d]) / 2;
	struct box low = b, line = b, high = b;

	if (b.hi[d] - b.lo[d] <= SMALLEST_PART) {
		number_cells(lu, unknown, &b);
		return;
	}
	low.hi[d] = line.lo[d] = middle;
	line.hi[d] = high.lo[d] = middle + 1;
	dissect(lu, unknown, low);
	dissect(lu, unknown, high);
	number_cells(lu, unknown, &line);
}

/* The first line of cells across a periodic axis opens the ring, and comes last. */
static void order_cells(struct ts_grid_lu *lu, const bool *unknown)
{
	struct box inner = { { lu->periodic[0], lu->periodic[1] }, { lu->n[0], lu->n[1] } }, line;

	for (int c = 0; c < lu->n[0] * lu->n[1]; c++)
		lu->number[c] = -1;
	dissect(lu, unknown, inner);
	for (int d = 0; d < 2; d++)
		if (lu->periodic[d]) {
			line = (struct box){ { 0, d == 0 ? lu->periodic[1] : 0 }, { lu->n[0], lu->n[1] } };
			line.hi[d] = 1;
			number_cells(lu, unknown, &line);
		}
}

/* ---- pattern */

/* The columns of row k of L: those on the paths of the elimination tree from the columns of row k of A to k. With
 * `path` NULL only the tree and the number of entries of each column are updated. Columns are written to
 * path[top .. unknowns - 1], each before its ancestors; returns top. */
static size_t row_pattern(struct ts_grid_lu *lu, int k, size_t *count, int *path)
{
	size_t top = lu->unknowns;

	lu->mark[k] = k;
	for (int side = 0; side < TS_GRID_NEIGHBOURS; side++) {
		int cell = ts_grid_lu_neighbour(lu, lu->cell[k], side), i = cell < 0 ? -1 : lu->number[cell];
		size_t length = 0;

		if (i < 0 || i > k)
			continue;
		for (; lu->mark[i] != k; i = lu->parent[i]) {
			lu->mark[i] = k;
			if (count) {
				count[i]++;
				if (lu->parent[i] < 0)
					lu->parent[i] = k;
			} else {
				path[length++] = i;
			}
		}
		while (length > 0)
			path[--top] = path[--length];
	}
	return top;
}

static enum ts_status make_pattern(struct ts_grid_lu *lu)
{
	size_t total = 0;

	for (size_t k = 0; k < lu->unknowns; k++)
		lu->parent[k] = lu->mark[k] = -1;
	for (size_t k = 0; k < lu->unknowns; k++)
		row_pattern(lu, (int)k, lu->end, NULL);
	for (size_t k = 0; k < lu->unknowns; k++) {
		lu->begin[k] = total;
		total += lu->end[k];
	}
	lu->begin[lu->unknowns] = total;
	lu->index = ts_alloc(total, sizeof *lu->index);
	lu->lower = ts_alloc(total, sizeof *lu->lower);
	lu->upper = ts_alloc(total, sizeof *lu->upper);
	return lu->index && lu->lower && lu->upper ? TS_OK : TS_NOMEM;
}

enum ts_status ts_grid_lu_make(struct ts_grid_lu *lu, const int n[2], const bool periodic[2],
			       const bool *unknown)
{
	size_t cells = (size_t)n[0] * (size_t)n[1];

	*lu = (struct ts_grid_lu){ .n = { n[0], n[1] }, .periodic = { periodic[0], periodic[1] } };
	lu->number = ts_alloc(cells, sizeof *lu->number);
	lu->cell = ts_alloc(cells, sizeof *lu->cell);
	if (!lu->number || !lu->cell)
		return TS_NOMEM;
	order_cells(lu, unknown);
	lu->parent = ts_alloc(lu->unknowns, sizeof *lu->parent);
	lu->mark = ts_alloc(lu->unknowns, sizeof *lu->mark);
	lu->path = ts_alloc(lu->unknowns, sizeof *lu->path);
	lu->begin = ts_alloc(lu->unknowns + 1, sizeof *lu->begin);
	lu->end = ts_alloc(lu->unknowns, sizeof *lu->end);
	lu->pivot = ts_alloc(lu->unknowns, sizeof *lu->pivot);
	lu->work = ts_alloc(2 * lu->unknowns, sizeof *lu->work);
	if (!lu->parent || !lu->mark || !lu->path || !lu->begin || !lu->end || !lu->pivot || !lu->work)
		return TS_NOMEM;
	return make_pattern(lu);
}

void ts_grid_lu_release(struct ts_grid_lu *lu)
{
	ts_free(lu->number);
	ts_free(lu->cell);
	ts_free(lu->parent);
	ts_free(lu->begin);
	ts_free(lu->end);
	ts_free(lu->index);
	ts_free(lu->lower);
	ts_free(lu->upper);
	ts_free(lu->pivot);
	ts_free(lu->work);
	ts_free(lu->mark);
	ts_free(lu->path);
	*lu = (struct ts_grid_lu){ .unknowns = 0 };
}

/* ---- numbers */

/* Scatters row k of A left of the diagonal to `row`, and column k above the diagonal to `column`. */
static void scatter(const struct ts_grid_lu *lu, const struct ts_grid_row *a, int k, double *row,
		    double *column)
{
	for (int side = 0; side < TS_GRID_NEIGHBOURS; side++) {
		int cell = ts_grid_lu_neighbour(lu, lu->cell[k], side), i = cell < 0 ? -1 : lu->number[cell];

		if (i < 0 || i > k)
			continue;
		row[i] += a[lu->cell[k]].side[side];
		column[i] += a[cell].side[side ^ 1];
	}
}

/* Computes l_ki and u_ik for column i, and subtracts their products from the rest of row and column k. */
static void eliminate(struct ts_grid_lu *lu, int k, int i, double *row, double *column, double *pivot)
{
	double l = row[i] / lu->pivot[i], u = column[i];
	size_t end = lu->end[i];

	row[i] = column[i] = 0;
	for (size_t e = lu->begin[i]; e < end; e++) {
		row[lu->index[e]] -= l * lu->upper[e];
		column[lu->index[e]] -= u * lu->lower[e];
	}
	*pivot -= l * u;
	lu->index[end] = k;
	lu->lower[end] = l;
	lu->upper[end] = u;
	lu->end[i]++;
}

int ts_grid_lu_factorize(struct ts_grid_lu *lu, const struct ts_grid_row *a)
{
	const double round_off = 1e-14;
	double *row = lu->work, *column = lu->work + lu->unknowns;

	memset(lu->work, 0, 2 * lu->unknowns * sizeof *lu->work);
	for (size_t k = 0; k < lu->unknowns; k++) {
		lu->mark[k] = -1;
		lu->end[k] = lu->begin[k];
	}
	for (int k = 0; k < (int)lu->unknowns; k++) {
		const double centre = a[lu->cell[k]].centre;

		lu->pivot[k] = centre;
		scatter(lu, a, k, row, column);
		for (size_t e = row_pattern(lu, k, NULL, lu->path); e < lu->unknowns; e++)
			eliminate(lu, k, lu->path[e], row, column, &lu->pivot[k]);
		if (!(centre > 0 && lu->pivot[k] > round_off * centre))
			return lu->cell[k];
	}
	return -1;
}

void ts_grid_lu_solve(struct ts_grid_lu *lu, const double *b, double *x)
{
	double *y = lu->work;

	for (size_t k = 0; k < lu->unknowns; k++)
		y[k] = b[lu->cell[k]];
	for (size_t k = 0; k < lu->unknowns; k++)
		for (size_t e = lu->begin[k]; e < lu->end[k]; e++)
			y[lu->index[e]] -= lu->lower[e] * y[k];
	for (size_t k = lu->unknowns; k-- > 0;) {
		for (size_t e = lu->begin[k]; e < lu->end[k]; e++)
			y[k] -= lu->upper[e] * y[lu->index[e]];
		y[k] /= lu->pivot[k];
	}
	for (size_t k = 0; k < lu->unknowns; k++)
		x[lu->cell[k]] = y[k];
}
