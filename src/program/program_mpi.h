/* The functions and objects of MPI that program_ranks.c uses. Its shared library, with six others, is loaded when there are
 * ranks: a process alone starts a fifth sooner and takes 1.5 MB less. */
#ifndef TS_PROGRAM_MPI_H
#define TS_PROGRAM_MPI_H

#include <mpi.h>
#include <stdbool.h>

/* X(name) for each function MPI_name */
#define TS_MPI_FUNCTIONS(X) \
	X(Abort)            \
	X(Comm_dup)         \
	X(Comm_free)        \
	X(Comm_rank)        \
	X(Comm_size)        \
	X(Finalize)         \
	X(Finalized)        \
	X(Get_count)        \
	X(Iallgather)       \
	X(Iallgatherv)      \
	X(Iallreduce)       \
	X(Ibarrier)         \
	X(Ibcast)           \
	X(Init_thread)      \
	X(Initialized)      \
	X(Iprobe)           \
	X(Irecv)            \
	X(Isend)            \
	X(Issend)           \
	X(Recv)             \
	X(Test)             \
	X(Testall)

struct ts_program_mpi {
#define TS_MPI_MEMBER(name) __typeof__(&MPI_##name) name;
	TS_MPI_FUNCTIONS(TS_MPI_MEMBER)
#undef TS_MPI_MEMBER
	MPI_Comm world;
	MPI_Datatype byte, real, whole, count; /* double, int64_t, uint64_t */
	MPI_Op most, sum;
};

/* False if the library or something in it is not found. */
bool ts_program_mpi_load(struct ts_program_mpi *mpi);

#endif
