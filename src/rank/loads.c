#include "rank/loads.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/sort.h"

#include "base/banned.h"

static int64_t weight_of(const struct ts_rank_points *points, size_t i)
{
	return points->weight ? points->weight[i] : 1;
}

static void sum(const struct ts_rank_points *points, int64_t *number, size_t n)
{
	if (points->world)
		ts_world_sums(points->world, number, n);
}

enum ts_status ts_rank_load_find(const struct ts_rank_blocks *blocks, const struct ts_rank_points *points,
				 struct ts_rank_load *load)
{
	size_t ranks = (size_t)ts_rank_blocks_number(blocks);
	int64_t *of = ts_alloc(ranks, sizeof *of);

	*load = (struct ts_rank_load){ .imbalance = 1 };
	if (!of)
		return TS_NOMEM;
	for (size_t i = 0; i < points->n; i++)
		of[ts_rank_blocks_owner(blocks, points->x[i])] += weight_of(points, i);
	sum(points, of, ranks);
	for (size_t r = 0; r < ranks; r++) {
		load->total += of[r];
		load->most = of[r] > load->most ? of[r] : load->most;
	}
	if (load->total > 0)
		load->imbalance = (double)load->most / ((double)load->total / (double)ranks);
	ts_free(of);
	return TS_OK;
}

/* ---- cuts along one dimension */

/* One cut between lo and hi: `at` is tried next, `best` is that of the least error so far. */
struct search {
	double lo, hi, at, best;
	int64_t target, error;
	bool done;
};

/* Takes the load below the place tried; goes on in the middle of what is left. */
static void narrow(struct search *s, int64_t below)
{
	int64_t error = llabs(below - s->target);

	if (s->done)
		return;
	if (error < s->error) {
		s->error = error;
		s->best = s->at;
	}
	if (below < s->target)
		s->lo = s->at;
	else
		s->hi = s->at;
	s->at = s->lo + (s->hi - s->lo) / 2;
	s->done = !error || !(s->at > s->lo && s->at < s->hi);
}

static int compare_search(const void *a, const void *b)
{
	return ts_compare_double(&((const struct search *)a)->at, &((const struct search *)b)->at);
}

static int compare_best(const void *a, const void *b)
{
	return ts_compare_double(&((const struct search *)a)->best, &((const struct search *)b)->best);
}

/* load[k]: of the slab between the places k - 1 and k of n cuts, which are in ascending order. */
static void count_slabs(const struct ts_rank_points *points, int d, const struct search *s, int n,
			int64_t *load)
{
	memset(load, 0, ((size_t)n + 1) * sizeof *load);
	for (size_t i = 0; i < points->n; i++) {
		int lo = 0, hi = n; /* as many places as are not above the point */

		while (lo < hi) {
			int middle = lo + (hi - lo) / 2;

			if (points->x[i][d] >= s[middle].at)
				lo = middle + 1;
			else
				hi = middle;
		}
		load[lo] += weight_of(points, i);
	}
	sum(points, load, (size_t)n + 1);
}

/* Whether no slab has more than `stop` times the mean. */
static bool are_even(const int64_t *load, int slabs, double stop)
{
	int64_t total = 0, most = 0;

	for (int k = 0; k < slabs; k++) {
		total += load[k];
		most = load[k] > most ? load[k] : most;
	}
	return (double)most <= stop * (double)total / slabs;
}

static void search_cuts(const struct ts_rank_points *points, int d, struct search *s, int n, int64_t *load,
			int most, double stop, int *iterations)
{
	bool done = false;

	for (int k = 0; k < most && !done; k++) {
		int64_t below = 0;

		/* targets ascend, and so do the best places: cuts may be exchanged with their neighbours */
		ts_sort(s, (size_t)n, sizeof *s, compare_search);
		count_slabs(points, d, s, n, load);
		(*iterations)++;
		if (!k) {
			int64_t total = 0;

			for (int j = 0; j <= n; j++)
				total += load[j];
			for (int j = 0; j < n; j++)
				s[j].target = (int64_t)((double)total * (j + 1) /
							(n + 1)); /* of the present order */
		}
		done = true;
		if (are_even(load, n + 1, stop)) {
			for (int j = 0; j < n; j++)
				s[j].best = s[j].at;
			return;
		}
		for (int j = 0; j < n; j++) {
			below += load[j];
			narrow(&s[j], below);
			done &= s[j].done;
		}
	}
}

/* All parts of the grid get these cuts along d. */
static void set_faces(struct ts_rank_blocks *blocks, int d, const struct search *s)
{
	int k[3] = { 0 };

	for (k[1] = 0; k[1] < (d > 1 ? blocks->count[1] : 1); k[1]++)
		for (k[0] = 0; k[0] < (d > 0 ? blocks->count[0] : 1); k[0]++) {
			double *face = ts_rank_blocks_faces(blocks, d, k);

			for (int j = 0; j < blocks->count[d] - 1; j++)
				face[j + 1] = s[j].best;
		}
}

enum ts_status ts_rank_loads_shift(struct ts_rank_blocks *blocks, const struct ts_rank_points *points, int d,
				   int most, double stop, int *iterations)
{
	static const int first[3] = { 0 };
	int n = blocks->count[d] - 1;
	struct search *s = ts_alloc((size_t)n, sizeof *s);
	int64_t *load = ts_alloc((size_t)n + 1, sizeof *load);
	const double *face = ts_rank_blocks_faces(blocks, d, first);

	if (s && load && n) {
		for (int j = 0; j < n; j++)
			s[j] = (struct search){ .lo = blocks->lo[d],
						.hi = blocks->lo[d] + blocks->length[d],
						.at = face[j + 1],
						.best = face[j + 1],
						.error = INT64_MAX };
		search_cuts(points, d, s, n, load, most, stop, iterations);
		ts_sort(s, (size_t)n, sizeof *s, compare_best);
		set_faces(blocks, d, s);
	}
	ts_free(load);
	ts_free(s);
	return s && load ? TS_OK : TS_NOMEM;
}

/* ---- recursive bisection */

/* A part of the box, with the ranks first .. first + n - 1, that is to be cut. */
struct part {
	int first, n, dim;
	double lo[3], hi[3]; /* extents of its points */
	int64_t below;	     /* load below the place tried; all at first */
	struct search cut;
};

struct bisection {
	struct ts_rank_blocks *blocks;
	const struct ts_rank_points *points;
	int32_t *of; /* by point: its part */
	struct part *part, *next;
	size_t n;
	int64_t *sums;
	double *most;
};

static void find_extents(struct bisection *b)
{
	for (size_t k = 0; k < 6 * b->n; k++)
		b->most[k] = -INFINITY;
	for (size_t i = 0; i < b->points->n; i++)
		for (int d = 0; d < 3 && b->of[i] >= 0; d++) {
			double *most = b->most + 6 * b->of[i];

			most[d] = fmax(most[d], b->points->x[i][d]);
			most[3 + d] = fmax(most[3 + d], -b->points->x[i][d]);
		}
	if (b->points->world)
		ts_world_most(b->points->world, b->most, 6 * b->n);
	for (size_t k = 0; k < b->n; k++)
		for (int d = 0; d < 3; d++) {
			b->part[k].hi[d] = b->most[6 * k + (size_t)d];
			b->part[k].lo[d] = -b->most[6 * k + 3 + (size_t)d];
		}
}

/* Without points: in the middle of its space. */
static void set_extents_of_space(const struct ts_rank_blocks *blocks, struct part *part)
{
	for (int d = 0; d < 3; d++) {
		const struct ts_rank_side below = ts_rank_blocks_side(blocks, part->first, d);
		const struct ts_rank_side above = ts_rank_blocks_side(blocks, part->first + part->n - 1, d);

		part->lo[d] = below.face[0];
		part->hi[d] = above.face[1];
	}
}

static void begin_search(const struct ts_rank_blocks *blocks, struct part *part)
{
	bool empty = !(part->lo[0] <= part->hi[0]);
	double at;

	if (empty)
		set_extents_of_space(blocks, part);
	for (int d = 1; d < 3; d++)
		if (part->hi[d] - part->lo[d] > part->hi[part->dim] - part->lo[part->dim])
			part->dim = d;
	at = part->lo[part->dim] + (part->hi[part->dim] - part->lo[part->dim]) / 2;
	part->cut = (struct search){ .lo = part->lo[part->dim],
				     .hi = part->hi[part->dim],
				     .at = at,
				     .best = at,
				     .error = INT64_MAX,
				     .done = empty };
}

/* The load of each part; with `tried` that below the places tried. */
static void count_below(struct bisection *b, bool tried)
{
	memset(b->sums, 0, b->n * sizeof *b->sums);
	for (size_t i = 0; i < b->points->n; i++) {
		const struct part *part = b->of[i] >= 0 ? &b->part[b->of[i]] : NULL;

		if (part && (!tried || b->points->x[i][part->dim] < part->cut.at))
			b->sums[b->of[i]] += weight_of(b->points, i);
	}
	sum(b->points, b->sums, b->n);
	for (size_t k = 0; k < b->n; k++)
		b->part[k].below = b->sums[k];
}

/* Cuts each part where its lower ranks get their share of the load. */
static void cut_parts(struct bisection *b)
{
	bool done = false;

	find_extents(b);
	count_below(b, false);
	for (size_t k = 0; k < b->n; k++) {
		struct part *part = &b->part[k];

		begin_search(b->blocks, part);
		part->cut.target = (int64_t)((double)part->below * (part->n / 2) / part->n);
	}
	while (!done) {
		done = true;
		count_below(b, true);
		for (size_t k = 0; k < b->n; k++) {
			narrow(&b->part[k].cut, b->part[k].below);
			done &= b->part[k].cut.done;
		}
	}
	for (size_t k = 0; k < b->n; k++)
		b->blocks->bisection[b->part[k].first + b->part[k].n / 2 - 1] =
			(struct ts_rank_cut){ b->part[k].dim, b->part[k].cut.best };
}

/* The halves of the parts that have several ranks are the next parts; points of others are done. */
static void go_to_halves(struct bisection *b)
{
	struct part *old = b->part;
	size_t n = 0;

	for (size_t k = 0; k < b->n; k++)
		for (int upper = 0; upper < 2; upper++) {
			int below = old[k].n / 2, ranks = upper ? old[k].n - below : below;

			b->sums[2 * k + (size_t)upper] = ranks > 1 ? (int64_t)n : -1;
			if (ranks > 1)
				b->next[n++] = (struct part){ .first = old[k].first + (upper ? below : 0),
							      .n = ranks };
		}
	for (size_t i = 0; i < b->points->n; i++) {
		int32_t of = b->of[i];

		if (of >= 0)
			b->of[i] =
				(int32_t)b->sums[2 * of + (b->points->x[i][old[of].dim] >= old[of].cut.best)];
	}
	b->part = b->next;
	b->next = old;
	b->n = n;
}

enum ts_status ts_rank_loads_bisect(struct ts_rank_blocks *blocks, const struct ts_rank_points *points)
{
	size_t ranks = (size_t)ts_rank_blocks_number(blocks);
	struct bisection b = { .blocks = blocks,
			       .points = points,
			       .of = ts_alloc(points->n, sizeof *b.of),
			       .part = ts_alloc(ranks, sizeof *b.part),
			       .next = ts_alloc(ranks, sizeof *b.next),
			       .sums = ts_alloc(2 * ranks, sizeof *b.sums),
			       .most = ts_alloc(6 * ranks, sizeof *b.most) };
	enum ts_status status = b.of && b.part && b.next && b.sums && b.most ? TS_OK : TS_NOMEM;

	if (status == TS_OK && ranks > 1)
		b.part[b.n++] = (struct part){ .n = (int)ranks };
	while (status == TS_OK && b.n) {
		cut_parts(&b);
		go_to_halves(&b);
	}
	ts_free(b.of);
	ts_free(b.part);
	ts_free(b.next);
	ts_free(b.sums);
	ts_free(b.most);
	return status;
}
