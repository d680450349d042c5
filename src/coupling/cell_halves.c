#include "base/clones.h"
TS_UNROLLED
#include "coupling/cell_halves.h"

#include "base/eight.h"

#include "base/banned.h"

typedef int32_t indices __attribute__((vector_size(16)));
typedef double pair __attribute__((vector_size(16)));

/* Adds the halves of four places along a uniform axis to `where`, as ts_halves_find; marks those outside. */
TS_INLINE void find_four(const struct ts_grid *grid, int d, const double *at, ts_four_marks *where,
			 ts_four_marks *outside)
{
	const double *face = grid->face[d], *centre = grid->centre[d];
	const int n = grid->n[d];
	const ts_four x = TS_FOUR_LOAD(at);
	const ts_four_marks in = (x >= face[0]) & (x <= face[n]);
	const ts_four quotient = (x - face[0]) / grid->width[d][0];
	indices cell = __builtin_convertvector((ts_four)((ts_four_marks)quotient & in), indices);
	const indices high = cell > n - 1;
	ts_four_marks half;
	ts_four middle;

	cell = (cell & ~high) | (high & (n - 1));
	middle = TS_TWO_JOIN(((pair){ centre[cell[0]], centre[cell[1]] }),
			     ((pair){ centre[cell[2]], centre[cell[3]] }));
	half = 2 * __builtin_convertvector(cell, ts_four_marks) - (x >= middle);
	*where |= half << TS_HALVES_BITS * d;
	*outside |= ~in;
}

TS_CLONES
static void find_uniform(const struct ts_grid *grid, const double *const x[3], size_t n, uint64_t *where)
{
	for (size_t k = 0; k < n; k += 4) {
		ts_four_marks halves = { 0 }, outside = { 0 };

#pragma GCC unroll 3
		for (int d = 0; d < 3; d++)
			find_four(grid, d, x[d] + k, &halves, &outside);
		*(ts_four_marks_anywhere *)&where[k] =
			(halves & ~outside) | (outside & (long long)TS_HALVES_ELSEWHERE);
	}
}

void ts_halves_find_all(const struct ts_grid *grid, const double *const x[3], size_t n, uint64_t *where)
{
	bool uniform = true;

	for (int d = 0; d < 3; d++)
		uniform &= grid->uniform[d] && grid->n[d] <= 1 << (TS_HALVES_BITS - 1);
	if (uniform) {
		find_uniform(grid, x, n, where);
		return;
	}
	for (size_t k = 0; k < n; k++)
		where[k] = ts_halves_find(grid, (const double[3]){ x[0][k], x[1][k], x[2][k] });
}
