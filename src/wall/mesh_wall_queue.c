#include "wall/mesh_wall_queue.h"

#include <math.h>

#include "base/parallel.h"
#include "mesh/mesh_distance.h"
#include "wall/mesh_crowd.h"
#include "wall/mesh_stick.h"
#include "wall/wall_coincide.h"
#include "wall/wall_queue.h"

#include "base/banned.h"

static bool are_flat_neighbours(const struct ts_mesh_wall *mw, size_t a, size_t b)
{
	const struct ts_mesh_near *p = &mw->near[a], *q = &mw->near[b];

	return a != b && p->mesh == q->mesh &&
	       ts_mesh_flat_neighbours(&mw->mesh[p->mesh].surface->mesh, (size_t)p->triangle,
				       (size_t)q->triangle) &&
	       ts_mesh_wall_adjoin(mw, a, b);
}

/* Starts contact k, one of the contacts from .. to-1 of a particle, with the history of a contact that
 * ends on a flat neighbour. False: a flat neighbour has the contact. */
static bool begin_contact(struct ts_wall *w, const struct ts_mesh_wall *mw, size_t from, size_t to, size_t k,
			  enum ts_mesh_part part)
{
	const struct ts_wall_contacts *c = &w->contacts;

	for (size_t j = from; j < to && part == TS_MESH_FACE; j++)
		if (mw->near[j].touches && are_flat_neighbours(mw, j, k))
			return false;
	for (size_t j = from; j < to; j++)
		if (*ts_mesh_contact_exists(c, j) > 0 && !mw->near[j].touches &&
		    are_flat_neighbours(mw, j, k))
			for (size_t m = 0; m < c->width; m++)
				ts_wall_memory(c, k)[m] = ts_wall_memory(c, j)[m];
	*ts_mesh_contact_exists(c, k) = 1;
	return true;
}

struct force_task {
	struct tsim *sim;
	struct ts_wall *w;
	struct ts_mesh_wall *mw;
	/* upper bound of the displacement of the meshes since the last force computation, length; infinite:
	 * all contacts are evaluated */
	double step;
};

/* Whether particle and triangle are still apart; stores the travel at which they may touch. */
static bool is_out_of_reach(const struct ts_mesh *m, struct ts_mesh_near *near,
			    const struct ts_mesh_neighbor *v, const double x[3])
{
	double far = ts_mesh_wall_safe_travel(m, near->triangle,
					      ts_mesh_distance(m, (size_t)near->triangle, x), v->radius);

	near->check_travel = far > 0 ? v->travel + far : -INFINITY;
	return far > 0;
}

static void make_contact_point(const struct force_task *task, const struct ts_mesh_near *near,
			       const struct ts_mesh_contact_point *at, struct ts_wall_contact_point *point)
{
	const struct ts_mesh_surface *s = task->mw->mesh[near->mesh].surface;

	for (int d = 0; d < 3; d++)
		point->n[d] = at->n[d];
	point->distance = at->distance;
	ts_mesh_surface_velocity(s, (size_t)near->triangle, at->weight, point->velocity);
	point->curvature = 0;
	point->observed = task->w->observers[near->mesh] != 0;
	point->type = (int)s->type;
	point->mesh = near->mesh + 1;
	point->triangle = near->triangle;
	point->warm = !isnan(s->temperature);
	point->temperature = s->temperature;
}

static void compute_triangle(const struct force_task *task, struct ts_wall_queue *q,
			     const struct ts_mesh_neighbor *v, size_t k)
{
	struct ts_wall *w = task->w;
	struct ts_mesh_near *near = &task->mw->near[k];
	const struct ts_mesh_surface *s = task->mw->mesh[near->mesh].surface;
	size_t t = (size_t)near->triangle;
	struct ts_mesh_contact_point at;
	enum ts_mesh_part part;
	double x[3];

	ts_mesh_wall_position(task->sim, near, v->i, x);
	if (!w->contacts.touching[k] && is_out_of_reach(&s->mesh, near, v, x))
		return;
	part = ts_mesh_is_removed(&s->mesh, t) ? TS_MESH_NOTHING : ts_mesh_nearest(&s->mesh, t, x, &at);
	near->touches = part != TS_MESH_NOTHING && at.distance <= v->radius &&
			(*ts_mesh_contact_exists(&w->contacts, k) > 0 ||
			 begin_contact(w, task->mw, v->first, v->first + v->n, k, part));
	near->check_travel = -INFINITY;
	if (!near->touches)
		return;
	make_contact_point(task, near, &at, ts_wall_queue_next(q));
	ts_wall_enqueue_contact(q, k, ts_wall_queue_next(q));
}

/* Adds the displacement of this step to the travel of the particle; whether one of its contacts may touch. */
static bool update_travel(const struct force_task *task, struct ts_mesh_neighbor *v)
{
	const struct ts_particles *p = task->sim->particles;
	const double *x = p->x[v->i];
	double step = sqrt(ts_distance2(x, v->place));

	/* if the radius has changed, all contacts are evaluated */
	v->travel += p->radius[v->i] == v->radius ? step + task->step : INFINITY;
	ts_scale(1, x, v->place);
	v->radius = p->radius[v->i];
	return !(v->travel < v->check_travel);
}

/* For laws that act at a distance: whether pair k, which has a contact point of its own, interacts. A new
 * contact takes over the history of one that has lost its contact point. */
static bool continue_contact(const struct force_task *task, struct ts_wall_queue *q,
			     const struct ts_mesh_neighbor *v, size_t k, struct ts_wall_contact_point *point)
{
	const struct ts_wall_contacts *c = &task->w->contacts;
	const struct ts_mesh_near *near = &task->mw->near[k];
	size_t from = *ts_mesh_contact_exists(c, k) > 0 ? k : ts_mesh_donor(task->mw, c, v, k);

	make_contact_point(task, near, &task->mw->place[k].at, point);
	for (size_t m = 0; m < c->width && from != SIZE_MAX; m++)
		ts_wall_memory(c, k)[m] = ts_wall_memory(c, from)[m];
	if (ts_wall_touches(q, k, point))
		return true;
	for (size_t m = 0; m < c->width && from != k; m++)
		ts_wall_memory(c, k)[m] = 0;
	return false;
}

static void compute_long_ranged(const struct force_task *task, struct ts_wall_queue *q,
				const struct ts_mesh_neighbor *v)
{
	struct ts_mesh_wall *mw = task->mw;
	double begins = v->radius + ts_mesh_wall_onset_distance(task->sim, task->w, v->radius);

	ts_mesh_places(task->sim, mw, v, ts_wall_reach(task->w, task->sim, v->radius));
	for (size_t k = v->first; k < v->first + v->n; k++) {
		struct ts_mesh_near *near = &mw->near[k];
		struct ts_wall_contact_point *point = ts_wall_queue_next(q);

		near->check_travel =
			v->travel + ts_mesh_wall_safe_travel(&mw->mesh[near->mesh].surface->mesh,
							     near->triangle, mw->place[k].distance, begins);
		near->touches = mw->place[k].own && continue_contact(task, q, v, k, point);
		if (!near->touches)
			continue;
		near->check_travel = -INFINITY;
		*ts_mesh_contact_exists(&task->w->contacts, k) = 1;
		ts_wall_enqueue_contact(q, k, point);
	}
}

static void compute_neighbor(const struct force_task *task, struct ts_wall_queue *q,
			     struct ts_mesh_neighbor *v)
{
	struct ts_wall_contacts *c = &task->w->contacts;
	struct ts_mesh_near *near = task->mw->near;
	size_t end = v->first + v->n, touches = 0;

	if (!update_travel(task, v))
		return;
	for (size_t k = v->first; k < end; k++)
		near[k].touches = false;
	if (q->long_ranged)
		compute_long_ranged(task, q, v);
	for (size_t k = v->first; k < end && !q->long_ranged; k++)
		if (c->touching[k] || !(v->travel < near[k].check_travel))
			compute_triangle(task, q, v, k);
	v->check_travel = INFINITY;
	for (size_t k = v->first; k < end; k++) {
		if (!near[k].touches)
			ts_wall_contact_end(c, k);
		touches += near[k].touches;
		v->check_travel = fmin(v->check_travel, near[k].check_travel);
	}
	if (touches >= TS_MESH_CROWD && !q->long_ranged && !task->mw->crowd.told)
		ts_mesh_crowd_look(task->sim, task->mw, v);
}

/* Prefetches the data that the computation of particle `v` will read. */
TS_INLINE void prefetch_neighbor(const struct force_task *task, const struct ts_mesh_neighbor *v)
{
	const struct ts_wall_contacts *c = &task->w->contacts;
	bool touches = v->check_travel < 0;

	ts_wall_prefetch_particle(task->sim->particles, v->i, touches);
	if (!touches)
		return;
	__builtin_prefetch(&task->mw->near[v->first]);
	__builtin_prefetch(&task->mw->near[v->first + v->n - 1]);
	__builtin_prefetch(ts_wall_memory(c, v->first), 1);
	__builtin_prefetch(ts_wall_memory(c, v->first + v->n - 1), 1);
}

static void compute_range(void *context, size_t from, size_t end)
{
	const struct force_task *t = context;
	struct ts_mesh_neighbor *v = t->mw->neighbor;
	struct ts_wall_queue queue;

	ts_wall_queue_start(&queue, t->w, t->sim);
	for (size_t k = from; k < end; k++) {
		prefetch_neighbor(t, &v[k + TS_WALL_AHEAD < end ? k + TS_WALL_AHEAD : k]);
		compute_neighbor(t, &queue, &v[k]);
	}
	ts_wall_queue_end(&queue);
}

enum ts_status ts_mesh_wall_enqueue_contacts(struct ts_instance *self, struct tsim *sim)
{
	struct ts_wall *w = self->state;
	struct ts_mesh_wall *mw = ts_mesh_wall_of(w);
	struct force_task task = { sim, w, mw, ts_mesh_wall_max_approach(sim, mw) };

	/* a contact costs as much as about 4 particles of simple loops */
	ts_parallel(ts_team(sim, 16 * w->contacts.n), mw->nneighbors, compute_range, &task);
	ts_wall_finish(w);
	ts_mesh_crowd_tell(self, sim, mw);
	return ts_coincide_wall(sim, w);
}
