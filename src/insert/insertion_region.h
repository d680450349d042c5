/* Places in a region for particles that are inserted: fix insert/pack and fix insert/rate/region. */
#ifndef TS_INSERT_INSERTION_REGION_H
#define TS_INSERT_INSERTION_REGION_H

#include "insert/insertion.h"
#include "region/region.h"

/* First member of the state of these fixes. The stream of random points belongs to the region, as in
 * LIGGGHTS: fixes that share a region share it, and the last one defined has seeded it. */
struct ts_insertion_region {
	struct ts_insertion base;
	struct ts_instance *region;
	int64_t ntry_mc;
	bool check_border, warn_region;
	double volume; /* of the region; saved */
};
#define TS_INSERTION_REGION_SAVED(T) TS_INSERTION_SAVED(T), TS_SAVE_F64(T, place.volume)
#define TS_INSERTION_REGION_ARGS(T)                                                                        \
	TS_REGION("region", T, place.region, .help = "where particles are inserted"),                      \
		TS_INT("ntry_mc", T, place.ntry_mc, .fallback = "100000", .range = TS_WITHIN, .lo = 1001,  \
		       .hi = 1e9,                                                                          \
		       .help = "random points for the volume of the region, which LIGGGHTS finds by lot"), \
		TS_BOOL("check_dist_from_subdomain_border", T, place.check_border, .fallback = "yes",      \
			.help = "with overlapcheck yes no particle is placed nearer to a face of the box " \
				"than its radius"),                                                        \
		TS_BOOL("warn_region", T, place.warn_region, .fallback = "yes",                            \
			.help = "no effect: a region that does not fit is an error")

enum ts_status ts_insertion_region_init(struct ts_instance *self, struct tsim *sim);
/* The region and what is in it at the beginning of an event. */
struct ts_region_content {
	double room; /* volume of the region */
	double volume, mass;
	int64_t number;
};
enum ts_status ts_insertion_region_content(struct ts_instance *self, struct tsim *sim,
					   struct ts_region_content *out);
/* Draws n particles, finds places for them with so many tries in all, and makes them. */
enum ts_status ts_insertion_region_event(struct ts_instance *self, struct tsim *sim, int64_t n,
					 int64_t most_tries);
/* Draws n particles and gives them places, whether they overlap or not: in the list of newcomers. */
enum ts_status ts_insertion_region_scatter(struct ts_instance *self, struct tsim *sim, int64_t n);
enum ts_status ts_insertion_region_archive(struct ts_instance *self, struct tsim *sim,
					   struct ts_archive *archive);

#endif
