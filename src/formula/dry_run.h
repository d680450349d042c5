/* Dry runs of formulas: names and shapes are checked, values of the simulation are not read. */
#ifndef TS_FORMULA_DRY_RUN_H
#define TS_FORMULA_DRY_RUN_H

#include "formula/formulas.h"

/* Flags before the dry run, which may be inside another. */
struct ts_dry_run {
	bool dry, probing, misfit;
};

struct ts_dry_run ts_dry_run_begin(struct ts_formulas *formulas);
/* Ends it; `status` is that of the formulas. Errors caused by missing values are cleared. Names that do
 * not exist yet and syntax errors are errors only if the value is needed `now`; outputs of the wrong shape
 * always are. */
enum ts_status ts_dry_run_end(struct ts_formulas *formulas, struct ts_dry_run before, enum ts_status status,
			      bool now);

#endif
