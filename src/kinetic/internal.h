/* Shared by the files of the shear flow between rough walls, granular_couette.h, and of the sheared film, sheared_film.h. */
#ifndef TS_KINETIC_INTERNAL_H
#define TS_KINETIC_INTERNAL_H

#include "kinetic/sheared_film.h"

/* Coefficients of the equations at x = ln(nu/(nu_limit - nu)). */
struct ts_couette_at {
	double nu;
	double root_t; /* sqrt(T) */
	double slope;  /* dx/dy over q */
	double shear;  /* a */
	double loss;   /* b */
};
void ts_couette_at(const struct ts_couette *c, double x, struct ts_couette_at *out);
double ts_couette_x(const struct ts_couette *c, double nu);
/* x at which the coefficients have a step; NaN: at none. */
double ts_couette_kink(const struct ts_couette *c);

/* Derivatives of the four unknowns of a node with y, and of these with the unknowns. */
struct ts_couette_rate {
	double f[4], j[4][4];
};
void ts_couette_rate(const struct ts_couette *c, const double z[4], struct ts_couette_rate *out);

/* Residuals of both conditions at a wall, and their derivatives with the unknowns there. */
void ts_couette_wall(const struct ts_couette *c, int wall, const double z[4], double residual[2],
		     double j[2][4]);

/* Middle of an interval by Hermite's cubic. */
void ts_couette_middle(double width, const double z0[4], const double f0[4], const double z1[4],
		       const double f1[4], double out[4]);

static inline double ts_couette_width(const struct ts_couette *c, int interval)
{
	return c->gap / c->parts[interval];
}

/* Makes n equal intervals; nodes are kept. */
enum ts_status ts_couette_room(struct ts_couette *c, int n);
/* A uniform solid fraction, with the shear stress that balances the energy of the whole gap. */
void ts_couette_guess(struct ts_couette *c);
/* Newton's method from the present nodes. TS_PHYSICS: it does not converge. */
enum ts_status ts_couette_newton(struct ts_couette *c);

/* ---- sheared film */

/* Find the solid fraction or the gap at which the speed is `target` times sqrt(N/rho), and solve there. Without a
 * solution `solutions` is 0; *least is the smallest solid fraction tried, `speed` the speed/sqrt(N/rho) in the narrowest and
 * the widest gap that have a solution, the one by which it fails being that of the couette; NaN: none has. Returns TS_OK, TS_NOMEM, or TS_PHYSICS: the equations could not be solved. */
enum ts_status ts_sheared_film_find_solids(struct ts_sheared_film *f, double target, double *least);
enum ts_status ts_sheared_film_find_gap(struct ts_sheared_film *f, double target, double speed[2]);

#endif
