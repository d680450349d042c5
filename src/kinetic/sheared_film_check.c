/* Checks of the input of a sheared film. */
#include <math.h>

#include "kinetic/sheared_film.h"
#include "math/constants.h"

#include "base/banned.h"

static enum ts_status check_positive(double value, const char *name, const struct ts_place *where,
				     struct ts_error *error)
{
	if (isnan(value) || (value > 0 && isfinite(value)))
		return TS_OK;
	return ts_fail(error, TS_RANGE, where, "sheared film: %s %g, expected > 0", name, value);
}

static enum ts_status check_numbers(const struct ts_sheared_film *f, const struct ts_place *where,
				    struct ts_error *error)
{
	const struct {
		double value;
		const char *name;
	} positive[] = { { f->diameter, "diameter" },
			 { f->density, "density" },
			 { f->gap, "gap" },
			 { f->solids, "solid fraction" },
			 { f->amount, "amount" },
			 { f->speed, "speed" },
			 { f->load, "load" },
			 { f->tolerance, "tolerance" },
			 { f->gas.packing, "solid fraction at closest packing" } };

	for (size_t k = 0; k < sizeof positive / sizeof *positive; k++)
		TS_TRY(check_positive(positive[k].value, positive[k].name, where, error));
	if (!(f->gas.packing < 1))
		return ts_fail(error, TS_RANGE, where,
			       "sheared film: solid fraction at closest packing %g, expected < 1",
			       f->gas.packing);
	if (f->gas.radial == TS_GAS_TORQUATO && !(f->gas.packing > TS_GAS_FREEZING))
		return ts_fail(error, TS_RANGE, where,
			       "sheared film: solid fraction at closest packing %g, expected more than that "
			       "at freezing, %g",
			       f->gas.packing, TS_GAS_FREEZING);
	if (!(f->gas.restitution >= 0 && f->gas.restitution <= 1))
		return ts_fail(error, TS_RANGE, where,
			       "sheared film: restitution %g of the grains, expected 0 to 1",
			       f->gas.restitution);
	return TS_OK;
}

static enum ts_status check_unknown(const struct ts_sheared_film *f, const struct ts_place *where,
				    struct ts_error *error)
{
	int unknown =
		isnan(f->gap) + (isnan(f->solids) && isnan(f->amount)) + isnan(f->speed) + isnan(f->load);

	if (!isnan(f->solids) && !isnan(f->amount))
		return ts_fail(error, TS_STATE, where,
			       "sheared film: both the solid fraction and the amount of grains are given, "
			       "expected one of them");
	if (unknown != 1)
		return ts_fail(error, TS_STATE, where,
			       "sheared film: of gap, solid fraction (or amount), speed and load %d are "
			       "given, expected 3: the fourth is the result",
			       4 - unknown);
	return TS_OK;
}

static enum ts_status check_walls(const struct ts_sheared_film *f, const struct ts_place *where,
				  struct ts_error *error)
{
	static const char *const names[] = { "lower", "upper" };

	for (int w = 0; w < 2; w++) {
		const struct ts_bumpy_wall *wall = &f->wall[w];

		if (!(wall->restitution >= 0 && wall->restitution <= 1))
			return ts_fail(error, TS_RANGE, where,
				       "sheared film: restitution %g of the %s wall, expected 0 to 1",
				       wall->restitution, names[w]);
		/* pi/2 with the round-off of degrees and of the arc sine */
		if (!(wall->half_angle > 0 && wall->half_angle <= TS_PI / 2 * (1 + 1e-12)))
			return ts_fail(error, TS_RANGE, where,
				       "sheared film: half angle of the bumps of the %s wall %g degrees, "
				       "expected > 0 and <= 90; a smooth wall (0) does not shear the grains, "
				       "so they come to rest",
				       names[w], wall->half_angle * 180 / TS_PI);
	}
	if (f->gas.restitution >= 1 && f->wall[0].restitution >= 1 && f->wall[1].restitution >= 1)
		return ts_fail(error, TS_STATE, where,
			       "sheared film: there is no steady state: grains and walls are elastic "
			       "(restitution 1), so the work of the walls heats the grains for ever");
	return TS_OK;
}

static enum ts_status check_content(const struct ts_sheared_film *f, const struct ts_place *where,
				    struct ts_error *error)
{
	double solids = isnan(f->solids) ? f->amount / f->gap : f->solids;

	if (f->gap < 2 * f->diameter)
		return ts_fail(error, TS_RANGE, where,
			       "sheared film: gap %g, expected at least 2 diameters, %g: kinetic theory is "
			       "for several layers of grains",
			       f->gap, 2 * f->diameter);
	if (f->gap > 2000 * f->diameter)
		return ts_fail(error, TS_RANGE, where,
			       "sheared film: gap %g, expected at most 2000 diameters, %g", f->gap,
			       2000 * f->diameter);
	if (f->amount > 2000 * f->diameter * f->gas.packing)
		return ts_fail(error, TS_RANGE, where,
			       "sheared film: amount %g, expected less than fills a gap of 2000 diameters, "
			       "%g",
			       f->amount, 2000 * f->diameter * f->gas.packing);
	if (solids >= (1 - 1e-7) * f->gas.packing) /* nearer, round-off governs */
		return ts_fail(error, TS_RANGE, where,
			       "sheared film: mean solid fraction %g, expected less than that at closest "
			       "packing, %g",
			       solids, f->gas.packing);
	return TS_OK;
}

enum ts_status ts_sheared_film_check(const struct ts_sheared_film *f, const struct ts_place *where,
				     struct ts_error *error)
{
	TS_TRY(check_numbers(f, where, error));
	TS_TRY(check_unknown(f, where, error));
	TS_TRY(check_walls(f, where, error));
	return check_content(f, where, error);
}
