/* Insertion at random positions in a region: fix insert/pack and fix insert/rate/region. */
#ifndef TS_INSERT_INSERTION_REGION_H
#define TS_INSERT_INSERTION_REGION_H

#include "insert/insertion.h"
#include "region/region.h"

/* First member of the state of these fixes. As in LIGGGHTS, the random stream of positions belongs to the
 * region: fixes with the same region share it, and the one defined last seeds it. */
struct ts_insertion_region {
	struct ts_insertion base;
	struct ts_instance *region;
	int64_t ntry_mc; /* random points for the volume */
	bool check_border, warn_region;
	struct ts_words avoid; /* IDs of meshes that particles must not touch */
	double volume;	       /* of the part that is in the box, by Monte Carlo integration; saved */
	double bounds[2][3];   /* of that part, when its volume was integrated; saved */
};
#define TS_INSERTION_REGION_SAVED(T) TS_INSERTION_SAVED(T), TS_SAVE_F64(T, place.volume)
#define TS_INSERTION_REGION_ARGS(T)                                                                         \
	TS_REGION("region", T, place.region, .help = "where particles are inserted"),                       \
		TS_INT("ntry_mc", T, place.ntry_mc, .fallback = "100000", .range = TS_WITHIN, .lo = 1000,   \
		       .hi = 1e9,                                                                           \
		       .help = "number of random points for the volume of the region, as in LIGGGHTS"),     \
		TS_BOOL("check_dist_from_subdomain_border", T, place.check_border, .fallback = "yes",       \
			.help = "with overlapcheck yes the distance of a particle to the faces of the box " \
				"is "                                                                       \
				"at least its radius"),                                                     \
		TS_BOOL("warn_region", T, place.warn_region, .fallback = "yes",                             \
			.help = "no effect: a region that does not fit is an error")
/* For the fixes that check overlaps. */
#define TS_INSERTION_AVOID_ARG(T)                                                                        \
	TS_SOME_KEYWORD("avoid_meshes", T, place.avoid, 0,                                               \
			.help = "IDs of meshes: inserted particles must not touch their triangles, nor " \
				"clumps with the sphere around them")

enum ts_status ts_insertion_region_init(struct ts_instance *self, struct tsim *sim);
/* Content of the region before an insertion: particles and rigid clumps whose centres lie in it. */
struct ts_region_content {
	double room;	     /* volume of the part of the region that is in the box */
	double volume, mass; /* of the particles */
	int64_t number;
};
/* Evaluates variables of the region, and its content unless `out` is NULL. */
enum ts_status ts_insertion_region_content(struct ts_instance *self, struct tsim *sim,
					   struct ts_region_content *out);
/* After that: the faces of the box beyond which the region reaches; infinite where it does not. */
void ts_insertion_region_faces(const struct ts_insertion_region *s, const struct ts_box *box,
			       double face[3][2]);
/* Draws n particles, searches positions for them with at most `most_tries` trial positions in all, and
 * creates them. */
enum ts_status ts_insertion_region_event(struct ts_instance *self, struct tsim *sim, int64_t n,
					 int64_t most_tries);
/* Draws n particles and random positions, without a check of overlaps, in the list; creates none. */
enum ts_status ts_insertion_region_scatter(struct ts_instance *self, struct tsim *sim, int64_t n);
enum ts_status ts_insertion_region_archive(struct ts_instance *self, struct tsim *sim,
					   struct ts_archive *archive);

/* Order of these arguments in the manual pages. */
#define TS_INSERTION_REGION_GROUPS                                                                \
	{ NULL, "region" },                                                                       \
	{                                                                                         \
		"The region", "ntry_mc check_dist_from_subdomain_border warn_region avoid_meshes" \
	}

#endif
