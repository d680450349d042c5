/* Restart files: the state of a simulation, compressed, with checksums. Format: doc/restart-format.md. */
#ifndef TS_RESTART_RESTART_H
#define TS_RESTART_RESTART_H

#include "core/sim.h"

/* Writes the file under a temporary name and renames it when it is complete. */
enum ts_status ts_restart_write(struct tsim *sim, const char *path, const struct ts_place *where);
/* Restores the systems; the state of styles is kept in sim->unclaimed until the script defines them again. A
 * damaged file changes nothing. */
enum ts_status ts_restart_read(struct tsim *sim, const char *path, const struct ts_place *where);

#endif
