/* What styles do with several ranks, and what all ranks agree on. doc/ranks.md.
 *
 * Outside of runs, unless a pause leaves the particles divided (core/ranks_pause.h), and in the stages END_OF_STEP and OUTPUT
 * of steps in which one of their hooks needs it, each rank has the whole simulation, and all execute the same commands and
 * functions. In the other stages the particles are divided: each rank has those of its block of space and copies of those
 * near it. */
#ifndef TS_CORE_RANKS_H
#define TS_CORE_RANKS_H

#include "core/sim.h"

enum { TS_RANKS_MOST = 1000000 }; /* for which a run can be planned */

/* Number of ranks, or of those for which a run is planned. */
static inline int ts_ranks(const struct tsim *sim)
{
	if (sim->reading.ranks)
		return sim->reading.ranks;
	return sim->world ? sim->world->n : 1;
}

/* Whether this is the rank that does what may be done once only, such as printing. */
static inline bool ts_ranks_first(const struct tsim *sim)
{
	return !sim->world || sim->world->rank == 0;
}

/* The largest of the values of all ranks while the particles are divided, else the value itself. */
double ts_ranks_most(const struct tsim *sim, double value);
void ts_ranks_most_of(const struct tsim *sim, double *value, size_t n);
/* The sums of the numbers of all ranks, which all call it. */
void ts_ranks_sums(const struct tsim *sim, int64_t *number, size_t n);
/* The number of the first rank: for what is not the same on all, such as times. */
double ts_ranks_same(const struct tsim *sim, double value);

/* With several ranks returns an error if the style is not made for them. `what`: kind and name for the message. */
enum ts_status ts_ranks_allow(struct tsim *sim, const struct ts_style *style, const char *what,
			      const struct ts_place *where);
/* The same for an option; `what`: its name. */
enum ts_status ts_ranks_refuse(struct tsim *sim, const char *what, const struct ts_place *where);
/* The first word that names a value which ranks with particles of their own do not have: an output, or a variable that
 * depends on all particles. NULL: none. */
const struct ts_word *ts_ranks_find_shared(const struct tsim *sim, struct ts_words words);
/* Whether a variable, NAME or v_NAME, is such a value; NULL: no. */
bool ts_ranks_variable_shared(const struct tsim *sim, const char *variable);
/* Whether it depends on the fields of the fluid. */
bool ts_ranks_variable_reads_fluid(const struct tsim *sim, const char *variable);
/* Between two calls formulas are evaluated while the particles are divided: what depends on all of them is an error. */
void ts_ranks_apart(struct tsim *sim, bool begins);
/* Before a run: where a fix, the flow style or a region acts in each step by a value that depends on all particles, all ranks
 * do all steps with all particles, and a warning tells. */
void ts_ranks_choose_steps(struct tsim *sim);
/* Calls the slot `settle` of the styles that have anything to do in this step. */
enum ts_status ts_ranks_settle(const struct ts_plan *plan, struct tsim *sim);
/* Whether a hook of END_OF_STEP or OUTPUT of this step needs all particles on each rank, or they are to be divided
 * again. */
bool ts_ranks_whole_due(const struct ts_plan *plan, const struct tsim *sim);
/* Whether in such a step lists of pairs or contacts are needed, too. */
bool ts_ranks_lists_due(const struct ts_plan *plan, const struct tsim *sim);
/* Whether a part of the set-up of a run needs lists of all contacts on each rank. */
bool ts_ranks_set_up_whole(const struct ts_plan *plan, const struct tsim *sim);
/* After the last step: whether nothing at the end of the run needs lists of contacts on all ranks (core/ranks_pause.h). */
bool ts_ranks_may_pause(const struct ts_plan *plan, const struct tsim *sim);
/* Then: whether nothing needs the particles of all ranks until the next run begins, so that they may stay divided. */
bool ts_ranks_may_rest(const struct ts_plan *plan, const struct tsim *sim);
/* Whether the inits of all live styles can be called while the particles are divided. */
bool ts_ranks_rowless(const struct tsim *sim);
/* Before the first step of a run: whether a hook of SETUP or OUTPUT needs all particles on each rank; of OUTPUT. */
bool ts_ranks_first_look(const struct ts_plan *plan, const struct tsim *sim);
bool ts_ranks_output_due(const struct ts_plan *plan, const struct tsim *sim);
/* While the particles are divided: the first rank prints the warnings of all. */
enum ts_status ts_ranks_tell(struct tsim *sim);
/* When a step begins: whether all ranks do it with all particles. */
bool ts_ranks_step_due(const struct tsim *sim);
/* After CHECK: all ranks rebuild the contact list, end, save, or look what runaways meet if one of them wants it. Hooks of
 * CHECK do not decide by themselves whether to call what all ranks have to call: they set a flag that is agreed on here. */
void ts_ranks_agree(struct tsim *sim);

#endif
