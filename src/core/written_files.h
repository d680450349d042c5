/* Files that live styles write (arguments with TS_WRITES). */
#ifndef TS_CORE_WRITTEN_FILES_H
#define TS_CORE_WRITTEN_FILES_H

#include "core/sim.h"

/* Before a run: fails if two styles write to the same file, as each would destroy what the other has written; several may
 * append to one. */
enum ts_status ts_written_files_check(struct tsim *sim);
/* Before a command replaces a file: fails if a style keeps it open for writing; `what`: the command. */
enum ts_status ts_written_files_allow(struct tsim *sim, const char *what, const char *path,
				      const struct ts_place *where);

#endif
