/* Closed meshes as solids. */
#include "immersed/solid.h"

#include <math.h>
#include <string.h>

#include "math/vec3.h"
#include "mesh/mesh_distance.h"
#include "mesh/mesh_surface.h"
#include "mesh/mesh_volume.h"

#include "base/banned.h"

struct closed {
	struct ts_solid solid; /* first */
	struct ts_mesh_surface *surface;
	struct ts_mesh_tree tree;
	struct ts_mesh_list *near; /* work memory of each worker; owned */
	size_t workers;
	const struct ts_solid_prescribed *prescribed;
	double outward; /* 1; -1: the normals of the triangles point inwards */
	uint64_t moves; /* counter of moves of the surface when the tree was built */
	double lo[3], hi[3];
};

/* Solves a x = b for symmetric a by Cramer's rule; false if a is singular. */
static bool solve_cramer(const double a[3][3], const double b[3], double x[3])
{
	double minor[3], det;

	ts_cross(a[1], a[2], minor);
	det = ts_dot(a[0], minor);
	if (!(fabs(det) > 0))
		return false;
	x[0] = ts_dot(b, minor) / det;
	ts_cross(a[2], a[0], minor);
	x[1] = ts_dot(b, minor) / det;
	ts_cross(a[0], a[1], minor);
	x[2] = ts_dot(b, minor) / det;
	return true;
}

/* Least-squares fit of a rigid motion to the velocities of the corners: with r the positions relative to
 * their mean, the velocity is the mean, and sum (r^2 1 - r r) omega = sum r x v. */
static void fit_rigid_motion(const struct ts_mesh_surface *s, struct ts_solid_motion *m)
{
	size_t corners = 3 * s->mesh.n;
	double a[3][3] = { { 0 } }, b[3] = { 0 };

	memset(m, 0, sizeof *m);
	for (size_t c = 0; c < corners; c++) {
		ts_axpy(1.0 / (double)corners, s->mesh.x[c / 3][c % 3], m->centre);
		if (s->v)
			ts_axpy(1.0 / (double)corners, s->v[c / 3][c % 3], m->velocity);
	}
	for (size_t c = 0; s->v && c < corners; c++) {
		double r[3], turn[3];

		ts_sub(s->mesh.x[c / 3][c % 3], m->centre, r);
		ts_cross(r, s->v[c / 3][c % 3], turn);
		for (int i = 0; i < 3; i++) {
			b[i] += turn[i];
			for (int j = 0; j < 3; j++)
				a[i][j] += (i == j ? ts_dot(r, r) : 0) - r[i] * r[j];
		}
	}
	if (s->v && !solve_cramer((const double(*)[3])a, b, m->omega))
		memset(m->omega, 0, sizeof m->omega);
}

/* The same motion, with another centre. */
static void change_centre(struct ts_solid_motion *m, const double centre[3])
{
	double v[3];

	ts_solid_velocity(m, centre, v);
	memcpy(m->velocity, v, sizeof v);
	memcpy(m->centre, centre, sizeof m->centre);
}

static enum ts_status update(struct ts_solid *solid, struct tsim *sim)
{
	struct closed *s = (struct closed *)solid;
	struct ts_solid_motion *m = solid->motion;

	solid->moved = s->tree.n == 0 || s->moves != s->surface->moves;
	fit_rigid_motion(s->surface, m);
	if (s->prescribed->centre)
		change_centre(m, s->prescribed->motion.centre);
	if (s->prescribed->velocity)
		memcpy(m->velocity, s->prescribed->motion.velocity, sizeof m->velocity);
	if (s->prescribed->omega)
		memcpy(m->omega, s->prescribed->motion.omega, sizeof m->omega);
	if (!solid->moved)
		return TS_OK;
	s->moves = s->surface->moves;
	ts_mesh_bounds(&s->surface->mesh, s->lo, s->hi);
	ts_mesh_tree_release(&s->tree);
	return ts_mesh_tree_build(&s->tree, &s->surface->mesh) == TS_OK ? TS_OK : ts_nomem(&sim->error);
}

static void bounds(const struct ts_solid *solid, size_t part, double lo[3], double hi[3])
{
	const struct closed *s = (const struct closed *)solid;

	(void)part;
	memcpy(lo, s->lo, sizeof s->lo);
	memcpy(hi, s->hi, sizeof s->hi);
}

static enum ts_status team(struct ts_solid *solid, size_t workers)
{
	struct closed *s = (struct closed *)solid;

	return TS_GROW(s->near, s->workers, workers);
}

static enum ts_status find_surface(struct ts_solid *solid, size_t worker, size_t part, const double x[3],
				   double reach, enum ts_solid_side *side,
				   struct ts_solid_surface *surface_point)
{
	struct closed *s = (struct closed *)solid;
	struct ts_mesh_distance d;
	bool near;

	(void)part;
	TS_TRY(ts_mesh_signed_distance(&s->surface->mesh, &s->tree, x, reach, &s->near[worker], &near, &d));
	*side = near ? TS_SOLID_NEAR : TS_SOLID_FAR;
	if (!near)
		return TS_OK;
	surface_point->distance = s->outward * d.distance;
	ts_scale(s->outward, d.n, surface_point->n);
	ts_solid_rigid_velocity(solid->motion, x, surface_point);
	if (surface_point->distance > 0 && s->surface->v && !s->prescribed->velocity && !s->prescribed->omega)
		ts_mesh_surface_velocity(s->surface, (size_t)d.triangle, d.weight, surface_point->v);
	return TS_OK;
}

static bool inside(const struct ts_solid *solid, size_t part, const double x[3])
{
	(void)part;
	return ts_mesh_inside(&((const struct closed *)solid)->surface->mesh, x);
}

static void release(struct ts_solid *solid)
{
	struct closed *s = (struct closed *)solid;

	ts_mesh_tree_release(&s->tree);
	for (size_t k = 0; k < s->workers; k++)
		ts_free(s->near[k].item);
	ts_free(s->near);
}

static const struct ts_solid_kind kind = { update, bounds, find_surface, inside, release, team };

/* Marks the triangles that are connected by edges with this one; `stack`: room for all. */
static void mark_shell(const struct ts_mesh *m, size_t first, bool *seen, size_t *stack)
{
	size_t n = 1;

	stack[0] = first;
	seen[first] = true;
	while (n > 0) {
		size_t t = stack[--n];

		for (int k = 0; k < 3; k++) {
			size_t next = (size_t)m->neighbour[t][k];

			if (!seen[next])
				stack[n++] = next;
			seen[next] = true;
		}
	}
}

/* Whether the normal of the triangle points out of the body, or into it. */
static bool points(const struct ts_mesh *m, size_t t, bool inwards)
{
	const double step = 1e-6 * sqrt(m->area[t]);
	double front[3] = { m->centre[t][0], m->centre[t][1], m->centre[t][2] };
	double back[3] = { front[0], front[1], front[2] };

	ts_axpy(step, m->normal[t], front);
	ts_axpy(-step, m->normal[t], back);
	return ts_mesh_inside(m, front) == inwards && ts_mesh_inside(m, back) != inwards;
}

/* A mesh may have several shells, each with normals to one side. *turned: a triangle of one whose normals point to the other
 * side than those of most of the volume; m->n: none. */
static enum ts_status find_turned_shell(const struct ts_mesh *m, bool inwards, size_t *turned)
{
	bool *seen = ts_alloc(m->n, sizeof *seen);
	size_t *stack = ts_alloc(m->n, sizeof *stack);
	enum ts_status status = seen && stack ? TS_OK : TS_NOMEM;

	*turned = m->n;
	for (size_t t = 0; status == TS_OK && t < m->n && *turned == m->n; t++) {
		if (seen[t] || !(m->area[t] > 0))
			continue;
		mark_shell(m, t, seen, stack);
		if (!points(m, t, inwards))
			*turned = t;
	}
	ts_free(seen);
	ts_free(stack);
	return status;
}

enum ts_status ts_solid_check_mesh(struct tsim *sim, const struct ts_word *id, const struct ts_mesh *mesh,
				   bool *inwards)
{
	struct ts_mesh_volume volume;
	size_t t;

	if (!ts_mesh_closed(mesh, &t))
		return ts_fail(&sim->error, TS_STATE, &id->place,
			       "fix immersed/boundary: mesh %s is not closed: triangle %zu, about (%g, %g, "
			       "%g), has an edge that it does not share with exactly one other",
			       id->text, t + 1, mesh->centre[t][0], mesh->centre[t][1], mesh->centre[t][2]);
	if (!ts_mesh_measure_volume(mesh, &volume))
		return ts_fail(&sim->error, TS_STATE, &id->place,
			       "fix immersed/boundary: mesh %s encloses no volume: the normals of some "
			       "triangles point inwards, those of others outwards",
			       id->text);
	*inwards = volume.volume < 0;
	if (find_turned_shell(mesh, *inwards, &t) != TS_OK)
		return ts_nomem(&sim->error);
	if (t < mesh->n)
		return ts_fail(&sim->error, TS_STATE, &id->place,
			       "fix immersed/boundary: mesh %s has several closed surfaces, and the normals "
			       "of one, about (%g, %g, %g), point into the body where those of others point "
			       "out of it",
			       id->text, mesh->centre[t][0], mesh->centre[t][1], mesh->centre[t][2]);
	return TS_OK;
}

struct ts_solid *ts_solid_of_mesh(struct ts_mesh_surface *surface, bool inwards, int dimensions,
				  const struct ts_solid_prescribed *prescribed)
{
	struct closed *s = ts_alloc(1, sizeof *s);

	if (!s)
		return NULL;
	s->solid = (struct ts_solid){ .kind = &kind, .parts = 1, .dimensions = dimensions };
	s->surface = surface;
	s->outward = inwards ? -1 : 1;
	s->prescribed = prescribed;
	if (TS_GROW(s->solid.motion, s->solid.motion_capacity, 1) == TS_OK && team(&s->solid, 1) == TS_OK)
		return &s->solid;
	ts_free(s->solid.motion);
	ts_free(s);
	return NULL;
}
