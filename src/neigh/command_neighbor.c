/* Command neighbor: the skin of the neighbour list. */
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
		.unit = "length", .help = "largest skin; 0: chosen from the radii"),
	TS_ENUM("style", struct state, style, styles, .flags = TS_POSITIONAL, .fallback = "bin",
		.help = "no effect: the search adapts to the radii"),
	TS_BOOL("fixed", struct state, fixed, .fallback = "no", .help = "the skin is always the given one"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_neighbor)
const struct ts_command_style ts_command_neighbor = {
	.style = {
		.name = "neighbor",
		.kind = TS_KIND_COMMAND,
		.summary = "Sets the skin of the neighbour list",
		.doc = "The neighbour list has all pairs of particles whose distance is less than the sum of "
		       "their radii plus the skin. It is rebuilt when a particle has moved half the skin. "
		       "With a larger skin builds are rarer and the list is longer; results do not depend on "
		       "it, except the last digits where particles cross periodic faces, which they do when "
		       "the list is built. Until then a particle that has crossed one is beyond the box, as in "
		       "LAMMPS: for regions, which end there, and for fix deform with `remap v`, which "
		       "changes its velocity when it crosses. For these a small skin is more exact.\n\n"
		       "At each build a skin s is chosen that suits the present speeds. With v dt the "
		       "displacement of the fastest particle in a step and d the smallest diameter, s = "
		       "sqrt(6 v dt d), at least d/100 and at most the given skin. If the next build would be "
		       "due in less than 80 steps, and all faces of the box are fixed, s is larger, up to 1.6 d "
		       "(v dt/d)^(1/4), also than given. It is not less than given while meshes, walls "
		       "or the box move. It is exactly the given one with `fixed yes`, with `legacy yes`, "
		       "where outputs depend on it, and with `thermo_modify lost ignore`: particles that have "
		       "left the box are deleted, and others wrapped into a periodic box, when some particle "
		       "has moved half the given skin; if all faces are fixed, this is checked apart from "
		       "builds, and s may be larger.",
		.example = "neighbor 0.001 bin\nneighbor 0.001 bin fixed yes",
		.args = args,
		.ranks = TS_RANKS_FORMULAS,
		.state_size = sizeof(struct state),
	},
	.run = run,
};
