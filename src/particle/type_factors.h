/* The keyword `scale TYPE FACTOR`, repeated: a factor for each particle type. */
#ifndef TS_PARTICLE_TYPE_FACTORS_H
#define TS_PARTICLE_TYPE_FACTORS_H

#include "core/sim.h"

/* Reads the factors: (*out)[type], 1 if not given. Memory is from the arena; `what` begins messages. */
enum ts_status ts_type_factors(struct tsim *sim, const char *what, struct ts_arena *arena,
			       struct ts_words words, double **out);

#define TS_TYPE_FACTORS(T, field, what)                                                                \
	TS_SOME_KEYWORD("scale", T, field, TS_REPEAT,                                                  \
			.help = "TYPE FACTOR: " what " is multiplied by FACTOR for particles of this " \
				"type; may be repeated")

#endif
