#include "insert/distribution.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/sort.h"
#include "insert/memory_check.h"
#include "particle/particles.h"

#include "base/banned.h"

const struct ts_arg ts_distribution_args[] = {
	TS_INT("seed", struct ts_distribution, seed, .flags = TS_POSITIONAL, .range = TS_POSITIVE,
	       .help = TS_SEED_HELP),
	TS_INT("n", struct ts_distribution, n, .flags = TS_POSITIONAL, .range = TS_WITHIN, .lo = 1, .hi = 1e6,
	       .help = "number of templates"),
	TS_REST("pairs", struct ts_distribution, pairs,
		.help = "ID weight, n times: a fix particletemplate/... and its weight"),
	TS_ARGS_END,
};

enum ts_status ts_distribution_archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *archive)
{
	struct ts_distribution *d = self->state;

	return ts_template_archive_stream(archive, sim, "random", &d->random);
}

static const struct ts_template *template_of(const struct ts_distribution *d, int64_t k)
{
	return d->template[k] -> state;
}

static enum ts_status read_pair(struct ts_instance *self, struct tsim *sim, int64_t k)
{
	struct ts_distribution *d = self->state;
	const struct ts_word *id = &d->pairs.word[2 * k], *weight = id + 1;

	TS_TRY(ts_template_require(sim, id, &d->template[k]));
	d->serial[k] = d->template[k] -> serial;
	for (int64_t j = 0; j < k; j++)
		if (d->template[j] == d->template[k])
			return ts_fail(&sim->error, TS_STATE, &id->place,
				       "fix %s: the template '%s' is named twice, add up the weights",
				       self->style->name, id->text);
	if (!ts_parse_real(weight->text, &d->share[k]) || !(d->share[k] >= 0))
		return ts_fail(&sim->error, TS_RANGE, &weight->place,
			       "fix %s: the weight of '%s' is '%s', expected a number >= 0",
			       self->style->name, id->text, weight->text);
	return TS_OK;
}

static void print_composition(const struct ts_instance *self, struct tsim *sim, bool by_mass)
{
	const struct ts_distribution *d = self->state;

	ts_log(&sim->log, "Fix %s (id %s): distribution based on %s%%:\n", self->style->name, self->id,
	       by_mass ? "mass" : "number");
	for (int64_t k = 0; k < d->n; k++) {
		const struct ts_template *t = template_of(d, k);
		double share = by_mass ? d->share[k] * t->mass / d->mass : d->share[k];

		ts_log(&sim->log, "    %s: d=%e (max. bounding sphere) %s%%=%f%%\n", d->template[k] -> id,
		       2 * t -> largest, by_mass ? "mass" : "number", 100 * share);
	}
}

static void update_means(struct ts_distribution *d)
{
	double sum = 0;

	for (int64_t k = 0; k < d->n; k++)
		sum += d->share[k];
	d->volume = d->mass = d->largest = 0;
	d->least = INFINITY;
	d->largest_type = 0;
	for (int64_t k = 0; k < d->n; k++) {
		const struct ts_template *t = template_of(d, k);

		d->share[k] /= sum;
		d->volume += d->share[k] * t->volume;
		d->mass += d->share[k] * t->mass;
		d->least = fmin(d->least, t->least);
		d->largest = fmax(d->largest, t->largest);
		if (t->type > d->largest_type)
			d->largest_type = (int)t->type;
	}
}

static enum ts_status make_distribution(struct ts_instance *self, struct tsim *sim)
{
	struct ts_distribution *d = self->state;

	if (d->pairs.n != 2 * (size_t)d->n)
		return ts_fail(&sim->error, TS_SYNTAX, &self->where,
			       "fix %s: expected %lld pairs of a template and its weight, found %zu words",
			       self->style->name, (long long)d->n, d->pairs.n);
	TS_TRY(ts_template_check_seed(sim, self->style->name, d->seed,
				      ts_instance_word(self, self->words.word[0].text)));
	d->random = ts_minstd_start(d->seed);
	d->template = ts_arena_alloc(&self->arena, (size_t)d->n, sizeof *d->template);
	d->serial = ts_arena_alloc(&self->arena, (size_t)d->n, sizeof *d->serial);
	d->share = ts_arena_alloc(&self->arena, (size_t)d->n, sizeof *d->share);
	return d->template && d->serial && d->share ? TS_OK : ts_nomem(&sim->error);
}

static enum ts_status read_pairs(struct ts_instance *self, struct tsim *sim, bool by_mass)
{
	struct ts_distribution *d = self->state;
	double sum = 0;

	for (int64_t k = 0; k < d->n; k++) {
		TS_TRY(read_pair(self, sim, k));
		sum += d->share[k];
	}
	if (!(sum > 0))
		return ts_fail(&sim->error, TS_RANGE, &d->pairs.word[1].place, "fix %s: all weights are 0",
			       self->style->name);
	if (fabs(sum - 1) > 1e-5)
		ts_warn(&sim->log, &d->pairs.word[1].place,
			"fix %s: the weights add up to %g, they are taken as shares of that",
			self->style->name, sum);
	for (int64_t k = 0; by_mass && k < d->n; k++)
		d->share[k] /= sum * template_of(d, k)->mass;
	update_means(d);
	if (by_mass)
		print_composition(self, sim, true);
	print_composition(self, sim, false);
	return TS_OK;
}

enum ts_status ts_distribution_init(struct ts_instance *self, struct tsim *sim, bool by_mass)
{
	struct ts_distribution *d = self->state;
	struct ts_instance *template;
	bool changed = !d->template;

	if (!d->template)
		TS_TRY(make_distribution(self, sim));
	for (int64_t k = 0; k < d->n && !changed; k++) { /* the script may have redefined them */
		TS_TRY(ts_template_require(sim, &d->pairs.word[2 * k], &template));
		changed = template->serial != d->serial[k];
	}
	return changed ? read_pairs(self, sim, by_mass) : TS_OK;
}

bool ts_distribution_holds(const struct ts_instance *self, const struct ts_new_particle *one)
{
	const struct ts_distribution *d = self->state;
	bool found = false;

	for (int64_t k = 0; k < d->n; k++)
		found |= d->serial[k] == one->serial;
	return found;
}

enum ts_status ts_distribution_require(struct tsim *sim, const struct ts_word *id, struct ts_instance **out)
{
	static const char prefix[] = "particledistribution/";

	TS_TRY(ts_sim_require(sim, TS_KIND_FIX, id, out));
	if (strncmp((*out)->style->name, prefix, sizeof prefix - 1) == 0)
		return TS_OK;
	return ts_fail(&sim->error, TS_STATE, &id->place,
		       "fix %s is of style %s, expected a fix particledistribution/discrete", id->text,
		       (*out)->style->name);
}

/* ---- drawing particles */

/* Rounds n * share down to count[]; the rest is given to templates drawn in proportion to their
 * remainders. */
static void round_counts(struct ts_distribution *d, int64_t n, int64_t *count)
{
	int64_t gap = n;

	for (int64_t k = 0; k < d->n; k++) {
		count[k] = (int64_t)((double)n * d->share[k]);
		gap -= count[k];
	}
	for (int64_t left = gap; left > 0; left--) {
		double r = ts_minstd_uniform(&d->random) * (double)gap, sum = 0;
		int64_t k = -1;

		do {
			double wanted = (double)n * d->share[++k];

			sum += wanted - floor(wanted);
		} while (sum < r && k < d->n - 1);
		count[k]++;
	}
}

static struct ts_new_particle particle_of(const struct ts_instance *self, struct ts_instance *template)
{
	return (struct ts_new_particle){
		.template = template,
		.serial = template->serial,
		.mask = 1u << self->group | 1u << template->group,
		.type = (int32_t)((struct ts_template *)template->state)->type,
	};
}

static enum ts_status append_particle(struct tsim *sim, const struct ts_instance *self,
				      struct ts_instance *template, struct ts_new_particles *out)
{
	struct ts_template *t = template->state;
	struct ts_new_particle *one;

	if (TS_GROW(out->item, out->capacity, out->n + 1) != TS_OK)
		return ts_nomem(&sim->error);
	one = &out->item[out->n++];
	*one = particle_of(self, template);
	one->radius = ts_spread_draw(&t->radius, &t->random);
	one->density = ts_spread_draw(&t->density, &t->random);
	return TS_OK;
}

struct sort_key {
	double size;
	size_t k;
};

static int compare_sizes(const void *a, const void *b)
{
	const struct sort_key *s = a, *t = b;

	if (s->size < t->size || s->size > t->size)
		return s->size > t->size ? -1 : 1;
	return (s->k > t->k) - (s->k < t->k);
}

/* Sorts by decreasing radius, since large particles are more difficult to place; the sort is stable. */
static enum ts_status sort_by_size(struct tsim *sim, struct ts_new_particles *list)
{
	struct sort_key *rank = ts_alloc(list->n + 1, sizeof *rank);
	struct ts_new_particle *sorted = ts_alloc(list->n + 1, sizeof *sorted);

	if (rank && sorted) {
		for (size_t k = 0; k < list->n; k++)
			rank[k] = (struct sort_key){ list->item[k].radius, k };
		ts_sort(rank, list->n, sizeof *rank, compare_sizes);
		for (size_t k = 0; k < list->n; k++)
			sorted[k] = list->item[rank[k].k];
		if (list->n)
			memcpy(list->item, sorted, list->n * sizeof *sorted);
	}
	ts_free(sorted);
	ts_free(rank);
	return rank && sorted ? TS_OK : ts_nomem(&sim->error);
}

/* Of clumps at least; the list is sorted into a copy. */
static enum ts_status check_memory(struct tsim *sim, const struct ts_instance *user, int64_t n)
{
	char who[100];
	double bytes;

	snprintf(who, sizeof who, "fix %s", user->style->name);
	return ts_memory_check(sim, who, (double)n,
			       2 * sizeof(struct ts_new_particle) + sizeof(struct sort_key), &user->where,
			       &bytes);
}

enum ts_status ts_distribution_draw(struct ts_instance *self, struct tsim *sim,
				    const struct ts_instance *user, int64_t n, bool exact,
				    struct ts_new_particles *out)
{
	struct ts_distribution *d = self->state;
	int64_t *count = ts_alloc((size_t)d->n, sizeof *count);
	enum ts_status status = count ? check_memory(sim, user, n) : ts_nomem(&sim->error);

	out->n = 0;
	if (status == TS_OK && exact)
		round_counts(d, n, count);
	for (int64_t k = 0; status == TS_OK && !exact && k < d->n; k++)
		count[k] = (int64_t)((double)n * d->share[k] + ts_minstd_uniform(&d->random));
	for (int64_t k = 0; k < d->n; k++)
		for (int64_t j = 0; status == TS_OK && j < count[k]; j++)
			status = append_particle(sim, self, d->template[k], out);
	ts_free(count);
	return status == TS_OK ? sort_by_size(sim, out) : status;
}

enum ts_status ts_distribution_archive_particle(struct ts_instance *self, struct tsim *sim,
						struct ts_archive *archive, const char *name,
						struct ts_new_particle *one, bool *some)
{
	const struct ts_distribution *d = self->state;
	double number[3] = { -1, one->radius, one->density }; /* index of the template, or -1 */

	for (int64_t k = 0; *some && k < d->n; k++)
		if (d->serial[k] == one->serial)
			number[0] = (double)k;
	TS_TRY(ts_archive_fixed(archive, name, TS_SAVED_F64, number, 3));
	if (ts_archive_writing(archive))
		return TS_OK;
	*some = number[0] >= 0;
	if (!*some)
		return TS_OK;
	if (!(number[0] < (double)d->n && number[1] > 0 && number[2] > 0))
		return ts_fail(&sim->error, TS_DAMAGED, NULL, "the particle drawn last is damaged");
	*one = particle_of(self, d->template[(size_t)number[0]]);
	one->radius = number[1];
	one->density = number[2];
	return TS_OK;
}
