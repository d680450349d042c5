#include "wall/voxel_wall.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "box/domain.h"
#include "math/vec3.h"
#include "neigh/coincide.h"
#include "wall/wall_coincide.h"
#include "wall/wall_queue.h"

#include "base/banned.h"

enum { LEAST_SLOTS = 4, IMAGES = 27 };

enum ts_status ts_voxel_wall_find(struct tsim *sim, struct ts_voxel_wall *vw, const struct ts_word *id)
{
	struct ts_voxel_surface *surface;

	TS_TRY(ts_voxel_surface_require(sim, id, &surface));
	vw->surface = surface;
	vw->by = ts_sim_find(sim, TS_KIND_FIX, id->text);
	return TS_OK;
}

void ts_voxel_wall_release(struct ts_voxel_wall *vw)
{
	ts_free(vw->neighbor);
	ts_free(vw->at);
	ts_free(vw->column);
	ts_free(vw->slot);
	ts_free(vw->used);
	*vw = (struct ts_voxel_wall){ 0 };
}

/* ---- periodic images */

/* A field that spans a periodic axis has its own columns on both sides of the box. Along other periodic axes
 * particles interact with the images of the field nearest to them. */
static bool has_images(const struct ts_voxel_field *f, const struct ts_box *box, int axis)
{
	for (int d = 0; d < 2; d++)
		if (f->axis[d] == axis && f->periodic[d])
			return false;
	return ts_box_periodic(box, axis);
}

/* Coordinate of the middle of the field. */
static double middle(const struct ts_voxel_field *f, int axis)
{
	for (int d = 0; d < 2; d++)
		if (f->axis[d] == axis)
			return 0.5 * (f->origin[d] + ts_voxel_border(f, d, f->n[d]));
	return 0.5 * (f->base + f->level[f->nlevels - 1].top[0]);
}

/* The point x in the frames of the images of the field that may be near it. */
struct images {
	int n, shift[IMAGES][3]; /* of the image, in box lengths */
	double x[IMAGES][3];
};

static void find_images(const struct ts_voxel_surface *s, const struct ts_box *box, const double x[3],
			struct images *out)
{
	out->n = 1;
	for (int d = 0; d < 3; d++) {
		out->shift[0][d] = 0;
		out->x[0][d] = x[d] - s->shift[d];
	}
	for (int d = 0; d < 3; d++) {
		double length = ts_box_length(box, d), nearest;
		int n = out->n;

		if (!has_images(&s->field, box, d))
			continue;
		nearest = rint((out->x[0][d] - middle(&s->field, d)) / length);
		for (int to = 3 * n - 1; to >= 0; to--) {
			int from = to % n, away = (int)nearest + to / n - 1;

			for (int e = 0; e < 3; e++) {
				out->x[to][e] = out->x[from][e];
				out->shift[to][e] = out->shift[from][e];
			}
			out->x[to][d] -= away * length;
			out->shift[to][d] = away;
		}
		out->n = 3 * n;
	}
}

double ts_voxel_wall_distance(const struct ts_voxel_wall *vw, const struct tsim *sim, const double x[3],
			      double reach)
{
	struct images images;
	double least = INFINITY;

	find_images(vw->surface, &sim->domain->box, x, &images);
	for (int k = 0; k < images.n; k++)
		least = fmin(least, ts_voxel_distance(&vw->surface->field, images.x[k], reach));
	return least;
}

static int modulo3(int64_t a)
{
	return (int)((a % 3 + 3) % 3);
}

/* 1 + number of a column and of its periodic image relative to the unwrapped position of particle i, modulo
 * three box lengths: it stays the same when the particle is wrapped. */
static double column_number(const struct ts_voxel_field *f, const struct ts_particles *p, size_t i,
			    const int64_t column[2], const int shift[3])
{
	int64_t local[2];
	int code = modulo3(p->image[i][f->axis[2]] + shift[f->axis[2]]);

	for (int d = 0; d < 2; d++) {
		int axis = f->axis[d];

		local[d] = f->periodic[d] ? ts_voxel_wrap(f, d, column[d]) : column[d];
		code = 3 * code + modulo3(p->image[i][axis] + shift[axis] + (column[d] - local[d]) / f->n[d]);
	}
	return 1 + (double)(IMAGES * (local[1] * f->n[0] + local[0]) + code);
}

/* The index of the column in the heights. */
static int64_t column_index(double column)
{
	return ((int64_t)column - 1) / IMAGES;
}

/* ---- listing */

static double *own_memory(const struct ts_wall_contacts *c, size_t k)
{
	return ts_wall_memory(c, k) + c->width - TS_VOXEL_MEMORY;
}

/* Slots that a particle needs if they are more than LEAST_SLOTS. */
struct need {
	int32_t tag;
	size_t slots;
};
struct needs {
	struct need *item; /* sorted by tag */
	size_t n, capacity;
};

static int compare_needs(const void *a, const void *b)
{
	const struct need *x = a, *y = b;

	return (x->tag > y->tag) - (x->tag < y->tag);
}

static enum ts_status add_need(struct tsim *sim, struct needs *needs, int32_t tag, size_t slots)
{
	if (slots <= LEAST_SLOTS)
		return TS_OK;
	if (TS_GROW(needs->item, needs->capacity, needs->n + 1) != TS_OK)
		return ts_nomem(&sim->error);
	needs->item[needs->n++] = (struct need){ tag, slots };
	return TS_OK;
}

/* Of the contacts of the list before, and of particles whose slots do not suffice in this step. */
static enum ts_status find_needs(struct tsim *sim, const struct ts_wall_contacts *c,
				 const struct ts_voxel_wall *vw, bool full, struct needs *needs)
{
	size_t n = 0;

	for (size_t k = 0; k < c->n && c->width >= TS_VOXEL_MEMORY; k++)
		if (own_memory(c, k)[TS_VOXEL_COLUMN] > 0)
			TS_TRY(add_need(sim, needs, c->key[k][0], (size_t)c->key[k][1] + 1));
	for (size_t k = 0; full && k < vw->nneighbors; k++)
		if (vw->neighbor[k].found > vw->neighbor[k].slots)
			TS_TRY(add_need(sim, needs, sim->particles->tag[vw->neighbor[k].i],
					vw->neighbor[k].found));
	if (needs->n)
		qsort(needs->item, needs->n, sizeof *needs->item, compare_needs);
	for (size_t k = 0; k < needs->n; k++) { /* one item for each particle */
		if (!n || needs->item[n - 1].tag != needs->item[k].tag)
			needs->item[n++] = needs->item[k];
		else if (needs->item[n - 1].slots < needs->item[k].slots)
			needs->item[n - 1].slots = needs->item[k].slots;
	}
	needs->n = n;
	return TS_OK;
}

static size_t slots_of(const struct needs *needs, int32_t tag)
{
	struct need key = { tag, 0 };
	const struct need *found =
		needs->n ? bsearch(&key, needs->item, needs->n, sizeof key, compare_needs) : NULL;
	size_t slots = LEAST_SLOTS;

	while (found && slots < found->slots)
		slots *= 2;
	return slots;
}

static enum ts_status add_neighbor(struct tsim *sim, struct ts_wall *w, struct ts_voxel_wall *vw, size_t i,
				   size_t slots)
{
	size_t first = w->contacts.n;

	if (TS_GROW(vw->neighbor, vw->neighbor_capacity, vw->nneighbors + 1) != TS_OK ||
	    TS_GROW(vw->at, vw->at_capacity, first + slots) != TS_OK ||
	    TS_GROW(vw->column, vw->column_capacity, first + slots) != TS_OK ||
	    TS_GROW(vw->slot, vw->slot_capacity, first + slots) != TS_OK ||
	    TS_GROW(vw->used, vw->used_capacity, first + slots) != TS_OK)
		return ts_nomem(&sim->error);
	vw->neighbor[vw->nneighbors++] = (struct ts_voxel_neighbor){ i, first, slots, 0 };
	for (size_t k = 0; k < slots; k++)
		TS_TRY(ts_wall_contacts_add(sim, &w->contacts, i, (int)k));
	return TS_OK;
}

static enum ts_status list_particles(struct ts_instance *self, struct tsim *sim, struct ts_wall *w,
				     struct ts_voxel_wall *vw, const struct needs *needs)
{
	const struct ts_particles *p = sim->particles;
	bool warm = !isnan(vw->surface->temperature), pulls = ts_wall_long_ranged(w, sim);

	vw->nneighbors = 0;
	for (size_t i = 0; i < p->n; i++) {
		double reach = p->radius[i] + sim->neigh->built_skin +
			       (pulls ? ts_wall_reach(w, sim, p->radius[i]) : 0);

		if (ts_in_group(p, i, vw->by->group) && ts_wall_interacts(self, sim, i, warm) &&
		    ts_voxel_wall_distance(vw, sim, p->xhold[i], reach) < reach)
			TS_TRY(add_neighbor(sim, w, vw, i, slots_of(needs, p->tag[i])));
	}
	return TS_OK;
}

/* `full`: particles have more contact points than slots. */
static enum ts_status list_again(struct ts_instance *self, struct tsim *sim, struct ts_wall *w,
				 struct ts_voxel_wall *vw, bool full)
{
	struct ts_wall_rebuild rebuild;
	struct needs needs = { 0 };
	enum ts_status status = find_needs(sim, &w->contacts, vw, full, &needs);

	if (status == TS_OK) {
		ts_wall_rebuild_start(w, sim, TS_VOXEL_MEMORY, &rebuild);
		status = ts_wall_rebuild_finish(w, sim, &rebuild, list_particles(self, sim, w, vw, &needs));
	}
	ts_free(needs.item);
	return status;
}

enum ts_status ts_voxel_wall_list(struct ts_instance *self, struct tsim *sim, struct ts_wall *w,
				  struct ts_voxel_wall *vw)
{
	return list_again(self, sim, w, vw, false);
}

/* ---- motion of the surface */

/* Particles are listed within the skin; particles and surface may each move by half of it. */
bool ts_voxel_wall_has_moved(const struct tsim *sim, const struct ts_voxel_wall *vw)
{
	return vw->surface->travelled > 0.5 * sim->neigh->built_skin;
}

enum ts_status ts_voxel_wall_check_displacement(struct ts_instance *self, struct tsim *sim,
						const struct ts_voxel_wall *vw)
{
	const struct ts_particles *p = sim->particles;
	double step = vw->surface->step;
	char what[80];

	for (size_t i = 0; step > sim->neigh->least_radius && i < p->n; i++) {
		double reach = p->radius[i] + step;

		if (!(step > p->radius[i]) || !ts_in_group(p, i, vw->by->group) ||
		    !ts_wall_interacts(self, sim, i, false) ||
		    !(ts_voxel_wall_distance(vw, sim, p->x[i], reach) < reach))
			continue;
		snprintf(what, sizeof what, "surface %.60s", vw->by->id);
		return ts_coincide_passed(sim, &vw->by->where, i, step, what);
	}
	return TS_OK;
}

/* ---- contact points of a step */

struct force_task {
	struct tsim *sim;
	struct ts_wall *w;
	struct ts_voxel_wall *vw;
	bool pulls;
};

/* Stores the contact points of a particle, as many as it has slots, and counts all. */
static void find_points(const struct force_task *t, struct ts_voxel_neighbor *v)
{
	const struct ts_particles *p = t->sim->particles;
	const struct ts_voxel_field *f = &t->vw->surface->field;
	struct ts_voxel_wall *vw = t->vw;
	double radius = p->radius[v->i];
	double reach = radius + (t->pulls ? ts_wall_reach(t->w, t->sim, radius) : 0);
	struct images images;

	v->found = 0;
	find_images(vw->surface, &t->sim->domain->box, p->x[v->i], &images);
	for (int k = 0; k < images.n; k++) {
		size_t room = v->found < v->slots ? v->slots - v->found : 0, from = v->first + v->found;
		size_t n = ts_voxel_contacts(f, images.x[k], reach, vw->at + from, room);

		for (size_t m = 0; m < n && m < room; m++)
			vw->column[from + m] =
				column_number(f, p, v->i, vw->at[from + m].column, images.shift[k]);
		v->found += n;
	}
}

static void find_range(void *context, size_t from, size_t to)
{
	const struct force_task *t = context;

	for (size_t k = from; k < to; k++)
		find_points(t, &t->vw->neighbor[k]);
}

static void find_all(const struct force_task *t)
{
	/* a search costs as much as about 4 particles of simple loops */
	ts_parallel(ts_team(t->sim, 4 * t->vw->nneighbors), t->vw->nneighbors, find_range, (void *)t);
}

static bool is_full(const struct ts_voxel_wall *vw)
{
	for (size_t k = 0; k < vw->nneighbors; k++)
		if (vw->neighbor[k].found > vw->neighbor[k].slots)
			return true;
	return false;
}

/* ---- matching of contact points and contacts */

static void take_slot(const struct ts_voxel_wall *vw, size_t point, size_t k)
{
	vw->slot[point] = k;
	vw->used[k] = true;
}

static void match_columns(const struct ts_wall_contacts *c, const struct ts_voxel_wall *vw,
			  const struct ts_voxel_neighbor *v)
{
	for (size_t point = v->first; point < v->first + v->found; point++) {
		double column = vw->column[point];

		vw->slot[point] = SIZE_MAX;
		for (size_t k = v->first; k < v->first + v->slots; k++)
			if (!(own_memory(c, k)[TS_VOXEL_COLUMN] < column) &&
			    !(own_memory(c, k)[TS_VOXEL_COLUMN] > column))
				take_slot(vw, point, k);
	}
}

/* The contact that has ended at the nearest point of the particle's surface; SIZE_MAX: none near enough. */
static size_t ended_contact(const struct ts_wall_contacts *c, const struct ts_voxel_wall *vw,
			    const struct ts_voxel_neighbor *v, const double n[3])
{
	double most = TS_VOXEL_SAME_NORMAL;
	size_t best = SIZE_MAX;

	for (size_t k = v->first; k < v->first + v->slots; k++) {
		const double *own = own_memory(c, k);
		double cosine = ts_dot(own + TS_VOXEL_NORMAL, n);

		if (vw->used[k] || !(own[TS_VOXEL_COLUMN] > 0) || !(cosine > most))
			continue;
		most = cosine;
		best = k;
	}
	return best;
}

static size_t free_slot(const struct ts_voxel_wall *vw, const struct ts_voxel_neighbor *v)
{
	size_t k = v->first;

	while (vw->used[k])
		k++;
	return k;
}

/* Gives each contact point a slot, and ends the contacts that have none. */
static void match_points(struct ts_wall_contacts *c, const struct ts_voxel_wall *vw,
			 const struct ts_voxel_neighbor *v)
{
	for (size_t k = v->first; k < v->first + v->slots; k++)
		vw->used[k] = false;
	match_columns(c, vw, v);
	for (size_t point = v->first; point < v->first + v->found; point++) {
		size_t k = vw->slot[point] == SIZE_MAX ? ended_contact(c, vw, v, vw->at[point].n) : SIZE_MAX;

		if (k != SIZE_MAX)
			take_slot(vw, point, k);
	}
	for (size_t k = v->first; k < v->first + v->slots; k++)
		if (!vw->used[k])
			ts_wall_contact_end(c, k);
	for (size_t point = v->first; point < v->first + v->found; point++)
		if (vw->slot[point] == SIZE_MAX)
			take_slot(vw, point, free_slot(vw, v));
}

static void compute_point(const struct force_task *t, struct ts_wall_queue *q, size_t at)
{
	const struct ts_voxel_surface *s = t->vw->surface;
	const struct ts_voxel_contact *from = &t->vw->at[at];
	struct ts_wall_contacts *c = &t->w->contacts;
	struct ts_wall_contact_point point = { .distance = from->distance,
					       .type = (int)s->type,
					       .mesh = 1,
					       .triangle = (int)column_index(t->vw->column[at]),
					       .warm = !isnan(s->temperature),
					       .temperature = s->temperature };
	size_t k = t->vw->slot[at];
	double *own = own_memory(c, k);

	for (int d = 0; d < 3; d++) {
		point.n[d] = from->n[d];
		point.velocity[d] = s->velocity[d];
	}
	if (!ts_wall_touches(q, k, &point)) {
		ts_wall_contact_end(c, k);
		return;
	}
	own[TS_VOXEL_COLUMN] = t->vw->column[at];
	for (int d = 0; d < 3; d++)
		own[TS_VOXEL_NORMAL + d] = from->n[d];
	ts_wall_enqueue_contact(q, k, &point);
}

/* In the order of slots, in which the forces of a particle are summed. */
static void compute_neighbor(const struct force_task *t, struct ts_wall_queue *q,
			     const struct ts_voxel_neighbor *v)
{
	const struct ts_voxel_wall *vw = t->vw;

	match_points(&t->w->contacts, vw, v);
	for (size_t k = v->first; v->found && k < v->first + v->slots; k++)
		for (size_t at = v->first; vw->used[k] && at < v->first + v->found; at++)
			if (vw->slot[at] == k)
				compute_point(t, q, at);
}

static void compute_range(void *context, size_t from, size_t to)
{
	const struct force_task *t = context;
	struct ts_wall_queue queue;

	ts_wall_queue_start(&queue, t->w, t->sim);
	for (size_t k = from; k < to; k++)
		compute_neighbor(t, &queue, &t->vw->neighbor[k]);
	ts_wall_queue_end(&queue);
}

enum ts_status ts_voxel_wall_enqueue_contacts(struct ts_instance *self, struct tsim *sim, struct ts_wall *w,
					      struct ts_voxel_wall *vw)
{
	struct force_task task = { sim, w, vw, ts_wall_long_ranged(w, sim) };

	find_all(&task);
	if (is_full(vw)) {
		TS_TRY(list_again(self, sim, w, vw, true));
		find_all(&task);
	}
	ts_parallel(ts_team(sim, 4 * vw->nneighbors), vw->nneighbors, compute_range, &task);
	ts_wall_finish(w);
	return ts_coincide_wall(sim, w);
}

/* ---- names */

void ts_voxel_wall_name(const struct ts_wall *w, const struct ts_voxel_wall *vw, size_t k, struct ts_str *out)
{
	double column = own_memory(&w->contacts, k)[TS_VOXEL_COLUMN];
	int64_t nx = vw->surface->field.n[0];

	if (column > 0)
		ts_str_addf(out, ", column %lld %lld of surface %s",
			    (long long)(column_index(column) % nx + 1),
			    (long long)(column_index(column) / nx + 1), vw->by->id);
}
