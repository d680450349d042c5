/* Primitive walls: planes and cylinders, two-sided. */
#ifndef TS_GEOM_PRIMITIVE_H
#define TS_GEOM_PRIMITIVE_H

enum ts_primitive_shape { TS_XPLANE, TS_YPLANE, TS_ZPLANE, TS_XCYLINDER, TS_YCYLINDER, TS_ZCYLINDER };

struct ts_primitive {
	enum ts_primitive_shape shape;
	double position;  /* of a plane */
	double radius;	  /* of a cylinder */
	double centre[2]; /* of a cylinder, along the next two axes in cyclic order: y,z | z,x | x,y */
};

/* Distance from the wall's surface, >= 0, and the unit vector from the nearest point of the surface
 * towards x. On the surface itself, and on the axis of a cylinder, where no direction is distinguished,
 * n = 0. */
double ts_primitive_distance(const struct ts_primitive *wall, const double x[3], double n[3]);

#endif
