/* What a program is made of. The core, the script language and the manual know styles, systems and checks
 * only through these tables, which whoever makes a simulation passes to ts_sim_new (library/tsim_tables.h
 * has those of tsim). */
#ifndef TS_CORE_TABLES_H
#define TS_CORE_TABLES_H

#include "core/style.h"

struct ts_plan;
struct ts_review_check;

struct ts_tables {
	const struct ts_style *const *styles; /* sorted by kind, then name; closed by NULL */
	/* in the order of their actions in a stage; closed by NULL */
	const struct ts_system_style *const *systems;
	const struct ts_review_check *checks; /* of the scene before a run; closed by .name NULL */
	/* Before the first step of a run of so many steps: prints its plan if asked for, refuses a time
	 * step beyond a limit of stability. */
	enum ts_status (*judge)(struct ts_plan *plan, struct tsim *sim, int64_t steps);
};

/* The only lookup; NULL if unknown. Styles have other names, too: the k-th of them, NULL: there are no
 * more. */
const struct ts_style *ts_style_find(const struct ts_tables *tables, enum ts_kind kind, const char *name);
const char *ts_style_other_name(const struct ts_style *style, size_t k);
/* The same, or an error with a suggestion. */
enum ts_status ts_style_require(struct tsim *sim, enum ts_kind kind, const struct ts_word *name,
				const struct ts_style **out);

#endif
