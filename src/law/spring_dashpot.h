/* Linear spring and dashpot, normal force only:
 *
 *   F = k delta - beta v_n
 *
 * The damping is given as beta, or by the coefficient of restitution e of two free bodies:
 *
 *   beta = -2 ln e sqrt(m* k/(pi^2 + ln^2 e)),
 *
 * which is exact if the contact ends at zero overlap: the contact lasts half a period pi/sqrt(omega0^2
 * - gamma^2) of a damped oscillator with omega0^2 = k/m*, gamma = beta/(2 m*). Source: any text on the
 * damped oscillator; as a contact law P. A. Cundall, O. D. L. Strack, Geotechnique 29 (1979) 47. */
#ifndef TS_LAW_SPRING_DASHPOT_H
#define TS_LAW_SPRING_DASHPOT_H

#include <math.h>
#include <stdbool.h>

#include "law/granular.h"
#include "law/granular_limit.h"
#include "math/constants.h"

struct ts_spring_dashpot {
	double stiffness;	     /* k, force/length */
	double damping;		     /* beta, force/velocity; NaN if given by restitution */
	double restitution;	     /* e; NaN if given by damping */
	struct ts_granular_pair law; /* kn; gamman or gamman_root */
};

static inline void ts_spring_dashpot_complete(struct ts_spring_dashpot *c)
{
	double log_e = log(c->restitution);

	c->law = (struct ts_granular_pair){ .kn = c->stiffness };
	if (isnan(c->restitution))
		c->law.gamman = c->damping;
	else
		c->law.gamman_root = -2 * log_e * sqrt(c->stiffness / (TS_PI * TS_PI + log_e * log_e));
}

static inline double ts_spring_dashpot_beta(const struct ts_granular_pair *c, double mass)
{
	return c->gamman_root != 0 ? c->gamman_root * sqrt(mass) : c->gamman;
}

static inline double ts_spring_dashpot_limit(const struct ts_granular_pair *c, double mass,
					     bool explicit_euler)
{
	return ts_oscillator_limit(c->kn, ts_spring_dashpot_beta(c, mass), mass, explicit_euler);
}

#endif
