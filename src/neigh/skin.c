/* How far beyond contact neighbours are looked for: it decides the cost, and nothing else. */
#include <math.h>

#include "box/domain.h"
#include "core/settings.h"
#include "mesh/mesh_surface.h"
#include "neigh/leaving.h"
#include "neigh/neigh.h"
#include "particle/prescribed.h"

#include "base/banned.h"

void ts_neigh_radii(const struct ts_particles *p, double *least, double *most)
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
	ts_neigh_radii(sim->particles, &least, &most);
	return sim->particles->n ? fmax(0.4 * least, 0.05 * most) : 1;
}

/* What else than particles has moved since the last rebuild, or will, and uses up the skin with them. */
static bool surroundings_move(const struct tsim *sim)
{
	bool move = ts_domain_moved(sim->domain) > 0 || sim->neigh->ask.walls_move(sim);
	const struct ts_instance *mesh;

	for (size_t k = 0; (mesh = ts_sim_next_of(sim, TS_KIND_FIX, TS_FAMILY_MESH, &k));)
		move |= ((const struct ts_mesh_surface *)mesh->state)->travelled > 0;
	return move;
}

/* Where a particle goes v dt in a step, a rebuild is due after s/2. Rows that do not touch, 10 s/d a
 * particle in a dense bed, are looked at in a part of the steps only, the rarer the slower particles are
 * (see choose_inner_skin in active_pairs.c): the sum of rebuilds and looks is least about BEST d (v
 * dt/d)^(1/4), and changes little below. As rows take memory, the skin is smaller than that, sqrt(ROWS v
 * dt d), where rebuilds are seldom, and never more than the one given; but where one would be due every
 * few steps, it is larger. */
static const double BEST = 1.6, ROWS = 6;
enum { SELDOM = 40 };
/* Where everything rests now, it may begin to move. */
static const double LEAST = 0.02; /* of the smallest radius */

/* At other faces rebuilds do what can be seen, particles are wrapped and faces fitted: if they are more
 * seldom than with the skin given, this is a surprise. */
static double quick_skin(const struct tsim *sim, double skin, double pace, double size)
{
	double quick = fmin(2 * SELDOM * pace, BEST * size * pow(pace / size, 0.25));

	if (!ts_domain_all_fixed(sim) || quick <= skin)
		return 0;
	return sim->particles->lost_policy == TS_LOST_IGNORE ? ts_leaving_skin(skin, quick) : quick;
}

double ts_neigh_choose_skin(const struct tsim *sim)
{
	const struct ts_particles *p = sim->particles;
	double skin = ts_neigh_skin(sim), least, most, pace, small;
	bool waits = p->lost_policy == TS_LOST_IGNORE;

	/* what waits for a rebuild, as in LIGGGHTS: contacts that end and are remembered, particles that
	 * have left */
	if (sim->legacy || sim->neigh->fixed_skin || sim->neigh->skin_counts ||
	    (waits && !ts_leaving_apart(sim)) || !p->n)
		return skin;
	ts_neigh_radii(p, &least, &most);
	pace = ts_prescribed_max_speed(sim, 0) * sim->clock.dt;
	small = sqrt(ROWS * pace * 2 * least);
	small = waits || surroundings_move(sim) ? skin : fmin(skin, fmax(small, LEAST * least));
	return fmax(small, quick_skin(sim, skin, pace, 2 * least));
}
