#include "flow/flow.h"

#include <math.h>
#include <string.h>

#include "box/domain.h"
#include "core/report.h"
#include "particle/particles.h"

#include "base/banned.h"

enum { FIELDS = 8 }; /* number of fields of the cheapest solver */

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

/* Estimates the number of cells of a grid in the box, with cells of two mean diameters. */
static double estimated_cells(const struct tsim *sim)
{
	const struct ts_particles *p = sim->particles;
	const struct ts_box *box = &sim->domain->box;
	double sum = 0, edge, n = 1;

	for (size_t i = 0; i < p->n; i++)
		sum += p->radius[i];
	if (!p->n)
		return 0;
	edge = 4 * sum / (double)p->n;
	for (int d = 0; d < sim->dimension; d++)
		n *= ceil((box->hi[d] - box->lo[d]) / edge);
	return n;
}

static enum ts_status plan(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report)
{
	const struct uniform *flow = self->state;

	ts_report_line(report, "fluid", "uniform velocity (%g %g %g), viscosity %g", flow->velocity[0],
		       flow->velocity[1], flow->velocity[2], flow->viscosity);
	ts_report_left_out(report, "fluid solver", 0, FIELDS * sizeof(double) * estimated_cells(sim),
			   "the velocity is imposed, particles do not act on it (cells of two diameters)");
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
		   .ranks = TS_RANKS_OWN | TS_RANKS_PARTICLES | TS_RANKS_ROWLESS,
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
