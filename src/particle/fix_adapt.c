/* Fix adapt: sizes, masses and coefficients of contacts that change during a run. */
#include "core/sim.h"

#include <math.h>

#include "contact/pair.h"
#include "core/number_or_peratom.h"
#include "particle/columns.h"
#include "particle/first_size.h"
#include "particle/particles.h"
#include "particle/sphere_shape.h"

#include "base/banned.h"

enum { DIAMETER, DENSITY, MASS, PAIR };
enum { MOST = 8 }; /* changes in a line */

struct change {
	int what;
	struct ts_number value;
	struct ts_types a, b;
	const struct ts_word *style, *number; /* of PAIR */
	const struct ts_arg *row;
	double *first; /* by pair of types */
};

struct state {
	int64_t every;
	struct ts_words words;
	bool scale, reset, mass;
	struct change change[MOST];
	size_t n, column;
	struct ts_number_or_peratom now;
	double *first; /* saved: coefficients as they were, of all changes */
	size_t first_n, first_capacity;
	int64_t applied, epoch; /* saved; the epoch makes forces be computed anew */
};

static enum ts_status expected(struct tsim *sim, const struct ts_instance *self, const struct ts_word *word,
			       const char *what)
{
	return ts_fail(&sim->error, TS_SYNTAX, word ? &word->place : &self->where,
		       "fix adapt: found '%s', expected %s", word ? word->text : "the end of the line", what);
}

static const struct ts_word *take(struct ts_words *words)
{
	const struct ts_word *word = words->n ? &words->word[0] : NULL;

	*words = ts_words_from(*words, 1);
	return word;
}

static enum ts_status take_variable(struct ts_instance *self, struct tsim *sim, struct ts_words *words,
				    struct change *c)
{
	const struct ts_word *word = take(words);
	const char *name = word && word->text[0] == 'v' && word->text[1] == '_' ? word->text + 2 : NULL;
	struct ts_suggest suggest = ts_suggest_start(name ? name : "");

	if (!name)
		return expected(sim, self, word, "v_NAME");
	c->value.variable = name;
	if (sim->script_api && sim->script_api->has_variable(sim->script_api_data, name))
		return TS_OK;
	if (sim->script_api)
		sim->script_api->suggest_variable(sim->script_api_data, &suggest);
	return ts_missing(&sim->error, "variable", name, &word->place, "fix adapt: unknown variable '%s'%s",
			  name, ts_suggest_text(&suggest));
}

/* atom diameter|density|mass v_NAME */
static enum ts_status take_atom(struct ts_instance *self, struct tsim *sim, struct ts_words *words,
				struct change *c)
{
	static const char *const names[] = { "diameter", "density", "mass" };
	const struct ts_word *word = take(words);

	for (c->what = 0; c->what < PAIR; c->what++)
		if (word && ts_streq(word->text, names[c->what]))
			return take_variable(self, sim, words, c);
	return expected(sim, self, word, "diameter, density or mass");
}

static enum ts_status take_types(struct ts_instance *self, struct tsim *sim, struct ts_words *words,
				 struct ts_types *types)
{
	const struct ts_word *word = take(words);

	if (!word || !ts_parse_types(word->text, types) ||
	    (types->hi ? types->hi : types->lo) > sim->particles->ntypes)
		return expected(sim, self, word, "a type of particles or a range such as 1*2");
	if (!types->hi)
		types->hi = sim->particles->ntypes;
	return TS_OK;
}

/* pair STYLE NUMBER I J v_NAME */
static enum ts_status take_pair(struct ts_instance *self, struct tsim *sim, struct ts_words *words,
				struct change *c)
{
	c->what = PAIR;
	c->style = take(words);
	c->number = take(words);
	if (!c->number)
		return expected(sim, self, NULL, "pair STYLE NUMBER I J v_NAME");
	TS_TRY(take_types(self, sim, words, &c->a));
	TS_TRY(take_types(self, sim, words, &c->b));
	return take_variable(self, sim, words, c);
}

static enum ts_status read_changes(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	struct ts_words words = s->words;

	while (words.n) {
		const struct ts_word *word = take(&words);
		struct change *c = &s->change[s->n];

		if (s->n++ == MOST)
			return expected(sim, self, word, "at most 8 changes");
		if (ts_streq(word->text, "atom"))
			TS_TRY(take_atom(self, sim, &words, c));
		else if (ts_streq(word->text, "pair"))
			TS_TRY(take_pair(self, sim, &words, c));
		else
			return expected(sim, self, word, "atom or pair");
	}
	return TS_OK;
}

/* The coefficients as they are when the fix is made; room by pair of types and change. */
static enum ts_status keep_first(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	size_t types = (size_t)sim->particles->ntypes + 1, room = types * types;
	bool fresh = s->first_n == 0;

	for (size_t k = 0; k < s->n; k++)
		if (s->change[k].what == PAIR)
			TS_TRY(ts_pair_row(sim, s->change[k].style, s->change[k].number, &s->change[k].row));
	if (TS_GROW(s->first, s->first_capacity, s->n * room) != TS_OK)
		return ts_nomem(&sim->error);
	s->first_n = s->n * room;
	for (size_t k = 0; k < s->n; k++) {
		struct change *c = &s->change[k];

		c->first = s->first + k * room;
		for (int a = c->a.lo; fresh && c->what == PAIR && a <= c->a.hi; a++)
			for (int b = c->b.lo; b <= c->b.hi; b++)
				c->first[(size_t)a * types + (size_t)b] = ts_pair_number(sim, c->row, a, b);
	}
	return TS_OK;
}

static void see_new(const struct state *s, const struct tsim *sim)
{
	for (size_t i = 0; i < sim->particles->n; i++)
		ts_first_size_note(sim, s->column, i);
}

static enum ts_status start(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	TS_TRY(read_changes(self, sim));
	TS_TRY(ts_first_size_start(sim, self, &s->column));
	see_new(s, sim);
	return TS_OK;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	if (!s->n)
		TS_TRY(start(self, sim));
	if (!s->applied)
		s->epoch++;
	return keep_first(self, sim);
}

static void set_particle(const struct state *s, struct tsim *sim, size_t i, int what, double value)
{
	struct ts_particles *p = sim->particles;
	const double *first = ts_first_size(sim, s->column, i);
	double volume = ts_particle_volume(sim, p->radius[i]);

	if (what == DIAMETER) {
		p->radius[i] = s->scale ? value * first[TS_FIRST_RADIUS] : 0.5 * value;
		if (s->mass)
			p->mass[i] *= ts_particle_volume(sim, p->radius[i]) / volume;
	} else if (what == MASS) {
		p->mass[i] = s->scale ? value * first[TS_FIRST_MASS] : value;
	} else {
		p->mass[i] = s->scale ? value * first[TS_FIRST_MASS] /
						ts_particle_volume(sim, first[TS_FIRST_RADIUS]) * volume
				      : value * volume;
	}
	if (p->imass[i] > 0)
		p->imass[i] = 1 / p->mass[i];
}

static enum ts_status change_particles(struct ts_instance *self, struct tsim *sim, const struct change *c)
{
	struct state *s = self->state;
	const struct ts_particles *p = sim->particles;

	TS_TRY(ts_number_or_peratom_now(sim, &c->value, &self->where, &s->now));
	for (size_t i = 0; i < p->n; i++) {
		double value = ts_number_or_peratom_of(&s->now, i);

		if (!ts_in_group(p, i, self->group))
			continue;
		if (!(value > 0) || !isfinite(value))
			return ts_fail(&sim->error, TS_RANGE, &self->where,
				       "fix adapt: v_%s is %g for particle %d, expected a number > 0",
				       c->value.variable, value, p->tag[i]);
		set_particle(s, sim, i, c->what, value);
	}
	return TS_OK;
}

static enum ts_status change_pairs(struct ts_instance *self, struct tsim *sim, const struct change *c)
{
	const struct state *s = self->state;
	size_t types = (size_t)sim->particles->ntypes + 1;
	double value;

	TS_TRY(ts_number_now(sim, &c->value, &self->where, &value));
	for (int a = c->a.lo; a <= c->a.hi; a++)
		for (int b = c->b.lo; b <= c->b.hi; b++) {
			double first = c->first[(size_t)a * types + (size_t)b];

			TS_TRY(ts_pair_set_number(sim, c->row, a, b, s->scale ? value * first : value,
						  &self->where));
		}
	return TS_OK;
}

static enum ts_status change(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	see_new(s, sim);
	for (size_t k = 0; k < s->n; k++)
		TS_TRY(s->change[k].what == PAIR ? change_pairs(self, sim, &s->change[k])
						 : change_particles(self, sim, &s->change[k]));
	s->applied = 1;
	return TS_OK;
}

/* Before the rows are built: they must know the new sizes. */
static enum ts_status post_integrate(struct ts_instance *self, struct tsim *sim)
{
	const struct state *s = self->state;

	if (sim->clock.step % s->every != 0)
		return TS_OK;
	sim->run.rebuild = true;
	return change(self, sim);
}

/* At the start of the first run. */
static enum ts_status exchange(struct ts_instance *self, struct tsim *sim)
{
	const struct state *s = self->state;

	return s->applied ? TS_OK : change(self, sim);
}

static enum ts_status finish(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	struct ts_particles *p = sim->particles;
	size_t types = (size_t)p->ntypes + 1;

	if (!s->reset)
		return TS_OK;
	for (size_t i = 0; i < p->n; i++) {
		if (!ts_in_group(p, i, self->group) ||
		    !(ts_first_size(sim, s->column, i)[TS_FIRST_KNOWN] > 0))
			continue;
		p->radius[i] = ts_first_size(sim, s->column, i)[TS_FIRST_RADIUS];
		p->mass[i] = ts_first_size(sim, s->column, i)[TS_FIRST_MASS];
	}
	for (size_t k = 0; k < s->n; k++) {
		const struct change *c = &s->change[k];

		for (int a = c->a.lo; c->what == PAIR && a <= c->a.hi; a++)
			for (int b = c->b.lo; b <= c->b.hi; b++)
				TS_TRY(ts_pair_set_number(sim, c->row, a, b,
							  c->first[(size_t)a * types + (size_t)b],
							  &self->where));
	}
	s->applied = 0;
	return TS_OK;
}

/* The coefficients as they are now: the script that reads the restart file says those of the beginning. */
static enum ts_status archive_present(struct ts_instance *self, struct tsim *sim, const struct change *c,
				      struct ts_archive *a, const char *name)
{
	size_t types = (size_t)sim->particles->ntypes + 1, n = types * types;
	double *now = ts_alloc(n, sizeof *now);
	enum ts_status status;

	if (!now)
		return ts_nomem(&sim->error);
	for (int i = c->a.lo; i <= c->a.hi; i++)
		for (int j = c->b.lo; j <= c->b.hi; j++)
			now[(size_t)i * types + (size_t)j] = ts_pair_number(sim, c->row, i, j);
	status = ts_archive_fixed(a, name, TS_SAVED_F64, now, n);
	for (int i = c->a.lo; !ts_archive_writing(a) && status == TS_OK && i <= c->a.hi; i++)
		for (int j = c->b.lo; status == TS_OK && j <= c->b.hi; j++)
			status = ts_pair_set_number(sim, c->row, i, j, now[(size_t)i * types + (size_t)j],
						    &self->where);
	ts_free(now);
	return status;
}

static enum ts_status archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a)
{
	struct state *s = self->state;
	char name[32];

	TS_TRY(ts_archive_array(a, "first", TS_SAVED_F64, (void **)&s->first, &s->first_capacity,
				&s->first_n));
	for (size_t k = 0; k < s->n; k++) {
		snprintf(name, sizeof name, "change%zu", k);
		if (s->change[k].what == PAIR)
			TS_TRY(archive_present(self, sim, &s->change[k], a, name));
	}
	return ts_particles_archive_column(a, sim, "particles", s->column);
}

static void fingerprint(const struct ts_instance *self, const struct tsim *sim, struct ts_hash *hash)
{
	const struct state *s = self->state;

	(void)sim;
	ts_hash_add(hash, &s->epoch, sizeof s->epoch);
}

static void fini(struct ts_instance *self)
{
	struct state *s = self->state;

	ts_number_or_peratom_release(&s->now);
	ts_free(s->first);
}

static const struct ts_arg args[] = {
	TS_INT("N", struct state, every, .flags = TS_POSITIONAL, .range = TS_WITHIN, .lo = 1, .hi = 1e15,
	       .help = "steps between changes"),
	TS_LIST_STATEFUL("changes", struct state, words,
			 .help = "atom diameter|density|mass v_NAME, or pair STYLE NUMBER I J v_NAME, one or "
				 "more"),
	TS_BOOL("scale", struct state, scale, .flags = TS_STATEFUL, .fallback = "no",
		.help = "the variables are factors of what there was when the fix was made"),
	TS_BOOL("reset", struct state, reset, .fallback = "no",
		.help = "at the end of a run all is again as it was when the fix was made"),
	TS_BOOL("mass", struct state, mass, .fallback = "yes",
		.help = "with a diameter changes the mass (the density stays); no: the mass stays"),
	TS_ARGS_END,
};

static const struct ts_saved saved[] = {
	TS_SAVE_I64(struct state, applied),
	TS_SAVE_I64(struct state, epoch),
	TS_SAVED_ROWS_END,
};

TS_STYLE(fix, ts_style, ts_fix_adapt)
const struct ts_style ts_fix_adapt = {
	.name = "adapt",
	.kind = TS_KIND_FIX,
	.summary = "Changes particles or coefficients of contacts during a run",
	.doc = "At the start of the first run and in each step that is a multiple of N the variables are "
	       "evaluated\n"
	       "and what they stand for is set: diameter, density or mass of the particles of the group, or "
	       "a number\n"
	       "of `pair_coeff` for all pairs of types I and J. `scale yes` counts from when the fix was "
	       "made,\n"
	       "however many runs there have been. The limit of the time step is checked only when a run "
	       "begins.",
	.example = "variable size equal ramp(0.01,0.012)\n"
		   "fix grow beads adapt 10 atom diameter v_size\n"
		   "fix soft all adapt 100 pair spring/dashpot stiffness 1 1* v_factor scale yes",
	.args = args,
	.state_size = sizeof(struct state),
	.saved = saved,
	.archive = archive,
	.fingerprint = fingerprint,
	.init = init,
	.hook = {
		[TS_STAGE_POST_INTEGRATE] = post_integrate,
		[TS_STAGE_EXCHANGE] = exchange,
		[TS_STAGE_FINISH] = finish,
	},
	.fini = fini,
};
