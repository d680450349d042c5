/* The fastest mode of some bodies that springs and dashpots join.
 *
 * M a + C v + K x = 0 with velocity Verlet or symplectic Euler, which see the dashpots half a step late,
 * is
 *
 *   M (x+ - 2 x + x-) + h C (x - x-) + h^2 K x = 0,
 *
 * for a mode x ~ z^k u: m (z - 1)^2 + h c (z - 1) + h^2 k z = 0 with m = u M u, c = u C u, k = u K u >= 0.
 * Both |z| <= 1 as long as h^2 k + 2 h c <= 4 m (Jury). At the limit z = -1, and the mode is one of 4 M -
 * 2 h C - h^2 K = 0, whatever M, C and K:
 *
 *   h is stable  <=>  h^2 times the largest number of M^-1 (K + 2 C/h) is at most 4.
 *
 * A dashpot makes a spring stiffer by 2 c/h. Any u gives, by its m, c and k (Rayleigh), a step beyond
 * which nothing is stable: the method of C. Lanczos (J. Res. Natl. Bur. Stand. 45 (1950) 255) finds that
 * of the fastest mode, from above; and a part of a network, the rest held, has a larger limit than the
 * whole. */
#ifndef TS_LIMITS_LANCZOS_H
#define TS_LIMITS_LANCZOS_H

#include <stdbool.h>
#include <stddef.h>

#include "base/status.h"

/* Translation and rotation of something rigid. */
struct ts_lanczos_body {
	double inverse_mass;
	double inverse_inertia[3][3];
};

/* A contact as body a feels it; b has one of its own. */
struct ts_link {
	int a, b; /* b -1: it is held */
	double n[3];
	double arm[2][3];  /* from the centres to the point of contact */
	double k[3], c[3]; /* spring and dashpot along n, across it, and against rolling */
};

struct ts_lanczos {
	struct ts_lanczos_body *body;
	size_t nbodies, body_capacity;
	struct ts_link *link;
	size_t nlinks, link_capacity;
	double (*u)[6], (*f)[6]; /* a motion, and the forces it calls forth */
	/* motions that are orthogonal, one after the other, and M times them */
	double (*basis)[6], (*momentum)[6];
	size_t u_capacity, f_capacity, basis_capacity, momentum_capacity;
};
void ts_lanczos_clear(struct ts_lanczos *linkage); /* keeps the memory */
void ts_lanczos_release(struct ts_lanczos *linkage);

/* The largest stable step, to some tenths of a per cent. `slip`: with
 * the springs across and against rolling. `near`: a step to begin with. *worst: the body that moves most.
 * TS_NOMEM. */
enum ts_status ts_lanczos_limit(struct ts_lanczos *linkage, bool slip, double near, double *limit,
				int *worst);

#endif
