#include "kinetic/sheared_film.h"

#include <math.h>

#include "base/alloc.h"
#include "kinetic/internal.h"

#include "base/banned.h"

static enum ts_status no_solution(const struct ts_sheared_film *f, const struct ts_place *where,
				  struct ts_error *error)
{
	return ts_fail(error, TS_PHYSICS, where,
		       "sheared film: no solution was found at a gap of %g diameters and the solid fraction "
		       "%g: that of narrow gaps was followed up to %g diameters",
		       f->couette.gap, f->couette.solids, f->couette.reached);
}

static enum ts_status not_accurate(const struct ts_sheared_film *f, const struct ts_place *where,
				   struct ts_error *error)
{
	return ts_fail(error, TS_PHYSICS, where,
		       "sheared film: at a gap of %g diameters and the solid fraction %g the estimated error "
		       "is %.2g on the finest mesh, of %d intervals; expected at most the tolerance %g: give "
		       "a larger `tolerance`",
		       f->couette.gap, f->couette.solids, f->couette.error, f->couette.n, f->tolerance);
}

static enum ts_status find_solids(struct ts_sheared_film *f, const struct ts_place *where,
				  struct ts_error *error)
{
	double least;

	f->couette.gap = f->gap / f->diameter;
	TS_TRY(ts_sheared_film_find_solids(f, f->speed / sqrt(f->load / f->density), &least));
	if (f->solutions)
		return TS_OK;
	return ts_fail(error, TS_PHYSICS, where,
		       "sheared film: no solid fraction between %g and closest packing carries the load %g "
		       "at the speed %g",
		       least, f->load, f->speed);
}

static enum ts_status find_gap(struct ts_sheared_film *f, const struct ts_place *where,
			       struct ts_error *error)
{
	double target = f->speed / sqrt(f->load / f->density), speed[2];
	enum ts_status status;
	bool large;

	f->couette.solids = f->solids;
	status = ts_sheared_film_find_gap(f, target, speed);
	if (f->solutions || status == TS_NOMEM || isnan(speed[0]))
		return status;
	large = speed[0] >= target;
	return ts_fail(error, TS_PHYSICS, where,
		       "sheared film: the load %g is too %s: at the speed %g the %s gap for which there is a "
		       "solution, %g diameters, carries %g",
		       f->load, large ? "large" : "small", f->speed, large ? "narrowest" : "widest",
		       f->couette.gap, f->density * pow(f->speed / speed[large ? 0 : 1], 2));
}

static enum ts_status solve_given(struct ts_sheared_film *f)
{
	struct ts_couette *c = &f->couette;

	c->gap = f->gap / f->diameter;
	c->solids = isnan(f->solids) ? f->amount / f->gap : f->solids;
	TS_TRY(ts_couette_solve(c, ts_couette_intervals(c->gap, f->points), f->tolerance));
	return f->count ? ts_couette_count(c, ts_couette_intervals(c->gap, 33), &f->solutions) : TS_OK;
}

/* The unknown one of gap, solid fraction, speed and load, and figures in units of the script. */
static void scale(struct ts_sheared_film *f)
{
	struct ts_couette_figures *g = &f->figures;
	double unit;

	ts_couette_figures(&f->couette, g);
	f->gap = f->couette.gap * f->diameter;
	f->solids = f->couette.solids;
	f->amount = f->solids * f->gap;
	if (isnan(f->load))
		f->load = f->density * f->speed * f->speed / (g->speed * g->speed);
	unit = sqrt(f->load / f->density);
	if (isnan(f->speed))
		f->speed = g->speed * unit;
	g->speed = f->speed;
	g->centre[1] *= unit * unit;
	g->dissipation *= f->load * unit;
	for (int w = 0; w < 2; w++) {
		g->slip[w] *= unit;
		g->wall_loss[w] *= f->load * unit;
	}
}

enum ts_status ts_sheared_film_solve(struct ts_sheared_film *f, const struct ts_place *where,
				     struct ts_error *error)
{
	enum ts_status status;

	TS_TRY(ts_sheared_film_check(f, where, error));
	f->solutions = 0;
	f->couette.gas = f->gas;
	f->couette.wall[0] = f->wall[0];
	f->couette.wall[1] = f->wall[1];
	if (isnan(f->gap))
		status = find_gap(f, where, error);
	else if (isnan(f->solids) && isnan(f->amount))
		status = find_solids(f, where, error);
	else
		status = solve_given(f);
	if (status == TS_NOMEM)
		return ts_nomem(error);
	if (status == TS_RANGE)
		return not_accurate(f, where, error);
	if (status != TS_OK) /* the first message stays */
		return no_solution(f, where, error);
	scale(f);
	if (!(f->load > 0 && isfinite(f->load) && isfinite(f->figures.traction * f->load * f->speed)))
		return ts_fail(error, TS_RANGE, where,
			       "sheared film: the load, %g, or the power is out of the range of numbers",
			       f->load);
	if (f->figures.most > f->gas.packing)
		return ts_fail(error, TS_PHYSICS, where,
			       "sheared film: the solid fraction reaches %g, above that at closest packing, "
			       "%g: grains would come to rest, which kinetic theory does not describe",
			       f->figures.most, f->gas.packing);
	return TS_OK;
}

enum ts_status ts_sheared_film_profile(const struct ts_sheared_film *f, double (*out)[4])
{
	double(*p)[3] = ts_alloc((size_t)f->points, sizeof *p), unit = sqrt(f->load / f->density);

	if (!p)
		return TS_NOMEM;
	ts_couette_profile(&f->couette, f->points, p);
	for (int k = 0; k < f->points; k++) {
		out[k][0] = f->gap * k / (f->points - 1);
		out[k][1] = p[k][1] * unit;
		out[k][2] = p[k][0];
		out[k][3] = p[k][2] * unit * unit;
	}
	ts_free(p);
	return TS_OK;
}

void ts_sheared_film_release(struct ts_sheared_film *f)
{
	ts_couette_release(&f->couette);
}
