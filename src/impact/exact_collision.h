/* The whole collision of one sphere with a flat surface, from touch to separation, under the contact law of the wall:
 *
 *   m q'' = -F_n(q, q'),  m v' = F_t,  I w' = a F_t,  F_t by the slip s = v + l w and the tangential spring xi
 *
 * with the overlap q, the velocity v of the centre along the surface, w = n x omega, and the lever arms l and a of slip
 * and torque (R - q/2, or R). No other force acts on the sphere meanwhile, and the surface does not turn. All forces
 * are those of ts_normal_force and of law/tangential.h in the limit of a vanishing time step:
 *
 *   stick   xi' = s, F_t = -k_t xi - gamma_t s, as long as k_t |xi| <= mu |F_n|
 *   slide   k_t |xi| = mu |F_n| and F_t = -mu |F_n| e, e = xi/|xi|, as long as the spring would grow beyond that:
 *           s.e > r', r = mu |F_n|/k_t; e turns by e' = (s - (s.e) e)/r
 *   follow  where stick would end at once in slide and slide in stick, small steps alternate between them; their limit
 *           has s.e = r': F_t = -mu |F_n| e - alpha gamma_t s with the alpha in (0, 1) for which (s.e)' = r''
 *           (A. F. Filippov, Differential Equations with Discontinuous Righthand Sides, Kluwer 1988)
 *   no_history: F_t = -min(gamma_t, mu |F_n|/|s|) s
 *
 * Integrated by the Runge-Kutta scheme of order 8 of Prince and Dormand (math/prince_dormand.h) with a step that follows
 * the estimated error. Changes between stick and slide, the end of the contact and the maxima are located within a step by
 * regula falsi; so is a change that is undone within the same step. The forces of Hertz' law are roots of the overlap,
 * which no scheme of high order can follow through q = 0: so q = z^p, and the independent variable is sigma,
 * dt = z^(p-1) dsigma. z' = q'/p, and with p = 4 (damping ~ q^(1/4)), 2 (damping ~ q^(1/2), or none) all forces are
 * polynomials in z; p = 1 for linear springs.
 *
 * A law that limits the normal force to F_n >= 0 ends before the surfaces part: the sphere then flies freely until
 * they do, and this is part of the collision.
 *
 * When a force that is not limited begins to pull, both stick and slide may be possible; small steps take either by
 * chance, here the contact sticks. */
#ifndef TS_WALL_EXACT_COLLISION_H
#define TS_WALL_EXACT_COLLISION_H

#include "law/granular.h"
#include "wall/contact_node.h"

/* Why collisions under this law are not computed; NULL: they are. */
const char *ts_collision_unsupported(const struct ts_granular_model *model);

struct ts_collision {
	const struct ts_granular_model *model;
	const struct ts_granular_pair *law;
	double mass, radius, r_eff; /* r_eff: R*, see ts_wall_effective_radius */
	double inertia;		    /* I/(m R^2) */
	double n[3];		    /* unit vector from the surface to the sphere */
	double velocity
		[3]; /* of the centre relative to the surface at the contact point, at touch; v.n < 0 */
	double omega[3];
	double longest; /* a collision that lasts longer is given up; may be infinite */
	/* If the surfaces part, the nodes of Gauss' quadrature in each step of the integration are appended, at states of
	 * the same accuracy as the result. Changes between stick and slide and a reversal of the slip along a line lie
	 * between steps, so that integrands may have kinks there. NULL: not wanted */
	struct ts_contact_nodes *nodes;
};

struct ts_collision_result {
	double velocity[3], omega[3];	 /* after the collision */
	double shift[3];		 /* displacement of the centre along the surface, length */
	double duration;		 /* until the surfaces part, time */
	double peak_force, peak_overlap; /* largest normal force, largest overlap */
	double impulse;			 /* integral of the normal force over time */
	double slip;			 /* path of the contact point along the surface, length */
	double work; /* of the tangential force on the sliding surfaces, energy; > 0: lost */
};

enum ts_collision_end {
	TS_COLLISION_PARTS,
	TS_COLLISION_STAYS, /* longer than `longest`: the result is not set */
	TS_COLLISION_FAILS, /* the integration does not converge: the result is not set */
	TS_COLLISION_NOMEM  /* for the nodes: the result is not set */
};
enum ts_collision_end ts_collision_compute(const struct ts_collision *c, struct ts_collision_result *out);

#endif
