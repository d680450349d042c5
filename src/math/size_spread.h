/* Size distributions: the distribution of a positive quantity, a radius or a density, over particles.
 *
 * Normal and lognormal distributions are truncated at three standard deviations. by_mass: the given
 * density is the mass density of the distribution; the number density is proportional to it over r^3. */
#ifndef TS_MATH_SIZE_SPREAD_H
#define TS_MATH_SIZE_SPREAD_H

#include <stdbool.h>

#include "math/minstd.h"

enum ts_spread_shape { TS_SPREAD_CONSTANT, TS_SPREAD_UNIFORM, TS_SPREAD_NORMAL, TS_SPREAD_LOGNORMAL };

struct ts_spread {
	int shape; /* enum ts_spread_shape */
	bool by_mass;
	/* constant: value; uniform: minimum, maximum; normal: mean, standard deviation; lognormal:
	 * median, standard deviation of ln */
	double a, b;
};

double ts_spread_smallest(const struct ts_spread *s);
double ts_spread_largest(const struct ts_spread *s);
/* Mean of r^power over particles (number average). */
double ts_spread_mean(const struct ts_spread *s, int power);
/* Draws the next value; a constant uses no random number. */
double ts_spread_draw(const struct ts_spread *s, struct ts_minstd *random);

#endif
