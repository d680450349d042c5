#include "contact/broken_bridges.h"

#include <string.h>

#include "base/sort.h"
#include "box/domain.h"
#include "core/ranks.h"
#include "law/capillary.h"
#include "neigh/contact_memory.h"
#include "particle/columns.h"
#include "particle/identity.h"

#include "base/banned.h"

/* Liquid that particle i gets from a broken bridge. */
struct transfer {
	int32_t tag, other, winding;
	int32_t image; /* of the partner, in the entry of the particle */
	size_t i;      /* ELSEWHERE: of another rank */
	double amount; /* relative to the volume of the particle */
};
static const size_t ELSEWHERE = SIZE_MAX;

struct transfers {
	struct transfer *item;
	size_t n, capacity;
	/* to particles of other ranks across periodic faces, by entries whose other side may not have broken */
	struct ts_parcel away;
};

/* An order that depends neither on threads nor on the order in memory. */
static int compare_transfers(const void *one, const void *two)
{
	const struct transfer *a = one, *b = two;

	if (a->tag != b->tag)
		return a->tag < b->tag ? -1 : 1;
	if (a->other != b->other)
		return a->other < b->other ? -1 : 1;
	return a->winding < b->winding ? -1 : a->winding > b->winding;
}

static size_t local_of(const struct ts_particles *p, size_t j)
{
	return j < p->n ? j : (size_t)p->ghost_owner[j - p->n];
}

static double *bridge_state(const struct ts_contact_list *list, const struct ts_pair *pair, size_t r)
{
	return &ts_contact_history(list, r)[ts_granular_met_at(&pair->model)];
}

static bool has_broken(const struct ts_contact_list *list, const struct ts_pair *pair, size_t r)
{
	return *bridge_state(list, pair, r) == TS_BRIDGE_BROKEN;
}

/* The other entry of a pair across a periodic face, list->n if there is none. Its bridge may break in another
 * step, because of rounding. */
static size_t mirror_pair(const struct ts_contact_list *list, const struct ts_particles *p, size_t r)
{
	for (size_t k = 0; ts_contact_image(list, r) != TS_IMAGE_SELF && k < list->n; k++)
		if ((size_t)list->i[k] == local_of(p, (size_t)list->j[r]) &&
		    (size_t)list->i[r] == local_of(p, (size_t)list->j[k]) &&
		    ts_contact_image(list, k) == 2 * TS_IMAGE_SELF - ts_contact_image(list, r))
			return k;
	return list->n;
}

static enum ts_status add_transfer(struct transfers *t, const struct transfer *one)
{
	if (one->i == ELSEWHERE)
		return ts_parcel_add(&t->away, one, sizeof *one);
	TS_TRY(TS_GROW(t->item, t->capacity, t->n + 1));
	t->item[t->n++] = *one;
	return TS_OK;
}

/* The transfer of the broken bridge of pair r to its particle i (side 0) or j (1). */
static struct transfer transfer_of(const struct ts_particles *p, const struct ts_contact_list *list,
				   const struct ts_pair *pair, size_t r, int side)
{
	const size_t of[2] = { (size_t)list->i[r], local_of(p, (size_t)list->j[r]) };
	const struct ts_granular_pair *law = ts_pair_law(pair, p->type[of[0]], p->type[of[1]]);
	const double liquid[2] = { p->liquid[of[0]], p->liquid[of[1]] };
	const double radius[2] = { p->radius[of[0]], p->radius[of[1]] };
	const double cube[2] = { ts_sphere_volume(radius[0]), ts_sphere_volume(radius[1]) };
	double volume = ts_bridge_volume(&pair->model, law, liquid, radius, false);
	double part = ts_bridge_part(&pair->model, law, liquid[side], radius[side], radius[!side]);
	int image = ts_contact_image(list, r);

	return (struct transfer){ .tag = ts_contact_tag(list, r, side),
				  .other = ts_contact_tag(list, r, !side),
				  .winding = ts_contact_winding(list, r),
				  .image = side ? 2 * TS_IMAGE_SELF - image : image,
				  .i = of[side] < p->n ? of[side] : ELSEWHERE,
				  .amount = volume / (cube[0] + cube[1]) - part / cube[side] };
}

/* The bridge of a pair ends without breaking. */
static void clear_bridge(struct tsim *sim, struct ts_contact_list *list, const struct ts_pair *pair, size_t r)
{
	if (!ts_contact_touches(list, r))
		return;
	ts_contacts_store_history(sim, list);
	*bridge_state(list, pair, r) = 0;
	list->active_chosen = false; /* the history in the list is to be loaded again */
}

/* Adds the transfers of the broken bridge of pair r: to both particles, or to i only, where the other side books its own. */
static enum ts_status add_broken(struct transfers *t, struct tsim *sim, struct ts_contact_list *list,
				 const struct ts_pair *pair, size_t r)
{
	const struct ts_particles *p = sim->particles;
	struct transfer to_i = transfer_of(p, list, pair, r, 0), to_j = transfer_of(p, list, pair, r, 1);
	size_t other = mirror_pair(list, p, r);
	bool across = ts_contact_image(list, r) != TS_IMAGE_SELF;

	TS_TRY(add_transfer(t, &to_i));
	/* a particle of another rank: this has the same entry, or one that differs by rounding, and does not know of this one */
	if (to_j.i == ELSEWHERE)
		return across ? add_transfer(t, &to_j) : TS_OK;
	if (other < list->n && has_broken(list, pair, other))
		return TS_OK;
	if (other < list->n)
		clear_bridge(sim, list, pair, other);
	return add_transfer(t, &to_j);
}

/* The entry of a particle of this rank for this transfer, list->n if there is none. */
static size_t find_entry(const struct ts_contact_list *list, const struct transfer *t)
{
	for (size_t k = 0; k < list->n; k++)
		if (ts_contact_tag(list, k, 0) == t->tag && ts_contact_tag(list, k, 1) == t->other &&
		    ts_contact_image(list, k) == t->image)
			return k;
	return list->n;
}

/* Adds the transfers of other ranks to particles of this one, unless the bridge has broken here, too. */
static enum ts_status take_transfers(struct transfers *t, struct tsim *sim, struct ts_contact_list *list,
				     const struct ts_pair *pair, const struct ts_parcel *rows)
{
	struct ts_identities map;

	TS_TRY(ts_identities(sim, false, &map));
	for (size_t k = 0; k < rows->n / sizeof(struct transfer); k++) {
		struct transfer one;
		int32_t i;
		size_t entry;

		memcpy(&one, rows->data + k * sizeof one, sizeof one);
		i = ts_identity_row(&map, one.tag);
		entry = i < 0 ? list->n : find_entry(list, &one);
		if (i < 0 || (entry < list->n && has_broken(list, pair, entry)))
			continue;
		if (entry < list->n)
			clear_bridge(sim, list, pair, entry);
		one.i = (size_t)i;
		TS_TRY(add_transfer(t, &one));
	}
	return TS_OK;
}

/* Whether a bridge may have its two entries on two ranks. */
static bool may_be_apart(const struct tsim *sim)
{
	bool periodic = false;

	for (int d = 0; d < 3; d++)
		periodic |= ts_box_periodic(&sim->domain->box, d);
	return periodic && sim->division && sim->neigh->contacts.bridge_column;
}

static enum ts_status exchange_transfers(struct transfers *t, struct tsim *sim, struct ts_contact_list *list,
					 const struct ts_pair *pair)
{
	struct ts_parcel others = { 0 };
	enum ts_status status = TS_OK;

	if (ts_ranks_most(sim, t->away.n > 0) > 0) {
		status = ts_world_share_others(sim->world, &t->away, &others);
		if (status == TS_OK)
			status = take_transfers(t, sim, list, pair, &others);
	}
	ts_parcel_release(&others);
	return status;
}

static enum ts_status collect(struct transfers *t, struct tsim *sim, const struct ts_pair *pair)
{
	struct ts_contact_list *list = &sim->neigh->contacts;

	for (size_t r = 0; list->bridges_broken && r < list->n; r++)
		if (has_broken(list, pair, r))
			TS_TRY(add_broken(t, sim, list, pair, r));
	return may_be_apart(sim) ? exchange_transfers(t, sim, list, pair) : TS_OK;
}

enum ts_status ts_broken_bridges_redistribute(struct tsim *sim, const struct ts_pair *pair)
{
	struct ts_contact_list *list = &sim->neigh->contacts;
	double *flux = sim->particles->column[pair->liquid.flux].data;
	struct transfers t = { .n = 0 };
	enum ts_status status;

	if (!list->bridges_broken && !may_be_apart(sim))
		return TS_OK;
	status = collect(&t, sim, pair);
	for (size_t r = 0; list->bridges_broken && r < list->n; r++)
		if (has_broken(list, pair, r))
			*bridge_state(list, pair, r) = 0;
	list->bridges_broken = false;
	ts_sort(t.item, t.n, sizeof *t.item, compare_transfers);
	for (size_t k = 0; k < t.n; k++)
		flux[t.item[k].i] += t.item[k].amount / sim->clock.dt;
	ts_free(t.item);
	ts_parcel_release(&t.away);
	return status == TS_OK ? TS_OK : ts_nomem(&sim->error);
}
