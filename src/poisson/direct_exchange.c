#include "poisson/direct_exchange.h"

#include <stdint.h>

#include "base/alloc.h"
#include "rank/transposition.h"

#include "base/banned.h"

/* Modes of its strips. */
static void modes_of(const void *solver, int rank, size_t from[2])
{
	const struct ts_direct *s = solver;
	const size_t modes = (size_t)s->n[0] * (size_t)s->n[1], width = s->strip;
	const size_t strips = (modes + width - 1) / width;

	for (int k = 0; k < 2; k++) {
		from[k] = width * ts_slabs_part(s->slabs, rank + k, strips);
		from[k] = from[k] < modes ? from[k] : modes;
	}
}

/* Modes of the first axis, in whole sets of lines that are transformed together along the second one. */
static void columns_of(const void *solver, int rank, size_t from[2])
{
	const struct ts_direct *s = solver;
	const size_t n = (size_t)s->n[0];

	for (int k = 0; k < 2; k++) {
		from[k] = TS_LINES * ts_slabs_part(s->slabs, rank + k, (n + TS_LINES - 1) / TS_LINES);
		from[k] = from[k] < n ? from[k] : n;
	}
}

static struct ts_transposition transposition(const struct ts_direct *s)
{
	struct ts_transposition t = { .slabs = s->slabs,
				      .field = { .first = s->work, .stride = s->plane },
				      .columns = s->columns ? columns_of : modes_of,
				      .of = s };

	if (!s->columns)
		return t;
	t.field.stride = (size_t)s->n[0];
	t.layers = (size_t)s->n[2];
	t.apart = s->plane;
	t.turned = s->columns->work;
	t.turned_stride = (size_t)s->columns->n[0];
	t.turned_apart = s->columns->plane;
	return t;
}

void ts_direct_release_columns(struct ts_direct *s)
{
	if (!s->columns)
		return;
	ts_free(s->columns->work);
	ts_free(s->columns->eigenvalue);
	ts_free(s->columns);
	s->columns = NULL;
}

/* The solver of the columns of this rank: it has the transforms and the work memory of the other one. */
static enum ts_status make_columns(struct ts_direct *s)
{
	struct ts_direct *c = s->columns = ts_alloc(1, sizeof *c);
	size_t column[2], n, rows = (size_t)s->n[1];

	if (!c)
		return TS_NOMEM;
	columns_of(s, s->slabs->world->rank, column);
	n = column[1] - column[0];
	*c = *s;
	c->columns = NULL;
	c->slabs = NULL;
	c->n[0] = (int)n;
	c->plane = ts_direct_plane(n * rows);
	c->work = ts_alloc_aligned(c->plane * (size_t)s->n[2], sizeof *c->work);
	c->eigenvalue = ts_alloc_aligned(n * rows, sizeof *c->eigenvalue);
	if (!c->work || !c->eigenvalue)
		return TS_NOMEM;
	c->singular = SIZE_MAX;
	for (size_t row = 0; row < rows; row++)
		for (size_t m = 0; m < n; m++) {
			const size_t there = row * (size_t)s->n[0] + column[0] + m;

			c->eigenvalue[row * n + m] = s->eigenvalue[there];
			if (there == s->singular)
				c->singular = row * n + m;
		}
	return TS_OK;
}

enum ts_status ts_direct_divide(struct ts_direct *s, struct ts_slabs *slabs)
{
	const int across = s->axis[2] == 2 ? 2 : 1;
	const bool was = slabs && slabs->active;
	enum ts_status status = TS_OK;

	ts_direct_release_columns(s);
	s->slabs = slabs && slabs->world && s->axis[across] == 2 && s->n[1] > 1 && s->n[across] == slabs->n
			   ? slabs
			   : NULL;
	if (!s->slabs)
		return TS_OK;
	slabs->active = true; /* as it will be */
	if (across == 1)
		status = make_columns(s);
	if (status == TS_OK) {
		const struct ts_transposition t = transposition(s);

		status = ts_transposition_room(&t);
	}
	slabs->active = was;
	return status;
}

bool ts_direct_divided(const struct ts_direct *s)
{
	return ts_slabs_ranks(s->slabs) > 1;
}

void ts_direct_exchange(const struct ts_direct *s, bool back)
{
	const struct ts_transposition t = transposition(s);

	if (ts_direct_divided(s))
		ts_transpose(&t, back);
}

void ts_direct_rehearse(const struct ts_direct *s)
{
	ts_direct_exchange(s, false);
	ts_direct_exchange(s, true);
}
