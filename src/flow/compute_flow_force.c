/* Compute: force of the fluid on a face of its grid. */
#include "flow/flow.h"
#include "flow/flow_measures.h"
#include "math/vec3.h"
#include "region/region.h"

#include "base/banned.h"

struct state {
	int side;
	struct ts_instance *region;
	struct tsim *sim;
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	struct ts_fluid *fluid;

	s->sim = sim;
	TS_TRY(ts_flow_require_fluid(sim, "compute flow/force", &self->where, &fluid));
	if (fluid->face[s->side / 2][s->side % 2] != TS_FLOW_PERIODIC && s->side / 2 < fluid->grid.dimensions)
		return TS_OK;
	return ts_fail(&sim->error, TS_STATE, ts_instance_word(self, ts_flow_face_names[s->side]),
		       "compute flow/force: nothing bounds the fluid at %s, %s", ts_flow_face_names[s->side],
		       s->side / 2 < fluid->grid.dimensions ? "which is periodic"
							    : "the flow is in two dimensions");
}

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	struct state *s = self->state;
	struct ts_flow_face_load push;
	struct ts_fluid *fluid;

	(void)sim;
	TS_TRY(ts_flow_require_fields(s->sim, "compute flow/force", &self->where, &fluid));
	TS_TRY(ts_flow_face_force(fluid, s->sim, s->side / 2, (enum ts_grid_side)(s->side % 2), s->region,
				  &push));
	for (int d = 0; d < 3; d++) {
		out->data[d] = push.pressure[d] + push.shear[d];
		out->data[3 + d] = push.pressure[d];
		out->data[6 + d] = push.shear[d];
	}
	out->data[9] = push.area;
	return TS_OK;
}

static const char *const columns[] = { "fx", "fy", "fz", "fpx", "fpy", "fpz", "fsx", "fsy", "fsz", "area" };

static const struct ts_value values[] = {
	{ "force", "force", "force (3 components), pressure force (3), shear force (3), area", TS_VECTOR, 10,
	  columns, eval },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_ENUM("face", struct state, side, ts_flow_face_names, .flags = TS_POSITIONAL,
		.help = "face of the grid"),
	TS_REGION("region", struct state, region, .flags = TS_OPTIONAL,
		  .help = "only faces of cells whose centre is in this region"),
	TS_ARGS_END,
};

TS_STYLE(compute, ts_style, ts_compute_flow_force)
const struct ts_style ts_compute_flow_force = {
	.name = "flow/force",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.summary = "Force of the fluid on a face of its grid",
	.doc = "The force of the fluid on a wall, inlet or outlet: c_ID[1] to [3] is the total force, [4] to "
	       "[6] the pressure force, [7] to [9] the shear force with stress mu du/dn, [10] the area, in "
	       "two dimensions of the depth of the box. The pressure on the face is extrapolated from the "
	       "two adjacent cells. The shear stress is the momentum flux in the equations of the fluid, so "
	       "in a steady flow the momentum balance along the face holds to round-off. Without an open "
	       "face the pressure is known up to a constant: its mean is 0, or `pressure_level` of "
	       "flow_style. For bodies in the fluid see fix immersed/boundary.",
	.example = "compute lid all flow/force yhi\nthermo_style custom step c_lid[7]",
	.args = args,
	.state_size = sizeof(struct state),
	.values = values,
	.init = init,
};
