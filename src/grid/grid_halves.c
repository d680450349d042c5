#include "grid/grid_halves.h"

#include "base/alloc.h"

#include "base/banned.h"

static struct ts_grid_half make_half(const struct ts_grid *grid, int d, int cell, bool upper)
{
	const int n = grid->n[d], low = upper ? cell : cell - 1;
	const bool periodic = grid->periodic[d], first = cell == 0 && !periodic && n > 1;
	const int centre[2] = { low >= 0   ? low
				: periodic ? n - 1
					   : 0,
				low + 1 < n ? low + 1
				: periodic  ? 0
					    : n - 1 };
	const int face[2] = { first ? 1 : cell, cell < n - 1 ? cell + 1 : periodic || n == 1 ? 0 : n - 1 };
	struct ts_grid_half half = { .centre = grid->centre[d][low],
				     .gap = grid->centre[d][low + 1] - grid->centre[d][low],
				     .face = grid->face[d][cell],
				     .width = grid->width[d][cell],
				     .face_distance = grid->face[d][cell + 1] - grid->face[d][cell],
				     .centre_first = low * grid->stride[d],
				     .face_first = cell * grid->stride[d] };

	for (int k = 0; k < 2; k++) {
		half.centre_at[k] = centre[k] * grid->stride[d];
		half.face_at[k] = face[k] * grid->stride[d];
		half.centre_width[k] = grid->width[d][centre[k]];
		half.face_gap[k] = grid->gap[d][face[k]];
	}
	return half;
}

enum ts_status ts_grid_halves_make(struct ts_grid *grid)
{
	size_t at = 0;

	if (grid->dimensions < 3)
		return TS_OK;
	grid->halves = ts_alloc_aligned(2 * ((size_t)grid->n[0] + (size_t)grid->n[1] + (size_t)grid->n[2]),
					sizeof *grid->halves);
	if (!grid->halves)
		return TS_NOMEM;
	for (int d = 0; d < 3; at += 2 * (size_t)grid->n[d++]) {
		grid->half[d] = grid->halves + at;
		for (int h = 0; h < 2 * grid->n[d]; h++)
			grid->halves[at + (size_t)h] = make_half(grid, d, h / 2, h % 2);
	}
	return TS_OK;
}
