#include "coupling/interpolation_weights.h"

#include "base/clones.h"
#include "base/inline.h"

#include "base/banned.h"

const char *const ts_coupling_interpolation_names[] = { "linear", "cell", NULL };

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

enum { CORNERS = 8 };

/* Indices in a field and weights of the points, x fastest. */
struct corners {
	ptrdiff_t at[CORNERS];
	double weight[CORNERS];
};

TS_INLINE void find_corners(const struct ts_grid *grid, const struct ts_coupling_weights *s,
			    struct corners *out)
{
	for (int b = 0; b < CORNERS; b++) {
		int x = b & 1, y = b >> 1 & 1, z = b >> 2;

		out->at[b] = (ptrdiff_t)ts_at(grid, s->index[0][x], s->index[1][y], s->index[2][z]);
		out->weight[b] = s->weight[0][x] * s->weight[1][y] * s->weight[2][z];
	}
}

/* Terms of points without weight are 0, whatever their fields are. The order of the sum is fixed. */
TS_INLINE double sum_terms(const struct corners *corners, const double term[CORNERS])
{
	double sum = 0;

	for (int b = 0; b < CORNERS; b++)
		sum += corners->weight[b] != 0 ? term[b] : 0;
	return sum;
}

double ts_coupling_interpolate(const struct ts_grid *grid, const struct ts_coupling_weights *s,
			       const double *field)
{
	struct corners corners;
	double term[CORNERS];

	find_corners(grid, s, &corners);
	for (int b = 0; b < CORNERS; b++)
		term[b] = corners.weight[b] * field[corners.at[b]];
	return sum_terms(&corners, term);
}

TS_CLONES
double ts_coupling_interpolate_gradient(const struct ts_grid *grid, const struct ts_coupling_weights *s,
					int c, const double *field)
{
	ptrdiff_t stride = grid->stride[c];
	struct corners corners;
	double term[CORNERS], gap[CORNERS], step[CORNERS];

	find_corners(grid, s, &corners);
	for (int b = 0; b < CORNERS; b++) {
		gap[b] = grid->gap[c][s->index[c][b >> c & 1]];
		step[b] = field[corners.at[b]] - field[corners.at[b] - stride];
	}
#pragma omp simd
	for (int b = 0; b < CORNERS; b++)
		term[b] = corners.weight[b] * step[b] / gap[b];
	return sum_terms(&corners, term);
}

/* Control volumes of the points. */
TS_INLINE void find_volumes(const struct ts_grid *grid, const struct ts_coupling_weights *s, int c,
			    double volume[CORNERS])
{
	double width[3][2];

	for (int d = 0; d < 3; d++)
		for (int side = 0; side < 2; side++)
			width[d][side] =
				(d == c && grid->ghosts[d] ? grid->gap : grid->width)[d][s->index[d][side]];
	for (int b = 0; b < CORNERS; b++) {
		volume[b] = width[0][b & 1] * width[1][b >> 1 & 1];
		if (!grid->by_depth)
			volume[b] *= width[2][b >> 2];
	}
}

TS_CLONES
double ts_coupling_distribute_force(const struct ts_grid *grid, const struct ts_coupling_weights *s, int c,
				    const double *q, double amount, double slope, double *source,
				    double *rate)
{
	struct corners corners;
	double volume[CORNERS], value[CORNERS], force[CORNERS], change[CORNERS], term[CORNERS];

	find_corners(grid, s, &corners);
	find_volumes(grid, s, c, volume);
	for (int b = 0; b < CORNERS; b++)
		value[b] = q[corners.at[b]];
#pragma omp simd
	for (int b = 0; b < CORNERS; b++) {
		force[b] = corners.weight[b] * (slope * value[b] - amount) / volume[b];
		change[b] = corners.weight[b] * slope / volume[b];
		term[b] = corners.weight[b] * value[b];
	}
	for (int b = 0; b < CORNERS; b++) /* two of them may be the same point */
		if (corners.weight[b] != 0) {
			source[corners.at[b]] += force[b];
			if (rate)
				rate[corners.at[b]] += change[b];
		}
	return sum_terms(&corners, term);
}
