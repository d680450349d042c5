/* A round nozzle: points in its opening, a disc or a ring, and directions in a cone about its axis. */
#ifndef TS_INSERT_NOZZLE_H
#define TS_INSERT_NOZZLE_H

#include "math/minstd.h"

enum ts_nozzle_cone {
	TS_CONE_UNIFORM,  /* uniform over the solid angle within `angle` of the axis */
	TS_CONE_GAUSSIAN, /* density per solid angle exp(-(t/angle)^2/2) at the angle t <= 3 angle */
	TS_CONE_LINEAR	  /* straight lines from one apex: tan t grows linearly to tan `angle` at the rim */
};

struct ts_nozzle {
	double centre[3], axis[3]; /* of the opening; unit vector along the jet */
	double side[2][3];	   /* unit vectors across the axis and each other */
	double outer, inner;	   /* radii of the opening */
	int cone;		   /* enum ts_nozzle_cone */
	double angle;		   /* of the cone [radian] */
};

/* Sets axis and side from a direction of any length, not 0. */
void ts_nozzle_orient(struct ts_nozzle *nozzle, const double direction[3]);
/* Largest angle between a direction and the axis [radian]. */
double ts_nozzle_widest(const struct ts_nozzle *nozzle);
/* Draws a point, uniform over the opening without margins of this width at its edges. */
void ts_nozzle_draw_point(const struct ts_nozzle *nozzle, double margin, struct ts_minstd *random,
			  double x[3]);
/* Draws a direction, a unit vector; with a linear cone, or an angle of 0, that of the axis without drawing. */
void ts_nozzle_draw_direction(const struct ts_nozzle *nozzle, struct ts_minstd *random, double out[3]);
/* The direction at the point x of the opening, for a linear cone. */
void ts_nozzle_linear_direction(const struct ts_nozzle *nozzle, const double x[3], double out[3]);

#endif
