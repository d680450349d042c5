/* Distances of contacts and what follows from them by roots and divisions, for many contacts at once.
 *
 * Roots and divisions take most of the time of a law. In the loop over the law each waits for the one before; here the
 * first ones are computed for a whole batch, and with AVX-512 by multiplications and additions, while the divider is
 * busy with others. All results are correctly rounded: they have the bits of sqrt() and of a division. */
#ifndef TS_CONTACT_CONTACT_ROOTS_H
#define TS_CONTACT_CONTACT_ROOTS_H

#include <stddef.h>

/* Columns, aligned to 64 bytes, with room for n contacts rounded up to a multiple of 8. */
struct ts_contact_roots {
	const double *d[3], *radius[2]; /* vectors between the centres; radii of i and j */
	const double *r_eff;		/* R*, or NULL if `root` is not needed */
	double *distance, *inverse;	/* length of d; its reciprocal, 0 for coincident centres */
	double *root;			/* sqrt(R* delta), not a number where the surfaces do not touch */
};
void ts_contact_roots(const struct ts_contact_roots *c, size_t n);

#endif
