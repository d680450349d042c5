/* What the theory of thin films neglects in a gap, for the plan of a run. */
#include <math.h>

#include "film/internal.h"

#include "base/banned.h"

/* Largest slope of the gap between neighbours along an axis. */
static double largest_slope(const struct ts_film *f, int axis)
{
	size_t stride = axis == 0 ? 1 : (size_t)f->n[0];
	double most = 0;

	for (int j = axis == 1; j < f->n[1]; j++)
		for (int i = axis == 0; i < f->n[0]; i++) {
			size_t at = ts_film_at(f, i, j), before = at - stride;
			int k = axis == 0 ? i : j;
			double width = 0.5 * (f->face[axis][k + 1] - f->face[axis][k - 1]);

			if (f->kind[at] == TS_FILM_FLUID && f->kind[before] == TS_FILM_FLUID)
				most = fmax(most, fabs(f->gap[at] - f->gap[before]) / width);
		}
	return most;
}

struct ts_film_validity ts_film_validity(const struct ts_film *f)
{
	struct ts_film_validity v = { .slope = fmax(largest_slope(f, 0), largest_slope(f, 1)) };
	double gap = 0, speed = 0, length = INFINITY;
	size_t fluid = 0;

	for (size_t c = 0; c < ts_film_cells(f); c++) {
		if (f->kind[c] != TS_FILM_FLUID)
			continue;
		fluid++;
		gap += f->gap[c];
		speed = fmax(speed, hypot(f->velocity[1][0][c] - f->velocity[0][0][c],
					  f->velocity[1][1][c] - f->velocity[0][1][c]));
	}
	for (int axis = 0; axis < 2; axis++)
		if (f->edge[axis][0] == TS_FILM_PRESSURE || f->edge[axis][1] == TS_FILM_PRESSURE)
			length = fmin(length, f->face[axis][f->n[axis]] - f->face[axis][0]);
	if (fluid == 0 || !isfinite(length))
		return v;
	gap /= (double)fluid;
	v.thickness = gap / length;
	v.inertia = f->density * speed * gap / f->viscosity * v.thickness;
	return v;
}
