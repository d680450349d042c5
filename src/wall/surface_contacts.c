#include "wall/surface_contacts.h"

#include <stdlib.h>

#include "base/sort.h"
#include "box/domain.h"
#include "mesh/mesh_touch.h"

#include "base/banned.h"

static const struct ts_mesh_surface *surface_at(const struct ts_mesh_wall *mw, size_t k)
{
	return mw->mesh[mw->near[k].mesh].surface;
}

/* ---- the list of a wall ---- */

static int by_element(const void *a, const void *b)
{
	const struct ts_mesh_touching *p = a, *q = b;

	if (p->element != q->element)
		return p->element < q->element ? -1 : 1;
	return (p->tag > q->tag) - (p->tag < q->tag);
}

enum ts_status ts_surface_contacts_collect(struct tsim *sim, const struct ts_wall *w, struct ts_mesh_wall *mw)
{
	const struct ts_wall_contacts *c = &w->contacts;

	mw->ntouching = 0;
	if (!c->report || !ts_mesh_wall_observed(mw))
		return TS_OK;
	if (TS_GROW(mw->touching, mw->touching_capacity, c->n) != TS_OK)
		return ts_nomem(&sim->error);
	for (size_t k = 0; k < c->n; k++)
		if (surface_at(mw, k)->observed && ts_wall_report(c, k))
			mw->touching[mw->ntouching++] =
				(struct ts_mesh_touching){ c->key[k][1], c->key[k][0], k };
	ts_sort(mw->touching, mw->ntouching, sizeof *mw->touching, by_element);
	return TS_OK;
}

bool ts_surface_contacts_listed(const struct tsim *sim, const struct ts_mesh_surface *surface)
{
	const struct ts_wall *w;

	for (size_t at = 0; (w = ts_walls_next(sim, &at, NULL));)
		for (size_t k = 0; w->mesh && k < w->contacts.n; k++)
			if (surface_at(w->mesh, k) == surface)
				return true;
	return false;
}

/* ---- iteration ---- */

struct ts_surface_contacts ts_surface_contacts(struct tsim *sim, const struct ts_mesh_surface *surface)
{
	return (struct ts_surface_contacts){ .sim = sim, .surface = surface };
}

/* Into the frame of the mesh from that of the image which is touched. */
static void into_frame(const struct tsim *sim, const struct ts_mesh_near *near, const double x[3],
		       double out[3])
{
	for (int d = 0; d < 3; d++)
		out[d] = x[d] - near->shift[d] * ts_box_length(&sim->domain->box, d);
}

static void describe(const struct ts_surface_contacts *it, size_t k, struct ts_surface_contact *out)
{
	const struct ts_wall_contacts *c = &it->wall->contacts;
	const struct ts_mesh_near *near = &it->wall->mesh->near[k];
	const struct ts_wall_report *r = &c->report[k];

	out->triangle = (size_t)near->triangle;
	out->particle = (size_t)c->row[k];
	out->overlap = r->overlap;
	ts_scale(-1, r->force, out->force);
	into_frame(it->sim, near, r->point, out->point);
	into_frame(it->sim, near, it->sim->particles->x[out->particle], out->centre);
}

bool ts_surface_contacts_next(struct ts_surface_contacts *it, struct ts_surface_contact *out)
{
	for (;;) {
		while (it->wall && it->at < it->wall->mesh->ntouching) {
			size_t k = it->wall->mesh->touching[it->at++].k;

			if (surface_at(it->wall->mesh, k) != it->surface)
				continue;
			describe(it, k, out);
			return true;
		}
		do {
			it->wall = ts_walls_next(it->sim, &it->next_wall, NULL);
		} while (it->wall && !it->wall->mesh);
		it->at = 0;
		if (!it->wall)
			return false;
	}
}

void ts_surface_contact_motion(const struct ts_surface_contacts *it, const struct ts_surface_contact *contact,
			       double n[3], double v[3])
{
	struct ts_mesh_contact_point at;

	ts_mesh_nearest(&it->surface->mesh, contact->triangle, contact->centre, &at);
	ts_scale(1, at.n, n);
	ts_mesh_surface_velocity(it->surface, contact->triangle, at.weight, v);
	ts_sub(it->sim->particles->v[contact->particle], v, v);
}
