/* Per-particle numbers of a fix at one step, summed over all particles only when an output needs them:
 * storing them is cheap, an exact sum is not. */
#ifndef TS_AVERAGE_PARTICLE_TALLY_H
#define TS_AVERAGE_PARTICLE_TALLY_H

#include "core/sim.h"

enum { TS_PARTICLE_TALLY_MOST = 4 };

/* Zero-initialise; ts_particle_tally_release when done. */
struct ts_particle_tally {
	double (*note)[TS_PARTICLE_TALLY_MOST]; /* [n] numbers of each particle, or of the noted ones */
	size_t n, capacity;
	bool fresh;			    /* `note` has changed since `sum` was computed */
	double sum[TS_PARTICLE_TALLY_MOST]; /* over all particles; written to restart files */
};

/* Allocates the numbers for all particles and sets them to 0. */
enum ts_status ts_particle_tally_start(struct tsim *sim, struct ts_particle_tally *tally);
/* The same, but the numbers of all particles are for the caller to set. */
enum ts_status ts_particle_tally_start_unset(struct tsim *sim, struct ts_particle_tally *tally);
/* The same for fixes of few particles: allocates room, and notes no particle yet. */
enum ts_status ts_particle_tally_start_empty(struct tsim *sim, struct ts_particle_tally *tally);
/* Appends `members` rows, to be written by the caller; returns the first. For several threads at once: the order of
 * rows does not matter, as sums are exact. */
double (*ts_particle_tally_append(struct ts_particle_tally *tally, size_t members))[TS_PARTICLE_TALLY_MOST];
/* The sums, exact and rounded once. */
const double *ts_particle_tally_sums(struct ts_particle_tally *tally);
/* Slot `join` of fixes whose state begins with a tally: the sums over the particles of all ranks. */
enum ts_status ts_particle_tally_join(struct ts_instance *self, struct tsim *sim);
/* The same for any tally. */
enum ts_status ts_particle_tally_merge(struct ts_particle_tally *tally, struct tsim *sim);
void ts_particle_tally_release(struct ts_particle_tally *tally);
/* Saves or restores the sums; called by the archive function of the fix. */
enum ts_status ts_particle_tally_archive(struct ts_archive *archive, struct ts_particle_tally *tally);

#endif
