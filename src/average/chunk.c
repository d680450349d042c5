#include "average/chunk.h"

#include <math.h>
#include <stdlib.h>

#include "average/chunk_bins.h"
#include "base/sort.h"
#include "math/exactsum.h"
#include "particle/columns.h"
#include "particle/particles.h"
#include "region/region.h"

#include "base/banned.h"

/* [particle] 1 + chunk number that `ids once` or `ids nfreq` has assigned; 0: not yet assigned. */
static double *assigned_column(const struct ts_chunks *c)
{
	return c->sim->particles->column[c->column].data;
}

/* Chunk number of each particle from its current position, type or value, and the number of chunks, without
 * `ids`, `compress` and `limit`. */
static enum ts_status find_chunk_ids(const struct ts_instance *self, struct ts_chunks *c, int64_t *id)
{
	const struct ts_particles *p = c->sim->particles;
	int64_t most = 0;

	TS_TRY(ts_region_update(c->region, c->sim));
	if (c->style == TS_CHUNK_VALUE)
		TS_TRY(ts_ref_input_eval(c->sim, &c->value, &c->values));
	else if (c->style == TS_CHUNK_TYPE)
		c->n = (size_t)p->ntypes;
	else
		TS_TRY(ts_chunk_bins_place(self, c));
	for (size_t i = 0; i < p->n; i++) {
		double value;

		id[i] = 0;
		if (!ts_in_group(p, i, self->group) || (c->region && !ts_region_contains(c->region, p->x[i])))
			continue;
		value = c->style == TS_CHUNK_VALUE ? c->values.data[i] : p->type[i];
		if (c->style != TS_CHUNK_VALUE && c->style != TS_CHUNK_TYPE)
			id[i] = ts_chunk_bin_of(c, p->x[i]);
		else if (value >= 1 && value < 1e15)
			id[i] = (int64_t)value;
		most = id[i] > most ? id[i] : most;
	}
	if (c->style != TS_CHUNK_VALUE)
		return TS_OK;
	c->n = c->once && ts_chunks_held(c) ? (size_t)c->once_n[0] : (size_t)most;
	c->once_n[0] = (int64_t)c->n;
	c->once = ts_chunks_held(c);
	return TS_OK;
}

/* Particles that `ids once` or `ids nfreq` has assigned to a chunk stay in it; others are assigned now. */
static void keep_assigned_ids(struct ts_chunks *c, enum ts_chunk_moment moment, int64_t *id)
{
	bool once = c->ids == TS_CHUNK_IDS_ONCE;
	double *column = assigned_column(c);

	if (!once && moment == TS_CHUNK_NO_SAMPLE)
		return;
	for (size_t i = 0; i < c->sim->particles->n; i++) {
		if ((once || moment == TS_CHUNK_NEXT_SAMPLE) && column[i] > 0)
			id[i] = (int64_t)column[i] - 1;
		else
			column[i] = 1 + (double)id[i];
	}
}

/* `compress yes`: renumbers the chunks that have particles 1, 2 ... in the order of their numbers. */
static enum ts_status compress_ids(struct ts_chunks *c, int64_t *id)
{
	size_t n = c->sim->particles->n, kinds = 0;

	TS_TRY(TS_GROW(c->original, c->original_capacity, n + 1));
	for (size_t i = 0; i < n; i++)
		c->original[i] = id[i];
	ts_sort(c->original, n, sizeof *c->original, ts_compare_int64);
	for (size_t i = 0; i < n; i++)
		if (c->original[i] > 0 && (kinds == 0 || c->original[i] != c->original[kinds - 1]))
			c->original[kinds++] = c->original[i];
	c->n = kinds;
	for (size_t i = 0; i < n && kinds; i++) {
		const int64_t *found =
			bsearch(&id[i], c->original, kinds, sizeof *c->original, ts_compare_int64);

		id[i] = found ? found - c->original + 1 : 0;
	}
	return TS_OK;
}

/* Particles of chunks beyond `limit` are in no chunk, or with `discard no` in the last one. */
static void limit_chunks(struct ts_chunks *c, int64_t *id)
{
	bool clamp = c->discard == TS_DISCARD_NO;

	if (!c->limit)
		return;
	if (c->exact || (int64_t)c->n > c->limit)
		c->n = (size_t)c->limit;
	for (size_t i = 0; i < c->sim->particles->n; i++)
		if (id[i] > c->limit)
			id[i] = clamp ? c->limit : 0;
}

/* `limit N exact` may add chunks without particles: they keep their own number as the original one. */
static enum ts_status pad_originals(struct ts_chunks *c, size_t kinds)
{
	if (!c->compress || c->n <= kinds)
		return TS_OK;
	TS_TRY(TS_GROW(c->original, c->original_capacity, c->n));
	for (size_t k = kinds; k < c->n; k++)
		c->original[k] = (int64_t)k + 1;
	return TS_OK;
}

/* Lists the particles of each chunk sorted by id: a counting sort over particles sorted by id, so that sums
 * do not depend on the order in memory. */
static enum ts_status list_members(struct ts_chunks *c, const int64_t *id)
{
	const struct ts_particles *p = c->sim->particles;
	uint64_t *key = ts_alloc_unset(2 * p->n, sizeof *key);

	if (!key)
		return TS_NOMEM;
	for (size_t k = 0; k < c->n + 3; k++)
		c->first[k] = 0;
	for (size_t i = 0; i < p->n; i++) {
		key[i] = (uint64_t)p->tag[i] << 32 | i;
		c->id[i] = id[i] > (int64_t)c->n ? 0 : (int32_t)id[i];
		c->first[c->id[i] + 2] += c->id[i] > 0;
	}
	ts_sort_keys(key, key + p->n, p->n);
	for (size_t k = 2; k < c->n + 3; k++)
		c->first[k] += c->first[k - 1];
	/* first[k + 1] is the start of chunk k, and moves to its end as members are entered */
	for (size_t at = 0; at < p->n; at++) {
		size_t i = (size_t)(key[at] & UINT32_MAX);

		if (c->id[i] > 0)
			c->member[c->first[c->id[i] + 1]++] = (int32_t)i;
	}
	ts_free(key);
	return TS_OK;
}

static enum ts_status assign_and_list(const struct ts_instance *self, struct ts_chunks *c,
				      enum ts_chunk_moment moment, int64_t *id)
{
	size_t kinds;

	TS_TRY(find_chunk_ids(self, c, id));
	if (c->ids != TS_CHUNK_IDS_EVERY)
		keep_assigned_ids(c, moment, id);
	if (c->compress)
		TS_TRY(compress_ids(c, id));
	kinds = c->n;
	limit_chunks(c, id);
	TS_TRY(pad_originals(c, kinds));
	if (c->n > 1000000000)
		return ts_fail(&c->sim->error, TS_RANGE, &self->where,
			       "%s %s: %zu chunks are too many; use compress yes",
			       ts_kind_name(self->style->kind), self->style->name, c->n);
	TS_TRY(TS_GROW(c->id, c->id_capacity, c->sim->particles->n));
	TS_TRY(TS_GROW(c->member, c->member_capacity, c->sim->particles->n));
	TS_TRY(TS_GROW(c->first, c->first_capacity, c->n + 3));
	return list_members(c, id);
}

enum ts_status ts_chunks_assign(struct ts_instance *self, struct ts_chunks *c, enum ts_chunk_moment moment)
{
	int64_t *id = ts_alloc(c->sim->particles->n, sizeof *id);
	enum ts_status status = id ? assign_and_list(self, c, moment, id) : TS_NOMEM;

	ts_free(id);
	return status == TS_NOMEM ? ts_nomem(&c->sim->error) : status;
}

enum ts_status ts_chunks_archive(struct ts_archive *archive, struct tsim *sim, struct ts_chunks *c)
{
	return c->has_column ? ts_particles_archive_column(archive, sim, "chunk", c->column) : TS_OK;
}

void ts_chunks_release(struct ts_chunks *c)
{
	ts_free(c->id);
	ts_free(c->original);
	ts_free(c->first);
	ts_free(c->member);
	ts_table_release(&c->values);
}

enum ts_status ts_chunks_find(struct tsim *sim, const struct ts_instance *user, const char *id,
			      struct ts_instance **owner, struct ts_chunks **chunks)
{
	struct ts_word word = { .text = id, .place = user->where };

	TS_TRY(ts_sim_require(sim, TS_KIND_COMPUTE, &word, owner));
	if (!ts_streq((*owner)->style->name, "chunk/atom"))
		return ts_fail(&sim->error, TS_STATE, &user->where,
			       "%s %s: compute %s is of style %s, expected chunk/atom",
			       ts_kind_name(user->style->kind), user->style->name, id, (*owner)->style->name);
	*chunks = (*owner)->state;
	return TS_OK;
}

enum ts_status ts_chunk_sum(const struct ts_chunks *c, int group, size_t width, ts_chunk_term *term,
			    const void *context, struct ts_table *out)
{
	const struct ts_particles *p = c->sim->particles;
	struct ts_exactsum *sum = ts_alloc(width, sizeof *sum);
	double *t = ts_alloc(width, sizeof *t);
	enum ts_status status = sum && t ? ts_table_resize(out, c->n, width) : TS_NOMEM;

	for (size_t chunk = 1; status == TS_OK && chunk <= c->n; chunk++) {
		for (size_t k = 0; k < width; k++)
			sum[k] = ts_exactsum_start();
		for (size_t m = c->first[chunk]; m < c->first[chunk + 1]; m++) {
			size_t i = (size_t)c->member[m];

			if (!ts_in_group(p, i, group))
				continue;
			term(c->sim, i, chunk, context, t);
			ts_exactsum_add_each(sum, width, t);
		}
		for (size_t k = 0; k < width; k++)
			out->data[(chunk - 1) * width + k] = ts_exactsum_value(&sum[k]);
	}
	ts_free(sum);
	ts_free(t);
	return status;
}
