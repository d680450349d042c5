/* The cells by which a rank sorts particles, numbered in the order of the grid: all of them, or those near its own particles
 * (flow/fluid_near.h). */
#ifndef TS_COUPLING_CELL_FRAME_H
#define TS_COUPLING_CELL_FRAME_H

#include "flow/fluid.h"

struct ts_cell_frame {
	struct ts_cell_spans span[3];
	int n[3]; /* cells in the spans of each axis */
};

/* That of all cells of a grid, and of those that this rank has of a fluid. */
struct ts_cell_frame ts_cell_frame_of_grid(const struct ts_grid *grid);
struct ts_cell_frame ts_cell_frame_of(const struct ts_fluid *fluid);

static inline size_t ts_cell_frame_cells(const struct ts_cell_frame *frame)
{
	return (size_t)frame->n[0] * (size_t)frame->n[1] * (size_t)frame->n[2];
}

/* Number of cells along axis d in the frame below cell k of the grid. */
static inline int ts_cell_frame_below(const struct ts_cell_frame *frame, int d, int k)
{
	const struct ts_cell_spans *spans = &frame->span[d];
	int below = 0;

	for (int s = 0; s < spans->n && k > spans->of[s].from; s++)
		below += (k < spans->of[s].to ? k : spans->of[s].to) - spans->of[s].from;
	return below;
}

/* The number of a cell that is in the frame. */
static inline int32_t ts_cell_frame_number(const struct ts_cell_frame *frame, const int cell[3])
{
	return (ts_cell_frame_below(frame, 2, cell[2]) * frame->n[1] +
		ts_cell_frame_below(frame, 1, cell[1])) *
		       frame->n[0] +
	       ts_cell_frame_below(frame, 0, cell[0]);
}

/* The cell of the grid with a number. */
void ts_cell_frame_cell(const struct ts_cell_frame *frame, int32_t number, int cell[3]);

#endif
