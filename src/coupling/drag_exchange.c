/* Momentum exchange of drag: the reaction on the fluid, and the correction of the forces on particles
 * after its step. */

#include <math.h>

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

/* Adds the reaction to the drag on one particle to the fluid. */
static void add_reaction(void *context, size_t i)
{
	struct ts_instance *self = ((struct ts_instance **)context)[0];
	struct tsim *sim = ((struct tsim **)context)[1];
	struct ts_drag *s = self->state;
	struct ts_fluid *fluid = s->fluid;
	struct ts_coupling_place at = { .how = (enum ts_coupling_interpolation)s->interpolation };
	const struct ts_coupling_reaction reaction = { s->total.note[i],
						       s->lagged ? NULL : s->exchange[i].slope,
						       { ts_drag_acts_along(s, 0), ts_drag_acts_along(s, 1),
							 ts_drag_acts_along(s, 2) } };

	if (ts_cell_order_locate(&s->order, fluid, sim->particles->x[i], i, at.x, at.cell))
		ts_coupling_faces_react(fluid, &at, &reaction, s->exchange[i].fluid_velocity);
}

enum ts_status ts_drag_add_to_fluid(struct ts_instance *self, struct tsim *sim)
{
	struct ts_drag *s = self->state;
	void *context[2] = { self, sim };

	if (!s->sorted)
		TS_TRY(ts_cell_order_make(&s->order, sim, s->fluid, self->group, 1));
	ts_cell_order_each(&s->order, ts_team(sim, sim->particles->n), add_reaction, context);
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
