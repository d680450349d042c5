/* A contact of two particles of one rank has one entry in its list; of particles of two ranks, or across a periodic
 * face, each particle has an entry. An entry is given to the rank of both particles of a contact if it is the only one,
 * or if it may become so: when a contact leaves a periodic face, that of the smaller identity is kept by both
 * (contact_history.c). */
#include "neigh/carried_history.h"

#include <string.h>

#include "neigh/neigh.h"
#include "particle/identity.h"

#include "base/banned.h"

/* The particle whose entry it is: i of the pair. */
static int32_t holder_of(const struct ts_contact_key *key)
{
	return key->tag[key->winding & TS_HISTORY_OTHER_SIDE ? 1 : 0];
}

static enum ts_status add_row(const struct ts_contact_history *h, size_t k, int32_t tag, bool results,
			      struct ts_carried *out)
{
	size_t size = h->width * sizeof *h->value;
	unsigned char *row = ts_carried_add(out, tag);

	if (!row)
		return TS_NOMEM;
	memcpy(row, &h->key[k], sizeof *h->key);
	row += sizeof *h->key;
	if (size)
		memcpy(row, h->value + k * h->width, size);
	if (results)
		memcpy(row + size, h->force[k], sizeof *h->force);
	if (results && h->torque)
		memcpy(row + size + sizeof *h->force, h->torque[k], sizeof *h->torque);
	return TS_OK;
}

/* The old list is not needed any more. */
static void forget_pairs(struct ts_contact_list *list)
{
	list->n = 0;
	list->active_chosen = list->memory_newer = list->locals_packed = false;
	list->results = TS_RESULTS_NONE;
}

static enum ts_status save_history(struct tsim *sim, struct ts_contact_list *list, bool results,
				   const struct ts_leaving *of, struct ts_contact_history *h)
{
	return sim->legacy == TS_LEGACY_LIGGGHTS ? ts_contact_history_save_all(sim, list, results, of, h)
						 : ts_contact_history_save(sim, list, results, of, h);
}

/* The rows of contact k. */
static enum ts_status add_rows(const struct ts_contact_history *h, size_t k, bool results,
			       const struct ts_leaving *leaving, struct ts_carried *out)
{
	const struct ts_contact_key *key = &h->key[k];
	const int32_t holder = holder_of(key), other = key->tag[1];
	/* with `results` all ranks get all rows: one is enough */
	bool both = !results && !(key->winding & TS_HISTORY_OTHER_SIDE);

	if (!leaving || ts_carried_leaves(leaving, holder))
		TS_TRY(add_row(h, k, holder, results, out));
	return both && (!leaving || ts_carried_leaves(leaving, other)) ? add_row(h, k, other, results, out)
								       : TS_OK;
}

static enum ts_status give(struct ts_instance *self, struct tsim *sim, bool results,
			   const struct ts_leaving *leaving, struct ts_carried *out)
{
	struct ts_neigh *nb = self->state;
	struct ts_contact_history h = { 0 };
	enum ts_status status = TS_OK;

	out->bytes = sizeof *h.key + nb->contacts.history_width * sizeof *h.value +
		     (results ? sizeof *h.force : 0) +
		     (results && nb->contacts.parts > 1 ? sizeof *h.torque : 0);
	if (!nb->wanted || (leaving && !leaving->n))
		return TS_OK;
	TS_TRY(save_history(sim, &nb->contacts, results, leaving, &h));
	for (size_t k = 0; k < h.n && status == TS_OK; k++)
		status = add_rows(&h, k, results, leaving, out);
	ts_contact_history_release(&h);
	if (!leaving)
		forget_pairs(&nb->contacts);
	return status == TS_OK ? TS_OK : ts_nomem(&sim->error);
}

static enum ts_status turn(struct ts_instance *self, struct tsim *sim, const struct ts_leaving *turning,
			   struct ts_carried *out)
{
	struct ts_neigh *nb = self->state;
	struct ts_contact_history h = { 0 };
	enum ts_status status = TS_OK;

	out->bytes = sizeof *h.key + nb->contacts.history_width * sizeof *h.value;
	if (!nb->wanted || !turning->n)
		return TS_OK;
	TS_TRY(save_history(sim, &nb->contacts, false, turning, &h));
	for (size_t k = 0; k < h.n; k++)
		for (int m = 0; m < 2 && status == TS_OK; m++)
			status = add_row(&h, k, h.key[k].tag[m], false, out);
	ts_contact_history_release(&h);
	return status == TS_OK ? TS_OK : ts_nomem(&sim->error);
}

/* Of an entry that was given to both particles the one of its holder is taken. */
static bool is_taken(const struct ts_identities *map, const struct ts_contact_key *key, int32_t tag)
{
	int32_t holder = holder_of(key);

	return tag == holder || ts_identity_row(map, holder) < 0;
}

static enum ts_status take(struct ts_instance *self, struct tsim *sim, const struct ts_carried *rows)
{
	struct ts_neigh *nb = self->state;
	struct ts_contact_history *h = &nb->saved;
	size_t n = ts_carried_count(rows), size = nb->contacts.history_width * sizeof *h->value;
	bool results = rows->bytes > sizeof *h->key + size,
	     torques = rows->bytes > sizeof *h->key + size + sizeof *h->force;
	struct ts_identities map;

	if (!nb->wanted)
		return TS_OK;
	TS_TRY(ts_identities(sim, false, &map));
	ts_contact_history_release(h);
	h->width = nb->contacts.history_width;
	h->key = ts_alloc(n, sizeof *h->key);
	h->value = ts_alloc(n * h->width, sizeof *h->value);
	h->force = results ? ts_alloc(n, sizeof *h->force) : NULL;
	h->torque = torques ? ts_alloc(n, sizeof *h->torque) : NULL;
	if (!h->key || !h->value || (results && !h->force) || (torques && !h->torque))
		return ts_nomem(&sim->error);
	for (size_t k = 0; k < n; k++) {
		int32_t tag;
		const unsigned char *row = ts_carried_row(rows, k, &tag);

		memcpy(&h->key[h->n], row, sizeof *h->key);
		if (!is_taken(&map, &h->key[h->n], tag))
			continue;
		row += sizeof *h->key;
		if (size)
			memcpy(h->value + h->n * h->width, row, size);
		if (results)
			memcpy(h->force[h->n], row + size, sizeof *h->force);
		if (torques)
			memcpy(h->torque[h->n], row + size + sizeof *h->force, sizeof *h->torque);
		h->n++;
	}
	return TS_OK;
}

const struct ts_carrier ts_carried_history = { .give = give, .take = take, .turn = turn };
