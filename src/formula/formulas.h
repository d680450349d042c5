/* State of the formulas and variables of a simulation. They use each other: a formula refers to variables,
 * and the value of a variable may be a formula. */
#ifndef TS_FORMULA_FORMULAS_H
#define TS_FORMULA_FORMULAS_H

#include "core/sim.h"
#include "formula/random_stream.h"
#include "formula/variable.h"

struct ts_formulas {
	struct tsim *sim;
	struct ts_variables variables;
	uint64_t evaluation;	  /* number of this evaluation; within it each variable is evaluated once */
	uint64_t evaluated;	  /* formulas evaluated within it */
	struct ts_variable *kept; /* variables whose columns or lists are cached within it */
	uint64_t drawn; /* evaluations of functions that change from call to call: random(), next() */
	bool misfit;	/* a formula has named an output without the shape needed there */
	/* What depends on all particles, or on a clock or random numbers, has been read: several ranks, each with particles of
	 * its own, would not read the same. */
	bool reads_all;
	bool reads_fluid; /* a number has been read that is computed from the fields of the fluid */
	size_t rows;	  /* of the columns that are evaluated (ts_variable_columns); 0: there are none */
	bool by_number;	  /* a variable with a column was used where only a number can be */
	int depth;	  /* nesting of formulas, through the variables they refer to */
	struct ts_random_stream *stream; /* one per seed of random() and normal() */
	size_t nstreams, stream_capacity;
	struct ts_variable_state *waiting; /* from a restart file, for variables not yet defined */
	size_t nwaiting, waiting_capacity;
	struct ts_map waiting_at; /* by name: index into `waiting` from 1, until restored */
	bool doubts_words;   /* -explain: words of variables that are open are unknown, not only numbers */
	const char *unknown; /* -check: name of the last unknown value that was substituted into a line */
};

/* Saves or restores what evaluations depend on between runs: random streams and variables. */
enum ts_status ts_formulas_archive(struct ts_formulas *formulas, struct ts_archive *archive);
void ts_formulas_release(struct ts_formulas *formulas);

#endif
