#include "wall/mesh_wall.h"

#include <math.h>
#include <stdio.h>

#include "box/domain.h"
#include "geom/box_images.h"
#include "mesh/mesh_distance.h"
#include "neigh/coincide.h"
#include "neigh/drift_frame.h"
#include "wall/mesh_wall_search.h"

#include "base/banned.h"

static enum ts_status update_tree(struct tsim *sim, struct ts_mesh_part_of_wall *part)
{
	if (part->tree.n && part->moves == part->surface->moves)
		return TS_OK;
	ts_mesh_tree_release(&part->tree);
	part->moves = part->surface->moves;
	return ts_mesh_tree_build(&part->tree, &part->surface->mesh) == TS_OK ? TS_OK : ts_nomem(&sim->error);
}

enum ts_status ts_mesh_wall_update_trees(struct tsim *sim, struct ts_mesh_wall *mw)
{
	for (size_t k = 0; k < mw->nmeshes; k++)
		TS_TRY(update_tree(sim, &mw->mesh[k]));
	return TS_OK;
}

static int modulo3(int a)
{
	return (a % 3 + 3) % 3;
}

/* Appends contact `first` to particle i, or makes an entry for the particle. All contacts of a particle
 * are added consecutively. */
static enum ts_status add_neighbor_triangle(struct tsim *sim, struct ts_mesh_wall *mw, size_t i, size_t first)
{
	const struct ts_particles *p = sim->particles;
	struct ts_mesh_neighbor *v;

	if (!mw->nneighbors || mw->neighbor[mw->nneighbors - 1].i != i) {
		if (TS_GROW(mw->neighbor, mw->neighbor_capacity, mw->nneighbors + 1) != TS_OK)
			return ts_nomem(&sim->error);
		mw->neighbor[mw->nneighbors++] = (struct ts_mesh_neighbor){
			.i = i,
			.first = first,
			.radius = p->radius[i],
			.check_travel = -INFINITY,
			.place = { p->xhold[i][0], p->xhold[i][1], p->xhold[i][2] },
		};
	}
	v = &mw->neighbor[mw->nneighbors - 1];
	v->n++;
	return TS_OK;
}

double ts_mesh_wall_onset_distance(const struct tsim *sim, const struct ts_wall *w, double radius)
{
	return ts_wall_model(w, sim)->multi ? ts_wall_reach(w, sim, radius) : 0;
}

static enum ts_status add_contact(struct tsim *sim, struct ts_wall *w, struct ts_mesh_wall *mw,
				  const struct ts_mesh_found *f)
{
	const struct ts_mesh *mesh = &mw->mesh[f->mesh].surface->mesh;
	const struct ts_particles *p = sim->particles;
	size_t k = w->contacts.n;
	int code = 0, far = 0;

	for (int d = 0; d < 3; d++) {
		int image = p->image[f->i][d] + f->shift[d], rest = modulo3(image);

		code = 3 * code + rest;
		far = (far << TS_MESH_WALL_BITS) + ((image - rest) / 3 & ((1 << TS_MESH_WALL_BITS) - 1));
	}
	if (TS_GROW(mw->near, mw->near_capacity, k + 1) != TS_OK)
		return ts_nomem(&sim->error);
	if ((ts_wall_long_ranged(w, sim) || w->look > 0) &&
	    TS_GROW(mw->place, mw->place_capacity, k + 1) != TS_OK)
		return ts_nomem(&sim->error);
	mw->near[k] = (struct ts_mesh_near){
		f->mesh,
		f->triangle,
		{ f->shift[0], f->shift[1], f->shift[2] },
		false,
		ts_mesh_wall_safe_travel(mesh, f->triangle, f->distance,
					 p->radius[f->i] +
						 ts_mesh_wall_onset_distance(sim, w, p->radius[f->i]))
	};
	TS_TRY(add_neighbor_triangle(sim, mw, f->i, k));
	return ts_wall_contacts_add(sim, &w->contacts, f->i,
				    ((int)mw->mesh[f->mesh].first + f->triangle) * TS_MESH_WALL_IMAGES + code,
				    far);
}

double ts_mesh_wall_max_approach(const struct tsim *sim, struct ts_mesh_wall *mw)
{
	double most = sim->full & TS_FULL_ACTIVE_PAIRS ? INFINITY : 0;

	for (size_t k = 0; k < mw->nmeshes; k++) {
		struct ts_mesh_part_of_wall *part = &mw->mesh[k];
		double step = part->surface->travelled - part->travelled;

		most = fmax(most, step >= 0 ? step : INFINITY);
		part->travelled = part->surface->travelled;
	}
	for (int d = 0; d < 3; d++) {
		double length = ts_box_length(&sim->domain->box, d);

		most = length == mw->length[d] ? most : INFINITY;
		mw->length[d] = length;
	}
	return most;
}

/* Fails if images of a triangle would have the same key. */
static enum ts_status check_length(struct tsim *sim, const struct ts_mesh_part_of_wall *part)
{
	const struct ts_mesh *m = &part->surface->mesh;

	for (int d = 0; d < 3; d++) {
		double most = TS_MESH_WALL_LONGEST * ts_box_length(&sim->domain->box, d);

		if (!ts_box_periodic(&sim->domain->box, d) ||
		    !(part->tree.hi[1][d] - part->tree.lo[1][d] > most))
			continue;
		for (size_t t = 0; t < m->n; t++) {
			const double(*x)[3] = (const double(*)[3])m->x[t];

			if (fmax(fmax(x[0][d], x[1][d]), x[2][d]) - fmin(fmin(x[0][d], x[1][d]), x[2][d]) >
			    most)
				return ts_fail(&sim->error, TS_RANGE, &part->by->where,
					       "triangle %zu of mesh %s is longer than %d periodic boxes "
					       "along %c",
					       t + 1, part->by->id, TS_MESH_WALL_LONGEST, "xyz"[d]);
		}
	}
	return TS_OK;
}

static enum ts_status add_pairs(struct ts_instance *self, struct tsim *sim)
{
	struct ts_wall *w = self->state;
	struct ts_mesh_wall *mw = ts_mesh_wall_of(w);
	struct ts_mesh_wall_search search = { 0 };
	enum ts_status status;

	for (size_t k = 0; k < mw->nmeshes; k++) {
		TS_TRY(update_tree(sim, &mw->mesh[k]));
		TS_TRY(check_length(sim, &mw->mesh[k]));
		mw->mesh[k].checked = mw->mesh[k].surface->travelled;
	}
	mw->nneighbors = 0;
	ts_mesh_wall_max_approach(sim, mw);
	status = ts_mesh_wall_search(self, sim, &search);
	for (size_t k = 0; status == TS_OK && k < search.parts; k++)
		for (size_t j = 0; status == TS_OK && j < search.part[k].n; j++)
			status = add_contact(sim, w, mw, &search.part[k].found[j]);
	ts_mesh_wall_search_release(&search);
	return status;
}

enum ts_status ts_mesh_wall_list(struct ts_instance *self, struct tsim *sim)
{
	return ts_wall_relist(self, sim, TS_MESH_MEMORY, add_pairs);
}

/* Particles are listed within the skin; they may move by half of it relative to the frame. */
bool ts_mesh_wall_has_moved(const struct ts_wall *w, const struct tsim *sim)
{
	const struct ts_mesh_wall *mw = ts_mesh_wall_of(w);
	bool far = false;

	for (size_t k = 0; k < mw->nmeshes; k++)
		far |= mw->mesh[k].surface->travelled > ts_drift_frame_room_of_walls(sim);
	return far;
}

/* Largest displacement of a corner of the triangle in this step, length. */
static double triangle_travel(const struct tsim *sim, const struct ts_mesh_surface *s, size_t t)
{
	double most = 0;

	for (int k = 0; s->v && k < 3; k++)
		most = fmax(most, ts_norm(s->v[t][k]));
	return most * sim->clock.dt;
}

/* Fails if a triangle that moved by more than the radius of particle i in this step may have passed
 * through it. */
static enum ts_status check_passage(struct tsim *sim, const struct ts_mesh_part_of_wall *part, size_t i,
				    const double x[3], double step, struct ts_mesh_list *list)
{
	const struct ts_particles *p = sim->particles;
	const struct ts_mesh *m = &part->surface->mesh;
	char what[120];

	list->n = 0;
	if (ts_mesh_tree_near(&part->tree, m, x, p->radius[i] + step, list) != TS_OK)
		return ts_nomem(&sim->error);
	for (size_t k = 0; k < list->n; k++) {
		size_t t = (size_t)list->item[k];
		double travel = triangle_travel(sim, part->surface, t);

		if (ts_mesh_is_removed(m, t) || !(travel > p->radius[i]) ||
		    ts_mesh_distance(m, t, x) > p->radius[i] + travel)
			continue;
		snprintf(what, sizeof what, "triangle %zu of mesh %.60s", t + 1, part->by->id);
		return ts_coincide_passed(sim, &part->by->where, i, travel, what);
	}
	return TS_OK;
}

/* The same for the particle and its periodic images. */
static enum ts_status check_images(struct tsim *sim, const struct ts_mesh_part_of_wall *part, size_t i,
				   double step, struct ts_mesh_list *list)
{
	const struct ts_particles *p = sim->particles;
	const struct ts_box *box = &sim->domain->box;
	const struct ts_mesh_tree *tree = &part->tree;
	struct ts_box_images images = ts_box_images(box, tree->lo[1], tree->hi[1], p->x[i], p->x[i],
						    p->radius[i] + ts_box_images_way(box, step));
	double x[3];

	while (ts_box_images_next(&images)) {
		ts_box_images_place(box, images.shift, p->x[i], x);
		TS_TRY(check_passage(sim, part, i, x, step, list));
	}
	return TS_OK;
}

/* Whether the mesh moved by at most the smallest radius since the last check (*step), so that no particle
 * needs to be checked. */
static bool is_slow(const struct tsim *sim, struct ts_mesh_part_of_wall *part, double *step)
{
	double travelled = part->surface->travelled;

	*step = travelled >= part->checked ? travelled - part->checked : travelled;
	part->checked = travelled;
	return *step <= sim->neigh->least_radius;
}

enum ts_status ts_mesh_wall_check_displacement(struct ts_instance *self, struct tsim *sim)
{
	struct ts_mesh_wall *mw = ts_mesh_wall_of(self->state);
	const struct ts_particles *p = sim->particles;
	struct ts_mesh_list list = { 0 };
	enum ts_status status = TS_OK;
	double step;

	for (size_t k = 0; k < mw->nmeshes && status == TS_OK; k++) {
		struct ts_mesh_part_of_wall *part = &mw->mesh[k];

		if (is_slow(sim, part, &step))
			continue;
		status = update_tree(sim, part);
		for (size_t i = 0; i < p->n && status == TS_OK; i++)
			if (ts_in_group(p, i, part->by->group) && ts_wall_interacts(self, sim, i, false))
				status = check_images(sim, part, i, step, &list);
	}
	ts_free(list.item);
	return status;
}

void ts_mesh_wall_position(const struct tsim *sim, const struct ts_mesh_near *near, size_t i, double x[3])
{
	ts_box_images_place(&sim->domain->box, near->shift, sim->particles->x[i], x);
}

bool ts_mesh_wall_adjoin(const struct ts_mesh_wall *mw, size_t a, size_t b)
{
	const struct ts_mesh_near *p = &mw->near[a], *q = &mw->near[b];
	const struct ts_mesh *m = &mw->mesh[p->mesh].surface->mesh;
	double tolerance = ts_mesh_wall_slack(m, p->triangle) + ts_mesh_wall_slack(m, q->triangle);
	bool adjoin = false;

	for (int k = 0; k < 3; k++) {
		double to[3];

		for (int d = 0; d < 3; d++)
			to[d] = m->x[q->triangle][k][d] - m->x[p->triangle][0][d] +
				(q->shift[d] - p->shift[d]) * mw->length[d];
		adjoin |= fabs(ts_dot(m->normal[p->triangle], to)) <= tolerance;
	}
	return adjoin;
}
