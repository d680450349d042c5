/* Forces in a collision of impact/exact_collision.h as functions of its state. */
#ifndef TS_IMPACT_COLLISION_FORCES_H
#define TS_IMPACT_COLLISION_FORCES_H

#include <math.h>

#include "law/granular_force.h"
#include "math/prince_dormand.h"

/* The state, with d tangential dimensions: z, q', t; then d numbers each of v, w, xi, shift; slip path, work. Unless
 * the contact sticks, xi is replaced by the angle of e in two dimensions, by e = +-1 in one. */
enum { TS_AT_Z, TS_AT_U, TS_AT_TIME, TS_AT_TANGENTIAL, TS_COLLIDING_MOST = TS_PRINCE_DORMAND_MOST };
enum ts_friction_mode { TS_STICK, TS_SLIDE, TS_FOLLOW };

/* The sphere in the collision: its law, the present mode, scales of the numbers of the state. */
struct ts_colliding {
	const struct ts_granular_pair *law;
	struct ts_granular_model model;
	struct ts_touch *touch; /* overlap, distance and speed are set by each evaluation */
	double inertia;		/* I */
	int power;		/* p: q = z^p */
	int d;			/* tangential dimensions */
	double kappa, damping;	/* k ~ q^kappa, gamma ~ q^damping */
	enum ts_friction_mode mode;
	double sign; /* of F_n */
	double scale[TS_COLLIDING_MOST];
	double elongation;  /* scale of xi */
	double least_limit; /* of friction, in the rate at which its direction turns */
	double peak_force, peak_overlap;
	double slips; /* sign of the slip along the axis before it reverses */
	/* axes of the tangential dimensions, and the initial v and w along them */
	double axis[2][3];
};

/* How s.e - r' turns: its rate if the contact slides, and if it sticks. */
struct ts_friction_turn {
	double slides, sticks;
};

/* Forces at one moment. */
struct ts_colliding_forces {
	struct ts_normal n;
	double q, u, rate; /* rate: dt/dsigma */
	double lever, arm;
	double slip[2], force[2], xi[2]; /* force: F_t; xi: the derivative in time */
	struct ts_friction_turn turn;	 /* TS_FOLLOW */
};

/* r = mu F_n/k_t and its rates, with F_n/k_t = K q + G q^b u, b = damping - kappa: K = k/k_t and G q^b = gamma/k_t. */
struct ts_friction_limit {
	double force; /* k_t r */
	double rate;  /* k_t r' */
	double bend;  /* k_t r'' */
};

static inline double ts_colliding_length(const double a[2], int d)
{
	return d == 2 ? sqrt(a[0] * a[0] + a[1] * a[1]) : fabs(a[0]);
}

/* e, unless the contact sticks; x: that part of the state. */
static inline void ts_colliding_direction(int d, const double *x, double e[2])
{
	e[0] = d == 2 ? cos(x[0]) : x[0];
	e[1] = d == 2 ? sin(x[0]) : 0;
}

/* The overlap q = z^p. */
double ts_colliding_overlap(const struct ts_colliding *o, double z);
void ts_colliding_evaluate(const struct ts_colliding *o, const double *y, struct ts_colliding_forces *m);
/* dy/dsigma; context: struct ts_colliding. */
void ts_colliding_derivative(const double *y, double *dy, const void *context);
/* dF_n/dt of F_n = k q + gamma u: (1 + kappa) k u + gamma (damping u^2/q + u'), u' = -F_n/m. */
double ts_colliding_force_rate(const struct ts_colliding *o, const struct ts_colliding_forces *m);
struct ts_friction_limit ts_colliding_limit(const struct ts_colliding *o,
					    const struct ts_colliding_forces *m);
/* While k_t |xi| = mu |F_n|: s' = F_t (1/m + l a/I) + l' w, F_t = -mu |F_n| e - alpha gamma_t s,
 * s.e' = |s - (s.e) e|^2/r. x: of the state. */
struct ts_friction_turn ts_colliding_turn(const struct ts_colliding *o, const double *x, const double e[2],
					  const struct ts_colliding_forces *m);

#endif
