/* Random selection of particles. Random numbers are functions of seed and tag, so the selection depends
 * neither on the order of particles in memory nor on threads. */
#ifndef TS_PARTICLE_DRAW_H
#define TS_PARTICLE_DRAW_H

#include "core/sim.h"

struct ts_draw {
	double number;	  /* random, uniform in (0, 1) */
	int32_t tag, row; /* row: local index */
};

/* Lists the particles with chosen[i] != 0 in ascending order of their random numbers. The caller frees *out
 * with ts_free. */
enum ts_status ts_draw(struct tsim *sim, const unsigned char *chosen, int64_t seed, struct ts_draw **out,
		       size_t *n);
/* Number of particles whose random number is below the probability. */
size_t ts_draw_below(const struct ts_draw *draw, size_t n, double probability);
/* The fraction `part` of n, rounded to the nearest integer. */
size_t ts_draw_part(size_t n, double part);

#endif
