#include "math/size_spread.h"

#include <math.h>

#include "base/banned.h"

static const double CUT = 3; /* truncation, in standard deviations */

double ts_spread_smallest(const struct ts_spread *s)
{
	if (s->shape == TS_SPREAD_NORMAL)
		return s->a - CUT * s->b;
	return s->shape == TS_SPREAD_LOGNORMAL ? s->a * exp(-CUT * s->b) : s->a;
}

double ts_spread_largest(const struct ts_spread *s)
{
	if (s->shape == TS_SPREAD_NORMAL)
		return s->a + CUT * s->b;
	if (s->shape == TS_SPREAD_LOGNORMAL)
		return s->a * exp(CUT * s->b);
	return s->shape == TS_SPREAD_UNIFORM ? s->b : s->a;
}

/* Value of the distribution at t of the standard variable: uniform in (0, 1), or normal. */
static double transform_standard(const struct ts_spread *s, double t)
{
	if (s->shape == TS_SPREAD_UNIFORM)
		return s->a + t * (s->b - s->a);
	return s->shape == TS_SPREAD_NORMAL ? s->a + t * s->b : s->a * exp(t * s->b);
}

double ts_spread_mean(const struct ts_spread *s, int power)
{
	enum { N = 4096 }; /* intervals of Simpson's rule: exact to about 1e-13 here */
	double lo = s->shape == TS_SPREAD_UNIFORM ? 0 : -CUT;
	double hi = s->shape == TS_SPREAD_UNIFORM ? 1 : CUT;
	double sum = 0, weights = 0;

	if (s->shape == TS_SPREAD_CONSTANT)
		return pow(s->a, power);
	for (int k = 0; k <= N; k++) {
		double t = lo + (hi - lo) * k / N, r = transform_standard(s, t);
		double weight = k == 0 || k == N ? 1 : k % 2 ? 4 : 2;

		if (s->shape != TS_SPREAD_UNIFORM)
			weight *= exp(-0.5 * t * t);
		if (s->by_mass)
			weight /= r * r * r;
		weights += weight;
		sum += weight * pow(r, power);
	}
	return sum / weights;
}

static double draw_standard(const struct ts_spread *s, struct ts_minstd *random)
{
	double t;

	if (s->shape == TS_SPREAD_UNIFORM)
		return ts_minstd_uniform(random);
	do
		t = ts_minstd_normal(random);
	while (fabs(t) > CUT);
	return t;
}

/* By mass: a value r is accepted with a probability proportional to 1/r^3. */
double ts_spread_draw(const struct ts_spread *s, struct ts_minstd *random)
{
	double smallest = ts_spread_smallest(s), r;

	if (s->shape == TS_SPREAD_CONSTANT)
		return s->a;
	do
		r = transform_standard(s, draw_standard(s, random));
	while (s->by_mass && ts_minstd_uniform(random) * r * r * r > smallest * smallest * smallest);
	return r;
}
