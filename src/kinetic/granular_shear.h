/* Uniform shear flow of smooth inelastic spheres by the Enskog equation, beyond Navier-Stokes order.
 *
 * The mean velocity is (u' y, 0, 0), solid fraction and granular temperature are uniform: the work of the shear stress is
 * dissipated where it is done. The peculiar velocities C are taken to have an anisotropic Gaussian distribution with the second
 * moment K = <C C>, T = tr(K)/3. The balance of the second moment,
 *
 *   u' (delta_ix K_jy + delta_jx K_iy) = S_ij,
 *
 * has four unknowns, K_xx, K_yy, K_zz, K_xy. S is the source by collisions (J. T. Jenkins, M. W. Richman, J. Fluid Mech. 192
 * (1988) 313; C.-S. Chou, M. W. Richman, Physica A 259 (1998) 430; J. F. Lutsko, Phys. Rev. E 70 (2004) 061101). Of two grains
 * whose line of centres is the unit vector k the normal relative velocity is Gaussian with the mean -d u' k_x k_y, since their
 * mean velocities differ, and the variance 2 k.K.k. With J_m the m-th moment of its positive part, eta = (1 + e)/2, n the
 * number density:
 *
 *   S_ij  = n g0 d^2 integral dk [eta^2 J_3 k_i k_j - 2 eta J_1 ((K.k)_i k_j + (K.k)_j k_i)]
 *   P_ij  = rho nu K_ij + rho nu n g0 d^3 (eta/2) integral dk J_2 k_i k_j	stress: kinetic and collisional
 *   gamma = rho nu n g0 d^2 (eta (1 - eta)/2) integral dk J_3		dissipation
 *
 * Integrals over the sphere are by quadrature, so nothing is expanded in the shear rate or in the anisotropy. For e -> 1, T is that of
 * Navier-Stokes order, g2/g5 (d u')^2 of granular_gas.h; the linear terms are those of V. Garzo and J. W. Dufty, Phys. Rev. E
 * 59 (1999) 5895 (V. Garzo, Phys. Fluids 25 (2013) 043301) without the fourth cumulant. */
#ifndef TS_KINETIC_GRANULAR_SHEAR_H
#define TS_KINETIC_GRANULAR_SHEAR_H

#include "base/status.h"
#include "kinetic/granular_gas.h"

/* Components of symmetric tensors; the flow is along x, its gradient along y. */
enum ts_shear_component { TS_SHEAR_XX, TS_SHEAR_YY, TS_SHEAR_ZZ, TS_SHEAR_XY, TS_SHEAR_COMPONENTS };

/* Integrals over the collisions, in units of d, rho and u'. */
struct ts_shear_collisions {
	double source[TS_SHEAR_COMPONENTS]; /* S */
	double stress[TS_SHEAR_COMPONENTS]; /* collisional */
	double dissipation;		    /* by volume */
	double rate;			    /* collisions of a grain */
};

/* The flow, in units of d, rho and u'. */
struct ts_granular_shear {
	struct ts_gas gas; /* given; all but the theory */
	double solids;	   /* given; > 0, below ts_gas_limit */

	double temperature;
	double moment[TS_SHEAR_COMPONENTS]; /* K */
	double stress[TS_SHEAR_COMPONENTS]; /* P, of both parts */
	struct ts_shear_collisions collisions;
	double imbalance; /* |work - dissipation|/work: round-off */
};

/* Sums of `order` by `order` points, even, on the half sphere; the error falls exponentially. `rate` is the shear rate, in any
 * unit of time. */
void ts_shear_collisions(const struct ts_gas *gas, double nu, double rate,
			 const double moment[TS_SHEAR_COMPONENTS], int order,
			 struct ts_shear_collisions *out);

/* Solves for the steady flow; restitution < 1. Returns TS_OK, TS_NOMEM, or TS_PHYSICS: no solution was found. */
enum ts_status ts_granular_shear_solve(struct ts_granular_shear *s);

#endif
