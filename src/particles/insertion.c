#include "particles/insertion.h"

#include <inttypes.h>

#include "math/rigid_turn.h"
#include "math/vec3.h"
#include "particles/body.h"
#include "particles/domain.h"
#include "particles/particles.h"

#include "base/banned.h"

const char *const ts_insertion_shares[] = { "exact", "uncorrelated", NULL };

/* ---- arguments */

enum { CONSTANT, UNIFORM, GAUSSIAN };

static const struct ts_arg mean_rows[] = {
	TS_VEC3("v", struct ts_insertion_velocity, mean, .flags = TS_POSITIONAL,
		.unit = "length/time", .help = "velocity"),
	TS_ARGS_END,
};

static const struct ts_arg fluctuation_rows[] = {
	TS_VEC3("v", struct ts_insertion_velocity, mean, .flags = TS_POSITIONAL,
		.unit = "length/time", .help = "mean velocity"),
	TS_VEC3("dv", struct ts_insertion_velocity, fluctuation, .flags = TS_POSITIONAL,
		.unit = "length/time", .help = "largest or standard deviation"),
	TS_ARGS_END,
};

static const struct ts_mode velocity_modes[] = {
	[CONSTANT] = { "constant", "the same for all", mean_rows },
	[UNIFORM] = { "uniform", "up to dv from the mean", fluctuation_rows },
	[GAUSSIAN] = { "gaussian", "normal with deviation dv", fluctuation_rows },
	{ .name = NULL },
};

static const struct ts_arg velocity_rows[] = {
	TS_MODE("spread", struct ts_insertion_velocity, spread, velocity_modes,
		.help = "how it is spread"),
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
	TS_MODE("spread", struct omega, mode, omega_modes, .help = "how it is spread"),
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
	[RANDOM] = { "random", "uniform over all", NULL },
	[QUATERNION] = { "constant", "turned by a quaternion", quaternion_rows },
	{ .name = NULL },
};

static const struct ts_arg orientation_rows[] = {
	TS_MODE("mode", struct orientation, mode, orientation_modes, .help = "how it is chosen"),
	TS_ARGS_END,
};

static enum ts_status read_part(struct ts_instance *self, struct tsim *sim, const char *keyword,
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
	if (ts_parse_int(s->every_word, &s->every) && s->every >= 0)
		return TS_OK;
	return ts_fail(&sim->error, TS_SYNTAX, ts_instance_word(self, s->every_word),
		       "fix %s: insert_every is '%s', expected a number of steps or once",
		       self->style->name, s->every_word);
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

static enum ts_status read_quaternion(struct ts_instance *self, struct tsim *sim,
				      const struct orientation *o)
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

	TS_TRY(read_every(self, sim));
	TS_TRY(read_part(self, sim, "vel", velocity_rows, s->velocity_words, &s->velocity));
	TS_TRY(read_part(self, sim, "omega", omega_rows, s->omega_words, &omega));
	for (int d = 0; d < 3; d++)
		s->omega[d] = omega.omega[d];
	TS_TRY(read_part(self, sim, "orientation", orientation_rows, s->orientation_words,
			 &orientation));
	s->turns = orientation.mode == RANDOM;
	TS_TRY(read_quaternion(self, sim, &orientation));
	return read_property(self, sim);
}

/* LIGGGHTS refuses equal seeds: the streams would be the same. */
static enum ts_status check_seeds(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_insertion *s = self->state;
	const struct ts_distribution *d = s->distribution->state;
	size_t n = 0;
	int64_t *seed = ts_alloc((size_t)d->n + 2, sizeof *seed);
	const char *owner = NULL;
	int64_t twice = 0, other = 0;

	if (!seed)
		return ts_nomem(&sim->error);
	seed[n++] = s->seed;
	seed[n++] = d->seed;
	for (int64_t k = 0; k < d->n; k++)
		seed[n++] = ((const struct ts_template *)d->template[k]->state)->seed;
	for (size_t k = 1; k < n && !owner; k++)
		for (size_t j = 0; j < k; j++)
			if (seed[j] == seed[k]) {
				owner = k == 1 ? s->distribution->id : d->template[k - 2]->id;
				twice = seed[k];
			}
	if (owner)
		other = ts_seed_next(twice, seed, n);
	ts_free(seed);
	if (!owner)
		return TS_OK;
	return ts_fail(&sim->error, TS_STATE, &self->where,
		       "fix %s: the seed %lld of fix %s is used twice; %lld is free", self->style->name,
		       (long long)twice, owner, (long long)other);
}

static enum ts_status refuse(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_insertion *s = self->state;
	const struct ts_distribution *d = s->distribution->state;

	if (sim->dimension == 2)
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "fix %s works in three dimensions; in two use `create_atoms N random`",
			       self->style->name);
	if (s->compress_tags)
		return ts_fail(&sim->error, TS_STATE, ts_instance_word(self, "compress_tags"),
			       "fix %s: compress_tags yes is known, but not built: a particle keeps its "
			       "number for life",
			       self->style->name);
	if (d->largest_type > sim->particles->ntypes)
		return ts_fail(&sim->error, TS_RANGE, &self->where,
			       "fix %s: a template has atom_type %d, but types go from 1 to %d",
			       self->style->name, d->largest_type, sim->particles->ntypes);
	return check_seeds(self, sim);
}

/* Looked at when the fix is met again: a restart file may have told it how to go on. */
static enum ts_status refuse_start(const struct ts_instance *self, struct tsim *sim)
{
	const struct ts_insertion *s = self->state;

	if (s->wait >= 0)
		return TS_OK;
	return ts_fail(&sim->error, TS_RANGE, ts_instance_word(self, "start"),
		       "fix %s: start %lld is past, this is step %lld", self->style->name,
		       (long long)s->start, (long long)sim->clock.step);
}

enum ts_status ts_insertion_init(struct ts_instance *self, struct tsim *sim, bool *first)
{
	struct ts_insertion *s = self->state;
	struct ts_word id = { .text = s->distribution_id };

	*first = s->distribution == NULL;
	id.place = *ts_instance_word(self, s->distribution_id);
	TS_TRY(ts_distribution_require(sim, &id, &s->distribution));
	if (!*first)
		return refuse_start(self, sim);
	TS_TRY(ts_seed_check(sim, self->style->name, s->seed, ts_instance_word(self, "seed")));
	TS_TRY(read_words(self, sim));
	TS_TRY(refuse(self, sim));
	if (s->omega_words.n)
		TS_TRY(ts_particles_need(sim, TS_NEED(OMEGA)));
	s->random = ts_minstd_start(s->seed);
	s->wait = s->start == INT64_MIN ? 1 : s->start - sim->clock.step;
	if (s->wait < 1)
		s->wait = -1;
	return TS_OK;
}

enum ts_status ts_insertion_archive(struct ts_instance *self, struct tsim *sim,
				    struct ts_archive *archive)
{
	return ts_minstd_archive(archive, sim, "random",
				 &((struct ts_insertion *)self->state)->random);
}

void ts_insertion_fini(struct ts_instance *self)
{
	ts_free(((struct ts_insertion *)self->state)->list.item);
}

/* ---- events */

enum ts_status ts_insertion_check(struct ts_instance *self, struct tsim *sim)
{
	struct ts_insertion *s = self->state;

	if (s->wait > 0 && --s->wait == 0) {
		s->due = true;
		sim->rebuild = true;
	}
	return TS_OK;
}

void ts_insertion_next(struct ts_instance *self)
{
	struct ts_insertion *s = self->state;

	s->due = false;
	s->wait = s->every;
}

void ts_insertion_draw_velocity(struct ts_insertion *s, struct ts_newcomer *one)
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

/* Uniform over all orientations (Shoemake, Graphics Gems III, 1992). */
void ts_insertion_draw_orientation(struct ts_insertion *s, struct ts_newcomer *one)
{
	double u, a, b;

	for (int k = 0; k < 4; k++)
		one->q[k] = s->q[k];
	if (!s->turns)
		return;
	u = ts_minstd_uniform(&s->random);
	a = 2 * TS_BODY_PI * ts_minstd_uniform(&s->random);
	b = 2 * TS_BODY_PI * ts_minstd_uniform(&s->random);
	one->q[0] = sqrt(1 - u) * sin(a);
	one->q[1] = sqrt(1 - u) * cos(a);
	one->q[2] = sqrt(u) * sin(b);
	one->q[3] = sqrt(u) * cos(b);
}

/* ---- spheres of a newcomer */

static const struct ts_template *template_of(const struct ts_newcomer *one)
{
	return one->template ? one->template->state : NULL;
}

static const struct ts_clump *clump_of(const struct ts_newcomer *one)
{
	return one->template ? template_of(one)->clump : NULL;
}

static size_t spheres_of(const struct ts_newcomer *one)
{
	return clump_of(one) ? clump_of(one)->n : 1;
}

/* Where its k-th sphere is; returns the radius. */
static double sphere_of(const struct ts_newcomer *one, size_t k, double x[3])
{
	const struct ts_template *t = template_of(one);
	double m[3][3], d[3], arm[3];

	ts_scale(1, one->x, x);
	if (!clump_of(one))
		return one->radius;
	ts_sub(t->clump->sphere[k].x, t->origin, d);
	ts_quaternion_matrix(one->q, m);
	ts_rotate(m, d, arm);
	ts_add(x, arm, x);
	return t->clump->sphere[k].radius;
}

enum ts_status ts_insertion_crowd(struct tsim *sim, struct ts_spherehash *crowd)
{
	const struct ts_particles *p = sim->particles;

	for (size_t i = 0; i < p->n; i++)
		if (ts_spherehash_add(crowd, p->x[i], p->radius[i]) != TS_OK)
			return ts_nomem(&sim->error);
	return TS_OK;
}

bool ts_insertion_overlaps(const struct tsim *sim, const struct ts_spherehash *crowd,
			   const struct ts_newcomer *one)
{
	for (size_t k = 0; k < spheres_of(one); k++) {
		double x[3], radius = sphere_of(one, k, x);

		if (ts_spherehash_overlaps_periodic(crowd, &sim->domain->box, x, radius))
			return true;
	}
	return false;
}

enum ts_status ts_insertion_join(struct tsim *sim, struct ts_spherehash *crowd,
				 const struct ts_newcomer *one)
{
	for (size_t k = 0; k < spheres_of(one); k++) {
		double x[3], radius = sphere_of(one, k, x);

		if (ts_spherehash_add(crowd, x, radius) != TS_OK)
			return ts_nomem(&sim->error);
	}
	return TS_OK;
}

/* Rounded as LIGGGHTS rounds it, where particles are inserted. */
static double sphere_mass(const struct tsim *sim, const struct ts_newcomer *one, double r)
{
	if (sim->dimension == 2)
		return one->density * ts_body_volume(sim, r);
	if (clump_of(one)) /* its 4 pi / 3 */
		return one->density * (r * r * r * 4.18879020479);
	return one->density * (r * r * r * 4 * TS_BODY_PI / 3);
}

static void fill_in(struct ts_instance *self, struct tsim *sim, const struct ts_newcomer *one,
		    size_t k, size_t i)
{
	struct ts_particles *p = sim->particles;

	p->type[i] = one->type;
	p->mask[i] |= one->mask | 1u << self->group;
	p->radius[i] = sphere_of(one, k, p->x[i]);
	p->mass[i] = sphere_mass(sim, one, p->radius[i]);
	p->imass[i] = 1 / p->mass[i];
	for (int d = 0; d < 3; d++) {
		p->v[i][d] = one->v[d];
		if (p->omega)
			p->omega[i][d] = one->omega[d];
	}
}

/* Spheres of a rigid clump overlap: they share its mass by their volumes. */
static void share_mass(struct ts_particles *p, double mass, size_t from, size_t n)
{
	double sum = 0;

	for (size_t i = from; i < from + n; i++)
		sum += p->mass[i];
	for (size_t i = from; i < from + n; i++)
		p->mass[i] *= mass / sum;
}

static enum ts_status make_body(struct ts_instance *self, struct tsim *sim,
				const struct ts_newcomer *one, size_t from, size_t n)
{
	const struct ts_template *t = one->template->state;
	const struct ts_instance *fix = NULL;
	struct ts_body body = t->body;
	int32_t *row;
	enum ts_status status;

	for (size_t k = 0; k < sim->instances[TS_KIND_FIX].n; k++)
		if (ts_streq(sim->instances[TS_KIND_FIX].item[k]->style->name, "multisphere"))
			fix = sim->instances[TS_KIND_FIX].item[k];
	if (!fix)
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "fix %s: rigid clumps of fix %s need `fix ID all multisphere`",
			       self->style->name, one->template->id);
	ts_quaternion_multiply(one->q, t->body.q, body.q);
	ts_quaternion_normalise(body.q);
	for (int i = 0; i < 3; i++) {
		body.x[i] = one->x[i];
		body.v[i] = one->v[i];
		body.omega[i] = one->omega[i];
	}
	ts_rigid_spin(body.q, body.inertia, one->omega, body.spin);
	share_mass(sim->particles, body.mass, from, n);
	row = ts_alloc(n, sizeof *row);
	if (!row)
		return ts_nomem(&sim->error);
	for (size_t k = 0; k < n; k++)
		row[k] = (int32_t)(from + k);
	status = ts_rigid_add(sim, &body, ts_rigid_owner(fix->id), row, n);
	ts_free(row);
	return status;
}

static enum ts_status make_one(struct ts_instance *self, struct tsim *sim,
			       const struct ts_newcomer *one, size_t from)
{
	const struct ts_template *t = template_of(one);
	struct ts_insertion *s = self->state;

	for (size_t k = 0; k < spheres_of(one); k++)
		fill_in(self, sim, one, k, from + k);
	s->mass += clump_of(one) ? t->mass : sim->particles->mass[from];
	s->inserted++;
	return t && t->rigid ? make_body(self, sim, one, from, t->clump->n) : TS_OK;
}

static enum ts_status set_property(struct ts_instance *self, struct tsim *sim, size_t from)
{
	struct ts_insertion *s = self->state;
	const struct ts_word *name = s->property_words.word;
	const struct ts_column *column;
	size_t k;

	if (!s->property_words.n)
		return TS_OK;
	column = ts_particles_named_column(sim->particles, name->text, &k);
	if (!column)
		return ts_fail(&sim->error, TS_UNKNOWN, &name->place,
			       "fix %s: set_property: no fix property/atom gives particles '%s'",
			       self->style->name, name->text);
	for (size_t i = from; i < sim->particles->n; i++)
		((double *)column->data)[i * column->width + k] = s->property;
	return TS_OK;
}

static void report(struct ts_instance *self, struct tsim *sim, size_t made, double mass)
{
	struct ts_insertion *s = self->state;

	if (s->verbose)
		ts_log(&sim->log,
		       "INFO: Particle insertion %s: inserted %zu particle templates (mass %e) at step "
		       "%" PRId64 "\n - a total of %" PRId64
		       " particle templates (mass %e) inserted so far.\n",
		       self->id, made, mass, sim->clock.step, s->inserted, s->mass);
	if (made >= s->list.n || s->warned)
		return;
	s->warned = true;
	ts_warn(&sim->log, &self->where,
		"fix %s %s: less insertions than requested: %zu of %zu particles found a place at step "
		"%" PRId64 " with %" PRId64 " tries each on average; raise maxattempt, ask for less, or "
		"give them more room (said once)",
		self->style->name, self->id, made, s->list.n, sim->clock.step, s->maxattempt);
}

enum ts_status ts_insertion_make(struct ts_instance *self, struct tsim *sim, size_t *from)
{
	struct ts_insertion *s = self->state;
	double before = s->mass;
	size_t made = 0, spheres = 0, row;

	for (size_t k = 0; k < s->list.n; k++) {
		made += s->list.item[k].placed;
		spheres += s->list.item[k].placed ? spheres_of(&s->list.item[k]) : 0;
	}
	TS_TRY(ts_particles_add(sim, spheres, from));
	row = *from;
	for (size_t k = 0; k < s->list.n; k++) {
		if (!s->list.item[k].placed)
			continue;
		TS_TRY(make_one(self, sim, &s->list.item[k], row));
		row += spheres_of(&s->list.item[k]);
	}
	TS_TRY(set_property(self, sim, *from));
	if (s->list.n)
		report(self, sim, made, s->mass - before);
	return TS_OK;
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
	{ "inserted", "", "number and mass of the particles inserted so far", TS_VECTOR, 2, names,
	  eval },
	{ .name = NULL },
};
