#include "poisson/multigrid.h"

#include <string.h>

#include "base/alloc.h"
#include "base/clones.h"
#include "poisson/multigrid_slabs.h"

#include "base/banned.h"

enum {
	FEWEST = 16,  /* approximate number of cells of the coarsest level */
	SWEEPS = 8,   /* on the coarsest level, in each direction */
	GRAIN = 4096, /* cells per thread */
};

/* Axes along which cells are merged: those with cells nearly as narrow as the narrowest. */
static bool choose_axes(const struct ts_stencil *s, struct ts_multigrid_transfer transfer[3])
{
	double width[3], least = 0;
	bool any = false;

	for (int d = 0; d < 3; d++) {
		width[d] = 0;
		for (int i = 0; i < s->n[d]; i++)
			width[d] += s->width[d][i] / s->n[d];
		if (d < s->axes && s->n[d] > 1 && (least == 0 || width[d] < least))
			least = width[d];
	}
	for (int d = 0; d < 3; d++) {
		transfer[d].joined = d < s->axes && s->n[d] > 1 && width[d] < 1.5 * least;
		any = any || transfer[d].joined;
	}
	return any && s->n[0] * s->n[1] * s->n[2] > FEWEST;
}

static int first_fine_cell(const struct ts_multigrid_level *l, int d, int coarse)
{
	if (!l->transfer[d].joined)
		return coarse;
	return coarse < l->s.n[d] / 2 ? 2 * coarse : l->s.n[d];
}

static enum ts_status make_stencil(const struct ts_multigrid_level *fine, struct ts_stencil *s)
{
	const struct ts_stencil *f = &fine->s;
	int n[3];

	for (int d = 0; d < 3; d++)
		n[d] = fine->transfer[d].joined ? f->n[d] / 2 : f->n[d];
	TS_TRY(ts_stencil_shape(s, n, f->axes, f->periodic, f->sparse));
	s->singular = f->singular;
	s->threads = 1 + n[0] * n[1] * n[2] / GRAIN;
	s->threads = s->threads < f->threads ? s->threads : f->threads;
	for (int d = 0; d < 3; d++) {
		for (int c = 0; c < n[d]; c++)
			for (int i = first_fine_cell(fine, d, c); i < first_fine_cell(fine, d, c + 1); i++)
				s->width[d][c] += f->width[d][i];
		for (int c = 1; c < n[d]; c++)
			s->conductance[d][c] = 2 / (s->width[d][c - 1] + s->width[d][c]);
		/* as the finer level: periodic, across half a cell, or not at all */
		if (f->conductance[d][0] > 0)
			s->conductance[d][0] =
				2 / (s->width[d][0] + (f->periodic[d] ? s->width[d][n[d] - 1] : 0));
		if (f->conductance[d][f->n[d]] > 0)
			s->conductance[d][n[d]] =
				2 / (s->width[d][n[d] - 1] + (f->periodic[d] ? s->width[d][0] : 0));
	}
	return TS_OK;
}

/* Centre of cell i of an axis; of the ghosts: the image, the face with the given value, or the cell's own. */
static double cell_centre(const struct ts_stencil *s, int d, int i)
{
	double x = 0, length = 0;
	int n = s->n[d];

	for (int k = 0; k < n; k++)
		length += s->width[d][k];
	if (i < 0 || i >= n) {
		if (s->periodic[d])
			return i < 0 ? cell_centre(s, d, n - 1) - length : cell_centre(s, d, 0) + length;
		return i < 0 ? 0 : length;
	}
	for (int k = 0; k < i; k++)
		x += s->width[d][k];
	return x + 0.5 * s->width[d][i];
}

/* Prolongation: the coarse cells beside each fine cell. */
static void set_prolongation_cells(const struct ts_stencil *fine, const struct ts_stencil *coarse,
				   struct ts_multigrid_transfer *transfer, int d)
{
	for (int c = 0; c < coarse->n[d]; c++)
		for (int i = transfer->begin[c]; i < transfer->begin[c + 1]; i++) {
			double x = cell_centre(fine, d, i), here = cell_centre(coarse, d, c);
			int below = x < here ? c - 1 : c;
			double low = cell_centre(coarse, d, below), high = cell_centre(coarse, d, below + 1);
			bool beyond = (below < 0 && coarse->conductance[d][0] == 0) ||
				      (below + 1 == coarse->n[d] && coarse->conductance[d][below + 1] == 0);

			/* with zero gradient the value is continued */
			transfer->below[i] = beyond ? c : below;
			transfer->above[i] = beyond ? 0 : (x - low) / (high - low);
		}
}

/* The coarse cell on one side, and its weight; -1: there is none, or the value beyond is given. */
static int coarse_neighbour(const struct ts_multigrid_transfer *transfer, const struct ts_stencil *coarse,
			    int d, int i, int side, double *share)
{
	int at = transfer->below[i] + side, n = coarse->n[d];

	*share = side ? transfer->above[i] : 1 - transfer->above[i];
	if (*share == 0)
		return -1;
	if (coarse->periodic[d])
		return (at + n) % n;
	return at < n ? at : -1;
}

/* Restriction: the transpose, for each coarse cell. */
static void fill_cells(const struct ts_stencil *coarse, struct ts_multigrid_transfer *transfer, int d, int n)
{
	double share;
	int at = 0;

	for (int c = 0; c < coarse->n[d]; c++) {
		transfer->first[c] = at;
		for (int i = 0; i < n; i++)
			for (int side = 0; side < 2; side++)
				if (coarse_neighbour(transfer, coarse, d, i, side, &share) == c) {
					transfer->cell[at] = i;
					transfer->weight[at++] = share;
				}
	}
	transfer->first[coarse->n[d]] = at;
}

static enum ts_status make_transfer(struct ts_multigrid_level *fine, const struct ts_stencil *coarse)
{
	for (int d = 0; d < 3; d++) {
		struct ts_multigrid_transfer *transfer = &fine->transfer[d];
		size_t n = (size_t)fine->s.n[d], m = (size_t)coarse->n[d] + 1;

		transfer->begin = ts_alloc(2 * m + 3 * n, sizeof *transfer->begin);
		transfer->above = ts_alloc(3 * n, sizeof *transfer->above);
		if (!transfer->begin || !transfer->above)
			return TS_NOMEM;
		transfer->first = transfer->begin + m;
		transfer->below = transfer->first + m;
		transfer->cell = transfer->below + n;
		transfer->weight = transfer->above + n;
		for (int c = 0; c <= coarse->n[d]; c++)
			transfer->begin[c] = first_fine_cell(fine, d, c);
		set_prolongation_cells(&fine->s, coarse, transfer, d);
		fill_cells(coarse, transfer, d, fine->s.n[d]);
	}
	fine->row = ts_alloc_pages((size_t)ts_stencil_rows(coarse) * (size_t)fine->s.n[0], sizeof(double),
				   fine->s.sparse);
	return fine->row ? TS_OK : TS_NOMEM;
}

static enum ts_status make_levels(struct ts_multigrid *m, const struct ts_stencil *finest)
{
	*m = (struct ts_multigrid){ .finest = finest };
	m->level[0].s = *finest;
	for (m->levels = 1; m->levels < TS_LEVELS; m->levels++) {
		struct ts_multigrid_level *fine = &m->level[m->levels - 1], *coarse = fine + 1;

		fine->r = ts_stencil_field(&fine->s);
		if (!fine->r)
			return TS_NOMEM;
		if (!choose_axes(&fine->s, fine->transfer))
			return TS_OK;
		TS_TRY(make_stencil(fine, &coarse->s));
		TS_TRY(make_transfer(fine, &coarse->s));
		coarse->p = ts_stencil_field(&coarse->s);
		coarse->b = ts_stencil_field(&coarse->s);
		coarse->rhs = coarse->b;
		if (!coarse->p || !coarse->b)
			return TS_NOMEM;
	}
	return TS_OK;
}

enum ts_status ts_multigrid_make(struct ts_multigrid *m, const struct ts_stencil *finest,
				 const struct ts_slabs *slabs)
{
	TS_TRY(make_levels(m, finest));
	return slabs && slabs->world ? ts_multigrid_divide(m, slabs->world) : TS_OK;
}

void ts_multigrid_release(struct ts_multigrid *m)
{
	for (int k = 0; k < TS_LEVELS; k++) {
		struct ts_multigrid_level *l = &m->level[k];

		for (int d = 0; d < 3; d++) {
			ts_free(l->transfer[d].begin);
			ts_free(l->transfer[d].above);
		}
		ts_slabs_release(&l->slabs);
		ts_free_pages(l->row);
		ts_stencil_field_free(l->r);
		ts_stencil_field_free(l->p);
		ts_stencil_field_free(l->b);
		if (k > 0) /* the first one is another's */
			ts_stencil_release(&l->s);
	}
	*m = (struct ts_multigrid){ 0 };
}

/* Link of a coarse face: sum of the fine links in it, scaled by the larger distance. */
static double joined_link(const struct ts_multigrid_level *fine, const struct ts_stencil *coarse, int d,
			  int i, int j, int k)
{
	const int face[3] = { i, j, k };
	int from[3], to[3];
	double sum = 0, conduct;

	for (int a = 0; a < 3; a++) {
		from[a] = fine->transfer[a].begin[face[a]];
		to[a] = a == d ? from[a] + 1 : fine->transfer[a].begin[face[a] + 1];
	}
	conduct = fine->s.conductance[d][from[d]];
	if (conduct == 0)
		return 0;
	for (int z = from[2]; z < to[2]; z++)
		for (int y = from[1]; y < to[1]; y++)
			for (int x = from[0]; x < to[0]; x++)
				sum += fine->s.link[d][ts_stencil_at(&fine->s, x, y, z)];
	return sum * (coarse->conductance[d][face[d]] / conduct);
}

/* Of the planes of this rank, while it has a slab of this level. */
static void set_coarse_weights(const struct ts_multigrid_level *fine, struct ts_multigrid_level *level)
{
	struct ts_stencil *coarse = &level->s;

	for (int d = 0; d < coarse->axes; d++) {
		const int ny = coarse->n[1] + (d == 1);
		long first, end;

		ts_slabs_rows(&level->slabs, coarse->n[2], ny, d == 2, &first, &end);
#pragma omp parallel for num_threads(coarse->threads) schedule(static)
		for (long row = first; row < end; row++)
			for (int i = 0; i < coarse->n[0] + (d == 0); i++)
				coarse->link[d][ts_stencil_at(coarse, i, (int)row % ny, (int)row / ny)] =
					joined_link(fine, coarse, d, i, (int)row % ny, (int)row / ny);
	}
	ts_multigrid_share_links(level);
	ts_stencil_invert_diagonal(coarse);
}

void ts_multigrid_set_weights(struct ts_multigrid *m)
{
	ts_multigrid_set_slabs(m);
	for (int k = 1; k < m->levels; k++)
		set_coarse_weights(&m->level[k - 1], &m->level[k]);
}

void ts_multigrid_rehearse_weights(struct ts_multigrid *m)
{
	ts_multigrid_set_slabs(m);
	for (int k = 1; k < m->levels; k++)
		ts_multigrid_share_links(&m->level[k]);
}

TS_CLONES
static void add_scaled(const double *restrict x, double scale, double *restrict y, int n)
{
#pragma omp simd
	for (int i = 0; i < n; i++)
		y[i] += scale * x[i];
}

/* Adds to p of a row the interpolated correction. `row`: work memory for a row of the coarse level, with
 * ghosts. */
static void prolong_row(const struct ts_multigrid_level *fine, const struct ts_multigrid_level *coarse, int j,
			int k, double *row)
{
	const int *below = fine->transfer[0].below;
	const double *above = fine->transfer[0].above;
	double *p = fine->p + ts_stencil_at(&fine->s, 0, j, k);

	memset(row, 0, ((size_t)coarse->s.n[0] + 2) * sizeof *row);
	for (int side = 0; side < 4; side++) {
		double share[2];
		int y = coarse_neighbour(&fine->transfer[1], &coarse->s, 1, j, side & 1, &share[0]);
		int z = coarse_neighbour(&fine->transfer[2], &coarse->s, 2, k, side >> 1, &share[1]);

		if (y >= 0 && z >= 0)
			add_scaled(coarse->p + ts_stencil_at(&coarse->s, -1, y, z), share[0] * share[1], row,
				   coarse->s.n[0] + 2);
	}
	for (int i = 0; i < fine->s.n[0]; i++)
		p[i] += (1 - above[i]) * row[below[i] + 1] + above[i] * row[below[i] + 2];
}

/* The transpose: a row of coarse cells sums over the fine cells beside them. */
static void restrict_row(const struct ts_multigrid_level *fine, const struct ts_multigrid_level *coarse,
			 int j, int k, double *row)
{
	const struct ts_multigrid_transfer *x = &fine->transfer[0], *y = &fine->transfer[1],
					   *z = &fine->transfer[2];
	double *b = coarse->b + ts_stencil_at(&coarse->s, 0, j, k);

	memset(row, 0, (size_t)fine->s.n[0] * sizeof *row);
	for (int m = z->first[k]; m < z->first[k + 1]; m++)
		for (int l = y->first[j]; l < y->first[j + 1]; l++)
			add_scaled(fine->r + ts_stencil_at(&fine->s, 0, y->cell[l], z->cell[m]),
				   y->weight[l] * z->weight[m], row, fine->s.n[0]);
	for (int i = 0; i < coarse->s.n[0]; i++) {
		double sum = 0;

		for (int l = x->first[i]; l < x->first[i + 1]; l++)
			sum += x->weight[l] * row[x->cell[l]];
		b[i] = sum;
	}
}

static void restrict_residual(struct ts_multigrid_level *fine, struct ts_multigrid_level *coarse)
{
	long first, end;

	ts_stencil_residual(&fine->s, fine->p, fine->rhs, fine->r);
	ts_multigrid_share_residual(fine);
	ts_slabs_rows(&coarse->slabs, coarse->s.n[2], coarse->s.n[1], 0, &first, &end);
#pragma omp parallel for num_threads(coarse->s.threads) schedule(static)
	for (long row = first; row < end; row++)
		restrict_row(fine, coarse, (int)(row % coarse->s.n[1]), (int)(row / coarse->s.n[1]),
			     fine->row + (size_t)row * (size_t)fine->s.n[0]);
	ts_multigrid_share_rhs(coarse);
}

static void prolong_correction(struct ts_multigrid_level *fine, struct ts_multigrid_level *coarse)
{
	int first, end;

	if (coarse->s.slabs)
		ts_stencil_ghosts_beside(&coarse->s, coarse->p, fine->correction.below,
					 fine->correction.above);
	ts_stencil_own(&fine->s, &first, &end);
#pragma omp parallel for num_threads(fine->s.threads) schedule(static)
	for (int row = first; row < end;
	     row++) /* the residual is not needed any more: its memory holds rows */
		prolong_row(fine, coarse, row % fine->s.n[1], row / fine->s.n[1],
			    fine->r + ts_stencil_row(&fine->s, row) - 1);
	ts_stencil_ghosts(&fine->s, fine->p);
}

static void sweep_up(const struct ts_multigrid_level *l)
{
	for (int colour = 0; colour < l->s.colours; colour++)
		ts_stencil_sweep(&l->s, l->p, l->rhs, colour, 1);
}

static void sweep_down(const struct ts_multigrid_level *l)
{
	for (int colour = l->s.colours - 1; colour >= 0; colour--)
		ts_stencil_sweep(&l->s, l->p, l->rhs, colour, 1);
}

/* As many sweeps in reverse order as in forward order: symmetric. */
static void solve_coarsest(const struct ts_multigrid_level *l)
{
	for (int k = 0; k < SWEEPS; k++)
		sweep_up(l);
	for (int k = 0; k < SWEEPS; k++)
		sweep_down(l);
}

void ts_multigrid_cycle(void *multigrid, const double *r, double *z)
{
	struct ts_multigrid *m = multigrid;
	struct ts_multigrid_level *l = m->level;
	int last = m->levels - 1;

	l[0].p = z;
	l[0].rhs = r;
	ts_multigrid_set_slabs(m);
	for (int k = 0; k <= last; k++) {
		ts_stencil_clear(&l[k].s, l[k].p);
		if (k == last)
			break;
		sweep_up(&l[k]);
		restrict_residual(&l[k], &l[k + 1]);
	}
	solve_coarsest(&l[last]);
	for (int k = last - 1; k >= 0; k--) {
		prolong_correction(&l[k], &l[k + 1]);
		sweep_down(&l[k]);
	}
	l[0].p = NULL;
}
