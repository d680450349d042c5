/* Periodic wrapping, loss of particles through fixed faces, and ghosts.
 *
 * The only functions that create ghosts. Styles must not assume that the partner of a contact is local. */
#ifndef TS_PARTICLE_EXCHANGE_H
#define TS_PARTICLE_EXCHANGE_H

#include "core/sim.h"
#include "geom/box.h"

/* Wraps positions into the periodic box, deletes particles outside of fixed faces (enum ts_lost says whether
 * with a warning or an error; none while sim->run.relist), fits shrink-wrapped faces, and drops the ghosts. */
enum ts_status ts_exchange_migrate(struct tsim *sim);
/* Where the faces of this dimension lie if those of style s and m are moved to the present particles. */
void ts_exchange_fitted_faces(const struct tsim *sim, int dim, double *lo, double *hi);

/* Stores the present positions (xhold) and box as those from which the contact list is built. */
void ts_exchange_hold(struct tsim *sim);

/* Creates ghosts of all particles whose xhold lies within `cutoff` of a periodic face and, while the particles are divided, of
 * those within `copies` >= cutoff of the block of this rank. Fails if the box is shorter than `most`, the largest cutoff
 * that the run may need. */
enum ts_status ts_exchange_borders(struct tsim *sim, double cutoff, double copies, double most);

/* Updates positions, velocities and the other TS_COL_FORWARD columns of the ghosts. */
void ts_exchange_forward(struct tsim *sim);

/* Limits of the coordinates beyond which a particle is lost and the contact list is rebuilt at once;
 * infinite where the face is not fixed. Also infinite with `thermo_modify lost ignore`, where lost
 * particles are deleted at the next regular rebuild: an outlet would otherwise cause one rebuild per
 * particle. */
void ts_exchange_limits(const struct tsim *sim, double lo[3], double hi[3]);
/* The fixed face, 2 * dim + side, beyond which x lies, or -1. */
int ts_exchange_left(const struct ts_box *box, const double x[3]);
/* Whether some local particle is there. */
bool ts_exchange_some_left(struct tsim *sim);

#endif
