/* Lubrication: the force and torque of a thin layer of viscous fluid between two spheres, or a sphere and a plane,
 * whose surfaces move relative to each other. The leading terms as the gap h closes, without inertia: of the normal
 * motion 1/h (not its correction in ln h, of X^A), of all others ln h.
 *
 * Notation: a, b the radii (b infinite: a plane), R = ab/(a + b), mu the dynamic viscosity, n the unit vector to
 * body a from body b, v the velocity of a minus that of b, omega_a and omega_b the angular velocities. Normal to the
 * surfaces, the squeeze flow gives
 *
 *   F = -6 pi mu R^2/h v_n.
 *
 * Along the surfaces the motion is described by two vectors that vanish where both bodies move as one rigid body,
 *
 *   S = v_t - (a' omega_a + b' omega_b) x n,  W = -(omega_a - omega_b) x n,  a' = a + h/2, b' = b + h/2,
 *
 * the slip in the middle of the gap and the rolling. With L = ln(min(a, b)/h), 0 where this is negative,
 *
 *   P = A S + B W,  Q = B S + C W,  F = -P,  T = n x (a' P + Q),
 *   A = 8/5 pi mu R L (2 - 3 ab/(a + b)^2),  B = 12/5 pi mu R^2 L (a - b)/(a + b),  C = 24/5 pi mu R^3 L.
 *
 * A, B and C are all terms in ln(h) of the resistance functions Y^A, Y^B and Y^C of two spheres (D. J. Jeffrey, Y. Onishi,
 * J. Fluid Mech. 139 (1984) 261; S. Kim, S. J. Karrila, Microhydrodynamics, 1991, ch. 11) and, for a plane, those of
 * A. J. Goldman, R. G. Cox, H. Brenner, Chem. Eng. Sci. 22 (1967) 637: F = -6 pi mu a (8/15 L) U, T = 8 pi mu a^2
 * (1/10 L) U of a translating sphere, and F = 6 pi mu a^2 (2/15 L) omega, T = -8 pi mu a^3 (2/5 L) omega of a rotating
 * one. Forces are opposite, and torques are balanced about any point, since a' + b' is the distance of the centres.
 * The relative rotation about n has no such term: that of X^C vanishes with h. */
#ifndef TS_LAW_LUBRICATION_H
#define TS_LAW_LUBRICATION_H

#include <math.h>

#include "math/constants.h"
#include "math/vec3.h"

struct ts_lubrication {
	double viscosity;
	double inner; /* smaller gaps count as this one, length: the roughness */
	double outer; /* no force from this gap on, length */
};

/* This body is a, the other b. */
struct ts_lubrication_pair {
	double radius[2]; /* of this; of the other, infinite: a plane */
	double gap;	  /* between the surfaces, length; < 0: overlap */
	double n[3];	  /* unit vector from the other one */
	double v[3];	  /* velocity of the centre of this minus that of the other one, or of the plane */
	double omega[2][3];
};

/* Force over velocity: normal, and A; B and C as above; the lever arm a'. */
struct ts_lubrication_resistance {
	double normal, slip, mixed, rolling, arm;
};

static inline double ts_lubrication_radius(double a, double b)
{
	return isinf(b) ? a : a * b / (a + b);
}

static inline void ts_lubrication_resistance(const struct ts_lubrication *l, const double radius[2],
					     double gap, struct ts_lubrication_resistance *out)
{
	double a = radius[0], b = radius[1], h = fmax(gap, l->inner), r = ts_lubrication_radius(a, b);
	double product = isinf(b) ? 0 : a * b / ((a + b) * (a + b)),
	       difference = isinf(b) ? -1 : (a - b) / (a + b);
	double scale = gap < l->outer ? TS_PI * l->viscosity : 0;
	double along = scale * fmax(log(fmin(a, b) / h), 0);

	out->normal = 6 * scale * r * r / h;
	out->slip = 1.6 * along * r * (2 - 3 * product);
	out->mixed = 2.4 * along * r * r * difference;
	out->rolling = 4.8 * along * r * r * r;
	out->arm = a + 0.5 * gap;
}

/* S and W. The other lever arm: of a plane it has no effect, since a plane does not rotate. */
static inline void ts_lubrication_motion(const struct ts_lubrication_pair *c, double normal_velocity,
					 double slip[3], double rolling[3])
{
	double arm[2] = { c->radius[0] + 0.5 * c->gap,
			  isinf(c->radius[1]) ? 0 : c->radius[1] + 0.5 * c->gap };
	double turn[3], relative[3], across[3];

	for (int d = 0; d < 3; d++)
		turn[d] = arm[0] * c->omega[0][d] + arm[1] * c->omega[1][d];
	ts_cross(turn, c->n, across);
	ts_sub(c->v, across, slip);
	ts_axpy(-normal_velocity, c->n, slip);
	ts_sub(c->omega[1], c->omega[0], relative);
	ts_cross(relative, c->n, rolling);
}

/* Adds the force and torque on this body. Exchanged bodies get the opposite force, bit for bit. */
static inline void ts_lubrication_add(const struct ts_lubrication *l, const struct ts_lubrication_pair *c,
				      double force[3], double torque[3])
{
	struct ts_lubrication_resistance k;
	double vn = ts_dot(c->v, c->n), s[3], w[3], couple[3], turning[3];

	ts_lubrication_resistance(l, c->radius, c->gap, &k);
	ts_lubrication_motion(c, vn, s, w);
	for (int d = 0; d < 3; d++) {
		double p = k.slip * s[d] + k.mixed * w[d];

		force[d] -= k.normal * vn * c->n[d] + p;
		couple[d] = k.arm * p + k.mixed * s[d] + k.rolling * w[d];
	}
	ts_cross(c->n, couple, turning);
	ts_add(torque, turning, torque);
}

/* Upper bound of the rate [1/time] at which this layer slows down a body of mass 1/imass and moment of inertia
 * 1/iinertia; other_imass: that of the other body, 0 if it does not move. The sum over the layers of a body, at most
 * over all bodies, bounds the largest rate of the whole system: the dissipation of a layer is at most 1 + t times
 * that with the other body at rest, plus 1 + 1/t times that with this body at rest, here t = other_imass/imass. For
 * the normal motion of two spheres, and of a sphere at a plane, the bound is the exact rate. */
static inline double ts_lubrication_rate(const struct ts_lubrication *l, const double radius[2], double gap,
					 double imass, double iinertia, double other_imass)
{
	struct ts_lubrication_resistance k;
	double turning;

	ts_lubrication_resistance(l, radius, gap, &k);
	turning = k.arm * (k.arm * k.slip + 2 * k.mixed) + k.rolling;
	return (1 + other_imass / imass) * fmax(k.normal * imass, k.slip * imass + turning * iinertia);
}

#endif
