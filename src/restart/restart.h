/* Restart files: the whole state of a simulation, checksummed, compressed, renamed into place. The format
 * is described in doc/restart-format.md. */
#ifndef TS_RESTART_RESTART_H
#define TS_RESTART_RESTART_H

#include "core/sim.h"

enum ts_status ts_restart_write(struct tsim *sim, const char *path, const struct ts_place *where);
/* Restores the systems; the state of styles waits in sim->unclaimed until the script defines them
 * again. A damaged file changes nothing. */
enum ts_status ts_restart_read(struct tsim *sim, const char *path, const struct ts_place *where);

#endif
