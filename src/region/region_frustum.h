/* Contact points on regions that are solids of revolution: cylinder and cone. */
#ifndef TS_REGION_REGION_FRUSTUM_H
#define TS_REGION_REGION_FRUSTUM_H

#include "geom/frustum.h"
#include "region/region.h"

/* Contact points of x; returns their number. c: dimensions normal to the axis; center: its coordinates in
 * these. */
int ts_region_frustum_contact_points(const struct ts_region *region, const struct ts_frustum *shape, int axis,
				     const int c[2], const double center[2], const double x[3], bool inside,
				     struct ts_region_contact_point *out);
/* Slot turns_in_place: the axis of the rotation is that of the solid. */
bool ts_region_frustum_turns_in_place(const struct ts_region *region, int axis, const int c[2],
				      const double center[2]);

#endif
