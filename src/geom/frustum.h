/* The surface of a cylinder or a truncated cone in the half-plane through its axis: distance r from the
 * axis, position s along it. */
#ifndef TS_GEOM_FRUSTUM_H
#define TS_GEOM_FRUSTUM_H

struct ts_frustum {
	double lo, hi, radius[2]; /* ends along the axis, and the radii there */
};

enum ts_frustum_face { TS_FRUSTUM_LOW, TS_FRUSTUM_HIGH, TS_FRUSTUM_SIDE, TS_FRUSTUM_FACES };

struct ts_frustum_contact_point {
	enum ts_frustum_face face;
	double r, s; /* nearest point of the surface */
};

/* Nearest points to (r, s) on each face that is not open (open: bit mask of faces); returns their
 * number. */
int ts_frustum_faces(const struct ts_frustum *f, unsigned open, double r, double s,
		     struct ts_frustum_contact_point out[TS_FRUSTUM_FACES]);
/* The nearest of these points, the side in case of equal distance; returns 0 if all faces are open. */
int ts_frustum_nearest(const struct ts_frustum *f, unsigned open, double r, double s,
		       struct ts_frustum_contact_point *out);

#endif
