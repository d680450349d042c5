#include "contact/liquid.h"

#include <math.h>
#include <stdlib.h>

#include "contact/pair.h"
#include "law/capillary.h"
#include "material/property.h"
#include "neigh/contact_memory.h"
#include "particle/style_column.h"

#include "base/banned.h"

/* ---- columns */

static const char CONTENT[] = "surfaceLiquidContent", FLUX[] = "liquidFlux", SOURCE[] = "liquidSource";

static enum ts_status add(struct tsim *sim, struct ts_liquid *l, double initial)
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

static enum ts_status initial_of(struct tsim *sim, const struct ts_place *where, double *out)
{
	static const char name[] = "surfaceLiquidContentInitial";

	TS_TRY(ts_property_value(sim, name, 0, 0, "pair_style gran", where, out));
	if (*out >= 0)
		return TS_OK;
	return ts_fail(&sim->error, TS_RANGE, ts_property_place(sim, name, 0, 0),
		       "property/global %s is %.15g, expected a number >= 0", name, *out);
}

/* What is not known yet is NaN. */
enum ts_status ts_liquid_columns(struct tsim *sim, const struct ts_instance *self, struct ts_liquid *l)
{
	double initial = NAN;

	if (ts_property_given(sim, "surfaceLiquidContentInitial"))
		TS_TRY(initial_of(sim, &self->where, &initial));
	return add(sim, l, initial);
}

enum ts_status ts_liquid_init(struct tsim *sim, const struct ts_instance *self, struct ts_liquid *l)
{
	const struct ts_particles *p = sim->particles;
	double initial;

	TS_TRY(initial_of(sim, &self->where, &initial));
	TS_TRY(add(sim, l, initial));
	for (size_t i = 0; i < p->n + p->nghost; i++)
		p->liquid[i] = isnan(p->liquid[i]) ? initial : p->liquid[i];
	return TS_OK;
}

enum ts_status ts_liquid_archive(struct tsim *sim, struct ts_archive *a, struct ts_liquid *l)
{
	struct ts_particles *p = sim->particles;

	if (!ts_archive_writing(a))
		TS_TRY(add(sim, l, 0));
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

/* One side of a row: what particle i gets. */
struct part {
	int32_t tag, other, winding;
	size_t i;
	double amount; /* by its own volume */
};

struct parts {
	struct part *part;
	size_t n, capacity;
};

/* In an order that neither threads nor places in memory change. */
static int compare(const void *one, const void *two)
{
	const struct part *a = one, *b = two;

	if (a->tag != b->tag)
		return a->tag < b->tag ? -1 : 1;
	if (a->other != b->other)
		return a->other < b->other ? -1 : 1;
	return a->winding < b->winding ? -1 : a->winding > b->winding;
}

static size_t original(const struct ts_particles *p, size_t j)
{
	return j < p->n ? j : (size_t)p->ghost_owner[j - p->n];
}

static double *met_of(const struct ts_contact_list *list, const struct ts_pair *pair, size_t r)
{
	return &list->history[r * list->history_width + (size_t)ts_granular_met_at(&pair->model)];
}

static bool broken(const struct ts_contact_list *list, const struct ts_pair *pair, size_t r)
{
	return *met_of(list, pair, r) == TS_BRIDGE_BROKEN;
}

/* The row of the same pair on the other side of a periodic face, which may see the bridge break in
 * another step, as it rounds otherwise; rows->n: there is none. */
static size_t mirror(const struct ts_contact_list *list, const struct ts_particles *p, size_t r)
{
	for (size_t k = 0; list->image[r] != TS_IMAGE_SELF && k < list->n; k++)
		if ((size_t)list->i[k] == original(p, (size_t)list->j[r]) &&
		    (size_t)list->i[r] == original(p, (size_t)list->j[k]) &&
		    list->image[k] == 2 * TS_IMAGE_SELF - list->image[r])
			return k;
	return list->n;
}

static enum ts_status put(struct parts *transfers, const struct ts_particles *p,
			  const struct ts_contact_list *list, size_t r, int side, double amount)
{
	size_t i = original(p, (size_t)(side ? list->j[r] : list->i[r]));

	if (TS_GROW(transfers->part, transfers->capacity, transfers->n + 1) != TS_OK)
		return TS_NOMEM;
	transfers->part[transfers->n++] =
		(struct part){ list->tag[side][r], list->tag[!side][r], list->winding[r], i, amount };
	return TS_OK;
}

/* Row r has broken: what both get, or where the row of the other side books its own i, i alone. */
static enum ts_status book(struct parts *transfers, const struct ts_particles *p,
			   const struct ts_contact_list *list, const struct ts_pair *pair, size_t r,
			   bool both)
{
	size_t i = (size_t)list->i[r], j = original(p, (size_t)list->j[r]);
	const struct ts_granular_pair *law = ts_pair_law(pair, p->type[i], p->type[j]);
	const double liquid[2] = { p->liquid[i], p->liquid[j] }, radius[2] = { p->radius[i], p->radius[j] };
	double cube[2], volume = ts_bridge_volume(&pair->model, law, liquid, radius, false);

	for (int k = 0; k < 2; k++)
		cube[k] = ts_sphere_volume(radius[k]);
	for (int k = 0; k < 1 + both; k++)
		if (put(transfers, p, list, r, k,
			volume / (cube[0] + cube[1]) -
				ts_bridge_part(&pair->model, law, liquid[k], radius[k], radius[!k]) /
					cube[k]) != TS_OK)
			return TS_NOMEM;
	return TS_OK;
}

/* All that broke; bridges whose other side has not yet are forgotten there. */
static enum ts_status collect(struct parts *transfers, struct tsim *sim, struct ts_contact_list *list,
			      const struct ts_pair *pair)
{
	const struct ts_particles *p = sim->particles;

	for (size_t r = 0; r < list->n; r++) {
		size_t other;
		bool both;

		if (!broken(list, pair, r))
			continue;
		other = mirror(list, p, r);
		both = other == list->n || !broken(list, pair, other);
		if (book(transfers, p, list, pair, r, both) != TS_OK)
			return TS_NOMEM;
		if (other == list->n || !both || !list->touching[other])
			continue;
		ts_contacts_store_history(sim, list);
		*met_of(list, pair, other) = 0;
		list->active_chosen = false; /* what rows remember is read anew */
	}
	return TS_OK;
}

enum ts_status ts_liquid_share(struct tsim *sim, const struct ts_pair *pair)
{
	struct ts_contact_list *list = &sim->neigh->contacts;
	double *flux = sim->particles->column[pair->liquid.flux].data;
	struct parts transfers = { 0 };
	enum ts_status status = collect(&transfers, sim, list, pair);

	list->bridges_broken = false;
	for (size_t r = 0; r < list->n; r++)
		if (broken(list, pair, r))
			*met_of(list, pair, r) = 0;
	if (transfers.n)
		qsort(transfers.part, transfers.n, sizeof *transfers.part, compare);
	for (size_t k = 0; k < transfers.n; k++)
		flux[transfers.part[k].i] += transfers.part[k].amount / sim->clock.dt;
	ts_free(transfers.part);
	return status == TS_OK ? TS_OK : ts_nomem(&sim->error);
}
