/* Spatial hash of spheres of any sizes in unbounded space, for overlap queries. Spheres of similar size
 * share a hash of points, so mixed sizes cost little more than equal ones. */
#ifndef TS_GEOM_SPHEREHASH_H
#define TS_GEOM_SPHEREHASH_H

#include "geom/pointhash.h"

enum { TS_SPHEREHASH_LEVELS = 24 };

struct ts_spherehash {
	int nlevels;
	size_t n;
	struct ts_spherehash_level {
		int exponent;	/* size class: about 2^exponent <= radius < 2^(exponent + 1) */
		double largest; /* largest radius */
		struct ts_pointhash points;
		double *radius;
		size_t *item; /* number of the sphere */
		size_t capacity, item_capacity;
	} level[TS_SPHEREHASH_LEVELS];
};

/* Zero-initialise. */
void ts_spherehash_release(struct ts_spherehash *hash);
enum ts_status ts_spherehash_add(struct ts_spherehash *hash, const double x[3], double radius);
/* Calls `visit` with the number, in the order of adding from 0, of all spheres of the hash that overlap or touch this one,
 * until it returns true. Returns whether it did. A sphere may be visited twice. */
bool ts_spherehash_visit(const struct ts_spherehash *hash, const double x[3], double radius,
			 ts_pointhash_fn *visit, void *context);
/* Largest radius; 0 without spheres. */
double ts_spherehash_largest(const struct ts_spherehash *hash);
/* Whether the sphere overlaps or touches one of the hash. */
bool ts_spherehash_overlaps(const struct ts_spherehash *hash, const double x[3], double radius);
/* The same including the periodic images of x; x and the spheres of the hash are in the box. */
bool ts_spherehash_overlaps_periodic(const struct ts_spherehash *hash, const struct ts_box *box,
				     const double x[3], double radius);

#endif
