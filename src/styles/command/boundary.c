/* Command boundary: what happens at the faces of the box. */
#include "core/sim.h"

#include <string.h>

#include "particles/domain.h"

#include "base/banned.h"

struct state {
	const char *face[3];
};

/* "p", "f", "fs": one letter for both faces of a dimension, or one for each. */
static enum ts_status read_faces(struct tsim *sim, const char *text, char dim,
				 const struct ts_place *where, enum ts_face face[2])
{
	static const char letters[] = "pfsm"; /* in the order of enum ts_face */
	size_t n = strlen(text);

	for (int side = 0; side < 2; side++) {
		const char *at = n == 1 || n == 2 ? strchr(letters, text[n == 2 ? side : 0]) : NULL;

		if (!at || !*at)
			return ts_fail(
				&sim->error, TS_SYNTAX, where,
				"boundary: %c is '%s', expected p, f, s or m, or two of f, s, m",
				dim, text);
		face[side] = (enum ts_face)(at - letters);
	}
	if ((face[0] == TS_FACE_PERIODIC) != (face[1] == TS_FACE_PERIODIC))
		return ts_fail(&sim->error, TS_SYNTAX, where,
			       "boundary: %c is '%s', but both faces must be periodic or none", dim,
			       text);
	return TS_OK;
}

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct state *s = state;
	enum ts_face face[3][2];

	if (sim->domain->exists)
		return ts_fail(&sim->error, TS_STATE, where,
			       "boundary must come before the simulation box is created");
	for (int d = 0; d < 3; d++)
		TS_TRY(read_faces(sim, s->face[d], (char)('x' + d), where, face[d]));
	memcpy(sim->domain->box.face, face, sizeof face);
	return TS_OK;
}

static const struct ts_arg args[] = {
	TS_WORD("x", struct state, face[0], .flags = TS_POSITIONAL,
		.help = "faces across x: p, f, s or m, or two letters for low and high"),
	TS_WORD("y", struct state, face[1], .flags = TS_POSITIONAL, .help = "faces across y"),
	TS_WORD("z", struct state, face[2], .flags = TS_POSITIONAL, .help = "faces across z"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_boundary)
const struct ts_command_style ts_command_boundary = {
	.style = {
		.name = "boundary",
		.kind = TS_KIND_COMMAND,
		.summary = "Says what happens at the faces of the box",
		.doc = "p: periodic. f: fixed, particles that leave are deleted (see thermo_modify lost).\n"
		       "s: the face follows the outermost particles. m: the same, but the box never becomes\n"
		       "smaller than it was created. Without the command: p p p.",
		.example = "boundary p p f\n"
		       "boundary f f fs",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.run = run,
};
