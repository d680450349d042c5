/* What each particle was like when a compute or fix was defined (its place, its velocity): a column of its
 * own, so that it goes with the particle, also into restart files. Particles that come later are taken as
 * they are when they come. */
#ifndef TS_PARTICLE_REFERENCE_H
#define TS_PARTICLE_REFERENCE_H

#include "particle/particles.h"

/* Three numbers of particle i, as it is now. */
typedef void ts_reference_fn(const struct ts_instance *self, const struct tsim *sim, size_t i, double now[3]);

struct ts_reference {
	const struct ts_instance *owner;
	ts_reference_fn *now;
	size_t column;
	bool started;
};

/* In init: finds the column and, the first time, fills it in. */
enum ts_status ts_reference_init(struct ts_instance *self, struct tsim *sim, struct ts_reference *ref,
				 ts_reference_fn *now);
/* In the style's archive function. */
enum ts_status ts_reference_archive(struct ts_archive *archive, struct tsim *sim,
				    const struct ts_reference *ref);
/* After a rebuild of the rows and in SETUP: new particles. */
void ts_reference_add(struct tsim *sim, const struct ts_reference *ref);

double *ts_reference_of(const struct tsim *sim, const struct ts_reference *ref, size_t i);

#endif
