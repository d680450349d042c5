/* The blocks of space of ranks whose particles are divided: chosen, and cut by the places of the particles. */
#include "particle/division_blocks.h"

#include <math.h>
#include <string.h>

#include "box/domain.h"
#include "core/ranks.h"
#include "particle/rank_sums.h"
#include "rank/loads.h"

#include "base/banned.h"

/* Room for chance, in particles. */
enum { FEW = 100 };
/* The blocks are cut again, in the next rebuild, if one has more than this times the particles of the largest one after the
 * last cut: when all ranks have got all particles, or the numbers are known at the end of a run; and else. */
static const double UNEVEN = 1.05, VERY_UNEVEN = 1.2;

enum ts_status ts_division_new(struct tsim *sim)
{
	struct ts_division *d;

	if (sim->particles->division)
		return TS_OK;
	d = ts_alloc(1, sizeof *d);
	sim->particles->division = d;
	if (!d)
		return ts_nomem(&sim->error);
	d->ranks = ts_ranks(sim);
	return ts_copies_init(&d->copies, d->ranks) == TS_OK ? TS_OK : ts_nomem(&sim->error);
}

/* The lengths of the space that most of the particles fill, not 0. */
static bool find_filled(double (*x)[3], size_t n, const double lo[3], const double hi[3], double length[3])
{
	if (n && !ts_rank_points_filled(x, n, n / 20, length))
		return false;
	for (int k = 0; k < 3; k++)
		length[k] = n ? fmax(length[k], 1e-3 * (hi[k] - lo[k])) : hi[k] - lo[k];
	return true;
}

static void face_areas(const double length[3], double area[3])
{
	for (int d = 0; d < 3; d++)
		area[d] = length[(d + 1) % 3] * length[(d + 2) % 3];
}

/* The areas of cuts across each dimension. If one half of the particles fills more space than the other one, as a stream over a bed,
 * they have fewer contacts, and their rank waits for the other: such a cut counts as larger. */
static bool find_areas(double (*x)[3], size_t n, const double length[3], double area[3])
{
	static const double PRICE = 4, CHANCE = 0.05;
	double unlike[3];

	face_areas(length, area);
	if (n && !ts_rank_points_unlike(x, n, unlike))
		return false;
	for (int d = 0; n && d < 3; d++)
		area[d] *= 1 + PRICE * fmax(0, unlike[d] - CHANCE);
	return true;
}

static enum ts_status find_grid(struct tsim *sim, int ranks, const double area[3], int count[3])
{
	const struct ts_domain *domain = sim->domain;

	if (ts_rank_blocks_choose(ranks, domain->processors, area, sim->dimension, count))
		return TS_OK;
	return ts_fail(&sim->error, TS_STATE, ts_sim_word(sim, 0, NULL),
		       "processors: %d ranks cannot be arranged in a grid of %d x %d x %d (0: any number)",
		       ranks, domain->processors[0], domain->processors[1], domain->processors[2]);
}

static enum ts_status choose_grid(struct tsim *sim, int ranks, double (*x)[3], size_t n, const double lo[3],
				  const double hi[3], int count[3])
{
	double length[3], area[3];

	return find_filled(x, n, lo, hi, length) && find_areas(x, n, length, area)
		       ? find_grid(sim, ranks, area, count)
		       : ts_nomem(&sim->error);
}

static void find_periodic(const struct tsim *sim, bool periodic[3])
{
	for (int k = 0; k < 3; k++)
		periodic[k] = ts_box_periodic(&sim->domain->box, k);
}

struct ts_placed ts_placed_before(const struct tsim *sim)
{
	const struct ts_particles *p = sim->particles;

	return (struct ts_placed){ p->xhold, p->tag, p->n, sim->domain->held_lo, sim->domain->held_hi };
}

struct ts_placed ts_placed_now(const struct tsim *sim)
{
	const struct ts_particles *p = sim->particles;

	return (struct ts_placed){ p->x, p->tag, p->n, sim->domain->box.lo, sim->domain->box.hi };
}

/* Particles by which the box is cut; the error of the numbers in the blocks of 4 ranks is then about 0.5 %. */
enum { SAMPLE = 1 << 17 };

static int64_t count_all(const struct tsim *sim, size_t n)
{
	int64_t all = (int64_t)n;

	ts_rank_sums_count(sim, &all);
	return all;
}

/* Whether the particle is one of about 1/part of all, which are spread over any lattice. */
static bool is_sampled(int32_t tag, uint64_t part)
{
	uint64_t mixed = (uint64_t)tag * 0x9e3779b97f4a7c15u;

	return (mixed >> 32) % part == 0;
}

/* The places of some particles; while they are divided of those of all ranks, which all get the same. */
static enum ts_status sample_places(struct tsim *sim, const struct ts_placed *placed,
				    struct ts_parcel *places)
{
	double(*at)[3] = placed->x;
	uint64_t part = (uint64_t)count_all(sim, placed->n) / SAMPLE + 1;
	struct ts_parcel own = { 0 };
	enum ts_status status = TS_OK;

	for (size_t i = 0; status == TS_OK && i < placed->n; i++)
		if (is_sampled(placed->tag ? placed->tag[i] : (int32_t)i, part))
			status = ts_parcel_add(sim->division ? &own : places, at[i], sizeof at[i]);
	if (status == TS_OK && sim->division)
		status = ts_world_share(sim->world, &own, places);
	ts_parcel_release(&own);
	return status == TS_OK ? TS_OK : ts_nomem(&sim->error);
}

enum ts_status ts_division_cut_space(struct tsim *sim, int ranks, struct ts_placed placed,
				     struct ts_rank_blocks *blocks)
{
	const double *lo = placed.lo, *hi = placed.hi;
	struct ts_parcel places = { 0 };
	enum ts_status status = sample_places(sim, &placed, &places);
	double(*x)[3] = (double(*)[3])(void *)places.data;
	size_t n = places.n / sizeof *x;
	bool periodic[3];
	int count[3];

	find_periodic(sim, periodic);
	if (status == TS_OK)
		status = choose_grid(sim, ranks, x, n, lo, hi, count);
	if (status == TS_OK &&
	    !(ts_rank_blocks_cut(blocks, count, lo, hi, periodic) && ts_rank_blocks_balance(blocks, x, n)))
		status = ts_nomem(&sim->error);
	ts_parcel_release(&places);
	return status;
}

enum ts_status ts_division_cut(struct tsim *sim, int ranks, struct ts_rank_blocks *blocks)
{
	return ts_division_cut_space(sim, ranks, ts_placed_before(sim), blocks);
}

bool ts_division_blocks_fit(const struct tsim *sim, struct ts_division *d, const double lo[3],
			    const double hi[3])
{
	const struct ts_rank_blocks *blocks = &d->blocks;

	if (!blocks->bisection && !blocks->cut[0])
		return false;
	for (int k = 0; k < 3; k++) {
		int given = blocks->bisection ? 0 : sim->domain->processors[k];

		if ((given && given != blocks->count[k]) ||
		    blocks->periodic[k] != ts_box_periodic(&sim->domain->box, k))
			return false;
	}
	ts_rank_blocks_fit(&d->blocks, lo, hi);
	return true;
}

/* owner[i]: the rank of each particle; returns the particles of the rank that has most, counted in n[rank]. */
static size_t find_owners(const struct tsim *sim, const struct ts_division *d, double (*at)[3],
			  int32_t *owner, size_t *n)
{
	const struct ts_particles *p = sim->particles;
	size_t most = 0;

	memset(n, 0, (size_t)d->ranks * sizeof *n);
	for (size_t i = 0; i < p->n; i++) {
		owner[i] = (int32_t)ts_rank_blocks_owner(&d->blocks, at[i]);
		n[owner[i]]++;
	}
	for (int r = 0; r < d->ranks; r++)
		most = n[r] > most ? n[r] : most;
	return most;
}

/* Whether a block with n particles has this much more than when the blocks were cut. */
static bool is_uneven(const struct ts_division *d, double factor, double n)
{
	return !d->held && n > factor * (double)d->cut_most + FEW;
}

bool ts_division_is_very_uneven(const struct ts_division *d, double n)
{
	return is_uneven(d, VERY_UNEVEN, n);
}

enum ts_status ts_division_choose_blocks(struct tsim *sim, struct ts_division *d,
					 const struct ts_placed *placed, int32_t *owner)
{
	size_t *n = ts_alloc((size_t)d->ranks, sizeof *n), most = 0;
	enum ts_status status = n ? TS_OK : ts_nomem(&sim->error);
	bool fit = ts_division_blocks_fit(sim, d, placed->lo, placed->hi);

	sim->run.uneven = false;
	d->held &= fit;
	if (status == TS_OK && fit)
		most = find_owners(sim, d, placed->x, owner, n);
	if (status == TS_OK && (!fit || is_uneven(d, UNEVEN, (double)most))) {
		status = ts_division_cut_space(sim, sim->world->n, *placed, &d->blocks);
		if (status == TS_OK)
			d->cut_most = find_owners(sim, d, placed->x, owner, n);
	}
	ts_free(n);
	return status;
}

bool ts_division_near(const struct tsim *sim, int dim, double x, double reach)
{
	return !sim->division || ts_rank_blocks_near(&sim->division->blocks, sim->world->rank, dim, x, reach);
}

enum ts_status ts_division_cut_again(struct tsim *sim, struct ts_division *d)
{
	const struct ts_particles *p = sim->particles;
	const struct ts_rank_points points = { .x = p->x, .n = p->n, .world = sim->world };
	struct ts_rank_load load;

	sim->run.uneven = false;
	TS_TRY(ts_division_cut_space(sim, d->ranks, ts_placed_now(sim), &d->blocks));
	if (ts_rank_load_find(&d->blocks, &points, &load) != TS_OK)
		return ts_nomem(&sim->error);
	d->cut_most = (size_t)load.most;
	return TS_OK;
}

bool ts_division_is_uneven(struct tsim *sim, struct ts_division *d)
{
	double n[2] = { (double)sim->particles->n, -(double)sim->particles->n };

	ts_world_most(sim->world, n, 2);
	d->most = (size_t)n[0];
	d->least = (size_t)-n[1];
	return is_uneven(d, UNEVEN, n[0]);
}

bool ts_division_owns(const struct tsim *sim, const double x[3])
{
	return ts_rank_blocks_owner(&sim->particles->division->blocks, x) == sim->world->rank;
}

enum ts_status ts_division_blocks(struct tsim *sim, struct ts_rank_blocks **blocks)
{
	const struct ts_particles *p = sim->particles;
	const struct ts_box *box = &sim->domain->box;
	struct ts_division *d;

	TS_TRY(ts_division_new(sim));
	d = p->division;
	*blocks = &d->blocks;
	if (ts_division_blocks_fit(sim, d, box->lo, box->hi))
		return TS_OK;
	d->held = false;
	d->cut_most = p->n / (size_t)d->ranks;
	return ts_division_cut_space(sim, d->ranks, ts_placed_now(sim), &d->blocks);
}

enum ts_status ts_division_plan(struct tsim *sim, int ranks, struct ts_rank_blocks *blocks)
{
	const struct ts_domain *domain = sim->domain;
	struct ts_division *d = sim->particles->division;

	if (!d || !d->held || d->ranks != ranks ||
	    !ts_division_blocks_fit(sim, d, domain->held_lo, domain->held_hi))
		return ts_division_cut(sim, ranks, blocks);
	return ts_rank_blocks_copy(blocks, &d->blocks) ? TS_OK : ts_nomem(&sim->error);
}

enum ts_status ts_division_cut_equal(struct tsim *sim, struct ts_rank_blocks *blocks)
{
	const struct ts_box *box = &sim->domain->box;
	const double length[3] = { ts_box_length(box, 0), ts_box_length(box, 1), ts_box_length(box, 2) };
	double area[3];
	bool periodic[3];
	int count[3];

	find_periodic(sim, periodic);
	face_areas(length, area);
	TS_TRY(find_grid(sim, ts_rank_blocks_number(blocks), area, count));
	return ts_rank_blocks_cut(blocks, count, box->lo, box->hi, periodic) ? TS_OK : ts_nomem(&sim->error);
}

enum ts_status ts_division_begin(struct tsim *sim, double (*x)[3], size_t n)
{
	const struct ts_box *box = &sim->domain->box;
	struct ts_division *d;

	TS_TRY(ts_division_new(sim));
	d = sim->particles->division;
	d->held = false;
	d->cut_most = n / (size_t)d->ranks;
	return ts_division_cut_space(sim, d->ranks, (struct ts_placed){ x, NULL, n, box->lo, box->hi },
				     &d->blocks);
}
