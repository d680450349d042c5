#include "base/clones.h"
TS_UNROLLED

#include <math.h>

#include "bond/bond_force.h"
#include "bond/bond_loop.h"
#include "bond/bpm_words.h"
#include "contact/contact_energy.h"
#include "law/bpm_bond.h"
#include "law/spring_dashpot.h"

#include "base/banned.h"

struct bpm_spring {
	struct ts_bond bond;
	struct ts_bpm_words words;
};

struct coeff {
	double k, strain, damping;
	/* from the keywords of the bond style, before a run */
	bool smooth, normalize;
	double critical; /* strain, infinite if bonds do not break */
};

static enum ts_status complete(struct tsim *sim, void *coeff, const struct ts_place *where)
{
	(void)sim, (void)coeff, (void)where;
	return TS_OK;
}

static void apply_words(struct bpm_spring *s)
{
	for (size_t t = 1; t < s->bond.coeffs.n; t++) {
		struct coeff *c = ts_coeff(&s->bond.coeffs, t);

		c->smooth = s->words.smooth;
		c->normalize = s->words.normalize;
		c->critical = s->words.breaks && !s->words.unbreakable ? c->strain : INFINITY;
	}
}

TS_INLINE double stiffness_of(const struct coeff *c, double rest)
{
	return c->normalize ? c->k / rest : c->k;
}

static bool bpm_spring_tension(const void *coeff, const struct ts_bond_state *state, double *tension)
{
	const struct coeff c = *(const struct coeff *)coeff;
	double strain = state->rest > 0 ? state->extension / state->rest : 0;
	double w = 1 - ts_bpm_eighth(strain, c.critical, c.smooth);
	double spring = state->rest > 0 ? stiffness_of(&c, state->rest) * state->extension * w : 0;
	bool holds = !(fabs(strain) > c.critical);

	*tension = holds ? spring + c.damping * w * state->rate : spring;
	return holds;
}

TS_CLONES static long compute(void *task, size_t from, size_t to)
{
	return ts_bond_compute_slices(task, from, to, bpm_spring_tension);
}

static bool damped(const void *coeff)
{
	return ((const struct coeff *)coeff)->damping > 0;
}

/* The largest, without strain. */
static double stiffness(const void *coeff, double rest)
{
	return stiffness_of(coeff, rest);
}

static double spring(const void *coeff, double extension, double rest)
{
	const struct coeff *c = coeff;

	return stiffness_of(c, rest) * extension *
	       (1 - ts_bpm_eighth(extension / rest, c->critical, c->smooth));
}

static double energy(const void *coeff, double extension, double rest)
{
	const struct coeff *c = coeff;

	return 0.5 * stiffness_of(c, rest) * extension * extension *
	       (1 - ts_bpm_eighth(extension / rest, c->critical, c->smooth) / 5);
}

static double limit(const void *coeff, double rest, double mass, bool explicit_euler)
{
	const struct coeff *c = coeff;
	const struct ts_granular_pair same = { .kn = stiffness_of(c, rest), .gamman = c->damping };

	return ts_spring_dashpot_limit(&same, mass, explicit_euler);
}

static enum ts_status chosen(struct ts_instance *self, struct tsim *sim)
{
	return ts_bpm_chosen(self, sim, &((struct bpm_spring *)self->state)->words);
}

static enum ts_status allow(struct ts_instance *self, struct tsim *sim)
{
	return ts_bpm_allow(self, sim, &((struct bpm_spring *)self->state)->words);
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct bpm_spring *s = self->state;

	if (s->words.volume)
		return ts_fail(&sim->error, TS_STATE, ts_instance_word(self, "volume/factor"),
			       "bond_style bpm/spring: volume/factor yes is not supported");
	TS_TRY(ts_bpm_check(self, sim, &s->words));
	apply_words(s);
	return ts_bond_init(self, sim);
}

static const struct ts_arg args[] = {
	TS_BPM_ARGS(struct bpm_spring, words),
	TS_BOOL("volume/factor", struct bpm_spring, words.volume, .fallback = "no", .help = "only no"),
	TS_ARGS_END,
};

static const struct ts_arg coeff_rows[] = {
	TS_REAL("k", struct coeff, k, .flags = TS_POSITIONAL, .range = TS_POSITIVE, .unit = "force/length",
		.help = "stiffness; with normalize yes: force"),
	TS_REAL("epsilon_c", struct coeff, strain, .flags = TS_POSITIONAL, .range = TS_POSITIVE, .unit = "",
		.help = "critical strain: the bond breaks at a larger one, in tension or compression"),
	TS_REAL("gamma", struct coeff, damping, .flags = TS_POSITIONAL, .range = TS_NOT_NEGATIVE,
		.unit = "force/velocity", .help = "damping"),
	TS_ARGS_END,
};

static const char *const more[] = { TS_BPM_DOC
				    "\n\nCompared with the documentation of LAMMPS, and by its example "
				    "examples/bpm/impact/in.bpm.impact.spring with the published log "
				    "(doc/bonds.md). Not supported: volume/factor yes.",
				    NULL };

TS_STYLE(bond, ts_bond_style, ts_bond_bpm_spring)
const struct ts_bond_style ts_bond_bpm_spring = {
	.style = { .name = "bpm/spring",
		   .kind = TS_KIND_BOND,
		   .ranks = TS_RANKS_OWN,
		   .summary = "breakable central spring of LAMMPS' package BPM",
		   .doc = "The bond force acts along the line of centres, > 0 attractive:\n\n"
			  "  F = k (r - r0) w + gamma w dr/dt,   w = 1 - (epsilon/epsilon_c)^8\n\n"
			  "with the rest length r0, the strain epsilon = (r - r0)/r0, and w = 1 with `smooth "
			  "no`. The bond breaks when |epsilon| > epsilon_c. The elastic energy is the "
			  "integral of the force, k (r - r0)^2/2 (1 - (epsilon/epsilon_c)^8/5), so that the "
			  "energy ledger closes; LAMMPS prints k (r - r0)^2/2.",
		   .doc_more = more,
		   .example = "special_bonds lj 0 1 1 coul 1 1 1\n"
			      "bond_style bpm/spring store/local broken 1000 time id1 id2\n"
			      "bond_coeff 1 1.0 0.05 0.1",
		   .cite = "J. T. Clemmer, J. M. Monti, J. B. Lechman, Soft Matter 20 (2024) 1702; J. T. "
			   "Clemmer, M. O. Robbins, Phys. Rev. Lett. 129 (2022) 078002",
		   .args = args,
		   .coeff = coeff_rows,
		   .state_size = sizeof(struct bpm_spring),
		   .archive = ts_bond_archive,
		   .fingerprint = ts_bond_fingerprint,
		   .init = init,
		   .hook = { [TS_STAGE_FORCE] = ts_bond_force },
		   .energy = ts_contact_energy_of_bonds,
		   .plan = ts_bond_plan,
		   .fini = ts_bond_fini },
	.allow = allow,
	.coeff_size = sizeof(struct coeff),
	.chosen = chosen,
	.complete = complete,
	.compute = compute,
	.damped = damped,
	.stiffness = stiffness,
	.spring = spring,
	.energy = energy,
	.limit = limit,
};
