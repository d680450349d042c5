#include "impact/impacts.h"

#include <math.h>

#include "base/sort.h"
#include "math/vec3.h"
#include "wall/shared_contacts.h"

#include "base/banned.h"

/* A touching contact in the list of the wall. */
struct ts_impact_touch {
	size_t surface;
	int32_t tag;
	size_t at; /* in w->touching */
};

/* ---- lists ---- */

static int compare(double a, double b)
{
	return (a > b) - (a < b);
}

static int by_surface_and_particle(const void *a, const void *b)
{
	const struct ts_surface_impact *p = a, *q = b;

	return p->surface != q->surface ? compare(p->surface, q->surface)
					: compare(p->event.tag, q->event.tag);
}

static int by_element_and_particle(const void *a, const void *b)
{
	const struct ts_surface_impact *p = a, *q = b;

	if (p->surface != q->surface)
		return compare(p->surface, q->surface);
	if (p->event.element != q->event.element)
		return compare(p->event.element, q->event.element);
	if (p->event.tag != q->event.tag)
		return compare(p->event.tag, q->event.tag);
	return compare(p->event.begin, q->event.begin);
}

static enum ts_status add(struct tsim *sim, struct ts_impact_list *list,
			  const struct ts_surface_impact *impact)
{
	if (TS_GROW(list->item, list->capacity, list->n + 1) != TS_OK)
		return ts_nomem(&sim->error);
	list->item[list->n++] = *impact;
	return TS_OK;
}

static void sort(struct ts_impact_list *list, int (*order)(const void *, const void *))
{
	ts_sort(list->item, list->n, sizeof *list->item, order);
}

/* Among the first n, which are sorted by surface and particle. */
static struct ts_surface_impact *find(const struct ts_impact_list *list, size_t n, size_t surface,
				      int32_t tag)
{
	struct ts_surface_impact key = { .event.tag = tag, .surface = (double)surface };

	return n ? bsearch(&key, list->item, n, sizeof key, by_surface_and_particle) : NULL;
}

/* Of the particle of a contact or event. */
static double groups_of(const struct tsim *sim, size_t i)
{
	return (double)(uint32_t)sim->particles->mask[i];
}

/* ---- preparation ---- */

/* Contacts that exist before the first step of the observation. */
static enum ts_status add_unseen(struct tsim *sim, struct ts_wall *w)
{
	const struct ts_particles *p = sim->particles;
	struct ts_impact_list *live = &w->impacts->live;
	size_t n = live->n;

	for (size_t k = 0; k < w->contacts.n; k++) {
		size_t i = (size_t)w->contacts.row[k];
		struct ts_surface_impact impact = { .groups = groups_of(sim, i), .event.tag = p->tag[i] };
		struct ts_wall_place place;
		int type;

		ts_wall_place(w, k, &place);
		impact.surface = (double)place.surface;
		if (w->impacts->tracked[place.surface] ||
		    !(w->observers[place.surface] & TS_OBSERVES_IMPACTS) ||
		    find(live, n, place.surface, p->tag[i]))
			continue;
		/* several contacts of a particle make several entries, of which those that are not
		 * continued vanish with the next forces */
		if (w->contacts.touching[k] || w->shape->distance(w, sim, k, &type) < p->radius[i])
			TS_TRY(add(sim, live, &impact));
	}
	sort(live, by_surface_and_particle);
	return TS_OK;
}

static enum ts_status reserve_tracked(struct tsim *sim, struct ts_impacts *impacts, size_t surfaces)
{
	if (TS_GROW(impacts->tracked, impacts->tracked_capacity, surfaces) != TS_OK)
		return ts_nomem(&sim->error);
	while (impacts->surfaces < surfaces)
		impacts->tracked[impacts->surfaces++] = 0;
	return TS_OK;
}

/* A restart file may have been made by a wall of more surfaces. */
static void drop_foreign(struct ts_impact_list *live, size_t surfaces)
{
	size_t n = 0;

	for (size_t k = 0; k < live->n; k++)
		if (live->item[k].surface >= 0 && live->item[k].surface < (double)surfaces)
			live->item[n++] = live->item[k];
	live->n = n;
}

enum ts_status ts_impacts_prepare(struct ts_instance *self, struct tsim *sim)
{
	struct ts_wall *w = self->state;
	size_t surfaces = ts_wall_surfaces(w);

	if (!(w->observed & TS_OBSERVES_IMPACTS)) {
		ts_impacts_free(w->impacts);
		w->impacts = NULL;
		return TS_OK;
	}
	if (!w->impacts)
		w->impacts = ts_alloc(1, sizeof *w->impacts);
	if (!w->impacts)
		return ts_nomem(&sim->error);
	TS_TRY(reserve_tracked(sim, w->impacts, surfaces));
	drop_foreign(&w->impacts->live, surfaces);
	TS_TRY(add_unseen(sim, w));
	for (size_t s = 0; s < surfaces; s++)
		w->impacts->tracked[s] = (w->observers[s] & TS_OBSERVES_IMPACTS) != 0;
	return TS_OK;
}

/* ---- one impact ---- */

/* Time that the surfaces take to pass the overlap at this speed, at most a step. */
static double passage(const struct tsim *sim, double overlap, double speed)
{
	return speed > 0 && overlap > 0 ? fmin(overlap / speed, sim->clock.dt) : 0;
}

static void begin(const struct tsim *sim, const struct ts_surface_contact *c,
		  struct ts_surface_impact *impact)
{
	struct ts_impact_event *e = &impact->event;

	e->tag = c->tag;
	e->type = c->type;
	e->element = (double)c->element;
	e->mass = c->inertial_mass; /* as in the contact law */
	e->radius = c->radius;
	ts_scale(1, c->velocity, e->velocity);
	ts_scale(1, c->normal, e->normal);
	ts_scale(1, c->point, e->point);
	ts_scale(1, c->omega, e->omega);
	/* the step that is added to it now began with free flight */
	e->duration = passage(sim, c->overlap, -ts_dot(c->velocity, c->normal)) - sim->clock.dt;
	e->begin = ts_sim_time(sim) - (e->duration + sim->clock.dt);
	impact->groups = (double)c->groups;
	impact->seen = !sim->run.in_setup;
}

/* A step with contacts: c is that with the largest overlap, `force` the sum of their normal forces, `power` that of
 * friction. */
static void follow(const struct tsim *sim, const struct ts_surface_contact *c, double force, double power,
		   struct ts_surface_impact *impact)
{
	struct ts_impact_event *e = &impact->event;
	double h = sim->clock.dt, slip[3];

	ts_surface_contact_slip(c, slip);
	e->peak_force = fmax(e->peak_force, force);
	e->peak_overlap = fmax(e->peak_overlap, c->overlap);
	e->impulse += force * h;
	e->slip += ts_norm(slip) * h;
	e->work += power * h;
	e->duration += h;
	impact->tail = passage(sim, c->overlap, ts_dot(c->velocity, c->normal));
}

/* The touches of one particle and one surface, t[0] to t[n - 1]. */
static void touch(const struct tsim *sim, const struct ts_wall *w, const struct ts_impact_touch *t, size_t n,
		  struct ts_surface_impact *impact, bool is_new)
{
	double force = 0, power = 0, v[3];
	struct ts_surface_contact c, main = { 0 };

	for (size_t k = 0; k < n; k++) {
		ts_surface_contact_of(sim, w, w->touching[t[k].at].k, &c);
		force += ts_surface_contact_normal_force(&c);
		power += ts_surface_contact_slip(&c, v);
		main = !k || c.overlap > main.overlap ? c : main;
	}
	if (is_new)
		begin(sim, &main, impact);
	if (!sim->run.in_setup)
		follow(sim, &main, force, power, impact);
	impact->touches = 1;
}

/* ---- a step ---- */

static int by_particle(const void *a, const void *b)
{
	const struct ts_impact_touch *p = a, *q = b;

	if (p->surface != q->surface)
		return p->surface < q->surface ? -1 : 1;
	if (p->tag != q->tag)
		return p->tag < q->tag ? -1 : 1;
	return (p->at > q->at) - (p->at < q->at);
}

/* The touching contacts with surfaces whose impacts are observed, sorted by surface and particle. */
static enum ts_status collect(struct tsim *sim, const struct ts_wall *w, struct ts_impacts *impacts,
			      size_t *n)
{
	*n = 0;
	if (TS_GROW(impacts->touch, impacts->touch_capacity, w->ntouching) != TS_OK)
		return ts_nomem(&sim->error);
	for (size_t at = 0; at < w->ntouching; at++) {
		const struct ts_wall_touching *t = &w->touching[at];

		if (w->observers[t->surface] & TS_OBSERVES_IMPACTS)
			impacts->touch[(*n)++] = (struct ts_impact_touch){ (size_t)t->surface, t->tag, at };
	}
	ts_sort(impacts->touch, *n, sizeof *impacts->touch, by_particle);
	return TS_OK;
}

/* Continues or begins the impacts of particles that touch. */
static enum ts_status touch_all(struct tsim *sim, const struct ts_wall *w, struct ts_impacts *impacts,
				size_t n)
{
	const struct ts_impact_touch *t = impacts->touch;
	size_t old = impacts->live.n;

	for (size_t k = 0, end; k < n; k = end) {
		struct ts_surface_impact fresh = { .surface = (double)t[k].surface };
		struct ts_surface_impact *known = find(&impacts->live, old, t[k].surface, t[k].tag);

		for (end = k + 1; end < n && t[end].surface == t[k].surface && t[end].tag == t[k].tag; end++)
			;
		touch(sim, w, t + k, end - k, known ? known : &fresh, !known);
		if (!known)
			TS_TRY(add(sim, &impacts->live, &fresh));
	}
	return TS_OK;
}

/* Moves impacts without contact in this step to those that have ended. */
static enum ts_status end_untouched(struct tsim *sim, struct ts_impacts *impacts)
{
	struct ts_impact_list *live = &impacts->live;
	size_t n = 0;

	for (size_t k = 0; k < live->n; k++) {
		struct ts_surface_impact *impact = &live->item[k];

		if (impact->touches > 0) {
			impact->touches = 0;
			live->item[n++] = *impact;
			continue;
		}
		impact->event.duration += impact->tail;
		if (impact->seen > 0 && !sim->run.in_setup)
			TS_TRY(add(sim, &impacts->ended, impact));
	}
	live->n = n;
	return TS_OK;
}

enum ts_status ts_impacts_update(struct tsim *sim, struct ts_wall *w)
{
	struct ts_impacts *impacts = w->impacts;
	size_t n, old;

	if (!impacts)
		return TS_OK;
	impacts->ended.n = 0;
	if (sim->division && !w->shares)
		TS_TRY(ts_shared_contacts_make(sim, w));
	if (!w->ntouching && !impacts->live.n && !impacts->added.n)
		return TS_OK;
	TS_TRY(collect(sim, w, impacts, &n));
	old = impacts->live.n;
	TS_TRY(touch_all(sim, w, impacts, n));
	if (impacts->live.n > old)
		sort(&impacts->live, by_surface_and_particle);
	TS_TRY(end_untouched(sim, impacts));
	for (size_t k = 0; k < impacts->added.n; k++)
		TS_TRY(add(sim, &impacts->ended, &impacts->added.item[k]));
	impacts->added.n = 0;
	sort(&impacts->ended, by_element_and_particle);
	return TS_OK;
}

enum ts_status ts_impacts_append(struct tsim *sim, struct ts_impacts *impacts, size_t surface,
				 uint32_t groups, const struct ts_impact_event *event)
{
	struct ts_surface_impact impact = {
		.event = *event, .surface = (double)surface, .groups = (double)groups, .seen = 1
	};

	return add(sim, &impacts->added, &impact);
}

/* ---- by observers ---- */

struct ts_surface_impacts ts_surface_impacts(const struct tsim *sim, const struct ts_instance *surface)
{
	return (struct ts_surface_impacts){ .sim = sim, .surface = surface };
}

const struct ts_surface_impact *ts_surface_impacts_next(struct ts_surface_impacts *it)
{
	for (;;) {
		while (it->wall && it->wall->impacts && it->at < it->wall->impacts->ended.n) {
			const struct ts_surface_impact *impact = &it->wall->impacts->ended.item[it->at++];

			if (ts_wall_surface(it->wall, (size_t)impact->surface) == it->surface)
				return impact;
		}
		it->wall = ts_walls_next(it->sim, &it->next_wall, NULL);
		it->at = 0;
		if (!it->wall)
			return NULL;
	}
}

/* ---- restart files ---- */

/* Only where there is something to follow. */
enum ts_status ts_impacts_archive(struct ts_archive *archive, struct tsim *sim, struct ts_wall *w)
{
	static const char tracked[] = "impacts_tracked", live[] = "impacts";
	bool there = ts_archive_writing(archive) ? w->impacts != NULL : ts_archive_has(archive, tracked);
	struct ts_impacts *impacts;
	size_t n, capacity;

	if (!there)
		return TS_OK;
	if (!w->impacts)
		w->impacts = ts_alloc(1, sizeof *w->impacts);
	impacts = w->impacts;
	if (!impacts)
		return ts_nomem(&sim->error);
	TS_TRY(ts_archive_array(archive, tracked, TS_SAVED_U8, (void **)&impacts->tracked,
				&impacts->tracked_capacity, &impacts->surfaces));
	n = impacts->live.n * TS_SURFACE_IMPACT_NUMBERS;
	capacity = impacts->live.capacity * TS_SURFACE_IMPACT_NUMBERS;
	TS_TRY(ts_archive_array(archive, live, TS_SAVED_F64, (void **)&impacts->live.item, &capacity, &n));
	impacts->live.capacity = capacity / TS_SURFACE_IMPACT_NUMBERS;
	impacts->live.n = n / TS_SURFACE_IMPACT_NUMBERS;
	return n % TS_SURFACE_IMPACT_NUMBERS
		       ? ts_fail(&sim->error, TS_DAMAGED, NULL, "impossible impacts on a wall")
		       : TS_OK;
}

void ts_impacts_free(struct ts_impacts *impacts)
{
	if (!impacts)
		return;
	ts_free(impacts->live.item);
	ts_free(impacts->ended.item);
	ts_free(impacts->added.item);
	ts_free(impacts->tracked);
	ts_free(impacts->touch);
	ts_free(impacts);
}
