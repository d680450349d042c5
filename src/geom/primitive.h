/* Primitive walls: planes and cylinders, both sides. */
#ifndef TS_GEOM_PRIMITIVE_H
#define TS_GEOM_PRIMITIVE_H

enum ts_primitive_shape { TS_XPLANE, TS_YPLANE, TS_ZPLANE, TS_XCYLINDER, TS_YCYLINDER, TS_ZCYLINDER };

struct ts_primitive {
	enum ts_primitive_shape shape;
	double position; /* coordinate of a plane */
	double radius;	 /* of a cylinder */
	/* axis of a cylinder: coordinates along the next two axes in cyclic order: y,z | z,x | x,y */
	double centre[2];
};

/* Distance of x from the surface, >= 0, and the unit vector n from the nearest point of the surface to
 * x. On the surface, and on the axis of a cylinder, where the direction is undefined, n = 0. */
double ts_primitive_distance(const struct ts_primitive *wall, const double x[3], double n[3]);

#endif
