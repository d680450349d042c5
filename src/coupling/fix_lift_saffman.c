#include "coupling/coupling_force.h"

#include "law/lift.h"
#include "math/vec3.h"
#include "particle/particles.h"

#include "base/banned.h"

enum { SAFFMAN, MEI };
static const char *const laws[] = { "saffman", "mei", NULL };

struct state {
	struct ts_coupling_force force; /* first */
	int law;
};

static void add_force(const struct ts_instance *self, const struct tsim *sim, size_t i,
		      const struct ts_coupling_local_flow *around, double f[3], double torque[3])
{
	const struct state *s = self->state;
	double d = 2 * sim->particles->radius[i], curl[3], vorticity, c;

	(void)torque;
	ts_coupling_curl(around->gradient, curl);
	vorticity = ts_norm(curl);
	c = ts_lift_saffman(d, around->density, around->viscosity, vorticity);
	if (s->law == MEI)
		c *= ts_lift_mei(d, around->density, around->viscosity, ts_norm(around->slip), vorticity);
	ts_cross(around->slip, curl, f);
	for (int k = 0; k < 3; k++)
		f[k] *= c;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	const struct state *s = self->state;

	TS_TRY(ts_coupling_force_init(self, sim));
	return s->law == MEI ? ts_flow_require_viscosity(sim, self, s->force.flow) : TS_OK;
}

static const struct ts_arg args[] = {
	TS_ENUM("law", struct state, law, laws, .fallback = "mei",
		.help = "lift coefficient: for small Reynolds numbers, or Mei's fit for larger ones"),
	TS_COUPLING_FORCE_ARGS(struct state, force),
	TS_ARGS_END,
};

TS_STYLE(fix, ts_coupling_force_style, ts_fix_lift_saffman)
const struct ts_coupling_force_style ts_fix_lift_saffman = {
	.style = {
		.name = "lift/saffman",
		.summary = "Saffman lift on particles that slip in a shear flow",
		.doc = "F = 1.615 d^2 sqrt(rho mu/|W|) C (w x W), with slip w = u - v and vorticity W =\n"
			"curl u. C = 1 (law saffman), or with Re = rho |w| d/mu and a = |W| d/(2 |w|) C =\n"
			"(1 - 0.3314 sqrt a) exp(-Re/10) + 0.3314 sqrt a up to Re = 40 and C = 0.0524\n"
			"sqrt(a Re) beyond (law mei). A sphere that moves slower than the fluid is pushed\n"
			"to where the flow is faster. A fluid that is solved for loses the momentum that\n"
			"the particles gain. In two dimensions the force is that of a row of 3/(2 d) spheres per unit\n"
			"depth, whose volume is that of the disc. f_ID[1] ... [3] is the total force.",
		.example = "flow_style projection cells 10 10 40 viscosity 1.0e-3 density 1000\n"
			   "fix lift all lift/saffman",
		.cite = "P. G. Saffman, J. Fluid Mech. 22 (1965) 385; R. Mei, Int. J. Multiphase Flow 18 "
			"(1992) 145",
		.args = args,
		.state_size = sizeof(struct state),
		.init = init,
		.archive = ts_coupling_force_archive,
		.fini = ts_coupling_force_fini,
		TS_COUPLING_FORCE_SLOTS,
	},
	.force = add_force,
	.row = true,
	.sheared = true,
};
