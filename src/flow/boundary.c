/* Boundary conditions: types of the faces, velocities given on them, and the check of the net flow. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "core/ranks.h"
#include "flow/projection.h"
#include "flow/void_fraction.h"

#include "base/banned.h"

/* ---- types */

/* Weights of the ghost value of a tangential component at a wall: extrapolation by the parabola through
 * the wall and two points inside, which makes the slope at the wall of second order; or linear through the
 * first point. */
static void set_ghost_weights(struct ts_fluid *fluid, int d, enum ts_grid_side side, bool straight)
{
	const struct ts_grid *grid = &fluid->grid;
	int n = grid->n[d], first = side == TS_LOW ? 0 : n - 1, second = side == TS_LOW ? 1 : n - 2;
	double wall = grid->face[d][side == TS_LOW ? 0 : n];
	double a = fabs(grid->centre[d][first] - wall), b = fabs(grid->centre[d][second] - wall);
	double *mirror = fluid->ghost_weights[d][side];

	mirror[0] = straight ? 2 : 2 * (a + b) / b;
	mirror[1] = straight ? -1 : -(a + b) / (b - a);
	mirror[2] = straight ? 0 : 2 * a * a / (b * (b - a));
}

static enum ts_status refuse_condition(struct tsim *sim, const struct ts_flow_condition *condition, int d,
				       enum ts_grid_side side, const char *why)
{
	return ts_fail(&sim->error, TS_STATE, &condition->where, "flow_boundary %c%s: %s", "xyz"[d],
		       side == TS_LOW ? "lo" : "hi", why);
}

static enum ts_status set_face_type(struct ts_projection *p, struct tsim *sim, int d, enum ts_grid_side side)
{
	struct ts_fluid *fluid = &p->fluid;
	const struct ts_flow_condition *condition = &p->condition[d][side];
	bool flat = d >= fluid->grid.dimensions;

	fluid->face[d][side] = condition->given		 ? condition->kind
			       : fluid->grid.periodic[d] ? TS_FLOW_PERIODIC
			       : flat			 ? TS_FLOW_SLIP
							 : TS_FLOW_WALL;
	if (condition->given && fluid->grid.periodic[d])
		return refuse_condition(sim, condition, d, side,
					"the box is periodic there; choose other faces with the boundary "
					"command");
	if (flat && fluid->face[d][side] != TS_FLOW_SLIP && fluid->face[d][side] != TS_FLOW_PERIODIC)
		return refuse_condition(sim, condition, d, side,
					"with one cell along z nothing varies there: slip or a periodic box "
					"only");
	if (!flat)
		set_ghost_weights(fluid, d, side, p->wall == TS_WALL_LINEAR);
	return TS_OK;
}

enum ts_status ts_projection_set_face_types(struct ts_instance *self, struct tsim *sim)
{
	struct ts_projection *p = self->state;
	struct ts_poisson *poisson = &p->poisson;

	poisson->grid = &p->fluid.grid;
	poisson->singular = true;
	for (int d = 0; d < 3; d++)
		for (int side = 0; side < 2; side++) {
			enum ts_flow_face kind;

			TS_TRY(set_face_type(p, sim, d, (enum ts_grid_side)side));
			kind = p->fluid.face[d][side];
			poisson->condition[d][side] = kind == TS_FLOW_PERIODIC	? TS_PRESSURE_PERIODIC
						      : ts_flow_face_open(kind) ? TS_PRESSURE_GIVEN
										: TS_PRESSURE_NO_GRADIENT;
			if (ts_flow_face_open(kind))
				poisson->singular = false;
		}
	return TS_OK;
}

/* ---- values */

static enum ts_status require_plane(const struct ts_grid *grid, int d, double **plane)
{
	if (!*plane)
		*plane = ts_alloc(ts_flow_plane_size(grid, d), sizeof(double));
	return *plane ? TS_OK : TS_NOMEM;
}

static void free_plane(double **plane)
{
	ts_free(*plane);
	*plane = NULL;
}

static double given_velocity(const struct ts_flow_face_velocity *given, int c, size_t k)
{
	return given->plane[c] ? given->plane[c][k] : given->constant[c];
}

/* Allocates the planes of component c if it varies over the face now, else frees them. Values of the last
 * step are kept. */
static enum ts_status allocate_planes(struct ts_projection *p, int d, enum ts_grid_side side, int c,
				      bool over_face)
{
	struct ts_flow_face_velocity *now = &p->velocity_now[d][side], *before = &p->velocity_before[d][side];
	struct ts_flow_face_velocity *given = &p->fluid.face_velocity[d][side];
	const struct ts_grid *grid = &p->fluid.grid;
	size_t n = ts_flow_plane_size(grid, d);
	bool had = before->plane[c];

	if (over_face)
		TS_TRY(require_plane(grid, d, &now->plane[c]));
	else
		free_plane(&now->plane[c]);
	if (over_face)
		TS_TRY(require_plane(grid, d, &before->plane[c]));
	for (size_t k = 0; over_face && !had && k < n; k++)
		before->plane[c][k] = before->constant[c];
	if (before->plane[c])
		return require_plane(grid, d, &given->plane[c]);
	free_plane(&given->plane[c]);
	return TS_OK;
}

static enum ts_status evaluate_face_now(struct ts_projection *p, struct tsim *sim, int d,
					enum ts_grid_side side)
{
	const struct ts_flow_condition *condition = &p->condition[d][side];
	const struct ts_grid *grid = &p->fluid.grid;
	struct ts_flow_face_velocity *now = &p->velocity_now[d][side];

	if (condition->once && sim->run.inside)
		return TS_OK;
	for (int c = 0; c < grid->dimensions; c++) {
		const struct ts_flow_formula formula = { &condition->velocity[c], "velocity", c };
		bool over_face = ts_flow_condition_shaped(condition) && condition->velocity[c].variable;

		if (allocate_planes(p, d, side, c, over_face) != TS_OK)
			return ts_nomem(&sim->error);
		if (over_face)
			TS_TRY(ts_flow_fill_plane(sim, condition, &formula, grid, d, side, now->plane[c]));
		else
			TS_TRY(ts_flow_formula_value(sim, condition, &formula, &now->constant[c]));
	}
	return ts_projection_evaluate_pressure(p, sim, d, side);
}

static enum ts_status evaluate_face(struct ts_projection *p, struct tsim *sim, int d, enum ts_grid_side side)
{
	enum ts_status status;

	ts_ranks_apart(sim, sim->run.inside && !sim->run.undivided && !p->condition[d][side].once);
	status = evaluate_face_now(p, sim, d, side);
	ts_ranks_apart(sim, false);
	return status;
}

enum ts_status ts_projection_evaluate_boundary(struct ts_instance *self, struct tsim *sim)
{
	struct ts_projection *p = self->state;

	for (int d = 0; d < p->fluid.grid.dimensions; d++)
		for (int side = 0; side < 2; side++)
			TS_TRY(evaluate_face(p, sim, d, (enum ts_grid_side)side));
	/* the time of the last step was another one */
	p->before_known &= p->before_resets == sim->clock.resets;
	p->before_resets = sim->clock.resets;
	p->force_known &= p->before_known;
	if (!p->before_known || (ts_projection_not_started(p) && !sim->run.inside))
		return ts_projection_store_boundary(p) == TS_OK ? TS_OK : ts_nomem(&sim->error);
	return TS_OK;
}

static void store_velocity(const struct ts_grid *grid, int d, const struct ts_flow_face_velocity *now,
			   struct ts_flow_face_velocity *before)
{
	for (int c = 0; c < grid->dimensions; c++) {
		before->constant[c] = now->constant[c];
		if (now->plane[c])
			memcpy(before->plane[c], now->plane[c], ts_flow_plane_size(grid, d) * sizeof(double));
		else
			free_plane(&before->plane[c]);
	}
}

enum ts_status ts_projection_store_boundary(struct ts_projection *p)
{
	for (int d = 0; d < p->fluid.grid.dimensions; d++)
		for (int side = 0; side < 2; side++)
			store_velocity(&p->fluid.grid, d, &p->velocity_now[d][side],
				       &p->velocity_before[d][side]);
	p->before_known = 1;
	return ts_projection_store_pressure(p);
}

static void interpolate_velocity(const struct ts_grid *grid, int d,
				 const struct ts_flow_face_velocity *before,
				 const struct ts_flow_face_velocity *now, double fraction,
				 struct ts_flow_face_velocity *out)
{
	for (int c = 0; c < grid->dimensions; c++) {
		size_t n = out->plane[c] ? ts_flow_plane_size(grid, d) : 0;

		out->constant[c] = ts_flow_interpolate_time(before->constant[c], now->constant[c], fraction);
		for (size_t k = 0; k < n; k++)
			out->plane[c][k] = ts_flow_interpolate_time(given_velocity(before, c, k),
								    given_velocity(now, c, k), fraction);
	}
}

void ts_projection_interpolate_boundary(struct ts_projection *p, double fraction)
{
	for (int d = 0; d < p->fluid.grid.dimensions; d++)
		for (int side = 0; side < 2; side++)
			interpolate_velocity(&p->fluid.grid, d, &p->velocity_before[d][side],
					     &p->velocity_now[d][side], fraction,
					     &p->fluid.face_velocity[d][side]);
}

enum ts_status ts_projection_archive_boundary(struct ts_projection *p, struct tsim *sim,
					      struct ts_archive *archive)
{
	for (int face = 0; face < 6; face++) {
		struct ts_flow_face_velocity *given = &p->velocity_before[face / 2][face % 2];
		char name[32];

		snprintf(name, sizeof name, "given_%d", face);
		TS_TRY(ts_archive_fixed(archive, name, TS_SAVED_F64, given->constant, 3));
		for (int c = 0; c < 3; c++) {
			snprintf(name, sizeof name, "given_%d_%d", face, c);
			if (ts_archive_writing(archive) ? !given->plane[c] : !ts_archive_has(archive, name))
				continue;
			if (require_plane(&p->fluid.grid, face / 2, &given->plane[c]) != TS_OK)
				return ts_nomem(&sim->error);
			TS_TRY(ts_archive_fixed(archive, name, TS_SAVED_F64, given->plane[c],
						ts_flow_plane_size(&p->fluid.grid, face / 2)));
		}
	}
	if (ts_archive_writing(archive) || ts_archive_has(archive, "resets")) /* older files have none */
		TS_TRY(ts_archive_fixed(archive, "resets", TS_SAVED_I64, &p->before_resets, 1));
	return ts_projection_archive_pressure(p, sim, archive);
}

/* ---- net flow */

/* Velocity across a face of the grid, at point `at` of the field: (ia, ib) on the face. Where only some planes are present
 * (fluid->planes) all faces that are not periodic are closed if the net flow is asked for: the velocity on them is the one
 * that the boundary gives. */
static double velocity_across(const struct ts_fluid *fluid, int d, enum ts_grid_side side, size_t at, int ia,
			      int ib)
{
	const struct ts_flow_face_velocity *given = &fluid->face_velocity[d][side];

	if (!ts_fluid_divided(fluid))
		return fluid->u[d][at];
	if (fluid->face[d][side] == TS_FLOW_SLIP)
		return 0;
	return given->plane[d] ? given->plane[d][ts_flow_plane_at(&fluid->grid, d, ia, ib)]
			       : given->constant[d];
}

/* Whether nothing flows through a face now. */
static bool is_tight(const struct ts_fluid *fluid, int d, enum ts_grid_side side)
{
	const struct ts_flow_face_velocity *given = &fluid->face_velocity[d][side];

	return fluid->face[d][side] == TS_FLOW_SLIP || (!given->plane[d] && given->constant[d] == 0);
}

bool ts_projection_is_tight(const struct ts_projection *p)
{
	const struct ts_grid *grid = &p->fluid.grid;
	bool tight = true;

	for (int d = 0; d < grid->dimensions; d++)
		for (int side = 0; side < 2 && !grid->periodic[d]; side++)
			tight &= !p->condition[d][side].velocity[d].variable &&
				 is_tight(&p->fluid, d, (enum ts_grid_side)side);
	return tight;
}

/* Returns the outward volume flow through one face of the grid; adds the sum of magnitudes to *size. */
static double face_outflow(const struct ts_fluid *fluid, int d, enum ts_grid_side side, double *size)
{
	const struct ts_grid *grid = &fluid->grid;
	const int a = d == 0, b = d == 2 ? 1 : 2;
	const size_t first =
		ts_at(grid, 0, 0, 0) + (side == TS_LOW ? 0 : (size_t)(grid->n[d] * grid->stride[d]));
	double sum = 0;

	if (ts_fluid_divided(fluid) && is_tight(fluid, d, side))
		return 0;
	for (int ib = 0; ib < grid->n[b]; ib++)
		for (int ia = 0; ia < grid->n[a]; ia++) {
			size_t at = first + (size_t)(ia * grid->stride[a] + ib * grid->stride[b]);
			double flow = velocity_across(fluid, d, side, at, ia, ib) * grid->width[a][ia] *
				      grid->width[b][ib];

			if (fluid->void_fraction_face[d])
				flow *= fluid->void_fraction_face[d][at];
			sum += flow;
			*size += fabs(flow);
		}
	return side == TS_LOW ? -sum : sum;
}

/* The line of the script for an error about the net flow: the flow_boundary command of the face with the
 * largest part of it. */
static const struct ts_place *place_of_flow(const struct ts_instance *self, double net)
{
	const struct ts_projection *p = self->state;
	const struct ts_grid *grid = &p->fluid.grid;
	const struct ts_place *place = &self->where;
	double most = 0, size = 0;

	for (int d = 0; d < grid->dimensions; d++)
		for (int side = 0; side < 2 && !grid->periodic[d]; side++) {
			double part = face_outflow(&p->fluid, d, (enum ts_grid_side)side, &size) *
				      (net < 0 ? -1 : 1);

			if (p->condition[d][side].given && part > most) {
				most = part;
				place = &p->condition[d][side].where;
			}
		}
	return place;
}

enum ts_status ts_projection_net_outflow(struct ts_instance *self, struct tsim *sim, double *mean)
{
	static const double UNEVEN = 1e-9; /* relative imbalance that is not round-off */
	struct ts_projection *p = self->state;
	const struct ts_grid *grid = &p->fluid.grid;
	double net = 0, size = 0, volume = 1, change;

	*mean = 0;
	if (!p->poisson.singular)
		return TS_OK;
	for (int d = 0; d < grid->dimensions; d++)
		for (int side = 0; side < 2 && !grid->periodic[d]; side++)
			net += face_outflow(&p->fluid, d, (enum ts_grid_side)side, &size);
	if (fabs(net) > UNEVEN * size)
		return ts_fail(&sim->error, TS_PHYSICS, place_of_flow(self, net),
			       "the fluid cannot %s: through all faces together it flows %s at %g per time, "
			       "and it is incompressible; make a face an outlet (flow_boundary xhi outlet) "
			       "or let the velocities given balance",
			       net < 0 ? "leave" : "come in", net < 0 ? "in" : "out", fabs(net));
	for (int d = 0; d < 3; d++)
		volume *= grid->face[d][grid->n[d]] - grid->face[d][0];
	if (ts_projection_void_rate_integral(p, &change) != TS_OK)
		return ts_nomem(&sim->error);
	*mean = (net + change) / volume;
	return TS_OK;
}
