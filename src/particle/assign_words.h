/* Keywords of the command `set` that take several words. chosen[i] != 0 selects local particle i; *count
 * returns the number of particles that were changed. */
#ifndef TS_PARTICLE_ASSIGN_WORDS_H
#define TS_PARTICLE_ASSIGN_WORDS_H

#include "core/sim.h"

/* Assigns a type to some of the chosen particles. CHANCE: to each with a probability; EXACT: to a fraction
 * of their number, rounded to the nearest integer; SUBSET: to a number of them. Random numbers are functions
 * of seed and tag, so the result depends neither on the order in memory nor on threads. */
enum ts_part { TS_PART_CHANCE, TS_PART_EXACT, TS_PART_SUBSET };
enum ts_status ts_assign_type(struct tsim *sim, enum ts_part selection, struct ts_words words,
			      const unsigned char *chosen, size_t *count);
/* Sets image flags; words: three integers, or NULL to leave a component. */
enum ts_status ts_assign_image(struct tsim *sim, struct ts_words words, const unsigned char *chosen,
			       size_t *count);
/* Sets the angular velocity; words: three numbers or variables, v_NAME. */
enum ts_status ts_assign_omega(struct tsim *sim, struct ts_words words, const unsigned char *chosen,
			       size_t *count);
/* Sets columns of fix property/atom or of another fix; words: NAME and one value, a number or v_NAME, for
 * each component, or NAME[k] and one value; any number of times. Values of i_NAME are integers. */
enum ts_status ts_assign_properties(struct tsim *sim, struct ts_words words, const unsigned char *chosen,
				    size_t *count);

/* Evaluates a number for each local particle: a constant, an equal-style or an atom-style variable. */
enum ts_status ts_assign_values(struct tsim *sim, const struct ts_number *number,
				const struct ts_place *where, struct ts_table *out);

#endif
