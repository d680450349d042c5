/* The loops of wall/wall_batch.h, compiled for the most frequent models. */
#include "base/clones.h"
TS_UNROLLED

#include "contact/granular_models.h"
#include "contact/law_stages.h"
#include "wall/wall_batch.h"
#include "wall/wall_stages.h"

#include "base/banned.h"

#define LOOP(name, ...)                                                                               \
	static const struct ts_granular_model name = { __VA_ARGS__ };                                 \
	TS_CLONES static void name##_contacts(struct ts_wall_batch *restrict b, size_t n,             \
					      const struct ts_granular_model *m,                      \
					      const struct ts_granular_pair *restrict law, double dt) \
	{                                                                                             \
		(void)m;                                                                              \
		ts_wall_batch_contacts(b, n, &name, law, dt);                                         \
	}
TS_GRANULAR_MODELS(LOOP)

ts_wall_batch_fn *ts_wall_batch_of(const struct ts_granular_model *model)
{
	static const struct {
		const struct ts_granular_model *model;
		ts_wall_batch_fn *contacts;
	} fast[] = {
#define ENTRY(name, ...) { &name, name##_contacts },
		TS_GRANULAR_MODELS(ENTRY)
	};

	for (size_t k = 0; k < sizeof fast / sizeof *fast; k++)
		if (ts_granular_same_model(model, fast[k].model))
			return fast[k].contacts;
	return ts_stages_for(model) ? ts_wall_staged : NULL;
}
