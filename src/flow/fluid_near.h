/* The cells near the particles of a rank, while ranks have the fluid in some planes only (fluid->planes): a rank has the
 * fields that its particles read there, and adds what they do to its own cells. Two exchanges, each in one message from rank to
 * rank:
 *   gather: what ranks have added to their own cells (flow/cell_owners.h) comes to those that compute the planes;
 *   spread: what ranks have computed in their slabs comes to those with particles near it.
 * Where they differ, a rank computes other planes than those in which its particles are. */
#ifndef TS_FLOW_FLUID_NEAR_H
#define TS_FLOW_FLUID_NEAR_H

#include "flow/cell_owners.h"

struct ts_fluid;

/* Ranges of indices along an axis, from .. to - 1, in order, apart. */
enum { TS_CELL_SPANS = 4 };
struct ts_cell_spans {
	int n;
	struct ts_cell_span {
		int from, to;
	} of[TS_CELL_SPANS];
};

static inline bool ts_cell_spans_have(const struct ts_cell_spans *spans, int k)
{
	bool have = false;

	for (int s = 0; s < spans->n; s++)
		have |= k >= spans->of[s].from && k < spans->of[s].to;
	return have;
}

/* Zero-initialise; ts_fluid_near_release when done. */
struct ts_fluid_near {
	bool active;   /* ranks have planes, and particles in the fluid */
	bool pressure; /* fixes read the pressure at particles */
	bool wanted;   /* by a fix that is being defined, and is not known to the simulation yet */
	/* What it was made for: ts_cell_owners_hash; how far particles are from the block of their rank at most (length); number
	 * of cells beyond its own to which a particle adds. A change of the last two is followed by another `ranks` 0. */
	uint64_t made_for;
	double margin;
	int reach;
	/* Step in which all ranks have agreed last that particles are near, and how often steps had been numbered anew. */
	int64_t agreed, era;
	int64_t begun; /* step in whose set-up this run has begun: what is agreed in it may not hold for all of it */
	bool stale; /* the values near particles are not those of the planes: the next agreement gets them */
	int ranks;  /* 0: it is not made */
	struct ts_cell_owners owners;
	/* Of each rank; owned, as the arrays below. */
	struct ts_near_rank {
		struct ts_cell_spans cell[3]; /* near its particles */
		struct ts_cell_spans planes;  /* of its slab and the halo, with images in the grid */
		struct ts_cell_spans beyond;  /* planes near its particles that are none of these */
	} * rank;
	struct ts_parcel *out, *in; /* [ranks] */
	size_t rank_capacity, out_capacity, in_capacity;
};

/* Makes it for these blocks, if it is not there yet; *made: it was not (NULL: not asked). The slabs of the fluid are those of
 * the ranks. */
enum ts_status ts_fluid_near_make(struct ts_fluid *fluid, const struct ts_rank_blocks *blocks, bool *made);
void ts_fluid_near_release(struct ts_fluid_near *near);
/* Whether plane k, which may be one of ghosts, is near the particles of this rank. */
bool ts_fluid_near_has_plane(const struct ts_fluid *fluid, int k);

/* Sets a field to zero in the planes of this rank and near its particles. */
void ts_fluid_near_clear(const struct ts_fluid *fluid, double *field);
/* What is near the particles of this rank. */
const struct ts_near_rank *ts_fluid_near_own(const struct ts_fluid *fluid);

#endif
