#include "coupling/interpolation_weights.h"

#include <math.h>

#include "base/banned.h"

const char *const ts_coupling_interpolation_names[] = { "linear", "cell", NULL };

bool ts_coupling_locate(const struct ts_fluid *fluid, const double x[3], double place[3], int cell[3])
{
	const struct ts_grid *grid = &fluid->grid;

	for (int d = 0; d < 3; d++) {
		double lo = grid->face[d][0], hi = grid->face[d][grid->n[d]];

		place[d] = x[d];
		if (grid->periodic[d] && !(x[d] >= lo && x[d] <= hi))
			place[d] -= floor((x[d] - lo) / (hi - lo)) * (hi - lo);
		if (grid->periodic[d] || grid->ghosts[d] == 0)
			place[d] = place[d] < lo ? lo : place[d] > hi ? hi : place[d];
		cell[d] = ts_grid_find(grid, d, place[d]);
		if (cell[d] < 0)
			return false;
	}
	return true;
}

static void set_axis_weights(struct ts_coupling_weights *s, int d, int low, int high, double share)
{
	s->index[d][0] = low;
	s->index[d][1] = high;
	s->weight[d][0] = 1 - share;
	s->weight[d][1] = share;
}

/* Weights along an axis on which the points are cell centres. */
static void along_centres(const struct ts_grid *grid, int d, double x, int cell,
			  enum ts_coupling_interpolation how, struct ts_coupling_weights *s)
{
	const double *centre = grid->centre[d];
	int n = grid->n[d], low = x < centre[cell] ? cell - 1 : cell;

	if (how == TS_INTERPOLATE_CELL || grid->ghosts[d] == 0) {
		set_axis_weights(s, d, cell, cell, 0);
		return;
	}
	set_axis_weights(s, d, low, low + 1, (x - centre[low]) / (centre[low + 1] - centre[low]));
	if (low < 0)
		s->index[d][0] = grid->periodic[d] ? n - 1 : 0;
	if (low + 1 >= n)
		s->index[d][1] = grid->periodic[d] ? 0 : n - 1;
}

/* Weights along the axis of the component, on which the points are faces. */
static void along_faces(const struct ts_grid *grid, int d, double x, int cell,
			enum ts_coupling_interpolation how, struct ts_coupling_weights *s)
{
	int n = grid->n[d], last = grid->periodic[d] || n == 1 ? 0 : n - 1;

	set_axis_weights(s, d, cell, cell + 1,
			 how == TS_INTERPOLATE_CELL ? 0.5 : (x - grid->face[d][cell]) / grid->width[d][cell]);
	if (cell == 0 && !grid->periodic[d] && n > 1)
		s->index[d][0] = 1;
	if (cell == n - 1)
		s->index[d][1] = last;
}

void ts_coupling_weights_centre(const struct ts_fluid *fluid, const double place[3], const int cell[3],
				enum ts_coupling_interpolation how, struct ts_coupling_weights *out)
{
	for (int d = 0; d < 3; d++)
		along_centres(&fluid->grid, d, place[d], cell[d], how, out);
}

void ts_coupling_weights_faces(const struct ts_fluid *fluid, const double place[3], const int cell[3],
			       enum ts_coupling_interpolation how, struct ts_coupling_weights out[3])
{
	ts_coupling_weights_centre(fluid, place, cell, how, &out[0]);
	out[1] = out[2] = out[0];
	for (int d = 0; d < 3; d++)
		if (fluid->grid.ghosts[d])
			along_faces(&fluid->grid, d, place[d], cell[d], how, &out[d]);
}

/* Field index and weight of corner b of eight. */
static double corner_weight(const struct ts_grid *grid, const struct ts_coupling_weights *s, int b,
			    size_t *at)
{
	int x = b & 1, y = b >> 1 & 1, z = b >> 2 & 1;

	*at = ts_at(grid, s->index[0][x], s->index[1][y], s->index[2][z]);
	return s->weight[0][x] * s->weight[1][y] * s->weight[2][z];
}

double ts_coupling_interpolate(const struct ts_grid *grid, const struct ts_coupling_weights *s,
			       const double *field)
{
	double sum = 0;

	for (int b = 0; b < 8; b++) {
		size_t at;
		double weight = corner_weight(grid, s, b, &at);

		if (weight != 0)
			sum += weight * field[at];
	}
	return sum;
}

double ts_coupling_interpolate_gradient(const struct ts_grid *grid, const struct ts_coupling_weights *s,
					int c, const double *field)
{
	size_t stride = (size_t)grid->stride[c];
	double sum = 0;

	for (int b = 0; b < 8; b++) {
		size_t at;
		double weight = corner_weight(grid, s, b, &at);

		if (weight != 0)
			sum += weight * (field[at] - field[at - stride]) /
			       grid->gap[c][s->index[c][b >> c & 1]];
	}
	return sum;
}

double ts_coupling_distribute_force(const struct ts_grid *grid, const struct ts_coupling_weights *s, int c,
				    const double *q, double amount, double slope, double *source,
				    double *rate)
{
	double sum = 0;

	for (int b = 0; b < 8; b++) {
		size_t at;
		double weight = corner_weight(grid, s, b, &at), volume = 1;

		if (weight == 0)
			continue;
		for (int d = 0; d < 3; d++) {
			int i = s->index[d][b >> d & 1];

			if (d == 2 && grid->by_depth)
				continue;
			volume *= d == c && grid->ghosts[d] ? grid->gap[d][i] : grid->width[d][i];
		}
		sum += weight * q[at];
		source[at] += weight * (slope * q[at] - amount) / volume;
		if (rate)
			rate[at] += weight * slope / volume;
	}
	return sum;
}
