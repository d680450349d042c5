#include "contact/pair.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "contact/limits.h"
#include "contact/multicontact.h"
#include "contact/substep_contacts.h"
#include "core/ranks.h"
#include "core/report.h"
#include "insert/template.h"
#include "particle/columns.h"
#include "particle/prescribed.h"

#include "base/banned.h"

static size_t entry_of(const struct ts_pair *pair, int a, int b)
{
	return (size_t)(a * (pair->ntypes + 1) + b);
}

enum ts_status ts_pair_prepare(struct tsim *sim, struct ts_instance *self)
{
	const struct ts_pair_style *style = ts_pair_style_of(self);
	struct ts_pair *pair = self->state;
	size_t n = (size_t)(sim->particles->ntypes + 1);

	pair->coeffs.rows = style->style.coeff;
	pair->coeffs.size = style->coeff_size;
	pair->ntypes = sim->particles->ntypes;
	pair->law_offset = style->law_offset;
	return ts_coeffs_resize(sim, &pair->coeffs, n * n);
}

static enum ts_status limit_types(struct tsim *sim, struct ts_types *t, const struct ts_place *where)
{
	TS_TRY(ts_particles_require_types(sim, "pair_coeff", t, where));
	if (!t->hi)
		t->hi = sim->particles->ntypes;
	return TS_OK;
}

enum ts_status ts_pair_set(struct tsim *sim, struct ts_types a, struct ts_types b, struct ts_words words,
			   const struct ts_place *where)
{
	struct ts_instance *self = ts_sim_only(sim, TS_KIND_PAIR);
	struct ts_pair *pair;
	enum ts_status status;
	void *entry;

	if (!self)
		return ts_fail(&sim->error, TS_STATE, where, "pair_coeff needs a pair_style before it");
	pair = self->state;
	TS_TRY(ts_pair_prepare(sim, self));
	TS_TRY(limit_types(sim, &a, where));
	TS_TRY(limit_types(sim, &b, where));
	entry = ts_alloc(1, pair->coeffs.size ? pair->coeffs.size : 1);
	if (!entry)
		return ts_nomem(&sim->error);
	status = ts_coeff_parse(sim, "pair_coeff", &pair->coeffs, words, where, entry);
	if (status == TS_OK)
		status = ts_pair_style_of(self)->complete(sim, entry, where);
	for (int i = a.lo; status == TS_OK && i <= a.hi; i++) {
		for (int j = b.lo; j <= b.hi; j++) {
			memcpy(ts_coeff(&pair->coeffs, entry_of(pair, i, j)), entry, pair->coeffs.size);
			memcpy(ts_coeff(&pair->coeffs, entry_of(pair, j, i)), entry, pair->coeffs.size);
			pair->coeffs.given[entry_of(pair, i, j)] = true;
			pair->coeffs.given[entry_of(pair, j, i)] = true;
		}
	}
	ts_free(entry);
	return status;
}

enum ts_status ts_pair_row(struct tsim *sim, const struct ts_word *style, const struct ts_word *name,
			   const struct ts_arg **row)
{
	struct ts_instance *pair = ts_sim_only(sim, TS_KIND_PAIR);
	struct ts_suggest suggest = ts_suggest_start(name->text);

	if (!pair || !ts_streq(pair->style->name, style->text))
		return ts_fail(&sim->error, TS_STATE, &style->place, "pair style '%s' is not in use%s%s",
			       style->text, pair ? ", it is " : "", pair ? pair->style->name : "");
	TS_TRY(ts_pair_prepare(sim, pair)); /* the coefficients may not have been given yet */
	for (*row = pair->style->coeff; *row && (*row)->type != TS_ARG_END; ++*row) {
		if ((*row)->type != TS_ARG_REAL)
			continue;
		if (ts_streq((*row)->name, name->text))
			return TS_OK;
		ts_suggest_try(&suggest, (*row)->name);
	}
	return ts_fail(&sim->error, TS_UNKNOWN, &name->place, "pair style %s has no number '%s'%s",
		       style->text, name->text, ts_suggest_text(&suggest));
}

bool ts_pair_given(const struct tsim *sim, int a, int b)
{
	const struct ts_pair *pair = ts_sim_only(sim, TS_KIND_PAIR)->state;

	return pair->coeffs.n && pair->coeffs.given[entry_of(pair, a, b)];
}

static double *number_of(const struct tsim *sim, const struct ts_arg *row, int a, int b)
{
	const struct ts_pair *pair = ts_sim_only(sim, TS_KIND_PAIR)->state;

	return (double *)(void *)((char *)ts_coeff(&pair->coeffs, entry_of(pair, a, b)) + row->offset);
}

double ts_pair_number(const struct tsim *sim, const struct ts_arg *row, int a, int b)
{
	return *number_of(sim, row, a, b);
}

enum ts_status ts_pair_set_number(struct tsim *sim, const struct ts_arg *row, int a, int b, double value,
				  const struct ts_place *where)
{
	struct ts_instance *self = ts_sim_only(sim, TS_KIND_PAIR);
	const struct ts_pair *pair = self->state;
	size_t entry[2] = { entry_of(pair, a, b), entry_of(pair, b, a) };

	if (!isfinite(value) || (row->range == TS_POSITIVE && !(value > 0)) ||
	    (row->range == TS_NOT_NEGATIVE && value < 0))
		return ts_fail(&sim->error, TS_RANGE, where, "%s of types %d and %d would be %g", row->name,
			       a, b, value);
	*number_of(sim, row, a, b) = *number_of(sim, row, b, a) = value;
	for (int k = 0; k < 2; k++)
		TS_TRY(ts_pair_style_of(self)->complete(sim, ts_coeff(&pair->coeffs, entry[k]), where));
	return TS_OK;
}

/* Largest gap at which the law attracts; of liquid bridges for any amount of liquid. */
static double reach_of(const struct ts_granular_model *m, const struct ts_granular_pair *law, double radius)
{
	if (ts_cohesion_bridges(m))
		return (law->most_gap - 1) * 2 * radius;
	return ts_normal_sticks(m) ? ts_jkr_reach(law, 0.5 * radius) : 0;
}

double ts_pair_reach(const struct tsim *sim, double radius)
{
	const struct ts_instance *inst = ts_sim_only(sim, TS_KIND_PAIR);
	const struct ts_pair *pair = inst ? inst->state : NULL;
	double most = 0;

	for (int a = 1; pair && pair->sticks && a <= pair->ntypes; a++)
		for (int b = a; b <= pair->ntypes; b++)
			most = fmax(most,
				    reach_of(ts_pair_model(pair, a, b), ts_pair_law(pair, a, b), radius));
	return pair && pair->model.multi ? 2 * TS_BULGE_MOST * radius : most;
}

bool ts_pair_interact(const struct tsim *sim, size_t i, size_t j)
{
	const struct ts_instance *pair = ts_sim_only(sim, TS_KIND_PAIR);
	const struct ts_particles *p = sim->particles;

	return pair && ts_pair_model(pair->state, p->type[i], p->type[j])->normal != TS_NORMAL_OFF;
}

/* present[t] > 0: there are particles of type t on any rank, or templates of them. */
static void types_present(const struct tsim *sim, double *present)
{
	const struct ts_particles *p = sim->particles;

	for (size_t i = 0; i < p->n; i++)
		present[p->type[i]] = 1;
	for (int t = 1; t <= p->ntypes; t++)
		if (ts_template_inverse_mass(sim, t, NULL) > 0)
			present[t] = 1;
	ts_ranks_most_of(sim, present, (size_t)p->ntypes + 1);
}

static enum ts_status check_given(struct tsim *sim, struct ts_instance *self)
{
	const struct ts_pair *pair = self->state;
	double *present = ts_alloc((size_t)pair->ntypes + 1, sizeof *present);

	if (!present)
		return ts_nomem(&sim->error);
	types_present(sim, present);
	for (int a = 1; a <= pair->ntypes; a++) {
		for (int b = a; b <= pair->ntypes; b++) {
			bool mixed = pair->mixes && pair->coeffs.given[entry_of(pair, a, a)] &&
				     pair->coeffs.given[entry_of(pair, b, b)];

			if (!(present[a] > 0 && present[b] > 0) || mixed ||
			    pair->coeffs.given[entry_of(pair, a, b)])
				continue;
			ts_free(present);
			return ts_fail(&sim->error, TS_STATE, &self->where,
				       "particles of types %d and %d exist, but there is no `pair_coeff %d "
				       "%d ...`",
				       a, b, a, b);
		}
	}
	ts_free(present);
	return TS_OK;
}

enum ts_status ts_pair_init(struct ts_instance *self, struct tsim *sim)
{
	struct ts_pair *pair = self->state;
	size_t memory;

	if (!sim->particles->ntypes)
		return TS_OK;
	TS_TRY(ts_pair_prepare(sim, self));
	/* which contacts that do not overlap touch is not carried then */
	if (pair->sticks && sim->legacy == TS_LEGACY_LIGGGHTS)
		TS_TRY(ts_ranks_refuse(sim, "legacy with a law that acts beyond contact", &self->where));
	ts_granular_memory_signs(&pair->model, pair->memory_sign);
	memory = (size_t)ts_granular_memory(&pair->model);
	if (!memory && sim->full & TS_FULL_HISTORY)
		memory = 3;
	TS_TRY(ts_contact_list_set_history(sim, &sim->neigh->contacts, memory, pair->memory_sign));
	sim->neigh->contacts.bridge_column =
		ts_cohesion_bridges(&pair->model) ? (size_t)ts_granular_met_at(&pair->model) + 1 : 0;
	ts_contact_list_set_torques(&sim->neigh->contacts, ts_granular_turns(&pair->model),
				    ts_granular_rolls(&pair->model));
	if (ts_granular_turns(&pair->model))
		TS_TRY(ts_particles_need(sim, TS_NEED(OMEGA) | TS_NEED(TORQUE)));
	return check_given(sim, self);
}

enum ts_status ts_pair_archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a)
{
	struct ts_pair *pair = self->state;

	TS_TRY(ts_pair_prepare(sim, self));
	TS_TRY(ts_coeffs_archive(a, sim, &pair->coeffs));
	for (size_t k = 0; !ts_archive_writing(a) && k < pair->coeffs.n; k++)
		if (pair->coeffs.given[k])
			TS_TRY(ts_pair_style_of(self)->complete(sim, ts_coeff(&pair->coeffs, k),
								&self->where));
	return TS_OK;
}

enum ts_status ts_pair_archive_given(struct ts_instance *self, struct tsim *sim, struct ts_archive *a)
{
	struct ts_pair *pair = self->state;

	TS_TRY(ts_pair_prepare(sim, self));
	if (!ts_archive_has(a, "given")) /* missing in older files */
		return TS_OK;
	return ts_archive_fixed(a, "given", TS_SAVED_U8, pair->coeffs.given, pair->coeffs.n);
}

void ts_pair_fingerprint(const struct ts_instance *self, const struct tsim *sim, struct ts_hash *hash)
{
	const struct ts_pair *pair = self->state;

	ts_coeffs_fingerprint(&pair->coeffs, sim, hash);
}

/* Largest present overlap of each pair of types, length. */
static double *deepest_overlaps(const struct tsim *sim, const struct ts_pair *pair)
{
	size_t n = (size_t)pair->ntypes + 1;
	const struct ts_contact_list *list = &sim->neigh->contacts;
	const struct ts_particles *p = sim->particles;
	double *most = ts_alloc(n * n, sizeof *most);

	for (size_t r = 0; most && r < list->n; r++) {
		size_t i = (size_t)list->i[r], j = (size_t)list->j[r];
		double d[3], *one = &most[entry_of(pair, p->type[i], p->type[j])];
		double *other = &most[entry_of(pair, p->type[j], p->type[i])];

		ts_sub(p->x[i], p->x[j], d);
		*one = *other = fmax(*one, p->radius[i] + p->radius[j] - ts_norm(d));
	}
	if (most)
		ts_ranks_most_of(sim, most, n * n);
	return most;
}

static enum ts_status report_types(const struct ts_instance *self, struct tsim *sim,
				   const struct ts_lightest *lightest, double overlap, int a, int b,
				   double speed, struct ts_plan_report *report)
{
	const struct ts_pair *pair = self->state;
	const struct ts_lightest *one = &lightest[a], *other = &lightest[b];
	double sum = one->inverse_mass[0] + other->inverse_mass[a == b];
	double r = one->radius[0] * other->radius[a == b] / (one->radius[0] + other->radius[a == b]);
	struct ts_contact_case c = {
		ts_pair_model(pair, a, b), ts_pair_law(pair, a, b), r, 1 / sum, overlap, speed
	};
	char what[48];

	/* no such pair of particles, or both are immobile */
	if (one->inverse_mass[0] < 0 || other->inverse_mass[a == b] < 0 || !(sum > 0))
		return TS_OK;
	snprintf(what, sizeof what, "of types %d and %d", a, b);
	return ts_contact_report_limits(report, sim, &self->where, &c, what);
}

enum ts_status ts_pair_plan(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report)
{
	const struct ts_pair *pair = self->state;
	struct ts_lightest *lightest = ts_lightest(sim, 0);
	double *overlap = deepest_overlaps(sim, pair), speed = 2 * ts_prescribed_max_speed(sim, 0);
	enum ts_status status = lightest && overlap ? TS_OK : ts_nomem(&sim->error);

	if (status == TS_OK)
		status = ts_multicontact_check(sim, &pair->model, ts_instance_word(self, "multicontact"));
	if (status == TS_OK)
		status = ts_substep_check(sim, &pair->model, ts_instance_word(self, "located"));

	for (int a = 1; status == TS_OK && a <= pair->ntypes; a++)
		for (int b = a; status == TS_OK && b <= pair->ntypes; b++)
			status = report_types(self, sim, lightest, overlap[entry_of(pair, a, b)], a, b, speed,
					      report);
	ts_free(lightest);
	ts_free(overlap);
	return status;
}

void ts_pair_fini(struct ts_instance *self)
{
	struct ts_pair *pair = self->state;

	ts_coeffs_release(&pair->coeffs);
}
