/* An elastic element between two bodies that carries normal force, shear force, bending moment and torque.
 *
 * Each body carries a frame whose first axis is the direction of the bond when it was created. Let n be the
 * unit vector from body a to body b, r their distance, l the distance at creation, t_a and t_b the first
 * axes of the two frames, c l the distance of a from the section where the bond transmits its moments, and
 * phi the rotation vector from frame a to frame b (bending phi_y, phi_z; twist phi_x). The energy
 *
 *   E = k_n (r - l)^2/2 + k_s l^2 |m_s|^2/2 + k_b (phi_y^2 + phi_z^2)/2 + k_t phi_x^2/2,
 *   m = c t_a + (1 - c) t_b,   m_s = m - (m.n) n
 *
 * has as derivatives all forces and moments. l m_s is the displacement of the two sides of the section across
 * the bond. This is the integral of the increments of D. O. Potyondy and P. A. Cundall (Int. J. Rock Mech. Min.
 * Sci. 41 (2004) 1329, eqs. 11-14) in the frame that rotates with the bond, without their error of the order of
 * the rotation in a step: a rigid motion of both bodies gives no force, whatever its size, and forces have a
 * potential. With c = 1/2 and the constants of law/beam.h it is the beam element of Timoshenko. Momentum and
 * angular momentum are conserved to rounding: d x F_b + T_a + T_b = 0.
 *
 * The functions have no branches, for vectorised loops. */
#ifndef TS_LAW_BOND_ELEMENT_H
#define TS_LAW_BOND_ELEMENT_H

#include <math.h>
#include <stdbool.h>

#include "base/inline.h"

struct ts_xyz {
	double x, y, z;
};

/* Unit quaternion. */
struct ts_wxyz {
	double w, x, y, z;
};

/* The four motions that a bond resists. */
enum { TS_BOND_NORMAL, TS_BOND_SHEAR, TS_BOND_BENDING, TS_BOND_TWIST, TS_BOND_MODES };

/* Constants of one bond. */
struct ts_bond_element {
	double length, fraction; /* l; c */
	double k[TS_BOND_MODES]; /* force/length, force/length, moment, moment */
	double c[TS_BOND_MODES]; /* damping: the same times time */
	/* the largest stresses are N per_area + (M + V lever) per_moment and V per_area + |M_t| per_torque */
	double per_area, per_moment, per_torque;
	double lever;			    /* from the section to where the largest moment acts, length */
	double tension, shear, compression; /* strengths, stress; INFINITY: never breaks */
	/* law/bond_softening.h: the stress where softening begins, INFINITY: never; rho; and the part of rho by which
	 * shear makes the crack grow, 0: it does not */
	double onset, rupture, shear_rupture;
	double friction; /* by which the pressure increases the shear strength */
};

/* State of the two bodies. */
struct ts_bond_ends {
	struct ts_xyz d;	/* from a to b */
	struct ts_wxyz q[2];	/* the frames that the bodies carry */
	struct ts_xyz v;	/* velocity of b minus that of a */
	struct ts_xyz omega[2]; /* angular velocities */
};

struct ts_bond_answer {
	struct ts_xyz force;	 /* on b; that on a is the opposite */
	struct ts_xyz torque[2]; /* on a, on b */
	/* without damping: normal force (> 0 tension), shear force, bending moment, torque (with sign) */
	double load[TS_BOND_MODES];
	double acting; /* by which these are multiplied: 1, less if the law smooths its forces */
	double axial;  /* normal force with damping */
	double tension, shear, compression; /* largest stresses of the section, without damping */
	double cosine;			    /* of half the angle |phi| */
	double smoothed; /* part of the elastic energy that a law which smooths its forces takes away */
};

TS_INLINE struct ts_xyz ts_xyz_cross(struct ts_xyz a, struct ts_xyz b)
{
	return (struct ts_xyz){ a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x };
}

TS_INLINE double ts_xyz_dot(struct ts_xyz a, struct ts_xyz b)
{
	return a.x * b.x + a.y * b.y + a.z * b.z;
}

/* a + s b */
TS_INLINE struct ts_xyz ts_xyz_add(struct ts_xyz a, double s, struct ts_xyz b)
{
	return (struct ts_xyz){ a.x + s * b.x, a.y + s * b.y, a.z + s * b.z };
}

TS_INLINE struct ts_xyz ts_xyz_scale(double s, struct ts_xyz a)
{
	return (struct ts_xyz){ s * a.x, s * a.y, s * a.z };
}

/* Rotation b, followed by a. */
TS_INLINE struct ts_wxyz ts_wxyz_product(struct ts_wxyz a, struct ts_wxyz b)
{
	return (struct ts_wxyz){ a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z,
				 a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
				 a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
				 a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w };
}

/* Rotation by the vector a, small or not. */
static inline struct ts_wxyz ts_wxyz_of_vector(struct ts_xyz a)
{
	const double angle = sqrt(ts_xyz_dot(a, a)), s = angle > 0 ? sin(0.5 * angle) / angle : 0.5;

	return (struct ts_wxyz){ cos(0.5 * angle), s * a.x, s * a.y, s * a.z };
}

/* The rotation from b to a, seen from b: conj(b) a. */
TS_INLINE struct ts_wxyz ts_wxyz_from(struct ts_wxyz b, struct ts_wxyz a)
{
	return ts_wxyz_product((struct ts_wxyz){ b.w, -b.x, -b.y, -b.z }, a);
}

/* First axis of the frame. */
TS_INLINE struct ts_xyz ts_wxyz_axis(struct ts_wxyz q)
{
	return (struct ts_xyz){ q.w * q.w + q.x * q.x - q.y * q.y - q.z * q.z, 2 * (q.x * q.y + q.w * q.z),
				2 * (q.x * q.z - q.w * q.y) };
}

TS_INLINE struct ts_xyz ts_wxyz_rotate(struct ts_wxyz q, struct ts_xyz a)
{
	const struct ts_xyz u = { q.x, q.y, q.z };
	const struct ts_xyz t = ts_xyz_scale(2, ts_xyz_cross(u, a));

	return ts_xyz_add(ts_xyz_add(a, q.w, t), 1, ts_xyz_cross(u, t));
}

/* (1 - atan(t)/t)/z with z = t^2 in 0 .. 0.18, by a polynomial that is Chebyshev's interpolation; error
 * 2e-18. */
TS_INLINE double ts_bond_arctangent(double z)
{
	double p = -0.015622700298223299379;

	p = p * z + 0.033957657814623253676;
	p = p * z - 0.045271750811398343843;
	p = p * z + 0.052249684158967799031;
	p = p * z - 0.058781655221706713816;
	p = p * z + 0.066663568105802673055;
	p = p * z - 0.076922924884927850154;
	p = p * z + 0.09090908615635290031;
	p = p * z - 0.11111111102313344563;
	p = p * z + 0.14285714285629909758;
	p = p * z - 0.19999999999999682305;
	return p * z + 0.33333333333333333135;
}

/* The largest angle |phi| for which the functions are accurate: 90 degrees; cos(|phi|/2) must be above this. */
#define TS_BOND_TURN 0.70710678118654752

/* Moments of bending and twist on b, in frame a. With h = |phi|/2, u = sin(h) phi/|phi| and the derivative
 * of phi by a rotation of b, 1 - phi x/2 + (1 - h cot h)/|phi|^2 (phi x)^2, whose transpose multiplies the
 * derivative of E. z = tan^2(h/2). */
TS_INLINE struct ts_xyz ts_bond_moment(const struct ts_bond_element *e, struct ts_wxyz p,
				       struct ts_bond_answer *out)
{
	const double sign = p.w < 0 ? -1 : 1, w = sign * p.w;
	const struct ts_xyz u = { sign * p.x, sign * p.y, sign * p.z };
	const double s2 = ts_xyz_dot(u, u), o = 1 / (1 + w), z = s2 * o * o, b = ts_bond_arctangent(z);
	const double a = 1 - z * b, g = (a + b) * o * o;
	const struct ts_xyz phi = ts_xyz_scale(4 * a * o, u);
	const double twist = (e->k[TS_BOND_TWIST] - e->k[TS_BOND_BENDING]) * phi.x,
		     kb = e->k[TS_BOND_BENDING];

	out->cosine = w;
	out->load[TS_BOND_BENDING] = kb * sqrt(phi.y * phi.y + phi.z * phi.z);
	out->load[TS_BOND_TWIST] = e->k[TS_BOND_TWIST] * phi.x;
	return (struct ts_xyz){ -(kb * phi.x + twist * (1 + g * (u.x * u.x - s2))),
				-(kb * phi.y + twist * (0.5 * phi.z + g * u.x * u.y)),
				-(kb * phi.z + twist * (g * u.x * u.z - 0.5 * phi.y)) };
}

TS_INLINE void ts_bond_elastic(const struct ts_bond_element *e, const struct ts_bond_ends *s,
			       struct ts_bond_answer *out)
{
	const double r2 = ts_xyz_dot(s->d, s->d), r = sqrt(r2), inverse = r > 0 ? 1 / r : 0;
	const struct ts_xyz n = ts_xyz_scale(inverse, s->d);
	const struct ts_xyz ta = ts_wxyz_axis(s->q[0]), tb = ts_wxyz_axis(s->q[1]);
	const struct ts_xyz m = ts_xyz_add(ts_xyz_scale(e->fraction, ta), 1 - e->fraction, tb);
	const double along = ts_xyz_dot(m, n), ks = e->k[TS_BOND_SHEAR] * e->length;
	const struct ts_xyz across = ts_xyz_add(m, -along, n);
	const double energy = ks * e->length, pull = e->k[TS_BOND_NORMAL] * (r - e->length);
	const struct ts_xyz bend =
		ts_wxyz_rotate(s->q[0], ts_bond_moment(e, ts_wxyz_from(s->q[0], s->q[1]), out));

	out->force = ts_xyz_add(ts_xyz_scale(-pull, n), energy * along * inverse, across);
	out->torque[0] = ts_xyz_add(ts_xyz_scale(-energy * e->fraction, ts_xyz_cross(ta, across)), -1, bend);
	out->torque[1] = ts_xyz_add(bend, -energy * (1 - e->fraction), ts_xyz_cross(tb, across));
	out->load[TS_BOND_NORMAL] = out->axial = pull;
	out->load[TS_BOND_SHEAR] = ks * sqrt(ts_xyz_dot(across, across));
	out->acting = 1;
	out->smoothed = 0;
}

/* Dashpots parallel to the four springs. */
TS_INLINE void ts_bond_viscous(const struct ts_bond_element *e, const struct ts_bond_ends *s,
			       struct ts_bond_answer *out)
{
	const double r2 = ts_xyz_dot(s->d, s->d), inverse = r2 > 0 ? 1 / sqrt(r2) : 0;
	const struct ts_xyz n = ts_xyz_scale(inverse, s->d);
	const struct ts_xyz mean =
		ts_xyz_add(ts_xyz_scale(e->fraction, s->omega[0]), 1 - e->fraction, s->omega[1]);
	const struct ts_xyz turn = ts_xyz_add(s->omega[1], -1, s->omega[0]);
	const double rate = ts_xyz_dot(s->v, n), pull = e->c[TS_BOND_NORMAL] * rate;
	const struct ts_xyz slip = ts_xyz_add(ts_xyz_add(s->v, -rate, n), -1, ts_xyz_cross(mean, s->d));
	const struct ts_xyz shear = ts_xyz_scale(-e->c[TS_BOND_SHEAR], slip);
	const struct ts_xyz arm = ts_xyz_cross(s->d, shear);
	const struct ts_xyz bend =
		ts_xyz_add(ts_xyz_scale(-e->c[TS_BOND_BENDING], turn),
			   (e->c[TS_BOND_BENDING] - e->c[TS_BOND_TWIST]) * ts_xyz_dot(turn, n), n);

	out->force = ts_xyz_add(ts_xyz_add(out->force, 1, shear), -pull, n);
	out->torque[0] = ts_xyz_add(ts_xyz_add(out->torque[0], -e->fraction, arm), -1, bend);
	out->torque[1] = ts_xyz_add(ts_xyz_add(out->torque[1], e->fraction - 1, arm), 1, bend);
	out->axial += pull;
}

/* The largest stresses of the section, Potyondy & Cundall eqs. 15, 16, with the share beta of the moments of
 * D. O. Potyondy, 45th US Rock Mechanics Symposium (2011), ARMA 11-346, in per_moment and per_torque. */
TS_INLINE void ts_bond_stress(const struct ts_bond_element *e, struct ts_bond_answer *out)
{
	const double normal = out->load[TS_BOND_NORMAL] * e->per_area;
	const double bending =
		(out->load[TS_BOND_BENDING] + out->load[TS_BOND_SHEAR] * e->lever) * e->per_moment;

	out->tension = bending + normal;
	out->compression = bending - normal;
	out->shear = out->load[TS_BOND_SHEAR] * e->per_area + fabs(out->load[TS_BOND_TWIST]) * e->per_torque;
}

TS_INLINE bool ts_bond_holds(const struct ts_bond_element *e, const struct ts_bond_answer *s)
{
	return !(s->tension >= e->tension) & !(s->shear >= e->shear) & !(s->compression >= e->compression) &
	       (s->cosine > TS_BOND_TURN);
}

/* Elastic energy of each mode. */
static inline void ts_bond_energies(const struct ts_bond_element *e, const struct ts_bond_answer *s,
				    double energy[TS_BOND_MODES])
{
	for (int k = 0; k < TS_BOND_MODES; k++)
		energy[k] = e->k[k] > 0 ? 0.5 * s->load[k] * s->load[k] / e->k[k] * (1 - s->smoothed) : 0;
}

/* Squared angular frequency of the fastest vibration of the two bodies, with dashpots that count as
 * stiffness c times `rate` (limits/lanczos.h: 2/dt). */
static inline double ts_bond_frequency2(const struct ts_bond_element *e, const double inverse_mass[2],
					const double inverse_inertia[2], double rate)
{
	const double arm[2] = { e->fraction * e->length, (1 - e->fraction) * e->length };
	const double mass = inverse_mass[0] + inverse_mass[1],
		     inertia = inverse_inertia[0] + inverse_inertia[1];
	double k[TS_BOND_MODES], slip, bend, cross;

	for (int m = 0; m < TS_BOND_MODES; m++)
		k[m] = e->k[m] + e->c[m] * rate;
	/* shear and bending are coupled: 2 x 2 matrix */
	slip = k[TS_BOND_SHEAR] *
	       (mass + arm[0] * arm[0] * inverse_inertia[0] + arm[1] * arm[1] * inverse_inertia[1]);
	bend = k[TS_BOND_BENDING] * inertia;
	cross = k[TS_BOND_SHEAR] * k[TS_BOND_BENDING] *
		pow(arm[0] * inverse_inertia[0] - arm[1] * inverse_inertia[1], 2);
	return fmax(fmax(k[TS_BOND_NORMAL] * mass, k[TS_BOND_TWIST] * inertia),
		    0.5 * (slip + bend + sqrt((slip - bend) * (slip - bend) + 4 * cross)));
}

/* Largest stable time step of one bond for velocity Verlet. */
static inline double ts_bond_element_limit(const struct ts_bond_element *e, const double inverse_mass[2],
					   const double inverse_inertia[2])
{
	double h = 2 / sqrt(ts_bond_frequency2(e, inverse_mass, inverse_inertia, 0)), before = INFINITY;

	/* h^2 (k + 2 c/h) <= 4: h converges from above, the distance in log h at least halves each time; without
	 * damping the first h is the limit */
	for (int n = 0; n < 60 && h > 0 && h < before && isfinite(h); n++) {
		before = h;
		h = 2 / sqrt(ts_bond_frequency2(e, inverse_mass, inverse_inertia, 2 / h));
	}
	return h;
}

#endif
