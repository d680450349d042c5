/* The models that most scenes have: loops over contacts are compiled for each of them, TS_GRANULAR_MODELS(M) writes
 * M(name, model) for each. */
#ifndef TS_NEIGH_GRANULAR_MODELS_H
#define TS_NEIGH_GRANULAR_MODELS_H

#define TS_GRANULAR_MODELS(M)                                                                      \
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
	M(hertz_no_history, .normal = TS_NORMAL_HERTZ, .tangential = TS_TANGENTIAL_NO_HISTORY)     \
	M(hertz_history_cdt, .normal = TS_NORMAL_HERTZ, .tangential = TS_TANGENTIAL_HISTORY,       \
	  .rolling = TS_ROLLING_CDT)                                                               \
	M(hertz_history_epsd2, .normal = TS_NORMAL_HERTZ, .tangential = TS_TANGENTIAL_HISTORY,     \
	  .rolling = TS_ROLLING_EPSD2)                                                             \
	M(hertz_history_sjkr, .normal = TS_NORMAL_HERTZ, .tangential = TS_TANGENTIAL_HISTORY,      \
	  .cohesion = TS_COHESION_SJKR)                                                            \
	M(hooke_history, .normal = TS_NORMAL_HOOKE, .tangential = TS_TANGENTIAL_HISTORY,           \
	  .stiffness_known = true)                                                                 \
	M(hooke_no_history, .normal = TS_NORMAL_HOOKE, .tangential = TS_TANGENTIAL_NO_HISTORY,     \
	  .stiffness_known = true)                                                                 \
	M(hooke_history_cdt, .normal = TS_NORMAL_HOOKE, .tangential = TS_TANGENTIAL_HISTORY,       \
	  .rolling = TS_ROLLING_CDT, .stiffness_known = true)                                      \
	M(numbers_hooke, .normal = TS_NORMAL_HOOKE_STIFFNESS,                                      \
	  .tangential = TS_TANGENTIAL_NO_HISTORY, .full_arms = true)                               \
	M(numbers_hooke_history, .normal = TS_NORMAL_HOOKE_STIFFNESS,                              \
	  .tangential = TS_TANGENTIAL_SLIDER, .full_arms = true)                                   \
	M(numbers_hertz_history, .normal = TS_NORMAL_HERTZ_STIFFNESS,                              \
	  .tangential = TS_TANGENTIAL_SLIDER, .full_arms = true)

#endif
