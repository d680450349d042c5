/* Command compute_modify: accepted for compatibility. */
#include "core/sim.h"

#include "base/banned.h"

struct state {
	struct ts_words rest;
};

/* Computes that always exist elsewhere. */
static const char *const standard[] = { "thermo_temp", "thermo_press", "thermo_pe", NULL };

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct state *s = state;
	struct ts_instance *inst;

	(void)where;
	for (const char *const *name = standard; *name; name++)
		if (ts_streq(s->rest.word[0].text, *name))
			return TS_OK;
	return ts_sim_require(sim, TS_KIND_COMPUTE, &s->rest.word[0], &inst);
}

static const struct ts_arg args[] = {
	TS_REST("id", struct state, rest,
		.help = "name of the compute, then dynamic yes|no, extra n: no effect"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_compute_modify)
const struct ts_command_style ts_command_compute_modify = {
	.style = {
		.name = "compute_modify",
		.kind = TS_KIND_COMMAND,
		.summary = "Accepted for compatibility; has no effect",
		.doc = "The compute must exist; thermo_temp, thermo_press and thermo_pe are taken to exist.",
		.example = "compute_modify thermo_temp dynamic yes",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.run = run,
};
