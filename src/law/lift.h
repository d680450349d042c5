/* Lift on a sphere with the slip velocity w = u - v, torque, and added mass.
 *
 *   shear   F = 1.615 d^2 sqrt(rho mu/|W|) C (w x W), W = curl u (P. G. Saffman, J. Fluid Mech. 22
 *           (1965) 385; 31 (1968) 624), C = 1, or by R. Mei, Int. J. Multiphase Flow 18 (1992) 145: with
 *           Re = rho |w| d/mu, a = |W| d/(2 |w|),
 *             C = (1 - 0.3314 sqrt(a)) exp(-Re/10) + 0.3314 sqrt(a)   for Re <= 40,
 *             C = 0.0524 sqrt(a Re)                                   above
 *   spin    F = pi/8 rho d^3 C (S x w), S = W/2 - angular velocity of the sphere (S. I. Rubinow, J. B.
 *           Keller, J. Fluid Mech. 11 (1961) 447), C = 1, or by B. Oesterle, T. Bui Dinh, Exp. Fluids 25
 *           (1998) 16: with Re_s = rho d^2 |S|/mu,
 *             C = Re/Re_s (0.45 + (Re_s/Re - 0.45) exp(-0.05684 Re_s^0.4 Re^0.3))
 *   torque  T = pi mu d^3 S (G. Kirchhoff 1876; small Re_s)
 *   added mass  F = 1/2 rho V_p (Du/Dt - dv/dt) (T. R. Auton, J. C. R. Hunt, M. Prud'homme, J. Fluid
 *               Mech. 197 (1988) 241) */
#ifndef TS_LAW_LIFT_H
#define TS_LAW_LIFT_H

#include <math.h>

#include "law/lens.h"
#include "math/constants.h"

/* Factor of w x W; 0 without shear. */
static inline double ts_lift_saffman(double diameter, double density, double viscosity, double vorticity)
{
	return vorticity > 0 ? 1.615 * diameter * diameter * sqrt(density * viscosity / vorticity) : 0;
}

static inline double ts_lift_mei(double diameter, double density, double viscosity, double speed,
				 double vorticity)
{
	double re = density * speed * diameter / viscosity, a;

	if (!(speed > 0))
		return 1;
	a = 0.5 * vorticity * diameter / speed;
	return re <= 40 ? (1 - 0.3314 * sqrt(a)) * exp(-re / 10) + 0.3314 * sqrt(a) : 0.0524 * sqrt(a * re);
}

/* Factor of S x w. */
static inline double ts_lift_magnus(double diameter, double density)
{
	return TS_PI / 8 * density * diameter * diameter * diameter;
}

static inline double ts_lift_oesterle(double diameter, double density, double viscosity, double speed,
				      double spin)
{
	double re = density * speed * diameter / viscosity;
	double re_s = density * spin * diameter * diameter / viscosity;

	if (!(re_s > 0 && re > 0))
		return 1;
	return re / re_s * (0.45 + (re_s / re - 0.45) * exp(-0.05684 * pow(re_s, 0.4) * pow(re, 0.3)));
}

/* Factor of S in the torque. */
static inline double ts_spin_torque(double diameter, double viscosity)
{
	return TS_PI * viscosity * diameter * diameter * diameter;
}

/* Convective heat transfer from a fluid to a sphere: Q = pi d^2 h (T_f - T_p), h = Nu k/d with Nu = 2 +
 * 0.6 Re^(1/2) Pr^(1/3) (W. E. Ranz, W. R. Marshall, Chem. Eng. Prog. 48 (1952) 141 and 173). */
static inline double ts_nusselt_ranz_marshall(double re, double prandtl)
{
	return 2 + 0.6 * sqrt(re) * cbrt(prandtl);
}

#endif
