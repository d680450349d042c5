/* The forces of contacts with walls. Those that touch queue up, and are computed some dozens at a time, in
 * columns (wall/wall_batch.h); where there is no such loop for the model one after the other, with the
 * same bits. Each particle has its contacts added in their order. */
#ifndef TS_WALL_WALL_QUEUE_H
#define TS_WALL_WALL_QUEUE_H

#include "base/four.h"
#include "wall/wall.h"

/* Of one share of a wall's contacts. */
struct ts_wall_queue {
	const struct ts_wall *w;
	struct tsim *sim;
	const struct ts_granular_model *model;
	bool sticks; /* surfaces act beyond their touch */
	size_t n;
	size_t contact[TS_BATCH];
	struct ts_wall_contact_point spot[TS_BATCH];
};

void ts_wall_queue_start(struct ts_wall_queue *q, const struct ts_wall *w, struct tsim *sim);
/* Whether the contact k is one at the spot: they touch, or have met and stick. */
bool ts_wall_sticks(const struct ts_wall_queue *q, size_t k, const struct ts_wall_contact_point *spot);
static inline bool ts_wall_touches(const struct ts_wall_queue *q, size_t k,
				   const struct ts_wall_contact_point *spot)
{
	return q->sticks ? ts_wall_sticks(q, k, spot)
			 : spot->distance < q->sim->particles->radius[q->w->contacts.row[k]];
}
/* The contact k touches at the spot: force and torque on the particle, force on the wall. */
void ts_wall_enqueue_contact(struct ts_wall_queue *q, size_t k, const struct ts_wall_contact_point *spot);
/* Does all that wait. */
void ts_wall_queue_end(struct ts_wall_queue *q);

/* Three numbers may lie in two lines of the caches. Inlined always: a function that only asks for memory
 * is taken for one that does nothing, and calls of it are left out. */
TS_INLINE void ts_wall_prefetch(const double x[3])
{
	__builtin_prefetch(x);
	__builtin_prefetch(x + 2);
}

/* Particles at a wall are scattered in memory: what will be needed of one soon; `all`: if it touches. */
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

/* A loop over contacts up to `end` is at k. */
enum { TS_WALL_AHEAD = 12 };
TS_INLINE void ts_wall_look_ahead(const struct ts_wall_contacts *c, const struct ts_particles *p, size_t k,
				  size_t end)
{
	size_t next = k + TS_WALL_AHEAD < end ? k + TS_WALL_AHEAD : k;

	ts_wall_prefetch_particle(p, (size_t)c->row[next], c->touching[next]);
}

#endif
