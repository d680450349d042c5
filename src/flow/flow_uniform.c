#include "flow/flow.h"

#include <string.h>

#include "flow/imposed_flow.h"

#include "base/banned.h"

struct uniform {
	double velocity[3], viscosity, density;
};

static void velocity(const struct ts_instance *self, const double x[3], double u[3])
{
	const struct uniform *flow = self->state;

	(void)x;
	memcpy(u, flow->velocity, sizeof flow->velocity);
}

static double viscosity(const struct ts_instance *self)
{
	return ((const struct uniform *)self->state)->viscosity;
}

static double density(const struct ts_instance *self)
{
	return ((const struct uniform *)self->state)->density;
}

static enum ts_status plan(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report)
{
	const struct uniform *flow = self->state;

	ts_report_line(report, "fluid", "uniform velocity (%g %g %g), viscosity %g", flow->velocity[0],
		       flow->velocity[1], flow->velocity[2], flow->viscosity);
	ts_imposed_flow_report(report, sim);
	return TS_OK;
}

static const struct ts_arg args[] = {
	TS_VEC3("velocity", struct uniform, velocity, .unit = "velocity",
		.help = "velocity of the fluid everywhere"),
	TS_REAL("viscosity", struct uniform, viscosity, .range = TS_NOT_NEGATIVE, .unit = "pressure time",
		.help = "dynamic viscosity"),
	TS_REAL("density", struct uniform, density, .range = TS_NOT_NEGATIVE, .unit = "mass/length^3",
		.fallback = "0", .help = "density of the fluid"),
	TS_ARGS_END,
};

TS_STYLE(flow, ts_flow_style, ts_flow_uniform)
const struct ts_flow_style ts_flow_uniform = {
	.style = { .name = "uniform",
		   .kind = TS_KIND_FLOW,
		   .summary = "A fluid with the same prescribed velocity everywhere",
		   .doc = "The velocity is given and particles do not change it. Drag fixes such as fix\n"
			  "drag/stokes use this velocity and viscosity. A typical use is the rising "
			  "drilling\n"
			  "fluid of a borehole.",
		   .example = "flow_style uniform velocity 0 0 1.0 viscosity 1.0e-3",
		   .args = args,
		   .state_size = sizeof(struct uniform),
		   .plan = plan },
	.velocity = velocity,
	.viscosity = viscosity,
	.density = density,
};
