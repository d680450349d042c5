/* Where particles come and go: periodic wrapping, loss through fixed faces, ghosts.
 *
 * The one interface through which images of particles (and, with several processes, the neighbours'
 * particles) arrive; no style may assume that all particles are local. */
#ifndef TS_PARTICLE_EXCHANGE_H
#define TS_PARTICLE_EXCHANGE_H

#include "core/sim.h"
#include "geom/box.h"

/* Wraps periodic coordinates and deletes (or reports, see enum ts_lost) particles outside fixed
 * faces; fits `s` and `m` faces. Drops the ghosts. */
enum ts_status ts_exchange_migrate(struct tsim *sim);

/* Rows are to be built of the positions and the box as they are now. */
void ts_exchange_hold(struct tsim *sim);

/* Makes ghosts of all particles whose xhold lies within `cutoff` of a periodic face; an error if one day
 * it may be `most`, and the box is smaller. */
enum ts_status ts_exchange_borders(struct tsim *sim, double cutoff, double most);

/* Refreshes positions, velocities and other TS_COL_FORWARD columns of the ghosts. */
void ts_exchange_forward(struct tsim *sim);

/* Coordinates beyond which a particle has to be taken out at once, as it has left through a fixed face;
 * infinite where there is none, and where `thermo_modify lost ignore` lets it wait for the next build of
 * neighbours: in an outflow there would be one for each that leaves. */
void ts_exchange_limits(const struct tsim *sim, double lo[3], double hi[3]);
/* Number of the fixed face (2 dim + side) through which x has left, or -1. */
int ts_exchange_left(const struct ts_box *box, const double x[3]);

#endif
