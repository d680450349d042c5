/* Displacement of the surface of an elastic half-space under a pressure that is constant on each rectangle of a grid.
 *
 * E* is the contact modulus: 1/E* = (1 - nu_1^2)/E_1 + (1 - nu_2^2)/E_2; u is the sum of the displacements of both
 * solids, positive away from the contact.
 *
 * Not periodic: u(x) = 1/(pi E*) int p(x')/|x - x'| dA', integrated over each rectangle (A. E. H. Love, Phil. Trans.
 * R. Soc. A 228 (1929) 377; K. L. Johnson, Contact Mechanics (1985), eq 3.25).
 * Periodic: u_q = 2 p_q/(E* |q|) for wave vectors q /= 0; the mean of u is 0, as the displacement of an infinite plane
 * under a mean pressure has no reference (K. L. Johnson, section 13.2). */
#ifndef TS_ROUGH_HALF_SPACE_H
#define TS_ROUGH_HALF_SPACE_H

#include "math/convolution.h"

struct ts_half_space_grid {
	int n[2];	 /* cells along both axes */
	double width[2]; /* their edges, length */
	double modulus;	 /* E*, pressure */
	bool periodic;
};

/* Zero-initialise. */
struct ts_half_space {
	struct ts_half_space_grid grid;
	struct ts_convolution compliance;
	bool made; /* for this grid */
};

/* Makes the kernel, unless it is that of this grid already. Returns TS_OK or TS_NOMEM; to be released also after a
 * failure. */
enum ts_status ts_half_space_make(struct ts_half_space *h, const struct ts_half_space_grid *grid,
				  int threads);
void ts_half_space_release(struct ts_half_space *h);
/* pressure, displacement: [n[1]][n[0]]; may be the same array. Returns TS_OK or TS_NOMEM. */
enum ts_status ts_half_space_displace(struct ts_half_space *h, const double *pressure, double *displacement);

#endif
