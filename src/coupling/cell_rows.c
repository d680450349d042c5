#include "coupling/cell_rows.h"

#include <string.h>

#include "base/alloc.h"

#include "base/banned.h"

/* ---- which ranks have cells near a cell */

static enum ts_status make_senders(struct ts_cell_senders *s, const struct ts_cell_space *space, int reach)
{
	const struct ts_cell_owners *owners = space->owners;
	const size_t ncells = ts_cell_frame_cells(&space->frame), ranks = (size_t)owners->ranks;

	if (s->ranks == owners->ranks && s->reach == reach && s->made_for == owners->made_for &&
	    s->cells == ncells)
		return TS_OK;
	s->ranks = 0; /* until it is made */
	TS_TRY(TS_GROW(s->cell, s->cell_capacity, ncells));
	TS_TRY(TS_GROW(s->index, s->index_capacity, ranks));
	TS_TRY(TS_GROW(s->out, s->out_capacity, ranks));
	TS_TRY(TS_GROW(s->in, s->in_capacity, ranks));
	for (size_t c = 0; c < ncells; c++)
		s->cell[c].n = -1;
	s->nother = 0;
	s->made_for = owners->made_for;
	s->reach = reach;
	s->cells = ncells;
	s->ranks = owners->ranks;
	return TS_OK;
}

static enum ts_status add_other(struct ts_cell_senders *s, struct ts_cell_others *others, int32_t rank)
{
	for (int32_t k = 0; k < others->n; k++)
		if (s->other[others->first + k] == rank)
			return TS_OK;
	TS_TRY(TS_GROW(s->other, s->other_capacity, s->nother + 1));
	s->other[s->nother++] = rank;
	others->n++;
	return TS_OK;
}

/* The cells from *from to *to are at most `reach` from cell i of an axis; across a periodic face they go on below 0, or
 * from n on. */
static void span(const struct ts_grid *grid, int d, int i, int reach, int *from, int *to)
{
	const int n = grid->n[d];

	*from = i - reach;
	*to = i + reach;
	if (!grid->periodic[d]) {
		*from = *from < 0 ? 0 : *from;
		*to = *to >= n ? n - 1 : *to;
	} else if (2 * reach + 1 >= n) {
		*from = 0;
		*to = n - 1;
	}
}

static int wrapped(int i, int n)
{
	return i < 0 ? i + n : i >= n ? i - n : i;
}

/* Whether all these cells are in the box. */
static bool lies_in(const struct ts_cell_box *box, const int from[3], const int to[3])
{
	bool lies = true;

	for (int d = 0; d < 3; d++)
		lies &= from[d] >= box->from[d] && to[d] < box->to[d];
	return lies;
}

static enum ts_status find_others(struct ts_cell_senders *s, const struct ts_cell_space *space, int own,
				  int32_t cell, struct ts_cell_others *others)
{
	const struct ts_grid *grid = space->grid;
	const int *n = grid->n;
	int at[3], from[3], to[3];

	*others = (struct ts_cell_others){ .first = (int32_t)s->nother };
	for (int r = 0; space->owners->all && r < space->owners->ranks; r++)
		if (r != own)
			TS_TRY(add_other(s, others, r));
	ts_cell_frame_cell(&space->frame, cell, at);
	for (int d = 0; d < 3; d++)
		span(grid, d, at[d], s->reach, &from[d], &to[d]);
	if (space->owners->all || lies_in(&space->owners->box[own], from, to))
		return TS_OK;
	for (int k = from[2]; k <= to[2]; k++)
		for (int j = from[1]; j <= to[1]; j++)
			for (int i = from[0]; i <= to[0]; i++) {
				const double x[3] = { grid->centre[0][wrapped(i, n[0])],
						      grid->centre[1][wrapped(j, n[1])],
						      grid->centre[2][wrapped(k, n[2])] };
				const int rank = ts_rank_blocks_owner(space->blocks, x);

				if (rank != own)
					TS_TRY(add_other(s, others, rank));
			}
	return TS_OK;
}

/* ---- rows */

static enum ts_status pack_row(struct ts_cell_senders *s, const struct ts_cell_rows *rows, int32_t i,
			       int rank)
{
	struct ts_cell_row row = { .radius = rows->radius[i], .tag = rows->tag[i], .mask = rows->mask[i] };

	memcpy(row.x, rows->x[i], sizeof row.x);
	TS_TRY(ts_parcel_add(&s->index[rank], &i, sizeof i));
	return ts_parcel_add(&s->out[rank], &row, sizeof row);
}

static enum ts_status pack_rows(struct ts_cell_senders *s, const struct ts_cell_space *space, int own,
				const int32_t *cell, const struct ts_cell_rows *rows)
{
	for (int r = 0; r < s->ranks; r++)
		s->index[r].n = s->out[r].n = 0;
	for (size_t i = 0; i < rows->own; i++) {
		struct ts_cell_others *others = cell[i] >= 0 ? &s->cell[cell[i]] : NULL;

		if (!others)
			continue;
		if (others->n < 0)
			TS_TRY(find_others(s, space, own, cell[i], others));
		for (int32_t k = 0; k < others->n; k++)
			TS_TRY(pack_row(s, rows, (int32_t)i, s->other[others->first + k]));
	}
	return TS_OK;
}

enum ts_status ts_cell_senders_rows(struct ts_cell_senders *s, struct ts_world *world,
				    const struct ts_cell_space *space, int reach, const int32_t *cell,
				    struct ts_cell_rows *rows)
{
	TS_TRY(make_senders(s, space, reach));
	TS_TRY(pack_rows(s, space, world->rank, cell, rows));
	TS_TRY(ts_world_deliver(world, s->out, s->in));
	s->rows.n = 0;
	for (int r = 0; r < s->ranks; r++)
		TS_TRY(ts_parcel_add(&s->rows, s->in[r].data, s->in[r].n));
	rows->other = (const struct ts_cell_row *)(const void *)s->rows.data;
	rows->n = rows->own + s->rows.n / sizeof *rows->other;
	return TS_OK;
}

/* ---- numbers */

static enum ts_status pack_numbers(struct ts_cell_senders *s, const double *mine, size_t stride, size_t width)
{
	for (int r = 0; r < s->ranks; r++) {
		const int32_t *index = (const int32_t *)(const void *)s->index[r].data;
		const size_t n = s->index[r].n / sizeof *index;
		double *to;

		s->out[r].n = 0;
		to = (double *)(void *)ts_parcel_extend(&s->out[r], n * width * sizeof *to);
		if (!to)
			return TS_NOMEM;
		for (size_t k = 0; k < n; k++, to += width)
			memcpy(to, mine + stride * (size_t)index[k], width * sizeof *to);
	}
	return TS_OK;
}

enum ts_status ts_cell_senders_numbers(struct ts_cell_senders *s, struct ts_world *world, const double *mine,
				       size_t stride, size_t width, struct ts_parcel *all)
{
	const size_t bytes = width * sizeof(double);
	unsigned char *to = ts_parcel_extend(all, s->rows.n / sizeof(struct ts_cell_row) * bytes);
	struct ts_parcel *place = ts_alloc((size_t)s->ranks, sizeof *place);
	enum ts_status status = to && place ? pack_numbers(s, mine, stride, width) : TS_NOMEM;

	for (int r = 0; r < s->ranks && status == TS_OK; r++) {
		place[r] = (struct ts_parcel){ .data = to,
					       .n = s->in[r].n / sizeof(struct ts_cell_row) * bytes };
		to += place[r].n;
	}
	if (status == TS_OK)
		ts_world_swap(world, s->out, place);
	ts_free(place);
	return status;
}

void ts_cell_senders_release(struct ts_cell_senders *s)
{
	for (size_t r = 0; r < s->index_capacity; r++)
		ts_parcel_release(&s->index[r]);
	for (size_t r = 0; r < s->out_capacity; r++)
		ts_parcel_release(&s->out[r]);
	for (size_t r = 0; r < s->in_capacity; r++)
		ts_parcel_release(&s->in[r]);
	ts_parcel_release(&s->rows);
	ts_free(s->cell);
	ts_free(s->other);
	ts_free(s->index);
	ts_free(s->out);
	ts_free(s->in);
	*s = (struct ts_cell_senders){ 0 };
}
