/* A step of the granular automaton: all granules that are to move do so one after the other, in random order. */
#ifndef TS_AUTOMATON_STEP_H
#define TS_AUTOMATON_STEP_H

#include "automaton/granule_lattice.h"

enum ts_automaton_order {
	TS_AUTOMATON_EXACT, /* all orders have the same probability */
	/* Blocks of cells in four groups, as the squares of a board of four colours; the groups follow each other in random
	 * order, blocks of one group do not touch; within a block all orders have the same probability. The blocks lie
	 * elsewhere in each step. */
	TS_AUTOMATON_BLOCKS
};
/* Fewest cells along x with the order `blocks`. */
enum { TS_AUTOMATON_BLOCKS_LEAST = 16 };

/* Allocates what the order needs for the present number of granules; false: no memory. */
bool ts_automaton_step_make(struct ts_automaton_lattice *l, enum ts_automaton_order order);
/* The result does not depend on the number of threads. */
void ts_automaton_step(struct ts_automaton_lattice *l, const struct ts_laws *laws,
		       enum ts_automaton_order order, uint64_t seed, int64_t step, int threads,
		       struct ts_automaton_count *count);

/* For tests: the n entries in an order of which all have the same probability. */
void ts_automaton_shuffle(uint32_t *entry, uint32_t n, uint64_t seed, int64_t step);

#endif
