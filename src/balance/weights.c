#include "balance/weights.h"

#include <math.h>
#include <stdio.h>

#include "core/group.h"
#include "core/number_or_peratom.h"
#include "core/ranks.h"
#include "core/script_api.h"
#include "neigh/neigh.h"
#include "particle/particles.h"
#include "rank/blocks.h"

#include "base/banned.h"

struct weighing {
	struct ts_weights *weights;
	const struct ts_rank_blocks *blocks;
	double *weight; /* by local particle: the product so far */
};

struct ts_weight_style {
	const char *name;
	/* Reads the words after the name, from word *k on, and moves *k behind them. */
	enum ts_status (*parse)(struct ts_weight *item, struct tsim *sim, const char *what,
				struct ts_words words, size_t *k);
	enum ts_status (*check)(const struct ts_weight *item, struct tsim *sim);
	enum ts_status (*apply)(const struct ts_weight *item, struct tsim *sim, struct weighing *w);
};

/* ---- words */

static enum ts_status fail_word(struct tsim *sim, const char *what, struct ts_words words, size_t k,
				const char *expected)
{
	const struct ts_word *word = &words.word[k < words.n ? k : words.n - 1];

	if (k < words.n)
		return ts_fail(&sim->error, TS_SYNTAX, &word->place, "%s: found '%s', expected %s", what,
			       word->text, expected);
	return ts_fail(&sim->error, TS_SYNTAX, &word->place, "%s: expected %s after '%s'", what, expected,
		       word->text);
}

static enum ts_status read_factor(double *out, struct tsim *sim, const char *what, struct ts_words words,
				  size_t *k)
{
	if (*k >= words.n || !ts_parse_real(words.word[*k].text, out) || !(*out > 0) || !isfinite(*out))
		return fail_word(sim, what, words, *k, "a factor > 0");
	++*k;
	return TS_OK;
}

static enum ts_status parse_factor(struct ts_weight *item, struct tsim *sim, const char *what,
				   struct ts_words words, size_t *k)
{
	return read_factor(item->value, sim, what, words, k);
}

static enum ts_status parse_groups(struct ts_weight *item, struct tsim *sim, const char *what,
				   struct ts_words words, size_t *k)
{
	int64_t n;

	if (*k >= words.n || !ts_parse_int(words.word[*k].text, &n) || n < 1 || n > TS_MOST_WEIGHT_GROUPS)
		return fail_word(sim, what, words, *k, "the number of groups, 1 to 32");
	++*k;
	for (item->groups = 0; item->groups < n; item->groups++) {
		if (*k >= words.n)
			return fail_word(sim, what, words, *k, "a group");
		TS_TRY(ts_group_require(sim, &words.word[*k], &item->group[item->groups]));
		++*k;
		TS_TRY(read_factor(&item->value[item->groups], sim, what, words, k));
	}
	return TS_OK;
}

static enum ts_status parse_name(struct ts_weight *item, struct tsim *sim, const char *what,
				 struct ts_words words, size_t *k)
{
	if (*k >= words.n)
		return fail_word(sim, what, words, *k, "a name");
	item->name = words.word[*k].text;
	item->word = &words.word[(*k)++];
	return TS_OK;
}

/* ---- factors */

static enum ts_status apply_groups(const struct ts_weight *item, struct tsim *sim, struct weighing *w)
{
	const struct ts_particles *p = sim->particles;

	for (int g = 0; g < item->groups; g++)
		for (size_t i = 0; i < p->n; i++)
			w->weight[i] *= ts_in_group(p, i, item->group[g]) ? item->value[g] : 1;
	return TS_OK;
}

/* Stretches factors between their least and their largest, so that the ratio of these becomes `stretch` times as large, but
 * not less than 1, and multiplies the weights with them. */
static void multiply_stretched(struct tsim *sim, const double *factor, double stretch, double *weight)
{
	const size_t n = sim->particles->n;
	double most[2] = { -INFINITY, -INFINITY }, slope, least;

	for (size_t i = 0; i < n; i++) {
		most[0] = fmax(most[0], factor[i]);
		most[1] = fmax(most[1], -factor[i]);
	}
	ts_ranks_most_of(sim, most, 2);
	least = -most[1];
	slope = most[0] > least ? fmax(0, (stretch * most[0] - least) / (most[0] - least)) : 1;
	for (size_t i = 0; i < n; i++)
		weight[i] *= least + slope * (factor[i] - least);
}

/* The particle itself, and each pair. */
static enum ts_status apply_neighbors(const struct ts_weight *item, struct tsim *sim, struct weighing *w)
{
	const struct ts_contact_list *list = &sim->neigh->contacts;
	const size_t n = sim->particles->n;
	double *factor;

	if (ts_ranks_most(sim, list->particles != n || !list->gather.first) > 0) {
		if (!sim->run.inside)
			ts_warn(&sim->log, &item->word->place,
				"weight neigh has no effect: there is no neighbor list of the present "
				"particles; `run 0` makes one");
		return TS_OK;
	}
	factor = ts_alloc(n, sizeof *factor);
	if (!factor)
		return ts_nomem(&sim->error);
	for (size_t i = 0; i < n; i++)
		factor[i] = 1 + (double)(list->gather.first[i + 1] - list->gather.first[i]);
	multiply_stretched(sim, factor, item->value[0], w->weight);
	ts_free(factor);
	return TS_OK;
}

/* Time by rank, and how many particles had it. While all ranks have all particles each counts those of its block. */
static void share_times(struct tsim *sim, const struct weighing *w, const int32_t *owner, int64_t *number)
{
	const size_t ranks = (size_t)sim->world->n;
	const bool divided = sim->division;

	number[sim->world->rank] = (int64_t)(sim->run.force_ticks - w->weights->counted);
	for (size_t i = 0; i < sim->particles->n; i++)
		number[ranks + (size_t)owner[i]] += divided || owner[i] == sim->world->rank;
	ts_world_sums(sim->world, number, 2 * ranks);
}

static void apply_shared_times(const struct ts_weight *item, struct tsim *sim, struct weighing *w,
			       const int32_t *owner, const int64_t *number, double *factor)
{
	const size_t ranks = (size_t)sim->world->n;
	double time = 0, particles = 0;

	for (size_t r = 0; r < ranks; r++) {
		time += (double)number[r];
		particles += (double)number[ranks + r];
		if (number[ranks + r] && number[r] <= 0) {
			if (!sim->run.inside)
				ts_warn(&sim->log, &item->word->place,
					"weight time has no effect: no run has measured times");
			return;
		}
	}
	for (size_t i = 0; i < sim->particles->n; i++) /* 1 in the mean of all particles */
		factor[i] = (double)number[owner[i]] / (double)number[ranks + (size_t)owner[i]] * particles /
			    time;
	multiply_stretched(sim, factor, item->value[0], w->weight);
}

static enum ts_status apply_times(const struct ts_weight *item, struct tsim *sim, struct weighing *w)
{
	const size_t n = sim->particles->n;
	int32_t *owner;
	int64_t *number;
	double *factor;
	enum ts_status status = TS_NOMEM;

	if (!sim->world)
		return TS_OK;
	owner = ts_alloc(n, sizeof *owner);
	number = ts_alloc(2 * (size_t)sim->world->n, sizeof *number);
	factor = ts_alloc(n, sizeof *factor);
	if (owner && number && factor) {
		for (size_t i = 0; i < n; i++)
			owner[i] = sim->division ? sim->world->rank
						 : ts_rank_blocks_owner(w->blocks, sim->particles->x[i]);
		share_times(sim, w, owner, number);
		apply_shared_times(item, sim, w, owner, number, factor);
		status = TS_OK;
	}
	ts_free(factor);
	ts_free(number);
	ts_free(owner);
	w->weights->counted = sim->run.force_ticks;
	return status == TS_OK ? TS_OK : ts_nomem(&sim->error);
}

static enum ts_status multiply_variable(const struct ts_weight *item, struct tsim *sim, double *product)
{
	struct ts_number_or_peratom values = { 0 };
	const struct ts_number number = { .variable = item->name };
	enum ts_status status = ts_number_or_peratom_now(sim, &number, &item->word->place, &values);

	for (size_t i = 0; status == TS_OK && i < sim->particles->n; i++)
		product[i] *= ts_number_or_peratom_of(&values, i);
	ts_number_or_peratom_release(&values);
	return status;
}

/* The first variable stands for all of them: their product is in the column. */
static bool is_first_variable(const struct ts_weights *weights, const struct ts_weight *item)
{
	for (const struct ts_weight *w = weights->item; w < item; w++)
		if (w->style == item->style)
			return false;
	return true;
}

static enum ts_status apply_variable(const struct ts_weight *item, struct tsim *sim, struct weighing *w)
{
	const struct ts_weights *weights = w->weights;
	const double *kept = weights->column ? sim->particles->column[weights->column].data : NULL;

	if (!kept)
		return multiply_variable(item, sim, w->weight);
	for (size_t i = 0; is_first_variable(weights, item) && i < sim->particles->n; i++)
		w->weight[i] *= kept[i];
	return TS_OK;
}

static enum ts_status check_variable(const struct ts_weight *item, struct tsim *sim)
{
	char name[300];
	struct ts_ref ref;

	snprintf(name, sizeof name, "v_%s", item->name);
	TS_TRY(ts_ref_resolve(sim, name, &item->word->place, &ref));
	return ts_ref_check(sim, &ref, &item->word->place);
}

/* ---- property that keeps the weights */

/* As LAMMPS names it, without d_; or a scalar of LIGGGHTS. */
static double *find_property(const struct ts_weight *item, const struct tsim *sim)
{
	const struct ts_particles *p = sim->particles;
	char name[300];

	snprintf(name, sizeof name, "d_%s", item->name);
	for (size_t k = TS_NCOLUMN_BUILTIN; k < p->ncolumns; k++) {
		const struct ts_column *c = &p->column[k];

		if ((ts_streq(c->name, name) || ts_streq(c->name, item->name)) && c->width == 1 &&
		    c->element == sizeof(double))
			return c->data;
	}
	return NULL;
}

static enum ts_status check_property(const struct ts_weight *item, struct tsim *sim)
{
	if (find_property(item, sim))
		return TS_OK;
	return ts_fail(&sim->error, TS_UNKNOWN, &item->word->place,
		       "weight store: there is no property d_%s of particles with one number; `fix ID all "
		       "property/atom d_%s` defines it",
		       item->name, item->name);
}

static enum ts_status store(const struct ts_weight *item, struct tsim *sim, struct weighing *w)
{
	double *property = find_property(item, sim);

	TS_TRY(check_property(item, sim));
	for (size_t i = 0; i < sim->particles->n; i++)
		property[i] = w->weight[i];
	return TS_OK;
}

/* ---- all */

static const struct ts_weight_style styles[] = {
	{ "group", parse_groups, NULL, apply_groups },	{ "neigh", parse_factor, NULL, apply_neighbors },
	{ "time", parse_factor, NULL, apply_times },	{ "var", parse_name, check_variable, apply_variable },
	{ "store", parse_name, check_property, store },
};

static const struct ts_weight_style *find_style(const char *name)
{
	for (size_t k = 0; k < sizeof styles / sizeof *styles; k++)
		if (ts_streq(styles[k].name, name))
			return &styles[k];
	return NULL;
}

enum ts_status ts_weights_parse(struct ts_weights *weights, struct tsim *sim, const char *what,
				struct ts_words words)
{
	for (size_t k = 0; k < words.n;) {
		const struct ts_weight_style *style = find_style(words.word[k].text);

		if (!style)
			return fail_word(sim, what, words, k, "group, neigh, time, var or store");
		if (TS_GROW(weights->item, weights->capacity, weights->n + 1) != TS_OK)
			return ts_nomem(&sim->error);
		weights->item[weights->n] = (struct ts_weight){ .style = style, .word = &words.word[k++] };
		TS_TRY(style->parse(&weights->item[weights->n], sim, what, words, &k));
		weights->n++;
	}
	return TS_OK;
}

enum ts_status ts_weights_check(const struct ts_weights *weights, struct tsim *sim)
{
	for (size_t k = 0; k < weights->n; k++)
		if (weights->item[k].style->check)
			TS_TRY(weights->item[k].style->check(&weights->item[k], sim));
	return TS_OK;
}

void ts_weights_release(struct ts_weights *weights)
{
	ts_free(weights->item);
	*weights = (struct ts_weights){ 0 };
}

bool ts_weights_have_variables(const struct ts_weights *weights)
{
	for (size_t k = 0; k < weights->n; k++)
		if (weights->item[k].style->apply == apply_variable)
			return true;
	return false;
}

enum ts_status ts_weights_evaluate(const struct ts_weights *weights, struct tsim *sim, double *product)
{
	for (size_t i = 0; i < sim->particles->n; i++)
		product[i] = 1;
	for (size_t k = 0; k < weights->n; k++)
		if (weights->item[k].style->apply == apply_variable)
			TS_TRY(multiply_variable(&weights->item[k], sim, product));
	return TS_OK;
}

enum ts_status ts_weights_find(struct ts_weights *weights, struct tsim *sim,
			       const struct ts_rank_blocks *blocks, double *weight)
{
	const struct ts_particles *p = sim->particles;
	struct weighing w = { weights, blocks, weight };

	for (size_t i = 0; i < p->n; i++)
		weight[i] = 1;
	for (size_t k = 0; k < weights->n; k++) {
		const struct ts_weight *item = &weights->item[k];

		TS_TRY(item->style->apply(item, sim, &w));
		for (size_t i = 0; i < p->n; i++)
			if (!(weight[i] > 0) || !isfinite(weight[i]))
				return ts_fail(&sim->error, TS_RANGE, &item->word->place,
					       "weight %s: the weight of particle %d is %g, expected a "
					       "number > 0",
					       item->style->name, p->tag[i], weight[i]);
	}
	return TS_OK;
}
