/* Forces of wall contacts. Touching contacts are queued and computed in batches of TS_BATCH by vector
 * instructions (wall/wall_batch.h); contact by contact if there is no such loop for the model, with the same
 * results bit for bit. Forces are added to each particle in the order of its contacts. */
#ifndef TS_WALL_WALL_QUEUE_H
#define TS_WALL_WALL_QUEUE_H

#include "base/four.h"
#include "wall/wall.h"

/* The queue of one thread. */
struct ts_wall_queue {
	const struct ts_wall *w;
	struct tsim *sim;
	const struct ts_granular_model *model;
	bool long_ranged; /* the law acts at a distance */
	size_t n;	  /* queued contacts */
	size_t contact[TS_BATCH];
	struct ts_wall_contact_point point[TS_BATCH];
};

void ts_wall_queue_start(struct ts_wall_queue *q, const struct ts_wall *w, struct tsim *sim);
/* Whether contact k interacts at this contact point under a law that acts at a distance: the surfaces
 * touch, or have touched and are still within the range of adhesion or of the liquid bridge. */
bool ts_wall_in_range(const struct ts_wall_queue *q, size_t k, const struct ts_wall_contact_point *point);
/* The same for any law. */
static inline bool ts_wall_touches(const struct ts_wall_queue *q, size_t k,
				   const struct ts_wall_contact_point *point)
{
	return q->long_ranged ? ts_wall_in_range(q, k, point)
			      : point->distance < q->sim->particles->radius[q->w->contacts.row[k]];
}
/* The place of the next contact point in the queue, which may be filled in before it is known whether the contact
 * touches: a point that is made elsewhere is copied, and the copy waits for the stores. */
static inline struct ts_wall_contact_point *ts_wall_queue_next(struct ts_wall_queue *q)
{
	return &q->point[q->n];
}
/* Queues contact k, which touches at this contact point: its force and torque act on the particle, the
 * opposite force on the wall. */
void ts_wall_enqueue_contact(struct ts_wall_queue *q, size_t k, const struct ts_wall_contact_point *point);
/* The input of the contact law for contact k at this contact point. */
void ts_wall_queue_touch(const struct ts_wall_queue *q, size_t k, const struct ts_wall_contact_point *point,
			 struct ts_touch *t);
/* Computes the contacts that are queued. */
void ts_wall_queue_end(struct ts_wall_queue *q);

/* A vector may lie in two cache lines. Always inlined: the compiler takes a function that only prefetches for
 * one without effect, and removes calls of it. */
TS_INLINE void ts_wall_prefetch(const double x[3])
{
	__builtin_prefetch(x);
	__builtin_prefetch(x + 2);
}

/* Prefetches the data of particle i, as particles at a wall are scattered in memory. `all`: it touches, so
 * the force computation needs its velocity, mass and force, too. */
TS_INLINE void ts_wall_prefetch_particle(const struct ts_particles *p, size_t i, bool all)
{
	ts_wall_prefetch(p->x[i]);
	__builtin_prefetch(p->radius + i);
	if (!all)
		return;
	__builtin_prefetch(p->imass + i);
	__builtin_prefetch(p->mass + i);
	ts_wall_prefetch(p->v[i]);
	ts_wall_prefetch(p->f[i]);
	if (p->omega)
		ts_wall_prefetch(p->omega[i]);
	if (p->torque)
		ts_wall_prefetch(p->torque[i]);
}
/* The same for what is stored of contact k, which touches. */
TS_INLINE void ts_wall_prefetch_contact(const struct ts_wall_contacts *c, size_t k)
{
	__builtin_prefetch(ts_wall_memory(c, k), 1);
	__builtin_prefetch(&c->last[k], 1);
	__builtin_prefetch(c->force[k], 1);
}

/* In a loop over contacts up to `end` that is at contact k: prefetches the particle of contact k +
 * TS_WALL_AHEAD. */
enum { TS_WALL_AHEAD = 12 };
TS_INLINE void ts_wall_prefetch_ahead(const struct ts_wall_contacts *c, const struct ts_particles *p,
				      size_t k, size_t end)
{
	size_t next = k + TS_WALL_AHEAD < end ? k + TS_WALL_AHEAD : k;

	ts_wall_prefetch_particle(p, (size_t)c->row[next], c->touching[next]);
	if (c->touching[next])
		ts_wall_prefetch_contact(c, next);
}

#endif
