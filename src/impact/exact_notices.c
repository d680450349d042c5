#include "impact/exact_notices.h"

#include "base/sort.h"
#include "core/ranks.h"

#include "base/banned.h"

/* A contact is resolved by the steps if it lasts for so many of them. */
static const double RESOLVED = 10;

struct scene {
	struct tsim *sim;
	const struct ts_exact_target *target;
	size_t targets;
};

double *ts_exact_warned(struct ts_exact_impacts *e, bool member)
{
	return member ? &e->warned_body : &e->warned_left;
}

static int by_tag(const void *a, const void *b)
{
	const struct ts_exact_notice *p = a, *q = b;

	if (p->tag != q->tag)
		return p->tag < q->tag ? -1 : 1;
	return p->many - q->many;
}

/* The surface and the particle must not pass each other before a contact force acts. */
static enum ts_status check_left(const struct scene *s, const struct ts_exact_notice *left)
{
	const struct ts_instance *by = s->target[left->target].by;
	double way = left->speed * s->sim->clock.dt;

	if (!(way > left->radius))
		return TS_OK;
	return ts_fail(&s->sim->error, TS_PHYSICS, &by->where,
		       "impact exact: particle %d %s, so its contact with wall %s is resolved by time steps; "
		       "but they approach each other by %g in a step, more than its radius %g; use a shorter "
		       "time step",
		       left->tag, left->member ? "is in a rigid body" : "touches another particle, too",
		       by->id, way, left->radius);
}

static void warn_left(const struct scene *s, const struct ts_exact_notice *left)
{
	struct ts_exact_impacts *e = s->target[left->target].wall->exact;
	const struct ts_instance *by = s->target[left->target].by;
	double h = s->sim->clock.dt, *warned = ts_exact_warned(e, left->member);

	if (*warned > 0 || !(left->duration > 0 && left->duration < RESOLVED * h))
		return;
	*warned = 1;
	if (!ts_ranks_first(s->sim))
		return;
	if (left->member)
		ts_warn(&s->sim->log, &by->where,
			"impact exact: particle %d is in a rigid body, whose contacts with wall %s are "
			"resolved by time steps; this one lasts about %.3g, only %.2g steps of %g",
			left->tag, by->id, left->duration, left->duration / h, h);
	else
		ts_warn(&s->sim->log, &by->where,
			"impact exact: particle %d touches another particle and wall %s in the same step, so "
			"this contact is resolved by time steps; it lasts %.3g, only %.2g steps of %g",
			left->tag, by->id, left->duration, left->duration / h, h);
}

static enum ts_status store_left(const struct scene *s, const struct ts_exact_notice *left)
{
	TS_TRY(check_left(s, left));
	for (size_t k = 0; k < s->targets; k++) { /* what it meets next may be any of the walls */
		struct ts_exact_impacts *o = s->target[k].wall->exact;

		if (TS_GROW(o->left, o->left_capacity, o->nleft + 1) != TS_OK)
			return ts_nomem(&s->sim->error);
		o->left[o->nleft++] = left->tag;
	}
	warn_left(s, left);
	return TS_OK;
}

static void warn_many(const struct scene *s, const struct ts_exact_notice *many)
{
	struct ts_exact_impacts *e = s->target[0].wall->exact;
	bool again = e->warned_many > 0;

	e->warned_many = 1;
	if (again || !ts_ranks_first(s->sim))
		return;
	ts_warn(&s->sim->log, &s->target[0].by->where,
		"impact exact: particle %d at (%g %g %g) has had %d impacts in one step, as between two "
		"surfaces nearer to each other than its diameter; it stays where it is for the rest of the "
		"step",
		many->tag, many->x[0], many->x[1], many->x[2], TS_EXACT_MOST);
}

enum ts_status ts_exact_tell(struct tsim *sim, const struct ts_exact_target *target, size_t targets,
			     struct ts_exact_notices *notices)
{
	const struct scene s = { sim, target, targets };

	ts_sort(notices->item, notices->n, sizeof *notices->item, by_tag);
	for (size_t k = 0; k < notices->n; k++) {
		const struct ts_exact_notice *notice = &notices->item[k];

		if (notice->many)
			warn_many(&s, notice);
		else
			TS_TRY(store_left(&s, notice));
	}
	return TS_OK;
}
