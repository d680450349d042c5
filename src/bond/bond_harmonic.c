#include "base/clones.h"
TS_UNROLLED

#include "bond/bond_force.h"
#include "bond/bond_loop.h"
#include "contact/contact_energy.h"
#include "law/spring_dashpot.h"

#include "base/banned.h"

struct harmonic {
	struct ts_bond bond;
};

struct coeff {
	double k, length;
};

static enum ts_status complete(struct tsim *sim, void *coeff, const struct ts_place *where)
{
	(void)sim, (void)coeff, (void)where;
	return TS_OK;
}

static bool harmonic_tension(const void *coeff, const struct ts_bond_state *state, double *tension)
{
	*tension = 2 * ((const struct coeff *)coeff)->k * state->extension;
	return true;
}

TS_CLONES static long compute_harmonic_bonds(void *task, size_t from, size_t to)
{
	return ts_bond_compute_slices(task, from, to, harmonic_tension);
}

static bool damped(const void *coeff)
{
	(void)coeff;
	return false;
}

static double length(const void *coeff)
{
	return ((const struct coeff *)coeff)->length;
}

static double stiffness(const void *coeff, double rest)
{
	(void)rest;
	return 2 * ((const struct coeff *)coeff)->k;
}

static double spring(const void *coeff, double extension, double rest)
{
	(void)rest;
	return 2 * ((const struct coeff *)coeff)->k * extension;
}

static double energy(const void *coeff, double extension, double rest)
{
	(void)rest;
	return ((const struct coeff *)coeff)->k * extension * extension;
}

static double limit(const void *coeff, double rest, double mass, bool explicit_euler)
{
	const struct ts_granular_pair same = { .kn = stiffness(coeff, rest) };

	return ts_spring_dashpot_limit(&same, mass, explicit_euler);
}

static const struct ts_arg coeff_rows[] = {
	TS_REAL("K", struct coeff, k, .flags = TS_POSITIONAL, .range = TS_POSITIVE, .unit = "energy/area",
		.help = "half the stiffness of the bond"),
	TS_REAL("r0", struct coeff, length, .flags = TS_POSITIONAL, .range = TS_NOT_NEGATIVE,
		.unit = "length", .help = "length of a bond without force"),
	TS_ARGS_END,
};

TS_STYLE(bond, ts_bond_style, ts_bond_harmonic)
const struct ts_bond_style ts_bond_harmonic = {
	.style = { .name = "harmonic",
		   .kind = TS_KIND_BOND,
		   .ranks = TS_RANKS_OWN,
		   .summary = "spring of LAMMPS between two centres, which does not break",
		   .doc = "The bond force acts along the line of centres, > 0 attractive, and the bond has "
			  "the energy E:\n\n"
			  "  F = 2 K (r - r0),   E = K (r - r0)^2\n\n"
			  "with the distance r of the centres. As in LAMMPS K includes the factor 1/2, and "
			  "r0 is the length given, not that with which the bond was created. Bonded "
			  "particles that overlap interact by the pair style as well, as in LAMMPS, unless "
			  "special_bonds switches that off. Bonds that break: bond contact, or fix "
			  "bond/break.\n\n"
			  "A single bond with the reduced mass m* is stable for time steps below 2 "
			  "sqrt(m*/(2 K)).",
		   .example = "atom_style hybrid sphere bond\n"
			      "bond_style harmonic\n"
			      "bond_coeff 1 500 1.0",
		   .coeff = coeff_rows,
		   .state_size = sizeof(struct harmonic),
		   .archive = ts_bond_archive,
		   .fingerprint = ts_bond_fingerprint,
		   .init = ts_bond_init,
		   .hook = { [TS_STAGE_FORCE] = ts_bond_force },
		   .energy = ts_contact_energy_of_bonds,
		   .plan = ts_bond_plan,
		   .fini = ts_bond_fini },
	.coeff_size = sizeof(struct coeff),
	.complete = complete,
	.compute = compute_harmonic_bonds,
	.damped = damped,
	.length = length,
	.stiffness = stiffness,
	.spring = spring,
	.energy = energy,
	.limit = limit,
};
