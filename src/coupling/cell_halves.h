/* Where a place is in the grid: the halves of cells along the three axes (grid/grid_halves.h) in one number.
 * TS_HALVES_ELSEWHERE: it is not in the grid at its own coordinates, but across a periodic face, or not at all. */
#ifndef TS_COUPLING_CELL_HALVES_H
#define TS_COUPLING_CELL_HALVES_H

#include <stdint.h>

#include "grid/grid.h"

enum { TS_HALVES_BITS = 21 };
#define TS_HALVES_ELSEWHERE (UINT64_C(1) << 63)

/* Half along axis d. */
static inline int ts_halves_of(uint64_t where, int d)
{
	return (int)(where >> TS_HALVES_BITS * d & ((UINT64_C(1) << TS_HALVES_BITS) - 1));
}

static inline uint64_t ts_halves_find(const struct ts_grid *grid, const double x[3])
{
	uint64_t where = 0;

	for (int d = 0; d < 3; d++) {
		const int cell = ts_grid_find(grid, d, x[d]);

		if (cell < 0 || cell >= 1 << (TS_HALVES_BITS - 1))
			return TS_HALVES_ELSEWHERE;
		where |= (2 * (uint64_t)cell + (x[d] >= grid->centre[d][cell])) << TS_HALVES_BITS * d;
	}
	return where;
}

/* Of `n` places in columns, which have room for a multiple of four. In vectors. */
void ts_halves_find_all(const struct ts_grid *grid, const double *const x[3], size_t n, uint64_t *where);

#endif
