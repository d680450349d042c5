/* Restart files: the whole state of a simulation, checksummed, compressed, renamed into place.
 *
 * Layout: the line "tsim restart 1\n"; byte order mark and version (2 x u32); sections; an end
 * mark. A section: kind + 1 (u32; CLOCK_SECTION for the clock), lengths of its names (3 x u32),
 * sizes of its block plain and compressed (2 x u64), checksum of the compressed block (u32), the
 * names of style, id and group, the compressed block (core/archive.h). The end mark is a zero (u32)
 * followed by the checksum of all before it. */
#ifndef TS_IO_RESTART_H
#define TS_IO_RESTART_H

#include "core/sim.h"

enum ts_status ts_restart_write(struct tsim *sim, const char *path, const struct ts_place *where);
/* Restores the systems; the state of styles waits in sim->pending until the script defines them
 * again. A damaged file changes nothing. */
enum ts_status ts_restart_read(struct tsim *sim, const char *path, const struct ts_place *where);

#endif
