/* Particles drawn by lot: keyed by seed and identity, so neither order nor threads matter. */
#ifndef TS_PARTICLE_DRAW_H
#define TS_PARTICLE_DRAW_H

#include "core/sim.h"

struct ts_draw {
	double number; /* uniform in (0, 1) */
	int32_t tag, row;
};

/* The local particles with a flag, in the order of their numbers; to be freed with ts_free. */
enum ts_status ts_draw(struct tsim *sim, const unsigned char *chosen, int64_t seed, struct ts_draw **out,
		       size_t *n);
/* How many have a number below the probability. */
size_t ts_draw_below(const struct ts_draw *draw, size_t n, double probability);
/* This part of n, to the nearest integer. */
size_t ts_draw_part(size_t n, double part);

#endif
