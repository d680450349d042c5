/* Restraints: the part of a force on a particle that takes effect. Some fixes set components of the
 * force on their particles (fix setforce), project it to a line or a plane, or prescribe the motion
 * (fix move). Fixes that add a force which depends on how the particle will move (implicit drag, added
 * mass) have to evaluate these restraints. */
#ifndef TS_FORCE_RESTRAINT_H
#define TS_FORCE_RESTRAINT_H

#include "core/sim.h"

/* Slot of struct ts_style. A restraint with a hook in POST_FORCE removes forces that were added before
 * it in the script; one without (an integrator of prescribed motion) ignores all forces. */
struct ts_restraint {
	/* Called once in a step before `apply`; NULL: nothing to prepare. */
	ts_hook_fn *prepare;
	/* Replaces the force f on particle i by the part that takes effect. NULL: the fix distributes
	 * forces among particles, so that this part cannot be given for one particle. */
	void (*apply)(const struct ts_instance *self, const struct tsim *sim, size_t i, double f[3]);
};

/* Zero-initialise; free with ts_restraints_release. */
struct ts_restraints {
	struct ts_instance **fix;
	size_t n, capacity;
};

/* For init: lists the fixes that restrain a force added by `self`. `alone`: this force depends on the
 * motion of each single particle, so a fix that distributes forces among particles of the same group is
 * refused. */
enum ts_status ts_restraints_find(struct ts_restraints *list, struct tsim *sim,
				  const struct ts_instance *self, bool alone);
enum ts_status ts_restraints_prepare(const struct ts_restraints *list, struct tsim *sim);
void ts_restraints_apply(const struct ts_restraints *list, const struct tsim *sim, size_t i, double f[3]);
void ts_restraints_release(struct ts_restraints *list);

#endif
