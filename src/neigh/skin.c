/* How far beyond contact neighbours are looked for: it decides the cost, and nothing else. */
#include <math.h>

#include "core/settings.h"
#include "neigh/limits.h"
#include "neigh/neigh.h"
#include "neigh/wall.h"
#include "particles/domain.h"
#include "particles/mesh_surface.h"
#include "particles/particles.h"

#include "base/banned.h"

static void radii(const struct ts_particles *p, double *least, double *most)
{
	*least = INFINITY;
	*most = 0;
	for (size_t i = 0; i < p->n; i++) {
		*least = p->radius[i] < *least ? p->radius[i] : *least;
		*most = p->radius[i] > *most ? p->radius[i] : *most;
	}
}

double ts_neigh_skin(const struct tsim *sim)
{
	double least, most;

	if (sim->neigh->skin > 0)
		return sim->neigh->skin;
	radii(sim->particles, &least, &most);
	return sim->particles->n ? fmax(0.4 * least, 0.05 * most) : 1;
}

/* What else than particles has moved since the last rebuild, or will, and uses up the skin with them. */
static bool surroundings_move(const struct tsim *sim)
{
	bool move = ts_domain_moved(sim->domain) > 0;
	const struct ts_instance *mesh;
	const struct ts_wall *wall;

	for (size_t k = 0; (wall = ts_walls_next(sim, &k, NULL));)
		move |= wall->moves;
	for (size_t k = 0; (mesh = ts_sim_next_of(sim, TS_KIND_FIX, TS_FAMILY_MESH, &k));)
		move |= ((const struct ts_mesh_surface *)mesh->state)->travelled > 0;
	return move;
}

/* With a skin s a dense bed has 10 s/d rows a particle that do not touch, each to be looked at in every step; and
 * a rebuild, which costs as much as `REBUILD` such looks a particle, is due after s/2 at the speed v. Least of
 * 10 s/d + REBUILD 2 v dt/s: s = sqrt(REBUILD/5 v dt d). */
enum { REBUILD = 30 };
/* Where everything rests now, it may begin to move. */
static const double LEAST = 0.02; /* of the smallest radius */

double ts_neigh_choose_skin(const struct tsim *sim)
{
	const struct ts_particles *p = sim->particles;
	double skin = ts_neigh_skin(sim), least, most, best;

	/* what waits for a rebuild, as in LIGGGHTS: contacts that end and are remembered, particles that have left */
	if (sim->legacy || sim->neigh->fixed_skin || sim->neigh->skin_counts ||
	    p->lost_policy == TS_LOST_IGNORE || !p->n || surroundings_move(sim))
		return skin;
	radii(p, &least, &most);
	best = sqrt(REBUILD / 5.0 * ts_fastest(sim, 0) * sim->clock.dt * 2 * least);
	return fmin(skin, fmax(best, LEAST * least));
}
