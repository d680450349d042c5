#include "flow/added_mass.h"

#include <string.h>

#include "base/alloc.h"
#include "particles/body.h"
#include "particles/particles.h"

#include "base/banned.h"

struct state {
	struct ts_added_mass mass; /* first */
	bool accelerates;
	double *last[3], *rate[3]; /* velocity of the fluid after its last step, and its change by time */
	size_t size, capacity[2][3];
};

/* Du/Dt at the particle */
static void fluid_acceleration(const struct state *s, const struct ts_flow_around *around, double a[3])
{
	const struct ts_fluid *fluid = s->mass.force.fluid;

	for (int c = 0; c < 3; c++) {
		struct ts_share share;

		a[c] = 0;
		if (!fluid || !s->accelerates)
			continue;
		for (int k = 0; k < 3; k++)
			a[c] += around->u[k] * around->slope[c][k];
		if (!s->size || c >= fluid->grid.dimensions)
			continue;
		ts_share_face(fluid, c, around->place, around->cell, TS_INTERPOLATE_LINEAR, &share);
		a[c] += ts_share_gather(&fluid->grid, &share, s->rate[c]);
	}
}

/* The particle's own acceleration a follows from all forces: m a = f + M (Du/Dt - a). */
static void act(const struct ts_instance *self, const struct tsim *sim, size_t i,
		const struct ts_flow_around *around, double f[3], double torque[3])
{
	const struct state *s = self->state;
	const struct ts_particles *p = sim->particles;
	double added = s->mass.coefficient * around->density * ts_body_volume(sim, p->radius[i]), fluid[3];

	(void)torque;
	fluid_acceleration(s, around, fluid);
	for (int k = 0; k < 3; k++) {
		double own = p->imass[i] == 0 ? 0
					      : (p->f[i][k] + added * fluid[k]) / (p->mass[i] + added);

		f[k] = added * (fluid[k] - own);
	}
}

static enum ts_status carry(struct ts_instance *self, struct tsim *sim, struct ts_fluid *fluid, double dt)
{
	struct state *s = self->state;
	size_t size = fluid->grid.size;
	bool known = s->size == size;

	for (int c = 0; c < 3; c++) {
		if (TS_GROW(s->last[c], s->capacity[0][c], size) != TS_OK ||
		    TS_GROW(s->rate[c], s->capacity[1][c], size) != TS_OK)
			return ts_nomem(&sim->error);
		for (size_t k = 0; k < size; k++) {
			s->rate[c][k] = known ? (fluid->u[c][k] - s->last[c][k]) / dt : 0;
			s->last[c][k] = fluid->u[c][k];
		}
	}
	s->size = size;
	return TS_OK;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	TS_TRY(ts_flow_force_init(self, sim));
	s->mass.force.part.carry = s->mass.force.fluid && s->accelerates ? carry : NULL;
	if (!s->mass.force.fluid || s->size != s->mass.force.fluid->grid.size)
		s->size = 0;
	return TS_OK;
}

static enum ts_status archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a)
{
	static const char *const names[2][3] = { { "lastx", "lasty", "lastz" },
						 { "ratex", "ratey", "ratez" } };
	struct state *s = self->state;

	TS_TRY(ts_flow_force_archive(self, sim, a));
	for (int c = 0; c < 3; c++) {
		TS_TRY(ts_archive_array(a, names[0][c], TS_SAVED_F64, (void **)&s->last[c],
					&s->capacity[0][c], &s->size));
		TS_TRY(ts_archive_array(a, names[1][c], TS_SAVED_F64, (void **)&s->rate[c],
					&s->capacity[1][c], &s->size));
	}
	return TS_OK;
}

static void fini(struct ts_instance *self)
{
	struct state *s = self->state;

	ts_flow_force_fini(self);
	for (int c = 0; c < 3; c++) {
		ts_free(s->last[c]);
		ts_free(s->rate[c]);
	}
}

static const struct ts_arg args[] = {
	TS_REAL("coefficient", struct state, mass.coefficient, .fallback = "0.5", .range = TS_NOT_NEGATIVE,
		.unit = "", .help = "part of the displaced mass that moves with the particle"),
	TS_BOOL("fluid_acceleration", struct state, accelerates, .fallback = "yes",
		.help = "whether Du/Dt counts; no: the fluid is taken as steady and uniform"),
	TS_FLOW_FORCE_ARGS(struct state, mass.force),
	TS_ARGS_END,
};

TS_STYLE(fix, ts_flow_force_style, ts_fix_added_mass)
const struct ts_flow_force_style ts_fix_added_mass = {
	.style = {
		.name = "added_mass",
		.summary = "the fluid that an accelerated particle takes with it",
		.doc = "F = C rho V_p (Du/Dt - dv/dt), C = 1/2 for a sphere. dv/dt is that by all forces, this one among them:\n"
		       "(f + C rho V_p Du/Dt)/(m + C rho V_p), so the particle moves as one of mass m + C rho V_p, stably also\n"
		       "where it is lighter than the fluid. Define it after all other forces; schemes exact and implicit of\n"
		       "drags before it know of it, if it is defined before the run. Du/Dt is that of the fluid at the\n"
		       "particle, du/dt over its last step and u grad u. A fluid that is solved for loses what the particles\n"
		       "gain. f_ID[1] ... [3] is the total.",
		.example = "flow_style uniform velocity 0 0 0 viscosity 1.0e-3 density 1000\n"
			   "fix heavy all added_mass",
		.cite = "T. R. Auton, J. C. R. Hunt, M. Prud'homme, J. Fluid Mech. 197 (1988) 241",
		.args = args,
		.state_size = sizeof(struct state),
		.init = init,
		.archive = archive,
		.fini = fini,
		TS_FLOW_FORCE_SLOTS,
	},
	.act = act,
	.sheared = true,
};
