#include "wall/surface_contacts.h"

#include "base/sort.h"
#include "box/domain.h"
#include "rigid/rigid.h"
#include "wall/shared_contacts.h"
#include "wall/surface.h"

#include "base/banned.h"

/* The fix of the surface of contact k. */
static const struct ts_instance *surface_at(const struct ts_wall *w, size_t k)
{
	struct ts_wall_place place;

	ts_wall_place(w, k, &place);
	return ts_wall_surface(w, place.surface);
}

/* ---- the list of a wall ---- */

enum ts_status ts_surface_contacts_find_observers(struct tsim *sim, struct ts_wall *w)
{
	size_t n = ts_wall_surfaces(w);

	if (TS_GROW(w->observers, w->observers_capacity, n) != TS_OK)
		return ts_nomem(&sim->error);
	w->observed = 0;
	for (size_t s = 0; s < n; s++) {
		w->observers[s] = ts_surface_observers(sim, ts_wall_surface(w, s));
		w->observed |= w->observers[s];
	}
	w->contacts.want_reports |= w->observed != 0;
	return TS_OK;
}

int ts_wall_touching_order(const void *a, const void *b)
{
	const struct ts_wall_touching *p = a, *q = b;

	if (p->surface != q->surface)
		return p->surface < q->surface ? -1 : 1;
	if (p->element != q->element)
		return p->element < q->element ? -1 : 1;
	if (p->tag != q->tag)
		return p->tag < q->tag ? -1 : 1;
	return (p->k > q->k) - (p->k < q->k); /* images of the particle, contact points on one column */
}

/* Appends the observed contacts that touch, or those that only conduct heat, to the first n of the list; returns
 * their number. */
static size_t append_sorted(struct ts_wall *w, size_t n, bool touch)
{
	const struct ts_wall_contacts *c = &w->contacts;
	struct ts_wall_place place;
	size_t from = n;

	for (size_t k = 0; k < c->n; k++) {
		if (!(touch ? ts_wall_report(c, k) != NULL : ts_wall_only_conducts(c, k)))
			continue;
		ts_wall_place(w, k, &place);
		if (w->observers[place.surface])
			w->touching[n++] =
				(struct ts_wall_touching){ (int32_t)place.surface, (int32_t)place.element,
							   c->key[k][0], k };
	}
	ts_sort(w->touching + from, n - from, sizeof *w->touching, ts_wall_touching_order);
	return n;
}

enum ts_status ts_surface_contacts_collect(struct tsim *sim, struct ts_wall *w)
{
	w->ntouching = w->nlisted = 0;
	w->shares = false;
	if (!w->observed)
		return TS_OK;
	if (w->contacts.report) {
		if (TS_GROW(w->touching, w->touching_capacity, w->contacts.n) != TS_OK)
			return ts_nomem(&sim->error);
		w->ntouching = append_sorted(w, 0, true);
		w->nlisted = w->warm ? append_sorted(w, w->ntouching, false) : w->ntouching;
	}
	return TS_OK;
}

static bool has_wall(const struct tsim *sim, const struct ts_instance *surface)
{
	const struct ts_wall *w;

	for (size_t at = 0; (w = ts_walls_next(sim, &at, NULL));)
		if (ts_wall_find_surface(w, surface) != SIZE_MAX)
			return true;
	return false;
}

void ts_surface_warn_without_wall(struct ts_instance *self, struct tsim *sim,
				  const struct ts_instance *surface, const char *word)
{
	if (!has_wall(sim, surface))
		ts_warn(&sim->log, ts_instance_word(self, word),
			"fix %s: no fix wall/gran is made of the surface %s, so no particle touches it",
			self->style->name, surface->id);
}

bool ts_surface_contacts_listed(const struct tsim *sim, const struct ts_instance *surface)
{
	const struct ts_wall *w;

	for (size_t at = 0; (w = ts_walls_next(sim, &at, NULL));)
		for (size_t k = 0; k < w->contacts.n; k++)
			if (surface_at(w, k) == surface)
				return true;
	return false;
}

/* ---- iteration ---- */

struct ts_surface_contacts ts_surface_contacts(const struct tsim *sim, const struct ts_instance *surface)
{
	return (struct ts_surface_contacts){ .sim = sim, .surface = surface };
}

struct ts_surface_contacts ts_surface_heat_contacts(const struct tsim *sim, const struct ts_instance *surface)
{
	return (struct ts_surface_contacts){ .sim = sim, .surface = surface, .immobile = true };
}

/* Into the frame of the surface from that of the image which is touched. */
static void into_frame(const struct tsim *sim, const struct ts_wall_place *place, const double x[3],
		       double out[3])
{
	for (int d = 0; d < 3; d++)
		out[d] = x[d] - place->shift[d] * ts_box_length(&sim->domain->box, d);
}

static void set_particle(const struct ts_particles *p, struct ts_surface_contact *out)
{
	static const double none[3] = { 0 };
	size_t i = out->particle;

	out->type = p->type[i];
	out->groups = (uint32_t)p->mask[i];
	out->tag = p->tag[i];
	out->mass = p->mass[i];
	out->inertial_mass = ts_rigid_inertial_mass(p, i);
	out->radius = p->radius[i];
	ts_scale(1, p->omega ? p->omega[i] : none, out->omega);
}

static double lever_of(const struct ts_wall *w, const struct tsim *sim, double radius, double overlap)
{
	return radius - (ts_wall_model(w, sim)->full_arms ? 0 : 0.5 * overlap);
}

void ts_surface_contact_of(const struct tsim *sim, const struct ts_wall *w, size_t k,
			   struct ts_surface_contact *out)
{
	const struct ts_wall_contacts *c = &w->contacts;
	const struct ts_wall_report *r = &c->report[k];
	struct ts_wall_place place;

	if (w->shares) {
		*out = *ts_shared_contact(w, k);
		return;
	}
	ts_wall_place(w, k, &place);
	out->element = place.element;
	out->particle = (size_t)c->row[k];
	out->overlap = r->overlap;
	out->conductance = r->conductance;
	out->heat = r->heat;
	ts_scale(-1, r->force, out->force);
	ts_scale(1, c->last[k].n, out->normal);
	ts_sub(sim->particles->v[out->particle], r->velocity, out->velocity);
	into_frame(sim, &place, r->point, out->point);
	into_frame(sim, &place, sim->particles->x[out->particle], out->centre);
	set_particle(sim->particles, out);
	out->lever = lever_of(w, sim, out->radius, out->overlap);
	out->duration = sim->clock.dt;
}

static void node_of(const struct ts_surface_contacts *it, const struct ts_wall_brief *b,
		    const struct ts_contact_node *node, struct ts_surface_contact *out)
{
	*out = (struct ts_surface_contact){ .element = b->element,
					    .particle = SIZE_MAX,
					    .type = b->type,
					    .groups = b->groups,
					    .mass = b->mass,
					    .radius = b->radius,
					    .duration = node->duration,
					    .overlap = node->overlap,
					    .lever = lever_of(it->wall, it->sim, b->radius, node->overlap) };
	ts_scale(1, node->omega, out->omega);
	ts_scale(-1, node->force, out->force);
	ts_add(b->point, node->shift, out->point);
	ts_scale(1, b->normal, out->normal);
	ts_scale(1, node->velocity, out->velocity);
	ts_scale(1, out->point, out->centre);
	ts_axpy(b->radius - node->overlap, b->normal, out->centre);
}

/* The next node of a brief contact with the surface on the present wall. */
static bool next_node(struct ts_surface_contacts *it, struct ts_surface_contact *out)
{
	const struct ts_wall *w = it->wall;

	for (; it->brief < w->nbriefs; it->brief++, it->node = 0) {
		const struct ts_wall_brief *b = &w->brief[it->brief];

		if (it->node == b->nnodes || ts_wall_surface(w, b->surface) != it->surface)
			continue;
		node_of(it, b, &b->node[it->node++], out);
		return true;
	}
	return false;
}

bool ts_surface_contacts_next(struct ts_surface_contacts *it, struct ts_surface_contact *out)
{
	for (;;) {
		while (it->wall && it->at < (it->immobile ? it->wall->nlisted : it->wall->ntouching)) {
			const struct ts_wall_touching *t = &it->wall->touching[it->at++];

			if (ts_wall_surface(it->wall, (size_t)t->surface) != it->surface)
				continue;
			ts_surface_contact_of(it->sim, it->wall, t->k, out);
			return true;
		}
		/* forces before the first step belong to the step before, whose brief contacts have been counted */
		if (it->wall && !it->sim->run.in_setup && next_node(it, out))
			return true;
		it->wall = ts_walls_next(it->sim, &it->next_wall, NULL);
		it->at = it->brief = it->node = 0;
		if (!it->wall)
			return false;
	}
}

double ts_surface_contact_normal_force(const struct ts_surface_contact *c)
{
	return -ts_dot(c->force, c->normal);
}

double ts_surface_contact_slip(const struct ts_surface_contact *c, double v[3])
{
	double arm[3], turn[3];

	for (int d = 0; d < 3; d++)
		arm[d] = -c->lever * c->normal[d];
	ts_cross(c->omega, arm, turn);
	ts_add(c->velocity, turn, v);
	ts_axpy(-ts_dot(v, c->normal), c->normal, v);
	return ts_dot(c->force, v);
}
