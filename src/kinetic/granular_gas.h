/* Kinetic theory of smooth inelastic spheres: constitutive functions of the solid fraction nu.
 *
 * With T = <C^2>/3 the granular temperature (velocity^2), C the velocity of a grain relative to the mean, rho the
 * density of a grain and d its diameter:
 *   normal stress     N = rho g1 T
 *   shear stress      S = rho d g2 sqrt(T) |du/dy|
 *   flux of energy    q = -rho d (g3 sqrt(T) dT/dy + g4 T^1.5 dnu/dy)
 *   dissipation       gamma = (rho/d) g5 T^1.5 by volume
 *
 * Theories:
 *   lun           C. K. K. Lun, S. B. Savage, D. J. Jeffrey, N. Chepurniy, J. Fluid Mech. 140 (1984) 223; nearly elastic
 *   garzo/dufty   V. Garzo, J. W. Dufty, Phys. Rev. E 59 (1999) 5895; revised Enskog theory, any restitution
 * Both have the same g1, and at e = 1 the same functions: those of Enskog. */
#ifndef TS_KINETIC_GRANULAR_GAS_H
#define TS_KINETIC_GRANULAR_GAS_H

#include <stdbool.h>

enum ts_gas_theory { TS_GAS_LUN, TS_GAS_GARZO_DUFTY };

/* Radial distribution at contact, g0:
 *   lun/savage          (1 - nu/nu_max)^(-2.5 nu_max); C. K. K. Lun, S. B. Savage, Acta Mech. 63 (1986) 15
 *   carnahan/starling   (2 - nu)/(2 (1 - nu)^3); N. F. Carnahan, K. E. Starling, J. Chem. Phys. 51 (1969) 635
 *   torquato            the same up to freezing, nu_f = 0.49; from there its value at nu_f times
 *                       (nu_max - nu_f)/(nu_max - nu); S. Torquato, Phys. Rev. E 51 (1995) 3170; nu_max > nu_f */
enum ts_gas_radial { TS_GAS_LUN_SAVAGE, TS_GAS_CARNAHAN_STARLING, TS_GAS_TORQUATO };

struct ts_gas {
	enum ts_gas_theory theory;
	enum ts_gas_radial radial;
	double restitution; /* e, 0 to 1 */
	double packing;	    /* nu_max, 0 to 1: solid fraction at closest packing */
};

struct ts_gas_functions {
	double pressure, pressure_slope; /* g1, dg1/dnu */
	double viscosity, conductivity;	 /* g2, g3 */
	double dufour;			 /* g4 */
	double dissipation;		 /* g5 */
};

/* Solid fraction of spheres at freezing. */
#define TS_GAS_FREEZING 0.49

/* Solid fraction at which the slope of g0 has a step; NaN: at none. */
double ts_gas_kink(const struct ts_gas *gas);
/* Solid fraction at which g0 is infinite. */
double ts_gas_limit(const struct ts_gas *gas);
/* 0 < nu < ts_gas_limit. */
double ts_gas_radial(const struct ts_gas *gas, double nu, double *slope);
void ts_gas_functions(const struct ts_gas *gas, double nu, struct ts_gas_functions *out);
/* The same where free = 1 - nu/limit is so small that nu does not tell it. */
void ts_gas_functions_packed(const struct ts_gas *gas, double nu, double free, struct ts_gas_functions *out);

/* T/(d du/dy)^2 = g2/g5 of the homogeneous shear flow, in which the work of the shear stress is dissipated where it is
 * done; e < 1. */
double ts_gas_sheared_temperature(const struct ts_gas *gas, double nu);

/* Restitution of smooth spheres that dissipate as much translational energy as nearly elastic spheres with the friction
 * coefficient mu, whose rotation is in equilibrium; `tangential` is the restitution along the surface, -1 to 1, of
 * contacts that stick. J. T. Jenkins, C. Zhang, Phys. Fluids 14 (2002) 1228; for small mu e - pi mu/2 + 9 mu^2/2. */
double ts_gas_rough_restitution(double restitution, double friction, double tangential);

#endif
