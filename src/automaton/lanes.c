#include "automaton/lanes.h"

#include "automaton/granule.h"
#include "base/inline.h"

#include "base/banned.h"

/* Truth values are numbers 0 and 1: gcc does not vectorise loops that combine those of different widths. */
struct work {
	_Alignas(64) uint32_t w[TS_LANES];	      /* the granule that is updated */
	uint32_t tried[TS_LANES];		      /* bits of directions */
	uint32_t done[TS_LANES];		      /* its update is complete */
	int32_t first[TS_LANES], left[TS_LANES];      /* begin of its list, what is left of it */
	uint64_t draw[TS_LANES], increment[TS_LANES]; /* struct ts_draws_stream */
	int32_t c[TS_LANES], at[TS_LANES];	      /* its cell and the one in its direction */
	uint32_t here[TS_LANES], there[TS_LANES];     /* what these are to be */
	uint32_t active[TS_LANES];		      /* the lane has a granule */
	uint32_t ended[TS_LANES];		      /* the lane has no more blocks */
	uint32_t fixed[TS_LANES];		      /* a fixed cell is in its direction */
};

/* What a round finds in all lanes together, and counts. */
struct found {
	uint32_t active; /* number of lanes */
	uint32_t fixed;	 /* any */
	uint32_t moved, collided, clipped;
};

#define ATTEMPT_ARGS                                                                                  \
	const uint32_t *restrict cell, int32_t stride, const uint32_t *restrict mover, uint32_t pair, \
		struct work *restrict b, struct found *restrict found

/* One attempt of a granule in each lane. A lane whose granule is done takes the next. What happens at fixed cells is left to
 * the caller. Cells are not written, so that all lanes can be computed at a time. */
TS_INLINE void attempt(ATTEMPT_ARGS)
{
	const struct ts_laws laws = { .pair = pair }; /* options of ts_lanes_suit, which are 0 */
	uint32_t actives = 0, any_fixed = 0, moved = 0, collided = 0, clipped = 0;

#pragma omp simd reduction(| : any_fixed) reduction(+ : actives, moved, collided, clipped)
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
		actives += active;
		any_fixed |= fixed;
		moved += empty;
		collided += met;
		clipped += met * (ts_laws_is_clipped(u1) + ts_laws_is_clipped(u2));
	}
	found->active = actives;
	found->fixed = any_fixed;
	found->moved += moved;
	found->collided += collided;
	found->clipped += clipped;
}

/* The same for instruction sets with gathers, which target_clones (base/clones.h) would not use: gcc 12 replaces them by single
 * loads unless it tunes for a processor where they are fast. NULL: this processor has none. */
typedef void attempt_fn(ATTEMPT_ARGS);

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
__attribute__((target("avx2,tune=skylake"))) static void attempt_avx2(ATTEMPT_ARGS)
{
	attempt(cell, stride, mover, pair, b, found);
}

__attribute__((target("avx512f,tune=skylake"))) static void attempt_avx512(ATTEMPT_ARGS)
{
	attempt(cell, stride, mover, pair, b, found);
}

static attempt_fn *attempt_here(void)
{
	return __builtin_cpu_supports("avx512f") ? attempt_avx512
	       : __builtin_cpu_supports("avx2")	 ? attempt_avx2
						 : NULL;
}
#else
static attempt_fn *attempt_here(void)
{
	return NULL;
}
#endif

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

/* Lanes whose blocks are complete take others. Returns the number of lanes that have a block. */
static uint32_t take_blocks(struct work *b, const struct ts_lanes *lanes, struct ts_automaton_count *count)
{
	uint32_t live = 0;

	for (int k = 0; k < TS_LANES; k++) {
		struct ts_lane lane = { .mover = lanes->mover + (size_t)k * lanes->most };

		if (!b->active[k] && !b->ended[k] && lanes->next(lanes->context, &lane)) {
			count->due += lane.left;
			b->left[k] = lane.left + 1; /* attempt counts the one before */
			b->draw[k] = lane.draws.at;
			b->increment[k] = lane.draws.increment;
			b->done[k] = 1;
		} else if (!b->active[k]) {
			b->ended[k] = 1;
		}
		live += !b->ended[k];
	}
	return live;
}

void ts_lanes_update(struct ts_automaton_lattice *l, const struct ts_laws *laws, const struct ts_lanes *lanes,
		     struct ts_automaton_count *count)
{
	attempt_fn *attempt_all = attempt_here();
	struct found found = { 0 };
	struct work b = { 0 };
	uint32_t live;

	for (int k = 0; k < TS_LANES; k++) {
		lanes->mover[(size_t)k * lanes->most] = 0;
		b.first[k] = (int32_t)((size_t)k * lanes->most);
	}
	live = take_blocks(&b, lanes, count);
	while (live > 0) {
		attempt_all(l->cell, (int32_t)l->stride, lanes->mover, laws->pair, &b, &found);
		for (int k = 0; k < TS_LANES && found.fixed; k++)
			if (b.fixed[k])
				attempt_at_fixed(l, laws, &b, k, count);
		write_cells(l->cell, &b);
		if (found.active < live)
			live = take_blocks(&b, lanes, count);
	}
	count->moved += found.moved;
	count->collided += found.collided;
	count->clipped += found.clipped;
}

bool ts_lanes_suit(const struct ts_laws *laws)
{
	return laws->contact == TS_LAWS_OFFSET && laws->directions == TS_LAWS_RANDOM &&
	       laws->partner == TS_LAWS_TURNS && attempt_here();
}
