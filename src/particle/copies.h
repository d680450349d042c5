/* Copies of particles of other ranks: the first ghosts, exact in all columns when they are made, and up to date in the
 * columns that are forwarded to ghosts in each step. Their periodic images are ghosts like those of local particles.
 */
#ifndef TS_PARTICLE_COPIES_H
#define TS_PARTICLE_COPIES_H

#include "particle/particles.h"
#include "rank/blocks.h"

/* Copies that a rank has, and that it sends. */
struct ts_copies {
	size_t n;	  /* ghosts 0 .. n-1 */
	size_t *received; /* by rank: how many of them, in this order */
	size_t *sent;	  /* by rank: how many of `row` */
	int32_t *row;	  /* local particles that are sent, rank by rank */
	size_t row_capacity;
	struct ts_parcel *out, *in; /* by rank */
};

enum ts_status ts_copies_init(struct ts_copies *copies, int ranks);
void ts_copies_release(struct ts_copies *copies, int ranks);

/* Number of copies; 0 without ranks. */
size_t ts_copies(const struct tsim *sim);
/* The rank that copy k, k < copies->n, is from. */
int ts_copies_rank(const struct ts_copies *copies, size_t k);

/* Copies by identity. */
struct ts_copy_map {
	int32_t (*entry)[2]; /* identity; number of the copy */
	size_t n;
};

/* Makes the map, released by ts_copy_map_release; TS_OK or TS_NOMEM. */
enum ts_status ts_copy_map_make(const struct tsim *sim, struct ts_copy_map *map);
/* Number of the copy with this identity, or -1. */
int32_t ts_copy_map_find(const struct ts_copy_map *map, int32_t tag);
void ts_copy_map_release(struct ts_copy_map *map);

/* Particles of other ranks that a rank needs copies of however far away they are, such as partners of its bonds. any:
 * there may be such particles; the same on all ranks. */
struct ts_claims {
	bool any;
	struct ts_parcel rows; /* int32_t[2]: this rank, and an identity or minus the number of a body */
	int rank;
};
enum ts_status ts_claims_add(struct tsim *sim, struct ts_claims *claims, int32_t tag);
/* All members of a rigid body. */
enum ts_status ts_claims_add_body(struct tsim *sim, struct ts_claims *claims, int32_t body);

/* Visits the ranks whose blocks are within `cutoff` of a periodic image of x, the place of a particle of the block `own` at
 * the last rebuild; in a sheared box some twice. */
void ts_copies_visit(const struct ts_domain *domain, const struct ts_rank_blocks *blocks,
		     const struct ts_rank_block *own, const double x[3], double cutoff,
		     ts_rank_visit_fn *visit, void *context);
/* Makes the copies of all particles of other ranks that are, or have a periodic image, within `cutoff` of the block
 * of this one, and of those that are claimed. */
enum ts_status ts_copies_make(struct tsim *sim, double cutoff);
/* Updates the columns that change in each step. */
void ts_copies_forward(struct tsim *sim);
/* Rows that copies get from their originals, of any number: count[k] for copy k, one copy after the other. */
struct ts_copied_rows {
	uint32_t *count;
	struct ts_parcel rows;
	size_t capacity;
};
/* Gets the rows of all copies; those of the own particle i are row first[i] .. first[i + 1] - 1, of `bytes` each. The particles
 * are divided. TS_OK or TS_NOMEM. */
enum ts_status ts_copies_forward_rows(struct tsim *sim, size_t bytes, const size_t *first, const void *row,
				      struct ts_copied_rows *got);
void ts_copied_rows_release(struct ts_copied_rows *rows);
/* Updates force and torque of copies that are members of rigid bodies. */
void ts_copies_forward_forces(struct tsim *sim);
/* Bytes that this sends of each copy. */
size_t ts_copies_step_bytes(const struct ts_particles *p);

/* Appends all columns of row i to a parcel; the bytes of one; writes them to row i. */
enum ts_status ts_copies_pack(const struct ts_particles *p, size_t i, struct ts_parcel *out);
size_t ts_copies_row_bytes(const struct ts_particles *p);
void ts_copies_unpack(const struct ts_particles *p, size_t i, const unsigned char *bytes);

#endif
