#include "limits/tunnelling.h"

#include <math.h>
#include <stdio.h>

#include "bond/bonds.h"
#include "box/domain.h"
#include "contact/pair.h"
#include "core/ranks.h"
#include "geom/box_images.h"
#include "geom/spherehash.h"
#include "impact/exact_impacts.h"
#include "mesh/mesh_distance.h"
#include "mesh/mesh_surface.h"
#include "neigh/neigh.h"
#include "neigh/runaways.h"
#include "particle/division.h"
#include "particle/exchange.h"
#include "particle/particles.h"
#include "wall/wall.h"

#include "base/banned.h"

/* ---- other particles ---- */

/* Smallest distance of the origin from the segment from m - d/2 to m + d/2. */
static double distance_to_segment(const double m[3], const double d[3])
{
	double d2 = ts_dot(d, d), t = d2 > 0 ? -ts_dot(m, d) / d2 : 0, x[3];

	t = fmax(-0.5, fmin(0.5, t));
	ts_scale(1, m, x);
	ts_axpy(t, d, x);
	return ts_norm(x);
}

/* Whether a contact of i and j has a force; d: vector from j to i. */
static bool have_contact_law(const struct tsim *sim, size_t i, size_t j, const double d[3])
{
	ts_excluded_fn *excluded = ts_neigh_excluded(sim);

	return ts_pair_interact(sim, i, j) && !(excluded && excluded(sim, i, j, d));
}

/* Whether i, moving relative to j along a segment longer than its radius, comes nearer than the sum of the
 * radii plus `reach`; or stretches a bond with j. */
static bool hits_other(const struct tsim *sim, size_t i, size_t j, double reach)
{
	const struct ts_particles *p = sim->particles;
	double path[3], d[3], middle[3], sum = p->radius[i] + p->radius[j] + reach;

	ts_sub(p->v[i], p->v[j], path);
	ts_scale(sim->clock.dt, path, path);
	if (!(ts_dot(path, path) > p->radius[i] * p->radius[i]))
		return false;
	ts_sub(p->x[i], p->x[j], d);
	ts_box_nearest(&sim->domain->box, d);
	ts_scale(1, d, middle);
	ts_axpy(-0.5, path, middle);
	if (!(distance_to_segment(middle, path) > sum) && have_contact_law(sim, i, j, d))
		return true;
	return sim->bonds->n && ts_bonds_has(sim->bonds, p->tag[i], p->tag[j]);
}

/* The paths of all particles in the step, each within a sphere around its middle; particles that meet are in spheres
 * that overlap. */
struct paths {
	bool listed; /* else all particles are looked at */
	struct ts_spherehash sphere;
	double reach; /* of attraction */
};

/* A list is made for so many fast particles: to make it costs as much as to look at all particles for each of them. */
enum { MANY = 16 };

static void middle_of_path(const struct tsim *sim, size_t i, double x[3])
{
	ts_scale(1, sim->particles->x[i], x);
	ts_axpy(-0.5 * sim->clock.dt, sim->particles->v[i], x);
}

/* With more than the rounding of positions. */
static double path_radius(const struct tsim *sim, size_t i)
{
	const struct ts_particles *p = sim->particles;

	return (1 + 1e-9) * (0.5 * sim->clock.dt * ts_norm(p->v[i]) + p->radius[i]);
}

static bool interact(const struct tsim *sim)
{
	return sim->neigh->wanted || sim->bonds->n;
}

static enum ts_status list_paths(struct tsim *sim, size_t fast, struct paths *paths)
{
	const struct ts_particles *p = sim->particles;
	double least, largest;

	/* a bond may be longer than any reach */
	*paths = (struct paths){ .listed = sim->neigh->wanted && !sim->bonds->n && fast >= MANY };
	ts_neigh_radii(sim, &least, &largest); /* of all ranks */
	paths->reach = sim->neigh->wanted ? ts_pair_reach(sim, largest) : 0;
	for (size_t i = 0; paths->listed && i < p->n; i++) {
		double x[3];

		middle_of_path(sim, i, x);
		if (ts_spherehash_add(&paths->sphere, x, path_radius(sim, i)) != TS_OK)
			return ts_nomem(&sim->error);
	}
	return TS_OK;
}

/* The partner of the least identity that i hits. */
struct partner {
	const struct tsim *sim;
	const struct paths *paths;
	size_t i;
	double found; /* its identity; infinite: none */
};

static bool try_partner(void *context, size_t j)
{
	struct partner *s = context;

	if (j != s->i && s->sim->particles->tag[j] < s->found && hits_other(s->sim, s->i, j, s->paths->reach))
		s->found = s->sim->particles->tag[j];
	return false;
}

static double find_partner(const struct tsim *sim, const struct paths *paths, size_t i)
{
	const struct ts_box *box = &sim->domain->box;
	double radius = path_radius(sim, i) + paths->reach, x[3], image[3];
	/* a path may end outside of the box, where the particle is wrapped at the next rebuild */
	double far = radius + 3 * ts_spherehash_largest(&paths->sphere) + sim->neigh->built_skin;
	struct partner s = { sim, paths, i, INFINITY };

	if (!interact(sim))
		return INFINITY;
	middle_of_path(sim, i, x);
	for (int k = 0; paths->listed && k < 27; k++)
		if (ts_box_image(box, x, k, far, image))
			ts_spherehash_visit(&paths->sphere, image, radius, try_partner, &s);
	for (size_t j = 0; !paths->listed && j < sim->particles->n; j++)
		try_partner(&s, j);
	return s.found;
}

/* ---- surfaces: sphere tracing; the sphere advances by its gap to the surface until the gap vanishes or the
 * path ends */

typedef double gap_fn(const struct tsim *sim, const void *surface, const double x[3]);

/* Gaps below this fraction of the radius count as zero; along a surface that stays near, the number of steps
 * is bounded. */
static const double GAP_NEGLIGIBLE = 0.01;
enum { STEPS_MOST = 10000 };

static bool reaches_surface(const struct tsim *sim, size_t i, const double end[3], gap_fn *gap,
			    const void *surface)
{
	const struct ts_particles *p = sim->particles;
	double path = ts_norm(p->v[i]) * sim->clock.dt, gone = 0, radius = p->radius[i];

	for (int n = 0; n < STEPS_MOST; n++) {
		double x[3], free;

		ts_scale(1, end, x);
		ts_axpy((gone / path - 1) * sim->clock.dt, p->v[i], x);
		free = gap(sim, surface, x) - radius;
		if (!(free > GAP_NEGLIGIBLE * radius))
			return true;
		if (gone >= path)
			return false;
		gone = fmin(path, gone + free);
	}
	return true;
}

/* The same for all images across periodic faces. */
static bool meets_surface(const struct tsim *sim, size_t i, gap_fn *gap, const void *surface)
{
	const struct ts_particles *p = sim->particles;
	double reach = ts_norm(p->v[i]) * sim->clock.dt + 2 * p->radius[i], end[3];

	for (int k = 0; k < 27; k++)
		if (ts_box_image(&sim->domain->box, p->x[i], k, reach, end) &&
		    reaches_surface(sim, i, end, gap, surface))
			return true;
	return false;
}

static double gap_of_wall(const struct tsim *sim, const void *surface, const double x[3])
{
	const struct ts_wall *w = surface;

	return w->shape->gap(w, sim, x);
}

/* The largest displacement of a corner of this triangle in a step. */
static double travel_of_triangle(const struct tsim *sim, const struct ts_mesh_surface *s, size_t t)
{
	double most = 0;

	for (int k = 0; s->v && k < 3; k++)
		most = fmax(most, ts_norm(s->v[t][k]));
	return most * sim->clock.dt;
}

/* Distance from the mesh minus the displacement of the corners in a step. */
static double gap_of_mesh(const struct tsim *sim, const void *surface, const double x[3])
{
	const struct ts_mesh_surface *s = surface;
	double least = INFINITY;

	for (size_t t = 0; t < s->mesh.n; t++)
		least = fmin(least, ts_mesh_distance(&s->mesh, t, x) - travel_of_triangle(sim, s, t));
	return least;
}

/* The same as meets_surface for the images of a mesh, which may be far from the box. */
static bool meets_mesh(const struct tsim *sim, size_t i, const struct ts_mesh_surface *s)
{
	const struct ts_particles *p = sim->particles;
	const struct ts_box *box = &sim->domain->box;
	double way = ts_norm(p->v[i]) * sim->clock.dt, most = 0, lo[3], hi[3], end[3];
	struct ts_box_images images;

	for (size_t t = 0; t < s->mesh.n; t++)
		most = fmax(most, travel_of_triangle(sim, s, t));
	ts_mesh_bounds(&s->mesh, lo, hi);
	images = ts_box_images(box, lo, hi, p->x[i], p->x[i],
			       ts_box_images_way(box, way + most) + 2 * p->radius[i]);
	while (ts_box_images_next(&images)) {
		ts_box_images_place(box, images.shift, p->x[i], end);
		if (reaches_surface(sim, i, end, gap_of_mesh, s))
			return true;
	}
	return false;
}

static bool hits_wall(struct tsim *sim, size_t i, char *what, size_t room)
{
	const struct ts_instance *by;
	const struct ts_wall *w;

	for (size_t k = 0; (w = ts_walls_next(sim, &k, &by));) {
		if (!ts_wall_interacts(by, sim, i, false) || ts_exact_passes(w, sim->particles->tag[i]))
			continue;
		if (w->shape->gap && meets_surface(sim, i, gap_of_wall, w)) {
			snprintf(what, room, " past wall %.60s", by->id);
			return true;
		}
	}
	return false;
}

/* Whether a wall made of this mesh has carried the particle through what it met. */
static bool is_exact(const struct tsim *sim, const struct ts_instance *mesh, size_t i)
{
	const struct ts_instance *by;
	const struct ts_wall *w;

	for (size_t at = 0; (w = ts_walls_next(sim, &at, &by));)
		if (ts_exact_passes(w, sim->particles->tag[i]) && ts_wall_interacts(by, sim, i, false) &&
		    ts_wall_find_surface(w, mesh) != SIZE_MAX)
			return true;
	return false;
}

/* All meshes, also those without contact forces: particles that pass some of them are counted. */
static bool hits_mesh(struct tsim *sim, size_t i, char *what, size_t room)
{
	const struct ts_mesh_surface *s;
	struct ts_instance *by;

	for (size_t k = 0; (s = ts_mesh_surface_next(sim, &k, &by));) {
		if (is_exact(sim, by, i) || !meets_mesh(sim, i, s))
			continue;
		snprintf(what, room, " past mesh %.60s", by->id);
		return true;
	}
	return false;
}

/* ---- the box ---- */

/* Whether it has moved so far that periodic images are ambiguous, or has left the box while lost particles are not
 * ignored. */
static bool leaves_box(const struct tsim *sim, size_t i, char *what, size_t room)
{
	const struct ts_particles *p = sim->particles;
	const struct ts_box *box = &sim->domain->box;
	bool far = false;

	for (int k = 0; k < 3; k++)
		far |= ts_box_periodic(box, k) &&
		       fabs(p->v[i][k]) * sim->clock.dt > 0.25 * ts_box_length(box, k);
	if (far || p->lost_policy == TS_LOST_IGNORE || ts_exchange_left(box, p->x[i]) < 0)
		return far;
	snprintf(what, room, " out of the box (`thermo_modify lost ignore` lets free particles leave)");
	return true;
}

/* ---- of all ranks */

/* What the fast particles of all ranks meet. Walls, meshes and faces are the same on all of them: the rank of the particle looks
 * at these. Others are met among the own particles and the fast ones. */
struct search {
	struct paths paths;
	size_t own;	 /* the particles from here on are of other ranks */
	size_t *fast, n; /* indices */
};

static bool hits_boundary(struct tsim *sim, size_t i, char *what, size_t room)
{
	return hits_wall(sim, i, what, room) || hits_mesh(sim, i, what, room);
}

/* The fast particle of the least identity that hits anything; SIZE_MAX: none. */
static size_t find_first(struct tsim *sim, const struct search *s)
{
	const int32_t *tag = sim->particles->tag;
	double least = INFINITY;
	char what[100];

	for (size_t k = 0; k < s->n; k++) {
		size_t i = s->fast[k];
		bool own = i < s->own;

		if (tag[i] < least && ((own && leaves_box(sim, i, what, sizeof what)) ||
				       isfinite(find_partner(sim, &s->paths, i)) ||
				       (own && hits_boundary(sim, i, what, sizeof what))))
			least = tag[i];
	}
	least = -ts_ranks_most(sim, -least);
	for (size_t k = 0; k < s->n; k++)
		if (tag[s->fast[k]] == least)
			return s->fast[k];
	return SIZE_MAX;
}

static void find_hit(struct tsim *sim, const struct search *s, size_t *hit, char *what, size_t room)
{
	size_t first = find_first(sim, s);
	double partner = first == SIZE_MAX ? INFINITY : find_partner(sim, &s->paths, first);

	partner = -ts_ranks_most(sim, -partner);
	what[0] = 0;
	if (first == SIZE_MAX || first >= s->own)
		return;
	*hit = first;
	if (leaves_box(sim, first, what, room))
		return;
	if (isfinite(partner))
		snprintf(what, room, " past particle %d", (int)partner);
	else
		hits_boundary(sim, first, what, room);
}

static size_t list_fast(const struct tsim *sim, size_t *fast)
{
	double dt2 = sim->clock.dt * sim->clock.dt;
	size_t n = 0;

	for (size_t i = 0; i < sim->particles->n; i++)
		if (ts_runaways_has(sim->particles, i, dt2))
			fast[n++] = i;
	return n;
}

/* Each rank gets the fast particles of the others; where there are bonds all, since a rank has not all bonds of its fast
 * particles, nor the velocities of their ends. */
static enum ts_status show_fast(struct tsim *sim)
{
	double dt2 = sim->clock.dt * sim->clock.dt;
	const struct ts_particles *p = sim->particles;
	bool bonds = ts_ranks_most(sim, (double)sim->bonds->n) > 0;
	unsigned char *chosen = ts_alloc(p->n, 1);
	enum ts_status status = chosen ? TS_OK : ts_nomem(&sim->error);

	for (size_t i = 0; chosen && i < p->n; i++)
		chosen[i] = ts_runaways_has(p, i, dt2);
	if (status == TS_OK)
		status = ts_division_show(sim, bonds ? NULL : chosen);
	ts_free(chosen);
	return status;
}

enum ts_status ts_tunnelling_find(struct tsim *sim, size_t *hit, char *what, size_t room)
{
	struct search s = { .own = sim->particles->n };
	enum ts_status status;

	*hit = SIZE_MAX;
	TS_TRY(show_fast(sim));
	s.fast = ts_alloc(sim->particles->n, sizeof *s.fast);
	s.n = s.fast ? list_fast(sim, s.fast) : 0;
	status = s.fast ? list_paths(sim, s.n, &s.paths) : ts_nomem(&sim->error);
	if (status == TS_OK)
		find_hit(sim, &s, hit, what, room);
	ts_spherehash_release(&s.paths.sphere);
	ts_free(s.fast);
	TS_TRY(status);
	return ts_division_hide(sim);
}
