/* The contact list: one row for each candidate pair, two particles that may touch before the next rebuild.
 *
 * Rows are sorted by particle i (local), then by the identity of particle j. A contact law writes the
 * force of each row to a place of its own, without write conflicts; then each particle sums the forces of
 * its rows in the order of its partners' identities. So sums do not depend on the number of threads, on
 * the order of particles in memory, nor on which particle of a pair is i: the forces on i and j are
 * exactly opposite.
 *
 * A pair of local particles has one row. A local particle and a ghost have one row here, and the owner of
 * the ghost has another one. */
#ifndef TS_NEIGH_CONTACT_LIST_H
#define TS_NEIGH_CONTACT_LIST_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "core/sim.h"
#include "neigh/gather.h"
#include "particle/particles.h"

/* The data of a particle that contact laws read, packed: copied once a step, loaded by the loops as whole
 * vectors. */
struct ts_contact_sphere {
	double place[4];  /* x, y, z, radius */
	double motion[4]; /* velocity, 1/mass */
	double spin[4];	  /* angular velocity, radius again */
} __attribute__((aligned(32)));

/* Displacement of the surfaces of a pair in this step by its other contacts (law/halfspace.h), length; R*
 * with it. */
struct ts_contact_bulge {
	double bulge, r_eff;
};

/* An active pair: a row that may touch within the next steps, see active_pairs.h. */
struct ts_active_pair {
	uint32_t row, slot; /* of the list; of `result` */
	int32_t i, j;
};

/* Active pairs with the same contact law. The first `active` ones touched in the last force evaluation. */
enum { TS_ACTIVE_BLOCK = 128 };
struct ts_active_block {
	uint32_t first, n; /* at most TS_ACTIVE_BLOCK */
	uint32_t active;
	int32_t type[2]; /* of i, of j */
	size_t memory;	 /* offset of its columns in ts_contact_list.memory */
};

/* Active pairs and blocks of one parallel share of the list. TS_BLOCKS_AHEAD empty blocks follow them:
 * sentinels, so that the data of the next blocks can be prefetched without a bounds check. */
enum { TS_BLOCKS_AHEAD = 2 };
struct ts_contact_span {
	size_t near, near_end, block, block_end;
};

/* Particles adjacent in memory, whose forces are summed as soon as all their rows are computed. */
enum { TS_CONTACT_CHUNK = 64 };
struct ts_contact_chunk {
	size_t first, end; /* range of their active pairs; 0, 0: none */
};

/* Which forces and torques are stored; see force_slots.h. */
enum ts_contact_results {
	TS_RESULTS_NONE,   /* none: not computed since the list was built */
	TS_RESULTS_PASSED, /* none: they are summed into the particles and overwritten */
	TS_RESULTS_KEPT,   /* those of row r, in slot r */
};

struct ts_contact_list {
	size_t n, capacity;
	/* lists only pairs of two immobile particles; else only all other pairs */
	bool both_frozen;
	size_t particles; /* local particles when the list was built */
	int32_t *i, *j;	  /* indices of the columns of particles; i local, j local or ghost */
	int32_t *tag[2];  /* identities of i and j */
	uint8_t *image;	  /* which image of j: 13 = itself; see ts_image_code */
	int32_t *winding; /* which image, independent of periodic wrapping; ts_winding */
	enum ts_contact_results results;
	bool broken; /* liquid bridges have broken in this step: contact/liquid.h */
	/* the next sums are the first forces of the step: they overwrite p->f instead of adding to it */
	bool sets;
	/* By slot: force (ts_contact_force), then tangential and rolling torque if the laws have them;
	 * `parts` of them */
	double (*result)[4];
	int parts;
	size_t room;
	uint8_t *touching; /* 1: the surfaces overlap, or a bridge joins them */
	double *history;   /* history_width numbers per row; zero where the pair has never touched */
	double *memory;	   /* the history of touching active pairs, in columns: see contact_memory.h */
	bool unsettled;	   /* `memory` is newer than `history` */
	size_t history_width;
	/* 1 + which number of the history is > 0 while a bridge of liquid is there; 0: none has one */
	size_t bridged;
	const signed char *history_sign; /* +1 or -1: factor when i and j change places */

	struct ts_gather gather;	  /* the rows of each local particle */
	struct ts_contact_sphere *sphere; /* of all particles, in this step */
	size_t sphere_capacity;
	bool placed; /* those of local particles are written in this step */
	double step; /* largest displacement of these since the last step, length */

	/* The active pairs, see active_pairs.h */
	bool looked;		 /* they have been chosen */
	bool all;		 /* all rows are active: laws may attract beyond inner_skin */
	double skin, inner_skin; /* largest distance of surfaces of candidate pairs, of active pairs */
	/* upper bound of the approach of two particles since the active pairs were chosen, length */
	double travelled;
	double max_displacement; /* of a particle in the last step, length */
	int shares;
	struct ts_contact_span *span; /* of each share */
	struct ts_active_pair *near;
	struct ts_active_block *block;
	const struct ts_contact_bulge *bulge; /* by row; NULL: no surface is displaced */
	/* index in `near` by row, or TS_PAIR_INACTIVE; after slots are assigned: the stack of free slots */
	uint32_t *at;
	uint8_t *waiting; /* by active pair: how many of its two particles have not summed it yet */
	size_t span_capacity, near_capacity, block_capacity, memory_capacity, at_capacity, waiting_capacity;

	/* Like first and entry of the gather lists, but of active pairs: the slots that each particle sums */
	uint32_t *sum_first, *sum;
	struct ts_contact_chunk *chunk; /* of particles k TS_CONTACT_CHUNK ... */
	uint8_t *gathered;		/* by chunk: summed in this force evaluation */
	size_t chunks, sum_first_capacity, sum_capacity, chunk_capacity, gathered_capacity;
};

enum { TS_IMAGE_SELF = 13 };
/* Image shift (-1, 0, 1 per dimension) as a number 0..26. */
static inline uint8_t ts_image_code(const int8_t shift[3])
{
	return (uint8_t)(TS_IMAGE_SELF + shift[0] + 3 * shift[1] + 9 * shift[2]);
}

/* Box lengths between two images as seen without periodic wrapping, each modulo 1024. */
static inline int32_t ts_winding(const int32_t turns[3])
{
	return (turns[0] & 1023) | (turns[1] & 1023) << 10 | (turns[2] & 1023) << 20;
}

/* Builds the list of all pairs of particles whose distance at the last rebuild (xhold) is below r_i + r_j
 * + skin and of which at least one can move (none, if both_frozen). The history of touching pairs is
 * carried over. `excluded` may be NULL. */
typedef bool ts_excluded_fn(const struct tsim *sim, size_t i, size_t j);
enum ts_status ts_contact_list_build(struct tsim *sim, struct ts_contact_list *rows, double skin,
				     ts_excluded_fn *excluded);

/* The rows of share k of rows->shares: from .. to-1. */
static inline void ts_contact_range(const struct ts_contact_list *rows, size_t k, size_t *from, size_t *to)
{
	*from = rows->n * k / (size_t)rows->shares;
	*to = rows->n * (k + 1) / (size_t)rows->shares;
}

/* Adds the forces and torques of their rows to the particles from .. to-1, or overwrites them
 * (rows->sets). */
typedef void ts_contacts_sum_fn(const struct ts_contact_list *rows, const struct ts_particles *p, size_t from,
				size_t to);
ts_contacts_sum_fn *ts_contacts_sum_of(const struct ts_contact_list *rows);

/* The force on i in a slot, the opposite acts on j; zero where the pair does not touch. The fourth number
 * is half the overlap: the lever arms are the radii minus it. */
static inline double *ts_contact_force(const struct ts_contact_list *rows, size_t slot)
{
	return rows->result[slot * (size_t)rows->parts];
}

/* Torques, or NULL. Tangential: (radius - force[3]) times it acts on either particle. Rolling: it acts on
 * i, its opposite on j. The fourth number is always 0. */
static inline double *ts_contact_tangential_torque(const struct ts_contact_list *rows, size_t slot)
{
	return rows->parts > 1 ? rows->result[slot * (size_t)rows->parts + 1] : NULL;
}

static inline double *ts_contact_rolling_torque(const struct ts_contact_list *rows, size_t slot)
{
	return rows->parts > 2 ? rows->result[slot * (size_t)rows->parts + 2] : NULL;
}

/* Which torques the contact laws have besides forces. */
void ts_contact_list_set_torques(struct ts_contact_list *rows, bool turn, bool roll);
enum ts_status ts_contact_list_set_history(struct tsim *sim, struct ts_contact_list *rows, size_t width,
					   const signed char *sign);
/* Memory of the list in bytes. */
size_t ts_contact_list_bytes(const struct ts_contact_list *rows);
void ts_contact_list_release(struct ts_contact_list *rows);

#endif
