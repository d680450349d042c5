/* A cloud of particles of different sizes that collide, the same each time. */
#ifndef TESTS_CLOUD_H
#define TESTS_CLOUD_H

#include "deck.h"

enum { CLOUD_EDGE = 4, CLOUD = CLOUD_EDGE * CLOUD_EDGE * CLOUD_EDGE };

/* Particles by identity. */
struct cloud {
	double x[3][CLOUD], v[3][CLOUD], m[CLOUD], r[CLOUD];
};

/* A disturbed lattice that moves inwards. */
struct cloud cloud_start(void);
/* `boundary` as in the command, `options` after pair_style spring/dashpot; forces of the first
 * step are done. Edge of the box: CLOUD_BOX, from -CLOUD_BOX/2 on. */
struct tsim *cloud_open(const char *boundary, const char *options, const char *integrator,
			struct cloud start);
/* Identities less `skip`. */
struct cloud cloud_read(struct tsim *sim, int skip);

extern const double CLOUD_BOX;

#endif
