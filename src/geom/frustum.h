/* The surface of a cylinder or a truncated cone, in the half-plane through its axis: r from the axis, s
 * along it. */
#ifndef TS_GEOM_FRUSTUM_H
#define TS_GEOM_FRUSTUM_H

struct ts_frustum {
	double lo, hi, radius[2]; /* the ends, and the radii there */
};

enum ts_frustum_face { TS_FRUSTUM_LOW, TS_FRUSTUM_HIGH, TS_FRUSTUM_SIDE, TS_FRUSTUM_FACES };

struct ts_frustum_contact_point {
	enum ts_frustum_face face;
	double r, s; /* the point of the surface that is nearest */
};

/* Of each face that is not open (bit of its number) the point nearest to (r, s); returns how many. */
int ts_frustum_faces(const struct ts_frustum *f, unsigned open, double r, double s,
		     struct ts_frustum_contact_point out[TS_FRUSTUM_FACES]);
/* The one of them that is nearest of all, of equal ones that of the side; 0: all faces are open. */
int ts_frustum_nearest(const struct ts_frustum *f, unsigned open, double r, double s,
		       struct ts_frustum_contact_point *out);

#endif
