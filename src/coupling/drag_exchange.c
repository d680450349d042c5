/* Momentum exchange of drag: the reaction on the fluid, and the correction of the forces on particles
 * after its step. */

#include <math.h>
#include <stddef.h>
#include <string.h>

#include "base/alloc.h"

#include "coupling/drag_exchange.h"
#include "coupling/drag_slip.h"
#include "coupling/interpolation_faces.h"
#include "coupling/reactions.h"
#include "coupling/stencil_batch.h"
#include "flow/projection.h"
#include "particle/particles.h"

#include "base/banned.h"

double ts_drag_steps_to_fluid(const struct ts_drag *s)
{
	const struct ts_projection *p = s->flow->state;

	return p->waited + 1 >= p->every ? (double)p->every : 0;
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

static enum ts_status share_reactions(struct ts_drag *s, struct tsim *sim, struct ts_reactions *r)
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
	struct ts_reactions reactions = { .fluid = s->fluid,
					  .order = &s->order,
					  .how = (enum ts_coupling_interpolation)s->interpolation };

	if (!s->sorted)
		TS_TRY(ts_cell_order_make(&s->order, sim, s->fluid, self->group, 1));
	TS_TRY(share_reactions(s, sim, &reactions));
	if (s->lagged)
		reactions.slope.own = NULL;
	for (int d = 0; d < 3; d++)
		reactions.along[d] = ts_drag_acts_along(s, d);
	reactions.velocity =
		(double *)s->exchange + offsetof(struct ts_drag_exchange, fluid_velocity) / sizeof(double);
	reactions.stride = sizeof *s->exchange / sizeof(double);
	ts_reactions_add(&reactions, ts_team(sim, s->order.sort->of.n));
	s->fluid->apart = sim->division;
	s->nexchange = sim->particles->n;
	return TS_OK;
}

/* Adds B (u' - u) to the force on particle i, where u' is `later`. */
static void correct_particle(struct ts_drag *s, const struct tsim *sim, size_t i, const double later[3],
			     double share)
{
	const int dimensions = s->fluid->grid.dimensions;
	struct ts_particles *p = sim->particles;
	const struct ts_drag_exchange *exchange = &s->exchange[i];
	double more[3] = { 0 };

	for (int c = 0; c < 3; c++)
		if (c < dimensions && exchange->slope[c] != 0) {
			more[c] = exchange->slope[c] * (later[c] - exchange->fluid_velocity[c]);
			s->total.note[i][c] += more[c];
		}
	if (s->restraints.n)
		ts_restraints_apply(&s->restraints, sim, i, more);
	if (p->imass[i] == 0)
		return;
	for (int c = 0; c < dimensions; c++)
		p->f[i][c] += share * more[c];
}

static bool has_slope(const struct ts_drag *s, size_t i)
{
	const double *slope = s->exchange[i].slope;

	return slope[0] != 0 || slope[1] != 0 || slope[2] != 0;
}

static void correct_one(struct ts_drag *s, const struct tsim *sim, size_t i, double share)
{
	struct ts_coupling_place at = { .how = (enum ts_coupling_interpolation)s->interpolation };
	double later[3];

	if (!has_slope(s, i) || !ts_coupling_locate(s->fluid, sim->particles->x[i], at.x, at.cell))
		return;
	ts_coupling_faces_interpolate(s->fluid, &at, s->fluid->exchange_velocity, later);
	correct_particle(s, sim, i, later, share);
}

/* Of the particles from .. to - 1, TS_STENCIL_BATCH at most. */
static void correct_batch(struct ts_drag *s, const struct tsim *sim, size_t from, size_t to, double share)
{
	double later[3][TS_STENCIL_BATCH];
	size_t of[TS_STENCIL_BATCH] = { 0 }, n = 0;
	bool inside[TS_STENCIL_BATCH];
	struct ts_stencil_batch batch;

	for (size_t i = from; i < to; i++)
		if (has_slope(s, i))
			of[n++] = i;
	ts_stencil_batch_find(&batch, &s->fluid->grid, (const double(*)[3])sim->particles->x, of, n);
	ts_stencil_batch_interpolate(&batch, s->fluid, s->fluid->exchange_velocity, later, inside);
	for (size_t k = 0; k < n; k++)
		if (inside[k])
			correct_particle(s, sim, of[k],
					 (const double[3]){ later[0][k], later[1][k], later[2][k] }, share);
}

static void correct_from(struct ts_drag *s, const struct tsim *sim, size_t from, double share)
{
	const size_t n = sim->particles->n;
	const size_t to = from + TS_STENCIL_BATCH < n ? from + TS_STENCIL_BATCH : n;

	if (ts_stencil_batch_possible(s->fluid, s->interpolation))
		correct_batch(s, sim, from, to, share);
	else
		for (size_t i = from; i < to; i++)
			correct_one(s, sim, i, share);
}

enum ts_status ts_drag_correct(struct ts_instance *self, struct tsim *sim, struct ts_fluid *fluid,
			       double length)
{
	struct ts_drag *s = self->state;
	size_t n = sim->particles->n;
	double share = 1 / ts_fluid_kick_fraction(sim);

	(void)length;
	(void)fluid;
	if (s->nexchange != n)
		return TS_OK;
	s->total.fresh = true;
#pragma omp parallel for num_threads(ts_team(sim, n)) schedule(static)
	for (size_t i = 0; i < n; i += TS_STENCIL_BATCH)
		correct_from(s, sim, i, share);
	s->nexchange = 0;
	return TS_OK;
}
