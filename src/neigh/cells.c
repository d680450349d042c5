#include "neigh/cells.h"

#include <math.h>
#include <string.h>

#include "base/clones.h"
#include "base/inline.h"
#include "base/parallel.h"
#include "particle/particles.h"

#include "base/banned.h"

/* What one share (one thread) finds about its particles. */
struct extent {
	double lo[3], hi[3], largest; /* box around the centres, and the largest radius, length */
	int levels;
};

struct fill_task {
	const struct ts_particles *p;
	struct ts_cells *cells;
	size_t n, ncells; /* of all levels */
	int shares;
	struct extent all, *share;
};

/* The particles of share t: from .. to-1. */
static void particles_of(const struct fill_task *f, size_t t, size_t *from, size_t *to)
{
	*from = f->n * t / (size_t)f->shares;
	*to = f->n * (t + 1) / (size_t)f->shares;
}

/* ---- extent of the particles */

TS_CLONES static void measure(const struct ts_particles *p, size_t from, size_t to, struct extent *e)
{
	double lo[3] = { INFINITY, INFINITY, INFINITY }, hi[3] = { -INFINITY, -INFINITY, -INFINITY };
	double largest = 0;

	for (size_t i = from; i < to; i++) {
		for (int d = 0; d < 3; d++) {
			double x = p->xhold[i][d];

			lo[d] = x < lo[d] ? x : lo[d];
			hi[d] = x > hi[d] ? x : hi[d];
		}
		largest = p->radius[i] > largest ? p->radius[i] : largest;
	}
	memcpy(e->lo, lo, sizeof lo);
	memcpy(e->hi, hi, sizeof hi);
	e->largest = largest;
}

static void measure_shares(void *context, size_t from, size_t to)
{
	const struct fill_task *f = context;
	size_t first, end;

	for (size_t t = from; t < to; t++) {
		particles_of(f, t, &first, &end);
		measure(f->p, first, end, &f->share[t]);
	}
}

static void measure_all(struct fill_task *f)
{
	ts_parallel(f->shares, (size_t)f->shares, measure_shares, f);
	f->all = f->share[0];
	for (int t = 1; t < f->shares; t++) {
		for (int d = 0; d < 3; d++) {
			f->all.lo[d] = fmin(f->all.lo[d], f->share[t].lo[d]);
			f->all.hi[d] = fmax(f->all.hi[d], f->share[t].hi[d]);
		}
		f->all.largest = fmax(f->all.largest, f->share[t].largest);
	}
}

/* ---- levels and cells of the particles */

/* Cells at least as large as the contact distance on the level plus the skin; enlarged until there are at
 * most 4 n + 64, so that sparse systems do not need much memory. */
static void size_grid(const struct fill_task *f, struct ts_level *level, double skin)
{
	const double *lo = f->all.lo, *hi = f->all.hi;
	double size = 2 * level->reach + skin, most = 4.0 * (double)f->n + 64;
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
	level->ncells = (size_t)count;
}

TS_INLINE int cell_index(const struct ts_level *level, int dim, double x)
{
	double c = (x - level->lo[dim]) * level->inverse[dim];

	if (!(c > 0))
		return 0;
	return c < level->cells[dim] ? (int)c : level->cells[dim] - 1;
}

/* Level l has the radii r with rmax/2^(l+1) < r <= rmax/2^l; the last level also all smaller ones. */
TS_INLINE int level_of_radius(double largest, double radius)
{
	double bound = largest / 2;
	int level = 0;

	while (radius <= bound && level < TS_MAX_LEVELS - 1) {
		level++;
		bound /= 2;
	}
	return level;
}

static void assign_shares(void *context, size_t from, size_t to)
{
	const struct fill_task *f = context;
	struct ts_cells *cells = f->cells;
	size_t first, end;

	for (size_t t = from; t < to; t++) {
		int levels = 1;

		particles_of(f, t, &first, &end);
		for (size_t i = first; i < end; i++) {
			int l = level_of_radius(f->all.largest, f->p->radius[i]);
			const struct ts_level *level = &cells->level[l];
			const double *x = f->p->xhold[i];

			levels = l >= levels ? l + 1 : levels;
			cells->level_of[i] = (uint8_t)l;
			cells->cell_of[i] = cell_index(level, 0, x[0]) +
					    level->cells[0] * (cell_index(level, 1, x[1]) +
							       level->cells[1] * cell_index(level, 2, x[2]));
		}
		f->share[t].levels = levels;
	}
}

static void assign_all(struct fill_task *f, double skin)
{
	struct ts_cells *cells = f->cells;

	for (int l = 0; l < TS_MAX_LEVELS; l++) {
		cells->level[l].reach = ldexp(f->all.largest, -l);
		size_grid(f, &cells->level[l], skin);
	}
	ts_parallel(f->shares, (size_t)f->shares, assign_shares, f);
	cells->nlevels = 1;
	for (int t = 0; t < f->shares; t++)
		cells->nlevels = f->share[t].levels > cells->nlevels ? f->share[t].levels : cells->nlevels;
}

/* ---- lists of the cells: a counting sort. Each share lists its particles behind those of the shares before. */

TS_INLINE int32_t *place_of(const struct fill_task *f, size_t share, size_t i)
{
	const struct ts_cells *cells = f->cells;

	return &cells->place[share * f->ncells + cells->level[cells->level_of[i]].first +
			     (size_t)cells->cell_of[i]];
}

static void count_shares(void *context, size_t from, size_t to)
{
	const struct fill_task *f = context;
	size_t first, end;

	for (size_t t = from; t < to; t++) {
		memset(f->cells->place + t * f->ncells, 0, f->ncells * sizeof *f->cells->place);
		particles_of(f, t, &first, &end);
		for (size_t i = first; i < end; i++)
			++*place_of(f, t, i);
	}
}

static void counts_to_places(const struct fill_task *f, struct ts_level *level)
{
	int32_t sum = 0;

	for (size_t c = 0; c < level->ncells; c++) {
		int32_t *place = f->cells->place + level->first + c;

		level->start[c] = sum;
		for (int t = 0; t < f->shares; t++, place += f->ncells) {
			int32_t count = *place;

			*place = sum;
			sum += count;
		}
	}
	level->start[level->ncells] = sum;
}

static void list_shares(void *context, size_t from, size_t to)
{
	const struct fill_task *f = context;
	size_t first, end;

	for (size_t t = from; t < to; t++) {
		particles_of(f, t, &first, &end);
		for (size_t i = first; i < end; i++) {
			const struct ts_level *level = &f->cells->level[f->cells->level_of[i]];
			int32_t at = (*place_of(f, t, i))++;

			level->list[at] = (long long)i;
			for (int d = 0; d < 3; d++)
				level->position[d][at] = f->p->xhold[i][d];
			level->position[3][at] = f->p->radius[i];
		}
	}
}

/* Allocates the list of n particles; the entries behind it, which are read, too, are zero. */
static enum ts_status reserve_list(struct ts_level *level, size_t n)
{
	enum { BEHIND = TS_CELLS_VECTOR - 1 };

	TS_TRY(TS_RENEW_UNSET(level->list, level->list_capacity, n + BEHIND));
	memset(level->list + n, 0, BEHIND * sizeof *level->list);
	for (int c = 0; c < 4; c++) {
		TS_TRY(TS_RENEW_UNSET(level->position[c], level->position_capacity[c], n + BEHIND));
		memset(level->position[c] + n, 0, BEHIND * sizeof *level->position[c]);
	}
	return TS_OK;
}

static enum ts_status list_all(struct fill_task *f)
{
	struct ts_cells *cells = f->cells;

	f->ncells = 0;
	for (int l = 0; l < cells->nlevels; l++) {
		cells->level[l].first = f->ncells;
		f->ncells += cells->level[l].ncells;
	}
	TS_TRY(TS_RENEW_UNSET(cells->place, cells->place_capacity, (size_t)f->shares * f->ncells));
	ts_parallel(f->shares, (size_t)f->shares, count_shares, f);
	for (int l = 0; l < cells->nlevels; l++) {
		struct ts_level *level = &cells->level[l];

		TS_TRY(TS_RENEW_UNSET(level->start, level->start_capacity, level->ncells + 1));
		counts_to_places(f, level);
		TS_TRY(reserve_list(level, (size_t)level->start[level->ncells]));
	}
	ts_parallel(f->shares, (size_t)f->shares, list_shares, f);
	return TS_OK;
}

/* Counts of cells by share take memory, so there are not more shares than this. */
enum { MOST_SHARES = 8 };

enum ts_status ts_cells_fill(struct tsim *sim, struct ts_cells *cells, double skin)
{
	size_t n = sim->particles->n + sim->particles->nghost;
	int team = ts_team(sim, 4 * n); /* as much work as several simple loops */
	struct extent share[MOST_SHARES];
	struct fill_task f = { .p = sim->particles,
			       .cells = cells,
			       .n = n,
			       .shares = team < MOST_SHARES ? team : MOST_SHARES,
			       .share = share };

	cells->nlevels = 0;
	if (!n)
		return TS_OK;
	if (TS_RENEW_UNSET(cells->level_of, cells->capacity, n) != TS_OK ||
	    TS_RENEW_UNSET(cells->cell_of, cells->cell_capacity, n) != TS_OK)
		return ts_nomem(&sim->error);
	measure_all(&f);
	assign_all(&f, skin);
	return list_all(&f) == TS_OK ? TS_OK : ts_nomem(&sim->error);
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
	ts_free(cells->place);
	*cells = (struct ts_cells){ 0 };
}
