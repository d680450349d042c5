/* What a fix notes for each particle at one step, summed only if someone asks: noting costs a store
 * for each particle, an exact sum is dearer. Numbers of particles that do not count are 0. */
#ifndef TS_AVERAGE_PARTICLE_TALLY_H
#define TS_AVERAGE_PARTICLE_TALLY_H

#include "core/sim.h"

enum { TS_PARTICLE_TALLY_MOST = 4 };

/* Zero-initialise; ts_particle_tally_release when done. */
struct ts_particle_tally {
	double (*note)[TS_PARTICLE_TALLY_MOST]; /* by particle */
	size_t n, capacity;
	bool fresh;			    /* noted since the last sum */
	double sum[TS_PARTICLE_TALLY_MOST]; /* saved */
};

/* Makes room for all particles; all notes are 0. */
enum ts_status ts_particle_tally_start(struct tsim *sim, struct ts_particle_tally *tally);
/* The sums, exact and rounded once. */
const double *ts_particle_tally_sums(struct ts_particle_tally *tally);
void ts_particle_tally_release(struct ts_particle_tally *tally);
/* For the archive function of the fix: the sums. */
enum ts_status ts_particle_tally_archive(struct ts_archive *archive, struct ts_particle_tally *tally);

#endif
