/* Command thermo_modify: formats of the table in the log; what a lost particle means. */
#include "core/sim.h"
#include "io/thermo.h"
#include "particles/particles.h"

#include "base/banned.h"

struct state {
	int lost, norm, flush, line, format_kind;
	const char *format;
};

/* in the order of enum ts_lost */
static const char *const policies[] = { "ignore", "warn", "error", NULL };
static const char *const answers[] = { "no", "yes", NULL };
static const char *const lines[] = { "one", "multi", NULL };

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct state *s = state;

	if (s->lost >= 0)
		sim->particles->lost_policy = s->lost;
	if (s->line == 1)
		ts_warn(&sim->log, where, "thermo_modify line multi: rows are written on one line");
	if (s->format)
		return ts_thermo_format(sim, s->format_kind == 1, s->format, where);
	return TS_OK;
}

static const struct ts_arg format_row[] = {
	TS_WORD("text", struct state, format, .flags = TS_POSITIONAL, .help = "a C format"),
	TS_ARGS_END,
};

static const struct ts_mode formats[] = {
	{ "float", "columns of real numbers, for instance %20.15g", format_row },
	{ "int", "columns of integers, for instance %10d", format_row },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_ENUM("lost", struct state, lost, policies, .flags = TS_OPTIONAL,
		.help = "when a particle leaves the box through a fixed face"),
	TS_ENUM("norm", struct state, norm, answers, .flags = TS_OPTIONAL,
		.help = "no effect: quantities are never divided by the number of particles"),
	TS_ENUM("flush", struct state, flush, answers, .flags = TS_OPTIONAL,
		.help = "no effect: every row is handed to the system at once"),
	TS_ENUM("line", struct state, line, lines, .flags = TS_OPTIONAL,
		.help = "rows are always written on one line"),
	{ .name = "format",
	  .type = TS_ARG_MODE,
	  .flags = TS_OPTIONAL,
	  .offset = TS_FIELD(struct state, format_kind, int *),
	  .modes = formats,
	  .help = "how numbers are written" },
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_thermo_modify)
const struct ts_command_style ts_command_thermo_modify = {
	.style = {
		.name = "thermo_modify",
		.kind = TS_KIND_COMMAND,
		.summary = "Formats of the table in the log; what to do about lost particles",
		.doc = "Defaults: format float %14.8g, format int %8d.",
		.example = "thermo_modify lost warn norm no\n"
			   "thermo_modify format float %20.15g",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.run = run,
};
