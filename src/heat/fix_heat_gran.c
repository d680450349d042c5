#include "heat/heat.h"

#include "base/banned.h"

/* in the order of enum ts_heat_scheme */
static const char *const schemes[] = { "euler", "exact", NULL };

static const struct ts_arg args[] = {
	TS_REAL("initial_temperature", struct ts_heat, initial, .unit = "temperature",
		.help = "temperature of particles that have none yet"),
	TS_HEAT_AREA_ARG(struct ts_heat, area_words),
	TS_BOOL("area_correction", struct ts_heat, correction, .fallback = "no",
		.help = "correct the overlap to that of the material with youngsModulusOriginal"),
	TS_BOOL("store_contact_data", struct ts_heat, store, .fallback = "no",
		.help = "store nContactsConduction, contactAreaConduction and wallHeatFlux for each "
			"particle"),
	TS_ENUM("scheme", struct ts_heat, scheme, schemes, .fallback = "euler",
		.help = "time integration: euler (explicit, as in LIGGGHTS) or exact"),
	TS_ARGS_END,
};

static const char doc[] =
	"Each particle has a uniform temperature T, the per-atom property Temp. Particles in contact "
	"exchange heat,\n\n"
	"  m c dT_i/dt = sum_j h_ij (T_j - T_i) + S_i,   h_ij = 4 k_i k_j/(k_i + k_j) sqrt(A)\n\n"
	"with the thermal conductivity k and the specific heat capacity c of each atom type, the properties "
	"thermalConductivity and thermalCapacity (fix property/global). Walls with a `temperature` take "
	"part; fix surface/heat gives the heat that each of their elements receives. The contact area A "
	"is\n\n"
	"* `contact_area overlap`: the area of the circle in which the spheres intersect. With "
	"`area_correction yes` the overlap is first multiplied by (Y*/Y*_original)^(1/a), with a = 3/2 for "
	"hertz and a = 1 for hooke, and Y*_original from youngsModulusOriginal; at walls, too (LIGGGHTS and "
	"`legacy yes` leave it out there).\n"
	"* `contact_area constant A`: the number A.\n"
	"* `contact_area projection`: pi R^2 of the larger sphere.\n\n"
	"Particles that are not in the group keep their temperature, but exchange heat with those of the "
	"group. New particles get the temperature initial_temperature; `set ... property/atom Temp T` sets "
	"another, and `set ... property/atom heatSource S` sets a heat source S (energy/time). The mass m of "
	"a sphere of a clump is its share of the mass of the clump by volume; LIGGGHTS counts the mass of "
	"the whole clump for each of its spheres.\n\n"
	"The scalar f_ID is the heat content, the sum of m c T over all particles. Per-atom properties for "
	"output: f_Temp; f_heatFlux, the heat flow into the particle in the last step (energy/time); "
	"f_heatSource; and f_directionalHeatFlux[1] ... [3], the sum over the contacts of half the heat flow "
	"times the vector between the centres.\n\n"
	"`scheme euler` is the explicit scheme of LIGGGHTS, of first order. Its limit is the smallest m "
	"c/sum h of a particle; above it temperatures oscillate, and the run warns. A run whose temperatures "
	"diverge stops with an error. `scheme exact` solves the linear system exactly over each time step, "
	"with the contacts at the end of the step, and has no limit.\n\n"
	"Equations typeset, assumptions, order and limits: doc/theory-heat.md.";

TS_STYLE(fix, ts_style, ts_fix_heat_gran)
const struct ts_style ts_fix_heat_gran = {
	.name = "heat/gran",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_OWN | TS_RANKS_OUTPUTS,
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
	.hook[TS_STAGE_POST_BUILD] = ts_heat_update_contacts,
	.hook[TS_STAGE_PRE_FORCE] = ts_heat_clear,
	.hook[TS_STAGE_POST_FORCE] = ts_heat_conduct,
	.hook[TS_STAGE_FINAL_INTEGRATE] = ts_heat_advance,
	.hook[TS_STAGE_SETUP] = ts_heat_set_bound,
	.defers = TS_DEFERS(PRE_FORCE) | TS_DEFERS(POST_FORCE) | TS_DEFERS(FINAL_INTEGRATE),
	.plan = ts_heat_plan,
	.fini = ts_heat_fini,
};
