/* Command flow_boundary: conditions at the faces of the fluid's grid. */
#include "flow/projection.h"

#include "base/banned.h"

enum { NFACES = 6 };
static const char *const face_names[] = { "xlo", "xhi", "ylo", "yhi", "zlo", "zhi", "all", NULL };

enum { EACH_STEP, ONCE };
static const char *const updates[] = { "step", "once", NULL };

/* What can be chosen: a periodic face is one of the box. */
static const char *const kinds[] = { "wall", "slip", "inlet", "outlet", NULL };
_Static_assert(TS_FLOW_PERIODIC == 0 && TS_FLOW_OUTLET == 4, "kinds begin after the periodic one");

struct state {
	int face, kind, update;
	struct ts_words velocity, set;
};

static enum ts_flow_face kind_of(const struct state *s)
{
	return (enum ts_flow_face)(s->kind + TS_FLOW_WALL);
}

static enum ts_status refuse(struct tsim *sim, const struct state *s, const struct ts_place *where)
{
	bool given = kind_of(s) == TS_FLOW_WALL || kind_of(s) == TS_FLOW_INLET;

	if (s->velocity.n && !given)
		return ts_fail(&sim->error, TS_SYNTAX, &s->velocity.word[0].place,
			       "flow_boundary: at %s faces no velocity is given; wall or inlet have one",
			       kinds[s->kind]);
	if (kind_of(s) == TS_FLOW_INLET && !s->velocity.n)
		return ts_fail(&sim->error, TS_SYNTAX, where,
			       "flow_boundary: an inlet needs a velocity: velocity VX VY VZ");
	if (s->set.n && !s->velocity.n)
		return ts_fail(&sim->error, TS_SYNTAX, &s->set.word[0].place,
			       "flow_boundary: set x|y|z is of use together with velocity only");
	return TS_OK;
}

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct state *s = state;
	struct ts_flow_condition condition = { .kind = kind_of(s), .said = true, .once = s->update == ONCE,
					       .where = *where };
	struct ts_projection *projection;
	struct ts_instance *flow;

	TS_TRY(refuse(sim, s, where));
	TS_TRY(ts_projection_require(sim, "flow_boundary", where, &flow, &projection));
	if (s->velocity.n)
		TS_TRY(ts_flow_read_vector(sim, "flow_boundary: velocity", s->velocity, where, &flow->arena,
					   condition.velocity));
	TS_TRY(ts_flow_read_set(sim, "flow_boundary: set", s->set, where, &flow->arena, condition.set));
	for (int face = 0; face < NFACES; face++) {
		bool flat = s->face == NFACES && projection->fluid.grid.periodic[face / 2];
		bool plane = s->face == NFACES && face / 2 >= projection->fluid.grid.dimensions;

		if ((s->face == face || s->face == NFACES) && !flat && !plane)
			projection->condition[face / 2][face % 2] = condition;
	}
	projection->pressure = NULL;
	return ts_projection_prepare(flow, sim);
}

static const struct ts_arg args[] = {
	TS_ENUM("face", struct state, face, face_names, .flags = TS_POSITIONAL,
		.help = "face of the grid; all: those that are not periodic"),
	TS_ENUM("kind", struct state, kind, kinds, .flags = TS_POSITIONAL,
		.help = "what is there"),
	TS_SOME_KEYWORD("velocity", struct state, velocity, 0,
			.help = "VX VY VZ of the wall or of the fluid that comes in: numbers or v_NAME"),
	TS_SOME_KEYWORD("set", struct state, set, TS_REPEAT,
			.help = "x|y|z name: internal-style variable that gets the coordinate of each point "
				"of the face before the velocity is evaluated; may be repeated"),
	TS_ENUM("update", struct state, update, updates, .fallback = "step",
		.help = "when velocities are evaluated: in each step, or once when a run begins, which is enough "
			"for formulas of the place alone"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_flow_boundary)
const struct ts_command_style ts_command_flow_boundary = {
	.style = { .name = "flow_boundary",
		   .kind = TS_KIND_COMMAND,
		   .summary = "Sets what is at a face of the fluid's grid",
		   .doc = "After flow_style projection. Faces where nothing is said are periodic where the box "
			  "is, else walls at rest.\n\n"
			  "wall: the fluid sticks to it; its velocity may be given. slip: no flow across, no shear, "
			  "as in a plane of symmetry. inlet: the velocity is given. outlet: pressure zero, the "
			  "velocity does not change along the normal; where fluid comes back in, it brings no "
			  "momentum.\n\n"
			  "Velocities may be equal-style variables, evaluated in each step; with `update once` when a run "
			  "begins. With `set y yy` the "
			  "internal-style variable yy gets the coordinate of each point of the face before, for "
			  "profiles.",
		   .example = "flow_boundary yhi wall velocity 1 0 0\n"
			      "variable yy internal 0\n"
			      "variable profile equal 4*v_yy*(1-v_yy)\n"
			      "flow_boundary xlo inlet velocity v_profile 0 0 set y yy\n"
			      "flow_boundary xhi outlet",
		   .args = args,
		   .state_size = sizeof(struct state) },
	.needs_box = true,
	.run = run,
};
