/* What the command and the fix balance have in common: their words, and the change of the blocks of ranks. */
#ifndef TS_BALANCE_RANK_BALANCE_H
#define TS_BALANCE_RANK_BALANCE_H

#include "balance/weights.h"
#include "rank/blocks.h"

/* After the threshold: words of the argument table; and what they mean. */
struct ts_rank_balance {
	const char *what; /* for messages */
	double threshold;
	struct ts_words cuts[3], shift, weight;
	bool rcb;
	const char *file; /* NULL: none */

	bool uniform[3], given[3]; /* by dimension: equal blocks, or those of `cuts` */
	int order[3], dimensions;  /* shift: along which dimensions */
	int64_t bisections;	   /* along each of them, at most */
	double enough;		   /* stops at this imbalance */
	struct ts_weights weights;
	struct ts_rank_blocks alone; /* without ranks: one block */
};

struct ts_balance_result {
	double before, after; /* imbalance */
	double most;	      /* weight of the rank that has most */
	int iterations;
};

/* Reads the words; fails where they are wrong. */
enum ts_status ts_balance_read(struct ts_rank_balance *balance, struct tsim *sim,
			       const struct ts_place *where);
/* Weighs the particles; where the imbalance is larger than the threshold the blocks are changed: for the next division, or the
 * exchange of this rebuild. With ranks all call it. */
enum ts_status ts_balance_apply(struct ts_rank_balance *balance, struct tsim *sim,
				const struct ts_place *where, struct ts_balance_result *result);
void ts_balance_release(struct ts_rank_balance *balance);

/* The corners of the blocks, as LAMMPS writes them. */
struct ts_textfile;
enum ts_status ts_balance_write(struct ts_textfile *file, const struct tsim *sim,
				const struct ts_rank_blocks *blocks);
/* The blocks that ts_balance_apply changes. */
enum ts_status ts_balance_blocks(struct ts_rank_balance *balance, struct tsim *sim,
				 struct ts_rank_blocks **blocks);

#endif
