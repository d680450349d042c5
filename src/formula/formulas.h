/* Formulas and variables of a simulation, which use each other: a formula has variables, and a variable may be a
 * formula. */
#ifndef TS_FORMULA_FORMULAS_H
#define TS_FORMULA_FORMULAS_H

#include "base/quotes.h"
#include "core/sim.h"
#include "formula/variable.h"
#include "math/rng.h"

/* The random numbers of one seed: those of single numbers, and rounds in which each particle draws one. */
struct ts_random_stream {
	int64_t seed, draws, rounds;
};

struct ts_formulas {
	struct tsim *sim;
	struct ts_variables variables;
	uint64_t evaluation;	  /* of formulas, from outside: within one each variable is evaluated once */
	uint64_t evaluated;	  /* formulas in this one */
	struct ts_variable *kept; /* those whose columns or lists are kept within it */
	uint64_t drawn;		  /* values that differ from one look to the next: of random(), next() */
	bool misfit; /* a formula has named an output that is not of the shape that is needed there */
	int depth;   /* of formulas, over all variables that use each other */
	struct ts_random_stream *stream; /* one per seed of random() and normal() */
	size_t nstreams, stream_capacity;
	struct ts_variable_state *waiting; /* from a restart file, for variables not yet defined */
	size_t nwaiting, waiting_capacity;
	struct ts_map waiting_at; /* by name, those not yet taken: where in `waiting`, from 1 */
	const char *unknown;	  /* -check: the last unknown value that was put into a line */
};

void ts_formulas_release(struct ts_formulas *formulas);

/* TS_OPEN: only a run can tell. */
enum ts_truth { TS_NO, TS_YES, TS_OPEN };

/* Formulas. The text stands at `place`. */
enum ts_status ts_expr_scalar(struct ts_formulas *formulas, const char *text, const struct ts_place *place,
			      double *out);
enum ts_status ts_expr_peratom(struct ts_formulas *formulas, const char *text, const struct ts_place *place,
			       struct ts_table *out);
enum ts_status ts_expr_vector(struct ts_formulas *formulas, const char *text, const struct ts_place *place,
			      struct ts_table *out);
/* Begins to read formulas only, and ends it: `status` is that of the formulas. What their numbers have
 * caused is forgiven, and what is not there yet, unless it is asked for now. */
struct ts_dry {
	bool dry, looking, misfit;
};
struct ts_dry ts_dry_begin(struct ts_formulas *formulas);
enum ts_status ts_dry_end(struct ts_formulas *formulas, struct ts_dry before, enum ts_status status,
			  bool now);
/* A condition of `if`, where bare names are words that can be compared. */
enum ts_status ts_expr_condition(struct ts_formulas *formulas, const char *text, const struct ts_place *place,
				 enum ts_truth *out);

/* random_stream.c: the stream of a seed; what a restart file keeps of streams and variables. */
enum ts_status ts_random_stream_of(struct ts_formulas *formulas, double seed, struct ts_random_stream **out);
enum ts_status ts_formulas_archive(struct ts_formulas *formulas, struct ts_archive *archive);

#endif
