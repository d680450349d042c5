/* Spheres of any sizes in space without bounds, for the question "does this sphere overlap one of them?".
 * Spheres of similar size share a hash of points, so mixed sizes cost little more than equal ones. */
#ifndef TS_GEOM_SPHEREHASH_H
#define TS_GEOM_SPHEREHASH_H

#include "geom/pointhash.h"

enum { TS_SPHEREHASH_LEVELS = 24 };

struct ts_spherehash {
	int nlevels;
	struct ts_spherehash_level {
		int exponent;	/* of two: 2^exponent <= radius < 2^(exponent + 1), about */
		double largest; /* radius */
		struct ts_pointhash points;
		double *radius;
		size_t capacity;
	} level[TS_SPHEREHASH_LEVELS];
};

/* Zero-initialise. */
void ts_spherehash_release(struct ts_spherehash *hash);
enum ts_status ts_spherehash_add(struct ts_spherehash *hash, const double x[3], double radius);
/* Touching counts as overlap. */
bool ts_spherehash_overlaps(const struct ts_spherehash *hash, const double x[3], double radius);
/* The same with the images of x across the periodic faces of the box. */
bool ts_spherehash_overlaps_periodic(const struct ts_spherehash *hash, const struct ts_box *box,
				     const double x[3], double radius);

#endif
