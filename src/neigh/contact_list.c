#include "neigh/contact_list.h"

#include <string.h>

#include "base/parallel.h"
#include "box/domain.h"
#include "neigh/coincide.h"
#include "neigh/contact_history.h"
#include "neigh/contact_memory.h"
#include "neigh/contact_search.h"
#include "neigh/force_slots.h"
#include "neigh/neigh.h"
#include "particle/particles.h"

#include "base/banned.h"

/* See ts_contact_winding: box lengths by which particle i was wrapped, for an image those of its owner less its shift.
 */
static int32_t turns_of(const struct ts_particles *p, const struct ts_shear *shear, size_t i)
{
	const int8_t *shift = i < p->n ? NULL : p->ghost_shift[i - p->n];
	size_t owner = shift ? (size_t)p->ghost_owner[i - p->n] : i;
	int32_t turns[3];

	for (int k = 0; k < 3; k++)
		turns[k] = p->image[owner][k] - (shift ? shift[k] : 0);
	if (shear->on && shift)
		turns[shear->flow] += (int32_t)(shear->turns * shift[shear->gradient]);
	return ts_winding(turns);
}

struct note_task {
	const struct tsim *sim;
	struct ts_contact_list *list;
};

static void note_share(void *context, size_t from, size_t to)
{
	const struct note_task *t = context;
	const struct ts_particles *p = t->sim->particles;
	const struct ts_shear *shear = &t->sim->domain->box.shear;
	struct ts_contact_list *list = t->list;

	for (size_t i = from; i < to; i++) {
		list->tag[i] = p->tag[i];
		list->turns[i] = turns_of(p, shear, i);
		if (i >= p->n)
			list->image[i - p->n] = ts_contact_image_of(p, i);
	}
}

/* Notes identities and images of all particles. */
static enum ts_status note_particles(struct tsim *sim, struct ts_contact_list *list)
{
	const struct ts_particles *p = sim->particles;
	struct note_task task = { sim, list };
	size_t n = p->n + p->nghost;

	TS_TRY(TS_RENEW_UNSET(list->tag, list->tag_capacity, n));
	TS_TRY(TS_RENEW_UNSET(list->turns, list->turns_capacity, n));
	TS_TRY(TS_RENEW_UNSET(list->image, list->image_capacity, p->nghost));
	ts_parallel(ts_team(sim, 2 * n), n, note_share, &task);
	return TS_OK;
}

/* Allocates room for n pairs, but for their history; the old contents are lost. */
static enum ts_status reserve_pairs(struct ts_contact_list *list, size_t n)
{
	size_t held = list->capacity, capacity = 0;

	if (n <= held)
		return TS_OK;
	list->n = list->capacity = 0; /* in case of failure */
#define RENEW_COLUMN(column)                                       \
	do {                                                       \
		capacity = held;                                   \
		TS_TRY(TS_RENEW_UNSET(list->column, capacity, n)); \
	} while (0)
	RENEW_COLUMN(i);
	RENEW_COLUMN(j);
	RENEW_COLUMN(slot);
#undef RENEW_COLUMN
	list->capacity = capacity;
	return TS_OK;
}

struct fill_task {
	struct ts_contact_list *list;
	const struct ts_contact_search *found;
};

static void write_shares(void *context, size_t from, size_t to)
{
	const struct fill_task *f = context;

	for (size_t t = from; t < to; t++) {
		const struct ts_contact_found *share = &f->found->share[t];
		size_t r = share->first, at = 0;

		for (size_t k = r; k < r + share->n; k++) /* not touching */
			f->list->slot[k] = (uint32_t)TS_PAIR_INACTIVE << 1;
		for (size_t i = share->from; i < share->to; i++)
			for (size_t k = f->found->count[i]; k; k--) {
				f->list->i[r] = (int32_t)i;
				f->list->j[r++] = share->partner[at++];
			}
	}
}

/* Partners of the same identity, that is images of one particle, are put in the order of their images. In an
 * entry with side 1 the particle is j and its partner i, which is local, thus no image. */
static void order_images(const struct ts_contact_list *list, size_t from, size_t to)
{
	const struct ts_gather *g = &list->gather;

	for (size_t k = from + 1; k < to; k++) {
		uint32_t e = g->entry[k];
		int mine = e & 1 ? TS_IMAGE_SELF : ts_contact_image(list, e >> 1);
		size_t at = k;

		for (; at > from; at--) {
			uint32_t b = g->entry[at - 1];

			if (ts_contact_tag(list, b >> 1, !(b & 1)) !=
				    ts_contact_tag(list, e >> 1, !(e & 1)) ||
			    (b & 1 ? TS_IMAGE_SELF : ts_contact_image(list, b >> 1)) <= mine)
				break;
			g->entry[at] = b;
		}
		g->entry[at] = e;
	}
}

static void order_images_share(void *context, size_t from, size_t to)
{
	const struct ts_contact_list *list = context;
	const struct ts_gather *g = &list->gather;

	for (size_t i = from; i < to; i++)
		order_images(list, g->first[i], g->first[i + 1]);
}

/* Whether two images of a particle can be partners of the same one: no two are nearer each other than the least length of a
 * periodic box. reach: the largest distance of partners. */
static bool images_meet(const struct tsim *sim, double reach)
{
	const struct ts_domain *d = sim->domain;
	bool meet = false;

	for (int dim = 0; dim < 3; dim++)
		meet |= ts_box_periodic(&d->box, dim) && !(d->held_hi[dim] - d->held_lo[dim] > 2.001 * reach);
	return meet;
}

static enum ts_status index_by_particle(struct tsim *sim, struct ts_contact_list *list, double reach)
{
	const struct ts_particles *p = sim->particles;
	struct ts_gather_pairs pairs = {
		.n = list->n, .stride = 1, .end = { list->i, list->j }, .tag_of = list->tag
	};

	if (ts_gather_index(sim, &list->gather, &pairs) != TS_OK)
		return ts_nomem(&sim->error);
	if (p->nghost && images_meet(sim, reach))
		ts_parallel(ts_team(sim, 4 * list->n), p->n, order_images_share, list);
	return TS_OK;
}

/* What belongs to the pairs of the old list. Rows of sums, of a fixed size per particle, take most memory while the search
 * needs it, and are given back; the rest is kept, as to map its memory anew for each list takes longer than to fill it. */
static void forget_active_pairs(struct ts_contact_list *list)
{
	list->active_chosen = false;
	ts_free(list->sum);
	list->sum = NULL;
	list->sum_capacity = 0;
	ts_free(list->spare);
	list->spare = NULL;
	ts_contacts_give_history_back(list);
}

/* Whether pairs that do not touch may have history: those that have parted, and liquid bridges that broke. */
static bool parted_history(const struct tsim *sim, const struct ts_contact_list *list)
{
	return sim->legacy == TS_LEGACY_LIGGGHTS || list->bridge_column;
}

static enum ts_status search_and_build(struct tsim *sim, struct ts_contact_list *list,
				       struct ts_contact_search *found, struct ts_contact_history *old)
{
	size_t all = sim->particles->n + sim->particles->nghost;
	const struct ts_instance *pair = ts_sim_only(sim, TS_KIND_PAIR);
	struct fill_task task = { list, found };
	bool coincide;
	double reach;

	if (!sim->run.resuming) /* forces are saved only for a run that is continued */
		ts_force_slots_forget(list);
	TS_TRY(ts_contact_history_carry(sim, list, sim->run.resuming, old));
	if (sim->division && !sim->run.resuming && list == &sim->neigh->contacts)
		TS_TRY(ts_contact_history_append(sim, old, &sim->neigh->saved)); /* from other ranks */
	ts_force_slots_forget(list);
	forget_active_pairs(list);
	TS_TRY(ts_contact_search(sim, found));
	if (note_particles(sim, list) != TS_OK || reserve_pairs(list, found->n) != TS_OK ||
	    ts_contacts_reserve_history(list, found->n, parted_history(sim, list)) != TS_OK ||
	    TS_RENEW_UNSET(list->sphere, list->sphere_capacity, all) != TS_OK ||
	    TS_RENEW_UNSET(list->motion, list->motion_capacity, all) != TS_OK)
		return ts_nomem(&sim->error);
	list->n = found->n;
	list->sums_listed = false;
	list->skin = found->skin;
	list->particles = sim->particles->n;
	list->pair = pair ? pair->serial : 0;
	list->locals_packed = false;
	list->displacement = 0;
	if (all) /* so that the first displacements are computed from defined numbers */
		memset(list->sphere, 0, all * sizeof *list->sphere);
	ts_parallel(found->shares, (size_t)found->shares, write_shares, &task);
	coincide = found->coincide;
	reach = 2 * found->cells.level[0].reach + found->skin;
	ts_contact_search_release(found);
	if (coincide && !list->both_frozen)
		TS_TRY(ts_coincide_check_pairs(sim, list));
	TS_TRY(index_by_particle(sim, list, reach));
	if (sim->run.resuming) /* outputs may read forces before they are computed */
		TS_TRY(ts_force_slots_keep_all(sim, list));
	return ts_contact_history_restore(sim, old, list);
}

enum ts_status ts_contact_list_build(struct tsim *sim, struct ts_contact_list *list, double skin,
				     ts_excluded_fn *excluded)
{
	struct ts_contact_search found = {
		.skin = skin, .both_frozen = list->both_frozen, .excluded = excluded, .expected = list->n
	};
	struct ts_contact_history old = { 0 };
	enum ts_status status = search_and_build(sim, list, &found, &old);

	ts_contact_search_release(&found);
	ts_contact_history_release(&old);
	return status;
}

void ts_contact_list_set_torques(struct ts_contact_list *list, bool turn, bool roll)
{
	int parts = roll ? 3 : turn ? 2 : 1;

	if (parts != list->parts)
		list->results = TS_RESULTS_NONE;
	list->parts = parts;
}

enum ts_status ts_contact_list_set_history(struct tsim *sim, struct ts_contact_list *list, size_t width,
					   const signed char *sign)
{
	for (size_t k = 0; k < width; k++) /* the pair style may be deleted before the list */
		list->history_sign[k] = sign[k];
	if (width == list->history_width)
		return TS_OK;
	ts_free(list->history);
	list->history = NULL;
	list->history_capacity = 0;
	list->active_chosen = list->memory_newer = false;
	list->history_width = width;
	return ts_contacts_reserve_history(list, list->n, list->history_by_pair) == TS_OK
		       ? TS_OK
		       : ts_nomem(&sim->error);
}

/* History and results are not in memory at the same time where all results are kept: ts_contacts_forget_history. */
static size_t largest_state(const struct ts_contact_list *list)
{
	size_t history = list->n * list->history_width * sizeof *list->history,
	       kept = list->n * (size_t)list->parts * sizeof *list->result; /* if all pairs touch */

	return history > kept ? history : kept;
}

size_t ts_contact_list_bytes(const struct ts_contact_list *list)
{
	const struct {
		size_t n, size;
	} part[] = {
		{ list->capacity, sizeof *list->i + sizeof *list->j + sizeof *list->slot },
		{ list->history_word_capacity, sizeof *list->history_word },
		{ list->tag_capacity, sizeof *list->tag },
		{ list->turns_capacity, sizeof *list->turns },
		{ list->image_capacity, sizeof *list->image },
		{ list->sphere_capacity, sizeof *list->sphere },
		{ list->motion_capacity, sizeof *list->motion },
		{ list->memory_capacity, sizeof *list->memory },
		{ list->gather.first_capacity, sizeof *list->gather.first },
		{ list->gather.entry_capacity, sizeof *list->gather.entry },
		{ list->active_capacity, sizeof *list->active },
		{ list->block_capacity, sizeof *list->block },
		{ list->sum_capacity, sizeof *list->sum },
		{ list->sum_rest_capacity, sizeof *list->sum_rest },
		{ list->sum_place_capacity, sizeof *list->sum_place },
		{ list->sums_capacity, sizeof *list->sums },
		{ list->rest_first_capacity, sizeof *list->rest_first },
		{ list->chunk_capacity, sizeof *list->chunk + sizeof *list->chunk_summed },
	};
	size_t bytes = largest_state(list);

	for (size_t k = 0; k < sizeof part / sizeof *part; k++)
		bytes += part[k].n * part[k].size;
	return bytes;
}

void ts_contact_list_release(struct ts_contact_list *list)
{
	ts_free(list->i);
	ts_free(list->j);
	ts_free(list->tag);
	ts_free(list->turns);
	ts_free(list->image);
	ts_free(list->result);
	ts_free(list->next_slot);
	ts_free(list->slot);
	ts_free(list->history);
	ts_free(list->history_word);
	ts_free(list->memory);
	ts_free(list->spare);
	ts_free(list->sphere);
	ts_free(list->motion);
	ts_free(list->span);
	ts_free(list->active);
	ts_free(list->block);
	ts_free(list->sum);
	ts_free(list->sum_place);
	ts_free(list->sums);
	ts_free(list->sum_rest);
	ts_free(list->rest_first);
	ts_free(list->chunk);
	ts_free(list->chunk_summed);
	ts_gather_release(&list->gather);
	*list = (struct ts_contact_list){ 0 };
}
