/* Ranks started by mpirun: rank/world.h by MPI. The only file that calls MPI is program_ranks.c. */
#ifndef TS_PROGRAM_RANKS_H
#define TS_PROGRAM_RANKS_H

#include "base/files.h"
#include "base/log.h"
#include "rank/world.h"

/* The version of MPI by which there are ranks, or "no". */
const char *ts_program_ranks_standard(void);
/* Whether this is the first of the processes that a launcher started, or it is alone: by its variables, before there are
 * ranks. */
bool ts_program_ranks_first(void);
/* The communicator of all processes; NULL: this process is alone (then nothing is initialised), or *why tells why the
 * processes that were started cannot work together. */
struct ts_world *ts_program_ranks_begin(int *argc, char ***argv, const char **why);
/* Waits for the other ranks and ends MPI. */
void ts_program_ranks_end(struct ts_world *world);
/* The same for a program that has initialised MPI itself, and ends it: a copy of the communicator to which the pointer
 * points, NULL: MPI_COMM_WORLD; or NULL, and *why. */
struct ts_world *ts_program_ranks_join(const void *communicator, const char **why);
void ts_program_ranks_leave(struct ts_world *world);
/* Ends all ranks with the first message that reaches the first one, which prints it; does not return. */
void ts_program_ranks_fail(struct ts_world *world, const char *message);
/* The log to which the first rank prints the message that ends all. */
void ts_program_ranks_listen(struct ts_world *world, struct ts_log *log);
/* Whether the first rank reads and writes all files. */
struct ts_files_peers ts_program_ranks_files(struct ts_world *world);

#endif
