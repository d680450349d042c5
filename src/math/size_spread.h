/* How a positive quantity, a radius or a density, is spread over particles.
 *
 * Normal and lognormal spreads end at three standard deviations. By mass means that the given density is
 * that of mass: the density of number is that divided by r^3. */
#ifndef TS_MATH_SIZE_SPREAD_H
#define TS_MATH_SIZE_SPREAD_H

#include <stdbool.h>

#include "math/minstd.h"

enum ts_spread_shape { TS_SPREAD_CONSTANT, TS_SPREAD_UNIFORM, TS_SPREAD_NORMAL, TS_SPREAD_LOGNORMAL };

struct ts_spread {
	int shape; /* enum ts_spread_shape */
	bool by_mass;
	double a, b; /* the value; least and largest; mean and deviation; median and deviation of ln */
};

double ts_spread_least(const struct ts_spread *s);
double ts_spread_largest(const struct ts_spread *s);
/* The mean of r^power over particles (by number). */
double ts_spread_mean(const struct ts_spread *s, int power);
/* The next number; nothing is drawn for a constant. */
double ts_spread_draw(const struct ts_spread *s, struct ts_minstd *random);

#endif
