#include "insert/template.h"

#include <math.h>
#include <string.h>

#include "core/ranks.h"
#include "particle/particles.h"
#include "particle/sphere_shape.h"

#include "base/banned.h"

/* Range of math/minstd.h: each seed is a state in its one cycle. */
static const int64_t SEED_LIMIT = 2147483646;
static const int64_t LEAST_LIGGGHTS = 10000; /* LIGGGHTS accepts only primes above this number */

/* The stream starts at the seed itself: this gives the numbers of LIGGGHTS 3.8 for seeds that it accepts, and
 * those of older editions, which accepted all, for others. */
enum ts_status ts_template_check_seed(struct tsim *sim, const char *what, int64_t seed,
				      const struct ts_place *where)
{
	if (seed > SEED_LIMIT)
		return ts_fail(&sim->error, TS_RANGE, where, "%s: the seed is %lld, expected 1 to %lld", what,
			       (long long)seed, (long long)SEED_LIMIT);
	if (sim->legacy == TS_LEGACY_LIGGGHTS && !(seed > LEAST_LIGGGHTS && ts_minstd_is_prime(seed)))
		ts_warn(&sim->log, where,
			"%s: LIGGGHTS 3.8 refuses the seed %lld: it takes primes above %lld only", what,
			(long long)seed, (long long)LEAST_LIGGGHTS);
	return TS_OK;
}

enum ts_status ts_template_archive_stream(struct ts_archive *archive, struct tsim *sim, const char *name,
					  struct ts_minstd *random)
{
	double number[3] = { random->state, random->has_spare, random->spare };

	TS_TRY(ts_archive_fixed(archive, name, TS_SAVED_F64, number, 3));
	if (!(number[0] >= 1 && number[0] <= SEED_LIMIT) || !isfinite(number[2]))
		return ts_fail(&sim->error, TS_DAMAGED, NULL,
			       "the state of a stream of random numbers is damaged");
	random->state = (int32_t)number[0];
	random->has_spare = number[1] != 0;
	random->spare = number[2];
	return TS_OK;
}

enum ts_status ts_template_archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *archive)
{
	return ts_template_archive_stream(archive, sim, "random",
					  &((struct ts_template *)self->state)->random);
}

/* ---- distributions of a quantity: constant, uniform ... */

struct spread_words {
	int shape;
	struct ts_words words;
};

static const struct ts_arg given_rows[] = {
	TS_REST("numbers", struct spread_words, words, .help = "[number|mass] a [b]"),
	TS_ARGS_END,
};

static const struct ts_mode shapes[] = {
	[TS_SPREAD_CONSTANT] = { "constant", "the same for all particles", given_rows },
	[TS_SPREAD_UNIFORM] = { "uniform", "uniform between two values", given_rows },
	[TS_SPREAD_NORMAL] = { "gaussian", "normal distribution", given_rows },
	[TS_SPREAD_LOGNORMAL] = { "lognormal", "lognormal distribution", given_rows },
	{ .name = NULL },
};

static const struct ts_arg shape_rows[] = {
	TS_MODE("shape", struct spread_words, shape, shapes, .help = "distribution"),
	TS_ARGS_END,
};

static enum ts_status check_spread(struct tsim *sim, const char *what, const struct ts_spread *s,
				   const struct ts_place *where)
{
	if (s->shape == TS_SPREAD_UNIFORM && !(s->a < s->b))
		return ts_fail(&sim->error, TS_RANGE, where,
			       "%s: uniform from %g to %g, expected an ascending range", what, s->a, s->b);
	if (s->shape >= TS_SPREAD_NORMAL && s->b < 0)
		return ts_fail(&sim->error, TS_RANGE, where,
			       "%s: the deviation is %g, expected a number >= 0", what, s->b);
	if (ts_spread_smallest(s) > 0)
		return TS_OK;
	if (s->shape == TS_SPREAD_NORMAL)
		return ts_fail(&sim->error, TS_RANGE, where,
			       "%s: three deviations below the mean are %g, expected a number > 0; take a "
			       "smaller deviation, or lognormal",
			       what, ts_spread_smallest(s));
	return ts_fail(&sim->error, TS_RANGE, where, "%s: found %g, expected a number > 0", what, s->a);
}

enum ts_status ts_template_spread(struct ts_instance *self, struct tsim *sim, const char *what,
				  struct ts_words words, struct ts_spread *out)
{
	struct spread_words given = { 0 };
	const struct ts_place *where = words.n ? &words.word[0].place : &self->where;
	size_t first = 0, numbers;
	double value[2] = { 0 };

	TS_TRY(ts_args_parse(sim, what, shape_rows, words, where, &self->arena, &given));
	*out = (struct ts_spread){ .shape = given.shape };
	if (given.shape != TS_SPREAD_CONSTANT && given.words.n &&
	    (ts_streq(given.words.word[0].text, "number") || ts_streq(given.words.word[0].text, "mass"))) {
		out->by_mass = ts_streq(given.words.word[0].text, "mass");
		first = 1;
	}
	numbers = given.shape == TS_SPREAD_CONSTANT ? 1 : 2;
	if (given.words.n != first + numbers)
		return ts_fail(&sim->error, TS_SYNTAX, where, "%s: expected %zu number%s after %s, found %zu",
			       what, numbers, numbers > 1 ? "s" : "", shapes[given.shape].name,
			       given.words.n - first);
	for (size_t k = 0; k < numbers; k++)
		if (!ts_parse_real(given.words.word[first + k].text, &value[k]))
			return ts_fail(&sim->error, TS_SYNTAX, &given.words.word[first + k].place,
				       "%s: '%s' is not a number", what, given.words.word[first + k].text);
	out->a = value[0];
	out->b = value[1];
	return check_spread(sim, what, out, where);
}

/* ---- common to all templates */

enum ts_status ts_template_start(struct ts_instance *self, struct tsim *sim)
{
	struct ts_template *t = self->state;
	char what[80];

	if (t->type > sim->particles->ntypes)
		return ts_fail(&sim->error, TS_RANGE, ts_instance_word(self, "atom_type"),
			       "fix %s: there is no type %lld, types go from 1 to %d", self->style->name,
			       (long long)t->type, sim->particles->ntypes);
	snprintf(what, sizeof what, "fix %s", self->style->name);
	TS_TRY(ts_template_check_seed(sim, what, t->seed, ts_instance_word(self, self->words.word[0].text)));
	t->random = ts_minstd_start(t->seed);
	snprintf(what, sizeof what, "fix %s: density", self->style->name);
	return ts_template_spread(self, sim, what, t->density_words, &t->density);
}

enum ts_status ts_template_check_volume(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_template *t = self->state;

	if (t->volume >= t->volume_limit)
		return TS_OK;
	return ts_fail(&sim->error, TS_RANGE, &self->where,
		       "fix %s: the particles have a mean volume of %g, below volume_limit %g; if lengths "
		       "are right, say `volume_limit %.2g`",
		       self->style->name, t->volume, t->volume_limit, 0.5 * t->volume);
}

static bool begins(const struct ts_instance *fix, const char *prefix)
{
	return strncmp(fix->style->name, prefix, strlen(prefix)) == 0;
}

static bool is_template(const struct ts_instance *fix)
{
	return begins(fix, "particletemplate/");
}

enum ts_status ts_template_require(struct tsim *sim, const struct ts_word *id, struct ts_instance **out)
{
	TS_TRY(ts_sim_require(sim, TS_KIND_FIX, id, out));
	if (is_template(*out))
		return TS_OK;
	return ts_fail(&sim->error, TS_STATE, &id->place,
		       "fix %s is of style %s, expected a particle template (fix particletemplate/...)",
		       id->text, (*out)->style->name);
}

/* Type, smallest radius and mass of what the fix can insert; false if it inserts nothing of its own. */
static bool insertable_kind(const struct ts_instance *fix, struct ts_prospect *out)
{
	const struct ts_template *t = fix->state;

	if (is_template(fix))
		*out = (struct ts_prospect){ t->type, t->least, t->lightest };
	else if (fix->style->family && ts_streq(fix->style->family, TS_FAMILY_PROSPECT))
		*out = *(const struct ts_prospect *)fix->state;
	else
		return false;
	return true;
}

int ts_template_max_type(const struct tsim *sim)
{
	const struct ts_instances *fixes = &sim->instances[TS_KIND_FIX];
	const struct ts_particles *p = sim->particles;
	int most = 0;

	for (size_t i = 0; i < p->n; i++)
		most = p->type[i] > most ? p->type[i] : most;
	for (size_t k = 0; k < fixes->n; k++) {
		const struct ts_instance *fix = fixes->item[k];
		const int given = fix->style->gives_type ? fix->style->gives_type(fix, sim) : 0;
		struct ts_prospect one;

		most = given > most ? given : most;
		if (insertable_kind(fix, &one) && one.type > most)
			most = (int)one.type;
	}
	return (int)ts_ranks_most(sim, most);
}

uint32_t ts_template_groups(const struct tsim *sim)
{
	const struct ts_instances *fixes = &sim->instances[TS_KIND_FIX];
	uint32_t groups = 0;

	for (size_t k = 0; k < fixes->n; k++) {
		const struct ts_instance *fix = fixes->item[k];
		struct ts_prospect one;

		if (insertable_kind(fix, &one) || begins(fix, "particledistribution/") ||
		    begins(fix, "insert/"))
			groups |= (uint32_t)1 << fix->group;
	}
	return groups;
}

bool ts_template_of_spheres(const struct tsim *sim)
{
	const struct ts_instances *fixes = &sim->instances[TS_KIND_FIX];
	struct ts_prospect one;
	bool any = false;

	for (size_t k = 0; k < fixes->n; k++)
		any |= insertable_kind(fixes->item[k], &one) &&
		       !ts_streq(fixes->item[k]->style->name, "particletemplate/multisphere");
	return any;
}

double ts_template_inverse_mass(const struct tsim *sim, int type, double *radius)
{
	const struct ts_instances *fixes = &sim->instances[TS_KIND_FIX];
	double most = -1;

	for (size_t k = 0; k < fixes->n; k++) {
		struct ts_prospect one;

		if (!insertable_kind(fixes->item[k], &one) || one.type != type || !(1 / one.lightest > most))
			continue;
		most = 1 / one.lightest;
		if (radius)
			*radius = one.least;
	}
	return most;
}
