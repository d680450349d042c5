#include "wall/voxel_wall.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/sort.h"
#include "box/domain.h"
#include "math/vec3.h"
#include "neigh/coincide.h"
#include "neigh/drift_frame.h"

#include "base/banned.h"

/* ---- the list ---- */

enum { LEAST_SLOTS = 4 };

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

void ts_voxel_images(const struct ts_voxel_surface *s, const struct ts_box *box, const double x[3],
		     struct ts_voxel_images *out)
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
	struct ts_voxel_images images;
	double least = INFINITY;

	ts_voxel_images(vw->surface, &sim->domain->box, x, &images);
	for (int k = 0; k < images.n; k++)
		least = fmin(least, ts_voxel_distance(&vw->surface->field, images.x[k], reach));
	return least;
}

double ts_voxel_wall_gap(const struct ts_wall *w, const struct tsim *sim, const double x[3])
{
	const struct ts_voxel_wall *vw = ts_voxel_wall_of(w);
	const struct ts_voxel_field *f = &vw->surface->field;
	double far = 0, reach = f->width[0] + f->width[1];

	for (int d = 0; d < 3; d++)
		far += ts_box_length(&sim->domain->box, d);
	for (; reach < far; reach *= 2) {
		double distance = ts_voxel_wall_distance(vw, sim, x, reach);

		if (distance < reach)
			return distance - vw->surface->step;
	}
	return far - vw->surface->step;
}

/* ---- listing */

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

/* Of the contacts of the list before; `full`: and of the contact points in this step, of all particles: those that have
 * slots enough keep them. */
static enum ts_status find_needs(struct tsim *sim, const struct ts_wall_contacts *c,
				 const struct ts_voxel_wall *vw, bool full, struct needs *needs)
{
	size_t n = 0;

	for (size_t k = 0; k < c->n && c->width >= TS_VOXEL_MEMORY; k++)
		if (ts_voxel_memory(c, k)[TS_VOXEL_COLUMN] > 0)
			TS_TRY(add_need(sim, needs, c->key[k][0], (size_t)c->key[k][1] + 1));
	for (size_t k = 0; full && k < vw->nneighbors; k++)
		TS_TRY(add_need(sim, needs, sim->particles->tag[vw->neighbor[k].i], vw->neighbor[k].found));
	ts_sort(needs->item, needs->n, sizeof *needs->item, compare_needs);
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
	vw->neighbor[vw->nneighbors++] =
		(struct ts_voxel_neighbor){ .i = i, .first = first, .slots = slots, .travel = INFINITY };
	for (size_t k = 0; k < slots; k++)
		TS_TRY(ts_wall_contacts_add(sim, &w->contacts, i, (int)k, 0));
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

		if (ts_in_group(p, i, vw->by->group) && ts_wall_lists(self, sim, i, 0, warm) &&
		    ts_voxel_wall_distance(vw, sim, p->xhold[i], reach) < reach)
			TS_TRY(add_neighbor(sim, w, vw, i, slots_of(needs, p->tag[i])));
	}
	return TS_OK;
}

enum ts_status ts_voxel_wall_list_slots(struct ts_instance *self, struct tsim *sim, bool full)
{
	struct ts_wall *w = self->state;
	struct ts_voxel_wall *vw = ts_voxel_wall_of(w);
	struct ts_wall_rebuild rebuild;
	struct needs needs = { 0 };
	enum ts_status status = find_needs(sim, &w->contacts, vw, full, &needs);

	for (int d = 0; d < 3; d++)
		vw->length[d] = ts_box_length(&sim->domain->box, d);
	if (status == TS_OK) {
		ts_wall_rebuild_start(w, sim, TS_VOXEL_MEMORY, &rebuild);
		status = ts_wall_rebuild_finish(w, sim, &rebuild, list_particles(self, sim, w, vw, &needs));
	}
	ts_free(needs.item);
	return status;
}

enum ts_status ts_voxel_wall_list(struct ts_instance *self, struct tsim *sim)
{
	return ts_voxel_wall_list_slots(self, sim, false);
}

/* ---- motion of the surface */

/* Particles are listed within the skin; they may move by half of it relative to the frame. */
bool ts_voxel_wall_has_moved(const struct ts_wall *w, const struct tsim *sim)
{
	return ts_voxel_wall_of(w)->surface->travelled > ts_drift_frame_room_of_walls(sim);
}

enum ts_status ts_voxel_wall_check_displacement(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_voxel_wall *vw = ts_voxel_wall_of(self->state);
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
