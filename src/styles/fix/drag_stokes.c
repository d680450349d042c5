#include "flow/flow.h"

#include <math.h>
#include <string.h>

#include "core/plan.h"
#include "particles/particles.h"

#include "base/banned.h"

enum { EXPLICIT, EXACT };
static const char *const schemes[] = { "explicit", "exact", NULL };
static const char *const axes_names[] = { "x", "y", "z", "xy", "xz", "yz", "xyz", NULL };
static const int axes_bits[] = { 1, 2, 4, 3, 5, 6, 7 };

struct drag {
	int axes, scheme;
};

static const double SIX_PI = 18.849555921538759431;

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	if (!ts_sim_only(sim, TS_KIND_FLOW))
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "fix drag/stokes needs a fluid: use flow_style before it");
	return TS_OK;
}

/* The force that takes the velocity over one step exactly along the exponential towards its limit
 * w = u + f tau/m, given the other forces f: F = m (w - v)(1 - exp(-h/tau))/h - f. */
static double exact_force(double f, double slip, double coefficient, double mass, double h)
{
	double rate = coefficient / mass;

	return mass * (slip + f / coefficient) * -expm1(-h * rate) / h - f;
}

static enum ts_status post_force(struct ts_instance *self, struct tsim *sim)
{
	const struct drag *s = self->state;
	struct ts_instance *fluid = ts_sim_only(sim, TS_KIND_FLOW);
	const struct ts_flow_style *flow = ts_flow_style_of(fluid);
	struct ts_particles *p = sim->particles;
	double viscosity = flow->viscosity(fluid), h = sim->clock.dt;
	int axes = axes_bits[s->axes];

	if (!(viscosity > 0))
		return TS_OK;
#pragma omp parallel for num_threads(ts_team(sim, p->n)) schedule(static)
	for (size_t i = 0; i < p->n; i++) {
		double coefficient = SIX_PI * viscosity * p->radius[i], u[3];

		if (!ts_in_group(p, i, self->group))
			continue;
		flow->velocity(fluid, p->x[i], u);
		for (int k = 0; k < 3; k++) {
			double slip = u[k] - p->v[i][k];

			if (!(axes >> k & 1))
				continue;
			p->f[i][k] += s->scheme == EXPLICIT
					      ? coefficient * slip
					      : exact_force(p->f[i][k], slip, coefficient,
							    p->mass[i], h);
		}
	}
	return TS_OK;
}

static enum ts_status plan(struct ts_instance *self, struct tsim *sim,
			   struct ts_plan_report *report)
{
	const struct drag *s = self->state;
	struct ts_instance *fluid = ts_sim_only(sim, TS_KIND_FLOW);
	const struct ts_particles *p = sim->particles;
	double viscosity = ts_flow_style_of(fluid)->viscosity(fluid), least = INFINITY;

	for (size_t i = 0; i < p->n; i++)
		if (ts_in_group(p, i, self->group))
			least = fmin(least, p->mass[i] / p->radius[i]);
	if (!(viscosity > 0) || isinf(least))
		return TS_OK;
	least /= SIX_PI * viscosity;
	ts_report_line(report, "drag", "Stokes along %s, least relaxation time %g",
		       axes_names[s->axes], least);
	if (s->scheme == EXACT)
		return TS_OK;
	return ts_report_limit(report, 2 * least, true, &self->where,
			       "explicit Stokes drag, 2 tau (scheme exact has no limit)");
}

static const struct ts_arg args[] = {
	TS_ENUM("axes", struct drag, axes, axes_names, .fallback = "xyz",
		.help = "components in which the drag acts"),
	TS_ENUM("scheme", struct drag, scheme, schemes, .fallback = "explicit",
		.help = "force at the present velocity, or exact relaxation over the step"),
	TS_ARGS_END,
};

TS_STYLE(fix, ts_style, ts_fix_drag_stokes)
const struct ts_style ts_fix_drag_stokes = {
	.name = "drag/stokes",
	.kind = TS_KIND_FIX,
	.summary = "Stokes drag of the fluid on each particle of the group",
	.doc = "F = 6 pi eta r (u - v), u the velocity of the fluid at the particle's centre and eta its "
	       "viscosity, both from flow_style. `axes z` keeps only that component.\n\n"
	       "scheme explicit takes the force at the present velocity: stable for steps below "
	       "2 tau, tau = m/(6 pi eta r). scheme exact makes the velocity follow the exponential "
	       "relaxation under drag and all forces added before this fix exactly over each step, "
	       "so it is stable for any step; define it after the fixes that add forces. With "
	       "velocity Verlet it is the half-step velocity that is exact.",
	.example = "flow_style uniform velocity 0 0 1.0 viscosity 1.0e-3\n"
		   "fix drag rock drag/stokes axes z scheme exact",
	.cite = "G. G. Stokes, Trans. Camb. Phil. Soc. 9 (1851) 8",
	.args = args,
	.state_size = sizeof(struct drag),
	.init = init,
	.hook = { [TS_STAGE_POST_FORCE] = post_force },
	.plan = plan,
};
