#include "kinetic/granular_gas.h"

#include <math.h>

#include "math/constants.h"

#include "base/banned.h"

double ts_gas_limit(const struct ts_gas *gas)
{
	return gas->radial == TS_GAS_CARNAHAN_STARLING ? 1 : gas->packing;
}

double ts_gas_kink(const struct ts_gas *gas)
{
	return gas->radial == TS_GAS_TORQUATO ? TS_GAS_FREEZING : NAN;
}

static double carnahan_starling(double nu, double *slope)
{
	double free = 1 - nu;

	*slope = (5 - 2 * nu) / (2 * free * free * free * free);
	return (2 - nu) / (2 * free * free * free);
}

/* free = 1 - nu/limit */
static double torquato(double packing, double nu, double free, double *slope)
{
	double g0;

	if (nu <= TS_GAS_FREEZING)
		return carnahan_starling(nu, slope);
	g0 = carnahan_starling(TS_GAS_FREEZING, slope) * (1 - TS_GAS_FREEZING / packing) / free;
	*slope = g0 / (packing * free);
	return g0;
}

static double lun_savage(double packing, double free, double *slope)
{
	double g0 = pow(free, -2.5 * packing);

	*slope = 2.5 * g0 / free;
	return g0;
}

static double radial(const struct ts_gas *gas, double nu, double free, double *slope)
{
	switch (gas->radial) {
	case TS_GAS_CARNAHAN_STARLING:
		return carnahan_starling(nu, slope);
	case TS_GAS_TORQUATO:
		return torquato(gas->packing, nu, free, slope);
	default:
		return lun_savage(gas->packing, free, slope);
	}
}

double ts_gas_radial(const struct ts_gas *gas, double nu, double *slope)
{
	return radial(gas, nu, 1 - nu / ts_gas_limit(gas), slope);
}

/* Lun et al. (1984), section 6, eta = (1 + e)/2. */
static void lun(double e, double nu, double g0, double slope, struct ts_gas_functions *g)
{
	double eta = (1 + e) / 2, nu2g0 = nu * nu * g0, dnu2g0 = 2 * nu * g0 + nu * nu * slope;

	g->viscosity = 5 * sqrt(TS_PI) / 96 *
		       (1 / (eta * (2 - eta) * g0) + 8.0 / 5 * (3 * eta - 1) / (2 - eta) * nu +
			64.0 / 25 * eta * ((3 * eta - 2) / (2 - eta) + 12 / TS_PI) * nu2g0);
	g->conductivity =
		25 * sqrt(TS_PI) / (16 * eta * (41 - 33 * eta)) *
		(1 / g0 + 12.0 / 5 * eta * (1 + eta * (4 * eta - 3)) * nu +
		 16.0 / 25 * eta * eta * (9 * eta * (4 * eta - 3) + 4 / TS_PI * (41 - 33 * eta)) * nu2g0);
	g->dufour = 15 * sqrt(TS_PI) / 4 * (2 * eta - 1) * (eta - 1) / (41 - 33 * eta) *
		    (1 / (nu * g0) + 12.0 / 5 * eta) * dnu2g0;
}

/* Garzo & Dufty (1999), equations (4.15) to (4.26) and appendices, for spheres, in units of the dilute elastic gas. */
static void garzo_dufty(double e, double nu, double g0, double slope, struct ts_gas_functions *g)
{
	double x = nu * g0, dlog = nu * slope / g0; /* d ln g0/d ln nu */
	double p = 1 + 2 * (1 + e) * x;
	double c = 32 * (1 - e) * (1 - 2 * e * e) / (81 - 17 * e + 30 * e * e * (1 - e));
	double zeta = 5.0 / 12 * g0 * (1 - e * e) * (1 + 3.0 / 32 * c);
	double rate_eta = g0 * (1 - (1 - e) * (1 - e) / 4) * (1 - c / 64);
	double rate_kappa =
		g0 / 3 * (1 + e) * (1 + 33.0 / 16 * (1 - e) + (19 - 3 * e) / 1024 * c); /* also of mu */
	double eta = (1 - 0.4 * (1 + e) * (1 - 3 * e) * x) / (rate_eta - zeta / 2);
	double kappa = 2.0 / 3 / (rate_kappa - 2 * zeta) *
		       (1 + (1 + p) / 2 * c +
			0.6 * x * (1 + e) * (1 + e) * (2 * e - 1 + ((1 + e) / 2 - 5 / (3 * (1 + e))) * c));
	double mu = 2 / (2 * rate_kappa - 3 * zeta) *
		    ((1 + dlog) * zeta * kappa + (p + 2 * (1 + e) * x * (1 + dlog)) / 3 * c -
		     0.8 * x * (1 + dlog / 2) * (1 + e) * (e * (1 - e) + (4.0 / 3 + e * (1 - e)) / 4 * c));
	double collisional = 1 + 1.2 * x * (1 + e);

	g->viscosity =
		5 * sqrt(TS_PI) / 96 *
		(eta * (1 + 0.8 * x * (1 + e)) + 0.6 * 128 / (5 * TS_PI) * nu * x * (1 + e) * (1 - c / 32));
	g->conductivity = 25 * sqrt(TS_PI) / 128 *
			  (kappa * collisional + 256 / (25 * TS_PI) * nu * x * (1 + e) * (1 + 7.0 / 32 * c));
	g->dufour = 25 * sqrt(TS_PI) / 128 * mu * collisional / nu;
	g->dissipation *= 1 + 3.0 / 32 * c;
}

void ts_gas_functions_packed(const struct ts_gas *gas, double nu, double free, struct ts_gas_functions *out)
{
	double e = gas->restitution, slope, g0 = radial(gas, nu, free, &slope);

	out->pressure = nu + 2 * (1 + e) * nu * nu * g0;
	out->pressure_slope = 1 + 2 * (1 + e) * (2 * nu * g0 + nu * nu * slope);
	out->dissipation = 12 / sqrt(TS_PI) * (1 - e * e) * nu * nu * g0;
	if (gas->theory == TS_GAS_LUN)
		lun(e, nu, g0, slope, out);
	else
		garzo_dufty(e, nu, g0, slope, out);
}

void ts_gas_functions(const struct ts_gas *gas, double nu, struct ts_gas_functions *out)
{
	ts_gas_functions_packed(gas, nu, 1 - nu / ts_gas_limit(gas), out);
}

double ts_gas_sheared_temperature(const struct ts_gas *gas, double nu)
{
	struct ts_gas_functions g;

	ts_gas_functions(gas, nu, &g);
	return g.viscosity / g.dissipation;
}

double ts_gas_rough_restitution(double restitution, double friction, double tangential)
{
	/* tangent of the angle of impact up to which contacts stick */
	double m0 = 3.5 * friction * (1 + restitution) / (1 + tangential), m02 = m0 * m0;
	double k, arc, a1, a2, b1, b2;

	if (!(friction > 0))
		return restitution;
	k = 2.0 / 7 * (1 + tangential) / (1 + restitution); /* friction/m0 */
	arc = TS_PI * m0 * (1 - 2 / TS_PI * atan(m0));
	a1 = k * (arc + 2 * m02 / (1 + m02) * (1 - 2 * k));
	a2 = 2.5 * k * (arc / 2 + (m02 - m02 * m02) / ((1 + m02) * (1 + m02)));
	b1 = k * k * m02 / (1 + m02);
	b2 = k / 2 * (arc / 2 + m02 / (1 + m02));
	return restitution - a1 / 2 + a2 * b1 / (2 * b2);
}
