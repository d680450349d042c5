/* Signed distance of a point from the solid of a voxel height field.
 *
 * The space above the columns is itself a height field, upside down: heights -h along the reversed axis,
 * without end where there is no column. So the point outside that is nearest to a point in the solid is found
 * as the nearest point of that field (voxel/voxel_touch.h); the sides at the ends of a field that is not
 * periodic and the base are planes. The cost of a point depends on the columns within reach, not on their
 * number. */
#ifndef TS_VOXEL_VOXEL_DISTANCE_H
#define TS_VOXEL_VOXEL_DISTANCE_H

#include "voxel/voxel_field.h"

/* The space above a field, upside down. Zero-initialise; `field` is released by ts_voxel_field_release. */
struct ts_voxel_space {
	struct ts_voxel_field field;
	/* [index][0 low, 1 high]: the solid continues beyond this end of a field that is not periodic, where no
	 * point is asked for: it is no surface. Set by the caller */
	bool continues[2][2];
	bool bottomless; /* the same for the base */
};

struct ts_voxel_distance {
	double distance; /* length; < 0 inside; 0 on the surface */
	double n[3]; /* unit vector out of the solid, along the line through the point and the nearest one */
};

/* Makes the space above `f`, or follows its heights; *changed: they are not those of the last call. Returns TS_OK
 * or TS_NOMEM. */
enum ts_status ts_voxel_space_update(struct ts_voxel_space *space, const struct ts_voxel_field *f,
				     bool *changed);

/* Signed distance of x, in the frame of the field, from its surface; false: it is not less than `reach`, and `out`
 * is not written. */
bool ts_voxel_signed_distance(const struct ts_voxel_field *f, const struct ts_voxel_space *space,
			      const double x[3], double reach, struct ts_voxel_distance *out);

/* Whether x is below the top of its column, and above the base, at any distance. */
bool ts_voxel_inside(const struct ts_voxel_field *f, const double x[3]);

#endif
