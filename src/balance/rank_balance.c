#include "balance/rank_balance.h"

#include <inttypes.h>
#include <math.h>
#include <string.h>

#include "box/domain.h"
#include "core/ranks.h"
#include "io/textfile.h"
#include "particle/division.h"
#include "particle/particles.h"
#include "rank/loads.h"

#include "base/banned.h"

/* ---- words */

static enum ts_status fail_at(struct tsim *sim, const struct ts_rank_balance *b, const struct ts_word *word,
			      const char *expected)
{
	return ts_fail(&sim->error, TS_SYNTAX, &word->place, "%s: found '%s', expected %s", b->what,
		       word->text, expected);
}

/* uniform, or numbers between 0 and 1 in ascending order. */
static enum ts_status read_cuts(struct ts_rank_balance *b, struct tsim *sim, int d)
{
	double last = 0, x;

	b->given[d] = b->cuts[d].n > 0;
	b->uniform[d] = b->cuts[d].n == 1 && ts_streq(b->cuts[d].word[0].text, "uniform");
	for (size_t k = 0; !b->uniform[d] && k < b->cuts[d].n; k++) {
		const struct ts_word *word = &b->cuts[d].word[k];

		if (!ts_parse_real(word->text, &x) || !(x > last && x < 1))
			return fail_at(sim, b, word,
				       "uniform, or numbers between 0 and 1 in ascending order");
		last = x;
	}
	if (b->given[d] && d == 2 && sim->dimension == 2)
		return fail_at(sim, b, &b->cuts[d].word[0],
			       "x or y: in two dimensions the box is not cut along z");
	return TS_OK;
}

static enum ts_status read_dimensions(struct ts_rank_balance *b, struct tsim *sim, const struct ts_word *word)
{
	bool seen[3] = { 0 };

	for (const char *c = word->text; *c; c++) {
		int d = *c - 'x';

		if (d < 0 || d >= sim->dimension || seen[d])
			return fail_at(sim, b, word,
				       sim->dimension == 2 ? "letters x and y, each at most once"
							   : "letters x, y and z, each at most once");
		seen[d] = true;
		b->order[b->dimensions++] = d;
	}
	return TS_OK;
}

static enum ts_status read_shift(struct ts_rank_balance *b, struct tsim *sim, const struct ts_place *where)
{
	const struct ts_word *word = b->shift.word;

	if (b->shift.n != 3)
		return ts_fail(&sim->error, TS_SYNTAX, where,
			       "%s: shift is followed by the dimensions, the number of bisections, and the "
			       "imbalance at which to stop",
			       b->what);
	TS_TRY(read_dimensions(b, sim, &word[0]));
	if (!ts_parse_int(word[1].text, &b->bisections) || b->bisections < 1 || b->bisections > INT32_MAX)
		return fail_at(sim, b, &word[1], "a number of bisections > 0");
	if (!ts_parse_real(word[2].text, &b->enough) || !(b->enough >= 1))
		return fail_at(sim, b, &word[2], "an imbalance >= 1");
	return TS_OK;
}

enum ts_status ts_balance_read(struct ts_rank_balance *b, struct tsim *sim, const struct ts_place *where)
{
	bool cuts = false;

	for (int d = 0; d < 3; d++) {
		TS_TRY(read_cuts(b, sim, d));
		cuts |= b->given[d];
	}
	if (cuts + (b->shift.n > 0) + b->rcb != 1)
		return ts_fail(&sim->error, TS_SYNTAX, where,
			       "%s: expected one way of balancing: %sshift or rcb", b->what,
			       ts_streq(b->what, "balance") ? "x, y or z (or several of these), " : "");
	if (b->shift.n)
		TS_TRY(read_shift(b, sim, where));
	return ts_weights_parse(&b->weights, sim, b->what, b->weight);
}

void ts_balance_release(struct ts_rank_balance *b)
{
	ts_weights_release(&b->weights);
	ts_rank_blocks_release(&b->alone);
}

/* ---- blocks */

enum ts_status ts_balance_blocks(struct ts_rank_balance *b, struct tsim *sim, struct ts_rank_blocks **blocks)
{
	static const int one[3] = { 1, 1, 1 };
	static const bool closed[3] = { false, false, false };
	const struct ts_box *box = &sim->domain->box;

	if (ts_ranks(sim) > 1)
		return ts_division_blocks(sim, blocks);
	*blocks = &b->alone;
	return ts_rank_blocks_cut(&b->alone, one, box->lo, box->hi, closed) ? TS_OK : ts_nomem(&sim->error);
}

/* All parts of the grid get the given cuts along d. */
static enum ts_status set_cuts(const struct ts_rank_balance *b, struct tsim *sim,
			       struct ts_rank_blocks *blocks, int d)
{
	int n = blocks->count[d], k[3] = { 0 };

	if (ts_ranks(sim) == 1)
		return TS_OK;
	if (!b->uniform[d] && b->cuts[d].n != (size_t)n - 1)
		return ts_fail(&sim->error, TS_RANGE, &b->cuts[d].word[0].place,
			       "%s: expected uniform or %d numbers, since there are %d blocks along %c "
			       "(`processors` sets how many); found %zu",
			       b->what, n - 1, n, 'x' + d, b->cuts[d].n);
	for (k[1] = 0; k[1] < (d > 1 ? blocks->count[1] : 1); k[1]++)
		for (k[0] = 0; k[0] < (d > 0 ? blocks->count[0] : 1); k[0]++)
			for (int j = 1; j < n; j++) {
				double at = (double)j / n;

				if (!b->uniform[d])
					(void)ts_parse_real(b->cuts[d].word[j - 1].text, &at);
				ts_rank_blocks_faces(blocks, d, k)[j] =
					blocks->lo[d] + at * blocks->length[d];
			}
	return TS_OK;
}

static enum ts_status shift_cuts(const struct ts_rank_balance *b, struct tsim *sim,
				 struct ts_rank_blocks *blocks, const struct ts_rank_points *points,
				 int *iterations)
{
	struct ts_rank_load load;

	for (int k = 0; k < b->dimensions; k++) {
		if (ts_rank_loads_shift(blocks, points, b->order[k], (int)b->bisections, b->enough,
					iterations) != TS_OK ||
		    ts_rank_load_find(blocks, points, &load) != TS_OK)
			return ts_nomem(&sim->error);
		if (load.imbalance <= b->enough)
			break;
	}
	return TS_OK;
}

static enum ts_status bisect(struct tsim *sim, struct ts_rank_blocks *blocks,
			     const struct ts_rank_points *points, int *iterations)
{
	const struct ts_box *box = &sim->domain->box;
	bool periodic[3];

	for (int d = 0; d < 3; d++)
		periodic[d] = ts_box_periodic(box, d);
	*iterations = 1;
	if (ts_ranks(sim) == 1)
		return TS_OK;
	if (!ts_rank_blocks_bisect(blocks, ts_rank_blocks_number(blocks), box->lo, box->hi, periodic) ||
	    ts_rank_loads_bisect(blocks, points) != TS_OK)
		return ts_nomem(&sim->error);
	return TS_OK;
}

/* Whether there are cuts that the words can move. */
static bool can_change(const struct ts_rank_balance *b, const struct ts_rank_blocks *blocks)
{
	bool can = b->rcb || blocks->bisection;

	for (int d = 0; d < 3; d++)
		can |= b->given[d] && blocks->count[d] > 1;
	for (int k = 0; k < b->dimensions; k++)
		can |= blocks->count[b->order[k]] > 1;
	return can;
}

static enum ts_status change_blocks(const struct ts_rank_balance *b, struct tsim *sim,
				    struct ts_rank_blocks *blocks, const struct ts_rank_points *points,
				    int *iterations)
{
	if (b->rcb)
		return bisect(sim, blocks, points, iterations);
	if (blocks->bisection)
		TS_TRY(ts_division_cut_equal(sim, blocks));
	for (int d = 0; d < 3; d++)
		if (b->given[d])
			TS_TRY(set_cuts(b, sim, blocks, d));
	return shift_cuts(b, sim, blocks, points, iterations);
}

/* ---- loads */

/* Integers in proportion to the weights; *unit: the weight of 1. */
static void round_weights(struct tsim *sim, const double *weight, int64_t *rounded, double *unit)
{
	const double largest = (double)(1 << 30);
	double most = 0;

	for (size_t i = 0; i < sim->particles->n; i++)
		most = fmax(most, weight[i]);
	*unit = ts_ranks_most(sim, most) / largest;
	for (size_t i = 0; i < sim->particles->n; i++)
		rounded[i] = (int64_t)fmax(1, nearbyint(weight[i] / *unit));
}

static enum ts_status weigh(struct ts_rank_balance *b, struct tsim *sim, const struct ts_rank_blocks *blocks,
			    struct ts_rank_points *points, double *unit)
{
	double *weight = ts_alloc(points->n, sizeof *weight);
	int64_t *rounded = ts_alloc(points->n, sizeof *rounded);
	enum ts_status status = weight && rounded ? TS_OK : ts_nomem(&sim->error);

	if (status == TS_OK)
		status = ts_weights_find(&b->weights, sim, blocks, weight);
	if (status == TS_OK)
		round_weights(sim, weight, rounded, unit);
	points->weight = rounded;
	ts_free(weight);
	return status;
}

static enum ts_status balance(struct ts_rank_balance *b, struct tsim *sim, struct ts_rank_blocks *blocks,
			      const struct ts_rank_points *points, struct ts_balance_result *result)
{
	struct ts_rank_load load;

	if (ts_rank_load_find(blocks, points, &load) != TS_OK)
		return ts_nomem(&sim->error);
	result->before = load.imbalance;
	if (load.imbalance > b->threshold || (!b->rcb && blocks->bisection)) {
		if (ts_ranks(sim) > 1)
			sim->particles->division->held |= can_change(b, blocks);
		TS_TRY(change_blocks(b, sim, blocks, points, &result->iterations));
		if (ts_rank_load_find(blocks, points, &load) != TS_OK)
			return ts_nomem(&sim->error);
	}
	result->after = load.imbalance;
	result->most = (double)load.most;
	return TS_OK;
}

enum ts_status ts_balance_apply(struct ts_rank_balance *b, struct tsim *sim, const struct ts_place *where,
				struct ts_balance_result *result)
{
	const struct ts_particles *p = sim->particles;
	struct ts_rank_points points = { p->x, NULL, p->n, sim->division ? sim->world : NULL };
	struct ts_rank_blocks *blocks;
	double unit = 1;
	enum ts_status status;

	(void)where;
	*result = (struct ts_balance_result){ .before = 1, .after = 1 };
	TS_TRY(ts_balance_blocks(b, sim, &blocks));
	status = b->weights.n ? weigh(b, sim, blocks, &points, &unit) : TS_OK;
	if (status == TS_OK)
		status = balance(b, sim, blocks, &points, result);
	result->most *= unit;
	ts_free((void *)points.weight);
	return status;
}

/* ---- file */

static enum ts_status write_corners(struct ts_textfile *file, const struct tsim *sim,
				    const struct ts_rank_blocks *blocks, int rank)
{
	static const int around[4][2] = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } };
	int corners = sim->dimension == 2 ? 4 : 8;
	const struct ts_rank_block block = ts_rank_blocks_block(blocks, rank);
	const struct ts_rank_side *side = block.side;

	for (int c = 0; c < corners; c++)
		TS_TRY(ts_textfile_printf(file, "%d 1 %g %g %g\n", rank * corners + c + 1,
					  side[0].face[around[c % 4][0]], side[1].face[around[c % 4][1]],
					  sim->dimension == 2 ? 0 : side[2].face[c / 4]));
	return TS_OK;
}

static enum ts_status write_nodes(struct ts_textfile *file, const struct tsim *sim,
				  const struct ts_rank_blocks *blocks)
{
	const struct ts_box *box = &sim->domain->box;
	int ranks = ts_rank_blocks_number(blocks);

	TS_TRY(ts_textfile_printf(file,
				  "ITEM: TIMESTEP\n%" PRId64
				  "\nITEM: NUMBER OF NODES\n%d\nITEM: BOX BOUNDS\n",
				  sim->clock.step, ranks * (sim->dimension == 2 ? 4 : 8)));
	for (int d = 0; d < 3; d++)
		TS_TRY(ts_textfile_printf(file, "%g %g\n", box->lo[d], box->hi[d]));
	TS_TRY(ts_textfile_printf(file, "ITEM: NODES\n"));
	for (int r = 0; r < ranks; r++)
		TS_TRY(write_corners(file, sim, blocks, r));
	return TS_OK;
}

enum ts_status ts_balance_write(struct ts_textfile *file, const struct tsim *sim,
				const struct ts_rank_blocks *blocks)
{
	int ranks = ts_rank_blocks_number(blocks), corners = sim->dimension == 2 ? 4 : 8;
	const char *what = sim->dimension == 2 ? "SQUARES" : "CUBES";

	TS_TRY(write_nodes(file, sim, blocks));
	TS_TRY(ts_textfile_printf(file, "ITEM: TIMESTEP\n%" PRId64 "\nITEM: NUMBER OF %s\n%d\nITEM: %s\n",
				  sim->clock.step, what, ranks, what));
	for (int r = 0; r < ranks; r++) {
		TS_TRY(ts_textfile_printf(file, "%d 1", r + 1));
		for (int c = 0; c < corners; c++)
			TS_TRY(ts_textfile_printf(file, " %d", r * corners + c + 1));
		TS_TRY(ts_textfile_printf(file, "\n"));
	}
	return ts_textfile_flush(file);
}
