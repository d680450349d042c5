/* Largest stable time step of a network of bodies joined by springs and dashpots.
 *
 * Velocity Verlet and symplectic Euler use in dashpots the velocities of the half step before, and so
 * discretise M a + C v + K x = 0 as
 *
 *   M (x+ - 2 x + x-) + h C (x - x-) + h^2 K x = 0.
 *
 * A mode x ~ z^k u fulfils m (z - 1)^2 + h c (z - 1) + h^2 k z = 0 with m = u M u, c = u C u, k = u K u >= 0.
 * Both |z| <= 1 if h^2 k + 2 h c <= 4 m (Jury criterion). At the limit z = -1, and the mode is in the null
 * space of 4 M - 2 h C - h^2 K, for any M, C and K:
 *
 *   h is stable <=> h^2 times the largest eigenvalue of M^-1 (K + 2 C/h) is at most 4.
 *
 * So a dashpot increases the stiffness by 2 c/h. Any motion u gives, by its m, c and k (Rayleigh quotient),
 * an upper bound of the stable step; the method of C. Lanczos (J. Res. Natl. Bur. Stand. 45 (1950) 255)
 * converges to that of the fastest mode from above. A part of a network, with the other bodies fixed, has a
 * larger limit than the whole. */
#ifndef TS_LIMITS_LANCZOS_H
#define TS_LIMITS_LANCZOS_H

#include <stdbool.h>
#include <stddef.h>

#include "base/status.h"

/* Inverse mass and inverse inertia tensor (in the frame of the box) of a particle or rigid body. */
struct ts_lanczos_body {
	double inverse_mass;
	double inverse_inertia[3][3];
	/* of springs to the ground along x, y, z: stiffness; of dashpots: force by velocity, torque by angular velocity */
	double spring[3], drag[2];
};

enum { TS_LINK_NORMAL, TS_LINK_TANGENTIAL, TS_LINK_ROLLING, TS_LINK_TWISTING, TS_LINK_SPRINGS };

/* A contact or bond as seen from body a; b has another link of its own. */
struct ts_link {
	int a, b; /* indices of bodies; b -1: immobile partner */
	double n[3];
	double arm[2][3]; /* lever arms from the centres to the contact point, length */
	/* stiffness and damping in normal and tangential direction, of rolling or bending, and of twisting */
	double k[TS_LINK_SPRINGS], c[TS_LINK_SPRINGS];
	bool bonded; /* all springs always act; else the tangential and rolling ones only with slip, below */
};

struct ts_lanczos {
	struct ts_lanczos_body *body;
	size_t nbodies, body_capacity;
	struct ts_link *link;
	size_t nlinks, link_capacity;
	/* by body: a motion (velocity, angular velocity), and its forces and torques */
	double (*u)[6], (*f)[6];
	/* basis of the Lanczos method, LANCZOS_STEPS motions one after the other, and M times them */
	double (*basis)[6], (*momentum)[6];
	size_t u_capacity, f_capacity, basis_capacity, momentum_capacity;
};
void ts_lanczos_clear(struct ts_lanczos *network); /* removes all bodies and links, keeps the memory */
void ts_lanczos_release(struct ts_lanczos *network);

/* Computes the largest stable step *limit, time, to some tenths of a per cent. `slip`: including the
 * tangential and rolling springs. `near`: a first estimate. *worst: the body with the largest part in the
 * fastest mode. Returns TS_OK or TS_NOMEM. */
enum ts_status ts_lanczos_limit(struct ts_lanczos *network, bool slip, double near, double *limit,
				int *worst);

#endif
