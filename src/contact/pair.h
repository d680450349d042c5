/* Pair styles: who meets whom with which contact law. */
#ifndef TS_CONTACT_PAIR_H
#define TS_CONTACT_PAIR_H

#include "contact/liquid.h"
#include "core/coeff.h"
#include "law/granular_force.h"
#include "neigh/neigh.h"
#include "particle/particles.h"

struct ts_pair_style {
	struct ts_style style;
	size_t coeff_size; /* bytes that the rows style.coeff fill, the arguments of pair_coeff */
	/* Checks an entry and derives constants; the words have been parsed. */
	enum ts_status (*complete)(struct tsim *sim, void *coeff, const struct ts_place *where);
	/* Where in an entry the constants of the law are. */
	size_t law_offset;
	/* makes what scripts may name from now on; or NULL */
	enum ts_status (*chosen)(struct ts_instance *self, struct tsim *sim);
};

/* First member of every pair style's state. */
struct ts_pair {
	struct ts_coeffs coeffs; /* entry of types a, b: a * (ntypes + 1) + b, types from 1 */
	int ntypes;
	size_t law_offset;		/* in an entry */
	size_t model_offset;		/* where each entry has a model of its own; 0: all have this one */
	bool sticks;			/* some surfaces act beyond their touch */
	struct ts_liquid liquid;	/* where there are bridges of it */
	bool mixes;			/* entries that are not given are made of those that are */
	struct ts_granular_model model; /* the law: used by rows, walls, outputs and tests */
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

/* How far beyond their touch the surfaces of particles of this radius, or smaller ones, may still pull. */
double ts_pair_reach(const struct tsim *sim, double radius);
/* Whether there is a pair style and its law of the types of particles i and j acts. */
bool ts_pair_interact(const struct tsim *sim, size_t i, size_t j);

/* What pair_coeff does. */
enum ts_status ts_pair_set(struct tsim *sim, struct ts_types a, struct ts_types b, struct ts_words words,
			   const struct ts_place *where);
/* One number of the coefficients, changed while a run goes on. The row of the live pair style with this
 * name; then its value for two types, read and written. */
enum ts_status ts_pair_row(struct tsim *sim, const struct ts_word *style, const struct ts_word *name,
			   const struct ts_arg **row);
double ts_pair_number(const struct tsim *sim, const struct ts_arg *row, int a, int b);
enum ts_status ts_pair_set_number(struct tsim *sim, const struct ts_arg *row, int a, int b, double value,
				  const struct ts_place *where);
/* Makes room for the coefficients of all types. */
enum ts_status ts_pair_prepare(struct tsim *sim, struct ts_instance *self);
/* Shared by all pair styles: slots of struct ts_style. */
enum ts_status ts_pair_init(struct ts_instance *self, struct tsim *sim);
enum ts_status ts_pair_archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a);
/* For styles whose coefficients stand elsewhere: only for which types pair_coeff was given. */
enum ts_status ts_pair_archive_given(struct ts_instance *self, struct tsim *sim, struct ts_archive *a);
void ts_pair_fingerprint(const struct ts_instance *self, const struct tsim *sim, struct ts_hash *hash);
enum ts_status ts_pair_plan(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report);
void ts_pair_fini(struct ts_instance *self);

#endif
