/* The two points along an axis between which a field is interpolated to a place, and the weight of the second. */
#ifndef TS_COUPLING_AXIS_POINTS_H
#define TS_COUPLING_AXIS_POINTS_H

#include "base/inline.h"
#include "coupling/interpolation_weights.h"

struct ts_axis_points {
	int low, high;
	double share;
};

/* Along an axis on which the points are cell centres. */
TS_INLINE struct ts_axis_points ts_axis_points_centres(const struct ts_grid *grid, int d, double x, int cell,
						       enum ts_coupling_interpolation how)
{
	const double *centre = grid->centre[d];
	int n = grid->n[d], low = x < centre[cell] ? cell - 1 : cell;
	struct ts_axis_points out;

	if (how == TS_INTERPOLATE_CELL || grid->ghosts[d] == 0)
		return (struct ts_axis_points){ cell, cell, 0 };
	out.share = (x - centre[low]) / (centre[low + 1] - centre[low]);
	out.low = low >= 0 ? low : grid->periodic[d] ? n - 1 : 0;
	out.high = low + 1 < n ? low + 1 : grid->periodic[d] ? 0 : n - 1;
	return out;
}

/* Along the axis of the component, on which the points are faces. */
TS_INLINE struct ts_axis_points ts_axis_points_faces(const struct ts_grid *grid, int d, double x, int cell,
						     enum ts_coupling_interpolation how)
{
	int n = grid->n[d], last = grid->periodic[d] || n == 1 ? 0 : n - 1;
	bool first = cell == 0 && !grid->periodic[d] && n > 1;

	return (struct ts_axis_points){ first ? 1 : cell, cell == n - 1 ? last : cell + 1,
					how == TS_INTERPOLATE_CELL
						? 0.5
						: (x - grid->face[d][cell]) / grid->width[d][cell] };
}

#endif
