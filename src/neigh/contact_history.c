#include "neigh/contact_history.h"

#include <string.h>

#include "base/parallel.h"
#include "math/vec3.h"
#include "neigh/contact_memory.h"
#include "neigh/force_slots.h"
#include "particle/copies.h"
#include "particle/identity.h"

#include "base/banned.h"

/* Across a periodic face a pair is listed twice, once with each particle as i. Both entries are equal but for
 * rounding, and each keeps its own history. The bit is set in the winding of the entry whose i has the larger
 * identity. */
enum { OTHER_SIDE = TS_HISTORY_OTHER_SIDE };

/* The key of pair r; *swapped: its i has the larger identity. */
static struct ts_contact_key make_key(const struct ts_contact_list *list, size_t r, bool *swapped)
{
	int32_t a = ts_contact_tag(list, r, 0), b = ts_contact_tag(list, r, 1);
	int32_t there = ts_contact_winding(list, r), back = ts_winding_difference(0, there);
	int32_t side = ts_contact_image(list, r) == TS_IMAGE_SELF ? 0 : OTHER_SIDE;

	*swapped = a > b || (a == b && there < back);
	if (*swapped)
		return (struct ts_contact_key){ { b, a }, back | side };
	return (struct ts_contact_key){ { a, b }, there };
}

static void copy_signed(double *to, const double *from, size_t width, const signed char *sign, bool swapped)
{
	for (size_t c = 0; c < width; c++)
		to[c] = swapped && sign[c] < 0 ? -from[c] : from[c];
}

/* Room for n contacts in the list's memory for active pairs and their history, which serves again only after the next list is
 * made; false: there is too little, as at the first list and where the columns of many blocks were extended. */
static bool borrow_memory(const struct ts_contact_list *list, struct ts_contact_history *h, size_t n)
{
	h->lent = h->width && n * h->width <= list->memory_capacity &&
		  n * sizeof *h->key <= list->active_capacity * sizeof *list->active;
	if (h->lent) {
		h->key = (void *)list->active;
		h->value = list->memory;
	}
	return h->lent;
}

static enum ts_status allocate_history(struct tsim *sim, struct ts_contact_history *h, size_t n, bool forces,
				       bool torques)
{
	h->key = ts_alloc(n, sizeof *h->key);
	h->value = ts_alloc(n * h->width, sizeof *h->value);
	h->force = forces ? ts_alloc(n, sizeof *h->force) : NULL;
	h->torque = torques ? ts_alloc(n, sizeof *h->torque) : NULL;
	if (!h->key || !h->value || (forces && !h->force) || (torques && !h->torque)) {
		ts_contact_history_release(h);
		return ts_nomem(&sim->error);
	}
	return TS_OK;
}

static void copy_force(double to[3], const double from[3], bool swapped)
{
	for (int k = 0; k < 3; k++)
		to[k] = swapped ? -from[k] : from[k];
}

static void save_torque(const struct ts_contact_list *list, size_t slot, bool swapped,
			double to[TS_HISTORY_TORQUE])
{
	to[0] = ts_contact_force(list, slot)[3];
	for (int k = 0; k < 3; k++)
		to[1 + k] = ts_contact_tangential_torque(list, slot)[k];
	if (list->parts > 2)
		copy_force(to + 4, ts_contact_rolling_torque(list, slot), swapped);
}

static void restore_torque(const struct ts_contact_list *list, size_t slot, bool swapped,
			   const double from[TS_HISTORY_TORQUE])
{
	if (list->parts < 2)
		return;
	ts_contact_force(list, slot)[3] = from[0];
	for (int k = 0; k < 3; k++)
		ts_contact_tangential_torque(list, slot)[k] = from[1 + k];
	if (list->parts > 2)
		copy_force(ts_contact_rolling_torque(list, slot), from + 4, swapped);
}

/* Saving by shares of the list, in its order. */
struct saving {
	const struct ts_contact_list *list;
	struct ts_contact_history *h;
	const struct ts_leaving *of; /* NULL: pairs of all particles */
	bool forces, memories, lend;
	size_t shares, *first; /* by share: number of its contacts, then of those of the shares before */
};

static bool has_state(const struct ts_contact_list *list, size_t r, bool memories)
{
	bool has = ts_contact_touches(list, r);

	for (size_t c = 0; memories && !has && c < list->history_width; c++)
		has = ts_contact_history(list, r)[c] != 0;
	return has;
}

/* Leaves out the pairs without a particle that leaves. */
static size_t keep_leaving(const struct saving *s, size_t *row, size_t n)
{
	size_t kept = 0;

	for (size_t k = 0; k < n; k++) {
		row[kept] = row[k];
		kept += ts_carried_leaves(s->of, ts_contact_tag(s->list, row[k], 0)) ||
			ts_carried_leaves(s->of, ts_contact_tag(s->list, row[k], 1));
	}
	return kept;
}

enum { SOME_PAIRS = 1024 };

/* Those of the pairs from .. to-1, at most SOME_PAIRS, that are saved. Without branches, since nobody can foretell them. */
static size_t choose_pairs(const struct saving *s, size_t from, size_t to, size_t *row)
{
	const struct ts_contact_list *list = s->list;
	const struct ts_leaving *of = s->of;
	const bool memories = s->memories;
	size_t n = 0;

	for (size_t r = from; r < to; r++) {
		bool is = has_state(list, r, memories);

		if (of)
			is &= ts_carried_may_leave(of, ts_contact_tag(list, r, 0)) |
			      ts_carried_may_leave(of, ts_contact_tag(list, r, 1));
		row[n] = r;
		n += is;
	}
	return of ? keep_leaving(s, row, n) : n;
}

/* Calls choose_pairs for the next pairs of share t, from *r on. */
static size_t next_pairs(const struct saving *s, size_t t, size_t *r, size_t *row)
{
	size_t from = *r, end = s->list->n * (t + 1) / s->shares;

	*r = end - from < SOME_PAIRS ? end : from + SOME_PAIRS;
	return choose_pairs(s, from, *r, row);
}

static void count_shares(void *context, size_t from, size_t to)
{
	const struct saving *s = context;
	size_t row[SOME_PAIRS];

	for (size_t t = from; t < to; t++) {
		size_t n = 0;

		for (size_t r = s->list->n * t / s->shares; r < s->list->n * (t + 1) / s->shares;)
			n += next_pairs(s, t, &r, row);
		s->first[t] = n;
	}
}

static void save_pair(const struct saving *s, size_t r, size_t n)
{
	const struct ts_contact_list *list = s->list;
	const size_t width = s->h->width;
	bool swapped;

	s->h->key[n] = make_key(list, r, &swapped);
	if (s->forces)
		copy_force(s->h->force[n], ts_contact_force(list, ts_contact_kept(list, r)), swapped);
	if (s->forces && s->h->torque)
		save_torque(list, ts_contact_kept(list, r), swapped, s->h->torque[n]);
	if (width)
		copy_signed(s->h->value + n * width, ts_contact_history(list, r), width, list->history_sign,
			    swapped);
}

static void save_shares(void *context, size_t from, size_t to)
{
	const struct saving *s = context;
	size_t row[SOME_PAIRS];

	for (size_t t = from; t < to; t++) {
		size_t n = s->first[t];

		for (size_t r = s->list->n * t / s->shares; r < s->list->n * (t + 1) / s->shares;) {
			size_t some = next_pairs(s, t, &r, row);

			for (size_t k = 0; k < some; k++)
				save_pair(s, row[k], n++);
		}
	}
}

/* `forces`: room for them is made even if they are 0. */
static enum ts_status save_shares_of(struct tsim *sim, struct saving *s, bool forces)
{
	size_t n = 0;

	ts_parallel((int)s->shares, s->shares, count_shares, s);
	for (size_t t = 0; t < s->shares; t++) {
		size_t some = s->first[t];

		s->first[t] = n;
		n += some;
	}
	if (!n)
		return TS_OK;
	if (!s->lend || forces || !borrow_memory(s->list, s->h, n))
		TS_TRY(allocate_history(sim, s->h, n, forces, forces && s->list->parts > 1));
	s->h->n = n;
	ts_parallel((int)s->shares, s->shares, save_shares, s);
	return TS_OK;
}

static enum ts_status save_contacts(struct tsim *sim, struct ts_contact_list *list, bool forces,
				    bool memories, const struct ts_leaving *of, bool lend,
				    struct ts_contact_history *h)
{
	/* the results are not kept after a step that failed: then forces are 0 */
	struct saving s = { .list = list,
			    .h = h,
			    .of = of,
			    .forces = forces && list->results == TS_RESULTS_KEPT,
			    .memories = memories,
			    .lend = lend,
			    .shares = (size_t)ts_team(sim, 4 * list->n) };
	enum ts_status status;

	*h = (struct ts_contact_history){ .width = list->history_width,
					  .overlapping = memories && !sim->run.resuming,
					  .parted = memories && sim->run.resuming };
	ts_contacts_store_history(sim, list);
	if (!list->n || !(h->width || forces))
		return TS_OK;
	s.first = ts_alloc(s.shares, sizeof *s.first);
	if (!s.first)
		return ts_nomem(&sim->error);
	status = save_shares_of(sim, &s, forces);
	ts_free(s.first);
	return status;
}

enum ts_status ts_contact_history_save(struct tsim *sim, struct ts_contact_list *list, bool forces,
				       const struct ts_leaving *of, struct ts_contact_history *h)
{
	return save_contacts(sim, list, forces, false, of, false, h);
}

enum ts_status ts_contact_history_save_all(struct tsim *sim, struct ts_contact_list *list, bool forces,
					   const struct ts_leaving *of, struct ts_contact_history *h)
{
	return save_contacts(sim, list, forces, true, of, false, h);
}

enum ts_status ts_contact_history_carry(struct tsim *sim, struct ts_contact_list *list, bool forces,
					struct ts_contact_history *h)
{
	TS_TRY(save_contacts(sim, list, forces, sim->legacy == TS_LEGACY_LIGGGHTS, NULL, true, h));
	list->active_chosen = false;
	return TS_OK;
}

static void copy_contacts(struct ts_contact_history *to, const struct ts_contact_history *from)
{
	if (from->n)
		memcpy(to->key + to->n, from->key, from->n * sizeof *from->key);
	if (from->n && to->width)
		memcpy(to->value + to->n * to->width, from->value, from->n * to->width * sizeof *from->value);
	to->n += from->n;
}

enum ts_status ts_contact_history_append(struct tsim *sim, struct ts_contact_history *h,
					 struct ts_contact_history *more)
{
	struct ts_contact_history both = { .width = h->width,
					   .overlapping = h->overlapping,
					   .parted = h->parted };

	if (more->n && more->width == h->width) {
		TS_TRY(allocate_history(sim, &both, h->n + more->n, false, false));
		copy_contacts(&both, h);
		copy_contacts(&both, more);
		ts_contact_history_release(h);
		*h = both;
	}
	ts_contact_history_release(more);
	return TS_OK;
}

static bool overlaps(const struct ts_particles *p, const struct ts_contact_list *list, size_t r)
{
	size_t i = (size_t)list->i[r], j = (size_t)list->j[r];
	double sum = p->radius[i] + p->radius[j];

	return ts_distance2(p->x[i], p->x[j]) < sum * sum;
}

/* Whether the saved contact k had a liquid bridge. */
static bool had_bridge(const struct ts_contact_list *list, const struct ts_contact_history *h, size_t k)
{
	return list->bridge_column && h->value[k * h->width + list->bridge_column - 1] > 0;
}

/* Saved contacts by particle: a linked list for the smaller identity of each key. Neighbouring particles are
 * near each other in memory, and so are their lists. */
struct restoring {
	const struct ts_contact_history *h;
	const struct ts_particles *p;
	struct ts_contact_list *list;
	/* by local particle, then by copy (particle/copies.h) */
	struct {
		uint64_t
			larger; /* the larger identities of its keys, each as the bit of its remainder by 64 */
		int32_t first;	/* index of its first key + 1, 0: none */
	} * chain;
	struct {
		/* the larger identity; index of the next key of the same particle + 1, 0: none */
		int32_t larger, next;
	} * link; /* by key */
};

struct chaining {
	struct restoring *g;
	struct ts_identities map;
	struct ts_copy_map copy;
	int team; /* number of threads */
};

/* Index of the particle or copy with this tag, or -1. */
static int32_t row_of(const struct chaining *c, int32_t tag)
{
	int32_t at = ts_identity_row(&c->map, tag);

	if (at >= 0)
		return at;
	at = ts_copy_map_find(&c->copy, tag);
	return at < 0 ? at : (int32_t)c->g->p->n + at;
}

static uint64_t bit_of(int32_t tag)
{
	return (uint64_t)1 << ((uint32_t)tag & 63);
}

/* The order of the keys of a particle depends on the threads, but is of no effect: at most one is the key of a pair. */
static void chain_share(void *context, size_t from, size_t to)
{
	const struct chaining *c = context;
	struct restoring *g = c->g;

	for (size_t k = from; k < to; k++) {
		int32_t at = row_of(c, g->h->key[k].tag[0]);
		uint64_t larger = bit_of(g->h->key[k].tag[1]);

		if (at < 0) /* the particle has left */
			continue;
		g->link[k].larger = g->h->key[k].tag[1];
		if (c->team > 1) {
			(void)__atomic_fetch_or(&g->chain[at].larger, larger, __ATOMIC_RELAXED);
			g->link[k].next =
				__atomic_exchange_n(&g->chain[at].first, (int32_t)k + 1, __ATOMIC_RELAXED);
		} else { /* a third of the time */
			g->chain[at].larger |= larger;
			g->link[k].next = g->chain[at].first;
			g->chain[at].first = (int32_t)k + 1;
		}
	}
}

static enum ts_status chain_keys_by_particle(struct tsim *sim, struct restoring *g)
{
	struct chaining c = { .g = g, .team = ts_team(sim, 4 * g->h->n) };
	bool room;

	TS_TRY(ts_identities(sim, false, &c.map));
	g->chain = ts_alloc(g->p->n + ts_copies(sim), sizeof *g->chain);
	g->link = ts_alloc(g->h->n, sizeof *g->link);
	room = ts_copy_map_make(sim, &c.copy) == TS_OK && g->chain && g->link;
	if (room)
		ts_parallel(c.team, g->h->n, chain_share, &c);
	ts_copy_map_release(&c.copy);
	return room ? TS_OK : ts_nomem(&sim->error);
}

/* The local particle, or the copy, of which i is an image, or i itself. */
static size_t local_of(const struct restoring *g, int32_t i)
{
	size_t at = (size_t)i;

	return at < g->p->n ? at : (size_t)g->p->ghost_owner[at - g->p->n];
}

/* Index + 1 of the key, 0: not found. A pair that has moved to a periodic face is listed twice where it was
 * listed once, or the reverse when it leaves the face: then the key of the other side serves. */
static int32_t find_either(const struct restoring *g, const struct ts_contact_key *key, size_t smaller)
{
	int32_t other = 0;

	for (int32_t k = g->chain[smaller].first; k; k = g->link[k - 1].next) {
		int32_t winding = g->h->key[k - 1].winding;

		if (g->link[k - 1].larger != key->tag[1])
			continue;
		if (winding == key->winding)
			return k;
		if (winding == (key->winding ^ OTHER_SIDE))
			other = k;
	}
	return other;
}

/* Whether the particles of the pair, or images of them, have a key: most pairs have none, and for them the
 * full key need not be made. */
static bool has_key(const struct restoring *g, size_t r)
{
	/* a table instead of a branch, which would be mispredicted half of the time */
	const int32_t *const end[2] = { g->list->i, g->list->j };
	int32_t a = ts_contact_tag(g->list, r, 0), b = ts_contact_tag(g->list, r, 1), larger = a > b ? a : b;
	size_t smaller = local_of(g, end[a > b][r]);
	int32_t k;

	if (!(g->chain[smaller].larger & bit_of(larger)))
		return false;
	k = g->chain[smaller].first;
	while (k && g->link[k - 1].larger != larger)
		k = g->link[k - 1].next;
	return k != 0;
}

/* Index + 1 of the key of pair r, 0: none; *swapped: as for make_key. */
static int32_t find_key(const struct restoring *g, size_t r, bool *swapped)
{
	struct ts_contact_key key;

	if (!has_key(g, r))
		return 0;
	key = make_key(g->list, r, swapped);
	return find_either(g, &key, local_of(g, *swapped ? g->list->j[r] : g->list->i[r]));
}

static void copy_values(const struct restoring *g, size_t r, size_t k, bool swapped)
{
	if (g->h->width)
		copy_signed(ts_contact_history(g->list, r), g->h->value + k * g->h->width, g->h->width,
			    g->list->history_sign, swapped);
}

/* To a list in which all pairs have entries. */
static void restore_share(void *context, size_t from, size_t to)
{
	const struct restoring *g = context;
	const struct ts_contact_history *h = g->h;
	struct ts_contact_list *list = g->list;

	for (size_t r = from; r < to; r++) {
		bool swapped, apart;
		int32_t k = find_key(g, r, &swapped);

		apart = (h->overlapping || h->parted) && k && !overlaps(g->p, list, r) &&
			!had_bridge(list, h, (size_t)(k - 1));
		if (!k || (apart && h->overlapping))
			continue;
		ts_contact_set_touching(list, r, !apart);
		copy_values(g, r, (size_t)(k - 1), swapped);
		if (h->force)
			copy_force(ts_contact_force(list, ts_contact_kept(list, r)), h->force[k - 1],
				   swapped);
		if (h->torque)
			restore_torque(list, ts_contact_kept(list, r), swapped, h->torque[k - 1]);
	}
}

/* To a list in which only pairs that touch have entries, in two passes: which do, with their keys as slots; then their
 * history. */
static void find_share(void *context, size_t from, size_t to)
{
	const struct restoring *g = context;

	for (size_t r = from; r < to; r++) {
		bool swapped;
		int32_t k = find_key(g, r, &swapped);

		if (k)
			g->list->slot[r] = (uint32_t)(k - 1) << 1 | 1;
	}
}

static void fill_share(void *context, size_t from, size_t to)
{
	const struct restoring *g = context;
	const struct ts_contact_list *list = g->list;

	for (size_t r = from; r < to; r++) {
		bool swapped;

		if (!ts_contact_touches(list, r))
			continue;
		(void)make_key(list, r, &swapped);
		copy_values(g, r, ts_contact_slot(list, r), swapped);
		ts_contact_set_slot(list, r, TS_PAIR_INACTIVE);
	}
}

static void restore_touching(struct tsim *sim, struct restoring *g)
{
	int team = ts_team(sim, 4 * g->list->n);

	ts_parallel(team, g->list->n, find_share, g);
	ts_contacts_note_history(sim, g->list);
	ts_parallel(team, g->list->n, fill_share, g);
}

enum ts_status ts_contact_history_restore(struct tsim *sim, const struct ts_contact_history *h,
					  struct ts_contact_list *list)
{
	struct restoring g = { .h = h, .p = sim->particles, .list = list };
	enum ts_status status;

	if (!h->n || !list->n)
		return TS_OK;
	if (h->force)
		TS_TRY(ts_force_slots_keep_all(sim, list));
	if (list->results == TS_RESULTS_KEPT || ts_contacts_with_history(list))
		ts_contacts_spread_history(
			list); /* slots are in use, or some pairs have their history already */
	status = chain_keys_by_particle(sim, &g);
	if (status == TS_OK && list->history_by_pair)
		ts_parallel(ts_team(sim, 4 * list->n), list->n, restore_share, &g);
	else if (status == TS_OK)
		restore_touching(sim, &g);
	ts_free(g.chain);
	ts_free(g.link);
	return status;
}

void ts_contact_history_release(struct ts_contact_history *h)
{
	if (!h->lent) {
		ts_free(h->key);
		ts_free(h->value);
	}
	ts_free(h->force);
	ts_free(h->torque);
	*h = (struct ts_contact_history){ 0 };
}

enum ts_status ts_contact_history_archive(struct ts_archive *archive, struct tsim *sim,
					  struct ts_contact_history *h)
{
	int64_t size[2] = { (int64_t)h->n, (int64_t)h->width };
	bool torques =
		ts_archive_writing(archive) ? h->torque != NULL : ts_archive_has(archive, "contact_torques");

	TS_TRY(ts_archive_fixed(archive, "history_size", TS_SAVED_I64, size, 2));
	if (size[0] < 0 || size[0] > INT32_MAX || size[1] < 0 || size[1] > 1024)
		return ts_fail(&sim->error, TS_DAMAGED, NULL, "impossible contact history");
	TS_TRY(ts_archive_expect(archive, "history_keys", TS_SAVED_I32, 3 * (size_t)size[0]));
	TS_TRY(ts_archive_expect(archive, "history", TS_SAVED_F64, (size_t)size[0] * (size_t)size[1]));
	if (!ts_archive_writing(archive)) {
		ts_contact_history_release(h);
		h->width = (size_t)size[1];
		if (size[0])
			TS_TRY(allocate_history(sim, h, (size_t)size[0], true, torques));
		h->n = (size_t)size[0];
	}
	TS_TRY(ts_archive_fixed(archive, "history_keys", TS_SAVED_I32, h->key, 3 * h->n));
	TS_TRY(ts_archive_fixed(archive, "history", TS_SAVED_F64, h->value, h->n * h->width));
	if (torques && h->n) /* missing in older files, whose contacts have none until the first step */
		TS_TRY(ts_archive_fixed(archive, "contact_torques", TS_SAVED_F64, h->torque,
					TS_HISTORY_TORQUE * h->n));
	return ts_archive_fixed(archive, "forces", TS_SAVED_F64, h->force, 3 * h->n);
}
