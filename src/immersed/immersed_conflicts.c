/* Boundaries and bodies that meet in one place with different velocities: no fluid is there, but the force on a
 * body contains their friction. Surfaces that are so near to each other that the grid does not resolve the fluid between them. */
#include <math.h>

#include "flow/flow_measures.h"
#include "flow/fluid_slabs.h"
#include "immersed/immersed.h"

#include "base/banned.h"

/* Relative difference of velocities that is not round-off. */
static const double UNEQUAL = 1e-9;

static bool differ(double a, double b)
{
	return fabs(a - b) > UNEQUAL * (fabs(a) + fabs(b));
}

/* Velocity of component c on the wall beside a cell. */
static double wall_velocity(const struct ts_fluid *fluid, int c, int d, int side, const int i[3])
{
	const struct ts_flow_face_velocity *given = &fluid->face_velocity[d][side];
	int a = d == 0, b = d == 2 ? 1 : 2;

	return given->plane[c] ? given->plane[c][ts_flow_plane_at(&fluid->grid, d, i[a], i[b])]
			       : given->constant[c];
}

/* Whether the body covers a part of this wall on which the velocity along it is not that of the body. */
static bool rubs_on_wall(const struct ts_immersed *ib, const struct ts_fluid *fluid, int d, int side)
{
	const struct ts_grid *grid = &fluid->grid;

	for (int c = 0; c < grid->dimensions; c++)
		for (size_t k = ib->first[c]; c != d && k < ib->first[c + 1]; k++) {
			const struct ts_immersed_point *p = &ib->point[k];
			int i[3];

			ts_grid_indices(grid, p->at, i);
			if (!p->outside && i[d] == (side ? grid->n[d] - 1 : 0) &&
			    differ(p->target, wall_velocity(fluid, c, d, side, i)))
				return true;
		}
	return false;
}

void ts_immersed_warn_walls(struct tsim *sim, const struct ts_place *where, const struct ts_immersed *ib,
			    const struct ts_fluid *fluid)
{
	for (int face = 0; face < 2 * fluid->grid.dimensions; face++)
		if (fluid->face[face / 2][face % 2] == TS_FLOW_WALL &&
		    ts_fluid_slabs_most(fluid, rubs_on_wall(ib, fluid, face / 2, face % 2)) > 0)
			ts_warn(&sim->log, where,
				"fix immersed/boundary: the body covers a part of the wall %s, which has "
				"another velocity than the body: the force on the body contains their "
				"friction; use `flow_boundary %s slip`",
				ts_flow_face_names[face], ts_flow_face_names[face]);
}

enum ts_status ts_immersed_warn_overlap(struct tsim *sim, const struct ts_place *where,
					const struct ts_immersed *a, const struct ts_immersed *b,
					const struct ts_fluid *fluid, const char *other)
{
	double *target = ts_alloc(fluid->grid.size, sizeof *target);
	size_t first, end;
	int64_t number = 0;

	if (!target)
		return ts_nomem(&sim->error);
	ts_fluid_slabs_values(fluid, &first, &end);
	for (int c = 0; c < fluid->grid.dimensions; c++) {
		for (size_t k = first; k < end; k++)
			target[k] = NAN;
		for (size_t k = a->first[c]; k < a->first[c + 1]; k++)
			if (!a->point[k].outside)
				target[a->point[k].at] = a->point[k].target;
		for (size_t k = b->first[c]; k < b->first[c + 1]; k++)
			number += !b->point[k].outside && differ(target[b->point[k].at], b->point[k].target);
	}
	ts_free(target);
	if (ts_fluid_divided(fluid))
		ts_world_sum(fluid->slabs->world, &number);
	if (number)
		ts_warn(&sim->log, where,
			"fix immersed/boundary: the body and that of fix %s overlap with different "
			"velocities, at %lld points of velocities: the forces on both contain their friction",
			other, (long long)number);
	return TS_OK;
}

/* ---- gaps */

static void sample_position(const struct ts_grid *grid, int component, const struct ts_immersed_sample *s,
			    double x[3])
{
	int i[3];

	ts_grid_indices(grid, s->corner, i);
	for (int d = 0; d < 3; d++) {
		const double *line = d == component ? grid->face[d] : grid->centre[d];

		x[d] = line[i[d]] + (s->t[d] != 0 ? s->t[d] * (line[i[d] + 1] - line[i[d]]) : 0);
	}
}

/* The position that many spacings beyond an outer point, along the normal of the surface. */
static void position_across(const struct ts_immersed *ib, const struct ts_fluid *fluid, int component,
			    const struct ts_immersed_outer *b, double spacings, double to[3])
{
	const struct ts_grid *grid = &fluid->grid;
	const struct ts_immersed_sample point = { .corner = ib->point[b->point].at };
	double x[3], y[3];

	sample_position(grid, component, &point, to);
	sample_position(grid, component, &b->out[0], x);
	sample_position(grid, component, &b->out[1], y);
	for (int d = 0; d < 3; d++) {
		double step = y[d] - x[d], period = grid->face[d][grid->n[d]] - grid->face[d][0];

		if (grid->periodic[d])
			step -= period * round(step / period);
		to[d] += spacings * step;
	}
}

/* Whether the point is nearer to the surface than half a spacing. */
static bool is_near(const struct ts_immersed_outer *b)
{
	return b->out[1].count > -0.5 / 2.5;
}

/* *faces: whether a surface of the solid lies less than about three cells opposite that of the body of `ib`. */
static enum ts_status find_gap(const struct ts_immersed *ib, struct ts_solid *solid,
			       const struct ts_fluid *fluid, bool *faces)
{
	static const double spacings[] = { 1.5, 2.5 }; /* a body is at least a spacing thick */
	double(*x)[3] = ts_alloc(2 * ib->nouter + 1, sizeof *x),
	*distance = ts_alloc(2 * ib->nouter + 1, sizeof *distance);
	enum ts_status status = x && distance ? TS_OK : TS_NOMEM;
	size_t n = 0;

	for (int c = 0; status == TS_OK && c < fluid->grid.dimensions; c++)
		for (size_t k = ib->outer_first[c]; k < ib->outer_first[c + 1]; k++)
			for (int which = 0; which < 2 && is_near(&ib->outer[k]); which++) {
				position_across(ib, fluid, c, &ib->outer[k], spacings[which], x[n]);
				distance[n++] = INFINITY;
			}
	if (status == TS_OK)
		status = ts_immersed_distances(solid, &fluid->grid, n, (const double(*)[3])x,
					       fluid->grid.width[0][0], distance);
	*faces = false;
	for (size_t k = 0; status == TS_OK && k < n; k++)
		*faces |= distance[k] < 0;
	*faces = ts_fluid_slabs_most(fluid, *faces) > 0;
	ts_free(x);
	ts_free(distance);
	return status;
}

enum ts_status ts_immersed_warn_gap(struct tsim *sim, const struct ts_place *where,
				    const struct ts_immersed *ib, struct ts_solid *solid,
				    const struct ts_fluid *fluid, const char *other)
{
	bool faces;
	enum ts_status status = find_gap(ib, solid, fluid, &faces);

	if (status == TS_OK && faces)
		ts_warn(&sim->log, where,
			"fix immersed/boundary: %s%s are opposite each other with fewer than three cells "
			"between them: the flow there, and the forces, may be wrong by more than 10 %%",
			other ? "the body and that of fix " : "surfaces of the body", other ? other : "");
	return status == TS_NOMEM ? ts_nomem(&sim->error) : status;
}
