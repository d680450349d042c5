#include "automaton/lanes.h"

#include "automaton/granule.h"
#include "base/clones.h"
#include "base/inline.h"

#include "base/banned.h"

/* Truth values are numbers 0 and 1: gcc does not vectorise loops that combine those of different widths. */
struct work {
	int32_t c[TS_LANES];			      /* the cell of the granule that is updated */
	uint32_t w[TS_LANES];			      /* the granule */
	uint32_t tried[TS_LANES];		      /* bits of directions */
	int32_t at[TS_LANES];			      /* the cell in its direction */
	uint32_t other[TS_LANES];		      /* what is there */
	uint64_t draw[TS_LANES], increment[TS_LANES]; /* struct ts_draws_stream */
	uint32_t bits[3][TS_LANES]; /* random numbers; after collide: 0: at a fixed cell, 1: moves */
	uint32_t active[TS_LANES], done[TS_LANES]; /* the lane has a granule; its update is complete */
};

static bool any_of(const uint32_t *flag)
{
	uint32_t any = 0;

	for (int k = 0; k < TS_LANES; k++)
		any |= flag[k];
	return any != 0;
}

/* The granule that a lane takes next. */
TS_CLONES static void take_next(const uint32_t *restrict cell, const uint32_t *restrict mover,
				struct ts_lanes *restrict lanes, struct work *restrict b)
{
#pragma omp simd
	for (int k = 0; k < TS_LANES; k++) {
		const int32_t left = lanes->left[k] - (int32_t)b->done[k];
		const uint32_t on = left > 0 ? 1 : 0;
		const int32_t place = lanes->first[k] + (on ? left - 1 : 0);
		const int32_t c = (int32_t)mover[place];
		const uint32_t w = cell[c];

		lanes->left[k] = left;
		b->w[k] = b->done[k] ? w & 0x7fffffffu : b->w[k];
		b->tried[k] = b->done[k] ? 0 : b->tried[k];
		b->c[k] = c;
		b->active[k] = on;
	}
}

/* What is in the direction of the granules; *portals: some is beyond a portal. */
TS_CLONES static void look(const uint32_t *restrict cell, int32_t stride, struct work *restrict b,
			   uint32_t *portals)
{
	const uint32_t first = ts_cell_fixed(TS_CELL_LEFT_PORTAL);
	uint32_t any = 0;

#pragma omp simd reduction(| : any)
	for (int k = 0; k < TS_LANES; k++) {
		const unsigned d = ts_cell_direction(b->w[k]);
		const int32_t at = b->c[k] + ts_cell_dy(d) * stride + ts_cell_dx(d);
		const uint32_t other = cell[at];

		b->at[k] = at;
		b->other[k] = other;
		b->tried[k] |= 1u << d;
		any |= other >> 31 & ~(other >> TS_CELL_STATE) & (first - 1 - other) >> 31;
	}
	*portals = any;
}

static void look_through_portals(const struct ts_automaton_lattice *l, struct work *b)
{
	for (int k = 0; k < TS_LANES; k++) {
		size_t at;

		b->other[k] = ts_granule_neighbour(l, (size_t)b->c[k], ts_cell_direction(b->w[k]), &at);
		b->at[k] = (int32_t)at;
	}
}

/* The random numbers of the collisions. */
TS_CLONES static void draw(struct work *restrict b)
{
#pragma omp simd
	for (int k = 0; k < TS_LANES; k++) {
		const uint64_t hit =
			b->other[k] >> TS_CELL_STATE & b->active[k] & (0u - (b->w[k] & TS_CELL_SPEED)) >> 31;
		const uint64_t z = ts_draws_mix(b->draw[k] += b->increment[k] & (0 - hit));

		b->bits[0][k] = (uint32_t)(z & 0xffff);
		b->bits[1][k] = (uint32_t)(z >> 16 & 0xffff);
		b->bits[2][k] = (uint32_t)(z >> 32 & 0xffff);
	}
}

/* Collisions of granules; the others of the lanes stay as they are. A granule that cannot go on is done. */
TS_CLONES static void collide(const struct ts_laws *laws, struct work *b, uint32_t sum[3])
{
	const struct ts_laws usual = { .pair = laws->pair }; /* options of ts_lanes_suit, which are 0 */
	uint32_t moved = 0, collided = 0, clipped = 0;

#pragma omp simd reduction(+ : moved, collided, clipped)
	for (int k = 0; k < TS_LANES; k++) {
		const uint32_t w = b->w[k], other = b->other[k];
		const unsigned normal = ts_granule_normal(&usual, ts_cell_direction(w), b->bits[0][k]);
		const struct ts_laws_velocity v1 = ts_laws_velocity_of(w), v2 = ts_laws_velocity_of(other);
		const int closing = ts_laws_closing(normal, v1, v2);
		const int d = ts_laws_impulse(&usual, normal, closing > 0 ? closing : 0);
		const struct ts_laws_velocity u1 = ts_laws_changed(v1, normal, -d),
					      u2 = ts_laws_changed(v2, normal, d);
		const uint32_t w1 = ts_laws_turn(&usual, w, u1, b->bits[1][k]),
			       w2 = ts_laws_turn(&usual, other, u2, b->bits[2][k]);
		const uint32_t go = b->active[k] & (0u - (w & TS_CELL_SPEED)) >> 31;
		const uint32_t granule = go & other >> TS_CELL_STATE,
			       empty = go & ~(other >> TS_CELL_STATE | other >> 31);
		const uint32_t fixed = go & other >> 31 & ~(other >> TS_CELL_STATE);
		const uint32_t met = granule & (uint32_t)-closing >> 31;
		const uint32_t now = met ? w1 : w;
		const uint32_t rests = 1 ^ (0u - (now & TS_CELL_SPEED)) >> 31;

		b->w[k] = now;
		b->other[k] = met ? w2 : empty ? w : other;
		b->done[k] = b->active[k] & (fixed ^ 1) &
			     ((met ^ 1) | rests | b->tried[k] >> ts_cell_direction(now));
		b->bits[0][k] = fixed;
		b->bits[1][k] = empty;
		moved += empty;
		collided += met;
		clipped += met * (ts_laws_is_clipped(u1) + ts_laws_is_clipped(u2));
	}
	sum[0] += moved;
	sum[1] += collided;
	sum[2] += clipped;
}

/* Lanes at walls and obstacles, of which there are few. */
static void rebound(struct ts_automaton_lattice *l, const struct ts_laws *laws, struct work *b,
		    struct ts_automaton_count *count)
{
	for (int k = 0; k < TS_LANES; k++)
		if (b->bits[0][k]) {
			struct ts_draws_stream draws = { b->draw[k], b->increment[k] };

			b->w[k] = ts_granule_rebound(l, laws, (size_t)b->c[k], b->w[k], b->other[k], &draws,
						     count);
			b->draw[k] = draws.at;
			b->done[k] =
				ts_cell_speed(b->w[k]) == 0 || b->tried[k] >> ts_cell_direction(b->w[k]) & 1;
		}
}

void ts_lanes_update(struct ts_automaton_lattice *l, const struct ts_laws *laws, struct ts_lanes *lanes,
		     struct ts_automaton_count *count)
{
	uint32_t sum[3] = { 0 }, portals;
	struct work b;

	for (int k = 0; k < TS_LANES; k++) {
		count->due += lanes->left[k];
		lanes->left[k]++; /* take_next counts the one before */
		b.draw[k] = lanes->draws[k].at;
		b.increment[k] = lanes->draws[k].increment;
		b.done[k] = 1;
	}
	for (;;) {
		take_next(l->cell, lanes->mover, lanes, &b);
		if (!any_of(b.active))
			break;
		look(l->cell, (int32_t)l->stride, &b, &portals);
		if (portals)
			look_through_portals(l, &b);
		draw(&b);
		collide(laws, &b, sum);
		if (any_of(b.bits[0]))
			rebound(l, laws, &b, count);
		for (int k = 0; k < TS_LANES; k++)
			if (b.active[k]) {
				l->cell[b.at[k]] = b.other[k];
				l->cell[b.c[k]] = b.bits[1][k] ? TS_CELL_EMPTY : b.w[k];
			}
	}
	count->moved += sum[0];
	count->collided += sum[1];
	count->clipped += sum[2];
}

bool ts_lanes_suit(const struct ts_laws *laws)
{
	return laws->contact == TS_LAWS_OFFSET && laws->directions == TS_LAWS_RANDOM &&
	       laws->partner == TS_LAWS_TURNS;
}
