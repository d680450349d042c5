/* The lattice of the granular automaton: unit cells in rows along x, which is periodic, between two walls; granules in
 * random cells; sums over rows. */
#ifndef TS_AUTOMATON_GRANULE_LATTICE_H
#define TS_AUTOMATON_GRANULE_LATTICE_H

#include <stddef.h>

#include "automaton/laws.h"
#include "base/status.h"

/* What has happened in the steps so far. */
struct ts_automaton_count {
	int64_t due;	  /* granules that were to move */
	int64_t moved;	  /* that did */
	int64_t collided; /* collisions with granules */
	int64_t clipped;  /* results of collisions that were reduced to one cell a step */
};

struct ts_automaton_lattice {
	int nx, ny;
	size_t stride;		/* cells from row to row, with one portal at each end */
	uint32_t *cell;		/* [(ny + 2) stride]: the first and the last row are walls */
	int32_t step[8];	/* to the neighbour in each direction, in cells */
	int64_t granules, open; /* open: cells without obstacles */
	uint32_t *mover;	/* [granules] with the order `exact`: cells of granules that are to move */
	struct ts_automaton_count *count; /* [blocks of one step] with the order `blocks` */
	size_t ncounts;
};

/* Sums over the granules of a row; components of velocities in units of 1/TS_CELL_ONE cells a step. */
struct ts_automaton_row {
	int64_t granules, open;
	int64_t x, y, squares;
};

static inline size_t ts_automaton_at(const struct ts_automaton_lattice *l, int x, int y)
{
	return (size_t)(y + 1) * l->stride + (size_t)(x + 1);
}

/* Bytes of a lattice of that size. */
double ts_automaton_bytes(int64_t nx, int64_t ny);
/* Empty cells; false: no memory. The caller sets obstacles, then ts_automaton_place. */
bool ts_automaton_make(struct ts_automaton_lattice *l, int nx, int ny);
void ts_automaton_release(struct ts_automaton_lattice *l);
/* Puts `granules` <= `open` into different cells, each set of cells with the same probability; with this speed, random
 * directions and phases. */
void ts_automaton_place(struct ts_automaton_lattice *l, uint64_t seed, int64_t granules, int speed);
int64_t ts_automaton_count_open(const struct ts_automaton_lattice *l);
/* For cells from a file: sets `granules` and `open`. False: walls are not in their places, or a cell has an impossible value. */
bool ts_automaton_accept(struct ts_automaton_lattice *l);

void ts_automaton_sum_row(const struct ts_automaton_lattice *l, int y, struct ts_automaton_row *sum);

#endif
