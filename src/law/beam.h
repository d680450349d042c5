/* The beam element of Timoshenko between two bodies, in the form of law/bond_element.h: with the mean theta_s and the
 * difference theta_d of the rotations of the ends relative to the chord, the cubic element has the energy
 *
 *   (E I/l) theta_d^2/2 + 12 E I/(l (1 + Phi)) theta_s^2/2,   Phi = 12 E I/(kappa G A l^2),
 *
 * which is its stiffness matrix E I/(l (1 + Phi)) (4 + Phi, 2 - Phi; 2 - Phi, 4 + Phi). The second term is the energy of the
 * displacement l theta_s across the bond. So a straight cantilever has the exact deflection P L^3/(3 E I) + P L/(kappa G A)
 * with any number of elements.
 *
 * M. Obermayr, K. Dressler, C. Vrettos, P. Eberhard, Computers and Geotechnics 49 (2013) 299; Y. Guo, C. Wassgren, W.
 * Ketterhagen, B. Hancock, J. Curtis, Powder Technol. 249 (2013) 386; J. S. Przemieniecki, Theory of Matrix Structural
 * Analysis (McGraw-Hill, 1968), sect. 5.6. */
#ifndef TS_LAW_BEAM_H
#define TS_LAW_BEAM_H

#include "law/bond_element.h"
#include "math/constants.h"

/* Shear coefficient of a circular section: G. R. Cowper, J. Appl. Mech. 33 (1966) 335. */
static inline double ts_beam_shear_coefficient(double poisson)
{
	return 6 * (1 + poisson) / (7 + 6 * poisson);
}

/* e->length is set; kappa: shear coefficient, INFINITY: no deformation by shear (Euler and Bernoulli). */
static inline void ts_beam_element(double radius, double e_modulus, double g_modulus, double kappa,
				   struct ts_bond_element *e)
{
	const double l = e->length, r2 = radius * radius, area = TS_PI * r2, inertia = area * r2 / 4;
	const double phi = 12 * e_modulus * inertia / (kappa * g_modulus * area * l * l);

	e->fraction = 0.5;
	e->k[TS_BOND_NORMAL] = e_modulus * area / l;
	e->k[TS_BOND_SHEAR] = 12 * e_modulus * inertia / (l * l * l * (1 + phi));
	e->k[TS_BOND_BENDING] = e_modulus * inertia / l;
	e->k[TS_BOND_TWIST] = g_modulus * 2 * inertia / l;
	e->lever = l / 2;
}

#endif
