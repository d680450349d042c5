#include "neigh/heat.h"

#include "base/banned.h"

static const struct ts_arg args[] = { TS_HEAT_ARGS };

TS_STYLE(fix, ts_style, ts_fix_heat_gran_conduction)
const struct ts_style ts_fix_heat_gran_conduction = {
	.name = "heat/gran/conduction",
	.kind = TS_KIND_FIX,
	.summary = "conduction of heat between touching particles",
	.doc = "The same as fix heat/gran.",
	.example = "fix heat all heat/gran/conduction initial_temperature 273.15",
	.args = args,
	.family = TS_FAMILY_HEAT,
	.state_size = sizeof(struct ts_heat),
	.archive = ts_heat_archive,
	.values = ts_heat_values,
	.init = ts_heat_init,
	.hook = TS_HEAT_HOOKS,
	.plan = ts_heat_plan,
	.fini = ts_heat_fini,
};
