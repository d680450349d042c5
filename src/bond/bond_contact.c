#include "base/clones.h"
TS_UNROLLED

#include <math.h>

#include "bond/bond_force.h"
#include "bond/bond_loop.h"
#include "contact/contact_energy.h"
#include "law/spring_dashpot.h"

#include "base/banned.h"

struct contact_bond {
	struct ts_bond bond;
};

struct coeff {
	double stiffness, ultimate, damping;
};

static enum ts_status complete(struct tsim *sim, void *coeff, const struct ts_place *where)
{
	(void)sim, (void)coeff, (void)where;
	return TS_OK;
}

static bool contact_bond_tension(const void *coeff, const struct ts_bond_state *state, double *tension)
{
	const struct coeff c = *(const struct coeff *)coeff;
	double spring = c.stiffness * state->extension, total = spring + c.damping * state->rate;
	bool holds = !(fabs(spring) > c.ultimate);

	*tension = holds ? total : spring;
	return holds;
}

TS_CLONES static long compute_contact_bonds(void *task, size_t from, size_t to)
{
	return ts_bond_compute_slices(task, from, to, contact_bond_tension);
}

static bool damped(const void *coeff)
{
	return ((const struct coeff *)coeff)->damping > 0;
}

static double stiffness(const void *coeff, double rest)
{
	(void)rest;
	return ((const struct coeff *)coeff)->stiffness;
}

static double spring(const void *coeff, double extension, double rest)
{
	(void)rest;
	return ((const struct coeff *)coeff)->stiffness * extension;
}

static double energy(const void *coeff, double extension, double rest)
{
	(void)rest;
	return 0.5 * ((const struct coeff *)coeff)->stiffness * extension * extension;
}

static double contact_bond_time_limit(const void *coeff, double rest, double mass, bool explicit_euler)
{
	const struct coeff *c = coeff;
	const struct ts_granular_pair same = { .kn = c->stiffness, .gamman = c->damping };

	(void)rest;
	return ts_spring_dashpot_limit(&same, mass, explicit_euler);
}

static const struct ts_arg coeff_rows[] = {
	TS_REAL("stiffness", struct coeff, stiffness, .range = TS_POSITIVE, .unit = "force/length",
		.help = "stiffness K of the bond"),
	TS_REAL("ultimate", struct coeff, ultimate, .range = TS_POSITIVE, .unit = "force",
		.help = "strength: the bond breaks when |K U| exceeds this"),
	TS_REAL("damping", struct coeff, damping, .range = TS_NOT_NEGATIVE, .fallback = "0",
		.unit = "force/velocity",
		.help = "viscous damping along the bond; its force does not count for breaking"),
	TS_ARGS_END,
};

TS_STYLE(bond, ts_bond_style, ts_bond_contact)
const struct ts_bond_style ts_bond_contact = {
	.style = { .name = "contact",
		   .kind = TS_KIND_BOND,
		   .ranks = TS_RANKS_OWN,
		   .summary = "contact bond: a breakable linear spring between two centres",
		   .doc = "The bond force acts along the line of centres:\n\n"
			  "  F = -K U - damping dU/dt,   U = r - r0\n\n"
			  "with the distance r of the centres and the rest length r0, the distance when the "
			  "bond was created. There is no shear force and no moment. A bond breaks "
			  "irreversibly when |K U| > ultimate, in tension or in compression. Broken bonds "
			  "are counted by the thermo keyword brokenbonds and listed with time and position "
			  "by fix bond/breakage.\n\n"
			  "Bonded particles that overlap interact by the pair style as well, unless "
			  "special_bonds switches that off. A single bond with the reduced mass m* is stable "
			  "for time steps below 2 sqrt(m*/K), with damping below 2 (sqrt(w^2 + g^2) - "
			  "g)/w^2, w^2 = K/m*, g = damping/(2 m*); the limit of a network of bonds is lower; "
			  "tsim estimates it at the stiffest parts of the network, see doc/stability.md.",
		   .example = "bond_style contact\n"
			      "bond_coeff 1 stiffness 2.0e5 ultimate 3.0\n"
			      "create_bonds many rock rock 1 0.0 1.05e-3",
		   .cite = "D. O. Potyondy, P. A. Cundall, Int. J. Rock Mech. Min. Sci. 41 (2004) 1329",
		   .coeff = coeff_rows,
		   .state_size = sizeof(struct contact_bond),
		   .archive = ts_bond_archive,
		   .fingerprint = ts_bond_fingerprint,
		   .init = ts_bond_init,
		   .hook = { [TS_STAGE_FORCE] = ts_bond_force },
		   .energy = ts_contact_energy_of_bonds,
		   .plan = ts_bond_plan,
		   .fini = ts_bond_fini },
	.coeff_size = sizeof(struct coeff),
	.complete = complete,
	.compute = compute_contact_bonds,
	.damped = damped,
	.stiffness = stiffness,
	.spring = spring,
	.energy = energy,
	.limit = contact_bond_time_limit,
};
