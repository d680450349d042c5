#include <string.h> /* also without MPI: a file must declare something */

#ifdef TS_WITH_MPI
#include "program/program_mpi.h"

#ifdef TS_MPI_FILE
#include <dlfcn.h>
#endif

#include "base/banned.h"

#ifdef TS_MPI_FILE
static bool find(void *library, const char *name, void *to)
{
	void *found = dlsym(library, name);

	memcpy(to, &found, sizeof found); /* an address of data or of a function */
	return found != NULL;
}

/* The objects of Open MPI are addresses, those of other libraries are numbers. A program that is compiled without -fPIC has copies
 * of its own of those that it names, which the library uses, too: they come first in the order in which symbols are looked for. */
#ifdef OPEN_MPI
#define OBJECT(to, name, value) found &= find(RTLD_DEFAULT, name, &(to))
#else
#define OBJECT(to, name, value) (to) = (value)
#endif

bool ts_program_mpi_load(struct ts_program_mpi *mpi)
{
	/* its modules, which it loads itself, look for its symbols among those of the program */
	void *library = dlopen(TS_MPI_FILE, RTLD_NOW | RTLD_GLOBAL | RTLD_NODELETE);
	bool found = library != NULL;

	if (!found)
		return false;
#define FIND(name) found &= find(library, "MPI_" #name, &mpi->name);
	TS_MPI_FUNCTIONS(FIND)
#undef FIND
	OBJECT(mpi->world, "ompi_mpi_comm_world", MPI_COMM_WORLD);
	OBJECT(mpi->byte, "ompi_mpi_byte", MPI_BYTE);
	OBJECT(mpi->real, "ompi_mpi_double", MPI_DOUBLE);
	OBJECT(mpi->whole, "ompi_mpi_int64_t", MPI_INT64_T);
	OBJECT(mpi->count, "ompi_mpi_uint64_t", MPI_UINT64_T);
	OBJECT(mpi->most, "ompi_mpi_op_max", MPI_MAX);
	OBJECT(mpi->sum, "ompi_mpi_op_sum", MPI_SUM);
	dlclose(library); /* it stays loaded */
	return found;
}
#else
bool ts_program_mpi_load(struct ts_program_mpi *mpi)
{
	*mpi = (struct ts_program_mpi){
#define TAKE(name) .name = MPI_##name,
		TS_MPI_FUNCTIONS(TAKE)
#undef TAKE
			.world = MPI_COMM_WORLD,
		.byte = MPI_BYTE,
		.real = MPI_DOUBLE,
		.whole = MPI_INT64_T,
		.count = MPI_UINT64_T,
		.most = MPI_MAX,
		.sum = MPI_SUM,
	};
	return true;
}
#endif
#else
#include "base/banned.h"
#endif
