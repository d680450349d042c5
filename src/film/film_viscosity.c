/* Viscosity that depends on the pressure, by the reduced pressure
 *
 *   q(p) = int_0^p eta(0)/eta(s) ds,   grad q = eta(0)/eta grad p,
 *
 * which satisfies the equation of constant viscosity eta(0) (A. W. Crook, Phil. Trans. A 254 (1961) 237). q increases with
 * p, so that q > q(pc) is p > pc, and all kinds of cavitation are the same for q as for p.
 *   Barus      eta = eta(0) exp(alpha p),  q = (1 - exp(-alpha p))/alpha      (C. Barus, Am. J. Sci. 45 (1893) 87)
 *   Roelands   eta = eta(0) (eta(0)/eta_r)^((1 + p/p_r)^Z - 1)                (C. J. A. Roelands, thesis, Delft 1966)
 * q has an upper limit: if the motion of the surfaces needs more, no pressure satisfies the equation. */
#include <math.h>

#include "base/alloc.h"
#include "film/internal.h"

#include "base/banned.h"

enum { MOST_STEPS = 500, POINTS = 5 };

/* ln(eta/eta(0)) */
static double growth(const struct ts_film *f, double p)
{
	const struct ts_film_piezo *z = &f->piezo;

	if (z->law == TS_FILM_BARUS)
		return z->alpha * p;
	if (z->law == TS_FILM_ROELANDS)
		return log(f->viscosity / z->viscosity) * expm1(z->exponent * log1p(p / z->pressure));
	return 0;
}

double ts_film_viscosity(const struct ts_film *f, double p)
{
	return f->piezo.law == TS_FILM_CONSTANT ? f->viscosity : f->viscosity * exp(growth(f, p));
}

/* q(b) - q(a) of Roelands by the rule of Gauss, on parts in which the viscosity changes by a factor of at most e. */
static double integrate(const struct ts_film *f, double a, double b)
{
	static const double point[POINTS] = { 0.046910077030668004, 0.23076534494715845, 0.5,
					      0.76923465505284155, 0.953089922969332 };
	static const double weight[POINTS] = { 0.11846344252809454, 0.23931433524968324, 0.28444444444444444,
					       0.23931433524968324, 0.11846344252809454 };
	const struct ts_film_piezo *z = &f->piezo;
	double rate = 2 * (1 + z->exponent * log(f->viscosity / z->viscosity)) / z->pressure;
	int parts = 1 + (int)fmin(fabs(b - a) * rate, 1e5);
	double width = (b - a) / parts, sum = 0;

	for (int k = 0; k < parts; k++)
		for (int m = 0; m < POINTS; m++)
			sum += weight[m] * exp(-growth(f, a + (k + point[m]) * width));
	return sum * width;
}

double ts_film_reduce(const struct ts_film *f, double p)
{
	double alpha = f->piezo.alpha;

	if (f->piezo.law == TS_FILM_ROELANDS)
		return integrate(f, 0, p);
	return f->piezo.law == TS_FILM_BARUS && alpha > 0 ? -expm1(-alpha * p) / alpha : p;
}

/* Newton's method from below: q(p) <= p, and because q is concave all its steps increase p and stay below the solution. */
static double expand_roelands(const struct ts_film *f, double q)
{
	const double steepest = 600, least = -f->piezo.pressure / 2;
	double p = fmax(q, least), now = integrate(f, 0, p);

	if (now > q && p == least)
		return NAN;
	for (int k = 0; k < MOST_STEPS; k++) {
		double e = growth(f, p), step = (q - now) * exp(fmin(e, steepest));

		if (e > steepest)
			return NAN;
		if (!(step > 1e-15 * fabs(p)) || !(q - now > 1e-16 * fabs(q)))
			return p;
		now += integrate(f, p, p + step);
		p += step;
	}
	return NAN;
}

double ts_film_expand(const struct ts_film *f, double q)
{
	double alpha = f->piezo.alpha;

	if (f->piezo.law == TS_FILM_ROELANDS)
		return expand_roelands(f, q);
	if (f->piezo.law == TS_FILM_CONSTANT || !(alpha > 0))
		return q;
	return alpha * q < 1 ? -log1p(-alpha * q) / alpha : NAN;
}

enum ts_status ts_film_check_viscosity(const struct ts_film *f, struct ts_error *error)
{
	const struct ts_film_piezo *z = &f->piezo;

	if (z->law == TS_FILM_BARUS && !(z->alpha >= 0 && isfinite(z->alpha)))
		return ts_fail(error, TS_RANGE, NULL, "film: coefficient of Barus %g, expected >= 0",
			       z->alpha);
	if (z->law != TS_FILM_ROELANDS)
		return TS_OK;
	if (!(z->viscosity > 0 && z->viscosity < f->viscosity))
		return ts_fail(error, TS_RANGE, NULL,
			       "film: the viscosity of Roelands is %g, expected > 0 and less than that at "
			       "pressure 0, %g",
			       z->viscosity, f->viscosity);
	if (!(z->pressure > 0 && isfinite(z->pressure)))
		return ts_fail(error, TS_RANGE, NULL, "film: the pressure of Roelands is %g, expected > 0",
			       z->pressure);
	if (!(z->exponent > 0 && z->exponent <= 1))
		return ts_fail(error, TS_RANGE, NULL,
			       "film: the exponent of Roelands is %g, expected > 0 and at most 1",
			       z->exponent);
	return TS_OK;
}

bool ts_film_can_reduce(const struct ts_film *f, double p)
{
	if (f->piezo.law == TS_FILM_ROELANDS && !(p > -f->piezo.pressure / 2))
		return false;
	return growth(f, p) < 600 && isfinite(ts_film_reduce(f, p));
}

/* Pressures from reduced ones; those that are given stay exact. */
static enum ts_status expand_all(struct ts_film *f, double cavity, struct ts_error *error)
{
	for (size_t c = 0; c < ts_film_cells(f); c++) {
		double q = f->p[c];

		if (f->kind[c] == TS_FILM_GIVEN)
			f->p[c] = f->pressure_given[c];
		else
			f->p[c] = q == cavity ? f->cavity_pressure : ts_film_expand(f, q);
		if (!isfinite(f->p[c]))
			return ts_fail(error, TS_PHYSICS, NULL,
				       "film: no pressure satisfies the equation at (%g, %g) with this "
				       "dependence of the viscosity on the pressure: the reduced pressure is "
				       "%g there; expected a wider gap, slower surfaces or a constant "
				       "viscosity",
				       ts_film_centre(f, 0, (int)(c % (size_t)f->n[0])),
				       ts_film_centre(f, 1, (int)(c / (size_t)f->n[0])), q);
	}
	return TS_OK;
}

/* A copy that shares the fields, of constant viscosity. */
static void reduce_input(const struct ts_film *f, double *given, struct ts_film *reduced)
{
	*reduced = *f;
	reduced->piezo.law = TS_FILM_CONSTANT;
	reduced->pressure_given = given;
	reduced->cavity_pressure = ts_film_reduce(f, f->cavity_pressure);
	for (int k = 0; k < 4; k++)
		if (f->edge[k / 2][k % 2] == TS_FILM_PRESSURE)
			reduced->edge_pressure[k / 2][k % 2] =
				ts_film_reduce(f, f->edge_pressure[k / 2][k % 2]);
	for (size_t c = 0; c < ts_film_cells(f); c++)
		if (f->kind[c] == TS_FILM_GIVEN)
			given[c] = ts_film_reduce(f, f->pressure_given[c]);
}

enum ts_status ts_film_solve_reduced(struct ts_film *f, ts_film_solve_fn *solve, struct ts_error *error)
{
	double *given = ts_alloc(ts_film_cells(f), sizeof *given);
	struct ts_film reduced;
	enum ts_status status;

	if (!given)
		return ts_nomem(error);
	reduce_input(f, given, &reduced);
	status = solve(&reduced, error);
	ts_free(given);
	f->report = reduced.report;
	f->lu = reduced.lu;
	f->scale[0] = reduced.scale[0];
	f->scale[1] = reduced.scale[1];
	return status == TS_OK ? expand_all(f, reduced.cavity_pressure, error) : status;
}
