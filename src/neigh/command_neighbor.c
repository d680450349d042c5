/* Command neighbor: how far beyond contact neighbours are remembered. */
#include "core/sim.h"

#include "neigh/neigh.h"

#include "base/banned.h"

struct state {
	double skin;
	int style;
	bool fixed;
};

static const char *const styles[] = { "bin", "nsq", "multi", NULL };

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct state *s = state;

	(void)where;
	sim->neigh->skin = s->skin;
	sim->neigh->fixed_skin = s->fixed;
	return TS_OK;
}

static const struct ts_arg args[] = {
	TS_REAL("skin", struct state, skin, .flags = TS_POSITIONAL, .range = TS_NOT_NEGATIVE,
		.unit = "length", .help = "extra distance, at most; 0: chosen from the radii"),
	TS_ENUM("style", struct state, style, styles, .flags = TS_POSITIONAL, .fallback = "bin",
		.help = "no effect: the method adapts to the radii"),
	TS_BOOL("fixed", struct state, fixed, .fallback = "no", .help = "never less than that"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_neighbor)
const struct ts_command_style ts_command_neighbor = {
	.style = {
		.name = "neighbor",
		.kind = TS_KIND_COMMAND,
		.summary = "Sets the extra distance of the neighbour search",
		.doc = "Pairs nearer than the sum of their radii plus the skin are remembered until a "
		       "particle has\n"
		       "moved half the skin. A large skin means fewer searches and longer lists; results do "
		       "not\n"
		       "depend on it. At each search the skin is chosen that suits the speeds as they are, v "
		       "dt being the\n"
		       "way of the fastest particle in a step and d the smallest diameter: s = sqrt(6 v dt "
		       "d), at least a\n"
		       "hundredth of d and at most what is given. Where a search would be due again in less "
		       "than 40\n"
		       "steps, and all faces are fixed, it is more than given, up to s = 1.6 d (v "
		       "dt/d)^(1/4). It is not\n"
		       "less than given where meshes, walls or the box move, and as given with `fixed yes`, "
		       "with `legacy\n"
		       "yes`, where outputs depend on it, and with `thermo_modify lost ignore`: particles "
		       "that have left\n"
		       "are deleted, and others wrapped into a periodic box, when some particle has moved "
		       "half the skin\n"
		       "given; if all faces are fixed, that is watched apart from searches.",
		.example = "neighbor 0.001 bin\nneighbor 0.001 bin fixed yes",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.run = run,
};
