/* Ranks of a program that uses the library: tsim_mpi.h. */
#include "tsim_mpi.h"

#include "core/sim.h"
#include "library/library.h"
#include "program/program_ranks.h"

#include "base/banned.h"

/* Whether nothing has been done with the simulation that the others might not have done. */
static bool is_new(const struct tsim *sim)
{
	return !ts_sim_has_box(sim) && !sim->run.inside && !sim->log.file && !sim->world;
}

int tsim_mpi_join(struct tsim *sim, const void *communicator)
{
	TS_LIBRARY_NEEDS(sim, sim);

	const char *why =
		is_new(sim) ? NULL
			    : "the simulation has begun: join before the first script line and tsim_log";
	struct ts_world *world = why ? NULL : ts_program_ranks_join(communicator, &why);

	if (why)
		return ts_library_result(sim, ts_fail(&sim->error, TS_STATE, NULL, "tsim_mpi_join: %s", why));
	if (world->n == 1) {
		ts_program_ranks_leave(world);
		return TSIM_OK;
	}
	sim->world = world;
	sim->library->peers = ts_program_ranks_files(world);
	sim->library->leave = ts_program_ranks_leave;
	sim->files.peers = &sim->library->peers;
	ts_program_ranks_listen(world, &sim->log);
	if (world->rank > 0) {
		tsim_screen(sim, NULL);
		tsim_on_log(sim, NULL, NULL);
	}
	return TSIM_OK;
}
