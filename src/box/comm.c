#include "box/comm.h"

#include "core/group.h"

#include "base/banned.h"

const char *const ts_comm_modes[] = { "single", "multi", "multi/old", NULL };

enum ts_status ts_comm_accept(struct tsim *sim, const struct ts_comm *comm, const struct ts_place *where)
{
	sim->still_ghosts = !comm->velocity;
	if (!comm->group)
		return TS_OK;
	where = ts_sim_word_of(sim, ts_group_name(sim, comm->group), where);
	return ts_fail(&sim->error, TS_RANGE, where,
		       "images of group %s alone would lose contacts of the others across periodic faces; "
		       "leave `group` out, or let particles pass through each other by neigh_modify include "
		       "or exclude",
		       ts_group_name(sim, comm->group));
}
