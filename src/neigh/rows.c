#include "neigh/rows.h"

#include <math.h>
#include <string.h>

#include "base/parallel.h"
#include "neigh/cells.h"
#include "neigh/row_history.h"
#include "particles/particles.h"

#include "base/banned.h"

/* What one thread finds for its share of the particles. */
struct found {
	int32_t *i, *j;
	size_t n, capacity_i, capacity_j;
	enum ts_status status;
};

struct search {
	const struct tsim *sim;
	const struct ts_particles *p;
	const struct ts_cells *cells;
	double skin;
	bool both_held;
	ts_excluded_fn *excluded;
};

/* Of two locals the larger one owns the row; in one size class, the first in memory. */
static bool owns(const struct search *s, size_t i, size_t j)
{
	int a = s->cells->level_of[i], b = s->cells->level_of[j];

	return j >= s->p->n || b > a || (b == a && j > i);
}

static bool near(const struct search *s, size_t i, size_t j)
{
	const double *xi = s->p->xhold[i], *xj = s->p->xhold[j];
	double d[3] = { xi[0] - xj[0], xi[1] - xj[1], xi[2] - xj[2] };
	double reach = s->p->radius[i] + s->p->radius[j] + s->skin;

	return d[0] * d[0] + d[1] * d[1] + d[2] * d[2] < reach * reach;
}

static void keep(struct found *found, size_t i, size_t j)
{
	if (TS_GROW(found->i, found->capacity_i, found->n + 1) != TS_OK ||
	    TS_GROW(found->j, found->capacity_j, found->n + 1) != TS_OK) {
		found->status = TS_NOMEM;
		return;
	}
	found->i[found->n] = (int32_t)i;
	found->j[found->n++] = (int32_t)j;
}

static void search_run(const struct search *s, const struct ts_level *level, size_t i, int32_t from,
		       int32_t to, struct found *found)
{
	for (int32_t k = from; k < to; k++) {
		size_t j = (size_t)level->list[k];

		if (j == i || !owns(s, i, j) || !near(s, i, j))
			continue;
		if ((s->p->imass[i] == 0 && s->p->imass[j] == 0) != s->both_held)
			continue;
		if (s->excluded && s->excluded(s->sim, i, j))
			continue;
		keep(found, i, j);
	}
}

static void search_level(const struct search *s, int l, size_t i, struct found *found)
{
	const struct ts_level *level = &s->cells->level[l];
	int lo[3], hi[3];

	ts_cells_range(level, s->p->xhold[i], s->p->radius[i] + level->reach + s->skin, lo, hi);
	for (int z = lo[2]; z <= hi[2]; z++) {
		for (int y = lo[1]; y <= hi[1]; y++) {
			/* the cells of a row in x are neighbours in the list too */
			int row = level->cells[0] * (y + level->cells[1] * z);

			search_run(s, level, i, level->start[row + lo[0]],
				   level->start[row + hi[0] + 1], found);
		}
	}
}

static uint8_t image_of(const struct ts_particles *p, size_t j)
{
	return j < p->n ? TS_IMAGE_SELF : ts_image_code(p->ghost_shift[j - p->n]);
}

/* x_i - x_j + turns L is the distance of the unwrapped positions: it stays when one is wrapped. */
static int32_t winding_of(const struct ts_particles *p, size_t i, size_t j)
{
	size_t owner = j < p->n ? j : (size_t)p->ghost_owner[j - p->n];
	int32_t turns[3];

	for (int k = 0; k < 3; k++)
		turns[k] = p->image[i][k] - p->image[owner][k] +
			   (j < p->n ? 0 : p->ghost_shift[j - p->n][k]);
	return ts_winding(turns);
}

/* Order of partners: identity, then image. */
static bool before(const struct ts_particles *p, size_t a, size_t b)
{
	if (p->tag[a] != p->tag[b])
		return p->tag[a] < p->tag[b];
	return image_of(p, a) < image_of(p, b);
}

static void sort_partners(const struct ts_particles *p, int32_t *j, size_t n)
{
	for (size_t k = 1; k < n; k++) {
		int32_t partner = j[k];
		size_t at = k;

		for (; at && before(p, (size_t)partner, (size_t)j[at - 1]); at--)
			j[at] = j[at - 1];
		j[at] = partner;
	}
}

static void search_share(const struct search *s, size_t from, size_t to, struct found *found)
{
	found->n = 0;
	for (size_t i = from; i < to && found->status == TS_OK; i++) {
		size_t first = found->n;
		/* with ghosts, a small local must find the large ghosts itself */
		int l = s->p->nghost ? 0 : s->cells->level_of[i];

		for (; l < s->cells->nlevels; l++)
			search_level(s, l, i, found);
		sort_partners(s->p, found->j + first, found->n - first);
	}
}

static enum ts_status reserve(struct ts_rows *rows, size_t n)
{
	size_t capacity = rows->capacity, start = rows->capacity;
	size_t width = rows->history_width ? rows->history_width : 1, hcap = start * width;

#define GROW_COLUMN(column)                                                                        \
	do {                                                                                       \
		capacity = start;                                                                  \
		TS_TRY(TS_GROW(rows->column, capacity, n));                                        \
	} while (0)
	GROW_COLUMN(i);
	GROW_COLUMN(j);
	GROW_COLUMN(tag[0]);
	GROW_COLUMN(tag[1]);
	GROW_COLUMN(image);
	GROW_COLUMN(winding);
	GROW_COLUMN(force);
	GROW_COLUMN(touching);
	if (rows->turn) {
		GROW_COLUMN(turn);
		GROW_COLUMN(roll);
		GROW_COLUMN(half);
	}
#undef GROW_COLUMN
	if (rows->history_width)
		TS_TRY(ts_grow((void **)&rows->history, &hcap, capacity * width,
			       sizeof *rows->history));
	rows->capacity = capacity;
	return TS_OK;
}

static void fill_rows(struct ts_rows *rows, const struct ts_particles *p, const struct found *found,
		      int shares)
{
	size_t r = 0;

	for (int t = 0; t < shares; t++) {
		for (size_t k = 0; k < found[t].n; k++, r++) {
			size_t i = (size_t)found[t].i[k], j = (size_t)found[t].j[k];

			rows->i[r] = (int32_t)i;
			rows->j[r] = (int32_t)j;
			rows->tag[0][r] = p->tag[i];
			rows->tag[1][r] = p->tag[j];
			rows->image[r] = image_of(p, j);
			rows->winding[r] = winding_of(p, i, j);
			rows->touching[r] = 0;
		}
	}
	if (r)
		memset(rows->force, 0, r * sizeof *rows->force);
	if (r && rows->turn) {
		memset(rows->turn, 0, r * sizeof *rows->turn);
		memset(rows->roll, 0, r * sizeof *rows->roll);
		memset(rows->half, 0, r * sizeof *rows->half);
	}
	if (r && rows->history_width)
		memset(rows->history, 0, r * rows->history_width * sizeof *rows->history);
}

static size_t row_end(const void *list, size_t r, int side)
{
	const struct ts_rows *rows = list;

	return (size_t)(side ? rows->j[r] : rows->i[r]);
}

/* Order of partners: identity, then image. Seen from j, which is local, i is no image. */
static uint64_t partner_key(const void *list, size_t r, int side)
{
	const struct ts_rows *rows = list;

	return (uint64_t)rows->tag[!side][r] << 8 | (side ? TS_IMAGE_SELF : rows->image[r]);
}

static enum ts_status search_all(struct tsim *sim, const struct search *s, struct found *found,
				 int shares)
{
	size_t n = s->p->n, total = 0;

#pragma omp parallel for num_threads(shares) schedule(static, 1)
	for (int t = 0; t < shares; t++)
		search_share(s, n * (size_t)t / (size_t)shares,
			     n * (size_t)(t + 1) / (size_t)shares, &found[t]);
	for (int t = 0; t < shares; t++) {
		if (found[t].status != TS_OK)
			return ts_nomem(&sim->error);
		total += found[t].n;
	}
	if (total >= (size_t)INT32_MAX)
		return ts_fail(&sim->error, TS_RANGE, NULL,
			       "more than 2^31 pairs of neighbours: the skin is too large");
	return TS_OK;
}

static enum ts_status build(struct tsim *sim, struct ts_rows *rows, const struct search *s,
			    struct found *found, int shares)
{
	struct ts_row_history old = { 0 };
	enum ts_status status;
	size_t total = 0;

	TS_TRY(search_all(sim, s, found, shares));
	for (int t = 0; t < shares; t++)
		total += found[t].n;
	if (sim->legacy)
		TS_TRY(ts_row_history_take_memories(sim, rows, sim->resuming, &old));
	else
		TS_TRY(ts_row_history_take(sim, rows, sim->resuming, &old));
	status = reserve(rows, total);
	if (status == TS_OK) {
		rows->n = total;
		rows->particles = s->p->n;
		fill_rows(rows, s->p, found, shares);
		status = ts_row_history_give(sim, &old, rows);
	}
	if (status == TS_OK)
		status = ts_gather_index(&rows->gather, s->p->n, rows->n, row_end, partner_key,
					 rows);
	ts_row_history_release(&old);
	return status == TS_OK ? TS_OK : ts_nomem(&sim->error);
}

enum ts_status ts_rows_build(struct tsim *sim, struct ts_rows *rows, double skin,
			     ts_excluded_fn *excluded)
{
	struct ts_cells cells = { 0 };
	struct search s = { sim, sim->particles, &cells, skin, rows->both_held, excluded };
	int shares = ts_team(sim, sim->particles->n);
	struct found *found = ts_alloc((size_t)shares, sizeof *found);
	enum ts_status status;

	if (!found)
		return ts_nomem(&sim->error);
	status = ts_cells_fill(sim, &cells, skin);
	if (status == TS_OK)
		status = build(sim, rows, &s, found, shares);
	for (int t = 0; t < shares; t++) {
		ts_free(found[t].i);
		ts_free(found[t].j);
	}
	ts_free(found);
	ts_cells_release(&cells);
	return status;
}

struct torques {
	const struct ts_rows *rows;
	struct ts_particles *p;
};

static void torque_share(void *context, size_t from, size_t to)
{
	static const double signs[] = { 1, -1 };
	const struct torques *t = context;
	const struct ts_rows *rows = t->rows;
	const struct ts_gather *g = &rows->gather;

	for (size_t i = from; i < to; i++) {
		double total[3] = { 0 };

		for (size_t k = g->first[i]; k < g->first[i + 1]; k++) {
			uint32_t r = g->entry[k] >> 1;
			double sign = signs[g->entry[k] & 1], arm = t->p->radius[i] - rows->half[r];

			for (int d = 0; d < 3; d++)
				total[d] += arm * rows->turn[r][d] + sign * rows->roll[r][d];
		}
		for (int d = 0; d < 3; d++)
			t->p->torque[i][d] += total[d];
	}
}

void ts_rows_gather_torques(struct tsim *sim, const struct ts_rows *rows)
{
	struct torques t = { rows, sim->particles };

	ts_parallel(ts_team(sim, sim->particles->n), sim->particles->n, torque_share, &t);
}

static void free_torques(struct ts_rows *rows)
{
	ts_free(rows->turn);
	ts_free(rows->roll);
	ts_free(rows->half);
	rows->turn = rows->roll = NULL;
	rows->half = NULL;
}

enum ts_status ts_rows_set_torques(struct tsim *sim, struct ts_rows *rows, bool wanted)
{
	size_t n = rows->capacity ? rows->capacity : 1;

	if (wanted == (rows->turn != NULL))
		return TS_OK;
	free_torques(rows);
	if (!wanted)
		return TS_OK;
	rows->turn = ts_alloc_aligned(n, sizeof *rows->turn);
	rows->roll = ts_alloc_aligned(n, sizeof *rows->roll);
	rows->half = ts_alloc_aligned(n, sizeof *rows->half);
	if (rows->turn && rows->roll && rows->half)
		return TS_OK;
	free_torques(rows);
	return ts_nomem(&sim->error);
}

void ts_rows_release(struct ts_rows *rows)
{
	ts_free(rows->i);
	ts_free(rows->j);
	ts_free(rows->tag[0]);
	ts_free(rows->tag[1]);
	ts_free(rows->image);
	ts_free(rows->winding);
	ts_free(rows->force);
	ts_free(rows->touching);
	free_torques(rows);
	ts_free(rows->history);
	ts_gather_release(&rows->gather);
	*rows = (struct ts_rows){ 0 };
}
