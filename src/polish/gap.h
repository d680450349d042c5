/* The gap between a height field (fix surface/voxel) and a plane face above it: of a plane wall, or the underside of a
 * second height field, at its `base`. Over column i it has the height H_i, the distance of its top from the face;
 * columns that reach the face touch it, H_i = 0. */
#ifndef TS_POLISH_GAP_H
#define TS_POLISH_GAP_H

#include "core/sim.h"
#include "voxel/voxel_surface.h"
#include "wall/wall.h"

struct ts_gap {
	const struct ts_voxel_surface *lower;
	const struct ts_wall *plane;	     /* the wall with the face; or NULL and */
	const struct ts_voxel_surface *slab; /* the field whose underside it is */
};

/* What the gap holds now. */
struct ts_gap_room {
	double face;	/* coordinate of the face along the axis of the heights */
	double volume;	/* sum of H_i over the columns, times the area of a column */
	double highest; /* largest H_i, length */
	double depth;	/* how deep the highest column is in the face, length; <= 0: none reaches it */
	int64_t stacked; /* sum of floor(H_i/d) over the columns: spheres of the diameter d that can be stacked */
	int64_t touching, columns;
};

/* In the init of a style: finds the two surfaces, or fails at these words with the reason. */
enum ts_status ts_gap_find(struct ts_instance *self, struct tsim *sim, const char *lower, const char *upper,
			   struct ts_gap *out);
struct ts_gap_room ts_gap_room(const struct ts_gap *g, const struct tsim *sim, double diameter);
/* Whether a sphere at x overlaps neither surface. `face`: of ts_gap_room. */
bool ts_gap_is_free(const struct ts_gap *g, double face, const double x[3], double radius);

#endif
