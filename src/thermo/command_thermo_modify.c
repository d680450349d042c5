/* Command thermo_modify: format of thermo output; treatment of lost particles. */
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

static enum ts_status set_standard_compute(struct tsim *sim, enum ts_standard which, const char *id,
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
	TS_TRY(set_standard_compute(sim, TS_STANDARD_TEMPERATURE, s->temperature, where));
	TS_TRY(set_standard_compute(sim, TS_STANDARD_PRESSURE, s->pressure, where));
	return ts_thermo_format(sim, s->format.n ? s->format : none);
}

static const struct ts_arg args[] = {
	TS_ENUM("lost", struct state, lost, policies, .flags = TS_OPTIONAL,
		.help = "what to do when a particle leaves the box through a fixed face; default: warn"),
	TS_ENUM("lost/bond", struct state, lost_bond, policies, .flags = TS_OPTIONAL,
		.help = "no effect: bonds are deleted with their particles"),
	TS_ENUM("norm", struct state, norm, answers, .flags = TS_OPTIONAL,
		.help = "whether ke, pe, etotal, erotate, epair, ebond and emol are divided by the number of "
			"particles"),
	TS_ENUM("flush", struct state, flush, answers, .flags = TS_OPTIONAL,
		.help = "no effect: output is flushed after each row"),
	TS_ENUM("line", struct state, line, lines, .flags = TS_OPTIONAL,
		.help = "one line for each row, or a block of several lines with named numbers"),
	TS_ENUM("warn", struct state, warn, policies, .flags = TS_OPTIONAL,
		.help = "no effect: each warning is printed once"),
	TS_WORD("temp", struct state, temperature, .flags = TS_OPTIONAL,
		.help = "ID of a compute whose value the keyword temp has; thermo_temp: temperature of all "
			"particles"),
	TS_WORD("press", struct state, pressure, .flags = TS_OPTIONAL,
		.help = "ID of a compute pressure whose values the keywords press, pxx ... have; "
			"thermo_press: pressure of all particles"),
	{ .name = "format",
	  .type = TS_ARG_REST,
	  .flags = TS_OPTIONAL | TS_TO_KEYWORD | TS_REPEAT,
	  .offset = TS_FIELD(struct state, format, struct ts_words *),
	  .help = "format of numbers: float F, int F, the number of a column and F, line \"F F ...\" with "
		  "one for each column, or none for the defaults; F is a C format such as %20.15g" },
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_thermo_modify)
const struct ts_command_style ts_command_thermo_modify = {
	.style = {
		.name = "thermo_modify",
		.kind = TS_KIND_COMMAND,
		.summary = "Sets the format of thermo output and the treatment of lost particles",
		.doc = "Defaults: format float %14.8g, format int %8d, with `line multi` %14.4f and %14d; "
		       "norm yes after the command `units lj`, otherwise no. thermo_style restores the "
		       "defaults, except for lost. temp and press change only these keywords: ke and etotal "
		       "are still those of all particles. The format of a column takes precedence over those "
		       "of float and int, and these over the format of the line.\n\n"
		       "A particle that leaves the box is deleted in that step. With `lost ignore` it is "
		       "deleted at the next rebuild of the neighbor list, as in LIGGGHTS and LAMMPS, and is "
		       "counted until then; this is faster if many particles leave.",
		.example = "thermo_modify lost warn norm no\n"
			   "thermo_modify format float %20.15g format 3 %10.4f",
		.args = args,
		.ranks = TS_RANKS_FORMULAS,
		.state_size = sizeof(struct state),
	},
	.run = run,
};
