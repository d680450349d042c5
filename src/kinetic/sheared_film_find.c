/* Searches for the solid fraction or the gap at which a film of grains carries its load. */
#include <gsl/gsl_errno.h>
#include <gsl/gsl_roots.h>
#include <math.h>

#include "kinetic/internal.h"

#include "base/banned.h"

/* Steps of the scan for solid fractions in x = ln(nu/(limit - nu)), of that for gaps in ln(gap). */
enum { SCAN = 72, WIDENINGS = 70 };
static const double first_x = -14, last_x = 12, widening = 0.1;

struct search {
	struct ts_sheared_film *f;
	bool gap;      /* it is unknown, otherwise the solid fraction */
	double target; /* U/sqrt(N/rho) */
	enum ts_status status;
};

static double limit_of(const struct ts_sheared_film *f)
{
	return fmin(ts_gas_limit(&f->gas), f->gas.packing);
}

/* Sets the unknown from the variable of the search. */
static void set(struct search *s, double x)
{
	struct ts_sheared_film *f = s->f;

	if (!s->gap) {
		f->couette.solids = limit_of(f) / (1 + exp(-x));
		return;
	}
	f->couette.gap = exp(x);
	if (!isnan(f->amount))
		f->couette.solids = f->amount / f->diameter / f->couette.gap;
}

static double excess_of(const struct search *s)
{
	struct ts_couette_figures figures;

	ts_couette_figures(&s->f->couette, &figures);
	return log(figures.speed / s->target);
}

/* On one mesh, for the scans; NaN if there is no solution. */
static double coarse(struct search *s, double x, bool warm)
{
	struct ts_couette *c = &s->f->couette;
	int n;

	set(s, x);
	n = ts_couette_intervals(c->gap, s->f->points);
	s->status = TS_PHYSICS;
	if (warm && c->n == n)
		s->status = ts_couette_solve_mesh(c, n, true);
	if (s->status == TS_PHYSICS)
		s->status = ts_couette_solve_mesh(c, n, false);
	return s->status == TS_OK ? excess_of(s) : NAN;
}

static double fine(double x, void *data)
{
	struct search *s = data;
	struct ts_couette *c = &s->f->couette;

	set(s, x);
	s->status = ts_couette_solve(c, ts_couette_intervals(c->gap, s->f->points), s->f->tolerance);
	return s->status == TS_OK ? excess_of(s) : NAN;
}

/* The root between low and high by R. P. Brent's method, on fine meshes. */
static enum ts_status refine_root(struct search *s, double low, double high)
{
	gsl_error_handler_t *handler = gsl_set_error_handler_off();
	gsl_root_fsolver *brent = gsl_root_fsolver_alloc(gsl_root_fsolver_brent);
	gsl_function function = { fine, s };
	int code = brent ? gsl_root_fsolver_set(brent, &function, low, high) : GSL_ENOMEM;
	double root = NAN;

	for (int k = 0; k < 60 && code == GSL_SUCCESS; k++) {
		code = gsl_root_fsolver_iterate(brent);
		root = gsl_root_fsolver_root(brent);
		if (code == GSL_SUCCESS &&
		    gsl_root_test_interval(gsl_root_fsolver_x_lower(brent), gsl_root_fsolver_x_upper(brent),
					   1e-14, 1e-14) == GSL_SUCCESS)
			break;
	}
	if (brent)
		gsl_root_fsolver_free(brent);
	gsl_set_error_handler(handler);
	if (!brent)
		return TS_NOMEM;
	if (s->status == TS_OK && code != GSL_SUCCESS)
		return TS_PHYSICS;
	if (s->status == TS_OK)
		fine(root, s);
	return s->status;
}

enum ts_status ts_sheared_film_find_solids(struct ts_sheared_film *f, double target, double *least)
{
	struct search s = { .f = f, .target = target };
	double step = (last_x - first_x) / SCAN, before = NAN, at = NAN;

	*least = limit_of(f) / (1 + exp(-first_x));
	f->solutions = 0;
	for (int k = 0; k <= SCAN; k++) {
		double now = coarse(&s, first_x + step * k, k > 0);

		if (s.status == TS_NOMEM || (s.status != TS_OK && !f->solutions))
			return s.status;
		if (before * now <= 0 && (f->branch == TS_SHEARED_DENSE || !f->solutions))
			at = first_x + step * (k - 1);
		f->solutions += before * now <= 0;
		before = now;
	}
	return f->solutions ? refine_root(&s, at, at + step) : TS_OK;
}

enum ts_status ts_sheared_film_find_gap(struct ts_sheared_film *f, double target, double speed[2])
{
	struct search s = { .f = f, .gap = true, .target = target };
	double x = log(2), now;

	if (!isnan(f->amount))
		x = fmax(x, log(f->amount / f->diameter / limit_of(f) * (1 + 1e-6)));
	f->solutions = 0;
	now = coarse(&s, x, false);
	speed[0] = speed[1] = target * exp(now);
	for (int k = 0; k < WIDENINGS && now < 0; k++, x += widening) {
		now = coarse(&s, x + widening, true);
		if (now >= 0) {
			f->solutions = 1;
			return refine_root(&s, x, x + widening);
		}
		if (s.status == TS_OK)
			speed[1] = target * exp(now);
	}
	if (s.status != TS_OK) /* the widest that has a solution */
		f->couette.gap = exp(x - widening);
	return s.status;
}
