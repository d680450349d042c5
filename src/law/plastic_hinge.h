/* Yield of an element of law/bond_element.h, elastic and ideally plastic: it flows in plastic hinges at its two ends
 * where the bending moment would exceed M_p, twists where the torque would exceed T_p, and lengthens or shortens
 * where the normal force would exceed N_p. For a solid circular section that yields at the stress s (W. Prager, P. G.
 * Hodge, Theory of Perfectly Plastic Solids, Wiley 1951)
 *
 *   N_p = pi R^2 s,   M_p = 4/3 R^3 s,   T_p = 2/3 pi R^3 s/sqrt(3).
 *
 * Each limit holds for itself: forces and moments that act together yield later than in a solid. */
#ifndef TS_LAW_PLASTIC_HINGE_H
#define TS_LAW_PLASTIC_HINGE_H

#include "law/bond_element.h"
#include "math/constants.h"

/* Limits of normal force, bending moment and torque; INFINITY: elastic. */
struct ts_plastic_section {
	double force, moment, torque;
};

/* The three places where an element turns: the hinges at its ends, and the twist, a half of it at each end. */
enum { TS_PLASTIC_TWIST = 2, TS_PLASTIC_PLACES };

/* What has flowed: the rotations of the frames in space, that of the twist from end a to end b, and the work that was
 * lost. */
struct ts_plastic_flow {
	struct ts_xyz turn[TS_PLASTIC_PLACES];
	double work;
};

static inline struct ts_plastic_section ts_plastic_circle(double radius, double yield)
{
	const double r3 = radius * radius * radius;

	return (struct ts_plastic_section){ .force = TS_PI * radius * radius * yield,
					    .moment = 4.0 / 3 * r3 * yield,
					    .torque = 2.0 / 3 * TS_PI * r3 * yield / sqrt(3) };
}

/* The moments at the three places, as they act on the bodies: perpendicular to the element at its ends, and about it. */
static inline void ts_plastic_moments(const struct ts_bond_element *e, const struct ts_bond_ends *s,
				      struct ts_xyz out[TS_PLASTIC_PLACES])
{
	const struct ts_xyz n = ts_xyz_scale(1 / sqrt(ts_xyz_dot(s->d, s->d)), s->d);
	struct ts_bond_answer a;

	ts_bond_elastic(e, s, &a);
	for (int p = 0; p < 2; p++)
		out[p] = ts_xyz_add(a.torque[p], -ts_xyz_dot(a.torque[p], n), n);
	out[TS_PLASTIC_TWIST] = ts_xyz_scale(ts_xyz_dot(a.torque[1], n), n);
}

static inline double ts_plastic_limit(const struct ts_plastic_section *y, int place)
{
	return place == TS_PLASTIC_TWIST ? y->torque : y->moment;
}

/* Moment of a place by its rotation. */
static inline double ts_plastic_stiffness(const struct ts_bond_element *e, int place)
{
	const double part = place ? 1 - e->fraction : e->fraction;

	return place == TS_PLASTIC_TWIST
		       ? e->k[TS_BOND_TWIST]
		       : e->k[TS_BOND_BENDING] + e->k[TS_BOND_SHEAR] * part * part * e->length * e->length;
}

/* What place `p` has to turn so that its moment is at the limit, or below it without flow; the flow of this step that is
 * there already is taken back first. */
static inline struct ts_xyz ts_plastic_turn(const struct ts_bond_element *e,
					    const struct ts_plastic_section *y, int p, struct ts_xyz moment,
					    struct ts_xyz flow)
{
	const double limit = ts_plastic_limit(y, p), k = ts_plastic_stiffness(e, p);
	const struct ts_xyz whole = ts_xyz_add(moment, k, flow);
	const double size = sqrt(ts_xyz_dot(whole, whole));

	return ts_xyz_add(ts_xyz_scale(size > limit ? (size - limit) / (k * size) : 0, whole), -1, flow);
}

/* Turns the frames at all places at once, so that neither end comes first; returns the largest turn, by that of the
 * elastic limit. */
static inline double ts_plastic_turn_all(const struct ts_bond_element *e, const struct ts_plastic_section *y,
					 struct ts_bond_ends *s, struct ts_plastic_flow *flow)
{
	struct ts_xyz moment[TS_PLASTIC_PLACES], turn[TS_PLASTIC_PLACES];
	double most = 0;

	ts_plastic_moments(e, s, moment);
	for (int p = 0; p < TS_PLASTIC_PLACES; p++) {
		turn[p] = ts_plastic_turn(e, y, p, moment[p], flow->turn[p]);
		flow->turn[p] = ts_xyz_add(flow->turn[p], 1, turn[p]);
		most = fmax(most, sqrt(ts_xyz_dot(turn[p], turn[p])) * ts_plastic_stiffness(e, p) /
					  ts_plastic_limit(y, p));
	}
	for (int end = 0; end < 2; end++)
		s->q[end] = ts_wxyz_product(ts_wxyz_of_vector(ts_xyz_add(turn[end], end ? 0.5 : -0.5,
									 turn[TS_PLASTIC_TWIST])),
					    s->q[end]);
	return most;
}

/* The length at which the normal force of an element of the distance r between its ends is at the limit, if it is
 * beyond, else its length: with k_n = E A/l, E A (r - l)/l = +-N_p. */
static inline double ts_plastic_length(const struct ts_bond_element *e, const struct ts_plastic_section *y,
				       double r)
{
	const double pull = e->k[TS_BOND_NORMAL] * (r - e->length), ea = e->k[TS_BOND_NORMAL] * e->length;

	return fabs(pull) > y->force ? r / (1 + copysign(y->force, pull) / ea) : e->length;
}

/* The work that is lost when the length l changes to `length`: N_p |dl|, minus the change of the elastic energy N_p^2
 * l/(2 E A) with l. */
static inline double ts_plastic_stretch_work(const struct ts_bond_element *e,
					     const struct ts_plastic_section *y, double length)
{
	const double ea = e->k[TS_BOND_NORMAL] * e->length, dl = length - e->length;

	return y->force * fabs(dl) + 0.5 * y->force * y->force * dl / ea;
}

static inline bool ts_plastic_exceeds(const struct ts_bond_element *e, const struct ts_plastic_section *y,
				      const struct ts_bond_ends *s)
{
	struct ts_xyz moment[TS_PLASTIC_PLACES];
	bool any = false;

	ts_plastic_moments(e, s, moment);
	for (int p = 0; p < TS_PLASTIC_PLACES; p++)
		any |= ts_xyz_dot(moment[p], moment[p]) > pow(ts_plastic_limit(y, p), 2);
	return any;
}

/* Turns the frames of *s until no moment is beyond its limit, so that the moments are the nearest admissible ones in
 * the norm of the elastic energy (closest-point return mapping: J. C. Simo, T. J. R. Hughes, Computational
 * Inelasticity, Springer 1998). The moments of the two ends depend on each other by at most a half, so errors fall by a
 * half each time. Returns false if nothing has flowed. */
static inline bool ts_plastic_relax(const struct ts_bond_element *e, const struct ts_plastic_section *y,
				    struct ts_bond_ends *s, struct ts_plastic_flow *flow)
{
	*flow = (struct ts_plastic_flow){ 0 };
	if (!ts_plastic_exceeds(e, y, s))
		return false;
	for (int n = 0; n < 100 && ts_plastic_turn_all(e, y, s, flow) >= 1e-13; n++)
		;
	for (int p = 0; p < TS_PLASTIC_PLACES; p++)
		flow->work += ts_plastic_limit(y, p) * sqrt(ts_xyz_dot(flow->turn[p], flow->turn[p]));
	return true;
}

#endif
