/* Molecules: molecule numbers of particles, which the script defines by `fix ID all property/atom mol`, or
 * read_data. */
#ifndef TS_PARTICLE_MOLECULE_H
#define TS_PARTICLE_MOLECULE_H

#include "particle/particles.h"

/* The molecule number of each particle; NULL if the script has defined none. */
const double *ts_particles_molecules(const struct ts_particles *p);
double *ts_particles_molecules_to_set(struct ts_particles *p);
/* The largest molecule number, of all ranks; 0 without molecules. */
double ts_particles_most_molecule(const struct tsim *sim);
/* Fails if there are particles without molecule numbers; the message begins with `what`, e.g. "group". */
enum ts_status ts_particles_need_molecules(struct tsim *sim, const char *what, const struct ts_place *where);

#endif
