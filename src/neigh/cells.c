#include "neigh/cells.h"

#include <math.h>
#include <string.h>

#include "particle/particles.h"

#include "base/banned.h"

static void bounding_box(const struct ts_particles *p, size_t n, double lo[3], double hi[3])
{
	for (int d = 0; d < 3; d++) {
		lo[d] = INFINITY;
		hi[d] = -INFINITY;
	}
	for (size_t i = 0; i < n; i++) {
		for (int d = 0; d < 3; d++) {
			double x = p->xhold[i][d];

			lo[d] = x < lo[d] ? x : lo[d];
			hi[d] = x > hi[d] ? x : hi[d];
		}
	}
}

/* Level l has the radii r with rmax/2^(l+1) < r <= rmax/2^l; the last level also all smaller ones. */
static void assign_levels(struct ts_cells *cells, const struct ts_particles *p, size_t n)
{
	double rmax = 0;

	for (size_t i = 0; i < n; i++)
		rmax = p->radius[i] > rmax ? p->radius[i] : rmax;
	cells->nlevels = 1;
	for (size_t i = 0; i < n; i++) {
		int level = 0;
		double bound = rmax / 2;

		while (p->radius[i] <= bound && level < TS_MAX_LEVELS - 1) {
			level++;
			bound /= 2;
		}
		cells->level_of[i] = (uint8_t)level;
		if (level >= cells->nlevels)
			cells->nlevels = level + 1;
	}
	for (int l = 0; l < cells->nlevels; l++)
		cells->level[l].reach = ldexp(rmax, -l);
}

/* Cells at least as large as the contact distance on the level plus the skin; enlarged until there are at
 * most 4 n + 64, so that sparse systems do not need much memory. */
static enum ts_status size_grid(struct tsim *sim, struct ts_level *level, const double lo[3],
				const double hi[3], double skin, size_t n)
{
	double size = 2 * level->reach + skin, most = 4.0 * (double)n + 64;
	double count;

	if (!(size > 0))
		size = 1;
	for (;; size *= 1.3) {
		count = 1;
		for (int d = 0; d < 3; d++)
			count *= floor((hi[d] - lo[d]) / size) + 1;
		if (count <= most)
			break;
	}
	for (int d = 0; d < 3; d++) {
		level->lo[d] = lo[d];
		level->inverse[d] = 1 / size;
		level->cells[d] = (int)floor((hi[d] - lo[d]) / size) + 1;
	}
	if (TS_GROW(level->start, level->start_capacity, (size_t)count + 2) != TS_OK)
		return ts_nomem(&sim->error);
	memset(level->start, 0, ((size_t)count + 2) * sizeof *level->start);
	return TS_OK;
}

static int cell_index(const struct ts_level *level, int dim, double x)
{
	double c = (x - level->lo[dim]) * level->inverse[dim];

	if (!(c > 0))
		return 0;
	return c < level->cells[dim] ? (int)c : level->cells[dim] - 1;
}

static void append_particle(struct ts_level *level, int32_t at, const struct ts_particles *p, size_t i)
{
	level->list[at] = (long long)i;
	for (int d = 0; d < 3; d++)
		level->position[d][at] = p->xhold[i][d];
	level->position[3][at] = p->radius[i];
}

static enum ts_status reserve_list(struct ts_level *level, size_t n)
{
	TS_TRY(TS_GROW(level->list, level->list_capacity, n + 3));
	for (int c = 0; c < 4; c++)
		TS_TRY(TS_GROW(level->position[c], level->position_capacity[c], n + 3));
	return TS_OK;
}

static enum ts_status fill_level(struct tsim *sim, struct ts_cells *cells, int l, size_t n)
{
	const struct ts_particles *p = sim->particles;
	struct ts_level *level = &cells->level[l];
	size_t ncells = (size_t)level->cells[0] * (size_t)level->cells[1] * (size_t)level->cells[2];

	for (size_t i = 0; i < n; i++) {
		const double *x = p->xhold[i];

		if (cells->level_of[i] != l)
			continue;
		cells->cell_of[i] = cell_index(level, 0, x[0]) +
				    level->cells[0] * (cell_index(level, 1, x[1]) +
						       level->cells[1] * cell_index(level, 2, x[2]));
		level->start[cells->cell_of[i] + 2]++;
	}
	for (size_t c = 2; c < ncells + 2; c++)
		level->start[c] += level->start[c - 1];
	if (reserve_list(level, (size_t)level->start[ncells + 1]) != TS_OK)
		return ts_nomem(&sim->error);
	for (size_t i = 0; i < n; i++)
		if (cells->level_of[i] == l)
			append_particle(level, level->start[cells->cell_of[i] + 1]++, p, i);
	return TS_OK;
}

enum ts_status ts_cells_fill(struct tsim *sim, struct ts_cells *cells, double skin)
{
	const struct ts_particles *p = sim->particles;
	size_t n = p->n + p->nghost;
	double lo[3], hi[3];

	if (!n) {
		cells->nlevels = 0;
		return TS_OK;
	}
	if (TS_GROW(cells->level_of, cells->capacity, n) != TS_OK ||
	    TS_GROW(cells->cell_of, cells->cell_capacity, n) != TS_OK)
		return ts_nomem(&sim->error);
	bounding_box(p, n, lo, hi);
	assign_levels(cells, p, n);
	for (int l = 0; l < cells->nlevels; l++) {
		TS_TRY(size_grid(sim, &cells->level[l], lo, hi, skin, n));
		TS_TRY(fill_level(sim, cells, l, n));
	}
	return TS_OK;
}

void ts_cells_range(const struct ts_level *level, const double x[3], double distance, int lo[3], int hi[3])
{
	for (int d = 0; d < 3; d++) {
		lo[d] = cell_index(level, d, x[d] - distance);
		hi[d] = cell_index(level, d, x[d] + distance);
	}
}

void ts_cells_release(struct ts_cells *cells)
{
	for (int l = 0; l < TS_MAX_LEVELS; l++) {
		ts_free(cells->level[l].start);
		ts_free(cells->level[l].list);
		for (int c = 0; c < 4; c++)
			ts_free(cells->level[l].position[c]);
	}
	ts_free(cells->level_of);
	ts_free(cells->cell_of);
	*cells = (struct ts_cells){ 0 };
}
