/* Command special_bonds: whether the contact force acts between bonded particles. */
#include "core/sim.h"

#include <math.h>

#include "neigh/neigh.h"

#include "base/banned.h"

struct state {
	double lj[3], coul[3], lj_coul[3];
	bool angle, dihedral;
};

static bool is_given(const double factors[3])
{
	return !isnan(factors[0]); /* missing optional vectors are NaN */
}

static enum ts_status set_special_bonds(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct state *s = state;
	const double *factor = is_given(s->lj_coul) ? s->lj_coul : s->lj;

	if (!is_given(factor))
		return ts_fail(&sim->error, TS_SYNTAX, where,
			       "special_bonds: expected lj or lj/coul with three factors");
	if (factor[0] != 0 && factor[0] != 1)
		return ts_fail(&sim->error, TS_RANGE, where,
			       "special_bonds: the first factor, for bonded particles, must be 0 or 1, found "
			       "%g",
			       factor[0]);
	if (factor[1] != 1 || factor[2] != 1)
		return ts_fail(&sim->error, TS_RANGE, where,
			       "special_bonds: the second and third factor, for neighbours of bonded "
			       "particles, must be 1, found %g and %g",
			       factor[1], factor[2]);
	sim->neigh->skip_bonded = factor[0] == 0;
	return TS_OK;
}

static const struct ts_arg args[] = {
	TS_VEC3("lj", struct state, lj, .flags = TS_OPTIONAL,
		.help = "factors of the contact force between particles that are one, two and three bonds "
			"apart: 0 or 1, then 1 and 1"),
	TS_VEC3("coul", struct state, coul, .flags = TS_OPTIONAL, .help = "no effect: no charges"),
	TS_VEC3("lj/coul", struct state, lj_coul, .flags = TS_OPTIONAL, .help = "the same as lj"),
	TS_BOOL("angle", struct state, angle, .fallback = "no", .help = "no effect"),
	TS_BOOL("dihedral", struct state, dihedral, .fallback = "no", .help = "no effect"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_special_bonds)
const struct ts_command_style ts_command_special_bonds = {
	.style = {
		.name = "special_bonds",
		.kind = TS_KIND_COMMAND,
		.summary = "sets whether the contact force acts between bonded particles",
		.doc = "By default the pair style acts between bonded particles as well, in addition to the "
		       "bond force. With a first factor of 0 it does not: bonded particles interact by the "
		       "bond alone, may overlap, and conduct no heat to each other (fix heat/gran). The "
		       "contact force acts from the step after the bond breaks. In a periodic box so small that "
		       "a particle touches two images of its partner, the nearest has the bond, the other the "
		       "contact force.",
		.example = "special_bonds lj 0 1 1 coul 1 1 1",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.run = set_special_bonds,
};
