#include "wall/mesh_crowd.h"

#include <inttypes.h>
#include <math.h>

#include "base/banned.h"

/* Cosine of the largest angle between the normals of contacts of one surface; those of a corner include more. */
static const double SAME_SIDE = 0.94;
/* Overlaps, by the largest, of a contact beside an edge (fix mesh/surface). */
static const double TWICE = 2;

struct touch {
	double point[3]; /* of the surface, relative to the centre of the particle */
	struct ts_mesh_contact_point at;
	int32_t mesh;
	double height; /* the least one of the triangle, length */
	bool is;       /* it touches, now as at the last look */
};

static struct touch find_touch(const struct tsim *sim, const struct ts_mesh_wall *mw,
			       const struct ts_mesh_neighbor *v, size_t k)
{
	const struct ts_mesh_near *near = &mw->near[k];
	const struct ts_mesh *mesh = &mw->mesh[near->mesh].surface->mesh;
	const size_t triangle = (size_t)near->triangle;
	const double *edge = mesh->length[triangle];
	struct touch t = { .mesh = near->mesh,
			   .height = 2 * mesh->area[triangle] / fmax(edge[0], fmax(edge[1], edge[2])) };
	double x[3];

	ts_mesh_wall_position(sim, near, v->i, x);
	t.is = near->touches && ts_mesh_nearest(mesh, triangle, x, &t.at) != TS_MESH_NOTHING;
	if (t.is)
		ts_scale(-t.at.distance, t.at.n, t.point);
	return t;
}

static size_t deepest_touch(const struct tsim *sim, const struct ts_mesh_wall *mw,
			    const struct ts_mesh_neighbor *v)
{
	size_t deepest = v->first;
	double least = INFINITY;

	for (size_t k = v->first; k < v->first + v->n; k++) {
		const struct touch t = find_touch(sim, mw, v, k);

		if (!t.is || !(t.at.distance < least))
			continue;
		least = t.at.distance;
		deepest = k;
	}
	return deepest;
}

void ts_mesh_crowd_look(const struct tsim *sim, struct ts_mesh_wall *mw, const struct ts_mesh_neighbor *v)
{
	const struct touch deepest = find_touch(sim, mw, v, deepest_touch(sim, mw, v));
	const double overlap = v->radius - deepest.at.distance;
	const double area = 2 * v->radius * overlap; /* square of the contact radius */
	const int32_t tag = sim->particles->tag[v->i];
	double sum = 0;
	size_t n = 0;

	for (size_t k = v->first; k < v->first + v->n; k++) {
		const struct touch t = find_touch(sim, mw, v, k);

		if (!t.is || t.mesh != deepest.mesh || ts_distance2(t.point, deepest.point) > area ||
		    ts_dot(t.at.n, deepest.at.n) < SAME_SIDE || t.height * t.height > 4 * area)
			continue;
		n++;
		sum += overlap > 0 ? (v->radius - t.at.distance) / overlap : 1;
	}
	if (n < TS_MESH_CROWD || sum <= TWICE)
		return;
#pragma omp critical
	if (!mw->crowd.contacts || tag < mw->crowd.tag)
		mw->crowd =
			(struct ts_mesh_crowd){ .tag = tag, .contacts = n, .sum = sum, .mesh = deepest.mesh };
}

void ts_mesh_crowd_tell(const struct ts_instance *self, struct tsim *sim, struct ts_mesh_wall *mw)
{
	const struct ts_mesh_crowd *c = &mw->crowd;

	if (!c->contacts || c->told)
		return;
	mw->crowd.told = true;
	ts_warn(&sim->log, &self->where,
		"fix wall/gran %s: at step %" PRId64 " particle %" PRId32
		" has %zu contacts with mesh %s within one contact area, each with the force of a plane: "
		"their overlaps add up to %.2g times the largest, where one contact has the right force; the "
		"triangles are too small for `curvature` of the mesh: take larger ones, or a `curvature` "
		"above the angle between two of them (once told)",
		self->id, sim->clock.step, c->tag, c->contacts, mw->mesh[c->mesh].by->id, c->sum);
}
