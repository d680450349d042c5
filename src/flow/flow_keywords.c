/* Keywords of the fluid for thermo_style and formulas. */
#include <math.h>
#include <stdio.h>

#include "core/ranks.h"
#include "flow/flow.h"
#include "flow/flow_measures.h"
#include "flow/projection.h"

#include "base/banned.h"

#define OF(require, name, value)                                           \
	static enum ts_status name(struct tsim *sim, double *out)          \
	{                                                                  \
		struct ts_fluid *fluid;                                    \
                                                                           \
		TS_TRY(require(sim, "keyword flow_" #name, NULL, &fluid)); \
		*out = (value);                                            \
		return TS_OK;                                              \
	}
#define OF_FIELDS(name, value) OF(ts_flow_require_fields, name, value)
#define OF_FLUID(name, value) OF(ts_flow_require_fluid, name, value)
OF_FIELDS(ke, ts_flow_kinetic_energy(fluid))
OF_FIELDS(px, ts_flow_momentum(fluid, 0))
OF_FIELDS(py, ts_flow_momentum(fluid, 1))
OF_FIELDS(pz, ts_flow_momentum(fluid, 2))
OF_FLUID(div, fluid->divergence)
OF_FLUID(cfl, fluid->courant)
OF_FLUID(iter, fluid->iterations)
OF_FLUID(res, fluid->residual)
OF_FLUID(dt, fluid->dt)
OF_FLUID(time, fluid->time)
OF_FLUID(steps, (double)fluid->steps)

static const struct ts_keyword keywords[] = {
	{ "flow_ke", "FlowKE", "energy", "kinetic energy of the fluid", TS_KEYWORD_FLUID | TS_KEYWORD_FIELDS,
	  ke },
	{ "flow_px", "FlowPx", "mass velocity", "momentum of the fluid along x",
	  TS_KEYWORD_FLUID | TS_KEYWORD_FIELDS, px },
	{ "flow_py", "FlowPy", "mass velocity", "momentum of the fluid along y",
	  TS_KEYWORD_FLUID | TS_KEYWORD_FIELDS, py },
	{ "flow_pz", "FlowPz", "mass velocity", "momentum of the fluid along z",
	  TS_KEYWORD_FLUID | TS_KEYWORD_FIELDS, pz },
	{ "flow_div", "FlowDiv", "1/time", "largest divergence left by the last projection", TS_KEYWORD_FLUID,
	  div },
	{ "flow_cfl", "FlowCFL", "",
	  "largest sum of |u| dt/h in the last step of the fluid, of cells by their lower faces",
	  TS_KEYWORD_FLUID, cfl },
	{ "flow_iter", "FlowIter", "", "iterations of the pressure solver in the last projection",
	  TS_KEYWORD_FLUID | TS_KEYWORD_INTEGER, iter },
	{ "flow_res", "FlowRes", "velocity/time", "largest |change of u|/dt in the last step of the fluid",
	  TS_KEYWORD_FLUID, res },
	{ "flow_dt", "FlowDt", "time", "last step of the fluid", TS_KEYWORD_FLUID, dt },
	{ "flow_time", "FlowTime", "time", "time of the fields of the fluid", TS_KEYWORD_FLUID, time },
	{ "flow_steps", "FlowSteps", "", "steps of the fluid since its beginning",
	  TS_KEYWORD_FLUID | TS_KEYWORD_INTEGER, steps },
	{ .name = NULL },
};

static enum ts_status check_keyword(struct tsim *sim, const struct ts_keyword *keyword,
				    const struct ts_place *where)
{
	char who[40];
	struct ts_fluid *fluid;

	snprintf(who, sizeof who, "keyword %s", keyword->name);
	return ts_flow_require_fluid(sim, who, where, &fluid);
}

static bool is_shared(const struct tsim *sim, const struct ts_flow_condition *condition)
{
	bool is = ts_ranks_variable_shared(sim, condition->pressure.variable);

	for (int d = 0; d < 3; d++)
		is |= ts_ranks_variable_shared(sim, condition->velocity[d].variable);
	return is && !condition->once;
}

static const char *undivided(const struct tsim *sim)
{
	const struct ts_instance *flow = ts_sim_only(sim, TS_KIND_FLOW);
	const struct ts_projection *p =
		flow && flow->style->family && ts_streq(flow->style->family, TS_FAMILY_PROJECTION)
			? flow->state
			: NULL;

	for (int face = 0; p && face < 6; face++)
		if (is_shared(sim, &p->condition[face / 2][face % 2]))
			return "a variable of flow_boundary";
	return NULL;
}

const struct ts_system_style ts_flow_system = {
	.style = {
		.name = "flow",
		.kind = TS_KIND_SYSTEM,
		.summary = "Numbers of the fluid for the table of the log",
	},
	.keywords = keywords,
	.check_keyword = check_keyword,
	.undivided = undivided,
};
