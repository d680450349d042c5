/* The most frequent models, whose contact loops are compiled as a whole: TS_GRANULAR_MODELS(M) expands to
 * M(name, model) for each. All other models are computed by the staged loop (law_stages.h). Batches of pairs of these models
 * have the roots of hertz from contact_roots.h (`rooted`).
 *
 * A model belongs here if its own loop saves more than 5 % of a run. Measured in scenes of contacts alone, time of a
 * particle and step without the loop / with it: spring 1.33, hertz_history 1.21, with rolling friction 1.22,
 * hooke_stiffness 1.25, and in a dense packing 1.06 (numbers_hooke_history) to 1.16 (hertz_history); at walls 1.11 to
 * 1.18. */
#ifndef TS_CONTACT_GRANULAR_MODELS_H
#define TS_CONTACT_GRANULAR_MODELS_H

#define TS_GRANULAR_MODELS(M)                                                                                \
	M(spring, .normal = TS_NORMAL_SPRING)                                                                \
	M(hertz_history, .normal = TS_NORMAL_HERTZ, .tangential = TS_TANGENTIAL_HISTORY, .rooted = true)     \
	M(hertz_history_cdt, .normal = TS_NORMAL_HERTZ, .tangential = TS_TANGENTIAL_HISTORY,                 \
	  .rolling = TS_ROLLING_CDT, .rooted = true)                                                         \
	M(hertz_history_epsd2, .normal = TS_NORMAL_HERTZ, .tangential = TS_TANGENTIAL_HISTORY,               \
	  .rolling = TS_ROLLING_EPSD2, .rooted = true)                                                       \
	M(hooke_stiffness_history, .normal = TS_NORMAL_HOOKE_STIFFNESS, .tangential = TS_TANGENTIAL_HISTORY) \
	M(hooke_stiffness_history_undamped, .normal = TS_NORMAL_HOOKE_STIFFNESS,                             \
	  .tangential = TS_TANGENTIAL_HISTORY, .no_tangential_damping = true)                                \
	M(hooke_stiffness_history_absolute, .normal = TS_NORMAL_HOOKE_STIFFNESS,                             \
	  .tangential = TS_TANGENTIAL_HISTORY, .absolute_damping = true)                                     \
	M(numbers_hooke_history, .normal = TS_NORMAL_HOOKE_STIFFNESS, .tangential = TS_TANGENTIAL_SLIDER,    \
	  .full_arms = true)                                                                                 \
	M(numbers_hertz_history, .normal = TS_NORMAL_HERTZ_STIFFNESS, .tangential = TS_TANGENTIAL_SLIDER,    \
	  .full_arms = true, .rooted = true)

#endif
