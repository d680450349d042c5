/* Command thermo_modify: how the table in the log is written; what a lost particle means. */
#include "core/standard.h"
#include "particle/particles.h"
#include "thermo/thermo.h"

#include "base/banned.h"

struct state {
	int lost, lost_bond, norm, flush, line, warn;
	const char *temperature, *pressure;
	struct ts_words format;
};

/* in the order of enum ts_lost */
static const char *const policies[] = { "ignore", "warn", "error", NULL };
static const char *const answers[] = { "no", "yes", NULL };
static const char *const lines[] = { "one", "multi", NULL };

static enum ts_status stand_for(struct tsim *sim, enum ts_standard which, const char *id,
				const struct ts_place *where)
{
	struct ts_word word = { .text = id };

	if (!id)
		return TS_OK;
	word.place = *ts_sim_word_of(sim, id, where);
	if (ts_streq(id, which == TS_STANDARD_PRESSURE ? "thermo_press" : "thermo_temp"))
		return ts_standard_set(sim, which, NULL);
	return ts_standard_set(sim, which, &word);
}

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct state *s = state;
	struct ts_words none = { NULL, 0 };

	if (s->lost >= 0)
		sim->particles->lost_policy = s->lost;
	if (s->norm >= 0)
		sim->thermo->norm = s->norm;
	if (s->line >= 0)
		sim->thermo->multi = s->line;
	TS_TRY(stand_for(sim, TS_STANDARD_TEMPERATURE, s->temperature, where));
	TS_TRY(stand_for(sim, TS_STANDARD_PRESSURE, s->pressure, where));
	return ts_thermo_format(sim, s->format.n ? s->format : none);
}

static const struct ts_arg args[] = {
	TS_ENUM("lost", struct state, lost, policies, .flags = TS_OPTIONAL,
		.help = "when a particle leaves the box through a fixed face"),
	TS_ENUM("lost/bond", struct state, lost_bond, policies, .flags = TS_OPTIONAL,
		.help = "no effect: bonds go with their partners"),
	TS_ENUM("norm", struct state, norm, answers, .flags = TS_OPTIONAL,
		.help = "whether ke and erotate are divided by the number of particles"),
	TS_ENUM("flush", struct state, flush, answers, .flags = TS_OPTIONAL,
		.help = "no effect: every row is handed to the system at once"),
	TS_ENUM("line", struct state, line, lines, .flags = TS_OPTIONAL,
		.help = "one line for a row, or a block of named numbers"),
	TS_ENUM("warn", struct state, warn, policies, .flags = TS_OPTIONAL,
		.help = "no effect: a warning is said once"),
	TS_WORD("temp", struct state, temperature, .flags = TS_OPTIONAL,
		.help = "name of a compute that gives what the keyword temp says; thermo_temp: of all "
			"particles"),
	TS_WORD("press", struct state, pressure, .flags = TS_OPTIONAL,
		.help = "name of a compute pressure that gives what press, pxx ... say; thermo_press: of "
			"all"),
	{ .name = "format",
	  .type = TS_ARG_REST,
	  .flags = TS_OPTIONAL | TS_TO_KEYWORD | TS_REPEAT,
	  .offset = TS_FIELD(struct state, format, struct ts_words *),
	  .help = "how numbers are written: float F, int F, the number of a column and F, line \"F F ...\" "
		  "with one for each column, or none: the defaults again; F is a C format such as %20.15g" },
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_thermo_modify)
const struct ts_command_style ts_command_thermo_modify = {
	.style = {
		.name = "thermo_modify",
		.kind = TS_KIND_COMMAND,
		.summary = "How the table in the log is written; what to do about lost particles",
		.doc = "Defaults: format float %14.8g, format int %8d, in blocks %14.4f and %14d; norm yes "
		       "after the\n"
		       "command `units lj`, else no. thermo_style brings the defaults back, but for lost. "
		       "temp and\n"
		       "press change these keywords alone: ke and etotal are those of all particles. A "
		       "format of a\n"
		       "column goes before those of a kind, and those before the line's.\n\n"
		       "A particle that leaves is taken out in that step. With lost ignore it goes with the "
		       "next rebuild of\n"
		       "neighbours, as in LIGGGHTS and LAMMPS, so until then it is counted: where many leave "
		       "this is faster.",
		.example = "thermo_modify lost warn norm no\n"
			   "thermo_modify format float %20.15g format 3 %10.4f",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.run = run,
};
