/* The gap between the surfaces of flow_style reynolds, and its rate. */
#include <float.h>
#include <math.h>

#include "film/film_flow.h"

#include "base/banned.h"

/* The gap is the distance h of the surfaces, or with a least gap l a smooth function of it: l + (d + sqrt(d^2 + l^2))/2,
 * d = h - l, which is h + l^2/(4 h) above and tends to l where the surfaces overlap. Returns its derivative. */
static double soften(double distance, double least, double *gap)
{
	double d = distance - least, root = sqrt(d * d + least * least);

	*gap = distance;
	if (!(least > 0))
		return 1;
	*gap = least + (d > 0 ? (d + root) / 2 : least * least / (root - d) / 2);
	return (1 + d / root) / 2;
}

static void set_gaps(struct ts_film_flow *flow)
{
	const double *low = flow->surface[0].z, *high = flow->surface[1].z;
	struct ts_film *f = &flow->film;

	for (size_t c = 0; c < ts_film_cells(f); c++) {
		flow->yield[c] = soften(high[c] - low[c], flow->least, &f->gap[c]);
		f->kind[c] = flow->solid && !(f->gap[c] > 0) ? TS_FILM_SOLID : TS_FILM_FLUID;
		flow->bottom[c] = low[c];
		if (flow->least > 0 || f->kind[c] == TS_FILM_SOLID)
			flow->bottom[c] = high[c] - fmax(f->gap[c], 0);
	}
}

/* Sets rates to 0 that are the round-off of terms that cancel: below a shape at rest a plane slides, and the gap stays. */
static void remove_round_off(struct ts_film_flow *flow, const double together[2], const double apart[2])
{
	const double *low = flow->surface[0].z, *high = flow->surface[1].z;
	struct ts_film *f = &flow->film;

	for (int j = 0; j < f->n[1]; j++)
		for (int i = 0; i < f->n[0]; i++) {
			size_t c = ts_film_at(f, i, j);
			double passes =
				(fabs(together[0]) + fabs(apart[0])) / (f->face[0][i + 1] - f->face[0][i]) +
				(fabs(together[1]) + fabs(apart[1])) / (f->face[1][j + 1] - f->face[1][j]);

			if (fabs(f->rate[c]) <= 16 * DBL_EPSILON * passes * (fabs(low[c]) + fabs(high[c])))
				f->rate[c] = 0;
		}
}

/* The rate of the gap g of shapes that move along the film with the velocities V1, below, and V2. With the distance d of
 * the surfaces, the yield g' = dg/dd, V = (V1 + V2)/2 and W = (V2 - V1)/2
 *
 *   dg/dt = g' (V1.grad z1 - V2.grad z2) = -V.grad g - g' W.grad(z1 + z2),
 *
 * so that an observer who moves along sees the same pressure to round-off. */
static void carry_shapes(struct ts_film_flow *flow)
{
	const struct ts_film_surface *lower = &flow->surface[0], *upper = &flow->surface[1];
	struct ts_film *f = &flow->film;
	double together[2], apart[2];

	for (int axis = 0; axis < 2; axis++) {
		double below = lower->stays ? 0 : lower->now[axis];
		double above = upper->stays || upper->plane_fix ? 0 : upper->now[axis];

		together[axis] = (below + above) / 2;
		apart[axis] = (above - below) / 2;
	}
	for (size_t c = 0; c < ts_film_cells(f); c++)
		flow->carried[c] = fmax(f->gap[c], 0);
	ts_film_carry(f, flow->carried, together, NULL, f->rate);
	for (size_t c = 0; c < ts_film_cells(f); c++)
		flow->carried[c] = lower->z[c] + upper->z[c];
	ts_film_carry(f, flow->carried, apart, flow->yield, f->rate);
	remove_round_off(flow, together, apart);
}

void ts_film_combine(struct ts_film_flow *flow)
{
	const struct ts_film_surface *lower = &flow->surface[0], *upper = &flow->surface[1];
	struct ts_film *f = &flow->film;

	set_gaps(flow);
	for (int axis = 0; axis < 2; axis++)
		for (int j = 0; j < f->n[1] + (axis == 1); j++)
			for (int i = 0; i < f->n[0] + (axis == 0); i++)
				f->ride[0][axis][ts_film_face(f, axis, i, j)] =
					f->ride[1][axis][ts_film_face(f, axis, i, j)] = 0;
	for (size_t c = 0; c < ts_film_cells(f); c++) {
		/* columns that are pressed down change the gap less than they move */
		f->rate[c] = flow->yield[c] * (upper->rate[c] - lower->rate[c]);
		for (int axis = 0; axis < 2; axis++) {
			f->velocity[0][axis][c] = lower->now[axis];
			f->velocity[1][axis][c] = upper->now[axis];
		}
	}
	carry_shapes(flow);
}
