/* The equations of the shear flow between rough walls, and their derivatives. */
#include <math.h>

#include "kinetic/internal.h"
#include "math/constants.h"

#include "base/banned.h"

/* 2 (1 - cos theta)/sin^2 theta = 2/(1 + cos theta) */
static double mean_slope(const struct ts_bumpy_wall *wall)
{
	return 2 / (1 + cos(wall->half_angle));
}

double ts_bumpy_wall_slip(const struct ts_bumpy_wall *wall)
{
	return sqrt(TS_PI / 2) * 1.5 / (mean_slope(wall) - cos(wall->half_angle));
}

double ts_bumpy_wall_loss(const struct ts_bumpy_wall *wall)
{
	return sqrt(2 / TS_PI) * (1 - wall->restitution) * mean_slope(wall);
}

double ts_couette_x(const struct ts_couette *c, double nu)
{
	return log(nu / (ts_gas_limit(&c->gas) - nu));
}

double ts_couette_kink(const struct ts_couette *c)
{
	return ts_couette_x(c, ts_gas_kink(&c->gas));
}

void ts_couette_at(const struct ts_couette *c, double x, struct ts_couette_at *out)
{
	double part = 1 / (1 + exp(-x)), h, root;
	struct ts_gas_functions g;

	out->nu = part * ts_gas_limit(&c->gas);
	ts_gas_functions_packed(&c->gas, out->nu, 1 / (1 + exp(x)), &g);
	root = sqrt(g.pressure);
	h = (g.conductivity * g.pressure_slope / g.pressure - g.dufour) / (g.pressure * root);
	out->root_t = 1 / root;
	out->slope = 1 / (h * out->nu / (1 + exp(x)));
	out->shear = root / g.viscosity;
	out->loss = g.dissipation / (g.pressure * root);
}

/* By central differences: errors of 1e-10, which cost Newton's method no iteration. Not across a step. */
static void differentiate(const struct ts_couette *c, double x, struct ts_couette_at *d)
{
	static const double step = 1e-5;
	const double kink = ts_couette_kink(c);
	struct ts_couette_at low, high;

	if (fabs(x - kink) <= step)
		x = kink + (x > kink ? 1.1 : -1.1) * step;
	ts_couette_at(c, x - step, &low);
	ts_couette_at(c, x + step, &high);
	d->nu = (high.nu - low.nu) / (2 * step);
	d->root_t = (high.root_t - low.root_t) / (2 * step);
	d->slope = (high.slope - low.slope) / (2 * step);
	d->shear = (high.shear - low.shear) / (2 * step);
	d->loss = (high.loss - low.loss) / (2 * step);
}

void ts_couette_rate(const struct ts_couette *c, const double z[4], struct ts_couette_rate *out)
{
	double q = z[1], s = z[3];
	struct ts_couette_at v, d;

	ts_couette_at(c, z[0], &v);
	differentiate(c, z[0], &d);
	*out = (struct ts_couette_rate){
		.f = { q * v.slope, s * s * v.shear - v.loss, v.nu, 0 },
		.j = { { q * d.slope, v.slope, 0, 0 },
		       { s * s * d.shear - d.loss, 0, 0, 2 * s * v.shear },
		       { d.nu } },
	};
}

void ts_couette_wall(const struct ts_couette *c, int wall, const double z[4], double residual[2],
		     double j[2][4])
{
	double slip = ts_bumpy_wall_slip(&c->wall[wall]), loss = ts_bumpy_wall_loss(&c->wall[wall]);
	double into = wall ? -1 : 1; /* direction of the normal into the flow */
	double s = z[3];
	struct ts_couette_at v, d;

	ts_couette_at(c, z[0], &v);
	differentiate(c, z[0], &d);
	/* energy: q into the flow = s u_s - D */
	residual[0] = into * z[1] - (s * s * slip - loss) * v.root_t;
	j[0][0] = -(s * s * slip - loss) * d.root_t;
	j[0][1] = into;
	j[0][2] = 0;
	j[0][3] = -2 * s * slip * v.root_t;
	residual[1] = z[2] - (wall ? c->solids * c->gap : 0);
	j[1][0] = j[1][1] = j[1][3] = 0;
	j[1][2] = 1;
}

void ts_couette_middle(double width, const double z0[4], const double f0[4], const double z1[4],
		       const double f1[4], double out[4])
{
	for (int k = 0; k < 4; k++)
		out[k] = (z0[k] + z1[k]) / 2 + width / 8 * (f0[k] - f1[k]);
}
