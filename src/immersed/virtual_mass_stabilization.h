/* Stabilization of the coupling of fluid and freely moving resolved bodies by a virtual mass. It is a
 * numerical device: the added mass itself is part of the resolved flow. (The added mass of unresolved
 * particles is a model: coupling/added_mass.h.)
 *
 * The force of the fluid in a step is that of the last step of the fluid, when the body had the
 * acceleration a'. It contains -m_a a', m_a the added mass. A body of less mass than about m_a/2
 * gets a larger acceleration of the opposite sign in each step: unstable for any time step
 * (P. Causin, J. F. Gerbeau, F. Nobile, Comput. Methods Appl. Mech. Eng. 194 (2005) 4506). A
 * virtual mass m_v on both sides of the equation of motion (S. Schwarz, T. Kempe, J. Froehlich, J.
 * Comput. Phys. 281 (2015) 591),
 *
 *   (m + m_v) a = F' + G + m_v a',
 *
 * with F' the force of the fluid and G all other forces, has no effect if a = a'; else its effect is of
 * first order in the step. With a' the mean over the last step of the fluid it is stable for m_a <
 * 2 m + 3 m_v, with several steps per step of the fluid for m_a < m + 2 m_v, also for m -> 0. As m a'
 * is the net force of that step, the net force is
 *
 *   m a = s (F' + G) + (1 - s) m a',   s = m/(m + m_v),
 *
 * and the same for torques. All particles of a rigid body have the same s, that of the whole body, so that
 * sums of forces and moments are those of this equation for the body. */
#ifndef TS_IMMERSED_VIRTUAL_MASS_STABILIZATION_H
#define TS_IMMERSED_VIRTUAL_MASS_STABILIZATION_H

#include <stdbool.h>

#include "core/sim.h"

/* Net force and torque on a body; [0..2] force, [3..5] torque. Kept as a column of doubles in restart
 * files. */
struct ts_net_force {
	double last[6]; /* at the end of the last step */
	/* sum over the steps since the last step of the fluid, of the mean of beginning and end */
	double sum[6];
	double steps;	/* number of these steps */
	double mean[6]; /* mean over the last step of the fluid */
	double begun;	/* 0: `last` is not set yet */
};
enum { TS_NET_FORCE_NUMBERS = sizeof(struct ts_net_force) / sizeof(double) }; /* all members are doubles */

/* Density of the body that particle i is or belongs to. */
double ts_virtual_mass_density(const struct tsim *sim, size_t i);
/* s = m/(m + m_v) of a body, with m_v = coefficient * density of the fluid * volume. */
static inline double ts_virtual_mass_ratio(double density, double coefficient, double fluid)
{
	return density / (density + coefficient * fluid);
}

/* Replaces force and torque by s (F' + G) + (1 - s) m a'; `share`: s. */
void ts_net_force_stabilize(const struct ts_net_force *net, double share, double force[3], double torque[3]);
/* Records the net force and torque of this step. `in_setup`: no step ends with it. */
void ts_net_force_record(struct ts_net_force *net, bool in_setup, const double force[3],
			 const double torque[3]);
/* After a step of the fluid: computes the mean and restarts the sum. */
void ts_net_force_average(struct ts_net_force *net);

#endif
