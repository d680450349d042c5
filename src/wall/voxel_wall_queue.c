#include "wall/voxel_wall_queue.h"

#include <math.h>

#include "box/domain.h"
#include "math/vec3.h"
#include "neigh/neigh.h"
#include "wall/voxel_foundation.h"
#include "wall/wall_coincide.h"
#include "wall/wall_queue.h"

#include "base/banned.h"

/* ---- contact points of a step */

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
		int64_t image = f->periodic[d] ? ts_voxel_image(f, d, column[d]) : 0;

		local[d] = column[d] - image * f->n[d];
		code = 3 * code + modulo3(p->image[i][f->axis[d]] + shift[f->axis[d]] + image);
	}
	return 1 + (double)(TS_VOXEL_IMAGES * (local[1] * f->n[0] + local[0]) + code);
}

struct force_task {
	struct tsim *sim;
	struct ts_wall *w;
	struct ts_voxel_wall *vw;
	bool pulls;
	/* upper bound of the displacement of the surface since the last force computation, length; infinite: all
	 * particles are searched */
	double step;
};

/* ---- which particles are searched */

static double max_approach(const struct tsim *sim, struct ts_voxel_wall *vw)
{
	/* infinite when columns have grown, NaN if they have before, too; columns that shrink make no contact */
	double step = vw->surface->travelled - vw->travelled;
	bool bounded = step >= 0 && !(sim->full & TS_FULL_ACTIVE_PAIRS);

	for (int d = 0; d < 3; d++) /* periodic images move with the box */
		bounded &= ts_box_length(&sim->domain->box, d) == vw->length[d];
	vw->travelled = vw->surface->travelled;
	return bounded ? step : INFINITY;
}

/* Distance up to which contact points of the particle count. */
static double reach_of(const struct force_task *t, double radius)
{
	return radius + (t->pulls ? ts_wall_reach(t->w, t->sim, radius) : 0);
}

/* Adds the displacement of this step to the travel of the particle; whether it may have a contact point. */
static bool update_travel(const struct force_task *t, struct ts_voxel_neighbor *v)
{
	const struct ts_particles *p = t->sim->particles;
	const double *x = p->x[v->i];
	double reach = reach_of(t, p->radius[v->i]), step = sqrt(ts_distance2(x, v->place));

	v->travel += reach == v->reach ? step + t->step : INFINITY;
	ts_scale(1, x, v->place);
	v->reach = reach;
	return !(v->travel < v->check_travel);
}

/* Stores the travel after which a particle may have a contact point; false: it may have one now. */
static bool is_out_of_reach(const struct force_task *t, const struct ts_voxel_images *images,
			    struct ts_voxel_neighbor *v)
{
	const struct ts_voxel_field *f = &t->vw->surface->field;
	double look = v->reach + t->sim->neigh->built_skin, least = look, size = 0, far;

	for (int k = 0; k < images->n; k++) {
		least = fmin(least, ts_voxel_distance(f, images->x[k], look));
		for (int d = 0; d < 3; d++)
			size = fmax(size, fabs(images->x[k][d]));
	}
	/* less than the distance by more than the rounding of it and of a sum of many steps */
	far = (1 - 1e-7) * (least - v->reach) - 1e-12 * (look + size);
	v->travel = 0;
	v->check_travel = far > 0 ? far : -INFINITY;
	return far > 0;
}

/* Stores the contact points of a particle, as many as it has slots, and counts all; unless none is possible. */
static void find_points(const struct force_task *t, struct ts_voxel_neighbor *v)
{
	const struct ts_particles *p = t->sim->particles;
	const struct ts_voxel_field *f = &t->vw->surface->field;
	struct ts_voxel_wall *vw = t->vw;
	bool touched = v->found > 0;
	struct ts_voxel_images images;

	v->found = 0;
	v->waits = !update_travel(t, v);
	if (v->waits)
		return;
	ts_voxel_images(vw->surface, &t->sim->domain->box, p->x[v->i], &images);
	v->check_travel = -INFINITY;
	if (!touched && is_out_of_reach(t, &images, v))
		return;
	for (int k = 0; k < images.n; k++) {
		size_t room = v->found < v->slots ? v->slots - v->found : 0, from = v->first + v->found;
		size_t n = ts_voxel_contacts(f, images.x[k], v->reach, vw->at + from, room);

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

/* ---- contact points in the contact area of a deeper one */

static void swap_points(const struct ts_voxel_wall *vw, size_t a, size_t b)
{
	struct ts_voxel_contact at = vw->at[a];
	double column = vw->column[a];

	vw->at[a] = vw->at[b];
	vw->at[b] = at;
	vw->column[a] = vw->column[b];
	vw->column[b] = column;
}

/* Whether point b lies in the contact area of point a of a sphere of this radius: within a distance of
 * sqrt(2 (R^2 - d_a^2)). Positions relative to the centre are -d n. */
static bool is_in_area(const struct ts_voxel_contact *a, const struct ts_voxel_contact *b, double radius)
{
	double away[3];

	for (int d = 0; d < 3; d++)
		away[d] = a->distance * a->n[d] - b->distance * b->n[d];
	return ts_dot(away, away) < 2 * (radius * radius - a->distance * a->distance);
}

/* Keeps the deepest point of each contact area. */
static void merge_points(const struct ts_voxel_wall *vw, struct ts_voxel_neighbor *v, double radius)
{
	size_t kept = v->first, end = v->first + v->found;

	for (size_t k = v->first; k < end; k++) {
		bool merged = false;

		for (size_t m = k + 1; m < end; m++)
			if (vw->at[m].distance < vw->at[k].distance)
				swap_points(vw, k, m);
		for (size_t m = v->first; m < kept && !merged; m++)
			merged = is_in_area(&vw->at[m], &vw->at[k], radius);
		if (!merged)
			swap_points(vw, kept++, k);
	}
	v->found = kept - v->first;
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
			if (!(ts_voxel_memory(c, k)[TS_VOXEL_COLUMN] < column) &&
			    !(ts_voxel_memory(c, k)[TS_VOXEL_COLUMN] > column))
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
		const double *own = ts_voxel_memory(c, k);
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
	struct ts_wall_contact_point *point = ts_wall_queue_next(q);
	size_t k = t->vw->slot[at];
	double *own = ts_voxel_memory(c, k);

	*point = (struct ts_wall_contact_point){ .distance = from->distance,
						 .type = (int)s->type,
						 .mesh = 1,
						 .triangle = (int)ts_voxel_column_index(t->vw->column[at]),
						 .observed = q->w->observers[0] != 0,
						 .warm = !isnan(s->temperature),
						 .temperature = s->temperature };
	for (int d = 0; d < 3; d++) {
		point->n[d] = from->n[d];
		point->velocity[d] = s->velocity[d];
	}
	if (!ts_wall_touches(q, k, point)) {
		ts_wall_contact_end(c, k);
		return;
	}
	own[TS_VOXEL_COLUMN] = t->vw->column[at];
	for (int d = 0; d < 3; d++)
		own[TS_VOXEL_NORMAL + d] = from->n[d];
	if (!isnan(s->winkler))
		ts_voxel_foundation_yield(s, q, k, point);
	ts_wall_enqueue_contact(q, k, point);
}

/* In the order of slots, in which the forces of a particle are summed. */
static void compute_neighbor(const struct force_task *t, struct ts_wall_queue *q, struct ts_voxel_neighbor *v)
{
	const struct ts_voxel_wall *vw = t->vw;

	if (v->waits) /* as most particles near the surface */
		return;
	for (size_t k = v->first; !v->found && k < v->first + v->slots; k++)
		ts_wall_contact_end(&t->w->contacts, k);
	if (!v->found)
		return;
	if (vw->surface->merges && v->found > 1)
		merge_points(vw, v, t->sim->particles->radius[v->i]);
	match_points(&t->w->contacts, vw, v);
	for (size_t k = v->first; k < v->first + v->slots; k++)
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

enum ts_status ts_voxel_wall_enqueue_contacts(struct ts_instance *self, struct tsim *sim)
{
	struct ts_wall *w = self->state;
	struct ts_voxel_wall *vw = ts_voxel_wall_of(w);
	struct force_task task = { sim, w, vw, ts_wall_long_ranged(w, sim), max_approach(sim, vw) };

	find_all(&task);
	if (is_full(vw)) {
		TS_TRY(ts_voxel_wall_list_slots(self, sim, true));
		find_all(&task);
	}
	ts_parallel(ts_team(sim, 4 * vw->nneighbors), vw->nneighbors, compute_range, &task);
	ts_wall_finish(w);
	return ts_coincide_wall(sim, w);
}
