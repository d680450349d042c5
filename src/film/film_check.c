/* Checks of the input of a film. */
#include <math.h>

#include "film/internal.h"

#include "base/banned.h"

static enum ts_status check_constants(const struct ts_film *f, struct ts_error *error)
{
	if (!(f->viscosity > 0 && isfinite(f->viscosity)))
		return ts_fail(error, TS_RANGE, NULL, "film: viscosity %g, expected > 0", f->viscosity);
	if (!(f->density > 0 && isfinite(f->density)))
		return ts_fail(error, TS_RANGE, NULL, "film: density %g, expected > 0", f->density);
	for (int side = 0; side < 2; side++)
		if (!(f->slip[side] >= 0 && isfinite(f->slip[side])))
			return ts_fail(error, TS_RANGE, NULL, "film: slip length %g, expected >= 0",
				       f->slip[side]);
	if (!(f->time_step >= 0 && isfinite(f->time_step)))
		return ts_fail(error, TS_RANGE, NULL, "film: time step %g, expected >= 0", f->time_step);
	if (!isfinite(f->cavity_pressure) || !isfinite(f->ambient))
		return ts_fail(error, TS_RANGE, NULL,
			       "film: the pressure of the cavity is %g, the ambient one %g",
			       f->cavity_pressure, f->ambient);
	if (f->floating && (f->cavitation != TS_FILM_NONE || f->piezo.law != TS_FILM_CONSTANT))
		return ts_fail(error, TS_STATE, NULL,
			       "film: a floating pressure is known but for a constant: expected no "
			       "cavitation, and a viscosity that does not depend on it");
	TS_TRY(ts_film_check_roughness(f, error));
	return ts_film_check_viscosity(f, error);
}

static enum ts_status check_pressure(const struct ts_film *f, double p, const char *where,
				     struct ts_error *error)
{
	if (!isfinite(p))
		return ts_fail(error, TS_RANGE, NULL, "film: the pressure given %s is %g", where, p);
	if (!ts_film_can_reduce(f, p))
		return ts_fail(error, TS_RANGE, NULL,
			       "film: the pressure given %s, %g, is out of the range of the dependence of "
			       "the viscosity on it",
			       where, p);
	if (f->cavitation != TS_FILM_NONE && p < f->cavity_pressure)
		return ts_fail(error, TS_RANGE, NULL,
			       "film: the pressure given %s, %g, is below that in the cavity, %g", where, p,
			       f->cavity_pressure);
	return TS_OK;
}

static enum ts_status check_axis(const struct ts_film *f, int d, struct ts_error *error)
{
	static const char *const names[2][2] = {
		{ "at the lower edge of axis 1", "at the upper edge of axis 1" },
		{ "at the lower edge of axis 2", "at the upper edge of axis 2" }
	};

	for (int i = 0; i < f->n[d]; i++)
		if (!(f->face[d][i + 1] > f->face[d][i] && isfinite(f->face[d][i] + f->face[d][i + 1])))
			return ts_fail(error, TS_RANGE, NULL,
				       "film: borders of cells along axis %d do not increase: %g, %g", d + 1,
				       f->face[d][i], f->face[d][i + 1]);
	if ((f->edge[d][0] == TS_FILM_PERIODIC) != (f->edge[d][1] == TS_FILM_PERIODIC))
		return ts_fail(error, TS_RANGE, NULL, "film: only one edge of axis %d is periodic", d + 1);
	if (f->edge[d][0] == TS_FILM_PERIODIC && f->n[d] < 3)
		return ts_fail(error, TS_RANGE, NULL,
			       "film: %d cells along the periodic axis %d, expected at least 3", f->n[d],
			       d + 1);
	for (int side = 0; side < 2; side++)
		if (f->edge[d][side] == TS_FILM_PRESSURE) {
			TS_TRY(check_pressure(f, f->edge_pressure[d][side], names[d][side], error));
			if (!(f->edge_void[d][side] >= 0 && f->edge_void[d][side] < 1))
				return ts_fail(error, TS_RANGE, NULL,
					       "film: the void fraction given %s is %g, expected 0 to 1",
					       names[d][side], f->edge_void[d][side]);
		}
	return TS_OK;
}

static enum ts_status check_polar(const struct ts_film *f, struct ts_error *error)
{
	if (f->face[0][0] < 0)
		return ts_fail(error, TS_RANGE, NULL, "film: the radius begins at %g, expected >= 0",
			       f->face[0][0]);
	if (ts_film_slips(f))
		return ts_fail(error, TS_RANGE, NULL,
			       "film: slip on a polar grid is not supported, expected slip lengths 0");
	if (f->edge[0][0] == TS_FILM_PERIODIC || (f->face[0][0] == 0 && f->edge[0][0] != TS_FILM_NO_FLOW))
		return ts_fail(error, TS_RANGE, NULL,
			       "film: the inner edge of a polar grid %s, expected no flow",
			       f->face[0][0] == 0 ? "is the centre" : "is periodic");
	return TS_OK;
}

static enum ts_status check_cell(const struct ts_film *f, int i, int j, struct ts_error *error)
{
	size_t c = ts_film_at(f, i, j);
	double x = ts_film_centre(f, 0, i), y = ts_film_centre(f, 1, j);

	if (f->kind[c] == TS_FILM_SOLID)
		return TS_OK;
	if (!(f->gap[c] > 0 && isfinite(f->gap[c])))
		return ts_fail(error, TS_RANGE, NULL,
			       "film: the gap is %g at (%g, %g), expected > 0: the surfaces touch or overlap",
			       f->gap[c], x, y);
	if (f->gap[c] < ts_film_least_gap(f))
		return ts_fail(error, TS_RANGE, NULL,
			       "film: the gap is %g at (%g, %g), %g standard deviations of the roughness: %s",
			       f->gap[c], x, y, f->gap[c] / hypot(f->roughness[0], f->roughness[1]),
			       f->asperity.density > 0
				       ? "flow factors are not known for so near surfaces"
				       : "below 3 the surfaces touch; expected `asperities`, or a wider gap");
	if (!isfinite(f->rate[c]) || !isfinite(f->velocity[0][0][c] + f->velocity[1][0][c]) ||
	    !isfinite(f->velocity[0][1][c] + f->velocity[1][1][c]))
		return ts_fail(error, TS_RANGE, NULL, "film: a velocity at (%g, %g) is not a finite number",
			       x, y);
	if (f->kind[c] == TS_FILM_GIVEN)
		return check_pressure(f, f->pressure_given[c], "in a cell", error);
	if (f->cavitation != TS_FILM_JFO)
		return TS_OK;
	if (f->time_step > 0 && !(f->content[c] >= 0 && isfinite(f->content[c])))
		return ts_fail(error, TS_RANGE, NULL, "film: the content is %g at (%g, %g), expected >= 0",
			       f->content[c], x, y);
	if (!(f->time_step > 0) && f->rate[c] != 0)
		return ts_fail(error, TS_STATE, NULL,
			       "film: the gap changes at (%g, %g); cavitation jfo then needs a time step", x,
			       y);
	return TS_OK;
}

bool ts_film_has_fluid(const struct ts_film *f)
{
	for (size_t c = 0; c < ts_film_cells(f); c++)
		if (f->kind[c] != TS_FILM_SOLID)
			return true;
	return false;
}

enum ts_status ts_film_check(const struct ts_film *f, struct ts_error *error)
{
	TS_TRY(check_constants(f, error));
	if (!ts_film_can_reduce(f, f->cavity_pressure))
		return ts_fail(error, TS_RANGE, NULL,
			       "film: the pressure of the cavity, %g, is out of the range of the dependence "
			       "of the viscosity on it",
			       f->cavity_pressure);
	TS_TRY(check_axis(f, 0, error));
	TS_TRY(check_axis(f, 1, error));
	if (f->polar)
		TS_TRY(check_polar(f, error));
	for (int j = 0; j < f->n[1]; j++)
		for (int i = 0; i < f->n[0]; i++)
			TS_TRY(check_cell(f, i, j, error));
	return ts_film_check_parts(f, error);
}
