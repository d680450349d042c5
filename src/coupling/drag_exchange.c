/* Momentum exchange of drag: the reaction on the fluid, and the correction of the forces on particles
 * after its step. */

#include <math.h>
#include <string.h>

#include "base/alloc.h"

#include "coupling/drag_exchange.h"
#include "coupling/drag_slip.h"
#include "coupling/interpolation_faces.h"
#include "flow/projection.h"
#include "particle/particles.h"

#include "base/banned.h"

double ts_drag_steps_to_fluid(const struct ts_drag *s)
{
	const struct ts_projection *p = s->flow->state;

	return p->waited + 1 >= p->every ? (double)p->every : 0;
}

struct reactions {
	struct ts_drag *drag;
	struct ts_cell_numbers force, slope;
};

/* Adds the reaction to the drag on one particle to the fluid. */
static void add_reaction(void *context, size_t row)
{
	const struct reactions *r = context;
	struct ts_drag *s = r->drag;
	struct ts_fluid *fluid = s->fluid;
	struct ts_coupling_place at = { .how = (enum ts_coupling_interpolation)s->interpolation };
	const struct ts_coupling_reaction reaction = { ts_cell_numbers_of(&r->force, row),
						       s->lagged ? NULL : ts_cell_numbers_of(&r->slope, row),
						       { ts_drag_acts_along(s, 0), ts_drag_acts_along(s, 1),
							 ts_drag_acts_along(s, 2) } };

	if (ts_cell_order_locate(&s->order, fluid, row, at.x, at.cell))
		ts_coupling_faces_react(fluid, &at, &reaction,
					row < r->force.n ? s->exchange[row].fluid_velocity : NULL);
}

/* While the particles are divided among ranks: force and slope of a particle side by side, for one message. */
static enum ts_status put_together(struct ts_drag *s, size_t n)
{
	TS_TRY(TS_RENEW_UNSET(s->both, s->both_capacity, n));
	for (size_t i = 0; i < n; i++) {
		memcpy(s->both[i], s->total.note[i], 3 * sizeof(double));
		memcpy(s->both[i] + 3, s->exchange[i].slope, 3 * sizeof(double));
	}
	return TS_OK;
}

static enum ts_status share_reactions(struct ts_drag *s, struct tsim *sim, struct reactions *r)
{
	if (!sim->division) {
		TS_TRY(ts_cell_order_share(&s->order, sim, (const double *)s->total.note,
					   TS_PARTICLE_TALLY_MOST, 3, &r->force));
		return ts_cell_order_share(&s->order, sim, (const double *)s->exchange, /* begins with it */
					   sizeof *s->exchange / sizeof(double), 3, &r->slope);
	}
	if (put_together(s, sim->particles->n) != TS_OK)
		return ts_nomem(&sim->error);
	TS_TRY(ts_cell_order_share(&s->order, sim, (const double *)s->both, 6, s->lagged ? 3 : 6, &r->force));
	r->slope = r->force;
	r->slope.own += 3;
	r->slope.other += 3;
	return TS_OK;
}

enum ts_status ts_drag_add_to_fluid(struct ts_instance *self, struct tsim *sim)
{
	struct ts_drag *s = self->state;
	struct reactions reactions = { .drag = s };

	if (!s->sorted)
		TS_TRY(ts_cell_order_make(&s->order, sim, s->fluid, self->group, 1));
	TS_TRY(share_reactions(s, sim, &reactions));
	ts_cell_order_each(&s->order, ts_team(sim, s->order.sort->of.n), add_reaction, &reactions);
	s->fluid->apart = sim->division;
	s->nexchange = sim->particles->n;
	return TS_OK;
}

/* Adds B (u' - u) to the force on particle i. */
static void correct_particle(const struct ts_instance *self, const struct tsim *sim,
			     const struct ts_fluid *fluid, size_t i, double share)
{
	struct ts_drag *s = self->state;
	struct ts_particles *p = sim->particles;
	struct ts_coupling_place at = { .how = (enum ts_coupling_interpolation)s->interpolation };
	double later[3], more[3] = { 0 };
	const double *slope = s->exchange[i].slope;

	if (slope[0] == 0 && slope[1] == 0 && slope[2] == 0)
		return;
	if (!ts_coupling_locate(fluid, p->x[i], at.x, at.cell))
		return;
	ts_coupling_faces_interpolate(fluid, &at, fluid->exchange_velocity, later);
	for (int c = 0; c < fluid->grid.dimensions; c++) {
		if (slope[c] == 0)
			continue;
		more[c] = slope[c] * (later[c] - s->exchange[i].fluid_velocity[c]);
		s->total.note[i][c] += more[c];
	}
	ts_restraints_apply(&s->restraints, sim, i, more);
	for (int c = 0; c < fluid->grid.dimensions; c++)
		if (p->imass[i] != 0)
			p->f[i][c] += share * more[c];
}

enum ts_status ts_drag_correct(struct ts_instance *self, struct tsim *sim, struct ts_fluid *fluid,
			       double length)
{
	struct ts_drag *s = self->state;
	size_t n = sim->particles->n;
	double share = 1 / ts_fluid_kick_fraction(sim);

	(void)length;
	if (s->nexchange != n)
		return TS_OK;
	s->total.fresh = true;
#pragma omp parallel for num_threads(ts_team(sim, n)) schedule(static)
	for (size_t i = 0; i < n; i++)
		correct_particle(self, sim, fluid, i, share);
	s->nexchange = 0;
	return TS_OK;
}
