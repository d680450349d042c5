#include "region/region_frustum.h"

#include <math.h>

#include "base/banned.h"

int ts_region_frustum_contact_points(const struct ts_region *region, const struct ts_frustum *shape, int axis,
				     const int c[2], const double center[2], const double x[3], bool inside,
				     struct ts_region_contact_point *out)
{
	struct ts_frustum_contact_point spot[TS_FRUSTUM_FACES];
	double a = x[c[0]] - center[0], b = x[c[1]] - center[1], r = sqrt(a * a + b * b);
	int n = inside ? ts_frustum_faces(shape, region->open, r, x[axis], spot)
		       : ts_frustum_nearest(shape, region->open, r, x[axis], spot),
	    kept = 0;

	for (int k = 0; k < n; k++) {
		double dr = r - spot[k].r, ds = x[axis] - spot[k].s, d = sqrt(dr * dr + ds * ds);
		bool curved = spot[k].face == TS_FRUSTUM_SIDE && spot[k].r > 0;

		if (!(r > 0) && dr != 0) /* on the axis: no direction */
			continue;
		out[kept] = (struct ts_region_contact_point){ .distance = d,
							      .face = inside ? (int)spot[k].face : 0 };
		if (curved)
			out[kept].curvature = (inside ? -0.5 : 0.5) / spot[k].r;
		if (d > 0) {
			out[kept].n[axis] = ds / d;
			out[kept].n[c[0]] = r > 0 ? dr / d * a / r : 0;
			out[kept].n[c[1]] = r > 0 ? dr / d * b / r : 0;
		}
		kept++;
	}
	return kept;
}

bool ts_region_frustum_turns_in_place(const struct ts_region *r, int axis, const int c[2],
				      const double center[2])
{
	return fabs(r->axis[axis]) == 1 && r->pivot[c[0]] == center[0] && r->pivot[c[1]] == center[1];
}
