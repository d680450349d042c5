/* What the command set gives to chosen particles besides plain numbers. `chosen` has a flag for each
 * local particle; *count says how many were changed. */
#ifndef TS_PARTICLE_ASSIGN_WORDS_H
#define TS_PARTICLE_ASSIGN_WORDS_H

#include "core/sim.h"

/* A type for a part of the particles. By chance each gets it with this probability; exact: that part of
 * their number, to the nearest integer; subset: so many. Chosen by random numbers keyed by seed and
 * identity, so neither order nor threads matter. */
enum ts_part { TS_PART_CHANCE, TS_PART_EXACT, TS_PART_SUBSET };
enum ts_status ts_assign_type(struct tsim *sim, enum ts_part part, struct ts_words words,
			      const unsigned char *chosen, size_t *count);
/* Image flags: three integers or NULL. */
enum ts_status ts_assign_image(struct tsim *sim, struct ts_words words, const unsigned char *chosen,
			       size_t *count);
/* NAME VALUES ...: columns that fix property/atom or another fix keeps, as many numbers or v_names as each
 * is wide; NAME[k] VALUE: one of them. Those of i_NAME are integers. */
enum ts_status ts_assign_properties(struct tsim *sim, struct ts_words words, const unsigned char *chosen,
				    size_t *count);

/* A number for each particle: a constant, or a variable of either kind. */
enum ts_status ts_assign_values(struct tsim *sim, const struct ts_number *number,
				const struct ts_place *where, struct ts_table *out);

#endif
