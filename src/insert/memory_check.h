/* Memory of particles that are to be created. */
#ifndef TS_INSERT_MEMORY_CHECK_H
#define TS_INSERT_MEMORY_CHECK_H

#include "core/sim.h"

/* Fails with TS_NOMEM if n particles need more memory than there is, before it is allocated: Linux grants more than it has and
 * kills the process when the memory is used. `extra`: bytes of each until it is made, besides its columns. `who`: the command,
 * for the message; *bytes: what the particles take. */
enum ts_status ts_memory_check(struct tsim *sim, const char *who, double n, size_t extra,
			       const struct ts_place *where, double *bytes);

#endif
