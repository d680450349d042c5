#include "contact/contact_view.h"

#include <inttypes.h>

#include "base/alloc.h"
#include "base/sort.h"
#include "bond/bonds.h"
#include "box/domain.h"
#include "math/vec3.h"
#include "neigh/contact_memory.h"
#include "neigh/force_slots.h"
#include "particle/group_moments.h"

#include "base/banned.h"

/* During a run each change of the particles is followed by a new list, unless an outside program makes it. */
static bool contacts_current(const struct ts_contact_list *list, const struct tsim *sim)
{
	const struct ts_particles *p = sim->particles;

	if (list->particles != p->n)
		return false;
	if (sim->run.inside && !sim->run.in_pieces)
		return true;
	for (size_t r = 0; r < list->n; r++) {
		size_t i = (size_t)list->i[r], j = (size_t)list->j[r];

		if (i >= p->n || j >= p->n + p->nghost || p->tag[i] != ts_contact_tag(list, r, 0) ||
		    p->tag[j] != ts_contact_tag(list, r, 1))
			return false;
	}
	return true;
}

bool ts_contacts_current(const struct tsim *sim)
{
	const struct ts_instance *pair = ts_sim_only(sim, TS_KIND_PAIR);

	return sim->neigh->contacts.pair == (pair ? pair->serial : 0) &&
	       contacts_current(&sim->neigh->contacts, sim);
}

enum ts_status ts_contacts_require(struct tsim *sim, const struct ts_instance *self)
{
	bool rows_wanted = sim->neigh->wanted || ts_sim_only(sim, TS_KIND_PAIR);

	ts_contacts_store_history(sim, &sim->neigh->contacts);
	if ((!rows_wanted || ts_contacts_current(sim)) && ts_bonds_connected(sim->bonds, sim->particles))
		return TS_OK;
	return ts_fail(&sim->error, TS_STATE, &self->where,
		       "%s %s%s%s: contacts are known only after a run, and not if particles have been added "
		       "or deleted since, or there is a new pair_style; `run 0` finds them",
		       ts_kind_name(self->style->kind), self->id, self->id[0] ? " " : "", self->style->name);
}

enum ts_status ts_contacts_kept(struct tsim *sim, const struct ts_instance *self)
{
	struct ts_contact_list *list = &sim->neigh->contacts;

	if (list->results == TS_RESULTS_NONE)
		return ts_force_slots_keep_all(sim, list);
	if (list->results == TS_RESULTS_KEPT)
		return TS_OK;
	return ts_fail(&sim->error, TS_STATE, &self->where,
		       "%s %s%s%s: forces of contacts were not kept at step %" PRId64 "; `run 0` finds them",
		       ts_kind_name(self->style->kind), self->id, self->id[0] ? " " : "", self->style->name,
		       sim->clock.step);
}

enum ts_status ts_contacts_forces(struct tsim *sim, const struct ts_instance *self)
{
	TS_TRY(ts_contacts_require(sim, self));
	return ts_contacts_kept(sim, self);
}

bool ts_contact_counts(const struct tsim *sim, size_t r, int group)
{
	const struct ts_contact_list *list = &sim->neigh->contacts;
	const struct ts_particles *p = sim->particles;
	size_t i = (size_t)list->i[r], j = (size_t)list->j[r];

	if (!ts_in_group(p, i, group) || !ts_in_group(p, j, group))
		return false;
	if (j < p->n || p->tag[i] < p->tag[j])
		return true;
	return p->tag[i] == p->tag[j] && ts_contact_image(list, r) > TS_IMAGE_SELF;
}

static int by_identities(const void *one, const void *other)
{
	const struct ts_contact_row *a = one, *b = other;

	if (a->pair != b->pair)
		return a->pair < b->pair ? -1 : 1;
	if (a->image != b->image)
		return a->image < b->image ? -1 : 1;
	return a->r < b->r ? -1 : a->r > b->r;
}

static struct ts_contact_row row_of(const struct ts_contact_list *list, size_t r)
{
	const uint64_t a = (uint32_t)ts_contact_tag(list, r, 0), b = (uint32_t)ts_contact_tag(list, r, 1);

	return (struct ts_contact_row){ a < b ? a << 32 | b : b << 32 | a, (int32_t)ts_contact_image(list, r),
					r };
}

static bool in_order(const struct ts_contact_rows *rows)
{
	for (size_t k = 1; k < rows->n; k++)
		if (by_identities(&rows->row[k - 1], &rows->row[k]) > 0)
			return false;
	return true;
}

enum ts_status ts_contact_rows(struct tsim *sim, int group, bool touching, struct ts_contact_rows *rows)
{
	const struct ts_contact_list *list = &sim->neigh->contacts;
	size_t n = 0;

	rows->n = 0;
	for (size_t r = 0; r < list->n; r++)
		n += !touching || ts_contact_touches(list, r);
	rows->row = ts_alloc(n, sizeof *rows->row);
	if (!rows->row)
		return ts_nomem(&sim->error);
	for (size_t r = 0; r < list->n; r++)
		if ((!touching || ts_contact_touches(list, r)) && ts_contact_counts(sim, r, group))
			rows->row[rows->n++] = row_of(list, r);
	if (!in_order(rows))
		ts_sort(rows->row, rows->n, sizeof *rows->row, by_identities);
	return TS_OK;
}

void ts_contact_rows_release(struct ts_contact_rows *rows)
{
	ts_free(rows->row);
	*rows = (struct ts_contact_rows){ 0 };
}

void ts_contact_view(const struct tsim *sim, size_t r, struct ts_contact_view *view)
{
	const struct ts_contact_list *list = &sim->neigh->contacts;
	const struct ts_particles *p = sim->particles;
	size_t i = (size_t)list->i[r], j = (size_t)list->j[r];
	size_t owner = j < p->n ? j : (size_t)p->ghost_owner[j - p->n];
	bool swap = ts_contact_tag(list, r, 0) > ts_contact_tag(list, r, 1);

	view->row = r;
	view->a = swap ? owner : i;
	view->b = swap ? i : owner;
	view->image = j >= p->n;
	view->sign = swap ? -1 : 1;
	ts_sub(p->x[i], p->x[j], view->d);
	ts_scale(view->sign, view->d, view->d);
	ts_scale(view->sign, ts_contact_force(list, ts_contact_kept(list, r)), view->force);
	view->distance = ts_norm(view->d);
}

void ts_contact_view_of_bond(const struct tsim *sim, size_t b, struct ts_contact_view *view)
{
	const struct ts_bonds *bonds = sim->bonds;
	const struct ts_particles *p = sim->particles;
	double direct[3];

	view->row = b;
	view->a = (size_t)bonds->row[b][0];
	view->b = (size_t)bonds->row[b][1];
	view->sign = 1;
	ts_sub(p->x[view->a], p->x[view->b], direct);
	for (int k = 0; k < 3; k++)
		view->d[k] = direct[k];
	ts_box_nearest(&sim->domain->box, view->d);
	view->image = ts_distance2(view->d, direct) > 0;
	view->distance = ts_norm(view->d);
	if (bonds->transmits) {
		for (int k = 0; k < 3; k++)
			view->force[k] = bonds->load[b].force[k];
		return;
	}
	/* computed as in the bond loop, since after a restart the tension is known before the force */
	for (int k = 0; k < 3; k++)
		view->force[k] =
			view->distance > 0 ? -bonds->tension[b] * (view->d[k] * (1 / view->distance)) : 0;
}
