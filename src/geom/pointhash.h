/* Spatial hash of points in cubic cells, for queries of points within a distance in unbounded space.
 * Periodic images are queried by the caller. */
#ifndef TS_GEOM_POINTHASH_H
#define TS_GEOM_POINTHASH_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/status.h"
#include "geom/box.h"

struct ts_pointhash {
	double cell; /* edge length of a cell: about the query distance */
	size_t n, capacity;
	double (*x)[3];
	int32_t *next; /* linked list of points in the same bucket, -1: end */
	size_t next_capacity;
	int32_t *bucket; /* nbuckets entries, a power of two: heads of the lists */
	size_t nbuckets;
};

/* Starts an empty hash; cell > 0. The hash must be zero-initialised or released. */
enum ts_status ts_pointhash_start(struct ts_pointhash *hash, double cell);
void ts_pointhash_release(struct ts_pointhash *hash);
enum ts_status ts_pointhash_add(struct ts_pointhash *hash, const double x[3]);

/* Calls `visit` for all points within reach of x, and possibly others, until it returns true. Returns
 * the index of that point, in the order of adding from 0, or -1. A point may be visited twice. */
typedef bool ts_pointhash_fn(void *context, size_t k);
int32_t ts_pointhash_visit(const struct ts_pointhash *hash, const double x[3], double reach,
			   ts_pointhash_fn *visit, void *context);
/* Index of a point nearer to x than distance, or -1. */
int32_t ts_pointhash_find(const struct ts_pointhash *hash, const double x[3], double distance);
/* Whether there is such a point. */
bool ts_pointhash_near(const struct ts_pointhash *hash, const double x[3], double distance);
/* The same including the periodic images of x. */
bool ts_pointhash_near_periodic(const struct ts_pointhash *hash, const struct ts_box *box, const double x[3],
				double distance);

#endif
