/* The inertia of the fluid around bodies that move freely.
 *
 * The force of the fluid that acts in a step is that of its last one, when the body had the
 * acceleration a'. It contains -m_a a', m_a the added mass. A body of less mass than about m_a/2
 * answers with a larger acceleration of the opposite sign in each step: unstable, whatever the step
 * (P. Causin, J. F. Gerbeau, F. Nobile, Comput. Methods Appl. Mech. Eng. 194 (2005) 4506). A
 * virtual mass m_v on both sides of the equation of motion (S. Schwarz, T. Kempe, J. Froehlich, J.
 * Comput. Phys. 281 (2015) 591),
 *
 *   (m + m_v) a = F' + G + m_v a',
 *
 * F' the fluid's force, G all others, changes nothing where a = a', and what it changes else is of
 * first order in the step. With a' the mean over the last step of the fluid it is stable for m_a <
 * 2 m + 3 m_v, with several steps to one of the fluid for m_a < m + 2 m_v, for m -> 0 too. As m a'
 * is the net force that acted then, the net force is
 *
 *   m a = s (F' + G) + (1 - s) m a',   s = m/(m + m_v),
 *
 * and the same for torques. Of a rigid body of several particles all have the same s, that of the
 * whole body, so that sums of forces and moments are those of this equation for the body. */
#ifndef TS_IMMERSED_VIRTUAL_MASS_STABILIZATION_H
#define TS_IMMERSED_VIRTUAL_MASS_STABILIZATION_H

#include <stdbool.h>

struct ts_net_force {
	double last[6]; /* force and torque that took effect in the last step */
	double sum[6];	/* mean of those of the beginning and the end of each step, since the last
			   step of the fluid */
	double steps;	/* so many */
	double mean[6]; /* over the last step of the fluid */
	double begun;
};
enum {
	TS_NET_FORCE_NUMBERS = sizeof(struct ts_net_force) / sizeof(double)
}; /* nothing else is in it */

/* s of a body of this density in a fluid, m_v = coefficient x fluid's density x volume. */
static inline double ts_virtual_mass_ratio(double density, double coefficient, double fluid)
{
	return density / (density + coefficient * fluid);
}

/* From the force and torque of all to the net ones. */
void ts_net_force_stabilize(const struct ts_net_force *net, double share, double force[3],
			double torque[3]);
/* What takes effect. `in_setup`: no step ends with it. */
void ts_net_force_record(struct ts_net_force *net, bool in_setup, const double force[3],
		       const double torque[3]);
/* The fluid has made a step. */
void ts_net_force_average(struct ts_net_force *net);

#endif
