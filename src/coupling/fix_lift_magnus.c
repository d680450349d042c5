#include "coupling/coupling_force.h"

#include "coupling/sphere_rows.h"
#include "law/lift.h"
#include "math/vec3.h"
#include "particle/particles.h"
#include "particle/sphere_shape.h"

#include "base/banned.h"

enum { RUBINOW, OESTERLE };
static const char *const laws[] = { "rubinow", "oesterle", NULL };

struct state {
	struct ts_coupling_force force; /* first */
	int law;
	bool torque;
};

static void add_force(const struct ts_instance *self, const struct tsim *sim, size_t i,
		      const struct ts_coupling_local_flow *around, double f[3], double torque[3])
{
	const struct state *s = self->state;
	const struct ts_particles *p = sim->particles;
	double d = 2 * p->radius[i], spin[3], c;

	ts_coupling_curl(around->gradient, spin);
	for (int k = 0; k < 3; k++)
		spin[k] = 0.5 * spin[k] - p->omega[i][k];
	c = ts_lift_magnus(d, around->density);
	if (s->law == OESTERLE)
		c *= ts_lift_oesterle(d, around->density, around->viscosity, ts_norm(around->slip),
				      ts_norm(spin));
	ts_cross(spin, around->slip, f);
	for (int k = 0; k < 3; k++) {
		f[k] *= c;
		torque[k] = s->torque ? ts_spin_torque(d, around->viscosity) * spin[k] : 0;
	}
}

static void add_ground(const struct ts_instance *self, const struct tsim *sim, size_t i,
		       struct ts_ground_springs *sum)
{
	const struct state *s = self->state;
	const struct ts_instance *flow = s->force.flow;
	const double d = 2 * sim->particles->radius[i];
	double place[3];
	int cell[3];

	if (!s->torque ||
	    (s->force.fluid && !ts_coupling_locate(s->force.fluid, sim->particles->x[i], place, cell)))
		return;
	sum->turning += ts_spheres_in_row(sim, d) *
			ts_spin_torque(d, ts_flow_style_of(flow)->viscosity(flow)) / ts_inertia(sim, i);
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	const struct state *s = self->state;

	TS_TRY(ts_coupling_force_init(self, sim));
	return s->law == OESTERLE ? ts_flow_require_viscosity(sim, self, s->force.flow) : TS_OK;
}

static const struct ts_arg args[] = {
	TS_ENUM("law", struct state, law, laws, .fallback = "oesterle",
		.help = "lift coefficient: for small Reynolds numbers, or a fit for larger ones"),
	TS_BOOL("torque", struct state, torque, .fallback = "yes",
		.help = "whether the fluid exerts a torque on the particle"),
	TS_COUPLING_FORCE_ARGS(struct state, force),
	TS_ARGS_END,
};

TS_STYLE(fix, ts_coupling_force_style, ts_fix_lift_magnus)
const struct ts_coupling_force_style ts_fix_lift_magnus = {
	.style = {
		.name = "lift/magnus",
		.summary = "Magnus lift on spinning particles, and torque of the fluid on them",
		.doc = "F = pi/8 rho d^3 C (S x w), with slip w = u - v and relative spin S = curl u/2 -\n"
			"omega. C = 1 (law rubinow), or C = Re/Re_s (0.45 + (Re_s/Re - 0.45) exp(-0.05684\n"
			"Re_s^0.4 Re^0.3)) (law oesterle), with Re = rho |w| d/mu and Re_s = rho d^2\n"
			"|S|/mu. The torque is pi mu d^3 S. It is explicit, and stable for time steps below\n"
			"2 I/(pi mu d^3), for spheres rho_p d^2/(30 mu); a larger step is refused. A fluid that is solved for loses the momentum\n"
			"that the particles gain, but not the angular momentum. In two dimensions force\n"
			"and torque are those of a row of 3/(2 d) spheres per unit depth, whose volume is\n"
			"that of the disc. f_ID[1] ... [3] is the total force.",
		.example = "flow_style uniform velocity 0 0 1.0 viscosity 1.0e-3 density 1000\n"
			   "fix curve all lift/magnus",
		.cite = "S. I. Rubinow, J. B. Keller, J. Fluid Mech. 11 (1961) 447; B. Oesterle, T. Bui Dinh, "
			"Exp. Fluids 25 (1998) 16",
		.args = args,
		.state_size = sizeof(struct state),
		.columns = TS_NEED(OMEGA) | TS_NEED(TORQUE),
		.init = init,
		.archive = ts_coupling_force_archive,
		.fini = ts_coupling_force_fini,
		TS_COUPLING_FORCE_SLOTS,
		.ground = add_ground,
	},
	.force = add_force,
	.row = true,
	.sheared = true,
};
