#include "base/clones.h"
TS_UNROLLED

#include "contact/contact_batch.h"
#include "contact/contact_models.h"
#include "contact/contact_stages.h"
#include "contact/granular_models.h"
#include "contact/law_stages.h"

#include "base/banned.h"

#define LOOP(name, ...)                                                                               \
	static const struct ts_granular_model name = { __VA_ARGS__ };                                 \
	TS_CLONES static void name##_contacts(struct ts_batch *restrict b, size_t n,                  \
					      const struct ts_granular_model *m,                      \
					      const struct ts_granular_pair *restrict law, double dt) \
	{                                                                                             \
		(void)m;                                                                              \
		ts_batch_contacts(b, n, &name, law, dt);                                              \
	}                                                                                             \
	TS_CLONES static void name##_share(void *task, size_t from, size_t to)                        \
	{                                                                                             \
		ts_contact_share_batched(task, from, to, &name, name##_contacts);                     \
	}
TS_GRANULAR_MODELS(LOOP)

/* The loop compiled for this whole model, or NULL. */
static ts_range_fn *share_of_whole_model(const struct ts_granular_model *m)
{
	static const struct {
		const struct ts_granular_model *model;
		ts_range_fn *share;
	} fast[] = {
#define ENTRY(name, ...) { &name, name##_share },
		TS_GRANULAR_MODELS(ENTRY)
	};

	for (size_t k = 0; k < sizeof fast / sizeof *fast; k++)
		if (ts_granular_same_model(m, fast[k].model))
			return fast[k].share;
	return NULL;
}

/* Whether all models of the pair style, one for each pair of types, have stages. */
static bool all_models_staged(const struct ts_pair *pair)
{
	bool all = ts_stages_for(&pair->model);

	/* otherwise all types have the same model */
	for (int a = 1; pair->model.wide && a <= pair->ntypes; a++)
		for (int b = a; b <= pair->ntypes; b++) {
			const struct ts_granular_model *m = ts_pair_model(pair, a, b);

			all &= !m->normal || ts_stages_for(m); /* normal off: no pair_coeff for these types */
		}
	return all;
}

ts_range_fn *ts_contact_share_of(const struct ts_pair *pair, bool generic)
{
	ts_range_fn *own = pair->sticks ? NULL : share_of_whole_model(&pair->model);

	if (own && !generic)
		return own;
	if (generic || !all_models_staged(pair))
		return ts_contact_share_generic;
	return pair->model.located ? ts_contact_share_located : ts_contact_share_staged;
}
