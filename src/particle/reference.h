/* Reference vector of each particle (position, velocity) at the time when a compute or fix was defined, or
 * when the particle was inserted if that was later. It is a column, so it moves with the particle and is
 * written to restart files. */
#ifndef TS_PARTICLE_REFERENCE_H
#define TS_PARTICLE_REFERENCE_H

#include "particle/particles.h"

/* Writes the present vector of particle i to now[]. */
typedef void ts_reference_fn(const struct ts_instance *self, const struct tsim *sim, size_t i, double now[3]);

struct ts_reference {
	const struct ts_instance *owner;
	ts_reference_fn *now;
	size_t column; /* index in particles->column */
	bool started;
};

/* For init: adds the column and, the first time, stores the present vectors. */
enum ts_status ts_reference_init(struct ts_instance *self, struct tsim *sim, struct ts_reference *ref,
				 ts_reference_fn *now);
/* For the archive function of the style. */
enum ts_status ts_reference_archive(struct ts_archive *archive, struct tsim *sim,
				    const struct ts_reference *ref);
/* Stores the present vectors of particles that have none; called in POST_BUILD and SETUP. */
void ts_reference_add(struct tsim *sim, const struct ts_reference *ref);

/* The reference vector of particle i. */
double *ts_reference_of(const struct tsim *sim, const struct ts_reference *ref, size_t i);

#endif
