/* Command boundary: boundary conditions of the box. */
#include "core/sim.h"

#include <string.h>

#include "box/domain.h"

#include "base/banned.h"

struct state {
	const char *face[3];
};

static enum ts_status set_boundary(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct state *s = state;
	enum ts_face face[3][2];

	if (sim->has_box)
		return ts_fail(&sim->error, TS_STATE, where,
			       "boundary must come before the simulation box is created; later it is "
			       "`change_box all boundary x y z`");
	TS_TRY(ts_domain_read_faces(sim, s->face, where, face));
	memcpy(sim->domain->box.face, face, sizeof face);
	return TS_OK;
}

static const struct ts_arg args[] = {
	TS_WORD("x", struct state, face[0], .flags = TS_POSITIONAL,
		.help = "faces normal to x: p, f, s or m, or two letters for the low and the high face"),
	TS_WORD("y", struct state, face[1], .flags = TS_POSITIONAL, .help = "faces normal to y"),
	TS_WORD("z", struct state, face[2], .flags = TS_POSITIONAL, .help = "faces normal to z"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_boundary)
const struct ts_command_style ts_command_boundary = {
	.style = {
		.name = "boundary",
		.kind = TS_KIND_COMMAND,
		.summary = "sets the boundary conditions of the box",
		.doc = "p: periodic. f: fixed, particles that cross the face are deleted (see thermo_modify "
		       "lost). s: shrink-wrapped, the face follows the outermost particle. m: shrink-wrapped, "
		       "but the box does not become smaller than it was created. Default: p p p.\n\n"
		       "A shrink-wrapped face is placed 1e-4 of the initial box length outside the outermost "
		       "particle centre. It is moved when the contact list is rebuilt, not in each step.",
		.example = "boundary p p f\n"
		       "boundary f f fs",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.run = set_boundary,
};
