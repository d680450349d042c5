/* Particles in the fluid sorted by cell and then by identity: sums over them do not depend on the order of
 * particles in memory or on the number of threads. While the particles are divided among ranks, each sorts its own ones and
 * those of other ranks that reach its cells: so it has the sums of its cells, with the bits of one rank.
 *
 * For adding to fields of the grid in parallel the cells are divided into slabs across the last axis,
 * thick enough that particles of every second slab write to different cells: these slabs are processed in
 * parallel. Slabs depend on the grid only. */
#ifndef TS_COUPLING_CELL_ORDER_H
#define TS_COUPLING_CELL_ORDER_H

#include "coupling/cell_halves.h"
#include "coupling/cell_rows.h"
#include "coupling/interpolation_weights.h"
#include "flow/fluid.h"

/* Particles in the fluid, sorted. */
struct ts_cell_sort {
	struct ts_cell_rows of;
	struct ts_cell_senders senders; /* while the particles are divided among ranks */
	struct ts_cell_frame frame;
	bool divided;
	/* indices of rows, sorted; number of the cell of each row in the frame, or -1. Owned, as the arrays below */
	int32_t *row, *cell;
	uint64_t *where; /* the same, and the half of the cell: ts_halves_of */
	size_t *start;	 /* of each cell: its first index in `row` */
	size_t n;	 /* number of particles in the fluid */
	/* The state of the own particles that was sorted: if nothing has changed, they are not sorted again. */
	struct ts_cell_sorted {
		double x[3];
		int32_t tag;
	} * last; /* [nlast] */
	size_t nlast;
	uint64_t
		grid; /* hash of the grid and the blocks: another fluid may have the memory of the one before */
	int reach;    /* number of cells beyond its own to which a particle adds */
	/* Step in which all ranks have agreed last whether to sort again, and how often steps had been numbered anew. */
	int64_t agreed, era;
	size_t row_capacity, cell_capacity, where_capacity, start_capacity, last_capacity;
};

/* Zero-initialise; ts_cell_order_release when done. A fix that sets `order` of struct ts_flow_part in its init shares
 * its sorted particles with the fixes after it in the script. */
struct ts_cell_order {
	struct ts_cell_sort own;
	const struct ts_cell_sort *sort; /* `own`, or that of another fix */
	int group;			 /* particles for which `add` is called */
	struct ts_parcel shared;	 /* ts_cell_order_share */
	struct ts_fluid *fluid;
	size_t *slab; /* of each slab: its first index in `row`. Owned */
	int nslabs;
	bool ring; /* periodic axis: the last slab is beside the first */
	size_t slab_capacity;
};

/* Whether there are so few particles for the cells that every rank has all cells: the values of cells would be more to send
 * than the particles of the other ranks. `most`: particles of the rank that has most. */
bool ts_cell_order_few(double most, int ranks, size_t cells);

/* Sorts the particles, and selects those of the group; `reach`: number of cells beyond its own to which a particle
 * adds. */
enum ts_status ts_cell_order_make(struct ts_cell_order *order, struct tsim *sim, struct ts_fluid *fluid,
				  int group, int reach);
void ts_cell_order_release(struct ts_cell_order *order);

/* ts_coupling_locate for the particle of a row, after ts_cell_order_make, while nothing moves. */
static inline bool ts_cell_order_locate(const struct ts_cell_order *order, const struct ts_fluid *fluid,
					size_t row, double place[3], int cell[3])
{
	const uint64_t where = order->sort->where[row];
	const double *x = ts_cell_rows_x(&order->sort->of, row);

	if (where & TS_HALVES_ELSEWHERE)
		return ts_coupling_locate(fluid, x, place, cell);
	for (int d = 0; d < 3; d++) {
		place[d] = x[d];
		cell[d] = ts_halves_of(where, d) / 2;
	}
	return true;
}

/* Numbers of particles for `add`: those of row r are at ts_cell_numbers_of. */
struct ts_cell_numbers {
	const double *own, *other;
	size_t n, stride, width; /* n: rows of own particles */
};

static inline const double *ts_cell_numbers_of(const struct ts_cell_numbers *numbers, size_t row)
{
	return row < numbers->n ? numbers->own + numbers->stride * row
				: numbers->other + numbers->width * (row - numbers->n);
}

/* Of the own particles `width` numbers of particle i from mine[stride * i] on. While the particles are divided all ranks
 * call it, and send what others need. */
enum ts_status ts_cell_order_share(struct ts_cell_order *order, struct tsim *sim, const double *mine,
				   size_t stride, size_t width, struct ts_cell_numbers *out);
/* While the particles are divided all ranks call it after `add`: each gets the values of the cells that it needs from the
 * ranks that have them (flow/fluid_near.h), or of all. */
enum ts_status ts_cell_order_spread(struct ts_cell_order *order, struct tsim *sim, double *field);
/* The same for sources of the fluid, which particles do not read: it needs those of its planes. */
enum ts_status ts_cell_order_gather(struct ts_cell_order *order, struct tsim *sim, double *field);

/* The cells that this rank adds to completely: all, or its own ones. */
struct ts_cell_box ts_cell_order_box(const struct ts_cell_order *order, const struct tsim *sim);

/* Calls `add` for rows of particles of the group, at most TS_CELL_ORDER_ROWS at once, in their order, in parallel for
 * particles that add to different cells. */
enum { TS_CELL_ORDER_ROWS = 32 };
typedef void ts_cell_order_rows_fn(void *context, const int32_t *row, size_t n);
void ts_cell_order_each_rows(const struct ts_cell_order *order, int threads, ts_cell_order_rows_fn *add,
			     void *context);
/* Calls `add` for the row of each particle of the group, likewise. */
typedef void ts_cell_order_fn(void *context, size_t row);
void ts_cell_order_each(const struct ts_cell_order *order, int threads, ts_cell_order_fn *add, void *context);

#endif
