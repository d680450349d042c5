/* The velocity of the fluid inside a film. */
#ifndef TS_FILM_FILM_VELOCITY_H
#define TS_FILM_FILM_VELOCITY_H

#include "film/film.h"

/* The film at a point (x, y) of its grid; components along the axes of the grid. */
struct ts_film_point {
	double p, empty;
	double gap, slope[2], rate; /* h, grad h, dh/dt */
	double wall[2][2];	    /* velocity of the surface [0 lower, 1 upper] along [axis] */
	double fluid[2][2]; /* of the fluid at the surface; other than that of the surface with slip */
	double stretch[2];  /* divergence of `fluid` along the film, due to slip */
	double mean[2];	    /* mean velocity over the gap, q/h; in the cavity that of the fluid there */
};

/* Interpolates the film at a point; a point outside of the grid gets the values at the nearest point in it. Between
 * centres p, h, dh/dt and the velocities of the surfaces vary linearly along each axis (stepped: h and dh/dt are
 * constant in a cell); the flow varies linearly between opposite faces of a cell, so that its divergence there is
 * -dh/dt as in the balance of the cell. */
void ts_film_sample(const struct ts_film *f, const double x[2], struct ts_film_point *out);

/* Interpolates any field at centres in the way of h, and its gradient; continued linearly from the centres to the
 * edges. */
void ts_film_interpolate(const struct ts_film *f, const double *field, const double x[2], double *value,
			 double slope[2]);

/* Both at once. */
void ts_film_sample_with(const struct ts_film *f, const double *field, const double x[2],
			 struct ts_film_point *out, double *value, double slope[2]);

/* Velocity at the height z = h1 + s h, 0 <= s <= 1: along the film Couette flow and a parabola,
 *   u = U1 (1 - s) + U2 s + 6 s (1 - s) (mean - (U1 + U2)/2),
 * U1 and U2 those of the fluid at the surfaces, and across it w, for which div u = 0 and with which the fluid follows the
 * surfaces at s = 0 and s = 1. lower_slope = grad h1 and
 * lower_rate = dh1/dt describe the lower surface z = h1(x, y, t). */
void ts_film_profile(const struct ts_film_point *point, double s, const double lower_slope[2],
		     double lower_rate, double u[3]);

#endif
