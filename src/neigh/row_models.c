#include "base/clones.h"
TS_UNROLLED

#include "neigh/row_batch.h"
#include "neigh/row_models.h"

#include "base/banned.h"

/* M(name, model): a line is a loop. */
#define MODELS(M)                                                                                  \
	M(spring, .normal = TS_NORMAL_SPRING)                                                      \
	M(spring_located, .normal = TS_NORMAL_SPRING, .located = true)                             \
	M(hertz, .normal = TS_NORMAL_HERTZ)                                                        \
	M(hooke_stiffness, .normal = TS_NORMAL_HOOKE_STIFFNESS)                                    \
	M(hooke_stiffness_absolute, .normal = TS_NORMAL_HOOKE_STIFFNESS, .absolute_damping = true) \
	M(hertz_located, .normal = TS_NORMAL_HERTZ, .located = true)                               \
	M(hertz_history_located, .normal = TS_NORMAL_HERTZ, .tangential = TS_TANGENTIAL_HISTORY,   \
	  .located = true)                                                                         \
	M(hooke_stiffness_history, .normal = TS_NORMAL_HOOKE_STIFFNESS,                            \
	  .tangential = TS_TANGENTIAL_HISTORY)                                                     \
	M(hooke_stiffness_history_undamped, .normal = TS_NORMAL_HOOKE_STIFFNESS,                   \
	  .tangential = TS_TANGENTIAL_HISTORY, .no_tangential_damping = true)                      \
	M(hooke_stiffness_history_absolute, .normal = TS_NORMAL_HOOKE_STIFFNESS,                   \
	  .tangential = TS_TANGENTIAL_HISTORY, .absolute_damping = true)                           \
	M(hertz_history, .normal = TS_NORMAL_HERTZ, .tangential = TS_TANGENTIAL_HISTORY)           \
	M(hertz_history_cdt, .normal = TS_NORMAL_HERTZ, .tangential = TS_TANGENTIAL_HISTORY,       \
	  .rolling = TS_ROLLING_CDT)                                                               \
	M(hertz_history_epsd2, .normal = TS_NORMAL_HERTZ, .tangential = TS_TANGENTIAL_HISTORY,     \
	  .rolling = TS_ROLLING_EPSD2)                                                             \
	M(hertz_history_sjkr, .normal = TS_NORMAL_HERTZ, .tangential = TS_TANGENTIAL_HISTORY,      \
	  .cohesion = TS_COHESION_SJKR)                                                            \
	M(hooke_history, .normal = TS_NORMAL_HOOKE, .tangential = TS_TANGENTIAL_HISTORY,           \
	  .stiffness_known = true)                                                                 \
	M(hooke_history_cdt, .normal = TS_NORMAL_HOOKE, .tangential = TS_TANGENTIAL_HISTORY,       \
	  .rolling = TS_ROLLING_CDT, .stiffness_known = true)                                      \
	M(numbers_hooke, .normal = TS_NORMAL_HOOKE_STIFFNESS,                                      \
	  .tangential = TS_TANGENTIAL_NO_HISTORY, .full_arms = true)                               \
	M(numbers_hooke_history, .normal = TS_NORMAL_HOOKE_STIFFNESS,                              \
	  .tangential = TS_TANGENTIAL_SLIDER, .full_arms = true)                                   \
	M(numbers_hertz_history, .normal = TS_NORMAL_HERTZ_STIFFNESS,                              \
	  .tangential = TS_TANGENTIAL_SLIDER, .full_arms = true)

#define LOOP(name, ...)                                                                            \
	static const struct ts_granular_model name = { __VA_ARGS__ };                              \
	TS_CLONES static void name##_contacts(struct ts_batch *restrict b, size_t n,               \
					      const struct ts_granular_pair *restrict law, double dt)  \
	{                                                                                          \
		ts_batch_contacts(b, n, &name, law, dt);                                           \
	}                                                                                          \
	TS_CLONES static void name##_share(void *task, size_t from, size_t to)                     \
	{                                                                                          \
		ts_row_share_batched(task, from, to, &name, name##_contacts);                      \
	}
MODELS(LOOP)

ts_share_fn *ts_row_share_of(const struct ts_granular_model *m, bool generic)
{
	static const struct {
		const struct ts_granular_model *model;
		ts_share_fn *share;
	} fast[] = {
#define ENTRY(name, ...) { &name, name##_share },
		MODELS(ENTRY)
	};

	for (size_t k = 0; k < sizeof fast / sizeof *fast && !generic; k++)
		if (ts_granular_same_model(m, fast[k].model))
			return fast[k].share;
	return ts_row_share_generic;
}
