#include "wall/wall_system.h"

#include "neigh/neigh.h"
#include "wall/loss.h"
#include "wall/wall.h"
#include "wall/wall_multicontact.h"

#include "base/banned.h"

static bool walls_move(const struct tsim *sim)
{
	const struct ts_wall *wall;
	bool move = false;

	for (size_t k = 0; (wall = ts_walls_next(sim, &k, NULL));)
		move |= wall->moves;
	return move;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	(void)self;
	sim->neigh->ask.walls_move = walls_move;
	sim->neigh->multicontact_walls = &ts_wall_multicontact;
	sim->particles->explain_loss = ts_explain_loss;
	return TS_OK;
}

const struct ts_system_style ts_walls_system = {
	.style = { .name = "walls",
		   .kind = TS_KIND_SYSTEM,
		   .summary = "what others ask of all walls",
		   .init = init },
};
