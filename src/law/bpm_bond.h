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
 * all loads grow in proportion. On other ways forces of this form have no potential. */
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
	for (int m = 0; m < TS_BOND_MODES; m++)
		e->c[m] *= w;
}

#endif
