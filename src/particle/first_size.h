/* Original radius and mass of each particle, before a fix changed them: a column of that fix. */
#ifndef TS_PARTICLE_FIRST_SIZE_H
#define TS_PARTICLE_FIRST_SIZE_H

#include "particle/particles.h"

enum { TS_FIRST_RADIUS, TS_FIRST_MASS, TS_FIRST_KNOWN, TS_FIRST_WIDTH };

/* Adds the column; no particle is stored yet. */
enum ts_status ts_first_size_start(struct tsim *sim, const struct ts_instance *self, size_t *column);
/* Stores radius and mass of particle i unless they are stored already. */
void ts_first_size_note(const struct tsim *sim, size_t column, size_t i);

/* The TS_FIRST_WIDTH numbers of particle i: radius, mass, and 1 if they are stored. */
static inline double *ts_first_size(const struct tsim *sim, size_t column, size_t i)
{
	return (double *)sim->particles->column[column].data + TS_FIRST_WIDTH * i;
}

#endif
