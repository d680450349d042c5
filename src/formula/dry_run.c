#include "formula/dry_run.h"

#include "base/banned.h"

struct ts_dry_run ts_dry_run_begin(struct ts_formulas *formulas)
{
	struct ts_dry_run before = { formulas->sim->reading.dry, formulas->sim->reading.probing,
				     formulas->misfit };

	formulas->sim->reading.dry = formulas->sim->reading.probing = true;
	formulas->misfit = false;
	return before;
}

enum ts_status ts_dry_run_end(struct ts_formulas *formulas, struct ts_dry_run before, enum ts_status status,
			      bool now)
{
	bool meant = status == TS_NOMEM || formulas->misfit ||
		     (now && (status == TS_UNKNOWN || status == TS_SYNTAX));

	formulas->sim->reading.dry = before.dry;
	formulas->sim->reading.probing = before.probing;
	formulas->misfit = before.misfit;
	if (status == TS_OK || meant)
		return status;
	ts_error_clear(&formulas->sim->error);
	return TS_OK;
}
