#include "flow/flow.h"

#include <math.h>

#include "core/report.h"
#include "flow/stagnation_profile.h"
#include "math/vec3.h"

#include "base/banned.h"

enum { AXISYMMETRIC, PLANE };
enum { POTENTIAL, VISCOUS };

struct stagnation {
	int shape, profile;
	double point[3], normal[3], span[3];
	double rate, speed, distance; /* NaN: not given */
	double viscosity, density;

	/* set by init */
	double a;	   /* rate at which the normal velocity decreases towards the plane, 1/time */
	double tangential; /* A = dU/dr outside the boundary layer: a/2 or a */
	double length;	   /* sqrt(nu/A); 0: potential flow */
	struct ts_stagnation_profile table;
};

/* With the normal n and the distance z from the plane, r the vector in the plane from the axis (plane flow:
 * from the line along span): u = A r f'(s) - k A length f(s) n. Potential flow: f = s, f' = 1. */
static void velocity(const struct ts_instance *self, const double x[3], double u[3])
{
	const struct stagnation *s = self->state;
	double r[3], z, f, slope = 1;

	ts_sub(x, s->point, r);
	z = ts_dot(r, s->normal);
	ts_axpy(-z, s->normal, r);
	if (s->shape == PLANE)
		ts_axpy(-ts_dot(r, s->span), s->span, r);
	if (!(s->length > 0)) {
		ts_scale(s->tangential, r, u);
		ts_axpy(-s->a * z, s->normal, u);
		return;
	}
	ts_stagnation_at(&s->table, fmax(0, z / s->length), &f, &slope);
	ts_scale(s->tangential * slope, r, u);
	ts_axpy(-s->a * s->length * f, s->normal, u);
}

static double viscosity(const struct ts_instance *self)
{
	return ((const struct stagnation *)self->state)->viscosity;
}

static double density(const struct ts_instance *self)
{
	return ((const struct stagnation *)self->state)->density;
}

static enum ts_status read_rate(struct ts_instance *self, struct tsim *sim)
{
	struct stagnation *s = self->state;

	if (isnan(s->speed) != isnan(s->distance) || isnan(s->rate) == isnan(s->speed))
		return ts_fail(&sim->error, TS_SYNTAX, &self->where,
			       "flow_style stagnation: expected either rate, or speed and distance");
	s->a = isnan(s->rate) ? s->speed / s->distance : s->rate;
	s->tangential = s->shape == PLANE ? s->a : s->a / 2;
	return TS_OK;
}

static enum ts_status make_unit(struct ts_instance *self, struct tsim *sim, const char *name, double v[3])
{
	double length = ts_norm(v);

	if (!(length > 0))
		return ts_fail(&sim->error, TS_RANGE, &self->where,
			       "flow_style stagnation: %s is 0 0 0, expected a vector", name);
	ts_scale(1 / length, v, v);
	return TS_OK;
}

static enum ts_status read_directions(struct ts_instance *self, struct tsim *sim)
{
	struct stagnation *s = self->state;

	TS_TRY(make_unit(self, sim, "normal", s->normal));
	if (s->shape == AXISYMMETRIC && sim->dimension == 2)
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "flow_style stagnation axisymmetric needs three dimensions; in two use plane");
	if (s->shape == AXISYMMETRIC)
		return TS_OK;
	TS_TRY(make_unit(self, sim, "span", s->span));
	if (fabs(ts_dot(s->normal, s->span)) > 1e-12)
		return ts_fail(&sim->error, TS_RANGE, &self->where,
			       "flow_style stagnation: span and normal are not perpendicular to each other");
	return TS_OK;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct stagnation *s = self->state;

	TS_TRY(read_rate(self, sim));
	TS_TRY(read_directions(self, sim));
	if (s->profile == POTENTIAL || s->length > 0)
		return TS_OK;
	if (!(s->viscosity > 0 && s->density > 0))
		return ts_fail(&sim->error, TS_RANGE, &self->where,
			       "flow_style stagnation: profile viscous needs viscosity and density > 0");
	s->length = sqrt(s->viscosity / s->density / s->tangential);
	ts_stagnation_solve(&s->table, s->shape == PLANE ? 1 : 2);
	return TS_OK;
}

static enum ts_status plan(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report)
{
	const struct stagnation *s = self->state;

	(void)sim;
	if (s->length > 0)
		ts_report_line(report, "fluid", "stagnation flow, %g per time, boundary layer of %.3g", s->a,
			       2 * s->length);
	else
		ts_report_line(report, "fluid", "stagnation flow, %g per time, potential flow", s->a);
	ts_report_left_out(report, "fluid solver", 0, 0,
			   "the velocity is imposed, particles do not act on it");
	return TS_OK;
}

static const char *const shapes[] = { "axisymmetric", "plane", NULL };
static const char *const profiles[] = { "potential", "viscous", NULL };

static const struct ts_arg args[] = {
	TS_ENUM("shape", struct stagnation, shape, shapes, .flags = TS_POSITIONAL,
		.help = "jet of circular section, or plane flow"),
	TS_VEC3("point", struct stagnation, point, .unit = "length",
		.help = "stagnation point, on the plane"),
	TS_VEC3("normal", struct stagnation, normal, .unit = "",
		.help = "normal of the plane, into the fluid; of any length"),
	TS_VEC3("span", struct stagnation, span, .unit = "", .fallback = "0 0 1",
		.help = "plane flow: direction in the plane along which nothing changes; of any length"),
	TS_REAL("rate", struct stagnation, rate, .flags = TS_OPTIONAL, .range = TS_POSITIVE, .unit = "1/time",
		.help = "a: the normal velocity is -a z at the distance z from the plane"),
	TS_REAL("speed", struct stagnation, speed, .flags = TS_OPTIONAL, .range = TS_POSITIVE,
		.unit = "velocity", .help = "instead of rate: the speed of the jet ..."),
	TS_REAL("distance", struct stagnation, distance, .flags = TS_OPTIONAL, .range = TS_POSITIVE,
		.unit = "length",
		.help = "... which potential flow has at this distance, a = speed/distance"),
	TS_ENUM("profile", struct stagnation, profile, profiles, .fallback = "potential",
		.help = "potential flow, or with the boundary layer at the plane"),
	TS_REAL("viscosity", struct stagnation, viscosity, .range = TS_NOT_NEGATIVE, .unit = "pressure time",
		.help = "dynamic viscosity"),
	TS_REAL("density", struct stagnation, density, .range = TS_NOT_NEGATIVE, .unit = "mass/length^3",
		.fallback = "0", .help = "density of the fluid"),
	TS_ARGS_END,
};

static const char doc[] =
	"A jet meets a plane and flows off along it. The velocity is given and particles do not change\n"
	"it; drag fixes use it. With z the distance from the plane, r the vector in the plane from the\n"
	"stagnation point (plane flow: from the line along span) and n the normal, potential flow is\n\n"
	"  u = (a/2) r - a z n   (axisymmetric), with the streamlines r^2 z = constant,\n"
	"  u = a r - a z n       (plane), r z = constant.\n\n"
	"`profile viscous` is the exact solution of the Navier-Stokes equations with the same flow far\n"
	"from the plane and no slip at it (Hiemenz 1911, Homann 1936): with A = a/2, k = 2\n"
	"(axisymmetric) or A = a, k = 1 (plane), s = z sqrt(A/nu), nu = viscosity/density,\n\n"
	"  u = A r f'(s) - k sqrt(A nu) f(s) n,   f''' + k f f'' + 1 - f'^2 = 0.\n\n"
	"f is solved to 1e-10. f' = 0.99 at s = 2.4 (plane) and 2.0; farther away the flow is the\n"
	"potential flow of a plane shifted by 0.648 (plane) or 0.569 sqrt(nu/A) into the fluid. Behind\n"
	"the plane, z < 0, the fluid is at rest; potential flow is continued there.\n\n"
	"The normal velocity grows with z without limit. The flow is that of a jet near its stagnation\n"
	"point: up to the distance z where the normal velocity a z reaches the speed of the jet, and\n"
	"r up to about the radius of the jet. Farther away use flow_style projection. For a free plane jet\n"
	"of width b and speed U potential theory gives a = pi U/(4 b) at the stagnation point.";

TS_STYLE(flow, ts_flow_style, ts_flow_stagnation)
const struct ts_flow_style ts_flow_stagnation = {
	.style = { .name = "stagnation",
		   .kind = TS_KIND_FLOW,
		   .ranks = TS_RANKS_OWN | TS_RANKS_PARTICLES | TS_RANKS_ROWLESS,
		   .summary = "A prescribed flow against a plane: axisymmetric or plane stagnation flow",
		   .doc = doc,
		   .example = "flow_style stagnation axisymmetric point 0 0 0 normal 0 0 1 speed 105 "
			      "distance 0.01 viscosity 1.8e-5 density 1.2",
		   .cite = "H. Schlichting, Boundary-Layer Theory, 7th ed. (1979), chapter V",
		   .args = args,
		   .state_size = sizeof(struct stagnation),
		   .init = init,
		   .plan = plan },
	.velocity = velocity,
	.viscosity = viscosity,
	.density = density,
};
