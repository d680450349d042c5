/* Steady shear flow of grains between two parallel rough walls, by kinetic theory, without gravity.
 *
 * Lengths in grain diameters d, velocities in sqrt(N/rho), stresses in the normal stress N; rho is the density of a
 * grain. Shear and normal stress do not vary with y, so with s = S/N, T = 1/g1(nu) and g1 .. g5 of granular_gas.h
 *
 *   |u'| = s a,   a = sqrt(g1)/g2               momentum
 *   q = h nu',    h = g3 g1'/g1^2.5 - g4/g1^1.5  flux of fluctuation energy
 *   q' = s |u'| - b,   b = g5/g1^1.5            balance of fluctuation energy
 *
 * Walls are made of spheres at which grains bounce, smooth and nearly elastic (J. T. Jenkins, M. W. Richman, J. Fluid
 * Mech. 171 (1986) 53; M. W. Richman, Acta Mech. 75 (1988) 227; leading order). With their half angle theta, between
 * the normal of the wall and the line to the sphere beyond which a grain cannot reach:
 *
 *   slip           u_s = sqrt(pi/2) f sqrt(T) s,   1/f = (2/3) (2 (1 - cos theta)/sin^2 theta - cos theta)
 *   dissipation    D = sqrt(2/pi) (1 - e_w) 2 (1 - cos theta)/sin^2 theta sqrt(T)
 *   energy         q into the flow = s u_s - D
 *
 * Unknown are nu(y), q(y) and s. Nothing else has a unit of time: the speed of the walls in these units is a result,
 * and the load for a given speed, or the reverse, follows by scaling.
 *
 * Method: collocation of fourth order (Simpson's rule on Hermite's cubics; R. D. Russell, L. F. Shampine, Numer. Math. 19
 * (1972) 1; J. Kierzenka, L. F. Shampine, ACM TOMS 27 (2001) 299) on equal intervals, Newton's method, and continuation
 * in the gap from a narrow one, where nu is uniform. Where the slope of g0 has a step, nu' has one: the interval around that place
 * has an error of first order, so it is made shorter than the others. Balances of energy hold to round-off on each mesh. */
#ifndef TS_KINETIC_GRANULAR_COUETTE_H
#define TS_KINETIC_GRANULAR_COUETTE_H

#include <stddef.h>

#include "base/status.h"
#include "kinetic/granular_gas.h"

struct ts_bumpy_wall {
	double half_angle;  /* theta, > 0 to pi/2 */
	double restitution; /* e_w */
};

struct ts_couette {
	/* given */
	struct ts_gas gas;
	struct ts_bumpy_wall wall[2]; /* [0] at y = 0 moves, [1] at y = gap is at rest */
	double gap;
	double solids; /* mean solid fraction */

	/* the solution on n intervals; zero-initialise, release by ts_couette_release */
	int n;
	double *parts;	   /* [n] the gap over the width of each interval */
	int equal;	   /* number of equal intervals, some of which have been halved, once or more */
	double (*node)[4]; /* [n + 1]; x = ln(nu/(nu_limit - nu)), q, integral of nu from 0 to y, s */
	size_t capacity;
	int iterations; /* of Newton's method, since ts_couette_solve began */
	double reached; /* the widest gap at which a solution was found */
	double error;	/* relative, of the figures, from the mesh of half as many intervals */

	/* internal */
	struct ts_couette_rate *rate;
	double *matrix, *step;
	size_t rate_capacity, matrix_capacity, step_capacity, parts_capacity;
};

struct ts_couette_figures {
	double speed;	    /* of the moving wall */
	double traction;    /* s */
	double slip[2];	    /* at the walls */
	double centre[2];   /* nu and T at half the gap */
	double most;	    /* largest nu at a node */
	double coldest;	    /* smallest T at a node by the largest */
	double dissipation; /* by collisions of grains, over the gap */
	double wall_loss[2];
	double imbalance; /* |work of the walls - all dissipation|/work */
};

/* Number of intervals to begin with so that profiles of so many points are on nodes: a multiple of points - 1 that is
 * fine enough for Newton's method. */
int ts_couette_intervals(double gap, int points);

/* Solves on meshes of `intervals` times 1, 2, 4 ... intervals until the error is below `tolerance`. Returns TS_OK,
 * TS_NOMEM, TS_PHYSICS if no solution was found, or TS_RANGE if the error stays above it: c->error. */
enum ts_status ts_couette_solve(struct ts_couette *c, int intervals, double tolerance);

/* The same on one mesh of `intervals`; from the present nodes, of as many intervals, if `warm`. */
enum ts_status ts_couette_solve_mesh(struct ts_couette *c, int intervals, bool warm);

/* Number of different solutions for the same input that Newton's method reaches from profiles of several shapes: dense
 * in the centre, at the walls, at either wall. On a mesh of `intervals`; c keeps its own solution. Returns TS_OK or
 * TS_NOMEM. */
enum ts_status ts_couette_count(const struct ts_couette *c, int intervals, int *count);

void ts_couette_figures(const struct ts_couette *c, struct ts_couette_figures *out);
/* Solid fraction, velocity and T at `points` equidistant places from y = 0 to the gap; (points - 1) divides n. */
void ts_couette_profile(const struct ts_couette *c, int points, double (*out)[3]);
void ts_couette_release(struct ts_couette *c);

/* Functions of a wall: u_s/(sqrt(T) s) and D/sqrt(T). */
double ts_bumpy_wall_slip(const struct ts_bumpy_wall *wall);
double ts_bumpy_wall_loss(const struct ts_bumpy_wall *wall);

#endif
