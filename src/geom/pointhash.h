/* A hash of points by cubic cells, for questions of the kind "is there a point nearer than d?" in
 * space without bounds. Periodic images are put to the question by the caller. */
#ifndef TS_GEOM_POINTHASH_H
#define TS_GEOM_POINTHASH_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/status.h"
#include "geom/box.h"

struct ts_pointhash {
	double cell; /* edge of a cell: about the distance that is asked for */
	size_t n, capacity;
	double (*x)[3];
	int32_t *next; /* chain of points in the same bucket, -1: end */
	size_t next_capacity;
	int32_t *bucket; /* nbuckets, a power of two; heads of chains */
	size_t nbuckets;
};

/* cell > 0. Zero-initialised or released before. */
enum ts_status ts_pointhash_start(struct ts_pointhash *hash, double cell);
void ts_pointhash_release(struct ts_pointhash *hash);
enum ts_status ts_pointhash_add(struct ts_pointhash *hash, const double x[3]);

/* Calls for points within reach of x, and perhaps others, until one call returns true: the number of that
 * point, from 0 in the order of adding; -1: none. A point may come twice. */
typedef bool ts_pointhash_fn(void *context, size_t k);
int32_t ts_pointhash_visit(const struct ts_pointhash *hash, const double x[3], double reach,
			   ts_pointhash_fn *visit, void *context);
/* A point nearer to x than distance, or -1. */
int32_t ts_pointhash_find(const struct ts_pointhash *hash, const double x[3], double distance);
/* Is there one? */
bool ts_pointhash_near(const struct ts_pointhash *hash, const double x[3], double distance);
/* The same with the images of x across the periodic faces of the box. */
bool ts_pointhash_near_periodic(const struct ts_pointhash *hash, const struct ts_box *box, const double x[3],
				double distance);

#endif
