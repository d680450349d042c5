/* Collision laws of the granular automaton: V. K. Jasti and C. F. Higgs, J. Tribol. 128 (2006) 358, equations (6) to (9).
 * Velocities are integers, in units of 1/TS_CELL_ONE cells a step. */
#ifndef TS_AUTOMATON_LAWS_H
#define TS_AUTOMATON_LAWS_H

#include "automaton/cell.h"

/* The line of centres of two granules in neighbouring cells, which are not resolved within their cells. */
enum ts_laws_contact {
	TS_LAWS_OFFSET, /* turned by 45 degrees to either side of the direction of motion, one of the two at random */
	TS_LAWS_CENTRE, /* the direction of motion */
	TS_LAWS_ANY	/* one of these three at random */
};
/* The direction after a collision: of the velocity that the laws give, or by a table, with laws of speeds without sign. */
enum ts_laws_directions { TS_LAWS_RANDOM, TS_LAWS_NEAREST, TS_LAWS_TABLE };
enum ts_laws_partner { TS_LAWS_TURNS, TS_LAWS_KEEPS };
enum ts_laws_normal { TS_LAWS_WALL_SPEED, TS_LAWS_WALL_NORMAL };

enum { TS_LAWS_FRACTION = 16 }; /* bits of the coefficients */

struct ts_laws {
	uint32_t pair;			      /* (1 + e_p)/2, times 2^16 */
	uint32_t wall_restitution, roughness; /* e_w and R, times 2^16 */
	int wall[2];			      /* velocity of the lower and the upper wall along x */
	int contact, directions, partner, normal;
};

struct ts_laws_velocity {
	int x, y;
};

TS_INLINE int ts_laws_abs(int v)
{
	return v < 0 ? -v : v;
}

/* v coefficient/2^bits to the nearest; 0 <= v <= 4 cells a step, so that 32 bits suffice */
TS_INLINE int ts_laws_scale(uint32_t coefficient, int v, unsigned bits)
{
	return (int)((coefficient * (uint32_t)v + ((uint32_t)1 << (bits - 1))) >> bits);
}

TS_INLINE struct ts_laws_velocity ts_laws_velocity_of(uint32_t w)
{
	const unsigned direction = ts_cell_direction(w);
	const int s = ts_cell_speed(w);

	return (struct ts_laws_velocity){ s * ts_cell_dx(direction), s * ts_cell_dy(direction) };
}

/* How fast granule 1 approaches granule 2 along their line of centres, `normal`; on a diagonal times sqrt(2). */
TS_INLINE int ts_laws_closing(unsigned normal, struct ts_laws_velocity v1, struct ts_laws_velocity v2)
{
	return (v1.x - v2.x) * ts_cell_dx(normal) + (v1.y - v2.y) * ts_cell_dy(normal);
}

/* Equations (8) and (9) for the components along the line of centres; the others stay. What granule 1 loses of each
 * component, times that of the line, granule 2 gains. closing > 0 */
TS_INLINE int ts_laws_impulse(const struct ts_laws *laws, unsigned normal, int closing)
{
	/* on a diagonal |(dx, dy)|^2 = 2 */
	return ts_laws_scale(laws->pair, closing, TS_LAWS_FRACTION + (normal & 1));
}

TS_INLINE struct ts_laws_velocity ts_laws_changed(struct ts_laws_velocity v, unsigned normal, int by)
{
	return (struct ts_laws_velocity){ v.x + by * ts_cell_dx(normal), v.y + by * ts_cell_dy(normal) };
}

/* Equation (6): u + R (U - u) */
TS_INLINE int ts_laws_along(const struct ts_laws *laws, int wall, int u)
{
	const int d = ts_laws_scale(laws->roughness, ts_laws_abs(wall - u), TS_LAWS_FRACTION);

	return wall > u ? u + d : u - d;
}

/* Equation (7), U - e_w (U - u), for the speed u towards the wall; afterwards it is directed away from it. U is the speed
 * of the wall, or its velocity along its normal, which is 0. */
TS_INLINE int ts_laws_rebound(const struct ts_laws *laws, int wall, int u)
{
	const int fast = laws->normal == TS_LAWS_WALL_SPEED ? ts_laws_abs(wall) : 0;
	const int d = ts_laws_scale(laws->wall_restitution, ts_laws_abs(fast - u), TS_LAWS_FRACTION);

	return fast > u ? fast - d : fast + d;
}

/* A wall along an axis: `normal` 1 along y, 0 along x. */
TS_INLINE struct ts_laws_velocity ts_laws_wall(const struct ts_laws *laws, int normal, int wall,
					       struct ts_laws_velocity v)
{
	struct ts_laws_velocity after;
	const int towards = normal ? v.y : v.x;
	int away = ts_laws_rebound(laws, wall, ts_laws_abs(towards));

	if (towards > 0)
		away = -away;
	if (normal) {
		after.x = ts_laws_along(laws, wall, v.x);
		after.y = away;
	} else {
		after.x = away;
		after.y = ts_laws_along(laws, 0, v.y);
	}
	return after;
}

/* ---- laws of speeds, directions by a table */

/* (8) and (9) for the speeds of both granules. Granule 1 turns back, to one of the two directions beside the opposite one;
 * granule 2 keeps its direction. */
TS_INLINE void ts_laws_table_pair(const struct ts_laws *laws, uint32_t *w1, uint32_t *w2, unsigned r)
{
	const int s1 = ts_cell_speed(*w1), s2 = ts_cell_speed(*w2);
	const int d = ts_laws_scale(laws->pair, ts_laws_abs(s1 - s2), TS_LAWS_FRACTION);

	*w1 = ts_cell_turned(*w1, s1 > s2 ? s1 - d : s1 + d, (ts_cell_direction(*w1) + (r & 1 ? 3 : 5)) & 7);
	*w2 = ts_cell_turned(*w2, s1 > s2 ? s2 + d : s2 - d, ts_cell_direction(*w2));
}

/* Directions normal to the wall are reversed, with (7); those along a diagonal are reflected, with (6) for the speed of the
 * wall. */
TS_INLINE uint32_t ts_laws_table_wall(const struct ts_laws *laws, uint32_t w, bool along_x, bool along_y,
				      int wall)
{
	const unsigned d = ts_cell_direction(w);
	const unsigned after = ts_cell_direction_of(along_y ? -ts_cell_dx(d) : ts_cell_dx(d),
						    along_x ? -ts_cell_dy(d) : ts_cell_dy(d));
	const int s = ts_cell_speed(w);

	if (d & 1)
		return ts_cell_turned(w, ts_laws_along(laws, ts_laws_abs(wall), s), after);
	return ts_cell_turned(w, ts_laws_rebound(laws, wall, s), after);
}

/* ---- the speed and the direction of a velocity */

TS_INLINE uint32_t ts_laws_is_clipped(struct ts_laws_velocity v)
{
	return (uint32_t)(TS_CELL_ONE - ts_laws_abs(v.x)) >> 31 |
	       (uint32_t)(TS_CELL_ONE - ts_laws_abs(v.y)) >> 31;
}

/* The granule w with the velocity v, by its speed max(|v_x|, |v_y|), at most 1, and a direction. v is between a direction
 * along an axis and a diagonal: with a random number r = 0 .. 65535 the diagonal is chosen with the probability
 * min/max, so that the mean velocity is v; with `nearest` the one with the smaller angle to v. Without branches, which
 * could not be predicted. */
TS_INLINE uint32_t ts_laws_turn(const struct ts_laws *laws, uint32_t w, struct ts_laws_velocity v, unsigned r)
{
	const int ax = ts_laws_abs(v.x), ay = ts_laws_abs(v.y);
	const int most = ax > ay ? ax : ay, least = ax > ay ? ay : ax;
	/* r most is below 2^31, as |v| < 4 cells a step; tan 22.5 degrees = 0.4142 */
	const unsigned diagonal = laws->directions == TS_LAWS_RANDOM
					  ? (r * (unsigned)most - ((unsigned)least << 16)) >> 31
					  : (unsigned)(most * 12 - least * 29) >> 31;
	/* by the signs of v_x and v_y, and whether |v_x| >= |v_y|; four bits each */
	const unsigned k = (unsigned)(v.x < 0) | (unsigned)(v.y < 0) << 1 | (unsigned)(ax >= ay) << 2;
	const unsigned direction = (diagonal ? 0x57315731u : 0x40406622u) >> 4 * k & 7;

	return ts_cell_turned(w, most > TS_CELL_ONE ? TS_CELL_ONE : most,
			      most == 0 ? ts_cell_direction(w) : direction);
}

#endif
