#include "automaton/lanes.h"

#include "automaton/granule.h"
#include "base/clones.h"
#include "base/inline.h"

#include "base/banned.h"

/* Truth values are numbers 0 and 1: gcc does not vectorise loops that combine those of different widths. */
struct work {
	_Alignas(64) uint32_t w[TS_LANES];	      /* the granule that is updated */
	uint32_t tried[TS_LANES];		      /* bits of directions */
	uint32_t done[TS_LANES];		      /* its update is complete */
	int32_t first[TS_LANES], left[TS_LANES];      /* struct ts_lanes */
	uint64_t draw[TS_LANES], increment[TS_LANES]; /* struct ts_draws_stream */
	int32_t c[TS_LANES], at[TS_LANES];	      /* its cell and the one in its direction */
	uint32_t here[TS_LANES], there[TS_LANES];     /* what these are to be */
	uint32_t active[TS_LANES];		      /* the lane has a granule */
	uint32_t fixed[TS_LANES];		      /* a fixed cell is in its direction */
};

/* What a round finds in all lanes together, and counts. */
struct found {
	uint32_t active, fixed;
	uint32_t moved, collided, clipped;
};

/* One attempt of a granule in each lane. A lane whose granule is done takes the next. What happens at fixed cells is left to
 * the caller. Cells are not written, so that all lanes can be computed at a time. */
TS_CLONES static void attempt(const uint32_t *restrict cell, int32_t stride, const uint32_t *restrict mover,
			      uint32_t pair, struct work *restrict b, struct found *restrict found)
{
	const struct ts_laws laws = { .pair = pair }; /* options of ts_lanes_suit, which are 0 */
	uint32_t any_active = 0, any_fixed = 0, moved = 0, collided = 0, clipped = 0;

#pragma omp simd reduction(| : any_active, any_fixed) reduction(+ : moved, collided, clipped)
	for (int k = 0; k < TS_LANES; k++) {
		/* the granule */
		const int32_t left = b->left[k] - (int32_t)b->done[k];
		const uint32_t active = left > 0 ? 1 : 0;
		const int32_t c = (int32_t)mover[b->first[k] + (active ? left - 1 : 0)];
		/* by masks: of a choice gcc makes a branch around the load, and does not vectorise */
		const uint32_t next = 0u - b->done[k];
		const uint32_t w = (cell[c] & 0x7fffffffu & next) | (b->w[k] & ~next);
		const unsigned d = ts_cell_direction(w);
		const uint32_t tried = (b->tried[k] & ~next) | 1u << d;
		/* what is in its direction */
		const int32_t at = c + ts_cell_dy(d) * stride + ts_cell_dx(d);
		const uint32_t other = cell[at];
		const uint32_t go = active & (0u - (w & TS_CELL_SPEED)) >> 31;
		const uint32_t granule = go & other >> TS_CELL_STATE,
			       empty = go & ~(other >> TS_CELL_STATE | other >> 31),
			       fixed = go & other >> 31 & ~(other >> TS_CELL_STATE);
		/* the collision */
		const uint64_t at_draw = b->draw[k] + (b->increment[k] & (0 - (uint64_t)granule));
		const uint64_t bits = ts_draws_mix(at_draw);
		const unsigned normal = ts_granule_normal(&laws, d, (uint32_t)bits & 0xffff);
		const struct ts_laws_velocity v1 = ts_laws_velocity_of(w), v2 = ts_laws_velocity_of(other);
		const int closing = ts_laws_closing(normal, v1, v2);
		const int by = ts_laws_impulse(&laws, normal, closing > 0 ? closing : 0);
		const struct ts_laws_velocity u1 = ts_laws_changed(v1, normal, -by),
					      u2 = ts_laws_changed(v2, normal, by);
		const uint32_t w1 = ts_laws_turn(&laws, w, u1, (uint32_t)bits >> 16);
		const uint32_t w2 = ts_laws_turn(&laws, other, u2, (uint32_t)(bits >> 32) & 0xffff);
		const uint32_t met = granule & (uint32_t)-closing >> 31;
		const uint32_t now = met ? w1 : w;
		const uint32_t rests = 1 ^ (0u - (now & TS_CELL_SPEED)) >> 31;

		b->left[k] = left;
		b->draw[k] = at_draw;
		b->c[k] = c;
		b->at[k] = at;
		b->w[k] = now;
		b->tried[k] = tried;
		b->here[k] = empty ? TS_CELL_EMPTY : now;
		b->there[k] = met ? w2 : empty ? w : other;
		b->active[k] = active;
		b->fixed[k] = fixed;
		b->done[k] = active & (fixed ^ 1) & ((met ^ 1) | rests | tried >> ts_cell_direction(now));
		any_active |= active;
		any_fixed |= fixed;
		moved += empty;
		collided += met;
		clipped += met * (ts_laws_is_clipped(u1) + ts_laws_is_clipped(u2));
	}
	found->active = any_active;
	found->fixed = any_fixed;
	found->moved += moved;
	found->collided += collided;
	found->clipped += clipped;
}

/* A lane in whose direction there is a fixed cell: a wall, an obstacle, or a portal, beyond which there may be anything. */
static void attempt_at_fixed(const struct ts_automaton_lattice *l, const struct ts_laws *laws, struct work *b,
			     int k, struct ts_automaton_count *count)
{
	struct ts_draws_stream draws = { b->draw[k], b->increment[k] };
	uint32_t w = b->w[k];
	size_t at;
	uint32_t other = ts_granule_neighbour(l, (size_t)b->c[k], ts_cell_direction(w), &at);
	const bool empty = other == TS_CELL_EMPTY;
	bool goes_on = !empty;

	if (ts_cell_state(other) == TS_CELL_FIXED)
		w = ts_granule_rebound(l, laws, (size_t)b->c[k], w, other, &draws, count);
	else if (!empty)
		goes_on = ts_granule_collide(laws, &w, &other, &draws, count);
	count->moved += empty;
	b->draw[k] = draws.at;
	b->at[k] = (int32_t)at;
	b->w[k] = w;
	b->here[k] = empty ? TS_CELL_EMPTY : w;
	b->there[k] = empty ? w : other;
	b->done[k] = !goes_on || ts_cell_speed(w) == 0 || (b->tried[k] >> ts_cell_direction(w) & 1);
}

static void write_cells(uint32_t *restrict cell, const struct work *restrict b)
{
	for (int k = 0; k < TS_LANES; k++)
		if (b->active[k]) {
			cell[b->at[k]] = b->there[k];
			cell[b->c[k]] = b->here[k];
		}
}

static void start(struct work *b, const struct ts_lanes *lanes, struct ts_automaton_count *count)
{
	for (int k = 0; k < TS_LANES; k++) {
		count->due += lanes->left[k];
		b->first[k] = lanes->first[k];
		b->left[k] = lanes->left[k] + 1; /* attempt counts the one before */
		b->draw[k] = lanes->draws[k].at;
		b->increment[k] = lanes->draws[k].increment;
		b->done[k] = 1;
		b->w[k] = b->tried[k] = 0;
	}
}

void ts_lanes_update(struct ts_automaton_lattice *l, const struct ts_laws *laws, const struct ts_lanes *lanes,
		     struct ts_automaton_count *count)
{
	struct found found = { 0 };
	struct work b;

	start(&b, lanes, count);
	for (;;) {
		attempt(l->cell, (int32_t)l->stride, lanes->mover, laws->pair, &b, &found);
		if (!found.active)
			break;
		for (int k = 0; k < TS_LANES && found.fixed; k++)
			if (b.fixed[k])
				attempt_at_fixed(l, laws, &b, k, count);
		write_cells(l->cell, &b);
	}
	count->moved += found.moved;
	count->collided += found.collided;
	count->clipped += found.clipped;
}

bool ts_lanes_suit(const struct ts_laws *laws)
{
	return laws->contact == TS_LAWS_OFFSET && laws->directions == TS_LAWS_RANDOM &&
	       laws->partner == TS_LAWS_TURNS;
}
