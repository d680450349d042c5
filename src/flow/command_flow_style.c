#include "core/life.h"
#include "flow/projection.h"

#include "base/banned.h"

struct style_line {
	struct ts_words words;
};

static const struct ts_flow_condition *first_condition(const struct ts_projection *p)
{
	for (int face = 0; face < 6; face++)
		if (p->condition[face / 2][face % 2].given)
			return &p->condition[face / 2][face % 2];
	return NULL;
}

/* A new style replaces the fluid: it is at rest, with the default conditions on its faces. */
static enum ts_status refuse_loss(struct tsim *sim, const struct ts_place *where)
{
	const struct ts_instance *flow = ts_sim_only(sim, TS_KIND_FLOW);
	const struct ts_flow_condition *condition;
	const struct ts_projection *p;

	if (!flow || !flow->style->family || !ts_streq(flow->style->family, TS_FAMILY_PROJECTION))
		return TS_OK;
	p = flow->state;
	condition = first_condition(p);
	if (p->moved)
		return ts_fail(&sim->error, TS_STATE, where,
			       "flow_style: the fluid of line %d has moved in a run; another flow_style "
			       "would begin at rest and without its flow_boundary lines: leave it, use "
			       "`clear`, or `flow_style none` before this line if that is what you want",
			       flow->where.line);
	if (condition)
		return ts_fail(&sim->error, TS_STATE, where,
			       "flow_style: another one would drop the flow_boundary of line %d, which "
			       "belongs to the fluid of line %d: put flow_boundary after this line, or "
			       "`flow_style none` before it",
			       condition->where.line, flow->where.line);
	return TS_OK;
}

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct style_line *line = state;

	if (!ts_streq(line->words.word[0].text, "none"))
		TS_TRY(refuse_loss(sim, where));
	return ts_sim_choose(sim, TS_KIND_FLOW, line->words, where);
}

static const struct ts_arg args[] = {
	TS_REST("style", struct style_line, words, .help = "a flow style and its arguments"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_flow_style)
const struct ts_command_style ts_command_flow_style = {
	.style = { .name = "flow_style",
		   .kind = TS_KIND_COMMAND,
		   .ranks = TS_RANKS_FORMULAS,
		   .summary = "Selects the fluid around the particles",
		   .doc = "Replaces the present flow style. Without a flow style there is no fluid, and "
			  "drag\n"
			  "fixes are refused. A fluid that is solved for is not replaced silently: after a\n"
			  "run with it, or if flow_boundary settings would be lost, another flow_style is\n"
			  "refused; `flow_style none` removes it, `clear` removes everything.",
		   .example = "flow_style uniform velocity 0 0 1.0 viscosity 1.0e-3",
		   .args = args,
		   .state_size = sizeof(struct style_line) },
	.run = run,
};
