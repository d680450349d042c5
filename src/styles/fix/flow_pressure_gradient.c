#include "flow/flow_force.h"

#include "particles/body.h"

#include "base/banned.h"

struct state {
	struct ts_flow_force force; /* first */
	int interpolation;
};

static void act(const struct ts_instance *self, const struct tsim *sim, size_t i,
		const struct ts_flow_around *around, double f[3], double torque[3])
{
	const struct state *s = self->state;
	const struct ts_fluid *fluid = s->force.fluid;
	double volume = ts_body_volume(sim, sim->particles->radius[i]);

	(void)torque;
	for (int c = 0; c < fluid->grid.dimensions; c++) {
		struct ts_share share;

		ts_share_face(fluid, c, around->place, around->cell,
			      (enum ts_interpolation)s->interpolation, &share);
		f[c] = -volume * ts_share_gradient(&fluid->grid, &share, c, fluid->p);
	}
}

static const struct ts_arg args[] = {
	TS_ENUM("interpolation", struct state, interpolation, ts_interpolation_names, .fallback = "linear",
		.help = "of the gradient to the particle: between faces, or mean of its cell"),
	TS_ARGS_END,
};

TS_STYLE(fix, ts_flow_force_style, ts_fix_flow_pressure_gradient)
const struct ts_flow_force_style ts_fix_flow_pressure_gradient = {
	.style = {
		.name = "flow/pressure_gradient",
		.summary = "force of the fluid's pressure gradient on each particle",
		.doc = "F = -V_p grad p, the gradient interpolated from the faces of cells; next to a boundary that of\n"
		       "the nearest face inside. Where the weight of the fluid is in its equations (flow_style projection\n"
		       "body_force) and held by walls, that contains the buoyancy; else add fix buoyancy.\n\n"
		       "The reaction needs nothing: with fix void_fraction the fluid has -e grad p, and the particles the\n"
		       "rest of -grad p. Without, the fluid is also where the particle is, and that part of it feels and\n"
		       "follows the gradient. In either case momentum of particles and fluid together is kept to 1e-3 to 1e-2\n"
		       "of it, not to round-off: doc/coupling.md says why. f_ID[1] ... [3] is the total.",
		.example = "flow_style projection cells 10 10 40 viscosity 1.8e-5 density 1.2 body_force 0 0 -9.81\n"
			   "fix lift all flow/pressure_gradient",
		.args = args,
		.state_size = sizeof(struct state),
		.init = ts_flow_force_init,
		.archive = ts_flow_force_archive,
		.fini = ts_flow_force_fini,
		TS_FLOW_FORCE_SLOTS,
	},
	.act = act,
	.solved = true,
	.internal = true,
};
