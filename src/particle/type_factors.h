/* Factors by type of particle: `scale TYPE FACTOR`, any number of times. */
#ifndef TS_PARTICLE_TYPE_FACTORS_H
#define TS_PARTICLE_TYPE_FACTORS_H

#include "core/sim.h"

/* One for each type, from index 1 on; 1 where none is given. Memory comes from the arena. */
enum ts_status ts_type_factors(struct tsim *sim, const char *what, struct ts_arena *arena,
			       struct ts_words words, double **out);

#define TS_TYPE_FACTORS(T, field, what)                                                                 \
	TS_SOME_KEYWORD("scale", T, field, TS_REPEAT,                                                   \
			.help = "TYPE FACTOR: " what " is that many times larger for particles of the " \
				"type; may be given again")

#endif
