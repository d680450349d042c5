#include "coupling/cell_order.h"

#include <string.h>

#include "base/alloc.h"
#include "base/hash.h"
#include "core/ranks.h"
#include "coupling/interpolation_weights.h"
#include "particle/particles.h"

#include "base/banned.h"

static uint64_t hash_grid(const struct ts_grid *grid)
{
	struct ts_hash hash = ts_hash_start();

	ts_hash_add(&hash, grid->n, sizeof grid->n);
	ts_hash_add(&hash, grid->periodic, sizeof grid->periodic);
	for (int d = 0; d < 3; d++)
		ts_hash_add(&hash, grid->face[d], ((size_t)grid->n[d] + 1) * sizeof *grid->face[d]);
	return ts_hash_value(&hash);
}

/* Whether the grid is another one, or own particles have moved or changed since they were sorted; all is noted as it is
 * now. */
static bool note_changes(struct ts_cell_sort *sort, const struct tsim *sim, const struct ts_fluid *fluid)
{
	const struct ts_particles *p = sim->particles;
	const uint64_t grid = hash_grid(&fluid->grid);
	const bool divided = sim->division;
	bool changed = sort->nlast != p->n || sort->grid != grid || sort->divided != divided;

	sort->divided = divided;
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

/* Of a particle, for all ranks. */
struct row {
	double x[3], radius;
	int32_t tag;
	uint32_t mask;
};

static void use_own(struct ts_cell_sort *sort, const struct ts_particles *p)
{
	sort->of = (struct ts_cell_rows){
		.n = p->n, .x = (const double(*)[3])p->x, .radius = p->radius, .tag = p->tag, .mask = p->mask
	};
}

static enum ts_status pack_rows(const struct ts_particles *p, struct ts_parcel *mine)
{
	struct row *to = (struct row *)(void *)ts_parcel_extend(mine, p->n * sizeof *to);

	for (size_t i = 0; to && i < p->n; i++) {
		to[i] = (struct row){ .radius = p->radius[i], .tag = p->tag[i], .mask = p->mask[i] };
		memcpy(to[i].x, p->x[i], sizeof to[i].x);
	}
	return to ? TS_OK : TS_NOMEM;
}

/* Columns of n rows, one after the other: `gathered` has room for them behind the rows. */
static enum ts_status take_rows(struct ts_cell_sort *sort, const struct row *from, size_t n)
{
	struct ts_parcel *to = &sort->gathered;
	double *x, *radius;
	uint32_t *mask;
	int32_t *tag;

	to->n = 0;
	x = (double *)(void *)ts_parcel_extend(to, n * sizeof *from);
	if (!x)
		return TS_NOMEM;
	radius = x + 3 * n;
	tag = (int32_t *)(void *)(radius + n);
	mask = (uint32_t *)(void *)(tag + n);
	for (size_t r = 0; r < n; r++) {
		memcpy(x + 3 * r, from[r].x, sizeof from[r].x);
		radius[r] = from[r].radius;
		tag[r] = from[r].tag;
		mask[r] = from[r].mask;
	}
	sort->of.n = n;
	sort->of.x = (const double(*)[3])x;
	sort->of.radius = radius;
	sort->of.tag = tag;
	sort->of.mask = mask;
	return TS_OK;
}

static enum ts_status gather_rows(struct ts_cell_sort *sort, struct tsim *sim)
{
	struct ts_parcel mine = { 0 }, all = { 0 };
	enum ts_status status = pack_rows(sim->particles, &mine);

	if (status == TS_OK)
		status = ts_world_share_own(sim->world, &mine, &all, &sort->of.first);
	sort->of.first /= sizeof(struct row);
	if (status == TS_OK)
		status = take_rows(sort, (const struct row *)(const void *)all.data,
				   all.n / sizeof(struct row));
	ts_parcel_release(&mine);
	ts_parcel_release(&all);
	return status;
}

/* ---- sort */

static void find_cells(struct ts_cell_sort *sort, const struct tsim *sim, const struct ts_fluid *fluid)
{
	const struct ts_cell_rows *of = &sort->of;
	const int *n = fluid->grid.n, most = 1 << TS_CELL_BITS;

#pragma omp parallel for num_threads(ts_team(sim, of->n)) schedule(static)
	for (size_t i = 0; i < of->n; i++) {
		double place[3];
		int cell[3];

		sort->cell[i] = -1;
		sort->where[i] = TS_CELL_ELSEWHERE;
		if (!ts_coupling_locate(fluid, of->x[i], place, cell))
			continue;
		sort->cell[i] = (cell[2] * n[1] + cell[1]) * n[0] + cell[0];
		if (memcmp(place, of->x[i], sizeof place) == 0 && cell[0] < most && cell[1] < most &&
		    cell[2] < most)
			sort->where[i] = (uint64_t)cell[0] | (uint64_t)cell[1] << TS_CELL_BITS |
					 (uint64_t)cell[2] << 2 * TS_CELL_BITS;
	}
}

static void sort_cell(int32_t *row, size_t from, size_t to, const int32_t *tag)
{
	for (size_t k = from + 1; k < to; k++) {
		int32_t this = row[k];
		size_t at = k;

		for (; at > from && tag[row[at - 1]] > tag[this]; at--)
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
		sort_cell(sort->row, start[c], start[c + 1], sort->of.tag);
}

static enum ts_status make_room(struct ts_cell_sort *sort, size_t n, size_t ncells)
{
	TS_TRY(TS_GROW(sort->row, sort->row_capacity, n));
	TS_TRY(TS_GROW(sort->cell, sort->cell_capacity, n));
	TS_TRY(TS_GROW(sort->where, sort->where_capacity, n));
	return TS_GROW(sort->start, sort->start_capacity, ncells + 2);
}

static enum ts_status sort_again(struct ts_cell_sort *sort, struct tsim *sim, const struct ts_fluid *fluid)
{
	size_t ncells = ts_grid_cells(&fluid->grid);
	bool changed;

	if (TS_GROW(sort->last, sort->last_capacity, sim->particles->n) != TS_OK)
		return ts_nomem(&sim->error);
	changed = ts_ranks_most(sim, note_changes(sort, sim, fluid)) > 0;
	if (!sim->division)
		use_own(sort, sim->particles);
	else if (changed && gather_rows(sort, sim) != TS_OK)
		return ts_nomem(&sim->error);
	if (!changed)
		return TS_OK;
	if (make_room(sort, sort->of.n, ncells) != TS_OK) {
		sort->nlast = SIZE_MAX;
		return ts_nomem(&sim->error);
	}
	find_cells(sort, sim, fluid);
	sort_particles(sort, ncells);
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

static void cut_slabs(struct ts_cell_order *order, const struct ts_grid *grid, int reach)
{
	int axis = grid->n[2] > 1 ? 2 : grid->n[1] > 1 ? 1 : 0, thick = 2 * reach + 2;
	size_t plane = 1;

	for (int d = 0; d < axis; d++)
		plane *= (size_t)grid->n[d];
	order->nslabs = grid->n[axis] / thick > 1 ? grid->n[axis] / thick : 1;
	order->ring = grid->periodic[axis];
	for (int k = 0; k < order->nslabs; k++)
		order->slab[k] = order->sort->start[(size_t)k * (size_t)thick * plane];
	order->slab[order->nslabs] = order->sort->n;
}

enum ts_status ts_cell_order_make(struct ts_cell_order *order, struct tsim *sim, const struct ts_fluid *fluid,
				  int group, int reach)
{
	struct ts_cell_sort *sort = find_sort(order, sim);

	if (TS_GROW(order->slab, order->slab_capacity, ts_grid_cells(&fluid->grid) + 1) != TS_OK)
		return ts_nomem(&sim->error);
	TS_TRY(sort_again(sort, sim, fluid));
	order->sort = sort;
	order->group = group;
	cut_slabs(order, &fluid->grid, reach);
	return TS_OK;
}

enum ts_status ts_cell_order_share(struct ts_cell_order *order, struct tsim *sim, const double *mine,
				   size_t stride, size_t width, struct ts_cell_numbers *out)
{
	size_t n = sim->particles->n, bytes = width * sizeof(double);
	struct ts_parcel own = { 0 };
	enum ts_status status;
	unsigned char *to;

	*out = (struct ts_cell_numbers){ mine, stride };
	if (!sim->division)
		return TS_OK;
	to = ts_parcel_extend(&own, n * bytes);
	for (size_t i = 0; to && i < n; i++)
		memcpy(to + i * bytes, mine + stride * i, bytes);
	order->shared.n = 0;
	status = to ? ts_world_share(sim->world, &own, &order->shared) : TS_NOMEM;
	ts_parcel_release(&own);
	*out = (struct ts_cell_numbers){ (const double *)(const void *)order->shared.data, width };
	return status == TS_OK ? TS_OK : ts_nomem(&sim->error);
}

void ts_cell_order_release(struct ts_cell_order *order)
{
	ts_parcel_release(&order->own.gathered);
	ts_parcel_release(&order->shared);
	ts_free(order->own.row);
	ts_free(order->own.cell);
	ts_free(order->own.where);
	ts_free(order->own.start);
	ts_free(order->own.last);
	ts_free(order->slab);
	*order = (struct ts_cell_order){ 0 };
}

/* Even slabs, then odd slabs; with an odd number along a periodic axis the last slab by itself. */
void ts_cell_order_each(const struct ts_cell_order *order, int threads, ts_cell_order_fn *add, void *context)
{
	int n = order->nslabs, alone = order->ring && n % 2 && n > 1;

	for (int colour = 0; colour < 2 + alone; colour++) {
		int from = colour == 2 ? n - 1 : colour, to = n - (alone && colour < 2);

#pragma omp parallel for num_threads(threads) schedule(dynamic, 1)
		for (int s = from; s < to; s += 2)
			for (size_t k = order->slab[s]; k < order->slab[s + 1]; k++) {
				size_t row = (size_t)order->sort->row[k];

				if (order->sort->of.mask[row] >> order->group & 1)
					add(context, row);
			}
	}
}
