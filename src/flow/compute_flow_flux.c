/* Compute flow/flux: volume flow through a plane or a face of the grid. */
#include "base/axes.h"
#include "flow/flow.h"
#include "flow/flow_measures.h"
#include "region/region.h"

#include "base/banned.h"

enum { NSIDES = 6 };

struct state {
	int mode; /* sides, then axes */
	double at;
	struct ts_instance *region;
	struct tsim *sim;
};

static double plane_coordinate(const struct state *s, const struct ts_grid *grid)
{
	if (s->mode >= NSIDES)
		return s->at;
	return grid->face[s->mode / 2][s->mode % 2 ? grid->n[s->mode / 2] : 0];
}

static int axis_of(const struct state *s)
{
	return s->mode < NSIDES ? s->mode / 2 : s->mode - NSIDES;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	struct ts_fluid *fluid;
	int d = axis_of(s);

	s->sim = sim;
	TS_TRY(ts_flow_require_fluid(sim, "compute flow/flux", &self->where, &fluid));
	if (ts_grid_find(&fluid->grid, d, plane_coordinate(s, &fluid->grid)) >= 0)
		return TS_OK;
	return ts_fail(&sim->error, TS_RANGE, &self->where,
		       "compute flow/flux: %s = %g is outside of the fluid's grid, which goes from %g to %g",
		       ts_axis_names[d], s->at, fluid->grid.face[d][0],
		       fluid->grid.face[d][fluid->grid.n[d]]);
}

static enum ts_status compute_flux(struct ts_instance *self, struct ts_flow_flux_sums *out)
{
	struct state *s = self->state;
	struct ts_fluid *fluid;

	TS_TRY(ts_flow_require_fields(s->sim, "compute flow/flux", &self->where, &fluid));
	return ts_flow_flux(fluid, s->sim, axis_of(s), plane_coordinate(s, &fluid->grid), s->region, out);
}

static enum ts_status eval_flux(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	struct ts_flow_flux_sums through;

	(void)sim;
	TS_TRY(compute_flux(self, &through));
	out->data[0] = through.flux;
	return TS_OK;
}

static enum ts_status eval_all(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	struct ts_flow_flux_sums through;

	(void)sim;
	TS_TRY(compute_flux(self, &through));
	out->data[0] = through.flux;
	out->data[1] = through.area;
	out->data[2] = through.area > 0 ? through.flux / through.area : 0;
	return TS_OK;
}

static const char *const columns[] = { "flux", "area", "velocity" };

static const struct ts_value values[] = {
	{ "flux", "length^3/time", "volume flow rate, positive along the axis", TS_SCALAR, 1, NULL,
	  eval_flux },
	{ "all", "", "flow rate, area, flow rate divided by area (superficial velocity)", TS_VECTOR, 3,
	  columns, eval_all },
	{ .name = NULL },
};

static const struct ts_arg place[] = {
	TS_REAL("at", struct state, at, .flags = TS_POSITIONAL, .unit = "length",
		.help = "coordinate of the plane"),
	TS_ARGS_END,
};

static const struct ts_mode modes[] = {
	{ "xlo", "the lower face of the grid across x", NULL },
	{ "xhi", "the upper one", NULL },
	{ "ylo", "the lower face across y", NULL },
	{ "yhi", "the upper one", NULL },
	{ "zlo", "the lower face across z", NULL },
	{ "zhi", "the upper one", NULL },
	{ "x", "a plane across x", place },
	{ "y", "a plane across y", place },
	{ "z", "a plane across z", place },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_MODE("where", struct state, mode, modes, .help = "the plane"),
	TS_REGION("region", struct state, region, .flags = TS_OPTIONAL,
		  .help = "only faces of cells whose centre is in this region"),
	TS_ARGS_END,
};

TS_STYLE(compute, ts_style, ts_compute_flow_flux)
const struct ts_style ts_compute_flow_flux = {
	.name = "flow/flux",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.summary = "Volume flow rate of the fluid through a plane",
	.doc = "The sum of e u A over the faces of cells in the plane, with u the velocity normal to the "
	       "plane, e the void fraction (1 without fix void_fraction) and A the area of a face, in two "
	       "dimensions of the depth of the box. Between two planes of faces the sum is interpolated "
	       "linearly. c_ID is the volume flow rate, positive along the axis on both faces of the grid; "
	       "c_ID[2] is the area, c_ID[3] the flow rate divided by the area.",
	.example = "compute in all flow/flux xlo\ncompute half all flow/flux z 0.5 region inner",
	.args = args,
	.state_size = sizeof(struct state),
	.values = values,
	.init = init,
};
