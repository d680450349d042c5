/* Pair styles: contact laws by pairs of particle types. */
#ifndef TS_CONTACT_PAIR_H
#define TS_CONTACT_PAIR_H

#include "contact/liquid.h"
#include "core/coeff.h"
#include "law/granular_force.h"
#include "neigh/neigh.h"
#include "particle/particles.h"

struct ts_pair_style {
	struct ts_style style;
	size_t coeff_size; /* bytes of an entry, which the arguments of pair_coeff (style.coeff) fill */
	/* Checks an entry and derives constants, after its words have been parsed. */
	enum ts_status (*complete)(struct tsim *sim, void *coeff, const struct ts_place *where);
	/* Offset of the constants of the law in an entry. */
	size_t law_offset;
	/* called when the style is chosen: makes what scripts may name from then on; or NULL */
	enum ts_status (*chosen)(struct ts_instance *self, struct tsim *sim);
};

/* First member of every pair style's state. */
struct ts_pair {
	struct ts_coeffs coeffs; /* by pair of types: entry of a, b at a * (ntypes + 1) + b, types from 1 */
	int ntypes;
	size_t law_offset; /* offset of the constants of the law in an entry */
	/* offset of the model in an entry, if each has its own; 0: all have `model` */
	size_t model_offset;
	bool sticks;			/* some laws attract beyond the touch */
	struct ts_liquid liquid;	/* columns of the liquid, for laws with liquid bridges */
	bool mixes;			/* entries that are not given are mixed from those that are */
	struct ts_granular_model model; /* the model: used by the contact loop, walls, outputs and tests */
	signed char memory_sign[TS_GRANULAR_MEMORY + 1];
};

static inline const struct ts_pair_style *ts_pair_style_of(const struct ts_instance *inst)
{
	return (const struct ts_pair_style *)inst->style;
}

static inline const struct ts_granular_pair *ts_pair_law(const struct ts_pair *pair, int a, int b)
{
	const char *entry = ts_coeff(&pair->coeffs, (size_t)(a * (pair->ntypes + 1) + b));

	return (const struct ts_granular_pair *)(entry + pair->law_offset);
}

static inline const struct ts_granular_model *ts_pair_model(const struct ts_pair *pair, int a, int b)
{
	const char *entry = ts_coeff(&pair->coeffs, (size_t)(a * (pair->ntypes + 1) + b));

	if (!pair->model_offset)
		return &pair->model;
	return (const struct ts_granular_model *)(entry + pair->model_offset);
}

/* Largest gap, length, at which the surfaces of particles of this radius or smaller still attract each other.
 */
double ts_pair_reach(const struct tsim *sim, double radius);
/* Whether there is a pair style with a contact law for the types of particles i and j. */
bool ts_pair_interact(const struct tsim *sim, size_t i, size_t j);

/* Sets the coefficients of all pairs of types a and b: command pair_coeff. */
enum ts_status ts_pair_set(struct tsim *sim, struct ts_types a, struct ts_types b, struct ts_words words,
			   const struct ts_place *where);
/* A single coefficient, changed during a run. ts_pair_row finds the argument with this name of the live pair
 * style; the others read and set its value for two types. */
enum ts_status ts_pair_row(struct tsim *sim, const struct ts_word *style, const struct ts_word *name,
			   const struct ts_arg **row);
bool ts_pair_given(const struct tsim *sim, int a, int b); /* whether pair_coeff has given the coefficients */
double ts_pair_number(const struct tsim *sim, const struct ts_arg *row, int a, int b);
enum ts_status ts_pair_set_number(struct tsim *sim, const struct ts_arg *row, int a, int b, double value,
				  const struct ts_place *where);
/* Allocates the coefficients of all pairs of types. */
enum ts_status ts_pair_prepare(struct tsim *sim, struct ts_instance *self);
/* Common to all pair styles: slots of struct ts_style. */
enum ts_status ts_pair_init(struct ts_instance *self, struct tsim *sim);
enum ts_status ts_pair_archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a);
/* For styles whose coefficients are given elsewhere: saves only for which types pair_coeff was given. */
enum ts_status ts_pair_archive_given(struct ts_instance *self, struct tsim *sim, struct ts_archive *a);
void ts_pair_fingerprint(const struct ts_instance *self, const struct tsim *sim, struct ts_hash *hash);
enum ts_status ts_pair_plan(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report);
void ts_pair_fini(struct ts_instance *self);

#endif
