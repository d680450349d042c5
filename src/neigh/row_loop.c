#include "neigh/row_loop.h"

#include <string.h>

#include "base/banned.h"

void ts_row_share_generic(void *task, size_t from, size_t to)
{
	ts_row_share(task, from, to, &((const struct ts_row_task *)task)->pair->model);
}

void ts_row_share_each(void *task, size_t from, size_t to)
{
	ts_row_share(task, from, to, NULL);
}

struct loop {
	struct ts_row_task task;
	ts_share_fn *share;
	ts_rows_gather_fn *gather;
};

static void place_share(void *context, size_t from, size_t to)
{
	const struct loop *loop = context;

	ts_rows_place(loop->task.p, loop->task.rows, from, to);
}

static void gather_chunk(const struct loop *loop, size_t c)
{
	size_t from = c * TS_ROW_CHUNK, n = loop->task.rows->particles;

	loop->gather(loop->task.rows, loop->task.p, from,
		     n - from < TS_ROW_CHUNK ? n : from + TS_ROW_CHUNK);
	loop->task.rows->gathered[c] = 1;
}

/* Rows are computed some at a time, and particles whose rows are all done are gathered while these are still near
 * in the caches. Chunks whose rows lie in the shares of several threads wait for the end. */
static void rows_share(void *context, size_t from, size_t to)
{
	enum { SOME = 8 * TS_ROW_BLOCK };
	struct loop *loop = context;
	struct ts_rows *rows = loop->task.rows;
	size_t c = 0;

	for (size_t r = from; r < to; r += SOME) {
		size_t end = to - r < SOME ? to : r + SOME;

		loop->share(&loop->task, r, end);
		for (; c < rows->chunks && rows->chunk[c].end <= end; c++)
			if (rows->chunk[c].first >= from && rows->chunk[c].end > 0)
				gather_chunk(loop, c);
	}
}

static void rest_share(void *context, size_t from, size_t to)
{
	const struct loop *loop = context;

	for (size_t c = from; c < to; c++)
		if (!loop->task.rows->gathered[c] && loop->task.rows->chunk[c].end > 0)
			gather_chunk(loop, c);
}

void ts_row_loop(struct tsim *sim, const struct ts_pair *pair, ts_share_fn *share)
{
	struct ts_rows *rows = &sim->neigh->rows;
	const struct ts_particles *p = sim->particles;
	struct loop loop = { .task = { p, rows, pair, sim->clock.dt, !sim->in_setup,
				       sim->legacy && !pair->mixes }, /* LAMMPS forgets at once */
			     .share = share,
			     .gather = ts_rows_gatherer(rows) };

	/* where memory does not advance, there is no loop of its own */
	if (!loop.task.advance || !(loop.task.dt > 0))
		loop.share = share == ts_row_share_each ? share : ts_row_share_generic;
	ts_parallel(ts_team(sim, p->n + p->nghost), p->n + p->nghost, place_share, &loop);
	if (rows->chunks)
		memset(rows->gathered, 0, rows->chunks);
	ts_parallel(ts_team(sim, rows->n), rows->n, rows_share, &loop);
	ts_parallel(ts_team(sim, rows->chunks), rows->chunks, rest_share, &loop);
}
