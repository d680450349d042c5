/* Regions: sets of points a script can name. A region style describes its shape; `side out` and
 * lattice units are the same for all. */
#ifndef TS_PARTICLES_REGION_H
#define TS_PARTICLES_REGION_H

#include "core/sim.h"

/* First member of every region's state. */
struct ts_region {
	int side;    /* 0 in, 1 out */
	int units;   /* 0 lattice, 1 box */
	double scale; /* factor for lengths: set by ts_region_init */
};
#define TS_REGION_ARGS(T)                                                                          \
	TS_ENUM("side", T, region.side, ts_region_sides, .fallback = "in",                         \
		.help = "which side belongs to the region"),                                       \
	TS_ENUM("units", T, region.units, ts_region_units, .fallback = "lattice",                  \
		.help = "whether lengths are given in lattice spacings or as they are")
extern const char *const ts_region_sides[], *const ts_region_units[];

struct ts_region_style {
	struct ts_style style;
	/* The shape itself, without `side`. */
	bool (*contains)(const struct ts_instance *self, const double x[3]);
	/* Box around the shape; ±INFINITY where it has no end. */
	void (*bounds)(const struct ts_instance *self, double lo[3], double hi[3]);
};

/* State of the regions that combine others. */
struct ts_region_set {
	struct ts_region region;
	int64_t n;
	struct ts_words names;
	struct ts_instance **member;
};
extern const struct ts_arg ts_region_set_args[];
enum ts_status ts_region_set_init(struct ts_instance *self, struct tsim *sim);

bool ts_region_contains(const struct ts_instance *region, const double x[3]);
void ts_region_bounds(const struct ts_instance *region, double lo[3], double hi[3]);
/* Sets region.scale from the lattice; call first in a region's init. */
void ts_region_init(struct ts_instance *self, struct tsim *sim);

#endif
