/* Which part of a force on a particle takes effect: some fixes set components of the force on their
 * particles, or keep it in a plane, or move particles as they are told. What adds a force that depends on
 * how the particle will move needs to know. */
#ifndef TS_FORCE_RESTRAINT_H
#define TS_FORCE_RESTRAINT_H

#include "core/sim.h"

/* Slot of struct ts_style. Fixes with a hook in POST_FORCE take away what was added before them in the
 * script, others (who integrate the motion) ignore forces whoever has added them. */
struct ts_restraint {
	/* Before it is asked in a step; NULL: nothing to do. */
	ts_hook_fn *prepare;
	/* What is left of the force f on particle i. NULL: forces are shared out among particles. */
	void (*leave)(const struct ts_instance *self, const struct tsim *sim, size_t i, double f[3]);
};

/* Zero-initialise; ts_restraints_release when done. */
struct ts_restraints {
	struct ts_instance **fix;
	size_t n, capacity;
};

/* For init: the fixes that restrain what `self` adds. `alone`: its force depends on how each particle will
 * move by itself, so that one is refused that shares out forces among particles that `self` acts on, too. */
enum ts_status ts_restraints_find(struct ts_restraints *list, struct tsim *sim,
				  const struct ts_instance *self, bool alone);
enum ts_status ts_restraints_prepare(const struct ts_restraints *list, struct tsim *sim);
void ts_restraints_leave(const struct ts_restraints *list, const struct tsim *sim, size_t i, double f[3]);
void ts_restraints_release(struct ts_restraints *list);

#endif
