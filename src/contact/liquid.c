#include "contact/liquid.h"

#include <math.h>
#include <stdlib.h>

#include "base/sort.h"
#include "contact/pair.h"
#include "law/capillary.h"
#include "material/property.h"
#include "neigh/contact_memory.h"
#include "particle/columns.h"
#include "particle/style_column.h"

#include "base/banned.h"

/* ---- columns */

static const char CONTENT[] = "surfaceLiquidContent", FLUX[] = "liquidFlux", SOURCE[] = "liquidSource";

static enum ts_status add_columns(struct tsim *sim, struct ts_liquid *l, double initial)
{
	struct ts_particles *p = sim->particles;
	const unsigned shared = TS_COL_NAMED | TS_COL_BORDER | TS_COL_FORWARD;

	TS_TRY(ts_particles_style_column(sim, CONTENT, 1, shared, initial, &l->content));
	TS_TRY(ts_particles_style_column(sim, FLUX, 1, TS_COL_NAMED, 0, &l->flux));
	TS_TRY(ts_particles_style_column(sim, SOURCE, 1, TS_COL_NAMED, 0, &l->source));
	p->column[l->content].bound = (void **)(void *)&p->liquid;
	p->liquid = p->column[l->content].data;
	return TS_OK;
}

static enum ts_status initial_content(struct tsim *sim, const struct ts_place *where, double *out)
{
	static const char name[] = "surfaceLiquidContentInitial";

	TS_TRY(ts_property_value(sim, name, 0, 0, "pair_style gran", where, out));
	if (*out >= 0)
		return TS_OK;
	return ts_fail(&sim->error, TS_RANGE, ts_property_place(sim, name, 0, 0),
		       "property/global %s is %.15g, expected a number >= 0", name, *out);
}

/* The initial content may not be given yet: NaN. */
enum ts_status ts_liquid_columns(struct tsim *sim, const struct ts_instance *self, struct ts_liquid *l)
{
	double initial = NAN;

	if (ts_property_given(sim, "surfaceLiquidContentInitial"))
		TS_TRY(initial_content(sim, &self->where, &initial));
	return add_columns(sim, l, initial);
}

enum ts_status ts_liquid_init(struct tsim *sim, const struct ts_instance *self, struct ts_liquid *l)
{
	const struct ts_particles *p = sim->particles;
	double initial;

	TS_TRY(initial_content(sim, &self->where, &initial));
	TS_TRY(add_columns(sim, l, initial));
	for (size_t i = 0; i < p->n + p->nghost; i++)
		p->liquid[i] = isnan(p->liquid[i]) ? initial : p->liquid[i];
	return TS_OK;
}

enum ts_status ts_liquid_archive(struct tsim *sim, struct ts_archive *a, struct ts_liquid *l)
{
	struct ts_particles *p = sim->particles;

	if (!ts_archive_writing(a))
		TS_TRY(add_columns(sim, l, 0));
	TS_TRY(ts_particles_archive_column(a, sim, p->column[l->content].name, l->content));
	TS_TRY(ts_particles_archive_column(a, sim, p->column[l->flux].name, l->flux));
	return ts_particles_archive_column(a, sim, p->column[l->source].name, l->source);
}

void ts_liquid_advance(struct tsim *sim, const struct ts_liquid *l)
{
	const struct ts_particles *p = sim->particles;
	double *content = p->column[l->content].data, *flux = p->column[l->flux].data,
	       *source = p->column[l->source].data;

	for (size_t i = 0; i < p->n; i++) {
		content[i] += sim->clock.dt * (flux[i] + source[i]);
		flux[i] = 0;
	}
}

/* ---- bridges that broke */

/* Liquid that particle i gets from a broken bridge. */
struct transfer {
	int32_t tag, other, winding;
	size_t i;
	double amount; /* relative to the volume of the particle */
};

struct transfer_list {
	struct transfer *item;
	size_t n, capacity;
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
	return &list->history[r * list->history_width + (size_t)ts_granular_met_at(&pair->model)];
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

static enum ts_status append_transfer(struct transfer_list *transfers, const struct ts_particles *p,
				      const struct ts_contact_list *list, size_t r, int side, double amount)
{
	size_t i = local_of(p, (size_t)(side ? list->j[r] : list->i[r]));

	if (TS_GROW(transfers->item, transfers->capacity, transfers->n + 1) != TS_OK)
		return TS_NOMEM;
	transfers->item[transfers->n++] =
		(struct transfer){ ts_contact_tag(list, r, side), ts_contact_tag(list, r, !side),
				   ts_contact_winding(list, r), i, amount };
	return TS_OK;
}

/* Transfers of the broken bridge of pair r: to both particles, or, where the entry of the other side books
 * its own, to i only. */
static enum ts_status book_transfers(struct transfer_list *transfers, const struct ts_particles *p,
				     const struct ts_contact_list *list, const struct ts_pair *pair, size_t r,
				     bool both)
{
	size_t i = (size_t)list->i[r], j = local_of(p, (size_t)list->j[r]);
	const struct ts_granular_pair *law = ts_pair_law(pair, p->type[i], p->type[j]);
	const double liquid[2] = { p->liquid[i], p->liquid[j] }, radius[2] = { p->radius[i], p->radius[j] };
	double cube[2], volume = ts_bridge_volume(&pair->model, law, liquid, radius, false);

	for (int k = 0; k < 2; k++)
		cube[k] = ts_sphere_volume(radius[k]);
	for (int k = 0; k < 1 + both; k++)
		if (append_transfer(transfers, p, list, r, k,
				    volume / (cube[0] + cube[1]) - ts_bridge_part(&pair->model, law,
										  liquid[k], radius[k],
										  radius[!k]) /
									   cube[k]) != TS_OK)
			return TS_NOMEM;
	return TS_OK;
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

/* Collects the transfers of all broken bridges. A bridge whose other entry has not broken yet is cleared
 * there. */
static enum ts_status collect_broken(struct transfer_list *transfers, struct tsim *sim,
				     struct ts_contact_list *list, const struct ts_pair *pair)
{
	const struct ts_particles *p = sim->particles;

	for (size_t r = 0; r < list->n; r++) {
		size_t other;
		bool both;

		if (!has_broken(list, pair, r))
			continue;
		other = mirror_pair(list, p, r);
		/* of a pair with a particle of another rank this one books the transfer to its own */
		both = local_of(p, (size_t)list->j[r]) < p->n &&
		       (other == list->n || !has_broken(list, pair, other));
		if (book_transfers(transfers, p, list, pair, r, both) != TS_OK)
			return TS_NOMEM;
		if (other != list->n && both)
			clear_bridge(sim, list, pair, other);
	}
	return TS_OK;
}

enum ts_status ts_liquid_redistribute(struct tsim *sim, const struct ts_pair *pair)
{
	struct ts_contact_list *list = &sim->neigh->contacts;
	double *flux = sim->particles->column[pair->liquid.flux].data;
	struct transfer_list transfers = { 0 };
	enum ts_status status = collect_broken(&transfers, sim, list, pair);

	list->bridges_broken = false;
	for (size_t r = 0; r < list->n; r++)
		if (has_broken(list, pair, r))
			*bridge_state(list, pair, r) = 0;
	ts_sort(transfers.item, transfers.n, sizeof *transfers.item, compare_transfers);
	for (size_t k = 0; k < transfers.n; k++)
		flux[transfers.item[k].i] += transfers.item[k].amount / sim->clock.dt;
	ts_free(transfers.item);
	return status == TS_OK ? TS_OK : ts_nomem(&sim->error);
}
