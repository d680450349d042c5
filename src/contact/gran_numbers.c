#include "contact/gran_numbers.h"

#include "contact/contact_loop.h"
#include "contact/contact_models.h"

#include "base/banned.h"

struct ts_granular_model ts_gran_numbers_model(int normal, int tangential,
					       const struct ts_gran_numbers *numbers)
{
	return (struct ts_granular_model){ .normal = normal,
					   .tangential = tangential,
					   .no_tension = numbers->limit_damping,
					   .full_arms = true };
}

enum ts_status ts_gran_numbers_law(struct tsim *sim, const struct ts_gran_numbers *numbers,
				   const struct ts_place *where, struct ts_granular_pair *out)
{
	*out = (struct ts_granular_pair){ .kn = numbers->kn,
					  .kt = 2.0 / 7 * numbers->kn,
					  .gamman = numbers->gamman,
					  .gammat = 0.5 * numbers->gamman,
					  .friction = numbers->xmu };
	if (!numbers->kt.null)
		TS_TRY(ts_number_now(sim, &numbers->kt, where, &out->kt));
	if (!numbers->gammat.null)
		TS_TRY(ts_number_now(sim, &numbers->gammat, where, &out->gammat));
	if (out->kt < 0 || out->gammat < 0)
		return ts_fail(&sim->error, TS_RANGE, where, "kt and gamma_t must be >= 0, found %g and %g",
			       out->kt, out->gammat);
	if (!numbers->damping)
		out->gammat = 0;
	return TS_OK;
}

enum ts_status ts_gran_numbers_init(struct ts_instance *self, struct tsim *sim, int normal, int tangential)
{
	struct ts_gran_numbers_pair *g = self->state;
	struct ts_granular_pair law;

	g->pair.model = ts_gran_numbers_model(normal, tangential, &g->numbers);
	TS_TRY(ts_gran_numbers_law(sim, &g->numbers, &self->where, &law));
	if (!sim->particles->ntypes)
		return TS_OK;
	TS_TRY(ts_pair_prepare(sim, self));
	for (size_t k = 0; k < g->pair.coeffs.n; k++)
		*(struct ts_granular_pair *)ts_coeff(&g->pair.coeffs, k) = law;
	return ts_pair_init(self, sim);
}

enum ts_status ts_gran_numbers_force(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_gran_numbers_pair *g = self->state;

	return ts_contact_loop(sim, &g->pair, ts_contact_share_of(&g->pair, g->generic));
}

enum ts_status ts_gran_numbers_complete(struct tsim *sim, void *coeff, const struct ts_place *where)
{
	(void)sim, (void)coeff, (void)where;
	return TS_OK;
}

const struct ts_arg ts_gran_numbers_args[] = {
	TS_GRAN_NUMBERS_ARGS(struct ts_gran_numbers_pair, numbers),
	TS_FLAG("generic", struct ts_gran_numbers_pair, generic,
		.help = "uses the contact loop for any model, for comparison with the specialised one"),
	TS_ARGS_END,
};

const struct ts_arg ts_gran_numbers_coeff[] = { TS_ARGS_END };
