/* Command flow_set: initial velocity of the fluid. */
#include "flow/flow_arguments.h"
#include "flow/fluid_slabs.h"
#include "flow/pressure_projection.h"
#include "flow/projection.h"

#include <math.h>

#include "base/banned.h"

struct state {
	struct ts_words velocity, set;
};

struct field {
	struct ts_number velocity[3];
	const char *set[3];
};

static enum ts_status evaluate_component(struct tsim *sim, const struct field *f, struct ts_fluid *fluid,
					 int c, const struct ts_place *where)
{
	const struct ts_grid *grid = &fluid->grid;
	int top[3];

	for (int d = 0; d < 3; d++)
		top[d] = grid->n[d] + (d == c && grid->ghosts[d]);
	for (int k = 0; k < top[2]; k++)
		for (int j = 0; j < top[1]; j++)
			for (int i = 0; i < top[0]; i++) {
				const double x[3] = { (c == 0 ? grid->face : grid->centre)[0][i],
						      (c == 1 ? grid->face : grid->centre)[1][j],
						      (c == 2 ? grid->face : grid->centre)[2][k] };
				double u;

				TS_TRY(ts_flow_set_coordinates(sim, f->set, x, where));
				TS_TRY(ts_number_now(sim, &f->velocity[c], where, &u));
				if (!isfinite(u))
					return ts_fail(&sim->error, TS_RANGE, where,
						       "flow_set: the velocity at (%g %g %g) would be %g",
						       x[0], x[1], x[2], u);
				if (ts_fluid_has_plane(fluid, k))
					fluid->u[c][ts_at(grid, i, j, k)] = u;
			}
	return TS_OK;
}

/* The grid of the present box; the velocity that it would carry over is replaced. */
static enum ts_status set_up_grid(struct ts_instance *flow, struct tsim *sim, struct ts_projection *p)
{
	for (int d = 0; d < 3 && p->fluid.u[d]; d++)
		ts_grid_field_clear(p->fluid.u[d], 0, p->fluid.grid.size);
	return ts_projection_setup(flow, sim);
}

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct state *s = state;
	struct ts_arena arena = { 0 };
	struct field field = { 0 };
	struct ts_projection *p;
	struct ts_instance *flow;
	enum ts_status status;

	TS_TRY(ts_projection_require(sim, "flow_set", where, &flow, &p));
	status = ts_flow_read_vector(sim, "flow_set: velocity", s->velocity, where, &arena, field.velocity);
	if (status == TS_OK && p->cells[2] == 1)
		status = ts_flow_refuse_depth(sim, "flow_set: velocity", s->velocity, field.velocity);
	if (status == TS_OK)
		status = ts_flow_read_set(sim, "flow_set: set", s->set, where, &arena, field.set);
	if (status == TS_OK)
		status = set_up_grid(flow, sim, p);
	for (int c = 0; c < p->fluid.grid.dimensions && status == TS_OK; c++)
		status = evaluate_component(sim, &field, &p->fluid, c, where);
	ts_arena_release(&arena);
	TS_TRY(status);
	TS_TRY(ts_projection_setup(flow, sim));
	if (ts_projection_keep_faces(p) != TS_OK)
		return ts_nomem(&sim->error);
	p->given = true;
	return ts_projection_project_initial(flow, sim);
}

static const struct ts_arg args[] = {
	TS_LIST_KEYWORD("velocity", struct state, velocity, .flags = TS_TO_KEYWORD,
			.help = "VX VY VZ: numbers or v_NAME"),
	TS_SOME_KEYWORD("set", struct state, set, TS_REPEAT,
			.help = "x|y|z name: internal-style variable that is set to the coordinate of each "
				"point before the velocity is evaluated; may be repeated"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_flow_set)
const struct ts_command_style ts_command_flow_set = {
	.style = { .name = "flow_set",
		   .kind = TS_KIND_COMMAND,
		   .ranks = TS_RANKS_FORMULAS,
		   .summary = "Sets the initial velocity of the fluid",
		   .doc = "Each component is evaluated at its own points, the faces of the cells. The field\n"
			  "is then projected onto a field without divergence, so flow_boundary must precede\n"
			  "this command; an inlet or outlet that follows is warned of. Without flow_set the "
			  "fluid starts at rest.",
		   .example = "variable xx internal 0\n"
			      "variable yy internal 0\n"
			      "variable u equal sin(v_xx)*cos(v_yy)\n"
			      "variable v equal -cos(v_xx)*sin(v_yy)\n"
			      "flow_set velocity v_u v_v 0 set x xx set y yy",
		   .args = args,
		   .state_size = sizeof(struct state) },
	.needs_box = true,
	.run = run,
};
