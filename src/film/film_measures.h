/* Loads, friction and flows of a film. */
#ifndef TS_FILM_FILM_MEASURES_H
#define TS_FILM_FILM_MEASURES_H

#include "film/film.h"

/* Forces on a surface, moments and places are in Cartesian coordinates, also on a polar grid; moments are about the
 * origin and the normal of the film. */
struct ts_film_measures {
	double load;	  /* sum of p - ambient over the area, which pushes the surfaces apart */
	double pressed;	  /* sum of |p - ambient| over the area */
	double centre[2]; /* centre of pressure of the load; NaN if the load is 0, up to round-off */
	double p_max;	  /* by a parabola through the highest centre and its neighbours */
	double p_max_at[2];
	double least_gap;
	/* Shear forces of the fluid on the surfaces [0 lower, 1 upper] along [axis]: sums over the area of
	 * +-eta (1 - theta) (U2 - U1)/h - h/2 grad p, with slip those of film_section.c; half and reynolds shear the
	 * whole gap also in the cavity. Of rough surfaces those of film_roughness.c. */
	double shear[2][2];
	double torque[2]; /* moments of `shear` */
	/* Forces of the pressure along the film, on both surfaces together: sum of -(p - ambient) grad h. They act on
	 * the surface that is not plane. */
	double pressure_force[2];
	double outflow[2][2]; /* volume per time that leaves through the edges [axis][low, high] */
	double volume;	      /* of fluid in the gap */
	/* of asperities: load, area in contact, friction on the upper surface along [axis] */
	double touch_load, touch_area, touch_friction[2];
};

void ts_film_measure(const struct ts_film *f, struct ts_film_measures *out);

#endif
