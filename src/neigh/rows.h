/* Contact rows: one row per pair of particles that may touch before the next rebuild.
 *
 * Rows are sorted by particle i (local), then by the partner's identity. Forces are computed over
 * rows, without write conflicts; then each particle gathers its own in the order of its partners'
 * identities. So sums do not depend on the number of threads, on the order of particles in memory,
 * nor on which of two partners owns the row: forces of a pair are exactly opposite.
 *
 * A pair of locals has one row; a local and a ghost have one row here and one on the other side. */
#ifndef TS_NEIGH_ROWS_H
#define TS_NEIGH_ROWS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "core/sim.h"
#include "neigh/gather.h"
#include "particle/particles.h"

/* What rows need of a particle, together: a copy that is made in each step, and that the loops read in whole vectors. */
struct ts_row_sphere {
	double place[4];  /* x, y, z, radius */
	double motion[4]; /* velocity, 1/mass */
	double spin[4];	  /* angular velocity, radius again */
} __attribute__((aligned(32)));

/* By how much the surfaces of a row stand out in this step, and R* with that. */
struct ts_row_bulge {
	double bulge, r_eff;
};

/* A row that is looked at. */
struct ts_row_near {
	uint32_t row, slot;
	int32_t i, j;
};

/* Near rows of one law. The first `active` ones touched when they were looked at last, the others wait for it. */
enum { TS_ROW_BLOCK = 128 };
struct ts_row_block {
	uint32_t first, n; /* at most TS_ROW_BLOCK */
	uint32_t active;
	int32_t type[2]; /* of i, of j */
	size_t memory;	 /* where its columns of rows->memory begin */
};

/* What belongs to one of the shares that are computed side by side. Behind its blocks there are empty ones, so that
 * what the next ones need can be sent for without a look whether there are any. */
enum { TS_ROW_AHEAD = 2 };
struct ts_row_span {
	size_t near, near_end, block, block_end;
};

/* Particles next to each other in memory, whose forces are added up together as soon as their rows are done. */
enum { TS_ROW_CHUNK = 64 };
struct ts_row_chunk {
	size_t first, end; /* their near rows lie within; 0, 0: there are none */
};

/* What becomes of forces and torques; see row_slots.h. */
enum ts_row_results {
	TS_RESULTS_NONE,   /* not computed since the rows were built */
	TS_RESULTS_PASSED, /* to the partners, and gone */
	TS_RESULTS_KEPT,   /* those of row r stand in slot r */
};

struct ts_rows {
	size_t n, capacity;
	bool both_held;	    /* the pairs of which neither can move, instead of all others */
	size_t particles;   /* how many there were when the rows were built */
	int32_t *i, *j;	    /* rows of the particle columns; i local, j local or ghost */
	int32_t *tag[2];    /* identities of i and j */
	uint8_t *image;	    /* which image of j: 13 = itself; see ts_image_code */
	int32_t *winding;   /* which image, in a way that wrapping does not change; ts_winding */
	enum ts_row_results results;
	bool broken; /* in this step bridges of liquid have: contact/liquid.h */
	bool sets; /* the next sums are the first forces of their step: nobody has set these to zero */
	/* Forces, see ts_row_force, and behind each, as far as contacts make torques (parts 2, 3), turn and roll */
	double (*result)[4];
	int parts;
	size_t room;
	uint8_t *touching;
	double *history; /* history_width numbers per row; zero where never touched */
	double *memory;	 /* of active rows, in columns: see row_memory.h */
	bool unsettled;	 /* that is newer */
	size_t history_width;
	size_t bridged; /* 1 + which number of the history is > 0 while a bridge of liquid is there; 0: none has one */
	const signed char *history_sign; /* +1 or -1: factor when i and j change places */

	struct ts_gather gather; /* of the local particles */
	struct ts_row_sphere *sphere; /* of all particles, now */
	size_t sphere_capacity;
	bool placed; /* those of local particles have been noted in this step */
	double step; /* the longest way of those noted, since all were */

	/* The rows that are looked at, see row_near.h */
	bool looked;	  /* they have been chosen */
	bool all;	  /* all are looked at: laws may pull from farther away */
	double skin, gap; /* of all rows, of those that are looked at */
	double travelled; /* since they were chosen: how far two particles have come nearer at most */
	double pace;	  /* the longest way of a particle in the last step */
	int shares;
	struct ts_row_span *span; /* of each share */
	struct ts_row_near *near;
	struct ts_row_block *block;
	const struct ts_row_bulge *bulge; /* of each row; NULL: surfaces do not move */
	uint32_t *at; /* where in `near` each row is, or TS_ROW_FAR; later slots that are free */
	uint8_t *waiting; /* of each near row: how many of its partners have not added it */
	size_t span_capacity, near_capacity, block_capacity, memory_capacity, at_capacity, waiting_capacity;

	/* Their sums: as first and entry of the gather, of near rows' slots in place of rows */
	uint32_t *sum_first, *sum;
	struct ts_row_chunk *chunk; /* of particles k TS_ROW_CHUNK ... */
	uint8_t *gathered;	    /* of each chunk, in this force evaluation */
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

/* Builds rows of all pairs of particles (xhold) nearer than r_i + r_j + skin, at least one of them
 * of finite mass (or none, if both_held says so); carries history over from the rows before. `excluded` may be NULL. */
typedef bool ts_excluded_fn(const struct tsim *sim, size_t i, size_t j);
enum ts_status ts_rows_build(struct tsim *sim, struct ts_rows *rows, double skin,
			     ts_excluded_fn *excluded);

/* The rows of share k of rows->shares: from .. to-1. */
static inline void ts_row_range(const struct ts_rows *rows, size_t k, size_t *from, size_t *to)
{
	*from = rows->n * k / (size_t)rows->shares;
	*to = rows->n * (k + 1) / (size_t)rows->shares;
}

/* Adds the forces and torques of the rows to those of the particles from .. to-1, or sets them (rows->sets). */
typedef void ts_rows_gather_fn(const struct ts_rows *rows, const struct ts_particles *p, size_t from,
			       size_t to);
ts_rows_gather_fn *ts_rows_gatherer(const struct ts_rows *rows);

/* The force in a slot: on i, j gets the opposite; zero where not touching. The fourth number is half the overlap, by
 * which the arms of torque are shorter than the radii. */
static inline double *ts_row_force(const struct ts_rows *rows, size_t slot)
{
	return rows->result[slot * (size_t)rows->parts];
}

/* Torques, or NULL: on either partner (radius - force[3]) turn, and roll on i, its opposite on j; the fourth number is
 * always 0. */
static inline double *ts_row_turn(const struct ts_rows *rows, size_t slot)
{
	return rows->parts > 1 ? rows->result[slot * (size_t)rows->parts + 1] : NULL;
}

static inline double *ts_row_roll(const struct ts_rows *rows, size_t slot)
{
	return rows->parts > 2 ? rows->result[slot * (size_t)rows->parts + 2] : NULL;
}

/* What contacts make besides forces. */
void ts_rows_set_torques(struct ts_rows *rows, bool turn, bool roll);
enum ts_status ts_rows_set_history(struct tsim *sim, struct ts_rows *rows, size_t width,
				   const signed char *sign);
/* What they take in memory, or will. */
size_t ts_rows_bytes(const struct ts_rows *rows);
void ts_rows_release(struct ts_rows *rows);

#endif
