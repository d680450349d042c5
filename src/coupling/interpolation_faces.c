#include "coupling/interpolation_faces.h"

#include "base/inline.h"
#include "coupling/axis_points.h"

#include "base/banned.h"

/* The two points along an axis: indices, positions in a field, weights. */
struct axis {
	int index[2];
	ptrdiff_t at[2];
	double weight[2];
};

/* The points of the components: component c has the faces across axis c, and centres along the others. */
struct axes {
	struct axis centre[3], face[3];
};

typedef double pair __attribute__((vector_size(16)));
enum { ROWS = 4 }; /* along x: k & 1 along y, k >> 1 along z */

TS_INLINE struct axis make_axis(const struct ts_grid *grid, int d, struct ts_axis_points points)
{
	return (struct axis){ { points.low, points.high },
			      { points.low * grid->stride[d], points.high * grid->stride[d] },
			      { 1 - points.share, points.share } };
}

TS_INLINE bool has_weights(const struct axis *a)
{
	return a->weight[0] != 0 && a->weight[1] != 0;
}

/* False for particles that need the general functions: a weight is 0, so that the field at its point does not count. */
TS_INLINE bool find_axes(const struct ts_fluid *fluid, const struct ts_coupling_place *at, struct axes *axes)
{
	const struct ts_grid *grid = &fluid->grid;

	if (grid->dimensions < 3)
		return false;
	for (int d = 0; d < 3; d++) {
		if (grid->ghosts[d] == 0)
			return false;
		axes->centre[d] =
			make_axis(grid, d, ts_axis_points_centres(grid, d, at->x[d], at->cell[d], at->how));
		axes->face[d] =
			make_axis(grid, d, ts_axis_points_faces(grid, d, at->x[d], at->cell[d], at->how));
		if (!has_weights(&axes->centre[d]) || !has_weights(&axes->face[d]))
			return false;
	}
	return true;
}

/* The points of component c. */
struct component {
	const struct axis *x, *y, *z;
	ptrdiff_t row[ROWS]; /* the first point of each */
	ptrdiff_t step;	     /* from there to the second one, not 1 across a periodic face */
};

TS_INLINE struct component component_of(const struct ts_grid *grid, const struct axes *axes, int c)
{
	struct component s = { c == 0 ? &axes->face[0] : &axes->centre[0],
			       c == 1 ? &axes->face[1] : &axes->centre[1],
			       c == 2 ? &axes->face[2] : &axes->centre[2],
			       { 0 },
			       0 };

#pragma GCC unroll 4
	for (int k = 0; k < ROWS; k++)
		s.row[k] = (ptrdiff_t)grid->origin + s.x->at[0] + s.y->at[k & 1] + s.z->at[k >> 1];
	s.step = s.x->at[1] - s.x->at[0];
	return s;
}

TS_INLINE pair row_weight(const struct component *s, int k)
{
	return (pair){ s->x->weight[0], s->x->weight[1] } * s->y->weight[k & 1] * s->z->weight[k >> 1];
}

TS_INLINE pair load(const double *from, ptrdiff_t step)
{
	return (pair){ from[0], from[step] };
}

TS_INLINE double add_terms(double sum, pair term)
{
	sum += term[0];
	return sum + term[1];
}

/* ---- the general functions, one component after the other */

static void interpolate_any(const struct ts_fluid *fluid, const struct ts_coupling_place *at,
			    double *const field[3], double out[3])
{
	struct ts_coupling_weights weights[3];

	ts_coupling_weights_faces(fluid, at->x, at->cell, at->how, weights);
	for (int c = 0; c < fluid->grid.dimensions; c++)
		out[c] = ts_coupling_interpolate(&fluid->grid, &weights[c], field[c]);
}

static void gradient_any(const struct ts_fluid *fluid, const struct ts_coupling_place *at,
			 const double *field, double out[3])
{
	struct ts_coupling_weights weights[3];

	ts_coupling_weights_faces(fluid, at->x, at->cell, at->how, weights);
	for (int c = 0; c < fluid->grid.dimensions; c++)
		out[c] = ts_coupling_interpolate_gradient(&fluid->grid, &weights[c], c, field);
}

static void react_any(struct ts_fluid *fluid, const struct ts_coupling_place *at,
		      const struct ts_coupling_reaction *r, double *velocity)
{
	struct ts_coupling_weights weights[3];

	ts_coupling_weights_faces(fluid, at->x, at->cell, at->how, weights);
	for (int c = 0; c < fluid->grid.dimensions; c++) {
		double u;

		if (!r->along[c])
			continue;
		u = ts_coupling_distribute_force(&fluid->grid, &weights[c], c, fluid->u[c], r->amount[c],
						 r->slope ? r->slope[c] : 0, fluid->force[c],
						 r->slope ? fluid->exchange[c] : NULL);
		if (velocity)
			velocity[c] = u;
	}
}

/* ---- all components at once */

void ts_coupling_faces_interpolate(const struct ts_fluid *fluid, const struct ts_coupling_place *at,
				   double *const field[3], double out[3])
{
	struct axes axes;

	if (!find_axes(fluid, at, &axes)) {
		interpolate_any(fluid, at, field, out);
		return;
	}
#pragma GCC unroll 3
	for (int c = 0; c < 3; c++) {
		const struct component s = component_of(&fluid->grid, &axes, c);
		double sum = 0;

#pragma GCC unroll 4
		for (int k = 0; k < ROWS; k++)
			sum = add_terms(sum, row_weight(&s, k) * load(field[c] + s.row[k], s.step));
		out[c] = sum;
	}
}

void ts_coupling_faces_gradient(const struct ts_fluid *fluid, const struct ts_coupling_place *at,
				const double *field, double out[3])
{
	const struct ts_grid *grid = &fluid->grid;
	struct axes axes;

	if (!find_axes(fluid, at, &axes)) {
		gradient_any(fluid, at, field, out);
		return;
	}
#pragma GCC unroll 3
	for (int c = 0; c < 3; c++) {
		const struct component s = component_of(grid, &axes, c);
		const double *below = field - grid->stride[c];
		const double gap[2] = { grid->gap[c][axes.face[c].index[0]],
					grid->gap[c][axes.face[c].index[1]] };
		double sum = 0;

#pragma GCC unroll 4
		for (int k = 0; k < ROWS; k++) {
			const double other = gap[c == 1 ? k & 1 : k >> 1];
			const pair by = { c == 0 ? gap[0] : other, c == 0 ? gap[1] : other };

			sum = add_terms(sum, row_weight(&s, k) *
						     (load(field + s.row[k], s.step) -
						      load(below + s.row[k], s.step)) /
						     by);
		}
		out[c] = sum;
	}
}

/* Widths of the control volumes of component c along axis d. */
TS_INLINE pair widths(const struct ts_grid *grid, int c, int d, const struct axis *a)
{
	const double *of = d == c ? grid->gap[d] : grid->width[d];

	if (d == 2 && grid->by_depth)
		return (pair){ 1, 1 };
	return (pair){ of[a->index[0]], of[a->index[1]] };
}

/* One number after the other: a load of two would wait for the stores of the particle before. */
TS_INLINE void add_to_points(double *field, ptrdiff_t step, pair amount)
{
	field[0] += amount[0];
	field[step] += amount[1];
}

TS_INLINE double react_along(struct ts_fluid *fluid, const struct axes *axes, int c, double amount,
			     double slope, bool rates)
{
	const struct component s = component_of(&fluid->grid, axes, c);
	const pair x = widths(&fluid->grid, c, 0, s.x), y = widths(&fluid->grid, c, 1, s.y),
		   z = widths(&fluid->grid, c, 2, s.z);
	double sum = 0;

#pragma GCC unroll 4
	for (int k = 0; k < ROWS; k++) {
		const pair volume = x * y[k & 1] * z[k >> 1], weight = row_weight(&s, k);
		const pair value = load(fluid->u[c] + s.row[k], s.step);

		sum = add_terms(sum, weight * value);
		add_to_points(fluid->force[c] + s.row[k], s.step, weight * (slope * value - amount) / volume);
		if (rates)
			add_to_points(fluid->exchange[c] + s.row[k], s.step, weight * slope / volume);
	}
	return sum;
}

void ts_coupling_faces_react(struct ts_fluid *fluid, const struct ts_coupling_place *at,
			     const struct ts_coupling_reaction *r, double *velocity)
{
	struct axes axes;

	if (!find_axes(fluid, at, &axes)) {
		react_any(fluid, at, r, velocity);
		return;
	}
#pragma GCC unroll 3
	for (int c = 0; c < 3; c++) {
		double u;

		if (!r->along[c])
			continue;
		u = r->slope ? react_along(fluid, &axes, c, r->amount[c], r->slope[c], true)
			     : react_along(fluid, &axes, c, r->amount[c], 0, false);
		if (velocity)
			velocity[c] = u;
	}
}
