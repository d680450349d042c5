/* Command thermo_style: columns of thermo output. */
#include "core/sim.h"
#include "core/ranks_pause.h"
#include "thermo/thermo.h"

#include <string.h>

#include "base/banned.h"

struct state {
	int style;
	struct ts_words columns;
};

enum { ONE, MULTI, CUSTOM };

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	static const char *const one[] = { "step", "atoms", "ke", "cpu" };
	const struct state *s = state;
	struct ts_word word[4];

	for (size_t k = 0; s->style == CUSTOM && k < s->columns.n; k++)
		if (strchr(s->columns.word[k].text,
			   '*')) /* an output is evaluated for the number of its columns */
			TS_TRY(ts_ranks_unite(sim));
	if (s->style == CUSTOM)
		return ts_thermo_columns(sim, s->columns, false);
	for (size_t k = 0; k < 4; k++)
		word[k] = (struct ts_word){ .text = one[k], .place = *where };
	return ts_thermo_columns(sim, (struct ts_words){ word, 4 }, s->style == MULTI);
}

static const struct ts_arg custom[] = {
	TS_REST("columns", struct state, columns,
		.help = "step, time, atoms, ke ..., c_ID, c_ID[k], f_ID, f_ID[k], v_NAME"),
	TS_ARGS_END,
};

static const struct ts_mode styles[] = {
	[ONE] = { "one", "step atoms ke cpu", NULL },
	[MULTI] = { "multi", "the same columns, in blocks of named numbers", NULL },
	[CUSTOM] = { "custom", "the listed columns", custom },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_MODE("style", struct state, style, styles, .help = "set of columns"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_thermo_style)
const struct ts_command_style ts_command_thermo_style = {
	.style = {
		.name = "thermo_style",
		.kind = TS_KIND_COMMAND,
		.summary = "Sets the columns of thermo output",
		.doc = "Keywords: step elapsed time dt cpu tpcpu spcpu cpuremain atoms ke erotate fmax fnorm "
		       "vol density lx ly lz xlo xhi ylo yhi zlo zhi, and those of other parts of the "
		       "program. The title of a compute, fix or variable is its name, with `legacy yes` its "
		       "first eight characters. The default style is one.\n\n"
		       "Keywords, and computes, fixes and variables that exist, are checked by this command; "
		       "others may be defined later, before the first run.",
		.example = "thermo_style custom step time ke c_energy f_bit[1] v_depth",
		.args = args,
		.ranks = TS_RANKS_FORMULAS,
		.state_size = sizeof(struct state),
	},
	.run = run,
};
