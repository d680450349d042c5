/* Tables of all styles, systems and checks of a program. The core, the script language and the manual
 * reach these only through the tables, which are passed to ts_sim_new (those of tsim:
 * library/tsim_tables.h). */
#ifndef TS_CORE_TABLES_H
#define TS_CORE_TABLES_H

#include "core/style.h"

struct ts_plan;
struct ts_review_check;

struct ts_tables {
	const struct ts_style *const *styles; /* sorted by kind, then name; closed by NULL */
	/* in the order of their hooks in a stage; closed by NULL */
	const struct ts_system_style *const *systems;
	const struct ts_review_check *checks; /* of the scene before a run; closed by .name NULL */
	/* Called before the first step of a run of that many steps: prints its plan with -explain, refuses
	 * a time step beyond a stability limit. */
	enum ts_status (*judge)(struct ts_plan *plan, struct tsim *sim, int64_t steps);
	enum ts_status (*judge_own)(struct tsim *sim);
	/* With several ranks, when a run begins: each keeps the particles of its block only; the stage BUILD makes lists. */
	enum ts_status (*keep_own)(struct tsim *sim);
	/* With several ranks: each keeps the particles of its block only; each gets all particles, for outputs that read
	 * nothing else without the lists of pairs and contacts. */
	enum ts_status (*divide)(struct ts_plan *plan, struct tsim *sim);
	enum ts_status (*gather)(struct ts_plan *plan, struct tsim *sim, bool lists);
	/* While they are divided, all ranks call it: whether particles have left the box, so that the list is made again. */
	bool (*search_left)(struct tsim *sim);
	/* Particles stay divided behind a run, until the next one begins. */
	enum ts_status (*rest)(struct tsim *sim, bool begins);
};

#endif
