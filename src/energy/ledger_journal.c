/* Journal: entries of exact sums, which are posted to the accounts in the order in which they were made.
 *
 * One rank posts each entry at once. While the particles are divided, entries wait until the end of the step; then all ranks
 * add their sums, as integers, in one operation. So accounts have the same bits on any number of ranks. */
#include <string.h>

#include "energy/ledger.h"
#include "particle/particles.h"

#include "base/banned.h"

static enum ts_status post_now(struct tsim *sim, struct ts_ledger *l, const struct ts_ledger_entry *entry,
			       const struct ts_exactsum *sum)
{
	struct ts_ledger_journal *j = &l->journal;

	if (TS_GROW(j->value, j->value_capacity, entry->n) != TS_OK)
		return ts_nomem(&sim->error);
	for (size_t k = 0; k < entry->n; k++)
		j->value[k] = ts_exactsum_value(&sum[k]);
	return entry->post(sim, l, entry, j->value);
}

enum ts_status ts_ledger_enter(struct tsim *sim, struct ts_ledger *l, const struct ts_ledger_entry *entry,
			       const struct ts_exactsum *sum)
{
	struct ts_ledger_journal *j = &l->journal;

	if (!sim->division)
		return post_now(sim, l, entry, sum);
	if (TS_GROW(j->entry, j->capacity, j->n + 1) != TS_OK ||
	    TS_GROW(j->sum, j->sum_capacity, j->sums + entry->n) != TS_OK)
		return ts_nomem(&sim->error);
	j->entry[j->n++] = *entry;
	if (entry->n)
		memcpy(j->sum + j->sums, sum, entry->n * sizeof *sum);
	j->sums += entry->n;
	return TS_OK;
}

enum ts_status ts_ledger_post_account(struct tsim *sim, struct ts_ledger *l,
				      const struct ts_ledger_entry *entry, const double *value)
{
	(void)sim;
	ts_compensated_add((struct ts_compensated_sum *)(void *)((char *)l + entry->at), value[0]);
	return TS_OK;
}

/* ---- the sums of all ranks */

/* What ranks agree on: the last and, negative, the first integer of a sum that is not 0, kinds of contacts, and whether each of
 * the entries that may be made is made. */
enum { LAST, FIRST, PLASTIC, MAYBE = PLASTIC + TS_LEDGER_SIDES };

struct posting {
	struct tsim *sim;
	struct ts_ledger *l;
	int64_t (*integer)[TS_EXACTSUM_INTEGERS]; /* of all sums */
	int64_t *sent; /* of those of entries that are made, from `first` to `last` */
	double *agreed;
	size_t first, last, nsent;
};

static void find_range(struct posting *t)
{
	const struct ts_ledger_journal *j = &t->l->journal;
	double last = -1, first = TS_EXACTSUM_INTEGERS;

	for (size_t s = 0; s < j->sums; s++) {
		ts_exactsum_pack(&j->sum[s], t->integer[s]);
		for (int k = 0; k < TS_EXACTSUM_INTEGERS; k++)
			if (t->integer[s][k]) {
				first = k < first ? k : first;
				last = k > last ? k : last;
			}
	}
	t->agreed[LAST] = last;
	t->agreed[FIRST] = -first;
}

static void agree(struct posting *t)
{
	struct ts_ledger *l = t->l;
	const struct ts_ledger_journal *j = &l->journal;
	size_t n = MAYBE;

	find_range(t);
	for (int side = 0; side < TS_LEDGER_SIDES; side++)
		t->agreed[PLASTIC + side] = (double)l->plastic[side];
	for (size_t k = 0; k < j->n; k++)
		if (j->entry[k].maybe)
			t->agreed[n++] = j->entry[k].counts;
	ts_world_most(t->sim->world, t->agreed, n);
	for (int side = 0; side < TS_LEDGER_SIDES; side++)
		l->plastic[side] = t->agreed[PLASTIC + side] > 0;
	n = MAYBE;
	for (size_t k = 0; k < j->n; k++)
		if (j->entry[k].maybe)
			j->entry[k].counts = t->agreed[n++] > 0;
	t->last = (size_t)(t->agreed[LAST] + 1);
	t->first = (size_t)-t->agreed[FIRST];
}

static bool is_made(const struct ts_ledger_entry *entry)
{
	return !entry->maybe || entry->counts;
}

/* Copies the integers that are sent, or those that have come. */
static void copy_integers(struct posting *t, bool back)
{
	const struct ts_ledger_journal *j = &t->l->journal;
	size_t s = 0, bytes = t->first < t->last ? (t->last - t->first) * sizeof *t->sent : 0;

	t->nsent = 0;
	for (size_t k = 0; k < j->n; k++) {
		for (size_t e = 0; e < j->entry[k].n && is_made(&j->entry[k]) && bytes; e++) {
			int64_t *own = &t->integer[s + e][t->first], *sent = &t->sent[t->nsent];

			memcpy(back ? own : sent, back ? sent : own, bytes);
			t->nsent += t->last - t->first;
		}
		s += j->entry[k].n;
	}
}

static enum ts_status post_entries(struct posting *t)
{
	struct ts_ledger_journal *j = &t->l->journal;
	size_t s = 0;

	for (size_t k = 0; k < j->n; k++) {
		const struct ts_ledger_entry entry = j->entry[k];

		for (size_t e = 0; e < entry.n && is_made(&entry); e++) {
			struct ts_exactsum sum = ts_exactsum_unpack(t->integer[s + e]);

			j->value[e] = ts_exactsum_value(&sum);
		}
		if (is_made(&entry))
			TS_TRY(entry.post(t->sim, t->l, &entry, j->value));
		s += entry.n;
	}
	return TS_OK;
}

enum ts_status ts_ledger_post(struct tsim *sim, struct ts_ledger *l)
{
	struct ts_ledger_journal *j = &l->journal;
	struct posting t = { .sim = sim, .l = l };
	enum ts_status status = TS_NOMEM;

	if (!sim->division || !j->n)
		return TS_OK;
	t.integer = ts_alloc(j->sums, sizeof *t.integer);
	t.sent = ts_alloc(j->sums * TS_EXACTSUM_INTEGERS, sizeof *t.sent);
	t.agreed = ts_alloc(MAYBE + j->n, sizeof *t.agreed);
	if (t.integer && t.sent && t.agreed && TS_GROW(j->value, j->value_capacity, j->sums) == TS_OK) {
		agree(&t);
		copy_integers(&t, false);
		ts_world_sums(sim->world, t.sent, t.nsent);
		copy_integers(&t, true);
		status = post_entries(&t);
	}
	ts_free(t.integer);
	ts_free(t.sent);
	ts_free(t.agreed);
	j->n = j->sums = l->missing.n = 0;
	return status == TS_NOMEM ? ts_nomem(&sim->error) : status;
}
