/* Local damping of a bond: against each of its four motions a fraction alpha of the force that the spring of this
 * motion exerts,
 *
 *   F_d = -alpha |F| v/|v|
 *
 * after D. O. Potyondy and P. A. Cundall, Int. J. Rock Mech. Min. Sci. 41 (2004) 1329, sect. 2.4. It takes energy
 * from vibrations, each half of which ends sqrt((1 - alpha)/(1 + alpha)) times as far as it began, and exerts no
 * force at rest. */
#ifndef TS_LAW_BOND_LOCAL_DAMPING_H
#define TS_LAW_BOND_LOCAL_DAMPING_H

#include "law/bond_element.h"

/* Rates of the four motions, as ts_bond_viscous has them. */
TS_INLINE void ts_bond_rates(const struct ts_bond_element *e, const struct ts_bond_ends *s,
			     double rate[TS_BOND_MODES])
{
	const double r2 = ts_xyz_dot(s->d, s->d), inverse = r2 > 0 ? 1 / sqrt(r2) : 0;
	const struct ts_xyz n = ts_xyz_scale(inverse, s->d);
	const struct ts_xyz mean =
		ts_xyz_add(ts_xyz_scale(e->fraction, s->omega[0]), 1 - e->fraction, s->omega[1]);
	const struct ts_xyz turn = ts_xyz_add(s->omega[1], -1, s->omega[0]);
	const double apart = ts_xyz_dot(s->v, n), twist = ts_xyz_dot(turn, n);
	const struct ts_xyz slip = ts_xyz_add(ts_xyz_add(s->v, -apart, n), -1, ts_xyz_cross(mean, s->d));
	const struct ts_xyz bend = ts_xyz_add(turn, -twist, n);

	rate[TS_BOND_NORMAL] = fabs(apart);
	rate[TS_BOND_SHEAR] = sqrt(ts_xyz_dot(slip, slip));
	rate[TS_BOND_BENDING] = sqrt(ts_xyz_dot(bend, bend));
	rate[TS_BOND_TWIST] = fabs(twist);
}

/* Adds the damping to the answer of ts_bond_elastic: dashpots with the coefficient alpha |F|/|v|. */
TS_INLINE void ts_bond_local_damping(const double alpha[TS_BOND_MODES], struct ts_bond_element *e,
				     const struct ts_bond_ends *s, struct ts_bond_answer *out)
{
	double rate[TS_BOND_MODES];

	ts_bond_rates(e, s, rate);
	for (int m = 0; m < TS_BOND_MODES; m++)
		e->c[m] = rate[m] > 0 ? alpha[m] * fabs(out->load[m]) / rate[m] : 0;
	ts_bond_viscous(e, s, out);
}

#endif
