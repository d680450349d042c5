/* The update of one granule: it moves, or it collides and tries again. */
#ifndef TS_AUTOMATON_GRANULE_H
#define TS_AUTOMATON_GRANULE_H

#include "automaton/draws.h"
#include "automaton/granule_lattice.h"

/* The neighbour of cell c in a direction, beyond a portal that at the other side of the lattice. */
static inline uint32_t ts_granule_neighbour(const struct ts_automaton_lattice *l, size_t c,
					    unsigned direction, size_t *at)
{
	size_t n = c + (size_t)(ptrdiff_t)l->step[direction];
	uint32_t w = l->cell[n];

	if (ts_cell_state(w) == TS_CELL_FIXED) {
		if (ts_cell_direction(w) == TS_CELL_LEFT_PORTAL)
			w = l->cell[n += (size_t)l->nx];
		else if (ts_cell_direction(w) == TS_CELL_RIGHT_PORTAL)
			w = l->cell[n -= (size_t)l->nx];
	}
	*at = n;
	return w;
}

static inline bool ts_granule_faces_fixed(const struct ts_automaton_lattice *l, size_t c, unsigned direction)
{
	size_t at;

	return ts_cell_state(ts_granule_neighbour(l, c, direction, &at)) == TS_CELL_FIXED;
}

/* A fixed cell is in the way. On a diagonal its neighbours show whether its face is along x or y; in a corner both
 * components are reversed. */
static inline uint32_t ts_granule_rebound(const struct ts_automaton_lattice *l, const struct ts_laws *laws,
					  size_t c, uint32_t w, uint32_t fixed, struct ts_draws_stream *draws,
					  struct ts_automaton_count *count)
{
	const unsigned d = ts_cell_direction(w), kind = ts_cell_direction(fixed);
	const int dx = ts_cell_dx(d), dy = ts_cell_dy(d);
	const int wall = kind <= TS_CELL_UPPER_WALL ? laws->wall[kind] : 0;
	const struct ts_laws_velocity v = ts_laws_velocity_of(w);
	struct ts_laws_velocity after;
	bool along_x = dy != 0, along_y = dx != 0;

	if (along_x && along_y) {
		const bool below = ts_granule_faces_fixed(l, c, ts_cell_direction_of(0, dy));
		const bool beside = ts_granule_faces_fixed(l, c, ts_cell_direction_of(dx, 0));

		along_x = below || !beside;
		along_y = beside || !below;
	}
	if (laws->directions == TS_LAWS_TABLE)
		return ts_laws_table_wall(laws, w, along_x, along_y, along_x ? wall : 0);
	after = ts_laws_wall(laws, along_x, along_x ? wall : 0, v);
	if (along_x && along_y)
		after.x = ts_laws_wall(laws, 0, 0, v).x;
	count->clipped += ts_laws_is_clipped(after);
	return ts_laws_turn(laws, w, after, (unsigned)(ts_draws_next(draws) & 0xffff));
}

TS_INLINE unsigned ts_granule_normal(const struct ts_laws *laws, unsigned direction, unsigned r)
{
	if (laws->contact == TS_LAWS_OFFSET)
		return (direction + (r & 1 ? 1 : 7)) & 7;
	if (laws->contact == TS_LAWS_ANY)
		return (direction + 7 + (r * 3 >> 16)) & 7;
	return direction;
}

/* A granule is in the way; false: they do not approach. */
static inline bool ts_granule_collide(const struct ts_laws *laws, uint32_t *w, uint32_t *other,
				      struct ts_draws_stream *draws, struct ts_automaton_count *count)
{
	const uint64_t bits = ts_draws_next(draws);
	const unsigned normal = ts_granule_normal(laws, ts_cell_direction(*w), (unsigned)(bits & 0xffff));
	const struct ts_laws_velocity v1 = ts_laws_velocity_of(*w), v2 = ts_laws_velocity_of(*other);
	const int closing = ts_laws_closing(normal, v1, v2);
	const unsigned before = ts_cell_direction(*other);
	struct ts_laws_velocity u1, u2;
	int d;

	if (laws->directions == TS_LAWS_TABLE) {
		ts_laws_table_pair(laws, w, other, (unsigned)bits);
		count->collided++;
		return true;
	}
	if (closing <= 0)
		return false;
	d = ts_laws_impulse(laws, normal, closing);
	u1 = ts_laws_changed(v1, normal, -d);
	u2 = ts_laws_changed(v2, normal, d);
	*w = ts_laws_turn(laws, *w, u1, (unsigned)(bits >> 16 & 0xffff));
	*other = ts_laws_turn(laws, *other, u2, (unsigned)(bits >> 32 & 0xffff));
	if (laws->partner == TS_LAWS_KEEPS)
		*other = ts_cell_turned(*other, ts_cell_speed(*other), before);
	count->collided++;
	count->clipped += ts_laws_is_clipped(u1) + ts_laws_is_clipped(u2);
	return true;
}

/* The granule of cell c, which is to move. It tries its direction, and after each collision the new one, until a cell is
 * empty or the direction has been tried before. */
static inline void ts_granule_update(struct ts_automaton_lattice *l, const struct ts_laws *laws, size_t c,
				     struct ts_draws_stream *draws, struct ts_automaton_count *count)
{
	uint32_t w = l->cell[c] & ~((uint32_t)1 << 31);
	unsigned tried = 0;

	count->due++;
	while (ts_cell_speed(w) > 0 && !(tried >> ts_cell_direction(w) & 1)) {
		size_t at;
		uint32_t other = ts_granule_neighbour(l, c, ts_cell_direction(w), &at);

		tried |= 1u << ts_cell_direction(w);
		if (other == TS_CELL_EMPTY) {
			l->cell[c] = TS_CELL_EMPTY;
			l->cell[at] = w;
			count->moved++;
			return;
		}
		if (!ts_cell_is_granule(other)) {
			w = ts_granule_rebound(l, laws, c, w, other, draws, count);
			continue;
		}
		if (!ts_granule_collide(laws, &w, &other, draws, count))
			break;
		l->cell[at] = other;
	}
	l->cell[c] = w;
}

#endif
