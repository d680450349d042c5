/* Spheres that move along straight lines: when they first touch something at rest. Whatever they part from, or move along,
 * is not touched, even if they overlap it. */
#ifndef TS_GEOM_SWEEP_H
#define TS_GEOM_SWEEP_H

#include <stdbool.h>

#include "geom/primitive.h"

struct ts_sweep {
	double x[3], v[3], radius; /* of the sphere at the begin; v: relative to what may be touched */
	double span;		   /* time for which it moves */
};
struct ts_sweep_hit {
	double time, n[3]; /* from the begin; unit vector from the point of contact to the centre */
	double overlap;	   /* > 0: they overlap already at the begin, and approach; then time is 0 */
};

bool ts_sweep_point(const struct ts_sweep *s, const double point[3], struct ts_sweep_hit *hit);
/* The line from `a` along the unit vector `along`, up to `length`; its ends excluded. */
bool ts_sweep_line(const struct ts_sweep *s, const double a[3], const double along[3], double length,
		   struct ts_sweep_hit *hit);
/* The plane through `a`, from either side. */
bool ts_sweep_plane(const struct ts_sweep *s, const double a[3], const double normal[3],
		    struct ts_sweep_hit *hit);
/* Planes and cylinders, from either side. */
bool ts_sweep_primitive(const struct ts_sweep *s, const struct ts_primitive *wall, struct ts_sweep_hit *hit);

#endif
