/* Command thermo: interval of thermo output. */
#include "core/sim.h"
#include "thermo/thermo.h"

#include "base/banned.h"

struct state {
	struct ts_number every;
};

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct state *s = state;

	struct ts_thermo *t = sim->thermo;
	double every = s->every.value;

	if (every != floor(every) || every > 9e15)
		return ts_fail(&sim->error, TS_SYNTAX, where,
			       "thermo: every is %g, expected an integer >= 0 or v_name", every);
	t->every = (int64_t)every;
	t->variable = NULL;
	if (s->every.variable)
		t->variable = ts_pool_get(sim->pool, s->every.variable);
	return s->every.variable && !t->variable ? ts_nomem(&sim->error) : TS_OK;
}

static const struct ts_arg args[] = {
	TS_NUMBER("every", struct state, every, .flags = TS_POSITIONAL, .range = TS_NOT_NEGATIVE,
		  .help = "steps between rows, or a variable that evaluates to the step of the next row; 0: "
			  "only the first and the last step"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_thermo)
const struct ts_command_style ts_command_thermo = {
	.style = {
		.name = "thermo",
		.kind = TS_KIND_COMMAND,
		.summary = "Sets the interval of thermo output",
		.doc = "Thermo output is a table in the log file and on the screen. A row is written at the "
		       "first and the last step of each run and when the step is a multiple of N. The default "
		       "is 0. A variable v_NAME is evaluated at the start of a run and after each row; its "
		       "value is the step of the next row. See also thermo_style, thermo_modify.",
		.example = "thermo 1000\nthermo v_next",
		.args = args,
		.ranks = TS_RANKS_FORMULAS,
		.state_size = sizeof(struct state),
	},
	.run = run,
};
