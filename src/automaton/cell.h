/* Cells of the granular automaton: one word of 32 bits each.
 *
 *   bits  0..13  speed s, the larger component of the velocity, in units of 1/TS_CELL_ONE cells a step
 *   bits 14..26  phase: the part of a cell that the granule has still to its account, in the same units
 *   bits 27..29  direction 0..7 of a granule; of a fixed cell its kind, enum ts_cell_fixed
 *   bits 30..31  enum ts_cell_state
 *
 * The velocity of a granule is s (dx, dy), where (dx, dy) is its direction: with the speed 1 it moves by one cell in
 * each step, along an axis or along a diagonal. In each step the phase is increased by the speed; where it reaches 1
 * the granule is due to move, and the phase is reduced by 1. 1/s is the time factor of the paper. */
#ifndef TS_AUTOMATON_CELL_H
#define TS_AUTOMATON_CELL_H

#include <stdbool.h>
#include <stdint.h>

#include "base/inline.h"

enum {
	TS_CELL_ONE = 1 << 13, /* one cell a step */
	TS_CELL_PHASE = 14,    /* first bit of the phase, of the direction, of the state */
	TS_CELL_DIRECTION = 27,
	TS_CELL_STATE = 30,
	TS_CELL_LOW = TS_CELL_ONE - 1, /* mask of a phase */
	TS_CELL_SPEED = 2 * TS_CELL_ONE - 1,
	TS_CELL_DIRECTIONS = 8
};

enum ts_cell_state {
	TS_CELL_EMPTY,
	TS_CELL_GRANULE,
	TS_CELL_FIXED,
	TS_CELL_DUE /* a granule that is to move */
};

/* Left and right of the lattice is a column of cells each that stand for those at its other side. */
enum ts_cell_fixed {
	TS_CELL_LOWER_WALL,
	TS_CELL_UPPER_WALL,
	TS_CELL_OBSTACLE,
	TS_CELL_LEFT_PORTAL,
	TS_CELL_RIGHT_PORTAL
};

TS_INLINE unsigned ts_cell_state(uint32_t w)
{
	return w >> TS_CELL_STATE;
}

/* Bit 30 is set in granules, and only there. */
TS_INLINE bool ts_cell_is_granule(uint32_t w)
{
	return w >> TS_CELL_STATE & 1;
}

TS_INLINE int ts_cell_speed(uint32_t w)
{
	return (int)(w & TS_CELL_SPEED);
}

TS_INLINE unsigned ts_cell_direction(uint32_t w)
{
	return w >> TS_CELL_DIRECTION & 7;
}

TS_INLINE uint32_t ts_cell_fixed(enum ts_cell_fixed kind)
{
	return (uint32_t)TS_CELL_FIXED << TS_CELL_STATE | (uint32_t)kind << TS_CELL_DIRECTION;
}

TS_INLINE uint32_t ts_cell_granule(int speed, int phase, unsigned direction)
{
	return (uint32_t)TS_CELL_GRANULE << TS_CELL_STATE | (uint32_t)direction << TS_CELL_DIRECTION |
	       (uint32_t)phase << TS_CELL_PHASE | (uint32_t)speed;
}

/* The same granule with another speed and direction. */
TS_INLINE uint32_t ts_cell_turned(uint32_t w, int speed, unsigned direction)
{
	const uint32_t kept = (uint32_t)3 << TS_CELL_STATE | (uint32_t)TS_CELL_LOW << TS_CELL_PHASE;

	return (w & kept) | (uint32_t)direction << TS_CELL_DIRECTION | (uint32_t)speed;
}

/* Components -1, 0, 1 of the directions, counter-clockwise from +x (figure 4 of the paper). Two bits for each, so that
 * no memory is read; with bit 31 gcc does not compute in 16 bits, for which there are no shifts of vectors. */
TS_INLINE int ts_cell_dx(unsigned direction)
{
	return (int)(0x8000901Au >> 2 * direction & 3) - 1;
}

TS_INLINE int ts_cell_dy(unsigned direction)
{
	return ts_cell_dx((direction + 6) & 7);
}

/* The direction with these components, not both 0. */
TS_INLINE unsigned ts_cell_direction_of(int dx, int dy)
{
	/* rows dy = -1, 0, 1; columns dx = -1, 0, 1; four bits each */
	return (unsigned)(UINT64_C(0x123004765) >> 4 * (3 * (dy + 1) + dx + 1) & 7);
}

#endif
