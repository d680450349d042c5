/* Trilinear interpolation of fields, exact at boundaries. */
#include "flow/fluid.h"

#include <math.h>

#include "base/inline.h"

#include "base/banned.h"

/* Up to three neighbouring points along an axis, from `first` on. */
struct stencil {
	int first, n;
	double weight[3], slope[3]; /* weights of the value, and of its derivative (1/length) */
};

/* The image of x in the grid along a periodic axis; else the nearest coordinate in the grid. */
static double wrap_or_clamp(const struct ts_grid *grid, int d, double x)
{
	double lo = grid->face[d][0], hi = grid->face[d][grid->n[d]];

	if (x >= lo && x <= hi)
		return x;
	if (grid->periodic[d])
		x -= floor((x - lo) / (hi - lo)) * (hi - lo);
	return x > lo ? x < hi ? x : hi : lo; /* lo also for NaN */
}

static struct stencil linear_stencil(const double *point, int i, double x)
{
	double gap = point[i + 1] - point[i], t = (x - point[i]) / gap;

	return (struct stencil){ i, 2, { 1 - t, t, 0 }, { -1 / gap, 1 / gap, 0 } };
}

/* `i`: the cell of x along the axis, here and below */
static struct stencil at_centres(const struct ts_grid *grid, int d, int i, double x)
{
	if (grid->ghosts[d] == 0) /* two dimensions: no gradient along z */
		return (struct stencil){ 0, 1, { 1, 0, 0 }, { 0, 0, 0 } };
	return linear_stencil(grid->centre[d], x < grid->centre[d][i] ? i - 1 : i, x);
}

/* Between a wall and the first point inside: linear from the velocity given, which is recovered from the
 * ghost. */
static struct stencil beside_wall(const struct ts_grid *grid, int d, enum ts_grid_side side, double x,
				  const double mirror[3])
{
	int n = grid->n[d], low = side == TS_LOW;
	double wall = grid->face[d][low ? 0 : n], point = grid->centre[d][low ? 0 : n - 1];
	double t = (x - wall) / (point - wall), slope = 1 / (point - wall);
	double given = 1 / mirror[0], along1 = -mirror[1] / mirror[0], along2 = -mirror[2] / mirror[0];
	double w[3] = { (1 - t) * given, t + (1 - t) * along1, (1 - t) * along2 };
	double s[3] = { -slope * given, slope * (1 - along1), -slope * along2 };

	if (low)
		return (struct stencil){ -1, 3, { w[0], w[1], w[2] }, { s[0], s[1], s[2] } };
	return (struct stencil){ n - 2, 3, { w[2], w[1], w[0] }, { s[2], s[1], s[0] } };
}

static bool gives_tangential_velocity(enum ts_flow_face face)
{
	return face == TS_FLOW_WALL || face == TS_FLOW_INLET;
}

/* Stencil along axis d for the components of the velocity along the other axes. */
static struct stencil tangential_stencil(const struct ts_fluid *fluid, int d, int i, double x)
{
	const struct ts_grid *grid = &fluid->grid;

	if (!grid->periodic[d] && grid->ghosts[d]) {
		if (x < grid->centre[d][0] && gives_tangential_velocity(fluid->face[d][TS_LOW]))
			return beside_wall(grid, d, TS_LOW, x, fluid->ghost_weights[d][TS_LOW]);
		if (x > grid->centre[d][grid->n[d] - 1] && gives_tangential_velocity(fluid->face[d][TS_HIGH]))
			return beside_wall(grid, d, TS_HIGH, x, fluid->ghost_weights[d][TS_HIGH]);
	}
	return at_centres(grid, d, i, x);
}

/* Two neighbouring points along an axis and the weights of their values: all that most places need. */
struct points {
	ptrdiff_t first; /* in a field */
	double weight[2];
};

/* The most frequent sum of those below. */
TS_INLINE double sum_eight(const struct ts_grid *grid, const double *field, const struct points *x,
			   const struct points *y, const struct points *z)
{
	const double *row = field + (ptrdiff_t)grid->origin + x->first + y->first + z->first;
	const ptrdiff_t sy = grid->stride[1], sz = grid->stride[2];
	double sum = 0;

	sum += z->weight[0] * y->weight[0] * (x->weight[0] * row[0] + x->weight[1] * row[1]);
	sum += z->weight[0] * y->weight[1] * (x->weight[0] * row[sy] + x->weight[1] * row[sy + 1]);
	sum += z->weight[1] * y->weight[0] * (x->weight[0] * row[sz] + x->weight[1] * row[sz + 1]);
	sum += z->weight[1] * y->weight[1] * (x->weight[0] * row[sy + sz] + x->weight[1] * row[sy + sz + 1]);
	return sum;
}

/* Sum over the points of three stencils; along axis `derived` (-1: none) with the weights of the
 * derivative. */
static double sum_stencil(const struct ts_grid *grid, const double *field, const struct stencil *const s[3],
			  int derived)
{
	const double *w[3];
	double sum = 0;

	for (int d = 0; d < 3; d++)
		w[d] = d == derived ? s[d]->slope : s[d]->weight;
	for (int k = 0; k < s[2]->n; k++)
		for (int j = 0; j < s[1]->n; j++) {
			const double *row =
				field + ts_at(grid, s[0]->first, s[1]->first + j, s[2]->first + k);
			double part = 0;

			for (int i = 0; i < s[0]->n; i++)
				part += w[0][i] * row[i];
			sum += w[2][k] * w[1][j] * part;
		}
	return sum;
}

TS_INLINE struct points two_points(const struct ts_grid *grid, int d, const double *point, int low, double x)
{
	double gap = point[low + 1] - point[low], t = (x - point[low]) / gap;

	return (struct points){ low * grid->stride[d], { 1 - t, t } };
}

void ts_fluid_two_points(const struct ts_fluid *fluid, int d, double *low, double *high)
{
	const struct ts_grid *grid = &fluid->grid;
	const bool wall[2] = { !grid->periodic[d] && gives_tangential_velocity(fluid->face[d][TS_LOW]),
			       !grid->periodic[d] && gives_tangential_velocity(fluid->face[d][TS_HIGH]) };

	*low = wall[TS_LOW] ? grid->centre[d][0] : -INFINITY;
	*high = wall[TS_HIGH] ? grid->centre[d][grid->n[d] - 1] : INFINITY;
}

/* Whether there are two points along axis d at x for all components: not in two dimensions. */
static bool has_two_points(const struct ts_fluid *fluid, int d, double x)
{
	double low, high;

	if (fluid->grid.ghosts[d] == 0)
		return false;
	ts_fluid_two_points(fluid, d, &low, &high);
	return x >= low && x <= high;
}

static void velocity_by_stencils(const struct ts_fluid *fluid, const double x[3], const int cell[3],
				 double u[3])
{
	const struct ts_grid *grid = &fluid->grid;
	struct stencil normal[3], tangential[3];

	for (int d = 0; d < 3; d++) {
		tangential[d] = tangential_stencil(fluid, d, cell[d], x[d]);
		normal[d] = grid->ghosts[d] ? linear_stencil(grid->face[d], cell[d], x[d]) : tangential[d];
	}
	for (int c = 0; c < 3; c++) {
		const struct stencil *s[3] = { &tangential[0], &tangential[1], &tangential[2] };

		s[c] = &normal[c];
		u[c] = sum_stencil(grid, fluid->u[c], s, -1);
	}
}

/* The stencils of which velocity_by_stencils takes the sums are those of two points, and the sums have the same order. */
void ts_fluid_velocity_in_cell(const struct ts_fluid *fluid, const double x[3], const int cell[3],
			       double u[3], const double *field, double *value)
{
	const struct ts_grid *grid = &fluid->grid;
	struct points centre[3], face[3];

	for (int d = 0; d < 3; d++) {
		const double *point = grid->centre[d];

		if (!has_two_points(fluid, d, x[d])) {
			velocity_by_stencils(fluid, x, cell, u);
			if (field)
				*value = ts_fluid_value(fluid, field, x, NULL);
			return;
		}
		centre[d] = two_points(grid, d, point, x[d] < point[cell[d]] ? cell[d] - 1 : cell[d], x[d]);
		face[d] = two_points(grid, d, grid->face[d], cell[d], x[d]);
	}
	u[0] = sum_eight(grid, fluid->u[0], &face[0], &centre[1], &centre[2]);
	u[1] = sum_eight(grid, fluid->u[1], &centre[0], &face[1], &centre[2]);
	u[2] = sum_eight(grid, fluid->u[2], &centre[0], &centre[1], &face[2]);
	if (field)
		*value = sum_eight(grid, field, &centre[0], &centre[1], &centre[2]);
}

void ts_fluid_velocity(const struct ts_fluid *fluid, const double x[3], double u[3])
{
	double place[3];
	int cell[3];

	for (int d = 0; d < 3; d++) {
		place[d] = wrap_or_clamp(&fluid->grid, d, x[d]);
		cell[d] = ts_grid_find(&fluid->grid, d, place[d]);
	}
	ts_fluid_velocity_in_cell(fluid, place, cell, u, NULL, NULL);
}

double ts_fluid_value(const struct ts_fluid *fluid, const double *field, const double x[3],
		      double gradient[3])
{
	const struct ts_grid *grid = &fluid->grid;
	struct stencil along[3];
	const struct stencil *s[3] = { &along[0], &along[1], &along[2] };

	for (int d = 0; d < 3; d++) {
		double at = wrap_or_clamp(grid, d, x[d]);

		along[d] = at_centres(grid, d, ts_grid_find(grid, d, at), at);
	}
	for (int d = 0; gradient && d < 3; d++)
		gradient[d] = sum_stencil(grid, field, s, d);
	return sum_stencil(grid, field, s, -1);
}
