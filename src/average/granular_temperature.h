/* Granular temperature: mean square of the velocity fluctuations of grains per direction, T = <|u - <u>|^2>/D,
 * in velocity^2. Shared by compute temp/granular and compute temp/granular/chunk.
 *
 * The sums of a set of particles are found in three passes over them: 1 mean, 2 slope, 3 fluctuations. */
#ifndef TS_AVERAGE_GRANULAR_TEMPERATURE_H
#define TS_AVERAGE_GRANULAR_TEMPERATURE_H

#include "core/sim.h"

enum ts_granular_motion { TS_GRANULAR_TRANSLATION, TS_GRANULAR_ROTATION };
enum ts_granular_weight { TS_GRANULAR_NUMBER, TS_GRANULAR_MASS };
/* The linear ones are in the order of the coordinates. */
enum ts_granular_mean {
	TS_GRANULAR_NONE,
	TS_GRANULAR_UNIFORM,
	TS_GRANULAR_LINEAR_X,
	TS_GRANULAR_LINEAR_Y,
	TS_GRANULAR_LINEAR_Z
};
extern const char *const ts_granular_motions[], *const ts_granular_weights[], *const ts_granular_means[];

/* Arguments of the styles. */
struct ts_granular {
	int motion, weight, mean;
	bool unbiased;
};
#define TS_GRANULAR_ROWS(T, G)                                                                               \
	TS_ENUM("mean", T, G.mean, ts_granular_means, .fallback = "uniform",                                 \
		.help = "mean velocity that is subtracted: none, that of all particles (uniform), or the "   \
			"least-squares straight line over a coordinate (linear/x, linear/y, linear/z)"),     \
		TS_ENUM("weight", T, G.weight, ts_granular_weights, .fallback = "number",                    \
			.help = "whether particles count alike, or by mass"),                                \
		TS_ENUM("motion", T, G.motion, ts_granular_motions, .fallback = "translation",               \
			.help = "velocities, or angular velocities times sqrt(I/m)"),                        \
		TS_BOOL("unbiased", T, G.unbiased, .fallback = "no",                                         \
			.help = "multiplies by N/(N - p), where the mean was found from the N particles: p " \
				"is 0 for mean none, 1 for uniform, 2 for linear")

/* The mean velocity of a set of particles: mean + slope (x - at). */
struct ts_granular_field {
	double weight, count;
	double mean[3], at, slope[3];
};
enum { TS_GRANULAR_WIDTH = 7 }; /* numbers of a pass */

/* The terms of particle i in pass 1, 2 and 3; `field` has the results of the passes before. */
void ts_granular_term(const struct tsim *sim, size_t i, const struct ts_granular *granular, int pass,
		      const struct ts_granular_field *field, double term[TS_GRANULAR_WIDTH]);
/* Enters the sums of pass 1 or 2 into the field. */
void ts_granular_enter(const struct ts_granular *granular, int pass, const double sum[TS_GRANULAR_WIDTH],
		       struct ts_granular_field *field);
/* From the sums of pass 3: out[0] T, out[1..6] the tensor <u'_a u'_b> in the order xx, yy, zz, xy, xz, yz, out[7]
 * the number of particles. Without fluctuations that are defined (no more particles than p) T is 0. */
enum { TS_GRANULAR_COLUMNS = 8 };
void ts_granular_result(const struct tsim *sim, const struct ts_granular *granular,
			const struct ts_granular_field *field, const double sum[TS_GRANULAR_WIDTH],
			double out[TS_GRANULAR_COLUMNS]);

#endif
