#include "automaton/granule_lattice.h"

#include "automaton/draws.h"
#include "base/alloc.h"
#include "base/clones.h"

#include "base/banned.h"

double ts_automaton_bytes(int64_t nx, int64_t ny)
{
	return (double)sizeof(uint32_t) * (double)(nx + 2) * (double)(ny + 2);
}

static void set_walls(struct ts_automaton_lattice *l)
{
	const size_t upper = (size_t)(l->ny + 1) * l->stride;

	for (int y = 0; y < l->ny; y++) {
		l->cell[ts_automaton_at(l, -1, y)] = ts_cell_fixed(TS_CELL_LEFT_PORTAL);
		l->cell[ts_automaton_at(l, l->nx, y)] = ts_cell_fixed(TS_CELL_RIGHT_PORTAL);
	}
	for (size_t c = 0; c < l->stride; c++) {
		l->cell[c] = ts_cell_fixed(TS_CELL_LOWER_WALL);
		l->cell[upper + c] = ts_cell_fixed(TS_CELL_UPPER_WALL);
	}
}

bool ts_automaton_make(struct ts_automaton_lattice *l, int nx, int ny)
{
	l->nx = nx;
	l->ny = ny;
	l->stride = (size_t)nx + 2;
	l->cell = ts_alloc_aligned(l->stride * ((size_t)ny + 2), sizeof *l->cell);
	if (!l->cell)
		return false;
	for (unsigned d = 0; d < TS_CELL_DIRECTIONS; d++)
		l->step[d] = ts_cell_dy(d) * (int32_t)l->stride + ts_cell_dx(d);
	set_walls(l);
	return true;
}

void ts_automaton_release(struct ts_automaton_lattice *l)
{
	ts_free(l->cell);
	ts_free(l->mover);
	ts_free(l->count);
	*l = (struct ts_automaton_lattice){ 0 };
}

int64_t ts_automaton_count_open(const struct ts_automaton_lattice *l)
{
	int64_t open = 0;

	for (int y = 0; y < l->ny; y++)
		for (int x = 0; x < l->nx; x++)
			open += ts_cell_state(l->cell[ts_automaton_at(l, x, y)]) != TS_CELL_FIXED;
	return open;
}

static bool is_possible(uint32_t w)
{
	switch (ts_cell_state(w)) {
	case TS_CELL_EMPTY:
		return w == 0;
	case TS_CELL_GRANULE:
		return ts_cell_speed(w) <= TS_CELL_ONE;
	case TS_CELL_FIXED:
		return w == ts_cell_fixed(TS_CELL_OBSTACLE);
	default:
		return false;
	}
}

static bool has_walls(const struct ts_automaton_lattice *l)
{
	const size_t upper = (size_t)(l->ny + 1) * l->stride;
	bool good = true;

	for (int y = 0; y < l->ny; y++)
		good &= l->cell[ts_automaton_at(l, -1, y)] == ts_cell_fixed(TS_CELL_LEFT_PORTAL) &&
			l->cell[ts_automaton_at(l, l->nx, y)] == ts_cell_fixed(TS_CELL_RIGHT_PORTAL);
	for (size_t c = 0; c < l->stride; c++)
		good &= l->cell[c] == ts_cell_fixed(TS_CELL_LOWER_WALL) &&
			l->cell[upper + c] == ts_cell_fixed(TS_CELL_UPPER_WALL);
	return good;
}

bool ts_automaton_accept(struct ts_automaton_lattice *l)
{
	if (!has_walls(l))
		return false;
	l->granules = 0;
	for (int y = 0; y < l->ny; y++)
		for (int x = 0; x < l->nx; x++) {
			const uint32_t w = l->cell[ts_automaton_at(l, x, y)];

			if (!is_possible(w))
				return false;
			l->granules += ts_cell_is_granule(w);
		}
	l->open = ts_automaton_count_open(l);
	return true;
}

/* Selection sampling: D. E. Knuth, The Art of Computer Programming 2, 3.4.2, algorithm S. */
void ts_automaton_place(struct ts_automaton_lattice *l, uint64_t seed, int64_t granules, int speed)
{
	struct ts_draws_stream draws = ts_draws_start(seed, 0, 0, TS_DRAWS_PLACES);
	int64_t left = l->open, need = granules;

	l->granules = granules;
	for (int y = 0; y < l->ny; y++)
		for (int x = 0; x < l->nx; x++) {
			uint32_t *cell = &l->cell[ts_automaton_at(l, x, y)];
			uint64_t bits;

			if (ts_cell_state(*cell) == TS_CELL_FIXED)
				continue;
			if (ts_draws_below(ts_draws_next(&draws), (uint32_t)left--) >= need)
				continue;
			need--;
			bits = ts_draws_next(&draws);
			*cell = ts_cell_granule(speed, (int)(bits >> 32 & TS_CELL_LOW), (unsigned)bits & 7);
		}
}

/* Cells whose speeds can be summed in 32 bits. */
enum { PIECE = 2048 };

TS_CLONES static void sum_piece(const uint32_t *cell, int n, int32_t sum[4])
{
	int32_t granules = 0, fixed = 0, x = 0, y = 0;

#pragma omp simd reduction(+ : granules, fixed, x, y)
	for (int k = 0; k < n; k++) {
		const uint32_t w = cell[k];
		const int32_t is = (int32_t)(w >> TS_CELL_STATE & 1), s = (int32_t)(w & TS_CELL_SPEED) * is;
		const unsigned d = ts_cell_direction(w);

		granules += is;
		fixed += (int32_t)(w >> TS_CELL_STATE) == TS_CELL_FIXED;
		x += s * ts_cell_dx(d);
		y += s * ts_cell_dy(d);
	}
	sum[0] = granules;
	sum[1] = fixed;
	sum[2] = x;
	sum[3] = y;
}

static int64_t sum_squares(const uint32_t *cell, int n)
{
	int64_t squares = 0;

#pragma omp simd reduction(+ : squares)
	for (int k = 0; k < n; k++) {
		const uint32_t w = cell[k];
		const int32_t s = (int32_t)(w & TS_CELL_SPEED) * (int32_t)(w >> TS_CELL_STATE & 1);

		squares += (int64_t)s * s << (w >> TS_CELL_DIRECTION & 1); /* on a diagonal both components */
	}
	return squares;
}

void ts_automaton_sum_row(const struct ts_automaton_lattice *l, int y, struct ts_automaton_row *sum)
{
	*sum = (struct ts_automaton_row){ 0 };
	for (int from = 0; from < l->nx; from += PIECE) {
		const uint32_t *cell = &l->cell[ts_automaton_at(l, from, y)];
		const int n = l->nx - from < PIECE ? l->nx - from : PIECE;
		int32_t part[4];

		sum_piece(cell, n, part);
		sum->granules += part[0];
		sum->open += n - part[1];
		sum->x += part[2];
		sum->y += part[3];
		sum->squares += sum_squares(cell, n);
	}
}
