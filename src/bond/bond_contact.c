#include "base/clones.h"
TS_UNROLLED

#include <math.h>

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

static bool law(const void *coeff, const struct ts_bond_state *state, double *tension)
{
	const struct coeff c = *(const struct coeff *)coeff;
	double pull = c.stiffness * state->extension, damped = pull + c.damping * state->rate;
	bool holds = !(fabs(pull) > c.ultimate);

	*tension = holds ? damped : pull;
	return holds;
}

TS_CLONES static long laws(struct ts_bond_batch *restrict b, const double *restrict rest, size_t n,
			   const void *restrict coeff)
{
	return ts_bond_laws(b, rest, n, coeff, law);
}

TS_CLONES static long share(void *task, size_t from, size_t to)
{
	return ts_bond_share(task, from, to, laws);
}

static bool damped(const void *coeff)
{
	return ((const struct coeff *)coeff)->damping > 0;
}

static double stiffness(const void *coeff)
{
	return ((const struct coeff *)coeff)->stiffness;
}

static double energy(const void *coeff, double extension)
{
	return 0.5 * ((const struct coeff *)coeff)->stiffness * extension * extension;
}

static double limit(const void *coeff, double mass, bool explicit_euler)
{
	const struct coeff *c = coeff;
	const struct ts_granular_pair same = { .kn = c->stiffness, .gamman = c->damping };

	return ts_spring_dashpot_limit(&same, mass, explicit_euler);
}

static const struct ts_arg coeff_rows[] = {
	TS_REAL("stiffness", struct coeff, stiffness, .range = TS_POSITIVE, .unit = "force/length",
		.help = "spring constant K between the centres"),
	TS_REAL("ultimate", struct coeff, ultimate, .range = TS_POSITIVE, .unit = "force",
		.help = "the bond breaks for good when |F| exceeds this"),
	TS_REAL("damping", struct coeff, damping, .range = TS_NOT_NEGATIVE, .fallback = "0",
		.unit = "force/velocity", .help = "dashpot along the bond; does not count for breaking"),
	TS_ARGS_END,
};

TS_STYLE(bond, ts_bond_style, ts_bond_contact)
const struct ts_bond_style ts_bond_contact = {
	.style = { .name = "contact",
		   .kind = TS_KIND_BOND,
		   .summary = "contact bond: a breakable linear spring between two centres",
		   .doc = "F = -K U along the line of centres, U the extension from the length the bond was "
			  "made with. No shear force, no moment. The bond breaks for good when |F| > "
			  "ultimate, in tension or compression; breakages are counted (thermo keyword "
			  "brokenbonds) and listed with time and place (fix bond/breakage).\n\n"
			  "Bonded particles that overlap also feel the pair style. A single bond is stable "
			  "for steps below 2 sqrt(m*/K), with damping below 2 (sqrt(w^2 + g^2) - g)/w^2, w^2 "
			  "= K/m*, g = damping/(2 m*); the limit of a network, which is lower, is found "
			  "about its stiffest places, see doc/stability.md.",
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
	.share = share,
	.damped = damped,
	.stiffness = stiffness,
	.energy = energy,
	.limit = limit,
};
