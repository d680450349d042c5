/* Pair style granular: the contact laws of LAMMPS' style of this name, by pairs of types. */
#include "contact/contact_energy.h"
#include "contact/contact_loop.h"
#include "contact/contact_models.h"
#include "contact/gran_coeff.h"
#include "contact/pair.h"

#include "base/banned.h"

struct granular {
	struct ts_pair pair;
	double cutoff;
};

static struct ts_gran_coeff *entry_of(const struct ts_pair *pair, int a, int b)
{
	return ts_coeff(&pair->coeffs, (size_t)(a * (pair->ntypes + 1) + b));
}

static bool is_given(const struct ts_pair *pair, int a, int b)
{
	return pair->coeffs.given[a * (pair->ntypes + 1) + b];
}

/* Mixes the law of two types without a pair_coeff of their own. */
static enum ts_status mix_types(struct ts_instance *self, struct tsim *sim, int a, int b)
{
	struct ts_pair *pair = self->state;
	const struct ts_gran_coeff *one = entry_of(pair, a, a), *other = entry_of(pair, b, b);

	if (is_given(pair, a, b) || !is_given(pair, a, a) || !is_given(pair, b, b))
		return TS_OK;
	if (!ts_gran_coeff_alike(one, other))
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "types %d and %d have different laws, which cannot be mixed: give `pair_coeff "
			       "%d %d ...`",
			       a, b, a, b);
	ts_gran_coeff_mix(one, other, entry_of(pair, a, b));
	ts_gran_coeff_mix(one, other, entry_of(pair, b, a));
	return TS_OK;
}

/* Chooses the common model; where types have different laws, the history of each contact has room for the
 * largest (`wide`). */
static void choose_common_model(struct ts_pair *pair)
{
	const struct ts_gran_coeff *first = NULL;
	bool differ = false;

	pair->sticks = false;
	for (int a = 1; a <= pair->ntypes; a++)
		for (int b = a; b <= pair->ntypes; b++) {
			const struct ts_gran_coeff *c = entry_of(pair, a, b);

			if (!c->model.normal)
				continue;
			differ |= first && !ts_gran_coeff_alike(first, c);
			pair->sticks |= ts_normal_sticks(&c->model);
			first = first ? first : c;
		}
	if (first)
		pair->model = first->model;
	pair->model.wide = differ;
	for (int a = 1; a <= pair->ntypes; a++)
		for (int b = 1; b <= pair->ntypes; b++)
			entry_of(pair, a, b)->model.wide = differ;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct ts_pair *pair = self->state;

	pair->mixes = true;
	pair->model_offset = offsetof(struct ts_gran_coeff, model);
	pair->model = (struct ts_granular_model){ .tangential = TS_TANGENTIAL_LINEAR };
	if (!sim->particles->ntypes)
		return TS_OK;
	TS_TRY(ts_pair_prepare(sim, self));
	for (int a = 1; a <= pair->ntypes; a++)
		for (int b = a + 1; b <= pair->ntypes; b++)
			TS_TRY(mix_types(self, sim, a, b));
	choose_common_model(pair);
	return ts_pair_init(self, sim);
}

static enum ts_status force(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_pair *pair = self->state;

	return ts_contact_loop(sim, pair, ts_contact_share_of(pair, false));
}

static const struct ts_arg args[] = {
	TS_REAL("cutoff", struct granular, cutoff, .flags = TS_POSITIONAL | TS_OPTIONAL, .unit = "length",
		.help = "no effect: contacts are defined by the radii"),
	TS_ARGS_END,
};

TS_STYLE(pair, ts_pair_style, ts_pair_granular)
const struct ts_pair_style ts_pair_granular = {
	.style = { .name = "granular",
		   .kind = TS_KIND_PAIR,
		   .ranks = TS_RANKS_OWN | TS_RANKS_ROWLESS,
		   .summary = "contact laws of granular materials, given by pair_coeff, in LAMMPS' syntax",
		   .doc = TS_GRAN_COEFF_DOC
		   "\n\n"
		   "Each pair of types has its own laws. Where `pair_coeff I J` is missing, the coefficients "
		   "of I I and J J are mixed, if their laws are the same: by geometric means, but E* = 1/((1 "
		   "- nu_I^2)/E_I + (1 - nu_J^2)/E_J). The tangential velocity is computed with the radii as "
		   "lever arms, torques with the distances to the contact point, as in LAMMPS, with whose "
		   "results (29 Sep 2021) it agrees to round-off except for two errors there: its limit of "
		   "friction is undefined with dmt, and mixed types lose their laws.\n\n"
		   "An oblique impact never gains energy, except for hooke with mindlin or mindlin_rescale: "
		   "at its beginning, where a is small, the dashpot leaves a long spring, whose energy grows "
		   "with a.",
		   .cite = "S. Luding, Granul. Matter 10 (2008) 235; J. S. Marshall, J. Comput. Phys. 228 "
			   "(2009) 1541; C. Thornton, S. J. Cummins, P. W. Cleary, Powder Technol. 233 "
			   "(2013) 30",
		   .example = "pair_style granular\n"
			      "pair_coeff * * hertz/material 1e7 0.7 0.3 tangential mindlin NULL 1.0 0.5 "
			      "damping tsuji\n"
			      "pair_coeff 2 2 jkr 1e7 50.0 0.3 0.01 tangential mindlin_rescale NULL 1.0 0.5 "
			      "rolling sds 1e3 1.0 0.1 twisting marshall",
		   .args = args,
		   .coeff = ts_gran_coeff_rows,
		   .state_size = sizeof(struct granular),
		   .archive = ts_pair_archive,
		   .fingerprint = ts_pair_fingerprint,
		   .init = init,
		   .hook = { [TS_STAGE_FORCE] = force },
		   .energy = ts_contact_energy_of_pairs,
		   .plan = ts_pair_plan,
		   .fini = ts_pair_fini },
	.coeff_size = sizeof(struct ts_gran_coeff),
	.complete = ts_gran_coeff_complete,
};
