#include "impact/exact_impacts.h"

#include <math.h>
#include <string.h>

#include "base/parallel.h"
#include "base/sort.h"
#include "box/domain.h"
#include "core/deferred_loops.h"
#include "core/report.h"
#include "integrate/integrators.h"
#include "neigh/neigh.h"
#include "particle/columns.h"
#include "particle/copies.h"
#include "particle/sphere_shape.h"
#include "rigid/rigid.h"
#include "impact/exact_collision.h"
#include "impact/exact_notices.h"
#include "impact/exact_sharing.h"
#include "impact/impacts.h"
#include "wall/mesh_wall.h"
#include "wall/surface.h"

#include "base/banned.h"

/* Overlaps up to this part of the radius are rounding errors of the position. */
static const double NEGLIGIBLE = 1e-9;
/* ---- arguments and checks ---- */

enum ts_status ts_exact_init(struct ts_instance *self, struct tsim *sim,
			     const struct ts_exact_surface *surface, void *shape)
{
	struct ts_wall *w = self->state;

	if (!w->exact)
		w->exact = ts_arena_alloc(&self->arena, 1, sizeof *w->exact);
	if (!w->exact)
		return ts_nomem(&sim->error);
	w->exact->surface = surface;
	w->exact->shape = shape;
	return ts_particles_add_column(sim, "impact_wait", 1, TS_COL_NAMED, &w->exact->wait);
}

static enum ts_status refuse(struct ts_instance *self, struct tsim *sim, const char *why)
{
	return ts_fail(&sim->error, TS_STATE, ts_instance_word(self, "impact"),
		       "fix %s impact exact: %s; leave `impact exact` out", self->style->name, why);
}

/* Those of resolved contacts only. */
static enum ts_status refuse_observers(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_wall *w = self->state;

	for (size_t k = 0; k < ts_wall_surfaces(w); k++) {
		const struct ts_instance *by = ts_surface_observer(sim, ts_wall_surface(w, k),
								   TS_OBSERVES_CONTACTS, TS_OBSERVES_BRIEF);

		if (by)
			return ts_fail(&sim->error, TS_STATE, ts_instance_word(self, "impact"),
				       "fix %s impact exact: fix %s %s reads resolved contacts only and "
				       "would miss the impacts; leave `impact exact` out",
				       self->style->name, by->style->name, by->id);
	}
	return TS_OK;
}

/* The first wall that takes part: its copies are sent once more. */
static bool is_first(const struct ts_instance *self, const struct tsim *sim)
{
	const struct ts_instance *by = NULL;
	struct ts_wall *w;

	for (size_t k = 0; (w = ts_walls_next(sim, &k, &by)) && !w->exact;)
		;
	return w && by == self;
}

enum ts_status ts_exact_plan(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report)
{
	const struct ts_wall *w = self->state;
	const char *why;

	if (is_first(self, sim)) {
		report->copied.messages++;
		report->copied.bytes += (double)ts_copies_step_bytes(sim->particles);
		report->shared.messages++;
	}
	if (!ts_wall_has_law(w, sim))
		return TS_OK; /* refused by ts_wall_plan */
	if (w->exact->surface->plan)
		TS_TRY(w->exact->surface->plan(sim, w->exact->shape));
	why = ts_collision_unsupported(ts_wall_model(w, sim));
	if (sim->run.explicit_euler || sim->run.clamped)
		why = "the integrator must move particles by h v, as fix nve and fix nve/sphere do";
	else if (w->warm && ts_wall_heats(sim))
		why = "heat is conducted in resolved contacts only";
	return why ? refuse(self, sim, why) : refuse_observers(self, sim);
}

enum ts_status ts_exact_archive(struct ts_archive *a, struct tsim *sim, struct ts_wall *w)
{
	double warned[2];

	if (!w->exact)
		return TS_OK;
	if (ts_archive_has(a, "impact_warned_body"))
		TS_TRY(ts_archive_fixed(a, "impact_warned_body", TS_SAVED_F64, &w->exact->warned_body, 1));
	warned[0] = w->exact->warned_left;
	warned[1] = w->exact->warned_many;
	if (ts_archive_has(a, "impact_warned"))
		TS_TRY(ts_archive_fixed(a, "impact_warned", TS_SAVED_F64, warned, 2));
	w->exact->warned_left = warned[0];
	w->exact->warned_many = warned[1];
	return ts_particles_archive_column(a, sim, "impact_wait", w->exact->wait);
}

void ts_exact_fini(struct ts_wall *w)
{
	if (!w->exact)
		return;
	ts_free(w->exact->item);
	ts_free(w->exact->nodes.item);
	ts_free(w->exact->left);
}

const struct ts_exact_impact *ts_exact_impacts(const struct ts_wall *w, size_t *n)
{
	*n = w->exact ? w->exact->n : 0;
	return w->exact ? w->exact->item : NULL;
}

bool ts_exact_passes(const struct ts_wall *w, int32_t tag)
{
	bool left = !w->exact;

	for (size_t k = 0; !left && k < w->exact->nleft; k++)
		left = w->exact->left[k] == tag;
	return !left;
}

void ts_exact_add_force(struct ts_wall *w, const struct tsim *sim)
{
	if (sim->run.in_setup)
		return;
	for (size_t k = 0; w->exact && k < w->exact->n; k++)
		ts_axpy(-1 / sim->clock.dt, w->exact->item[k].push, w->force);
}

/* ---- the search of one step ---- */

struct found {
	struct ts_exact_impact impact;
	size_t target;
};

/* The new state of a particle. */
struct change {
	size_t i;
	double x[3], v[3], omega[3], wait;
};

/* What one thread finds. */
struct share {
	struct ts_mesh_list list;
	struct ts_contact_nodes nodes;
	struct found *found;
	struct change *change;
	struct ts_exact_notices notices;
	size_t nfound, nchanges, found_capacity, change_capacity;
	size_t failed; /* 1 + index of a particle whose collision could not be integrated */
	enum ts_status status;
};

struct search {
	struct tsim *sim;
	struct ts_exact_target *target;
	size_t targets, shares;
	struct share *share;
	const double *wait; /* by particle */
	uint32_t moving;    /* bits of the groups that are integrated */
};

/* A particle on its way through the step. */
struct flight {
	size_t i;
	double x[3], v[3], omega[3], time; /* since the begin of the step */
};

/* The first touch of the particle with any wall within the time `span`. */
static bool first_touch(const struct search *s, struct share *share, const struct flight *f, double span,
			struct ts_exact_touch *touch, size_t *target)
{
	const struct ts_particles *p = s->sim->particles;
	struct ts_sweep path = {
		{ f->x[0], f->x[1], f->x[2] }, { f->v[0], f->v[1], f->v[2] }, p->radius[f->i], span
	};
	bool any = false, found;

	for (size_t k = 0; k < s->targets; k++) {
		const struct ts_exact_impacts *e = s->target[k].wall->exact;
		struct ts_exact_touch t;

		if (!ts_in_group(p, f->i, s->target[k].by->group))
			continue;
		share->status = e->surface->sweep(s->sim, e->shape, f->i, &path, &share->list, &found, &t);
		if (share->status != TS_OK)
			return false;
		if (!found || (any && !(t.hit.time < touch->hit.time)))
			continue;
		any = true;
		*touch = t;
		*target = k;
	}
	return any;
}

/* Whether particle i comes nearer to j than the sum of the radii in the step. `x`: of j at its end. */
static bool meets(const struct ts_particles *p, size_t i, size_t j, const double x[3], double h)
{
	double d[3], v[3], v2, t, sum = p->radius[i] + p->radius[j];

	ts_sub(p->x[i], x, d);
	ts_sub(p->v[i], p->v[j], v);
	v2 = ts_dot(v, v);
	t = v2 > 0 ? fmax(-h, fmin(0, -ts_dot(d, v) / v2)) : 0;
	ts_axpy(t, v, d);
	return ts_dot(d, d) < sum * sum;
}

/* Of the pairs that are listed. */
static bool meets_other(const struct tsim *sim, size_t i)
{
	const struct ts_contact_list *list = &sim->neigh->contacts;
	const struct ts_particles *p = sim->particles;
	const struct ts_gather *g = &list->gather;

	if (!list->n || !g->first || list->particles != p->n)
		return false;
	for (size_t k = g->first[i]; k < g->first[i + 1]; k++) {
		size_t pair = g->entry[k] / 2, j = (size_t)(g->entry[k] % 2 ? list->i : list->j)[pair];
		double x[3];

		if (j >= p->n) {
			const int8_t *turns = p->ghost_shift[j - p->n];
			const double shift[3] = { turns[0], turns[1], turns[2] };

			j = (size_t)p->ghost_owner[j - p->n];
			for (int d = 0; d < 3; d++)
				x[d] = p->x[j][d] + ts_box_shift(&sim->domain->box, shift, d);
		} else {
			ts_scale(1, p->x[j], x);
		}
		if (meets(p, i, j, x, sim->clock.dt))
			return true;
	}
	return false;
}

static struct ts_collision collision_of(const struct search *s, const struct flight *f,
					const struct ts_exact_touch *t, size_t target)
{
	const struct ts_wall *w = s->target[target].wall;
	const struct ts_particles *p = s->sim->particles;
	struct ts_collision c = { .model = ts_wall_model(w, s->sim),
				  .law = ts_wall_law(w, s->sim, t->type, p->type[f->i]),
				  .mass = ts_rigid_inertial_mass(p, f->i),
				  .radius = p->radius[f->i],
				  .r_eff = ts_wall_effective_radius(p->radius[f->i], t->curvature),
				  .inertia = ts_inertia_factor(s->sim),
				  .longest = TS_EXACT_LONGEST * s->sim->clock.dt };

	ts_scale(1, t->hit.n, c.n);
	ts_sub(f->v, t->velocity, c.velocity);
	ts_scale(1, f->omega, c.omega);
	return c;
}

static struct ts_impact_event event_of(const struct search *s, const struct flight *f,
				       const struct ts_exact_touch *t, const struct ts_collision *c,
				       const struct ts_collision_result *r)
{
	const struct ts_particles *p = s->sim->particles;
	struct ts_impact_event e = { .tag = p->tag[f->i],
				     .type = p->type[f->i],
				     .element = (double)t->element,
				     .mass = c->mass,
				     .radius = c->radius,
				     .begin = ts_sim_time(s->sim) - s->sim->clock.dt + f->time,
				     .duration = r->duration,
				     .peak_force = r->peak_force,
				     .peak_overlap = r->peak_overlap,
				     .impulse = r->impulse,
				     .slip = r->slip,
				     .work = r->work };

	ts_scale(1, c->velocity, e.velocity);
	ts_scale(1, c->omega, e.omega);
	ts_scale(1, c->n, e.normal);
	ts_scale(1, t->point, e.point);
	return e;
}

/* Moves the particle away from a surface by more than rounding. */
static void move_off(struct flight *f, const struct ts_sweep_hit *hit, double radius)
{
	double size = fmax(fabs(f->x[0]), fmax(fabs(f->x[1]), fabs(f->x[2])));

	ts_axpy(hit->overlap + 1e-12 * radius + 2e-15 * size, hit->n, f->x);
}

/* Puts the particle where it leaves the surface: displaced along it during the collision, but not into another surface,
 * or into this one where it is curved. */
static void leave(const struct search *s, struct share *share, struct flight *f,
		  const struct ts_exact_touch *t, const struct ts_collision *c,
		  const struct ts_collision_result *r)
{
	struct flight along = *f;
	struct ts_exact_touch other;
	size_t target;

	move_off(&along, &t->hit, c->radius);
	ts_scale(1 / r->duration, r->shift, along.v);
	ts_add(along.v, t->velocity, along.v);
	if (first_touch(s, share, &along, r->duration, &other, &target)) {
		ts_axpy(other.hit.time, along.v, along.x);
		move_off(&along, &other.hit, c->radius);
	} else {
		ts_axpy(r->duration, along.v, along.x);
	}
	ts_scale(1, along.x, f->x);
	ts_add(r->velocity, t->velocity, f->v);
	ts_scale(1, r->omega, f->omega);
	f->time += r->duration;
}

static void add_notice(struct share *share, const struct ts_exact_notice *notice)
{
	struct ts_exact_notices *to = &share->notices;

	if (TS_GROW(to->item, to->capacity, to->n + 1) != TS_OK)
		share->status = TS_NOMEM;
	else
		to->item[to->n++] = *notice;
}

static struct ts_exact_notice notice_of(const struct search *s, size_t i, size_t target)
{
	const struct ts_particles *p = s->sim->particles;
	struct ts_exact_notice notice = { .tag = p->tag[i],
					  .target = (int32_t)target,
					  .member = ts_rigid_member(p, i),
					  .radius = p->radius[i] };

	ts_scale(1, p->x[i], notice.x);
	return notice;
}

static void leave_to_forces(const struct search *s, struct share *share, const struct flight *f,
			    const struct ts_collision *c, size_t target)
{
	struct ts_exact_notice left = notice_of(s, f->i, target);
	struct ts_collision_result r;

	left.speed = -ts_dot(c->velocity, c->n);
	if (!(*ts_exact_warned(s->target[target].wall->exact, left.member) > 0) &&
	    ts_collision_compute(c, &r) == TS_COLLISION_PARTS)
		left.duration = r.duration;
	add_notice(share, &left);
}

/* Carries the particle through its next impact; false: the rest of its path is free, or left to the forces. */
static bool carry_once(const struct search *s, struct share *share, struct flight *f, bool first)
{
	const struct ts_particles *p = s->sim->particles;
	struct ts_exact_touch touch;
	struct ts_collision_result r;
	struct ts_collision c;
	enum ts_collision_end end;
	struct found *to;
	size_t target = 0, nodes;

	if (!first_touch(s, share, f, s->sim->clock.dt - f->time, &touch, &target))
		return false;
	if (first && touch.hit.overlap > NEGLIGIBLE * p->radius[f->i])
		return false;
	c = collision_of(s, f, &touch, target);
	if (ts_rigid_member(p, f->i) || (first && meets_other(s->sim, f->i))) {
		leave_to_forces(s, share, f, &c, target);
		return false;
	}
	ts_axpy(touch.hit.time, f->v, f->x);
	f->time += touch.hit.time;
	if (s->target[target].wall->observers[touch.surface] & TS_OBSERVES_CONTACTS)
		c.nodes = &share->nodes;
	nodes = share->nodes.n;
	end = ts_collision_compute(&c, &r);
	if (end == TS_COLLISION_FAILS)
		share->failed = f->i + 1;
	if (end == TS_COLLISION_NOMEM)
		share->status = TS_NOMEM;
	if (end != TS_COLLISION_PARTS)
		return false;
	if (TS_GROW(share->found, share->found_capacity, share->nfound + 1) != TS_OK) {
		share->status = TS_NOMEM;
		return false;
	}
	to = &share->found[share->nfound++];
	*to = (struct found){ { .event = event_of(s, f, &touch, &c, &r),
				.surface = touch.surface,
				.groups = (uint32_t)p->mask[f->i],
				.first = nodes,
				.nnodes = share->nodes.n - nodes },
			      target };
	ts_sub(r.velocity, c.velocity, to->impact.push);
	ts_scale(c.mass, to->impact.push, to->impact.push);
	leave(s, share, f, &touch, &c, &r);
	return share->status == TS_OK;
}

static void store_change(const struct search *s, struct share *share, struct flight *f)
{
	double rest = s->sim->clock.dt - f->time;
	struct change *to;

	if (TS_GROW(share->change, share->change_capacity, share->nchanges + 1) != TS_OK) {
		share->status = TS_NOMEM;
		return;
	}
	to = &share->change[share->nchanges++];
	*to = (struct change){ .i = f->i, .wait = fmax(0, -rest) };
	if (rest > 0)
		ts_axpy(rest, f->v, f->x);
	ts_scale(1, f->x, to->x);
	ts_scale(1, f->v, to->v);
	ts_scale(1, f->omega, to->omega);
}

/* The path of particle i in this step. */
static void carry(const struct search *s, struct share *share, size_t i)
{
	const struct ts_particles *p = s->sim->particles;
	struct flight f = { .i = i, .time = s->wait[i] };
	double h = s->sim->clock.dt;
	int impacts = 0;

	ts_scale(1, p->x[i], f.x);
	ts_scale(1, p->v[i], f.v);
	ts_axpy(-h, f.v, f.x);
	if (p->omega)
		ts_scale(1, p->omega[i], f.omega);
	while (f.time < h && impacts < TS_EXACT_MOST && carry_once(s, share, &f, impacts == 0))
		impacts++;
	if (impacts == TS_EXACT_MOST) { /* it waits for the next step where it is */
		struct ts_exact_notice many = notice_of(s, i, 0);

		many.many = true;
		add_notice(share, &many);
		f.time = fmax(f.time, h);
	}
	if (impacts || s->wait[i] > 0)
		store_change(s, share, &f);
}

static void search_range(void *context, size_t from, size_t to)
{
	const struct search *s = context;
	const struct ts_particles *p = s->sim->particles;

	for (size_t t = from; t < to; t++) {
		struct share *share = &s->share[t];
		size_t end = p->n * (t + 1) / s->shares;

		for (size_t i = p->n * t / s->shares; i < end && share->status == TS_OK; i++)
			if (p->imass[i] > 0 && (p->mask[i] & s->moving || ts_rigid_member(p, i)))
				carry(s, share, i);
	}
}

/* ---- results ---- */

static int by_particle_and_time(const void *a, const void *b)
{
	const struct ts_impact_event *p = &((const struct ts_exact_impact *)a)->event;
	const struct ts_impact_event *q = &((const struct ts_exact_impact *)b)->event;

	if (p->tag != q->tag)
		return p->tag < q->tag ? -1 : 1;
	return (p->begin > q->begin) - (p->begin < q->begin);
}

static enum ts_status take_share(const struct search *s, const struct share *share,
				 struct ts_exact_notices *notices)
{
	struct ts_particles *p = s->sim->particles;

	if (share->status != TS_OK)
		return ts_nomem(&s->sim->error);
	if (share->failed)
		return ts_fail(&s->sim->error, TS_PHYSICS, &s->target[0].by->where,
			       "impact exact: the impact of particle %d at (%g %g %g), velocity (%g %g %g), "
			       "could not be integrated; use `impact resolved` and a time step that resolves "
			       "contacts",
			       p->tag[share->failed - 1], p->x[share->failed - 1][0],
			       p->x[share->failed - 1][1], p->x[share->failed - 1][2],
			       p->v[share->failed - 1][0], p->v[share->failed - 1][1],
			       p->v[share->failed - 1][2]);
	if (TS_GROW(notices->item, notices->capacity, notices->n + share->notices.n) != TS_OK)
		return ts_nomem(&s->sim->error);
	for (size_t k = 0; k < share->notices.n; k++)
		notices->item[notices->n++] = share->notices.item[k];
	for (size_t k = 0; k < share->nfound; k++) {
		const struct found *found = &share->found[k];

		TS_TRY(ts_exact_take(s->sim, s->target[found->target].wall->exact, &found->impact,
				     share->nodes.item + found->impact.first));
	}
	for (size_t k = 0; k < share->nchanges; k++) {
		const struct change *c = &share->change[k];

		ts_scale(1, c->x, p->x[c->i]);
		ts_scale(1, c->v, p->v[c->i]);
		if (p->omega)
			ts_scale(1, c->omega, p->omega[c->i]);
		((double *)s->wait)[c->i] = c->wait;
	}
	return TS_OK;
}

static void release_share(struct share *share)
{
	ts_free(share->list.item);
	ts_free(share->nodes.item);
	ts_free(share->found);
	ts_free(share->change);
	ts_free(share->notices.item);
}

static enum ts_status search(struct search *s)
{
	struct ts_exact_notices notices = { 0 };
	enum ts_status status = TS_OK;

	s->share = ts_alloc(s->shares, sizeof *s->share);
	if (!s->share)
		return ts_nomem(&s->sim->error);
	ts_parallel((int)s->shares, s->shares, search_range, s);
	for (size_t k = 0; k < s->shares && status == TS_OK; k++)
		status = take_share(s, &s->share[k], &notices);
	for (size_t k = 0; k < s->shares; k++)
		release_share(&s->share[k]);
	ts_free(s->share);
	if (status == TS_OK && s->sim->division)
		status = ts_exact_share(s->sim, s->target, s->targets, &notices);
	if (status == TS_OK)
		status = ts_exact_tell(s->sim, s->target, s->targets, &notices);
	ts_free(notices.item);
	for (size_t k = 0; k < s->targets; k++) {
		struct ts_exact_impacts *e = s->target[k].wall->exact;

		ts_sort(e->item, e->n, sizeof *e->item, by_particle_and_time);
	}
	return status;
}

/* All walls that take part; *first: whether `self` is the first of them. NULL: out of memory. */
static struct ts_exact_target *list_targets(const struct ts_instance *self, const struct tsim *sim, size_t *n,
					    bool *first)
{
	const struct ts_instance *by;
	struct ts_exact_target *list = NULL;
	struct ts_wall *w;
	size_t capacity = 0;

	*n = 0;
	*first = true;
	for (size_t k = 0; (w = ts_walls_next(sim, &k, &by));) {
		if (!w->exact)
			continue;
		*first = *n ? *first : by == self;
		if (TS_GROW(list, capacity, *n + 1) != TS_OK) {
			ts_free(list);
			return NULL;
		}
		list[(*n)++] = (struct ts_exact_target){ by, w };
	}
	return list;
}

static enum ts_status prepare(struct search *s)
{
	for (size_t k = 0; k < s->targets; k++) {
		struct ts_exact_impacts *e = s->target[k].wall->exact;

		e->n = e->nleft = e->nodes.n = s->target[k].wall->nbriefs = 0;
		if (e->surface->prepare)
			TS_TRY(e->surface->prepare(s->sim, e->shape));
	}
	return TS_OK;
}

/* For those who observe contacts with surfaces of this wall. */
static enum ts_status list_briefs(struct tsim *sim, struct ts_wall *w)
{
	const struct ts_exact_impacts *e = w->exact;

	for (size_t k = 0; k < e->n; k++) {
		const struct ts_exact_impact *from = &e->item[k];
		struct ts_wall_brief *to;

		if (!from->nnodes)
			continue;
		if (TS_GROW(w->brief, w->brief_capacity, w->nbriefs + 1) != TS_OK)
			return ts_nomem(&sim->error);
		to = &w->brief[w->nbriefs++];
		*to = (struct ts_wall_brief){ .surface = from->surface,
					      .element = (size_t)from->event.element,
					      .type = (int)from->event.type,
					      .groups = from->groups,
					      .mass = from->event.mass,
					      .radius = from->event.radius,
					      .node = e->nodes.item + from->first,
					      .nnodes = from->nnodes };
		ts_scale(1, from->event.normal, to->normal);
		ts_scale(1, from->event.point, to->point);
	}
	return TS_OK;
}

/* To those who observe the impacts on surfaces of this wall. */
static enum ts_status report_impacts(struct tsim *sim, const struct ts_wall *w)
{
	const struct ts_exact_impacts *e = w->exact;

	for (size_t k = 0; w->impacts && k < e->n; k++)
		if (w->observers[e->item[k].surface] & TS_OBSERVES_IMPACTS)
			TS_TRY(ts_impacts_append(sim, w->impacts, e->item[k].surface, e->item[k].groups,
						 &e->item[k].event));
	return TS_OK;
}

enum ts_status ts_exact_carry(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_wall *w = self->state;
	struct search s = { .sim = sim };
	enum ts_status status;
	bool first;

	if (!w->exact || !(sim->clock.dt > 0))
		return TS_OK;
	s.target = list_targets(self, sim, &s.targets, &first);
	if (!s.target)
		return ts_nomem(&sim->error);
	status = TS_OK;
	if (first) {
		ts_deferred_loops_run(sim);
		ts_copies_forward(sim); /* of what particles may touch in this step */
		s.wait = sim->particles->column[w->exact->wait].data;
		s.moving = ts_integrated_groups(sim, TS_MOVES | TS_OBEYS);
		s.shares = (size_t)ts_team(sim, 4 * sim->particles->n);
		status = prepare(&s);
		if (status == TS_OK && (sim->particles->n || sim->division))
			status = search(&s);
		for (size_t k = 0; k < s.targets && status == TS_OK; k++)
			status = list_briefs(sim, s.target[k].wall);
		for (size_t k = 0; k < s.targets && status == TS_OK; k++)
			status = report_impacts(sim, s.target[k].wall);
	}
	ts_free(s.target);
	return status;
}
