/* The recorder of a script, which its report is made of: the core, the plan and the table of the log call these functions.
 * None of them changes what the script computes. */
#ifndef TS_CORE_RECORDER_H
#define TS_CORE_RECORDER_H

#include <stdbool.h>

#include "base/status.h"

struct tsim;
struct ts_plan;
struct ts_plan_report;

struct ts_recorder {
	/* Before the hooks of a run are listed: may define dumps. */
	enum ts_status (*begin)(struct ts_recorder *self, struct tsim *sim);
	/* The report of the plan before the first step of a run. */
	void (*planned)(struct ts_recorder *self, struct tsim *sim, const struct ts_plan_report *plan);
	/* The table of the log, sim->thermo, has a new row. */
	void (*row)(struct ts_recorder *self, struct tsim *sim);
	/* After each step. */
	void (*step)(struct ts_recorder *self, struct tsim *sim);
	/* Whether it makes a report of this script. */
	bool (*records)(const struct ts_recorder *self);
	/* The steps of a run have ended or failed; of a run in pieces after each piece. */
	void (*stop)(struct ts_recorder *self, struct tsim *sim, const struct ts_plan *plan);
	/* Before `clear` deletes all styles. */
	void (*clear)(struct ts_recorder *self, struct tsim *sim);
	void (*release)(struct ts_recorder *self, struct tsim *sim);
};

/* A program around the library that is told each row of the log; call NULL: none. */
struct ts_row_listener {
	enum ts_status (*call)(struct tsim *sim);
};

#endif
