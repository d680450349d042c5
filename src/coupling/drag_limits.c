/* Limits of the time step by drag. */
#include "coupling/drag_force.h"

#include <math.h>

#include "core/ranks.h"
#include "core/report.h"
#include "coupling/drag_slip.h"
#include "coupling/near_particles.h"
#include "flow/projection.h"
#include "particle/particles.h"
#include "rigid/rigid.h"

#include "base/banned.h"

/* Drag laws for unresolved particles assume that cells are larger than particles. */
static void warn_of_cells(const struct ts_instance *self, struct tsim *sim, double diameter)
{
	const struct ts_drag *s = self->state;
	const double least = ts_grid_least_width(&s->fluid->grid);

	if (least < diameter)
		ts_warn(&sim->log, &self->where,
			"fix %s: cells of the fluid are down to %g wide and particles up to %g: laws of drag "
			"hold for cells of several diameters",
			self->style->name, least, diameter);
}

/* Sums k at the faces across c: drag coefficients per volume. */
static void sum_coefficients(const struct ts_instance *self, const struct tsim *sim, int c, double *k)
{
	const struct ts_drag *s = self->state;
	const struct ts_fluid *fluid = s->fluid;
	const struct ts_particles *p = sim->particles;

	ts_grid_field_clear(k, 0, fluid->grid.size);
	for (size_t i = 0; i < p->n; i++) {
		struct ts_slip slip = { .density = fluid->density, .viscosity = fluid->viscosity };
		struct ts_coupling_weights weights[3];
		double w[3], place[3];
		int cell[3];

		if (!ts_in_group(p, i, self->group) || !ts_drag_slip_at(self, p, i, &slip, w) ||
		    !ts_coupling_locate(fluid, p->x[i], place, cell))
			continue;
		ts_coupling_weights_faces(fluid, place, cell,
					  (enum ts_coupling_interpolation)s->interpolation, weights);
		ts_coupling_distribute_force(&fluid->grid, &weights[c], c, fluid->u[c],
					     -ts_drag_coefficient(self, sim, &slip), 0, k, NULL);
	}
}

/* Largest rate k/(e rho) of du/dt = -k (u - v)/(e rho), for drag that is explicit in the fluid. Weights
 * sum to 1, so no mode of the velocities relaxes faster. */
static enum ts_status lagged_rate(const struct ts_instance *self, struct tsim *sim, double *rate)
{
	const struct ts_drag *s = self->state;
	const struct ts_fluid *fluid = s->fluid;
	double *k = ts_grid_field(&fluid->grid);

	if (!k)
		return ts_nomem(&sim->error);
	for (int c = 0; c < fluid->grid.dimensions; c++) {
		size_t stride = (size_t)fluid->grid.stride[c];

		if (!ts_drag_acts_along(s, c))
			continue;
		sum_coefficients(self, sim, c, k);
		for (size_t at = stride; at < fluid->grid.size; at++) {
			double e =
				fluid->void_fraction
					? 0.5 * (fluid->void_fraction[at] + fluid->void_fraction[at - stride])
					: 1;

			if (k[at] > 0)
				*rate = fmax(*rate, k[at] / (e * fluid->density));
		}
	}
	ts_grid_field_free(k);
	return TS_OK;
}

/* With scheme explicit the velocity of the particle relaxes as well: the slip decays at most at the sum of
 * both rates. The fluid makes one step of `every` steps of the simulation. */
static enum ts_status limit_lagged(struct ts_instance *self, struct tsim *sim, double relaxation,
				   struct ts_plan_report *report)
{
	const struct ts_drag *s = self->state;
	const struct ts_projection *p = s->flow->state;
	double rate = 0;

	if (!s->fluid || !s->two_way || !s->lagged || !(s->fluid->viscosity > 0))
		return TS_OK;
	TS_TRY(lagged_rate(self, sim, &rate));
	rate *= (double)p->every;
	if (s->scheme == TS_DRAG_EXPLICIT)
		rate += 1 / relaxation;
	return ts_report_limit(report, rate > 0 ? 2 / rate : INFINITY, false, &self->where,
			       "the force of fix %s with `lagged yes` on the fluid, 2 e rho/k (lagged no has "
			       "no such limit)",
			       self->style->name);
}

/* The drag coefficient of particle i (force/velocity), and its diameter; 0: no fluid brakes it. */
static double coefficient_at(const struct ts_instance *self, const struct tsim *sim, size_t i,
			     double *diameter)
{
	const struct ts_drag *s = self->state;
	const struct ts_flow_style *flow = ts_flow_style_of(s->flow);
	struct ts_slip slip = { .density = flow->density(s->flow), .viscosity = flow->viscosity(s->flow) };
	double w[3];

	if (!(slip.viscosity > 0) || !ts_drag_slip_at(self, sim->particles, i, &slip, w))
		return 0;
	*diameter = slip.diameter;
	return ts_drag_coefficient(self, sim, &slip);
}

/* Whether the force on particle i is explicit. */
static bool is_explicit(const struct ts_drag *s, const struct ts_particles *p, size_t i)
{
	return s->scheme == TS_DRAG_EXPLICIT || ts_rigid_member(p, i);
}

void ts_drag_add_ground(const struct ts_instance *self, const struct tsim *sim, size_t i,
			struct ts_ground_springs *sum)
{
	const struct ts_drag *s = self->state;
	const struct ts_particles *p = sim->particles;
	double rate, diameter;

	if (!is_explicit(s, p, i))
		return;
	rate = coefficient_at(self, sim, i, &diameter) * p->imass[i];
	for (int d = 0; d < 3; d++)
		if (ts_drag_acts_along(s, d))
			sum->rate[d] += rate;
}

/* Largest diameter; smallest relaxation times m/c of all particles, and of those with explicit drag. */
struct relaxation_times {
	double largest, least, explicit;
};

static struct relaxation_times relaxation_times_of(const struct ts_instance *self, const struct tsim *sim)
{
	const struct ts_drag *s = self->state;
	const struct ts_particles *p = sim->particles;
	struct relaxation_times t = { 0, INFINITY, INFINITY };

	for (size_t i = 0; i < p->n; i++) {
		double c, tau, diameter = 0;

		if (!ts_in_group(p, i, self->group))
			continue;
		c = coefficient_at(self, sim, i, &diameter);
		t.largest = fmax(t.largest, diameter);
		if (!(diameter > 0) || ts_drag_motion_prescribed(s, sim, i))
			continue;
		tau = ts_drag_mass(s, sim, i) / c;
		t.least = fmin(t.least, tau);
		if (is_explicit(s, p, i))
			t.explicit = fmin(t.explicit, tau);
	}
	return t;
}

enum ts_status ts_drag_report_limits(struct ts_instance *self, struct tsim *sim,
				     struct ts_plan_report *report)
{
	const struct ts_drag *s = self->state;
	struct relaxation_times t;
	struct ts_fluid *fluid;

	if (s->fluid && !sim->division) /* at all particles */
		TS_TRY(ts_flow_require_fields(sim, self->style->name, &self->where, &fluid));
	TS_TRY(ts_near_particles_ready(s->fluid, sim));
	t = relaxation_times_of(self, sim);
	t.largest = ts_ranks_most(sim, t.largest);
	if (s->fluid && s->two_way && !report->limits_only && ts_ranks_first(sim))
		warn_of_cells(self, sim, t.largest);
	TS_TRY(limit_lagged(self, sim, t.least, report));
	if (isinf(t.least))
		return TS_OK;
	ts_report_line(report, "drag", "%s along %s, least relaxation time %g", self->style->name,
		       ts_drag_axes[s->axes], t.least);
	if (s->scheme == TS_DRAG_EXPLICIT)
		return ts_report_limit(report, 2 * t.explicit, true, &self->where,
				       "explicit fix %s, 2 tau (scheme exact has no limit)",
				       self->style->name);
	return ts_report_limit(report, 2 * t.explicit, true, &self->where,
			       "fix %s on members of rigid bodies, whose drag is explicit, 2 tau",
			       self->style->name);
}
