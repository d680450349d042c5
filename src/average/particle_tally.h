/* What a fix notes for each particle at one step, summed only if someone asks: noting costs a store
 * for each particle, an exact sum is dearer. Numbers of particles that do not count are 0. */
#ifndef TS_AVERAGE_PARTICLE_TALLY_H
#define TS_AVERAGE_PARTICLE_TALLY_H

#include "core/sim.h"

enum { TS_TALLY_MOST = 4 };

/* Zero-initialise; ts_tally_release when done. */
struct ts_tally {
	double (*note)[TS_TALLY_MOST]; /* by particle */
	size_t n, capacity;
	bool fresh;			/* noted since the last sum */
	double sum[TS_TALLY_MOST];	/* saved */
};

/* Makes room for all particles; all notes are 0. */
enum ts_status ts_tally_start(struct tsim *sim, struct ts_tally *tally);
/* The sums, exact and rounded once. */
const double *ts_tally_sums(struct ts_tally *tally);
void ts_tally_release(struct ts_tally *tally);
/* For the archive function of the fix: the sums. */
enum ts_status ts_tally_archive(struct ts_archive *archive, struct ts_tally *tally);

#endif
