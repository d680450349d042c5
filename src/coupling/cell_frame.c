#include "coupling/cell_frame.h"

#include "base/banned.h"

static struct ts_cell_frame make(const struct ts_cell_spans span[3])
{
	struct ts_cell_frame frame = { .n = { 0 } };

	for (int d = 0; d < 3; d++) {
		frame.span[d] = span[d];
		for (int s = 0; s < span[d].n; s++)
			frame.n[d] += span[d].of[s].to - span[d].of[s].from;
	}
	return frame;
}

struct ts_cell_frame ts_cell_frame_of_grid(const struct ts_grid *grid)
{
	struct ts_cell_spans all[3];

	for (int d = 0; d < 3; d++)
		all[d] = (struct ts_cell_spans){ 1, { { 0, grid->n[d] } } };
	return make(all);
}

struct ts_cell_frame ts_cell_frame_of(const struct ts_fluid *fluid)
{
	return fluid->near.active ? make(fluid->near.rank[fluid->slabs->world->rank].cell)
				  : ts_cell_frame_of_grid(&fluid->grid);
}

static int cell_along(const struct ts_cell_spans *spans, int k)
{
	int s = 0;

	for (; k >= spans->of[s].to - spans->of[s].from; s++)
		k -= spans->of[s].to - spans->of[s].from;
	return spans->of[s].from + k;
}

void ts_cell_frame_cell(const struct ts_cell_frame *frame, int32_t number, int cell[3])
{
	cell[0] = cell_along(&frame->span[0], number % frame->n[0]);
	cell[1] = cell_along(&frame->span[1], number / frame->n[0] % frame->n[1]);
	cell[2] = cell_along(&frame->span[2], number / frame->n[0] / frame->n[1]);
}
