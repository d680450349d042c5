/* Pair styles: who meets whom with which contact law. */
#ifndef TS_NEIGH_PAIR_H
#define TS_NEIGH_PAIR_H

#include "core/coeff.h"
#include "law/contact.h"
#include "neigh/neigh.h"
#include "particles/particles.h"

struct ts_pair_style {
	struct ts_style style;
	size_t coeff_size; /* bytes that the rows style.coeff fill, the arguments of pair_coeff */
	/* Checks an entry and derives constants; the words have been parsed. */
	enum ts_status (*complete)(struct tsim *sim, void *coeff, const struct ts_place *where);
	/* The law, for one contact: used by walls, outputs and tests. */
	ts_contact_law *law;
	/* Largest stable step of a contact of this effective mass. */
	double (*limit)(const void *coeff, double mass, bool explicit_euler);
	size_t history_width;
	const signed char *history_sign;
};

/* First member of every pair style's state. */
struct ts_pair {
	struct ts_coeffs coeffs; /* entry of types a, b: a * (ntypes + 1) + b, types from 1 */
	int ntypes;
};

static inline const struct ts_pair_style *ts_pair_style_of(const struct ts_instance *inst)
{
	return (const struct ts_pair_style *)inst->style;
}

static inline const void *ts_pair_coeff(const struct ts_pair *pair, int a, int b)
{
	return ts_coeff(&pair->coeffs, (size_t)(a * (pair->ntypes + 1) + b));
}

/* What pair_coeff does. */
enum ts_status ts_pair_set(struct tsim *sim, struct ts_types a, struct ts_types b,
			   struct ts_words words, const struct ts_place *where);
/* One number of the coefficients, changed while a run goes on. The row of the live pair style with this
 * name; then its value for two types, read and written. */
enum ts_status ts_pair_row(struct tsim *sim, const struct ts_word *style, const struct ts_word *name,
			   const struct ts_arg **row);
double ts_pair_number(const struct tsim *sim, const struct ts_arg *row, int a, int b);
enum ts_status ts_pair_set_number(struct tsim *sim, const struct ts_arg *row, int a, int b,
				  double value, const struct ts_place *where);
/* Shared by all pair styles: slots of struct ts_style. */
enum ts_status ts_pair_init(struct ts_instance *self, struct tsim *sim);
enum ts_status ts_pair_archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a);
void ts_pair_fingerprint(const struct ts_instance *self, const struct tsim *sim,
			 struct ts_hash *hash);
enum ts_status ts_pair_plan(struct ts_instance *self, struct tsim *sim,
			    struct ts_plan_report *report);
void ts_pair_fini(struct ts_instance *self);

#endif
