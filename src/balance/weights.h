/* Weights of particles for the balance of ranks: the product of factors by group, number of neighbours, measured time and
 * variables. */
#ifndef TS_BALANCE_WEIGHTS_H
#define TS_BALANCE_WEIGHTS_H

#include "core/sim.h"

enum { TS_MOST_WEIGHT_GROUPS = 32 };

struct ts_weight_style;

/* One word `weight` of the script. */
struct ts_weight {
	const struct ts_weight_style *style;
	const struct ts_word *word; /* that names the style */
	int groups, group[TS_MOST_WEIGHT_GROUPS];
	double value[TS_MOST_WEIGHT_GROUPS]; /* by group; [0]: the factor of neigh and time */
	const char *name;		     /* of a variable, or of a property */
};

struct ts_weights {
	struct ts_weight *item; /* [n] */
	size_t n, capacity;
	size_t column; /* of particles, where the values of variables are kept; 0: they are evaluated at once */
	uint64_t counted; /* sim->run.force_ticks up to which times have been taken already */
};

/* `what` is the style for messages. The words must live as long as the weights. */
enum ts_status ts_weights_parse(struct ts_weights *weights, struct tsim *sim, const char *what,
				struct ts_words words);
/* Whether the variables and properties exist. */
enum ts_status ts_weights_check(const struct ts_weights *weights, struct tsim *sim);
void ts_weights_release(struct ts_weights *weights);
bool ts_weights_have_variables(const struct ts_weights *weights);

/* The product of the values of the variables for each local particle. All ranks have all particles. */
enum ts_status ts_weights_evaluate(const struct ts_weights *weights, struct tsim *sim, double *product);
/* The weights of the local particles, which the property of `store` gets, too. */
struct ts_rank_blocks;
enum ts_status ts_weights_find(struct ts_weights *weights, struct tsim *sim,
			       const struct ts_rank_blocks *blocks, double *weight);

#endif
