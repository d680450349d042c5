/* Command flow_boundary: conditions at the faces of the fluid's grid. */
#include "flow/flow_arguments.h"
#include "flow/projection.h"

#include "base/banned.h"

enum { NFACES = 6 };
static const char *const face_names[] = { "xlo", "xhi", "ylo", "yhi", "zlo", "zhi", "all", NULL };

enum { EACH_STEP, ONCE };
static const char *const updates[] = { "step", "once", NULL };

/* Conditions that can be chosen; periodic faces follow from the boundary command of the box. */
static const char *const kinds[] = { "wall", "slip", "inlet", "outlet", NULL };
_Static_assert(TS_FLOW_PERIODIC == 0 && TS_FLOW_OUTLET == 4 && TS_FLOW_INTAKE == 5,
	       "kinds begin after the periodic one");

static const char *const depths[] = { "no", "yes", NULL };

struct state {
	int face, kind, update, hydrostatic; /* hydrostatic: -1 if not given */
	struct ts_words velocity, set;
	struct ts_number pressure;
};

static enum ts_flow_face face_type(const struct state *s)
{
	enum ts_flow_face kind = (enum ts_flow_face)(s->kind + TS_FLOW_WALL);

	return kind == TS_FLOW_INLET && !s->pressure.null ? TS_FLOW_INTAKE : kind;
}

static bool has_flow_across(enum ts_flow_face kind)
{
	return kind == TS_FLOW_INLET || ts_flow_face_open(kind);
}

static enum ts_status refuse_invalid_words(struct tsim *sim, const struct state *s,
					   const struct ts_place *where)
{
	bool given = face_type(s) == TS_FLOW_WALL || face_type(s) == TS_FLOW_INLET;

	if (face_type(s) == TS_FLOW_INTAKE && s->velocity.n)
		return ts_fail(&sim->error, TS_SYNTAX, &s->velocity.word[0].place,
			       "flow_boundary: an inlet has a velocity or a pressure, not both");
	if (s->velocity.n && !given)
		return ts_fail(&sim->error, TS_SYNTAX, &s->velocity.word[0].place,
			       "flow_boundary: at %s faces no velocity is given; wall or inlet have one",
			       kinds[s->kind]);
	if (face_type(s) == TS_FLOW_INLET && !s->velocity.n)
		return ts_fail(&sim->error, TS_SYNTAX, where,
			       "flow_boundary: an inlet needs a velocity or a pressure: velocity VX VY VZ, "
			       "or pressure P");
	if (!ts_flow_face_open(face_type(s)) && (!s->pressure.null || s->hydrostatic >= 0))
		return ts_fail(&sim->error, TS_SYNTAX, where,
			       "flow_boundary: %s is for an outlet, or an inlet without velocity; at %s "
			       "faces no pressure is given",
			       s->pressure.null ? "hydrostatic" : "pressure", kinds[s->kind]);
	if (s->set.n && !s->velocity.n && s->pressure.null)
		return ts_fail(&sim->error, TS_SYNTAX, &s->set.word[0].place,
			       "flow_boundary: set x|y|z is of use together with velocity or pressure only");
	return TS_OK;
}

/* Whether a value on the face is a variable, which may depend on the coordinates. */
static bool has_formula(const struct ts_flow_condition *condition)
{
	bool some = condition->pressure.variable;

	for (int d = 0; d < 3; d++)
		some |= condition->velocity[d].variable != NULL;
	return some;
}

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct state *s = state;
	struct ts_flow_condition condition = {
		.kind = face_type(s), .given = true, .once = s->update == ONCE, .where = *where
	};
	const enum ts_flow_depth depth[] = { TS_FLOW_PRESSURE_UNSAID, TS_FLOW_EVEN, TS_FLOW_HYDROSTATIC };
	struct ts_projection *projection;
	struct ts_instance *flow;
	bool passes = false; /* fluid, one of the faces, now or before */

	TS_TRY(refuse_invalid_words(sim, s, where));
	TS_TRY(ts_projection_require(sim, "flow_boundary", where, &flow, &projection));
	if (s->velocity.n)
		TS_TRY(ts_flow_read_vector(sim, "flow_boundary: velocity", s->velocity, where, &flow->arena,
					   condition.velocity));
	if (s->velocity.n && projection->cells[2] == 1)
		TS_TRY(ts_flow_refuse_depth(sim, "flow_boundary: velocity", s->velocity, condition.velocity));
	condition.hydrostatic = depth[s->hydrostatic + 1];
	if (!s->pressure.null) {
		condition.pressure = s->pressure;
		if (s->pressure.variable &&
		    !(condition.pressure.variable = ts_arena_strdup(&flow->arena, s->pressure.variable)))
			return ts_nomem(&sim->error);
	}
	if (s->set.n && !has_formula(&condition))
		return ts_fail(&sim->error, TS_SYNTAX, &s->set.word[0].place,
			       "flow_boundary: set %s: all values of the face are numbers, which do not "
			       "depend on coordinates; give velocity or pressure as v_NAME, or leave out set",
			       s->set.word[0].text);
	TS_TRY(ts_flow_read_set(sim, "flow_boundary: set", s->set, where, &flow->arena, condition.set));
	for (int face = 0; face < NFACES; face++) {
		bool flat = s->face == NFACES && projection->fluid.grid.periodic[face / 2];
		bool plane = s->face == NFACES && face / 2 >= projection->fluid.grid.dimensions;

		if ((s->face != face && s->face != NFACES) || flat || plane)
			continue;
		passes |= has_flow_across(condition.kind) ||
			  has_flow_across(projection->condition[face / 2][face % 2].kind);
		projection->condition[face / 2][face % 2] = condition;
	}
	projection->pressure = NULL;
	if (projection->given && !projection->moved && passes)
		ts_warn(&sim->log, where,
			"flow_boundary: the velocity that flow_set has given was projected between the faces "
			"as they were before: put flow_set after flow_boundary");
	return ts_projection_setup(flow, sim);
}

static const struct ts_arg args[] = {
	TS_ENUM("face", struct state, face, face_names, .flags = TS_POSITIONAL,
		.help = "face of the grid; all: those that are not periodic"),
	TS_ENUM("kind", struct state, kind, kinds, .flags = TS_POSITIONAL, .help = "type of the boundary"),
	TS_SOME_KEYWORD("velocity", struct state, velocity, 0,
			.help = "VX VY VZ: velocity of the wall or of the inflow, numbers or v_NAME"),
	TS_NUMBER("pressure", struct state, pressure, .flags = TS_OPTIONAL, .unit = "pressure",
		  .help = "static pressure on the face, of an outlet (default 0) or of an inlet in place of "
			  "its velocity: a number or v_NAME"),
	TS_ENUM("hydrostatic", struct state, hydrostatic, depths, .flags = TS_OPTIONAL,
		.help = "yes: adds the hydrostatic pressure under body_force, measured from the top of the "
			"grid; no: uniform pressure, although body_force acts along the face"),
	TS_SOME_KEYWORD("set", struct state, set, TS_REPEAT,
			.help = "x|y|z name: internal-style variable that is set to the coordinate of each "
				"point of the face before velocity or pressure is evaluated; may be "
				"repeated"),
	TS_ENUM("update", struct state, update, updates, .fallback = "step",
		.help = "when variables are evaluated: in each step, or once at the beginning of a run, "
			"which suffices for formulas of the coordinates alone"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_flow_boundary)
const struct ts_command_style ts_command_flow_boundary = {
	.style = { .name = "flow_boundary",
		   .kind = TS_KIND_COMMAND,
		   .ranks = TS_RANKS_FORMULAS,
		   .summary = "Sets the boundary conditions on a face of the fluid's grid",
		   .doc = "Must follow flow_style projection. Faces for which no condition is given are\n"
			  "periodic if the box is periodic there, else walls at rest.\n\n"
			  "`wall`: no slip; the wall may have a velocity. `slip`: no flow across and no\n"
			  "shear stress, as in a plane of symmetry. `inlet`: the velocity is given, or the\n"
			  "pressure. `outlet`: the pressure is given, 0 by default, and the velocity has\n"
			  "zero gradient along the normal; fluid that flows back in has no momentum, but\n"
			  "along the face what viscosity exchanges with it, nu/(nu + |u| h) of the velocity\n"
			  "inside, u that of the fluid that enters, h the width of a cell. At an\n"
			  "inlet with a pressure, the fluid that enters has the normal velocity of the "
			  "first\n"
			  "cell: a developed flow. The pressure is the static pressure on the face itself.\n"
			  "With the pressure given at both ends, a channel is driven by the difference; a\n"
			  "face may be inlet and outlet at different times.\n\n"
			  "`hydrostatic yes` adds the weight of the fluid above, rho g (x - x_top), with g\n"
			  "the body_force of flow_style and x_top the top of the grid, along axes that are\n"
			  "not periodic. A fluid at rest then stays at rest, whichever faces are open, if\n"
			  "all have the same pressure P, which is the pressure at the top. If body_force\n"
			  "acts along a face of uniform pressure, `hydrostatic` must be given explicitly as\n"
			  "yes or no, since without the hydrostatic part the fluid is driven through the\n"
			  "face as a jet.\n\n"
			  "Velocities and pressure may be equal-style variables. They are evaluated in each\n"
			  "step, with `update once` at the beginning of a run. With `set y yy` the\n"
			  "internal-style variable yy is set to the coordinate of each point of the face\n"
			  "before the evaluation, for profiles. Values are interpolated linearly between "
			  "two\n"
			  "steps; the pressure acts with its mean over the step (time euler, ab2) or with\n"
			  "the weights of the scheme (rk2, rk3), so that all schemes are of second order in "
			  "the given pressure.",
		   .example = "flow_boundary yhi wall velocity 1 0 0\n"
			      "variable yy internal 0\n"
			      "variable profile equal 4*v_yy*(1-v_yy)\n"
			      "flow_boundary xlo inlet velocity v_profile 0 0 set y yy\n"
			      "flow_boundary xhi outlet\n"
			      "variable push equal 1000+50*sin(2*PI*time)\n"
			      "flow_boundary zlo inlet pressure v_push hydrostatic yes",
		   .args = args,
		   .state_size = sizeof(struct state) },
	.needs_box = true,
	.run = run,
};
