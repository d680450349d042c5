#include "wall/mesh_wall_queue.h"

#include <math.h>

#include "base/parallel.h"
#include "mesh/mesh_distance.h"
#include "wall/mesh_stick.h"
#include "wall/wall_coincide.h"
#include "wall/wall_queue.h"

#include "base/banned.h"

/* Across a periodic face the image of a triangle may be the neighbour. */
static bool same_surface(const struct ts_mesh_wall *mw, size_t a, size_t b)
{
	const struct ts_mesh_near *p = &mw->near[a], *q = &mw->near[b];

	return a != b && p->mesh == q->mesh &&
	       ts_mesh_flat_neighbours(&mw->mesh[p->mesh].surface->mesh, (size_t)p->triangle,
				       (size_t)q->triangle);
}

/* A new contact, among those from..to-1 of the particle. False: a flat neighbour has it. */
static bool begin_contact(struct ts_wall *w, const struct ts_mesh_wall *mw, size_t from, size_t to, size_t k,
			  enum ts_mesh_part part)
{
	const struct ts_wall_contacts *c = &w->contacts;

	for (size_t j = from; j < to && part == TS_MESH_FACE; j++)
		if (mw->near[j].done && same_surface(mw, j, k))
			return false;
	for (size_t j = from; j < to; j++)
		if (*ts_mesh_alive(c, j) > 0 && !mw->near[j].done && same_surface(mw, j, k))
			for (size_t m = 0; m < c->width; m++)
				ts_wall_memory(c, k)[m] = ts_wall_memory(c, j)[m];
	*ts_mesh_alive(c, k) = 1;
	return true;
}

struct task {
	struct tsim *sim;
	struct ts_wall *w;
	struct ts_mesh_wall *mw;
	double step; /* of the meshes since the last time, at most; infinite: all contacts are looked at */
};

/* Whether there is no touch yet, and when there may be. */
static bool waits(const struct ts_mesh *m, struct ts_mesh_near *near, const struct ts_mesh_neighbor *v,
		  const double x[3])
{
	double far = ts_mesh_wall_safe_way(m, near->triangle, ts_mesh_distance(m, (size_t)near->triangle, x),
					   v->radius);

	near->until = far > 0 ? v->way + far : -INFINITY;
	return far > 0;
}

static void make_spot(const struct ts_mesh_surface *s, const struct ts_mesh_near *near,
		      const struct ts_mesh_contact_point *at, struct ts_wall_contact_point *spot)
{
	for (int d = 0; d < 3; d++)
		spot->n[d] = at->n[d];
	spot->distance = at->distance;
	ts_mesh_surface_velocity(s, (size_t)near->triangle, at->weight, spot->velocity);
	spot->curvature = 0;
	spot->sums = s->observed;
	spot->type = (int)s->type;
	spot->mesh = near->mesh + 1;
	spot->triangle = near->triangle;
	spot->warm = !isnan(s->temperature);
	spot->temperature = s->temperature;
}

static void push(const struct task *task, struct ts_wall_queue *q, const struct ts_mesh_neighbor *v, size_t k)
{
	struct ts_wall *w = task->w;
	struct ts_mesh_near *near = &task->mw->near[k];
	const struct ts_mesh_surface *s = task->mw->mesh[near->mesh].surface;
	size_t t = (size_t)near->triangle;
	struct ts_wall_contact_point spot;
	struct ts_mesh_contact_point at;
	enum ts_mesh_part part;
	double x[3];

	ts_mesh_wall_place(task->sim, near, v->i, x);
	if (!w->contacts.touching[k] && waits(&s->mesh, near, v, x))
		return;
	part = ts_mesh_nearest(&s->mesh, t, x, &at);
	near->done = part != TS_MESH_NOTHING && at.distance <= v->radius &&
		     (*ts_mesh_alive(&w->contacts, k) > 0 ||
		      begin_contact(w, task->mw, v->first, v->first + v->n, k, part));
	near->until = -INFINITY;
	if (!near->done)
		return;
	make_spot(s, near, &at, &spot);
	ts_wall_enqueue_contact(q, k, &spot);
}

/* Notes where the particle is now; whether one of its contacts may touch. */
static bool moves(const struct task *task, struct ts_mesh_neighbor *v)
{
	const struct ts_particles *p = task->sim->particles;
	const double *x = p->x[v->i];
	double step = sqrt(ts_distance2(x, v->place));

	/* after a particle has grown nothing is known */
	v->way += p->radius[v->i] == v->radius ? step + task->step : INFINITY;
	ts_scale(1, x, v->place);
	v->radius = p->radius[v->i];
	return !(v->way < v->until);
}

/* A surface that acts beyond the touch: whether the contact k, which has a place of its own, is one. */
static bool meets(const struct task *task, struct ts_wall_queue *q, const struct ts_mesh_neighbor *v,
		  size_t k, struct ts_wall_contact_point *spot)
{
	const struct ts_wall_contacts *c = &task->w->contacts;
	const struct ts_mesh_near *near = &task->mw->near[k];
	size_t from = *ts_mesh_alive(c, k) > 0 ? k : ts_mesh_donor(task->mw, c, v, k);

	make_spot(task->mw->mesh[near->mesh].surface, near, &task->mw->place[k].at, spot);
	for (size_t m = 0; m < c->width && from != SIZE_MAX; m++)
		ts_wall_memory(c, k)[m] = ts_wall_memory(c, from)[m];
	if (ts_wall_touches(q, k, spot))
		return true;
	for (size_t m = 0; m < c->width && from != k; m++)
		ts_wall_memory(c, k)[m] = 0;
	return false;
}

static void visit_sticking(const struct task *task, struct ts_wall_queue *q, const struct ts_mesh_neighbor *v)
{
	struct ts_mesh_wall *mw = task->mw;
	double begins = v->radius + ts_mesh_wall_outreach(task->sim, task->w, v->radius);

	ts_mesh_places(task->sim, mw, v, ts_wall_reach(task->w, task->sim, v->radius));
	for (size_t k = v->first; k < v->first + v->n; k++) {
		struct ts_mesh_near *near = &mw->near[k];
		struct ts_wall_contact_point spot;

		near->until = v->way + ts_mesh_wall_safe_way(&mw->mesh[near->mesh].surface->mesh,
							     near->triangle, mw->place[k].distance, begins);
		near->done = mw->place[k].own && meets(task, q, v, k, &spot);
		if (!near->done)
			continue;
		near->until = -INFINITY;
		*ts_mesh_alive(&task->w->contacts, k) = 1;
		ts_wall_enqueue_contact(q, k, &spot);
	}
}

static void visit(const struct task *task, struct ts_wall_queue *q, struct ts_mesh_neighbor *v)
{
	struct ts_wall_contacts *c = &task->w->contacts;
	struct ts_mesh_near *near = task->mw->near;
	size_t end = v->first + v->n;

	if (!moves(task, v))
		return;
	for (size_t k = v->first; k < end; k++)
		near[k].done = false;
	if (q->sticks)
		visit_sticking(task, q, v);
	for (size_t k = v->first; k < end && !q->sticks; k++)
		if (c->touching[k] || !(v->way < near[k].until))
			push(task, q, v, k);
	v->until = INFINITY;
	for (size_t k = v->first; k < end; k++) {
		if (!near[k].done)
			ts_wall_contact_part(c, k);
		v->until = fmin(v->until, near[k].until);
	}
}

/* What a visit soon will need. */
TS_INLINE void send_for(const struct task *task, const struct ts_mesh_neighbor *v)
{
	const struct ts_wall_contacts *c = &task->w->contacts;
	bool touches = v->until < 0;

	ts_wall_prefetch_particle(task->sim->particles, v->i, touches);
	if (!touches)
		return;
	__builtin_prefetch(&task->mw->near[v->first]);
	__builtin_prefetch(&task->mw->near[v->first + v->n - 1]);
	__builtin_prefetch(ts_wall_memory(c, v->first), 1);
	__builtin_prefetch(ts_wall_memory(c, v->first + v->n - 1), 1);
}

static void push_share(void *context, size_t from, size_t end)
{
	const struct task *t = context;
	struct ts_mesh_neighbor *v = t->mw->visitor;
	struct ts_wall_queue queue;

	ts_wall_queue_start(&queue, t->w, t->sim);
	for (size_t k = from; k < end; k++) {
		send_for(t, &v[k + TS_WALL_AHEAD < end ? k + TS_WALL_AHEAD : k]);
		visit(t, &queue, &v[k]);
	}
	ts_wall_queue_end(&queue);
}

enum ts_status ts_mesh_wall_enqueue_contacts(struct tsim *sim, struct ts_wall *w, struct ts_mesh_wall *mw)
{
	struct task task = { sim, w, mw, ts_mesh_wall_come_nearer(sim, mw) };

	/* a contact is worth several particles of other loops */
	ts_parallel(ts_team(sim, 4 * w->contacts.n), mw->nvisitors, push_share, &task);
	ts_wall_finish(w);
	return ts_coincide_wall(sim, w);
}
