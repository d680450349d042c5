/* Area of the circle of intersection of two overlapping spheres, or of a sphere and a plane. */
#ifndef TS_LAW_LENS_H
#define TS_LAW_LENS_H

#include "base/inline.h"
#include "math/constants.h"

/* -pi/4 (r-Ri-Rj)(r+Ri-Rj)(r-Ri+Rj)(r+Ri+Rj)/r^2, r the distance of the centres; the larger radius is Ri, so that the
 * bits do not depend on which sphere comes first. */
TS_INLINE double ts_lens_of_spheres(double r, double one, double other)
{
	double ri = one > other ? one : other, rj = one > other ? other : one;

	return -TS_PI / 4 * (r - ri - rj) * (r + ri - rj) * (r - ri + rj) * (r + ri + rj) / (r * r);
}

/* pi (R^2 - r^2), r the distance of the centre from the plane. */
TS_INLINE double ts_lens_of_plane(double r, double radius)
{
	return TS_PI * (radius * radius - r * r);
}

#endif
