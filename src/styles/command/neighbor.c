/* Command neighbor: how far beyond contact neighbours are remembered. */
#include "core/sim.h"

#include "neigh/neigh.h"

#include "base/banned.h"

struct state {
	double skin;
	int style;
};

static const char *const styles[] = { "bin", "nsq", "multi", NULL };

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct state *s = state;

	(void)where;
	sim->neigh->skin = s->skin;
	return TS_OK;
}

static const struct ts_arg args[] = {
	TS_REAL("skin", struct state, skin, .flags = TS_POSITIONAL, .range = TS_NOT_NEGATIVE,
		.unit = "length", .help = "extra distance; 0: chosen from the radii"),
	TS_ENUM("style", struct state, style, styles, .flags = TS_POSITIONAL, .fallback = "bin",
		.help = "no effect: the method adapts to the radii"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_neighbor)
const struct ts_command_style ts_command_neighbor = {
	.style = {
		.name = "neighbor",
		.kind = TS_KIND_COMMAND,
		.summary = "Sets the extra distance of the neighbour search",
		.doc = "Pairs nearer than the sum of their radii plus the skin are remembered until a particle has\n"
		       "moved half the skin. A large skin means fewer searches and longer lists; results do not\n"
		       "depend on it.",
		.example = "neighbor 0.001 bin",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.run = run,
};
