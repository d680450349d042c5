#include "wall/wall_system.h"

#include "neigh/neigh.h"
#include "wall/wall_flight.h"
#include "wall/wall_loss.h"
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

static void connect_walls(struct tsim *sim)
{
	sim->neigh->callback.walls_move = walls_move;
	sim->neigh->multicontact_walls = &ts_wall_multicontact;
	sim->particles->explain_loss = ts_wall_explain_loss;
	sim->particles->find_missed_wall = ts_wall_flight;
}

const struct ts_system_style ts_walls_system = {
	.style = { .name = "walls",
		   .kind = TS_KIND_SYSTEM,
		   .summary = "functions of all walls that other parts call" },
	.no_instance = true,
	.connect = connect_walls,
};
