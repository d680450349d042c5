/* Particles that add to cells of the grid: those of this rank, and, while the particles are divided among ranks, those of
 * other ranks that reach a cell of this one (flow/cell_owners.h). */
#ifndef TS_COUPLING_CELL_ROWS_H
#define TS_COUPLING_CELL_ROWS_H

#include "core/sim.h"
#include "coupling/cell_frame.h"

/* Of a particle of another rank. */
struct ts_cell_row {
	double x[3], radius;
	int32_t tag;
	uint32_t mask;
};

/* Rows 0 .. own - 1 are the particles of this rank. */
struct ts_cell_rows {
	size_t n, own;
	const double (*x)[3]; /* of own particles */
	const double *radius;
	const int32_t *tag;
	const uint32_t *mask;
	const struct ts_cell_row *other; /* [n - own] */
};

static inline const double *ts_cell_rows_x(const struct ts_cell_rows *rows, size_t row)
{
	return row < rows->own ? rows->x[row] : rows->other[row - rows->own].x;
}

static inline double ts_cell_rows_radius(const struct ts_cell_rows *rows, size_t row)
{
	return row < rows->own ? rows->radius[row] : rows->other[row - rows->own].radius;
}

static inline int32_t ts_cell_rows_tag(const struct ts_cell_rows *rows, size_t row)
{
	return row < rows->own ? rows->tag[row] : rows->other[row - rows->own].tag;
}

static inline uint32_t ts_cell_rows_mask(const struct ts_cell_rows *rows, size_t row)
{
	return row < rows->own ? rows->mask[row] : rows->other[row - rows->own].mask;
}

/* What is sent from rank to rank. Zero-initialise; ts_cell_senders_release when done. */
struct ts_cell_senders {
	uint64_t made_for; /* hash of the grid and the blocks, as of the owners */
	int reach, ranks;
	size_t cells; /* of the frame */
	/* Of each cell: the other ranks with a cell at most `reach` cells from it, others[first] on; n -1: not known yet.
	 * Owned, as the arrays below. */
	struct ts_cell_others {
		int32_t first, n;
	} * cell;
	int32_t *other;
	size_t nother;
	struct ts_parcel *index;    /* [ranks]: the own particles that are sent to each, int32_t */
	struct ts_parcel *out, *in; /* [ranks]: rows; numbers are received in place */
	struct ts_parcel rows;	    /* all that were received, in the order of ranks */
	size_t cell_capacity, other_capacity, index_capacity, out_capacity, in_capacity;
};

/* The cells, and the ranks that have them. */
struct ts_cell_space {
	const struct ts_grid *grid;
	const struct ts_rank_blocks *blocks;
	const struct ts_cell_owners *owners;
	struct ts_cell_frame frame; /* numbers of cells */
};

/* Sends the particles of this rank, which are in the cells with these numbers (-1: in none), and sets rows->other. */
enum ts_status ts_cell_senders_rows(struct ts_cell_senders *senders, struct ts_world *world,
				    const struct ts_cell_space *space, int reach, const int32_t *cell,
				    struct ts_cell_rows *rows);
/* Sends `width` numbers of each of the same particles, from mine[stride * i] on, and appends those received to `all`, in
 * the order of the rows. */
enum ts_status ts_cell_senders_numbers(struct ts_cell_senders *senders, struct ts_world *world,
				       const double *mine, size_t stride, size_t width,
				       struct ts_parcel *all);
void ts_cell_senders_release(struct ts_cell_senders *senders);

#endif
