#include "coupling/cell_order.h"

#include <string.h>

#include "base/alloc.h"
#include "coupling/interpolation_weights.h"
#include "particle/particles.h"

#include "base/banned.h"

static void find_cells(struct ts_cell_order *order, const struct tsim *sim, const struct ts_fluid *fluid,
		       int group)
{
	const struct ts_particles *p = sim->particles;
	const int *n = fluid->grid.n;

#pragma omp parallel for num_threads(ts_team(sim, p->n)) schedule(static)
	for (size_t i = 0; i < p->n; i++) {
		double place[3];
		int cell[3];

		order->cell[i] = -1;
		if (ts_in_group(p, i, group) && ts_coupling_locate(fluid, p->x[i], place, cell))
			order->cell[i] = (cell[2] * n[1] + cell[1]) * n[0] + cell[0];
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
static void sort_particles(struct ts_cell_order *order, const struct ts_particles *p, size_t ncells)
{
	size_t *start = order->start;

	memset(start, 0, (ncells + 2) * sizeof *start);
	for (size_t i = 0; i < p->n; i++)
		if (order->cell[i] >= 0)
			start[order->cell[i] + 2]++;
	for (size_t c = 2; c < ncells + 2; c++)
		start[c] += start[c - 1];
	order->n = start[ncells + 1];
	for (size_t i = 0; i < p->n; i++)
		if (order->cell[i] >= 0)
			order->row[start[order->cell[i] + 1]++] = (int32_t)i;
	for (size_t c = 0; c < ncells; c++)
		sort_cell(order->row, start[c], start[c + 1], p->tag);
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
		order->slab[k] = order->start[(size_t)k * (size_t)thick * plane];
	order->slab[order->nslabs] = order->n;
}

enum ts_status ts_cell_order_make(struct ts_cell_order *order, struct tsim *sim, const struct ts_fluid *fluid,
				  int group, int reach)
{
	size_t n = sim->particles->n, ncells = ts_grid_cells(&fluid->grid);

	if (TS_GROW(order->row, order->row_capacity, n) != TS_OK ||
	    TS_GROW(order->cell, order->cell_capacity, n) != TS_OK ||
	    TS_GROW(order->start, order->start_capacity, ncells + 2) != TS_OK ||
	    TS_GROW(order->slab, order->slab_capacity, ncells + 1) != TS_OK)
		return ts_nomem(&sim->error);
	find_cells(order, sim, fluid, group);
	sort_particles(order, sim->particles, ncells);
	cut_slabs(order, &fluid->grid, reach);
	return TS_OK;
}

void ts_cell_order_release(struct ts_cell_order *order)
{
	ts_free(order->row);
	ts_free(order->cell);
	ts_free(order->start);
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
			for (size_t k = order->slab[s]; k < order->slab[s + 1]; k++)
				add(context, (size_t)order->row[k]);
	}
}
