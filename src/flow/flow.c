#include "flow/flow.h"

#include "flow/fluid.h"

#include "base/banned.h"

enum ts_status ts_flow_require_fluid(struct tsim *sim, const char *who, const struct ts_place *where,
				     struct ts_fluid **out)
{
	struct ts_instance *flow = ts_sim_only(sim, TS_KIND_FLOW);

	*out = NULL;
	if (!flow)
		return ts_fail(&sim->error, TS_STATE, where,
			       "%s needs a fluid: use flow_style projection before it", who);
	if (!ts_flow_style_of(flow)->fluid)
		return ts_fail(&sim->error, TS_STATE, where,
			       "%s needs a fluid that is solved for, which flow_style %s is not: use "
			       "flow_style projection before it",
			       who, flow->style->name);
	*out = ts_flow_style_of(flow)->fluid(flow);
	return TS_OK;
}

enum ts_status ts_flow_require_fields(struct tsim *sim, const char *who, const struct ts_place *where,
				      struct ts_fluid **out)
{
	struct ts_instance *flow = ts_sim_only(sim, TS_KIND_FLOW);

	TS_TRY(ts_flow_require_fluid(sim, who, where, out));
	if (!ts_fluid_divided(*out))
		return TS_OK;
	/* Styles that read the fluid in a step are looked for before it (flow/slab_step.h): this one has not been found. */
	if (sim->division && sim->run.inside && !sim->run.looks)
		return ts_fail(&sim->error, TS_STATE, where,
			       "%s needs the fluid within a step, when each rank has a part of the grid only",
			       who);
	ts_flow_style_of(flow)->complete(flow, sim);
	return TS_OK;
}

void ts_flow_complete(const struct tsim *sim)
{
	struct ts_instance *flow = ts_sim_only(sim, TS_KIND_FLOW);

	if (flow && ts_flow_style_of(flow)->fluid)
		ts_flow_style_of(flow)->complete(flow, sim);
}

struct ts_fluid *ts_flow_fluid(const struct tsim *sim)
{
	const struct ts_instance *flow = ts_sim_only(sim, TS_KIND_FLOW);

	return flow && ts_flow_style_of(flow)->fluid ? ts_flow_style_of(flow)->fluid(flow) : NULL;
}

enum ts_status ts_flow_require_viscosity(struct tsim *sim, const struct ts_instance *fix,
					 const struct ts_instance *flow)
{
	if (ts_flow_style_of(flow)->viscosity(flow) > 0)
		return TS_OK;
	return ts_fail(&sim->error, TS_STATE, &fix->where,
		       "fix %s needs a fluid with a viscosity: give flow_style %s one", fix->style->name,
		       flow->style->name);
}

const struct ts_instance *ts_flow_part_named(const struct tsim *sim, const char *style, size_t *k)
{
	const struct ts_instance *inst;

	while ((inst = ts_sim_next_of(sim, TS_KIND_FIX, TS_FAMILY_FLOW_PART, k)))
		if (ts_streq(inst->style->name, style))
			return inst;
	return NULL;
}
