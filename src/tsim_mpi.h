/* Several processes compute one simulation together, by MPI: doc/ranks.md. Link with -ltsim_mpi, which has all functions of
 * tsim.h, instead of -ltsim.
 *
 * All processes call the same functions of tsim.h with the same arguments in the same order. Between the steps each of them
 * has all particles, so that functions that read give the same on all. An error in a step, which only one process may meet,
 * ends all of them with its message; all other errors are returned to all. */
#ifndef TSIM_MPI_H
#define TSIM_MPI_H

#include <tsim.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Joins the processes of a communicator, before the first script line: `communicator` points to an MPI_Comm, of which a
 * copy is made; NULL: MPI_COMM_WORLD. MPI must have been initialised, with MPI_THREAD_FUNNELED at least, and is not
 * finalised. The first process alone has output (tsim_screen, tsim_on_log), and alone reads and writes files: a log file
 * is to be opened after this call. tsim_close, which all must call, leaves the others. With one process nothing happens.
 *
 * TSIM_STATE: MPI is not initialised, or the simulation has begun. */
TSIM_API int tsim_mpi_join(struct tsim *sim, const void *communicator);

#ifdef __cplusplus
}
#endif
#endif
