/* The surface of a bed or heap: the highest particle in each of many square columns along an upward direction. */
#ifndef TS_BED_HEAP_SURFACE_H
#define TS_BED_HEAP_SURFACE_H

#include "core/sim.h"

/* Upward direction, and two horizontal ones. */
struct ts_bed_frame {
	double up[3], side[2][3];
	int sides; /* horizontal directions in use: 1 in two dimensions */
};

struct ts_bed_grain {
	double cell[2]; /* indices of its column */
	double side[2]; /* coordinates along the horizontal directions */
	double height;	/* of its uppermost point */
	double bottom;	/* of its lowest point */
	int32_t tag;
};

/* Zero-initialise; ts_bed_surface_release when done. */
struct ts_bed_surface {
	struct ts_bed_frame frame;
	double column;		    /* width of the columns */
	struct ts_bed_grain *grain; /* [n] all particles of the group, sorted by column and height */
	size_t n, capacity;
	size_t *top; /* [ntops] the grain that makes the surface of each column with particles */
	size_t ntops, top_capacity;
	double base;   /* 1 % of the particles reach below this height: the foot of a bed */
	double volume; /* of all particles */
};

/* `up` need not be normalised; not 0, and in two dimensions without a z component: else an error. NaN: +z, in two
 * dimensions +y. */
enum ts_status ts_bed_frame_make(struct tsim *sim, const struct ts_instance *self, const double up[3],
				 struct ts_bed_frame *out);
/* Finds the surface. `column`: width of the columns, 0: twice the mean diameter. The surface of a column is at the
 * quantile `part` of the heights of its particles; 1: the highest. */
enum ts_status ts_bed_surface_find(struct tsim *sim, int group, double column, double part,
				   struct ts_bed_surface *surface);
void ts_bed_surface_release(struct ts_bed_surface *surface);

#endif
