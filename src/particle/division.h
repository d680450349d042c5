/* Particles divided among ranks: each has those in its block of space, by their positions at the last rebuild of the
 * contact list, and copies of those near it. Everything that belongs to a particle moves with it: its columns, and the
 * rows of styles with a carrier (core/carried.h).
 *
 * Bits do not depend on the ranks: an image or a copy has the numbers of its original, each rank computes the contacts
 * of its own particles, also those with copies, and sums them in the order of the partners' identities. */
#ifndef TS_PARTICLE_DIVISION_H
#define TS_PARTICLE_DIVISION_H

#include "core/carried.h"
#include "particle/copies.h"
#include "rank/blocks.h"

struct ts_plan;

/* All ranks have all particles for a look at their columns: those of other ranks follow the own ones, in the place of the
 * ghosts. The lists of the own particles stay; they are valid again when the ghosts are back. */
struct ts_look {
	size_t n, nghost; /* own particles and ghosts */
	size_t columns;	  /* numbers of the ghosts in each of the first `columns` columns that is active */
	struct ts_parcel ghosts;
	/* The virial of the contacts and bonds of all ranks, which outputs cannot sum then; of this step: contact/virial.h */
	double virial[6];
	int64_t virial_step;
};

struct ts_division {
	int ranks;
	struct ts_rank_blocks blocks;
	size_t cut_most; /* particles of the block that had most when the blocks were cut */
	bool held; /* the blocks are those of the command or fix balance: they are not cut again for the numbers */
	struct ts_copies copies;
	struct ts_carried *carried; /* [ncarried], by live style with a carrier */
	size_t ncarried, carried_capacity;
	struct ts_carried *turned; /* [nturned], by live style with a carrier: particle/turning.h */
	size_t nturned, turned_capacity;
	bool unjoined; /* at rest behind a run whose sums are of each rank alone: slot `join` of styles */
	bool turned_before; /* rows that depend on periodic faces have been exchanged for this rebuild */
	bool rebuilding;    /* lists are made again for other particles: it is no rebuild of the run */
	struct ts_str said; /* warnings of this rank, of which the first one is to print those that are new */
	int64_t built, made; /* how often copies were made, and how many */
	int64_t moved;	     /* particles that have come from other ranks */
	int64_t gathered;    /* how often all ranks got all particles */
	int64_t listed;	     /* how often contacts, too */
	struct ts_look look;
	/* Each rank has its own particles of a file, or of those that commands have made, and nothing has been computed: who
	 * needs all gets them by this function. release: NULL: there is nothing to release. */
	struct ts_reread {
		enum ts_status (*all)(struct tsim *sim, void *data);
		void (*release)(void *data);
		void *data;
	} reread;
	size_t least, most; /* fewest and most particles of a rank when they were gathered last */
};

/* Slots of struct ts_tables. */
enum ts_status ts_division_keep_own(struct tsim *sim);
enum ts_status ts_division_divide(struct ts_plan *plan, struct tsim *sim);
enum ts_status ts_division_gather(struct ts_plan *plan, struct tsim *sim, bool lists);
enum ts_status ts_division_rest(struct tsim *sim, bool begins);
/* While the particles are divided: appends those with chosen[i] (NULL: all) of the other ranks to the own ones of each rank, in
 * the place of the ghosts, until ts_division_hide; all ranks call both. Else there is nothing to do. */
enum ts_status ts_division_show(struct tsim *sim, const unsigned char *chosen);
enum ts_status ts_division_hide(struct tsim *sim);
/* Before particles are read divided: the blocks of ranks by the places that particles have in the file. */
enum ts_status ts_division_begin(struct tsim *sim, double (*x)[3], size_t n);
bool ts_division_owns(const struct tsim *sim, const double x[3]);
/* They have been read. */
void ts_division_start(struct tsim *sim, const struct ts_reread *reread);
/* Whether all particles of the file are being read instead, by all ranks. */
bool ts_division_rereads(const struct tsim *sim);
/* Lists are made, or all ranks have all particles: the file is not needed again. */
void ts_division_read_out(struct tsim *sim);

/* Whether each rank may keep its own only of the particles that a command makes before the first run. */
bool ts_division_can_make(const struct tsim *sim);
/* Particles are to be made at the places of all ranks, of which this one knows x[n]: the division begins, if it has not, and
 * its blocks are cut for these. */
enum ts_status ts_division_make(struct tsim *sim, double (*x)[3], size_t n);
/* Then: the rank of a particle that is made there. */
int32_t ts_division_owner(const struct tsim *sim, const double x[3]);
/* What is to become particles, rows of `size` bytes. */
struct ts_new_rows {
	void *row;
	size_t n, capacity; /* of the memory, in rows */
	size_t size;
};
/* Sends each row to rank to[k]; those of this rank come in the order of the ranks that had them. */
enum ts_status ts_division_send(struct tsim *sim, struct ts_new_rows *rows, const int32_t *to);
/* Of rows that ranks have one after the other, of which this rank has n: how many come before these, and of all ranks. */
enum ts_status ts_division_count(struct tsim *sim, size_t n, size_t *before, size_t *all);
/* They have been made: where the blocks do not fit those of before, too, they are cut again. */
enum ts_status ts_division_made(struct tsim *sim);
/* Slots of the system of particles. */
const char *ts_division_undivided(const struct tsim *sim);
bool ts_division_whole_step(const struct tsim *sim, bool set_up);
void ts_division_free(struct ts_division *division);

/* In PRE_EXCHANGE, before and after each rank adds its own of n new particles. */
enum ts_status ts_division_begin_new(struct tsim *sim);
void ts_division_end_new(struct tsim *sim, size_t n);
/* In EXCHANGE, before particles are wrapped or deleted: exchanges rows that depend on periodic faces. */
enum ts_status ts_division_let_go(struct tsim *sim);
/* After that: moves particles and their rows to the ranks of their new positions. */
enum ts_status ts_division_migrate(struct tsim *sim);
/* The sum of the numbers of all ranks while the particles are divided, else the number itself. */
int64_t ts_division_sum(const struct tsim *sim, int64_t number);

/* Cuts the box into a block for each of so many ranks, with the same number of particles; by the positions at the last
 * rebuild. */
enum ts_status ts_division_cut(struct tsim *sim, int ranks, struct ts_rank_blocks *blocks);

/* The blocks that so many ranks would have: those that balance has chosen, or those of ts_division_cut. */
enum ts_status ts_division_plan(struct tsim *sim, int ranks, struct ts_rank_blocks *blocks);

/* The blocks of the present ranks, or of those for which a run is planned, for the commands that change them; made if there are none that fit the box. */
enum ts_status ts_division_blocks(struct tsim *sim, struct ts_rank_blocks **blocks);
/* A grid of equal blocks instead. */
enum ts_status ts_division_cut_equal(struct tsim *sim, struct ts_rank_blocks *blocks);

/* Whether the coordinate x is within `reach` of the block of this rank; without ranks always. */
bool ts_division_near(const struct tsim *sim, int dim, double x, double reach);

/* Those of the ranks; NULL while each has all particles. */
static inline const struct ts_rank_blocks *ts_division_blocks_now(const struct tsim *sim)
{
	return sim->division ? &sim->division->blocks : NULL;
}

#endif
