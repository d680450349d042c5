#include "neigh/gather.h"

#include "base/parallel.h"
#include "base/sort.h"
#include "particle/particles.h"

#include "base/banned.h"

/* A share is a range of particles: each thread reads all pairs and lists those of its own particles. */
struct gather_task {
	const struct ts_gather_pairs *pairs;
	size_t *first;
	uint32_t *entry;
	size_t longest; /* length of the longest list */
};

static inline size_t end_particle(const struct ts_gather_pairs *p, size_t r, int side)
{
	return (size_t)p->end[side][r * p->stride];
}

static void count_entries_share(void *context, size_t from, size_t to)
{
	const struct gather_task *t = context;
	const struct ts_gather_pairs *p = t->pairs;

	for (size_t r = 0; r < p->n; r++)
		for (int side = 0; side < 2; side++)
			if (end_particle(p, r, side) - from < to - from)
				t->first[end_particle(p, r, side) + 2]++;
}

static void list_entries_share(void *context, size_t from, size_t to)
{
	const struct gather_task *t = context;
	const struct ts_gather_pairs *p = t->pairs;

	for (size_t r = 0; r < p->n; r++)
		for (int side = 0; side < 2; side++)
			if (end_particle(p, r, side) - from < to - from)
				t->entry[t->first[end_particle(p, r, side) + 1]++] =
					(uint32_t)(2 * r + (size_t)side);
}

static inline uint64_t tag_of_partner(const struct ts_gather_pairs *p, uint32_t entry)
{
	size_t r = (entry >> 1) * p->stride;
	int side = !(entry & 1);

	return (uint64_t)(p->tag_of ? p->tag_of[p->end[side][r]] : p->tag[side][r]);
}

static void sort_entries(const struct ts_gather_pairs *p, uint32_t *entry, size_t n, uint64_t *key,
			 uint64_t *spare)
{
	for (size_t k = 0; k < n; k++)
		key[k] = tag_of_partner(p, entry[k]) << 32 | entry[k];
	ts_sort_keys(key, spare, n);
	for (size_t k = 0; k < n; k++)
		entry[k] = (uint32_t)key[k];
}

/* Sorts the entries of each particle by the identities of its partners. Returns 1 if out of memory. */
static long sort_entries_share(void *context, size_t from, size_t to)
{
	const struct gather_task *t = context;
	uint64_t *key = ts_alloc(2 * t->longest, sizeof *key);

	for (size_t i = from; key && i < to; i++)
		sort_entries(t->pairs, t->entry + t->first[i], t->first[i + 1] - t->first[i], key,
			     key + t->longest);
	ts_free(key);
	return key == NULL;
}

/* Turns counts into offsets; returns the largest count. */
static size_t counts_to_offsets(size_t *first, size_t n)
{
	size_t longest = 0;

	for (size_t i = 2; i < n + 2; i++) {
		longest = first[i] > longest ? first[i] : longest;
		first[i] += first[i - 1];
	}
	return longest;
}

enum ts_status ts_gather_index(const struct tsim *sim, struct ts_gather *g,
			       const struct ts_gather_pairs *pairs)
{
	size_t n = sim->particles->n;
	int threads = ts_team(sim, 4 * pairs->n);
	struct gather_task t = { .pairs = pairs };

	TS_TRY(TS_RENEW(g->first, g->first_capacity, n + 2));
	TS_TRY(TS_RENEW_UNSET(g->entry, g->entry_capacity, 2 * pairs->n));
	t.first = g->first;
	t.entry = g->entry;
	for (size_t i = 0; i < n + 2; i++)
		g->first[i] = 0;
	if (!pairs->n)
		return TS_OK;
	ts_parallel(threads, n, count_entries_share, &t);
	t.longest = counts_to_offsets(g->first, n);
	ts_parallel(threads, n, list_entries_share, &t);
	return ts_parallel_count(threads, n, sort_entries_share, &t) ? TS_NOMEM : TS_OK;
}

void ts_gather_release(struct ts_gather *gather)
{
	ts_free(gather->first);
	ts_free(gather->entry);
	*gather = (struct ts_gather){ 0 };
}
