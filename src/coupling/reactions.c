#include "coupling/reactions.h"

#include "coupling/interpolation_faces.h"
#include "coupling/stencil_batch.h"

#include "base/banned.h"

static double *velocity_of(const struct ts_reactions *r, size_t row)
{
	return r->velocity && row < r->force.n ? r->velocity + r->stride * row : NULL;
}

static void add_row(const struct ts_reactions *r, size_t row)
{
	struct ts_coupling_place at = { .how = r->how };
	const struct ts_coupling_reaction reaction = { ts_cell_numbers_of(&r->force, row),
						       r->slope.own ? ts_cell_numbers_of(&r->slope, row)
								    : NULL,
						       { r->along[0], r->along[1], r->along[2] } };

	if (ts_cell_order_locate(r->order, r->fluid, row, at.x, at.cell))
		ts_coupling_faces_react(r->fluid, &at, &reaction, velocity_of(r, row));
}

static void add_rows(void *context, const int32_t *row, size_t n)
{
	const struct ts_reactions *r = context;

	for (size_t k = 0; k < n; k++)
		add_row(r, (size_t)row[k]);
}

static void add_batch(void *context, const int32_t *row, size_t n)
{
	const struct ts_reactions *r = context;
	const struct ts_cell_sort *sort = r->order->sort;
	struct ts_stencil_reactions of = { .sloped = r->slope.own,
					   .along = { r->along[0], r->along[1], r->along[2] } };
	struct ts_stencil_batch batch;

	batch.n = 0;
	for (size_t k = 0; k < n; k++) {
		const size_t at = (size_t)row[k];

		of.amount[k] = ts_cell_numbers_of(&r->force, at);
		of.slope[k] = of.sloped ? ts_cell_numbers_of(&r->slope, at) : NULL;
		of.velocity[k] = velocity_of(r, at);
		__builtin_prefetch(of.amount[k]);
		__builtin_prefetch(of.sloped ? of.slope[k] : of.amount[k]);
		ts_stencil_batch_add(&batch, ts_cell_rows_x(&sort->of, at), sort->where[at]);
	}
	ts_stencil_batch_react(&batch, r->fluid, &of);
}

void ts_reactions_add(const struct ts_reactions *r, int threads)
{
	struct ts_reactions copy = *r;

	_Static_assert((int)TS_CELL_ORDER_ROWS <= (int)TS_STENCIL_BATCH, "all rows of a call are a batch");
	ts_cell_order_each_rows(r->order, threads,
				ts_stencil_batch_possible(r->fluid, (int)r->how) ? add_batch : add_rows,
				&copy);
}
