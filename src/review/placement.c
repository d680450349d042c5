/* Checks of the review: walls that cannot be touched, missing floors, meshes smaller than particles. */
#include "review/internal.h"

#include <math.h>

#include "bond/bonds.h"
#include "box/domain.h"
#include "core/ranks.h"
#include "force/gravity.h"
#include "integrate/integrators.h"
#include "mesh/mesh_motion.h"
#include "mesh/mesh_surface.h"
#include "particle/division.h"
#include "wall/primitive_wall.h"

#include "base/banned.h"

/* ---- walls outside the box ---- */

static bool has_fixed_faces(const struct ts_box *box, int dim)
{
	return box->face[dim][0] == TS_FACE_FIXED && box->face[dim][1] == TS_FACE_FIXED;
}

/* Distance of the wall from the nearest point of the box; 0: the wall intersects it. */
static double distance_to_box(const struct ts_box *box, const struct ts_primitive *wall)
{
	int shape = (int)wall->shape, a = (shape + 1) % 3, b = (shape + 2) % 3;
	double near2 = 0, far2 = 0;

	if (shape <= TS_ZPLANE)
		return fmax(0, fmax(box->lo[shape] - wall->position, wall->position - box->hi[shape]));
	for (int k = 0; k < 2; k++) {
		int dim = k ? b : a;
		double below = box->lo[dim] - wall->centre[k], above = box->hi[dim] - wall->centre[k];
		double near = fmax(0, fmax(below, -above)), far = fmax(fabs(below), fabs(above));

		near2 += near * near;
		far2 += far * far;
	}
	return fmax(0, fmax(sqrt(near2) - wall->radius, wall->radius - sqrt(far2)));
}

/* Whether the faces that particles would cross to reach the wall are fixed. */
static bool is_normal_to_fixed_faces(const struct ts_box *box, const struct ts_primitive *wall)
{
	int shape = (int)wall->shape;

	return shape <= TS_ZPLANE
		       ? has_fixed_faces(box, shape)
		       : has_fixed_faces(box, (shape + 1) % 3) && has_fixed_faces(box, (shape + 2) % 3);
}

/* Radius of the largest particle, of all ranks; without particles an upper bound, the length of the box. */
static double largest_radius(const struct tsim *sim)
{
	const struct ts_particles *p = sim->particles;
	double most = 0;

	for (size_t i = 0; i < p->n; i++)
		most = fmax(most, p->radius[i]);
	most = ts_ranks_most(sim, most);
	for (int dim = 0; dim < 3 && !(most > 0); dim++)
		most = fmax(most, ts_box_length(&sim->domain->box, dim));
	return most;
}

static enum ts_status check_primitives(struct tsim *sim, const struct ts_instance *by,
				       const struct ts_primitive_wall *w, double radius)
{
	const struct ts_box *box = &sim->domain->box;

	for (int k = 0; k < w->n && !ts_primitive_wall_moves(w); k++) {
		double gap = distance_to_box(box, &w->primitive[k]);

		if (gap > radius && is_normal_to_fixed_faces(box, &w->primitive[k]))
			return ts_review_report(sim, "reach", &by->where,
						"this wall is at distance %g from the box (%g %g %g) to (%g "
						"%g %g) and no particle can touch it: particles are lost at "
						"the fixed faces of the box; check the units, or enlarge the "
						"box",
						gap, box->lo[0], box->lo[1], box->lo[2], box->hi[0],
						box->hi[1], box->hi[2]);
	}
	return TS_OK;
}

enum ts_status ts_review_reach(struct tsim *sim)
{
	const struct ts_instance *by;
	const struct ts_wall *w;
	double radius = largest_radius(sim);

	for (size_t k = 0; (w = ts_walls_next(sim, &k, &by));)
		if (ts_primitive_wall_of(w))
			TS_TRY(check_primitives(sim, by, ts_primitive_wall_of(w), radius));
	return TS_OK;
}

/* ---- gravity without a floor ---- */

/* Particles that fall out of the box during the run, and the bounding box of the space that they may
 * sweep. */
struct fall {
	size_t n;
	double time;	     /* of the run */
	double lo[3], hi[3]; /* length */
};

static void add_path(const struct tsim *sim, size_t i, const double g[3], int dim, struct fall *fall)
{
	const struct ts_particles *p = sim->particles;
	double radius = p->radius[i], t = fall->time;

	for (int k = 0; k < 3; k++) {
		double aside = k == dim ? 0 : fabs(p->v[i][k]) * t + 0.5 * fabs(g[k]) * t * t;

		fall->lo[k] = fmin(fall->lo[k], p->x[i][k] - radius - aside);
		fall->hi[k] = fmax(fall->hi[k], p->x[i][k] + radius + aside);
	}
	fall->n++;
}

/* The particles of all ranks together. */
static void merge_falls(const struct tsim *sim, struct fall *fall)
{
	double most[6];

	for (int k = 0; k < 3; k++) {
		most[k] = -fall->lo[k];
		most[3 + k] = fall->hi[k];
	}
	ts_ranks_most_of(sim, most, 6);
	for (int k = 0; k < 3; k++) {
		fall->lo[k] = -most[k];
		fall->hi[k] = most[3 + k];
	}
	fall->n = (size_t)ts_division_sum(sim, (int64_t)fall->n);
}

/* Free fall along dim, with acceleration g, for the time of the run. */
static struct fall free_fall(const struct tsim *sim, const struct ts_instance *by, int dim, const double g[3])
{
	const struct ts_particles *p = sim->particles;
	const struct ts_box *box = &sim->domain->box;
	uint32_t moved = ts_integrated_groups(sim, TS_MOVES);
	struct fall fall = { .time = (double)sim->review.steps * sim->clock.dt,
			     .lo = { INFINITY, INFINITY, INFINITY },
			     .hi = { -INFINITY, -INFINITY, -INFINITY } };

	for (size_t i = 0; i < p->n; i++) {
		double end = p->x[i][dim] + (p->v[i][dim] + 0.5 * g[dim] * fall.time) * fall.time;

		if ((p->mask[i] & moved) && ts_in_group(p, i, by->group) &&
		    (g[dim] < 0 ? end < box->lo[dim] : end > box->hi[dim]))
			add_path(sim, i, g, dim, &fall);
	}
	merge_falls(sim, &fall);
	if (g[dim] < 0)
		fall.lo[dim] = fmin(fall.lo[dim], box->lo[dim] - largest_radius(sim));
	else
		fall.hi[dim] = fmax(fall.hi[dim], box->hi[dim] + largest_radius(sim));
	return fall;
}

/* Whether a mesh may stop a falling particle: it intersects the swept space (periodic directions always
 * count), or it moves. */
static bool mesh_may_stop(const struct tsim *sim, const struct ts_instance *by, const struct fall *fall)
{
	const struct ts_mesh_surface *s = by->state;
	double lo[3], hi[3];
	bool meets = true;
	size_t first = 0;

	if (by->style->hook
		    [TS_STAGE_INITIAL_INTEGRATE] || /* the mesh moves by itself, or some fix moves meshes */
	    ts_sim_next_of(sim, TS_KIND_FIX, TS_FAMILY_MESH_MOVER, &first))
		return true;
	ts_mesh_bounds(&s->mesh, lo, hi);
	for (int k = 0; k < 3; k++)
		meets &= ts_box_periodic(&sim->domain->box, k) ||
			 (hi[k] >= fall->lo[k] && lo[k] <= fall->hi[k]);
	return meets;
}

/* Whether a wall may stop particles that fall along dim: planes normal to dim within the swept space,
 * cylinders whose axis is not dim, meshes, regions. */
static bool wall_may_stop(const struct tsim *sim, const struct ts_wall *w, int dim, const struct fall *fall)
{
	const struct ts_primitive_wall *p = ts_primitive_wall_of(w);
	size_t n = p ? 0 : ts_wall_surfaces(w);
	bool stops = false;

	for (size_t k = 0; k < n; k++) {
		const struct ts_instance *by = ts_wall_surface(w, k);

		stops |= !ts_streq(by->style->family, TS_FAMILY_MESH) || mesh_may_stop(sim, by, fall);
	}
	for (int k = 0; p && k < p->n; k++) {
		int shape = (int)p->primitive[k].shape;
		double at = p->primitive[k].position;

		stops |= shape >= TS_XCYLINDER
				 ? shape % 3 != dim
				 : shape == dim && (ts_primitive_wall_moves(p) ||
						    (at >= fall->lo[dim] && at <= fall->hi[dim]));
	}
	return stops;
}

static bool any_may_stop(const struct tsim *sim, int dim, const struct fall *fall)
{
	const struct ts_particles *p = sim->particles;
	const struct ts_wall *w;
	bool held = false;

	for (size_t k = 0; (w = ts_walls_next(sim, &k, NULL));)
		if (wall_may_stop(sim, w, dim, fall))
			return true;
	for (size_t i = 0; i < p->n; i++)
		held |= !(p->imass[i] > 0);
	return ts_ranks_most(sim, held) > 0;
}

/* Fixes other than gravity and walls that add forces, bonds, fluids and host programs may keep particles from
 * falling. */
static bool has_other_forces(const struct tsim *sim)
{
	const struct ts_instances *fixes = &sim->instances[TS_KIND_FIX];
	bool lifts = sim->instances[TS_KIND_FLOW].n > 0 || sim->outside || sim->bonds->n > 0;

	for (size_t k = 0; k < fixes->n; k++) {
		const struct ts_style *style = fixes->item[k]->style;
		const char *family = style->family;
		bool known =
			family && (ts_streq(family, TS_FAMILY_GRAVITY) || ts_streq(family, TS_FAMILY_WALL));

		lifts |= !known && style->hook[TS_STAGE_POST_FORCE] != NULL;
	}
	return lifts;
}

static enum ts_status check_floor(struct tsim *sim, const struct ts_instance *by, int dim, const double g[3])
{
	const struct ts_particles *p = sim->particles;
	const struct ts_box *box = &sim->domain->box;
	struct fall fall = free_fall(sim, by, dim, g);

	if (!fall.n || any_may_stop(sim, dim, &fall))
		return TS_OK;
	return ts_review_report(sim, "floor", &by->where,
				"gravity acts towards the fixed face %c%s without a wall, mesh or fixed "
				"particle below: in the time %g of this run %zu of %zu particles leave the "
				"box; add `fix ID all wall/gran primitive type 1 %cplane %g`, or use "
				"`thermo_modify lost ignore`",
				'x' + dim, g[dim] < 0 ? "lo" : "hi", fall.time, fall.n, p->n, 'x' + dim,
				g[dim] < 0 ? box->lo[dim] : box->hi[dim]);
}

enum ts_status ts_review_floor(struct tsim *sim)
{
	const struct ts_instance *by;

	if (sim->review.stale || sim->particles->lost_policy == TS_LOST_IGNORE || has_other_forces(sim))
		return TS_OK;
	for (size_t k = 0; (by = ts_sim_next_of(sim, TS_KIND_FIX, TS_FAMILY_GRAVITY, &k));) {
		const struct ts_gravity *g = by->state;

		double pull[3];

		ts_scale(g->magnitude.value, g->direction, pull);
		for (int dim = 0; dim < sim->dimension && !g->magnitude.variable; dim++) {
			bool down = pull[dim] < 0;

			if (fabs(g->direction[dim]) > 0.1 &&
			    sim->domain->box.face[dim][!down] == TS_FACE_FIXED)
				TS_TRY(check_floor(sim, by, dim, pull));
		}
	}
	return TS_OK;
}

/* ---- meshes smaller than a particle ---- */

enum ts_status ts_review_mesh_size(struct tsim *sim)
{
	const struct ts_particles *p = sim->particles;
	const struct ts_mesh_surface *s;
	struct ts_instance *by;
	double least = INFINITY;

	for (size_t i = 0; i < p->n; i++)
		least = fmin(least, p->radius[i]);
	for (size_t k = 0; p->n && (s = ts_mesh_surface_next(sim, &k, &by));) {
		double lo[3], hi[3], size = 0;

		ts_mesh_bounds(&s->mesh, lo, hi);
		for (int dim = 0; dim < 3; dim++)
			size = fmax(size, hi[dim] - lo[dim]);
		if (size < 0.2 * least)
			TS_TRY(ts_review_report(sim, "mesh_size", &by->where,
						"mesh %s has the length %g, less than a tenth of the "
						"smallest particle diameter %g; check the units of its file, "
						"and `scale`",
						by->id, size, 2 * least));
	}
	return TS_OK;
}
