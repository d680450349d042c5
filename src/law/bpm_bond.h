/* Bonds of LAMMPS' package BPM, by its manual.
 *
 * A central spring (J. T. Clemmer, J. M. Monti, J. B. Lechman, Soft Matter 20 (2024) 1702): with x = r - r0, the
 * strain e = x/r0 and its critical value e_c,
 *
 *   F = k x w,   w = 1 - (e/e_c)^8,   U = k x^2/2 (1 - (e/e_c)^8/5)
 *
 * or w = 1 without smoothing. The bond breaks at |e| > e_c.
 *
 * A bond with moments (law/bond_element.h) breaks when
 *
 *   B = f_r/f_rc + |f_s|/f_sc + |tau_b|/tau_bc + |tau_t|/tau_tc,   f_r > 0 in tension,
 *
 * reaches 1; its forces, and dashpots, are multiplied by 1 - max(B, 0)^4, its energy by 1 - max(B, 0)^4/3: their integral where
 * all loads grow in proportion. On other ways forces of this form have no potential: they are the derivatives of this energy,
 * and the rest, which takes or gives work (ts_bpm_derive). */
#ifndef TS_LAW_BPM_BOND_H
#define TS_LAW_BPM_BOND_H

#include <math.h>

#include "law/bond_element.h"

/* (e/e_c)^8, 0 if it is not smoothed. */
TS_INLINE double ts_bpm_eighth(double strain, double critical, bool smooth)
{
	const double y = strain / critical, y2 = y * y, y4 = y2 * y2;

	return smooth ? y4 * y4 : 0;
}

/* B: as largest "stress" of the answer, tension where normal force and bending have the larger part of it, else shear. */
TS_INLINE void ts_bpm_damage(const double critical[TS_BOND_MODES], struct ts_bond_answer *out)
{
	const double pull = out->load[TS_BOND_NORMAL] / critical[TS_BOND_NORMAL] +
			    fabs(out->load[TS_BOND_BENDING]) / critical[TS_BOND_BENDING];
	const double slide = fabs(out->load[TS_BOND_SHEAR]) / critical[TS_BOND_SHEAR] +
			     fabs(out->load[TS_BOND_TWIST]) / critical[TS_BOND_TWIST];
	const double damage = fmax(pull + slide, 0);

	out->tension = pull >= slide ? damage : 0;
	out->shear = pull >= slide ? 0 : damage;
	out->compression = 0;
}

/* B^4, after ts_bpm_damage. */
TS_INLINE double ts_bpm_smoothing(const struct ts_bond_answer *a)
{
	const double b = fmax(a->tension, a->shear), b2 = b * b;

	return b2 * b2;
}

/* Multiplies forces and dashpots by w. */
TS_INLINE void ts_bpm_scale(double w, struct ts_bond_element *e, struct ts_bond_answer *out)
{
	out->force = ts_xyz_scale(w, out->force);
	for (int k = 0; k < 2; k++)
		out->torque[k] = ts_xyz_scale(w, out->torque[k]);
	out->axial *= w;
	out->acting = w;
	for (int m = 0; m < TS_BOND_MODES; m++)
		e->c[m] *= w;
}

/* Force and torques become the derivatives of the energy U = U_0 (1 - B^4/3), after ts_bpm_damage: with a load f of the
 * displacement q that is
 *
 *   dU/dq = f s,   s = 1 - B^4/3 - 4/3 B^3 U_0 (dB/dq)/f,   dB/dq = k/f_c, times the sign of f if B has |f|,
 *
 * so they are those of the element with the stiffnesses k s. Where f is 0, dU/dq may jump; near it s is not accurate. */
TS_INLINE void ts_bpm_derive(const double critical[TS_BOND_MODES], const struct ts_bond_element *e,
			     const struct ts_bond_ends *s, struct ts_bond_answer *out)
{
	const double nearly = 1e-8, b = fmax(out->tension, out->shear);
	struct ts_bond_element of = *e;
	struct ts_bond_answer derived;
	double energy = 0;

	for (int m = 0; m < TS_BOND_MODES; m++)
		energy += e->k[m] > 0 ? 0.5 * out->load[m] * out->load[m] / e->k[m] : 0;
	for (int m = 0; m < TS_BOND_MODES; m++) {
		const double load = m == TS_BOND_NORMAL ? out->load[m] : fabs(out->load[m]);

		of.k[m] *= 1 - out->smoothed;
		if (fabs(load) > nearly * critical[m])
			of.k[m] -= 4. / 3 * b * b * b * energy * e->k[m] / critical[m] * e->k[m] / load;
	}
	ts_bond_elastic(&of, s, &derived);
	out->force = derived.force;
	for (int k = 0; k < 2; k++)
		out->torque[k] = derived.torque[k];
}

#endif
