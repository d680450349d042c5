#include "neigh/order.h"

#include <math.h>
#include <string.h>

#include "base/parallel.h"
#include "math/bounds.h"
#include "particle/columns.h"
#include "particle/identity.h"
#include "particle/particles.h"

#include "base/banned.h"

/* About as many cells as particles, with equal edges. They are numbered first along the shortest edge of the
 * bounding box, last along the longest: so cells of one layer are as near each other in memory as possible.
 */
struct grid {
	double lo[3], inverse;
	size_t cells[3], stride[3], n;
};

static void number_cells(struct grid *g)
{
	int axis_order[3] = { 0, 1, 2 };

	for (int pass = 0; pass < 2; pass++) {
		for (int k = 0; k < 2; k++) {
			if (g->cells[axis_order[k]] > g->cells[axis_order[k + 1]]) {
				int swap = axis_order[k];

				axis_order[k] = axis_order[k + 1];
				axis_order[k + 1] = swap;
			}
		}
	}
	g->n = 1;
	for (int k = 0; k < 3; k++) {
		g->stride[axis_order[k]] = g->n;
		g->n *= g->cells[axis_order[k]];
	}
}

static struct grid make_grid(const struct ts_particles *p, int team)
{
	struct grid g = { .inverse = 0 };
	double hi[3], volume = 1, longest = 0, edge;

	ts_bounds(team, p->n, (const double(*)[3])p->x, g.lo, hi);
	for (int d = 0; d < 3; d++)
		longest = fmax(longest, hi[d] - g.lo[d]);
	for (int d = 0; d < 3; d++) /* also for flat and thin bounding boxes */
		volume *= fmax(hi[d] - g.lo[d], 1e-3 * longest);
	edge = cbrt(volume / (double)p->n);
	g.inverse = edge > 0 ? 1 / edge : 0;
	for (int d = 0; d < 3; d++)
		g.cells[d] = (size_t)((hi[d] - g.lo[d]) * g.inverse) + 1;
	number_cells(&g);
	return g;
}

static size_t cell_of(const struct grid *g, const double x[3])
{
	size_t cell = 0;

	for (int d = 0; d < 3; d++)
		cell += g->stride[d] * (size_t)((x[d] - g->lo[d]) * g->inverse);
	return cell;
}

/* Members of a rigid body that follow one another are sorted as one, by the cell of the first of them, so that sums
 * over a body and the places of its members are read and written in order; those farther from it than this number
 * of edges of a cell begin anew, so that a large body is sorted by place. */
enum { NEAR = 4 };

struct first_member {
	int32_t body; /* 0: none */
	const double *x;
	size_t cell;
};

static bool near(const struct grid *g, const double a[3], const double b[3])
{
	for (int d = 0; d < 3; d++)
		if (!(fabs(a[d] - b[d]) * g->inverse < NEAR))
			return false;
	return true;
}

/* The cell by which particle i is sorted, after the one for which this was called before. */
static size_t sort_cell(const struct ts_particles *p, const struct grid *g, size_t i,
			struct first_member *first)
{
	const double *x = p->x[i];

	if (p->body && p->body[i] && p->body[i] == first->body && near(g, x, first->x))
		return first->cell;
	*first = (struct first_member){ p->body ? p->body[i] : 0, x, cell_of(g, x) };
	return first->cell;
}

/* Counting sort by cell; within a cell by identity. */
static void counting_sort(const struct ts_particles *p, const struct grid *g, const struct ts_identities *map,
			  int32_t *cell, int32_t *start, int32_t *order)
{
	struct first_member first = { 0 };

	for (size_t k = 0; k < map->n; k++) {
		cell[k] = (int32_t)sort_cell(p, g, (size_t)map->row[k], &first);
		start[cell[k] + 1]++;
	}
	for (size_t c = 0; c < g->n; c++)
		start[c + 1] += start[c];
	for (size_t k = 0; k < map->n; k++)
		order[start[cell[k]]++] = map->row[k];
}

struct place_task {
	const struct ts_particles *p;
	const struct grid *g;
};

/* The first of the particles up to i, without a gap, that are members of its body. */
static size_t first_of_body(const struct ts_particles *p, size_t i)
{
	while (i > 0 && p->body && p->body[i] && p->body[i - 1] == p->body[i])
		i--;
	return i;
}

/* Sorting moves all columns, so a few particles that have changed their cell are tolerated: in a random order
 * half of the particles are in an earlier cell than the one before them. */
static long count_descents(void *context, size_t from, size_t to)
{
	const struct place_task *t = context;
	struct first_member first = { 0 };
	size_t before = 0;
	long descents = 0;

	for (size_t i = from ? first_of_body(t->p, from - 1) : 0; i < to; i++) {
		size_t cell = sort_cell(t->p, t->g, i, &first);

		descents += i >= from && cell < before;
		before = cell;
	}
	return descents;
}

static bool well_ordered(const struct ts_particles *p, const struct grid *g, int team)
{
	struct place_task t = { .p = p, .g = g };

	return (size_t)ts_parallel_count(team, p->n, count_descents, &t) <= p->n / 16;
}

enum ts_status ts_order_by_place(struct tsim *sim)
{
	const struct ts_particles *p = sim->particles;
	struct ts_identities map;
	struct grid g;
	int32_t *cell, *start, *order;
	enum ts_status status = TS_OK;
	int team = ts_team(sim, 4 * p->n);

	if (p->n < TS_ORDER_LEAST)
		return TS_OK;
	g = make_grid(p, team);
	if (well_ordered(p, &g, team))
		return TS_OK;
	TS_TRY(ts_identities(sim, true, &map));
	cell = ts_alloc(p->n, sizeof *cell);
	start = ts_alloc(g.n + 1, sizeof *start);
	order = ts_alloc(p->n, sizeof *order);
	if (!cell || !start || !order) {
		status = ts_nomem(&sim->error);
	} else {
		counting_sort(p, &g, &map, cell, start, order);
		status = ts_particles_reorder(sim, order);
	}
	ts_free(cell);
	ts_free(start);
	ts_free(order);
	return status;
}
