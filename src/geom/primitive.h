/* Primitive walls: planes and cylinders, both sides. */
#ifndef TS_GEOM_PRIMITIVE_H
#define TS_GEOM_PRIMITIVE_H

#include <math.h>

#include "base/inline.h"

enum ts_primitive_shape { TS_XPLANE, TS_YPLANE, TS_ZPLANE, TS_XCYLINDER, TS_YCYLINDER, TS_ZCYLINDER };

struct ts_primitive {
	enum ts_primitive_shape shape;
	double position; /* coordinate of a plane */
	double radius;	 /* of a cylinder */
	/* axis of a cylinder: coordinates along the next two axes in cyclic order: y,z | z,x | x,y */
	double centre[2];
};

TS_INLINE double ts_plane_distance(const struct ts_primitive *wall, const double x[3], double n[3])
{
	int dim = (int)wall->shape;
	double d = x[dim] - wall->position;

	n[dim] = d > 0 ? 1 : d < 0 ? -1 : 0;
	return fabs(d);
}

TS_INLINE double ts_cylinder_distance(const struct ts_primitive *wall, const double x[3], double n[3])
{
	int axis = (int)wall->shape - TS_XCYLINDER;
	int a = (axis + 1) % 3, b = (axis + 2) % 3;
	double da = x[a] - wall->centre[0], db = x[b] - wall->centre[1];
	double r = sqrt(da * da + db * db), sign;

	if (!(r > 0))
		return wall->radius;
	sign = r > wall->radius ? 1 : r < wall->radius ? -1 : 0;
	n[a] = sign * da / r;
	n[b] = sign * db / r;
	return fabs(r - wall->radius);
}

/* Distance of x from the surface, >= 0, and the unit vector n from the nearest point of the surface to
 * x. On the surface, and on the axis of a cylinder, where the direction is undefined, n = 0. */
TS_INLINE double ts_primitive_distance(const struct ts_primitive *wall, const double x[3], double n[3])
{
	n[0] = n[1] = n[2] = 0;
	return wall->shape <= TS_ZPLANE ? ts_plane_distance(wall, x, n) : ts_cylinder_distance(wall, x, n);
}

#endif
