/* What bonds have beyond the element of law/bond_element.h: displacement softening, and a shear strength that grows with the
 * pressure.
 *
 * Softening: beyond the strength the section cracks, and its stress falls linearly with the opening until nothing is left.
 *
 * Let x be the opening of the outermost fibre by that at the strength, which is the stress of the whole section by its
 * strength, and X the largest x so far. The fraction of the section that is intact is
 *
 *   g(X) = 1 for X <= 1,   (rho - X)/((rho - 1) X) for 1 < X < rho,   0 from there on,
 *
 * so that the stress g x of a bond that is pulled falls from 1 to 0 between x = 1 and x = rho. It carries g times the
 * forces of the whole element; the cracked rest carries compression only. Unloading goes back to the origin. With the
 * ratio beta of the slopes of softening and loading rho = 1 + 1/beta. This has the energy
 *
 *   E = g Y + (1 - g) k_n min(r - l, 0)^2/2,   Y = (k_n max(r - l, 0)^2 + k_s u_s^2 + k_b phi_b^2 + k_t phi_t^2)/2,
 *
 * and dissipates -Y dg >= 0. Until a bond that is pulled is cracked through this is rho times its elastic energy at the
 * strength, the area below the curve.
 *
 * If shear softens, too, x is the larger of this opening and the shear stress of the whole section by its strength.
 *
 * Friction: the shear strength is that of Mohr and Coulomb, tau_c - sigma tan(phi) with the mean normal stress sigma (> 0 in
 * tension), as in the linear parallel bond of Itasca's PFC; of a cracked section that is pulled, g times that of the whole.
 *
 * Y. Ma, H. Huang, Int. J. Rock Mech. Min. Sci. 104 (2018) 9; with the opening by bending as in the soft bond of Itasca's
 * PFC. The functions have no branches, for vectorised loops. */
#ifndef TS_LAW_BOND_SOFTENING_H
#define TS_LAW_BOND_SOFTENING_H

#include "law/bond_element.h"

/* What a bond remembers: 0 while it is whole. */
struct ts_bond_damage {
	double reached; /* X, if above 1 */
	double release; /* Y/X^2 if the crack has grown in the last step, else 0; energy */
};

static inline void ts_bond_never_softens(struct ts_bond_element *e)
{
	e->onset = INFINITY;
	e->rupture = 2; /* more than 1, any */
	e->shear_rupture = e->friction = 0;
}

/* e->tension: the strength; the stress of the whole section at which the bond breaks from here on. With `sheared` the
 * same holds for the shear strength. */
static inline void ts_bond_softens_by(double beta, bool sheared, struct ts_bond_element *e)
{
	e->onset = e->tension;
	e->rupture = 1 + 1 / beta;
	e->tension *= e->rupture;
	if (!sheared)
		return;
	e->shear_rupture = e->rupture;
	e->shear *= e->rupture;
	e->friction *= e->rupture;
}

TS_INLINE double ts_bond_intact(double rupture, double reached)
{
	return reached > 1 ? (rupture - reached) / ((rupture - 1) * reached) : 1;
}

/* The shear strength at the present normal stress. */
TS_INLINE void ts_bond_rub(double intact, const struct ts_bond_answer *whole, struct ts_bond_element *e)
{
	const double normal = whole->load[TS_BOND_NORMAL] * e->per_area;

	e->shear -= e->friction * (normal > 0 ? intact : 1) * normal;
}

/* x; where the shear strength is not positive the bond breaks (ts_bond_holds), whatever this is. */
TS_INLINE double ts_bond_opening(const struct ts_bond_element *e, const struct ts_bond_answer *whole)
{
	const double opened = whole->tension / e->onset, sheared = e->shear_rupture * whole->shear / e->shear;

	return sheared > opened ? sheared : opened;
}

/* Y */
TS_INLINE double ts_bond_whole_energy(const struct ts_bond_element *e, const double load[TS_BOND_MODES])
{
	const double pull = fmax(load[TS_BOND_NORMAL], 0);

	return 0.5 * (pull * pull / e->k[TS_BOND_NORMAL] +
		      load[TS_BOND_SHEAR] * load[TS_BOND_SHEAR] / e->k[TS_BOND_SHEAR] +
		      load[TS_BOND_BENDING] * load[TS_BOND_BENDING] / e->k[TS_BOND_BENDING] +
		      load[TS_BOND_TWIST] * load[TS_BOND_TWIST] / e->k[TS_BOND_TWIST]);
}

/* The damage after an answer of the whole element, and the work *lost since that before. Twice the energy that is lost
 * between X_0 and X_1 is Y/X^2 times the triangle between the stresses X_0 g_0 and X_1 g_1; Y/X^2 is the mean of both,
 * exact if the bond is pulled, else of second order in the step. */
TS_INLINE struct ts_bond_damage ts_bond_crack(const struct ts_bond_element *e, struct ts_bond_damage before,
					      const struct ts_bond_answer *whole, double *lost)
{
	const double x = ts_bond_opening(e, whole), from = fmax(before.reached, 1);
	const bool grows = x > from;
	const double release = ts_bond_whole_energy(e, whole->load) / (x * x);
	const double mean = before.release > 0 ? 0.5 * (before.release + release) : release;

	*lost = grows ? mean * from * x * (ts_bond_intact(e->rupture, from) - ts_bond_intact(e->rupture, x))
		      : 0;
	return (struct ts_bond_damage){ grows ? x : before.reached, grows ? release : 0 };
}

/* Reduces the forces of the whole element, but not its stresses, to what the intact fraction g and the closed crack
 * carry. */
TS_INLINE void ts_bond_soften(double intact, const struct ts_bond_ends *s, struct ts_bond_answer *out)
{
	const double r2 = ts_xyz_dot(s->d, s->d), inverse = r2 > 0 ? 1 / sqrt(r2) : 0;
	const double closed = (1 - intact) * fmin(out->load[TS_BOND_NORMAL], 0);

	out->force = ts_xyz_add(ts_xyz_scale(intact, out->force), -closed * inverse, s->d);
	for (int end = 0; end < 2; end++)
		out->torque[end] = ts_xyz_scale(intact, out->torque[end]);
	for (int m = 0; m < TS_BOND_MODES; m++)
		out->load[m] *= intact;
	out->load[TS_BOND_NORMAL] += closed;
	out->axial = out->load[TS_BOND_NORMAL];
}

/* The same, and the constants of springs that give these forces. */
static inline void ts_bond_soften_state(double reached, const struct ts_bond_ends *s,
					struct ts_bond_element *e, struct ts_bond_answer *out)
{
	const double intact = ts_bond_intact(e->rupture, reached);

	ts_bond_soften(intact, s, out);
	for (int m = 0; m < TS_BOND_MODES; m++)
		e->k[m] *= m == TS_BOND_NORMAL && out->load[m] < 0 ? 1 : intact;
}

#endif
