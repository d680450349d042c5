/* The contact list: all candidate pairs, that is pairs of particles that may touch before the next rebuild.
 *
 * Pairs are sorted by particle i (local), then by the identity of particle j. The contact law writes the
 * force of each pair to a slot of its own, so threads do not conflict; then each particle sums the forces of
 * its pairs in the order of the identities of its partners. Hence the sums depend neither on the number of
 * threads nor on the order of particles in memory nor on which particle of a pair is i, and the forces on i
 * and j are exactly opposite.
 *
 * A pair of two local particles is listed once. A pair of a local particle and a ghost is listed once here,
 * and once more with the owner of the ghost as i. */
#ifndef TS_NEIGH_CONTACT_LIST_H
#define TS_NEIGH_CONTACT_LIST_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "core/sim.h"
#include "neigh/gather.h"
#include "particle/particles.h"

/* What contact laws read of a particle, packed once a step so that the loops load it as whole vectors: the sphere,
 * which decides whether a pair touches, and the motion, which is read of touching pairs only. */
struct ts_contact_sphere {
	double position[4]; /* x, y, z and radius, length */
} __attribute__((aligned(32)));
struct ts_contact_motion {
	double velocity[4]; /* velocity, length/time; 1/mass, 0 for immobile particles */
	double omega[4];    /* angular velocity, 1/time; radius again, length */
} __attribute__((aligned(64)));

/* Displacement of both surfaces of a pair in this step, caused by the other contacts of its particles
 * (law/halfspace.h), and the effective radius R* of the displaced surfaces; both lengths. */
struct ts_contact_bulge {
	double bulge, r_eff;
};

/* An active pair: a candidate pair that may touch within the next steps, see active_pairs.h. */
struct ts_active_pair {
	uint32_t row;  /* index of the pair in the contact list */
	uint32_t slot; /* index of its force in `result` */
	int32_t i, j;  /* the particles */
};

/* Active pairs with the same contact law. The first `touching` ones touched in the last force evaluation. */
enum { TS_ACTIVE_BLOCK = 128 };
struct ts_active_block {
	uint32_t first, n; /* active pairs first .. first+n-1, n <= TS_ACTIVE_BLOCK */
	uint32_t touching;
	int32_t type[2]; /* types of i and j */
	uint32_t column; /* length of each of its history columns: see contact_memory.h */
	double *memory;	 /* its history columns */
};

/* Active pairs and blocks of one share (one thread's part) of the contact list. TS_BLOCKS_AHEAD empty
 * sentinel blocks follow them, so that the data of the next blocks are prefetched without a bounds check. */
enum { TS_BLOCKS_AHEAD = 2 };
struct ts_contact_span {
	size_t active, active_end; /* active pairs active .. active_end-1 */
	size_t block, block_end;   /* blocks block .. block_end-1 */
};

/* TS_CONTACT_CHUNK particles adjacent in memory, whose forces are summed as soon as all pairs of all of them
 * are computed. */
enum { TS_CONTACT_CHUNK = 64 };
struct ts_contact_chunk {
	size_t first, end; /* range of their active pairs; 0, 0: none */
	bool divided;	   /* their active pairs are in several shares */
};

/* Which forces and torques are stored; see force_slots.h. */
enum ts_contact_results {
	TS_RESULTS_NONE,   /* none: not computed since the list was built */
	TS_RESULTS_PASSED, /* none: slots were reused after the particles had summed them */
	TS_RESULTS_KEPT,   /* all: that of pair r in slot ts_contact_kept(list, r) */
};

enum { TS_HISTORY_MOST = 64 }; /* numbers in the history of a contact */

struct ts_contact_list {
	size_t n, capacity; /* candidate pairs */
	/* lists only pairs of two immobile particles (for heat); else only all other pairs */
	bool both_frozen;
	size_t particles; /* number of local particles when the list was built */
	/* By pair, n numbers each: */
	int32_t *i, *j; /* indices of the particle columns; i local, j local or ghost */
	uint32_t *slot; /* 2 slot + 1 if the pair touches: ts_contact_touches, ts_contact_slot */

	/* history_width numbers each, zero where the pair has never touched: of which pairs, and where, see contact_memory.h */
	double *history;
	struct ts_history_word {
		uint64_t marks; /* of 64 pairs: which have an entry in `history` */
		uint32_t first; /* number of entries of the pairs before */
	} * history_word;
	size_t history_capacity, history_word_capacity;
	bool history_by_pair; /* all pairs have an entry, whatever the marks */

	/* By particle, ghosts included, as they were when the list was built: see ts_contact_tag and the functions
	 * after it. `image`: of ghosts only. */
	int32_t *tag, *turns;
	uint8_t *image;
	size_t tag_capacity, turns_capacity, image_capacity;

	enum ts_contact_results results;
	bool bridges_broken; /* liquid bridges broke in this step: contact/broken_bridges.h */
	/* the next sums are the first forces of the step: they overwrite p->f instead of adding to it */
	bool overwrite_sums;
	/* By slot, `parts` vectors each: force (see ts_contact_force), then tangential and rolling torque if
	 * the contact laws have them. result_capacity vectors are allocated. */
	double (*result)[4];
	int parts;
	size_t result_capacity;
	/* where all results are kept: the next slot that no pair has yet; in memory of its own, as loops copy the list */
	uint32_t *next_slot;

	double *memory;	   /* the history of touching active pairs, in columns: see contact_memory.h */
	double *spare;	   /* room for blocks whose columns have become too short; NULL: none can */
	bool memory_newer; /* `memory` has been advanced since it was last copied to `history` */
	size_t history_width;
	/* 1 + index of the history number that is > 0 while a liquid bridge exists; 0: no bridges */
	size_t bridge_column;
	/* by history number: factor +1 or -1 when i and j are swapped */
	signed char history_sign[TS_HISTORY_MOST];
	uint64_t pair; /* serial number of the pair style for which the list was made; 0: none */

	struct ts_gather gather;	  /* the candidate pairs of each local particle */
	struct ts_contact_sphere *sphere; /* of all particles, ghosts included, in this step */
	struct ts_contact_motion *motion;
	size_t sphere_capacity, motion_capacity;
	bool locals_packed; /* `sphere` and `motion` of the local particles is that of this step */
	double displacement; /* largest displacement of a particle since the last step so far, less drift, length */
	double drift[3]; /* displacement in a step of a frame, of which approaches do not depend, length */

	/* Active pairs, see active_pairs.h */
	bool active_chosen;	 /* false: they must be chosen before the next forces */
	bool all_active;	 /* all pairs are active: the laws may attract beyond inner_skin */
	double skin, inner_skin; /* largest gap between the surfaces of candidate, of active pairs, length */
	/* upper bound of the approach of any two particles since the active pairs were chosen, length */
	double approach;
	double max_displacement;      /* largest displacement in the last step, length */
	int shares;		      /* parts of the list, each computed by one thread */
	struct ts_contact_span *span; /* by share */
	struct ts_active_pair *active;
	struct ts_active_block *block;
	const struct ts_contact_bulge *bulge; /* by pair; NULL: no surface is displaced */
	size_t span_capacity, active_capacity, block_capacity, memory_capacity;

	/* The slots that particle i sums, see touching_sums.h: sums[i] of them, as 2 slot + side like the entries of
	 * the gather lists, but of touching pairs only. The first ones are in the row sum[TS_SUM_ROW i] .., which
	 * is filled up with `zero_slot`, a slot that is always zero; the rest from sum_rest[rest_first[i]] on. */
	uint32_t *sum, *sums, *sum_rest, *rest_first;
	uint8_t *sum_place; /* by entry of a row: its place in the gather list of the particle */
	bool sums_listed;   /* the lists above belong to this contact list */
	uint32_t zero_slot;
	bool sum_whole_rows;		/* most particles have more than half a row of touching pairs */
	struct ts_contact_chunk *chunk; /* chunk k: particles from k TS_CONTACT_CHUNK on */
	uint8_t *chunk_summed;		/* by chunk: summed in this force evaluation */
	size_t chunks, sum_capacity, sum_place_capacity, sums_capacity, sum_rest_capacity,
		rest_first_capacity, chunk_capacity, chunk_summed_capacity;
};

enum { TS_IMAGE_SELF = 13 };
/* Image shift (-1, 0 or 1 in each dimension) as a number 0..26; TS_IMAGE_SELF: not shifted. */
static inline uint8_t ts_image_code(const int8_t shift[3])
{
	return (uint8_t)(TS_IMAGE_SELF + shift[0] + 3 * shift[1] + 9 * shift[2]);
}

/* Numbers of box lengths in each dimension, modulo 1024, 10 bits each. */
static inline int32_t ts_winding(const int32_t turns[3])
{
	return (turns[0] & 1023) | (turns[1] & 1023) << 10 | (turns[2] & 1023) << 20;
}

/* a - b, dimension by dimension. */
static inline int32_t ts_winding_difference(int32_t a, int32_t b)
{
	int32_t turns[3];

	for (int k = 0; k < 3; k++)
		turns[k] = (a >> 10 * k & 1023) - (b >> 10 * k & 1023);
	return ts_winding(turns);
}

/* Identity of particle i (side 0) or j (side 1) of pair r. */
static inline int32_t ts_contact_tag(const struct ts_contact_list *list, size_t r, int side)
{
	return list->tag[side ? list->j[r] : list->i[r]];
}

/* Which periodic image j of pair r is, 0..26; see ts_image_code. */
static inline uint8_t ts_contact_image(const struct ts_contact_list *list, size_t r)
{
	size_t j = (size_t)list->j[r];

	return j < list->particles ? (uint8_t)TS_IMAGE_SELF : list->image[j - list->particles];
}

/* The same, but independent of periodic wrapping: x_i - x_j + winding L is the separation of the unwrapped
 * positions (L the box lengths). */
static inline int32_t ts_contact_winding(const struct ts_contact_list *list, size_t r)
{
	return ts_winding_difference(list->turns[list->i[r]], list->turns[list->j[r]]);
}

/* The slot of a pair that is not active, and, where all results are kept, of one that has not touched yet. */
enum { TS_PAIR_INACTIVE = INT32_MAX };

/* The slot of an active pair, or TS_PAIR_INACTIVE; while slots are assigned: its index in `active`. It stands in one
 * number with the touch, as the sums of a particle look both up for pairs that are scattered in memory. */
static inline uint32_t ts_contact_slot(const struct ts_contact_list *list, size_t r)
{
	return list->slot[r] >> 1;
}

static inline void ts_contact_set_slot(const struct ts_contact_list *list, size_t r, uint32_t slot)
{
	list->slot[r] = slot << 1 | (list->slot[r] & 1);
}

/* Whether the surfaces of pair r overlap, or a liquid bridge joins them. */
static inline bool ts_contact_touches(const struct ts_contact_list *list, size_t r)
{
	return list->slot[r] & 1;
}

/* Where all results are kept: the slot of pair r; that which is zero if the pair does not touch. */
static inline size_t ts_contact_kept(const struct ts_contact_list *list, size_t r)
{
	return ts_contact_touches(list, r) ? ts_contact_slot(list, r) : list->zero_slot;
}

static inline void ts_contact_set_touching(const struct ts_contact_list *list, size_t r, bool touches)
{
	list->slot[r] = (list->slot[r] & ~(uint32_t)1) | touches;
}

/* The same for an active pair, whose slot is known: nothing is read, as the number is rarely in the cache. */
static inline void ts_contact_set_active(const struct ts_contact_list *list,
					 const struct ts_active_pair *pair, bool touches)
{
	list->slot[pair->row] = pair->slot << 1 | touches;
}

/* Builds the list of all pairs of particles whose distance at the last rebuild (xhold) is less than r_i + r_j
 * + skin and of which at least one is mobile (none, if list->both_frozen). The history of touching pairs is
 * carried over. `excluded`: pairs to leave out, d: vector from (the image of) j to i; may be NULL. */
typedef bool ts_excluded_fn(const struct tsim *sim, size_t i, size_t j, const double d[3]);
enum ts_status ts_contact_list_build(struct tsim *sim, struct ts_contact_list *list, double skin,
				     ts_excluded_fn *excluded);

/* The candidate pairs of share k of list->shares: from .. to-1. */
static inline void ts_contact_range(const struct ts_contact_list *list, size_t k, size_t *from, size_t *to)
{
	*from = list->n * k / (size_t)list->shares;
	*to = list->n * (k + 1) / (size_t)list->shares;
}

/* The force on i in a slot; the opposite acts on j; zero where the pair does not touch. The fourth number is
 * half the overlap, length: the lever arms of the tangential force are the radii minus it. */
static inline double *ts_contact_force(const struct ts_contact_list *list, size_t slot)
{
	return list->result[slot * (size_t)list->parts];
}

/* Torques, or NULL if the laws have none. Tangential: a vector c per lever arm; the torque (radius -
 * force[3]) c acts on each of the two particles. Rolling: the torque acts on i, the opposite on j. The fourth
 * number is 0. */
static inline double *ts_contact_tangential_torque(const struct ts_contact_list *list, size_t slot)
{
	return list->parts > 1 ? list->result[slot * (size_t)list->parts + 1] : NULL;
}

static inline double *ts_contact_rolling_torque(const struct ts_contact_list *list, size_t slot)
{
	return list->parts > 2 ? list->result[slot * (size_t)list->parts + 2] : NULL;
}

/* Which torques the contact laws have besides forces: of tangential forces, of rolling friction. */
void ts_contact_list_set_torques(struct ts_contact_list *list, bool tangential, bool rolling);
/* Makes the history `width` numbers wide, all zero if that is a change; `sign`: see history_sign. */
enum ts_status ts_contact_list_set_history(struct tsim *sim, struct ts_contact_list *list, size_t width,
					   const signed char *sign);
/* Memory that the list takes, bytes. */
size_t ts_contact_list_bytes(const struct ts_contact_list *list);
void ts_contact_list_release(struct ts_contact_list *list);

#endif
