/* Arguments and schedule of the fixes that insert particles. */
#include "insert/insertion.h"

#include "math/constants.h"
#include "math/quaternion.h"
#include "particle/columns.h"
#include "particle/particles.h"
#include "particle/sphere_shape.h"

#include "base/banned.h"

const char *const ts_insertion_shares[] = { "exact", "uncorrelated", NULL };

/* ---- arguments */

enum { CONSTANT, UNIFORM, GAUSSIAN };

static const struct ts_arg mean_rows[] = {
	TS_VEC3("v", struct ts_insertion_velocity, mean, .flags = TS_POSITIONAL, .unit = "length/time",
		.help = "velocity"),
	TS_ARGS_END,
};

static const struct ts_arg fluctuation_rows[] = {
	TS_VEC3("v", struct ts_insertion_velocity, mean, .flags = TS_POSITIONAL, .unit = "length/time",
		.help = "mean velocity"),
	TS_VEC3("dv", struct ts_insertion_velocity, fluctuation, .flags = TS_POSITIONAL,
		.unit = "length/time", .help = "largest or standard deviation"),
	TS_ARGS_END,
};

static const struct ts_mode velocity_modes[] = {
	[CONSTANT] = { "constant", "the same for all", mean_rows },
	[UNIFORM] = { "uniform", "uniform within +-dv of the mean", fluctuation_rows },
	[GAUSSIAN] = { "gaussian", "normal with standard deviation dv", fluctuation_rows },
	{ .name = NULL },
};

static const struct ts_arg velocity_rows[] = {
	TS_MODE("spread", struct ts_insertion_velocity, spread, velocity_modes, .help = "distribution"),
	TS_ARGS_END,
};

struct omega {
	int mode;
	double omega[3];
};

static const struct ts_arg omega_constant[] = {
	TS_VEC3("omega", struct omega, omega, .flags = TS_POSITIONAL, .unit = "1/time",
		.help = "angular velocity"),
	TS_ARGS_END,
};

static const struct ts_mode omega_modes[] = {
	{ "constant", "the same for all", omega_constant },
	{ .name = NULL },
};

static const struct ts_arg omega_rows[] = {
	TS_MODE("spread", struct omega, mode, omega_modes, .help = "distribution"),
	TS_ARGS_END,
};

enum { TEMPLATE, RANDOM, QUATERNION };

struct orientation {
	int mode;
	struct ts_words numbers;
};

static const struct ts_arg quaternion_rows[] = {
	TS_REST("q", struct orientation, numbers, .help = "four numbers"),
	TS_ARGS_END,
};

static const struct ts_mode orientation_modes[] = {
	[TEMPLATE] = { "template", "as in the template", NULL },
	[RANDOM] = { "random", "uniform over all orientations", NULL },
	[QUATERNION] = { "constant", "rotated by a quaternion", quaternion_rows },
	{ .name = NULL },
};

static const struct ts_arg orientation_rows[] = {
	TS_MODE("mode", struct orientation, mode, orientation_modes, .help = "how the orientation is chosen"),
	TS_ARGS_END,
};

static enum ts_status parse_keyword(struct ts_instance *self, struct tsim *sim, const char *keyword,
				    const struct ts_arg *rows, struct ts_words words, void *out)
{
	char what[80];

	if (!words.n)
		return TS_OK;
	snprintf(what, sizeof what, "fix %s: %s", self->style->name, keyword);
	return ts_args_parse(sim, what, rows, words, &words.word[0].place, &self->arena, out);
}

static enum ts_status read_every(struct ts_instance *self, struct tsim *sim)
{
	struct ts_insertion *s = self->state;

	if (!s->every_word || ts_streq(s->every_word, "once"))
		return TS_OK;
	if (ts_arg_whole_part(self, sim, "insert_every", s->every_word, &s->every) && s->every >= 0)
		return TS_OK;
	return ts_fail(&sim->error, TS_SYNTAX, ts_instance_word(self, s->every_word),
		       "fix %s: insert_every is '%s', expected a number of steps or once", self->style->name,
		       s->every_word);
}

static enum ts_status read_property(struct ts_instance *self, struct tsim *sim)
{
	struct ts_insertion *s = self->state;
	const struct ts_word *word = s->property_words.word;

	if (s->property_words.n == 0)
		return TS_OK;
	if (s->property_words.n == 2 && ts_parse_real(word[1].text, &s->property))
		return TS_OK;
	return ts_fail(&sim->error, TS_SYNTAX, &word[0].place,
		       "fix %s: set_property is followed by a name and a number", self->style->name);
}

static enum ts_status read_quaternion(struct ts_instance *self, struct tsim *sim, const struct orientation *o)
{
	struct ts_insertion *s = self->state;
	double norm = 0;

	s->q[0] = 1;
	if (o->mode != QUATERNION)
		return TS_OK;
	for (size_t k = 0; k < 4 && o->numbers.n == 4; k++) {
		if (!ts_parse_real(o->numbers.word[k].text, &s->q[k]))
			s->q[k] = NAN;
		norm += s->q[k] * s->q[k];
	}
	if (!(norm > 0))
		return ts_fail(&sim->error, TS_SYNTAX, &s->orientation_words.word[0].place,
			       "fix %s: orientation constant is followed by four numbers, not all 0",
			       self->style->name);
	ts_quaternion_normalise(s->q);
	return TS_OK;
}

static enum ts_status read_words(struct ts_instance *self, struct tsim *sim)
{
	struct ts_insertion *s = self->state;
	struct orientation orientation = { 0 };
	struct omega omega = { 0 };

	TS_TRY(parse_keyword(self, sim, "vel", velocity_rows, s->velocity_words, &s->velocity));
	TS_TRY(parse_keyword(self, sim, "omega", omega_rows, s->omega_words, &omega));
	for (int d = 0; d < 3; d++)
		s->omega[d] = omega.omega[d];
	TS_TRY(parse_keyword(self, sim, "orientation", orientation_rows, s->orientation_words, &orientation));
	s->turns = orientation.mode == RANDOM;
	TS_TRY(read_quaternion(self, sim, &orientation));
	return read_property(self, sim);
}

/* The k-th seed: that of the insertion, of its distribution, then of its templates. */
static int64_t seed_of(const struct ts_insertion *s, size_t k)
{
	const struct ts_distribution *d = s->distribution->state;

	return k == 0	? s->seed
	       : k == 1 ? d->seed
			: ((const struct ts_template *)d->template[k - 2] -> state)->seed;
}

/* Warns if two fixes have the same seed: they draw the same numbers, so that sizes and positions are
 * correlated. LIGGGHTS 3.8 refuses that, older editions do not. */
static void check_seeds(const struct ts_instance *self, struct tsim *sim)
{
	const struct ts_insertion *s = self->state;
	const struct ts_distribution *d = s->distribution->state;
	size_t n = (size_t)d->n + 2;

	for (size_t k = 1; k < n; k++)
		for (size_t j = 0; j < k; j++) {
			if (seed_of(s, j) != seed_of(s, k))
				continue;
			ts_warn(&sim->log, &self->where,
				"fix %s: the seed %lld of fix %s is used twice: both draw the same random "
				"numbers, so sizes and positions are correlated; give each fix a seed of its "
				"own%s",
				self->style->name, (long long)seed_of(s, k),
				k == 1 ? s->distribution->id : d->template[k - 2] -> id,
				sim -> legacy ? " (LIGGGHTS 3.8 refuses it)" : "");
			return;
		}
}

static enum ts_status check_arguments(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_insertion *s = self->state;
	const struct ts_distribution *d = s->distribution->state;

	if (sim->dimension == 2)
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "fix %s works in three dimensions; in two use `create_atoms N random`",
			       self->style->name);
	if (s->compress_tags)
		return ts_fail(&sim->error, TS_STATE, ts_instance_word(self, "compress_tags"),
			       "fix %s: compress_tags yes is not supported: particles keep their atom IDs",
			       self->style->name);
	if (d->largest_type > sim->particles->ntypes)
		return ts_fail(&sim->error, TS_RANGE, &self->where,
			       "fix %s: a template has atom_type %d, but types go from 1 to %d",
			       self->style->name, d->largest_type, sim->particles->ntypes);
	check_seeds(self, sim);
	return TS_OK;
}

/* Only checked in later calls of init: a restart file may have set `wait`. */
static enum ts_status check_start(const struct ts_instance *self, struct tsim *sim)
{
	const struct ts_insertion *s = self->state;

	if (s->wait >= 0)
		return TS_OK;
	return ts_fail(&sim->error, TS_RANGE, ts_instance_word(self, "start"),
		       "fix %s: start %lld is past, this is step %lld", self->style->name,
		       (long long)s->start, (long long)sim->clock.step);
}

/* Particles that will be inserted are members of group all and of that of the fix. */
static enum ts_status refuse_two_movers(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_instances *fixes = &sim->instances[TS_KIND_FIX];
	const struct ts_instance *first = NULL;

	for (size_t k = 0; k < fixes->n; k++) {
		const struct ts_instance *fix = fixes->item[k];

		if (!(fix->style->integrates & TS_MOVES) || (fix->group && fix->group != self->group))
			continue;
		if (first)
			return ts_fail(&sim->error, TS_STATE, &fix->where,
				       "fix %s (%s) moves the particles that fix %s inserts, which fix %s "
				       "(%s, %s:%d) moves, too: they would be moved twice in each step; "
				       "`unfix` one of them",
				       fix->id, fix->style->name, self->id, first->id, first->style->name,
				       TS_FILE_AND_LINE(first->where));
		first = fix;
	}
	return TS_OK;
}

enum ts_status ts_insertion_init(struct ts_instance *self, struct tsim *sim, bool *first)
{
	struct ts_insertion *s = self->state;
	struct ts_word id = { .text = s->distribution_id };

	*first = s->distribution == NULL;
	TS_TRY(refuse_two_movers(self, sim));
	id.place = *ts_instance_word(self, s->distribution_id);
	TS_TRY(ts_distribution_require(sim, &id, &s->distribution));
	TS_TRY(read_every(self, sim));
	if (!*first)
		return check_start(self, sim);
	TS_TRY(ts_template_check_seed(sim, self->style->name, s->seed, ts_instance_word(self, "seed")));
	TS_TRY(read_words(self, sim));
	TS_TRY(check_arguments(self, sim));
	if (s->omega_words.n)
		TS_TRY(ts_particles_need(sim, TS_NEED(OMEGA)));
	s->random = ts_minstd_start(s->seed);
	s->wait = s->start == INT64_MIN ? 1 : s->start - sim->clock.step;
	if (s->wait < 1)
		s->wait = -1;
	return TS_OK;
}

enum ts_status ts_insertion_archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *archive)
{
	return ts_template_archive_stream(archive, sim, "random",
					  &((struct ts_insertion *)self->state)->random);
}

void ts_insertion_fini(struct ts_instance *self)
{
	ts_free(((struct ts_insertion *)self->state)->list.item);
	ts_free(((struct ts_insertion *)self->state)->sphere);
}

/* ---- schedule and random motion */

bool ts_insertion_due(const struct ts_instance *self, const struct tsim *sim)
{
	const struct ts_insertion *s = self->state;

	(void)sim;
	return s->due || s->wait == 1;
}

/* Members of bodies are copies, in whose place new particles come. */
bool ts_insertion_divides(const struct ts_insertion *s, const struct tsim *sim)
{
	const struct ts_distribution *d = s->distribution ? s->distribution->state : NULL;
	bool rigid = sim->particles->body != NULL;

	for (int64_t k = 0; d && k < d->n; k++)
		rigid |= ((const struct ts_template *)d->template[k] -> state)->rigid;
	return !rigid;
}

bool ts_insertion_whole_due(const struct ts_instance *self, const struct tsim *sim)
{
	return ts_insertion_due(self, sim) && !ts_insertion_divides(self->state, sim);
}

enum ts_status ts_insertion_check(struct ts_instance *self, struct tsim *sim)
{
	struct ts_insertion *s = self->state;

	if (s->wait > 0 && --s->wait == 0) {
		s->due = true;
		sim->run.rebuild = true;
	}
	return TS_OK;
}

void ts_insertion_next(struct ts_instance *self)
{
	struct ts_insertion *s = self->state;

	s->due = false;
	s->wait = s->every;
}

void ts_insertion_draw_velocity(struct ts_insertion *s, struct ts_new_particle *one)
{
	const struct ts_insertion_velocity *v = &s->velocity;

	for (int d = 0; d < 3; d++) {
		one->v[d] = v->mean[d];
		if (v->spread == UNIFORM)
			one->v[d] += v->fluctuation[d] * 2.0 * (ts_minstd_uniform(&s->random) - 0.5);
		else if (v->spread == GAUSSIAN)
			one->v[d] += v->fluctuation[d] * ts_minstd_normal(&s->random);
	}
}

/* Uniformly distributed unit quaternions (Shoemake, Graphics Gems III, 1992). */
void ts_insertion_draw_orientation(struct ts_insertion *s, struct ts_new_particle *one)
{
	double u, a, b;

	for (int k = 0; k < 4; k++)
		one->q[k] = s->q[k];
	if (!s->turns)
		return;
	u = ts_minstd_uniform(&s->random);
	a = 2 * TS_PI * ts_minstd_uniform(&s->random);
	b = 2 * TS_PI * ts_minstd_uniform(&s->random);
	one->q[0] = sqrt(1 - u) * sin(a);
	one->q[1] = sqrt(1 - u) * cos(a);
	one->q[2] = sqrt(u) * sin(b);
	one->q[3] = sqrt(u) * cos(b);
}

/* ---- outputs */

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct ts_insertion *s = self->state;

	(void)sim;
	out->data[0] = (double)s->inserted;
	out->data[1] = s->mass;
	return TS_OK;
}

static const char *const names[] = { "number", "mass", NULL };

const struct ts_value ts_insertion_values[] = {
	{ "inserted", "", "number and mass of the particles inserted so far", TS_VECTOR, 2, names, eval },
	{ .name = NULL },
};
