#include "heat/heat.h"

#include "base/banned.h"

/* in the order of enum ts_heat_scheme */
static const char *const schemes[] = { "euler", "exact", NULL };

static const struct ts_arg args[] = {
	TS_REAL("initial_temperature", struct ts_heat, initial, .unit = "temperature",
		.help = "of particles that have none yet"),
	TS_HEAT_AREA_ARG(struct ts_heat, area_words),
	TS_BOOL("area_correction", struct ts_heat, correction, .fallback = "no",
		.help = "overlaps as they would be with youngsModulusOriginal"),
	TS_BOOL("store_contact_data", struct ts_heat, store, .fallback = "no",
		.help = "columns nContactsConduction, contactAreaConduction and wallHeatFlux"),
	TS_ENUM("scheme", struct ts_heat, scheme, schemes, .fallback = "euler",
		.help = "euler as LIGGGHTS, or exact over each step"),
	TS_ARGS_END,
};

static const char doc[] =
	"Each particle has one temperature T, `Temp`. Touching particles exchange heat,\n"
	"m c dT_i/dt = sum_j h_ij (T_j - T_i) + S_i with h = 4 k_i k_j/(k_i + k_j) sqrt(A). k and c are the\n"
	"properties thermalConductivity and thermalCapacity per type (fix property/global). A is the area "
	"of\n"
	"contact: the circle in which the spheres cut each other (`contact_area overlap`; with\n"
	"`area_correction yes` the overlap is first multiplied by (Y*/Y*_original)^(1/a), a = 3/2 for hertz "
	"and\n"
	"1 for hooke, Y*_original from youngsModulusOriginal), a number (`constant`), or pi R^2 of the "
	"larger\n"
	"sphere (`projection`). Walls with a `temperature` take part.\n\n"
	"Particles that are not in the group keep their temperature, but exchange heat with those that are.\n"
	"Particles start with initial_temperature; `set ... property/atom Temp T` changes it, `set ...\n"
	"property/atom heatSource S` gives a source S of energy by time. f_Temp, f_heatFlux (into the "
	"particle,\n"
	"in the last step), f_heatSource and f_directionalHeatFlux[1] ... [3] (half of the flux of each "
	"contact\n"
	"times the vector between the centres) are read as numbers of particles, f_ID is the sum of m c T "
	"over\n"
	"all particles.\n\n"
	"`scheme euler` is LIGGGHTS': first order; the plan of a run warns of steps above m c/sum h, where\n"
	"temperatures begin to swing, and a run whose temperatures grow without bound stops. `scheme exact`\n"
	"solves the linear system exactly over each step, with the contacts as they are at its end: there "
	"is\n"
	"no limit of the step.";

TS_STYLE(fix, ts_style, ts_fix_heat_gran)
const struct ts_style ts_fix_heat_gran = {
	.name = "heat/gran",
	.kind = TS_KIND_FIX,
	.summary = "conduction of heat between touching particles",
	.doc = doc,
	.example = "fix k all property/global thermalConductivity peratomtype 43.0\n"
		   "fix c all property/global thermalCapacity peratomtype 490.0\n"
		   "fix heat all heat/gran initial_temperature 273.15\n"
		   "set region hot property/atom Temp 773.15",
	.cite = "B. Chaudhuri, F. J. Muzzio, M. S. Tomassone, Chem. Eng. Sci. 61 (2006) 6348",
	.args = args,
	.family = TS_FAMILY_HEAT,
	.state_size = sizeof(struct ts_heat),
	.archive = ts_heat_archive,
	.values = ts_heat_values,
	.init = ts_heat_init,
	.hook[TS_STAGE_POST_BUILD] = ts_heat_built,
	.hook[TS_STAGE_PRE_FORCE] = ts_heat_clear,
	.hook[TS_STAGE_POST_FORCE] = ts_heat_conduct,
	.hook[TS_STAGE_FINAL_INTEGRATE] = ts_heat_advance,
	.hook[TS_STAGE_SETUP] = ts_heat_start,
	.defers = TS_DEFERS(PRE_FORCE) | TS_DEFERS(POST_FORCE) | TS_DEFERS(FINAL_INTEGRATE),
	.plan = ts_heat_plan,
	.fini = ts_heat_fini,
};
