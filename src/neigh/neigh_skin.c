/* The skin: it affects the cost of a run and, without `legacy`, nothing else but the rounding of positions that are wrapped
 * across periodic faces, at the steps of rebuilds. */
#include <math.h>

#include "base/clones.h"
#include "box/domain.h"
#include "core/ranks.h"
#include "core/settings.h"
#include "math/vec3.h"
#include "mesh/mesh_surface.h"
#include "neigh/leaving.h"
#include "neigh/neigh.h"

#include "base/banned.h"

TS_CLONES static void bound_radii(const double *restrict radius, size_t n, double bounds[2])
{
	double least = INFINITY, most = 0;

#pragma omp simd reduction(min : least) reduction(max : most)
	for (size_t i = 0; i < n; i++) {
		least = radius[i] < least ? radius[i] : least;
		most = radius[i] > most ? radius[i] : most;
	}
	bounds[0] = least;
	bounds[1] = most;
}

void ts_neigh_radii(const struct tsim *sim, double *least, double *most)
{
	double bounds[2];

	bound_radii(sim->particles->radius, sim->particles->n, bounds);
	bounds[0] = -bounds[0];
	ts_ranks_most_of(sim, bounds, 2);
	*least = -bounds[0];
	*most = bounds[1];
}

double ts_neigh_skin(const struct tsim *sim)
{
	double least, most;

	if (sim->neigh->skin > 0)
		return sim->neigh->skin;
	ts_neigh_radii(sim, &least, &most);
	return most > 0 ? fmax(0.4 * least, 0.05 * most) : 1;
}

/* Whether something other than particles has moved since the last rebuild, or will move, and so uses up the
 * skin. */
static bool boundaries_move(const struct tsim *sim)
{
	bool move = ts_domain_moved(sim->domain) > 0 || sim->neigh->callback.walls_move(sim);
	const struct ts_instance *mesh;

	for (size_t k = 0; (mesh = ts_sim_next_of(sim, TS_KIND_FIX, TS_FAMILY_MESH, &k));)
		move |= ((const struct ts_mesh_surface *)mesh->state)->travelled > 0;
	return move;
}

/* Let the fastest particle move u = v dt per step; d is the smallest diameter, s the skin. A rebuild is due
 * every s/(2 u) steps. The about 10 s/d pairs per particle that do not touch are computed only in a part of
 * the steps, the fewer the slower the particles are (choose_inner_skin in active_pairs.c). The total cost is
 * least at about s = SKIN_BEST d (u/d)^(1/4) and varies little below it. As pairs take memory, the skin is
 * smaller than that, sqrt(SKIN_MEMORY u d), where rebuilds are rare, and at most the given one; but where a
 * rebuild would be due within REBUILD_STEPS steps, it is larger. */
static const double SKIN_BEST = 1.6, SKIN_MEMORY = 6;
enum { REBUILD_STEPS = 80 };
/* lower bound, in units of the smallest radius: particles at rest now may begin to move */
static const double SKIN_LEAST = 0.02;

static double skin_for_rare_rebuilds(double displacement, double least_radius)
{
	return fmax(sqrt(SKIN_MEMORY * displacement * 2 * least_radius), SKIN_LEAST * least_radius);
}

static double skin_for_fast_particles(double displacement, double least_radius)
{
	double size = 2 * least_radius;

	return fmin(2 * REBUILD_STEPS * displacement, SKIN_BEST * size * pow(displacement / size, 0.25));
}

/* Whether some effects occur only at rebuilds, as in LIGGGHTS: the end of the history of parted contacts, and the
 * deletion of particles that have left. */
static bool rebuilds_are_visible(const struct tsim *sim)
{
	return sim->legacy == TS_LEGACY_LIGGGHTS || sim->neigh->fixed_skin || sim->neigh->skin_observed ||
	       (sim->particles->lost_policy == TS_LOST_IGNORE && !ts_leaving_apart(sim));
}

/* The skin, length, for the displacement per step of the fastest particle. Fast particles have a larger one, which may be
 * larger than given, only if all faces are fixed: at other faces the steps of rebuilds are visible (particles are wrapped, which
 * rounds; faces are shrink-wrapped). */
static double choose_skin(const struct tsim *sim, double displacement, bool walls_move)
{
	double given = sim->neigh->given_skin, least = sim->neigh->least_radius;
	double skin = fmin(skin_for_rare_rebuilds(displacement, least), given);
	bool ignores_lost = sim->particles->lost_policy == TS_LOST_IGNORE;

	if (ts_domain_all_fixed(sim))
		skin = fmax(skin, skin_for_fast_particles(displacement, least));
	if (skin <= given)
		return walls_move || ignores_lost ? given : skin;
	return walls_move && ignores_lost ? ts_leaving_skin(given, skin) : skin;
}

/* A frame that moves needs a watch (leaving.h), which costs as much as a rebuild in about this number of steps. */
enum { WATCH_STEPS = 100 };

void ts_neigh_choose_skin(struct tsim *sim, double largest_radius)
{
	struct ts_neigh *nb = sim->neigh;
	struct ts_drift_frame_speeds speeds;
	bool walls_move, watched = sim->run.relist && nb->leaving_watched;
	double dt = sim->clock.dt;

	nb->frame = (struct ts_drift_frame){ .shift = { 0 } };
	nb->built_skin = nb->given_skin;
	nb->leaving_watched = false;
	ts_drift_frame_speeds(sim, &speeds);
	ts_scale(1, speeds.centre, nb->mean_velocity);
	if (rebuilds_are_visible(sim) || !(largest_radius > 0))
		return;
	walls_move = boundaries_move(sim);
	if (!walls_move && ts_domain_all_fixed(sim) && ts_drift_frame_pays(&speeds) &&
	    2 * WATCH_STEPS * speeds.most * dt > nb->built_skin)
		ts_scale(1, speeds.centre, nb->frame.velocity);
	nb->built_skin =
		choose_skin(sim, dt * (ts_norm(nb->frame.velocity) > 0 ? speeds.most_relative : speeds.most),
			    walls_move);
	nb->leaving_watched = ts_leaving_apart(sim) &&
			      (watched || ts_norm(nb->frame.velocity) > 0 || nb->built_skin > nb->given_skin);
}
