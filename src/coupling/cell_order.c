#include "coupling/cell_order.h"

#include <string.h>

#include "base/alloc.h"
#include "core/ranks.h"
#include "coupling/interpolation_weights.h"
#include "coupling/near_particles.h"
#include "flow/near_exchange.h"
#include "particle/division.h"
#include "particle/particles.h"

#include "base/banned.h"

/* Whether the grid is another one, or own particles have moved or changed since they were sorted; all is noted as it is
 * now. */
static bool note_changes(struct ts_cell_sort *sort, const struct tsim *sim, const struct ts_fluid *fluid,
			 int reach)
{
	const struct ts_particles *p = sim->particles;
	/* of all particles, or of those near own cells */
	const uint64_t grid =
		ts_cell_owners_hash(&fluid->grid, ts_division_blocks_now(sim)) + fluid->near.active;
	const bool divided = sim->division;
	bool changed = sort->nlast != p->n || sort->grid != grid || sort->divided != divided ||
		       (divided && sort->reach < reach);

	sort->divided = divided;
	sort->reach = reach > sort->reach || sort->grid != grid ? reach : sort->reach;
	sort->nlast = p->n;
	sort->grid = grid;
#pragma omp parallel for num_threads(ts_team(sim, p->n)) schedule(static) reduction(|| : changed)
	for (size_t i = 0; i < p->n; i++) {
		struct ts_cell_sorted *last = &sort->last[i];

		if (last->tag == p->tag[i] && memcmp(last->x, p->x[i], sizeof last->x) == 0)
			continue;
		last->tag = p->tag[i];
		memcpy(last->x, p->x[i], sizeof last->x);
		changed = true;
	}
	return changed;
}

/* ---- rows */

/* The columns of own particles, which may have other places in memory than when they were sorted. */
static void find_columns(struct ts_cell_sort *sort, const struct ts_particles *p)
{
	sort->of.x = (const double(*)[3])p->x;
	sort->of.radius = p->radius;
	sort->of.tag = p->tag;
	sort->of.mask = p->mask;
}

static void use_own(struct ts_cell_sort *sort, const struct ts_particles *p)
{
	sort->of = (struct ts_cell_rows){ .n = p->n, .own = p->n };
	find_columns(sort, p);
}

/* ---- sort */

enum { BATCH = 64 };

/* The number of the cell of row i; -1: it is outside of the grid. */
static int32_t find_cell(const struct ts_cell_sort *sort, const struct ts_fluid *fluid, size_t i)
{
	const uint64_t where = sort->where[i];
	double place[3];
	int cell[3];

	if (!(where & TS_HALVES_ELSEWHERE))
		for (int d = 0; d < 3; d++)
			cell[d] = ts_halves_of(where, d) / 2;
	else if (!ts_coupling_locate(fluid, ts_cell_rows_x(&sort->of, i), place, cell))
		return -1;
	return ts_cell_frame_number(&sort->frame, cell);
}

/* Of the rows from .. to - 1, BATCH at most. */
static void find_cells_of(struct ts_cell_sort *sort, const struct ts_fluid *fluid, size_t from, size_t to)
{
	double x[3][BATCH];
	uint64_t all[BATCH];

	for (size_t k = 0; k < BATCH; k++)
		for (int d = 0; d < 3; d++)
			x[d][k] = from + k < to ? ts_cell_rows_x(&sort->of, from + k)[d] : 0;
	ts_halves_find_all(&fluid->grid, (const double *const[3]){ x[0], x[1], x[2] }, to - from, all);
	for (size_t i = from; i < to; i++) {
		sort->where[i] = all[i - from];
		sort->cell[i] = find_cell(sort, fluid, i);
	}
}

/* Of the rows from .. of.n - 1. */
static void find_cells(struct ts_cell_sort *sort, const struct tsim *sim, const struct ts_fluid *fluid,
		       size_t from)
{
	const size_t n = sort->of.n;

#pragma omp parallel for num_threads(ts_team(sim, n - from)) schedule(static)
	for (size_t i = from; i < n; i += BATCH)
		find_cells_of(sort, fluid, i, i + BATCH < n ? i + BATCH : n);
}

static void sort_cell(const struct ts_cell_rows *of, int32_t *row, size_t from, size_t to)
{
	for (size_t k = from + 1; k < to; k++) {
		int32_t this = row[k], tag = ts_cell_rows_tag(of, (size_t)this);
		size_t at = k;

		for (; at > from && ts_cell_rows_tag(of, (size_t)row[at - 1]) > tag; at--)
			row[at] = row[at - 1];
		row[at] = this;
	}
}

/* Counting sort by cell, then by identity in each cell. start[c + 1] is used as the next free index of
 * cell c. */
static void sort_particles(struct ts_cell_sort *sort, size_t ncells)
{
	size_t *start = sort->start;

	memset(start, 0, (ncells + 2) * sizeof *start);
	for (size_t i = 0; i < sort->of.n; i++)
		if (sort->cell[i] >= 0)
			start[sort->cell[i] + 2]++;
	for (size_t c = 2; c < ncells + 2; c++)
		start[c] += start[c - 1];
	sort->n = start[ncells + 1];
	for (size_t i = 0; i < sort->of.n; i++)
		if (sort->cell[i] >= 0)
			sort->row[start[sort->cell[i] + 1]++] = (int32_t)i;
	for (size_t c = 0; c < ncells; c++)
		sort_cell(&sort->of, sort->row, start[c], start[c + 1]);
}

static enum ts_status make_room(struct ts_cell_sort *sort, size_t n, size_t ncells)
{
	TS_TRY(TS_GROW(sort->row, sort->row_capacity, n));
	TS_TRY(TS_GROW(sort->cell, sort->cell_capacity, n));
	TS_TRY(TS_GROW(sort->where, sort->where_capacity, n));
	return TS_GROW(sort->start, sort->start_capacity, ncells + 2);
}

/* Finds the cells of the rows: of the own particles, then of those that other ranks send. */
static enum ts_status make_rows(struct ts_cell_sort *sort, struct tsim *sim, struct ts_fluid *fluid, bool all)
{
	const size_t own = sort->of.own, ncells = ts_cell_frame_cells(&sort->frame);
	const struct ts_rank_blocks *blocks = ts_division_blocks_now(sim);
	struct ts_cell_space space;

	TS_TRY(make_room(sort, own, ncells));
	find_cells(sort, sim, fluid, 0);
	if (!sim->division)
		return TS_OK;
	if (!fluid->owners && !(fluid->owners = ts_alloc(1, sizeof *fluid->owners)))
		return TS_NOMEM;
	TS_TRY(ts_cell_owners_make(fluid->owners, sort->grid, &fluid->grid, blocks, all));
	space = (struct ts_cell_space){ &fluid->grid, blocks, fluid->owners, sort->frame };
	TS_TRY(ts_cell_senders_rows(&sort->senders, sim->world, &space, sort->reach, sort->cell, &sort->of));
	TS_TRY(make_room(sort, sort->of.n, ncells));
	find_cells(sort, sim, fluid, own);
	return TS_OK;
}

bool ts_cell_order_few(double most, int ranks, size_t cells)
{
	static const double FEW = 0.5;

	return most * ranks < FEW * (double)cells;
}

/* Between PRE_FORCE and POST_FORCE of a step no particle moves. */
static bool agreed_in_this_step(const struct ts_cell_sort *sort, const struct tsim *sim,
				const struct ts_fluid *fluid)
{
	return sim->division && !sim->run.in_setup && sort->agreed == sim->clock.step &&
	       sort->era == sim->era && fluid->near.begun != sim->clock.step;
}

static enum ts_status fail_moved(struct tsim *sim)
{
	return ts_fail(&sim->error, TS_STATE, NULL,
		       "particles have moved while the forces of the fluid on them were computed, which "
		       "works "
		       "without ranks only; use threads (OMP_NUM_THREADS)");
}

static enum ts_status sort_again(struct ts_cell_sort *sort, struct tsim *sim, struct ts_fluid *fluid,
				 int reach)
{
	double most[2] = { 0, (double)sim->particles->n };
	bool few;

	if (TS_GROW(sort->last, sort->last_capacity, sim->particles->n) != TS_OK)
		return ts_nomem(&sim->error);
	most[0] = note_changes(sort, sim, fluid, reach);
	if (agreed_in_this_step(sort, sim, fluid))
		return most[0] > 0 ? fail_moved(sim) : TS_OK;
	ts_near_particles_reach(fluid, reach);
	TS_TRY(ts_near_particles_agree(fluid, sim, most, 2));
	sort->agreed = sim->division && !sim->run.in_setup ? sim->clock.step : -1;
	sort->era = sim->era;
	find_columns(sort, sim->particles);
	if (!(most[0] > 0))
		return TS_OK;
	use_own(sort, sim->particles);
	sort->frame = ts_cell_frame_of(fluid);
	few = sim->world && !fluid->near.active &&
	      ts_cell_order_few(most[1], sim->world->n, ts_grid_cells(&fluid->grid));
	if (make_rows(sort, sim, fluid, few) != TS_OK) {
		sort->nlast = SIZE_MAX;
		return ts_nomem(&sim->error);
	}
	sort_particles(sort, ts_cell_frame_cells(&sort->frame));
	return TS_OK;
}

/* The sorted particles of the first fix that has some, or own ones. */
static struct ts_cell_sort *find_sort(struct ts_cell_order *own, const struct tsim *sim)
{
	const struct ts_instance *part;

	for (size_t k = 0; (part = ts_sim_next_of(sim, TS_KIND_FIX, TS_FAMILY_FLOW_PART, &k));) {
		const struct ts_flow_part *flow_part = part->state;

		if (flow_part->order)
			return &flow_part->order->own;
	}
	return &own->own;
}

/* The last axis with more than one cell. */
static int axis_of_slabs(const struct ts_grid *grid)
{
	return grid->n[2] > 1 ? 2 : grid->n[1] > 1 ? 1 : 0;
}

static int thickness(int reach)
{
	return 2 * reach + 2;
}

static int count_slabs(const struct ts_grid *grid, int reach)
{
	const int n = grid->n[axis_of_slabs(grid)] / thickness(reach);

	return n > 1 ? n : 1;
}

/* Slabs of the grid, also where the frame has a part of it. */
static void cut_slabs(struct ts_cell_order *order, const struct ts_grid *grid, int reach)
{
	const struct ts_cell_frame *frame = &order->sort->frame;
	const int axis = axis_of_slabs(grid);
	size_t plane = 1;

	for (int d = 0; d < axis; d++)
		plane *= (size_t)frame->n[d];
	order->nslabs = count_slabs(grid, reach);
	order->ring = grid->periodic[axis];
	for (int k = 0; k < order->nslabs; k++)
		order->slab[k] =
			order->sort->start[plane *
					   (size_t)ts_cell_frame_below(frame, axis, k * thickness(reach))];
	order->slab[order->nslabs] = order->sort->n;
}

enum ts_status ts_cell_order_make(struct ts_cell_order *order, struct tsim *sim, struct ts_fluid *fluid,
				  int group, int reach)
{
	struct ts_cell_sort *sort = find_sort(order, sim);

	if (TS_GROW(order->slab, order->slab_capacity, (size_t)count_slabs(&fluid->grid, reach) + 1) != TS_OK)
		return ts_nomem(&sim->error);
	TS_TRY(sort_again(sort, sim, fluid, reach));
	order->sort = sort;
	order->group = group;
	order->fluid = fluid;
	cut_slabs(order, &fluid->grid, reach);
	return TS_OK;
}

enum ts_status ts_cell_order_share(struct ts_cell_order *order, struct tsim *sim, const double *mine,
				   size_t stride, size_t width, struct ts_cell_numbers *out)
{
	struct ts_cell_sort *sort = find_sort(order, sim);

	*out = (struct ts_cell_numbers){ .own = mine, .n = sort->of.own, .stride = stride, .width = width };
	if (!sim->division)
		return TS_OK;
	order->shared.n = 0;
	if (ts_cell_senders_numbers(&sort->senders, sim->world, mine, stride, width, &order->shared) != TS_OK)
		return ts_nomem(&sim->error);
	out->other = (const double *)(const void *)order->shared.data;
	return TS_OK;
}

static enum ts_status share_cells(struct ts_cell_order *order, struct tsim *sim, double *field, bool near_too)
{
	struct ts_fluid *fluid = order->fluid;
	enum ts_status status = TS_OK;

	if (sim->division)
		status = fluid->near.active
				 ? ts_fluid_near_gather(fluid, &field, 1, near_too)
				 : ts_cell_owners_share(fluid->owners, sim->world, &fluid->grid, &field, 1);
	return status == TS_OK ? TS_OK : ts_nomem(&sim->error);
}

enum ts_status ts_cell_order_spread(struct ts_cell_order *order, struct tsim *sim, double *field)
{
	return share_cells(order, sim, field, true);
}

enum ts_status ts_cell_order_gather(struct ts_cell_order *order, struct tsim *sim, double *field)
{
	return share_cells(order, sim, field, false);
}

struct ts_cell_box ts_cell_order_box(const struct ts_cell_order *order, const struct tsim *sim)
{
	const struct ts_fluid *fluid = order->fluid;
	const int *n = fluid->grid.n;
	const struct ts_cell_box all = { { 0, 0, 0 }, { n[0], n[1], n[2] } };

	if (!sim->division || fluid->owners->all)
		return all;
	return ts_cell_box_common(&all, &fluid->owners->box[sim->world->rank]);
}

void ts_cell_order_release(struct ts_cell_order *order)
{
	ts_cell_senders_release(&order->own.senders);
	ts_parcel_release(&order->shared);
	ts_free(order->own.row);
	ts_free(order->own.cell);
	ts_free(order->own.where);
	ts_free(order->own.start);
	ts_free(order->own.last);
	ts_free(order->slab);
	*order = (struct ts_cell_order){ 0 };
}

static inline void fetch_row(const struct ts_cell_rows *of, size_t row)
{
	if (row >= of->own)
		return;
	__builtin_prefetch(&of->mask[row]);
	__builtin_prefetch(of->x[row]);
}

/* The rows of the group from index *k on, before index `to`. */
static size_t next_rows(const struct ts_cell_order *order, size_t *k, size_t to, int32_t *row)
{
	size_t n = 0;

	for (; *k < to && n < TS_CELL_ORDER_ROWS; ++*k) {
		const int32_t this = order->sort->row[*k];

		if (*k + TS_CELL_ORDER_ROWS < to)
			fetch_row(&order->sort->of, (size_t)order->sort->row[*k + TS_CELL_ORDER_ROWS]);
		if (ts_cell_rows_mask(&order->sort->of, (size_t)this) >> order->group & 1)
			row[n++] = this;
	}
	return n;
}

/* Even slabs, then odd slabs; with an odd number along a periodic axis the last slab by itself. */
void ts_cell_order_each_rows(const struct ts_cell_order *order, int threads, ts_cell_order_rows_fn *add,
			     void *context)
{
	int n = order->nslabs, alone = order->ring && n % 2 && n > 1;

	for (int colour = 0; colour < 2 + alone; colour++) {
		int from = colour == 2 ? n - 1 : colour, to = n - (alone && colour < 2);

#pragma omp parallel for num_threads(threads) schedule(dynamic, 1)
		for (int s = from; s < to; s += 2) {
			int32_t row[TS_CELL_ORDER_ROWS];
			size_t k = order->slab[s], nrows;

			while ((nrows = next_rows(order, &k, order->slab[s + 1], row)))
				add(context, row, nrows);
		}
	}
}

struct each_row {
	ts_cell_order_fn *add;
	void *context;
};

static void add_each(void *context, const int32_t *row, size_t n)
{
	const struct each_row *each = context;

	for (size_t k = 0; k < n; k++)
		each->add(each->context, (size_t)row[k]);
}

void ts_cell_order_each(const struct ts_cell_order *order, int threads, ts_cell_order_fn *add, void *context)
{
	struct each_row each = { add, context };

	ts_cell_order_each_rows(order, threads, add_each, &each);
}
