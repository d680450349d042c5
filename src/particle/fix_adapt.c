/* Fix adapt: changes diameter, density or mass of particles, or coefficients of contacts, during a run. */
#include "core/sim.h"

#include <math.h>

#include "contact/pair.h"
#include "core/number_or_peratom.h"
#include "particle/columns.h"
#include "particle/first_size.h"
#include "particle/particles.h"
#include "particle/sphere_shape.h"
#include "rigid/rigid_change.h"

#include "base/banned.h"

enum { DIAMETER, DENSITY, MASS, PAIR };
enum { MAX_CHANGES = 8 }; /* changes per fix */

struct change {
	int what;
	struct ts_number value;
	struct ts_types a, b;
	const struct ts_word *style, *number; /* of PAIR */
	const struct ts_arg *row;	      /* the coefficient in the table of pair_coeff */
	double *first;			      /* [ntypes + 1][ntypes + 1], original coefficients */
};

struct state {
	int64_t every;
	struct ts_words words;
	bool scale, reset, mass;
	struct change change[MAX_CHANGES];
	size_t n, column;
	struct ts_number_or_peratom now;
	double *first; /* saved: original coefficients of all changes */
	size_t first_n, first_capacity;
	int64_t applied,
		epoch; /* saved; a new epoch changes the fingerprint, so that forces are computed again */
};

static enum ts_status fail_expected(struct tsim *sim, const struct ts_instance *self,
				    const struct ts_word *word, const char *what)
{
	return ts_fail(&sim->error, TS_SYNTAX, word ? &word->place : &self->where,
		       "fix adapt: found '%s', expected %s", word ? word->text : "the end of the line", what);
}

static const struct ts_word *next_word(struct ts_words *words)
{
	const struct ts_word *word = words->n ? &words->word[0] : NULL;

	*words = ts_words_from(*words, 1);
	return word;
}

static enum ts_status read_variable(struct ts_instance *self, struct tsim *sim, struct ts_words *words,
				    struct change *c)
{
	const struct ts_word *word = next_word(words);
	const char *name = word && word->text[0] == 'v' && word->text[1] == '_' ? word->text + 2 : NULL;
	struct ts_suggest suggest = ts_suggest_start(name ? name : "");

	if (!name)
		return fail_expected(sim, self, word, "v_NAME");
	c->value.variable = name;
	if (sim->script_api && sim->script_api->has_variable(sim->script_api_data, name))
		return TS_OK;
	if (sim->script_api)
		sim->script_api->suggest_variable(sim->script_api_data, &suggest);
	return ts_missing(&sim->error, "variable", name, &word->place, "fix adapt: unknown variable '%s'%s",
			  name, ts_suggest_text(&suggest));
}

/* atom diameter|density|mass v_NAME */
static enum ts_status read_atom_change(struct ts_instance *self, struct tsim *sim, struct ts_words *words,
				       struct change *c)
{
	static const char *const names[] = { "diameter", "density", "mass" };
	const struct ts_word *word = next_word(words);

	for (c->what = 0; c->what < PAIR; c->what++)
		if (word && ts_streq(word->text, names[c->what]))
			return read_variable(self, sim, words, c);
	return fail_expected(sim, self, word, "diameter, density or mass");
}

static enum ts_status read_types(struct ts_instance *self, struct tsim *sim, struct ts_words *words,
				 struct ts_types *types)
{
	const struct ts_word *word = next_word(words);

	if (!word || !ts_parse_types(word->text, types) ||
	    (types->hi ? types->hi : types->lo) > sim->particles->ntypes)
		return fail_expected(sim, self, word, "a type of particles or a range such as 1*2");
	if (!types->hi)
		types->hi = sim->particles->ntypes;
	return TS_OK;
}

/* pair STYLE NUMBER I J v_NAME */
static enum ts_status read_pair_change(struct ts_instance *self, struct tsim *sim, struct ts_words *words,
				       struct change *c)
{
	c->what = PAIR;
	c->style = next_word(words);
	c->number = next_word(words);
	if (!c->number)
		return fail_expected(sim, self, NULL, "pair STYLE NUMBER I J v_NAME");
	TS_TRY(read_types(self, sim, words, &c->a));
	TS_TRY(read_types(self, sim, words, &c->b));
	return read_variable(self, sim, words, c);
}

static enum ts_status read_changes(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	struct ts_words words = s->words;

	while (words.n) {
		const struct ts_word *word = next_word(&words);
		struct change *c = &s->change[s->n];

		if (s->n++ == MAX_CHANGES)
			return fail_expected(sim, self, word, "at most 8 changes");
		if (ts_streq(word->text, "atom"))
			TS_TRY(read_atom_change(self, sim, &words, c));
		else if (ts_streq(word->text, "pair"))
			TS_TRY(read_pair_change(self, sim, &words, c));
		else
			return fail_expected(sim, self, word, "atom or pair");
	}
	return TS_OK;
}

/* Whether pair_coeff has given all coefficients that the fix changes: it may follow the fix. */
static bool all_given(const struct state *s, const struct tsim *sim)
{
	for (size_t k = 0; k < s->n; k++) {
		const struct change *c = &s->change[k];

		for (int a = c->a.lo; c->what == PAIR && a <= c->a.hi; a++)
			for (int b = c->b.lo; b <= c->b.hi; b++)
				if (!ts_pair_given(sim, a, b))
					return false;
	}
	return true;
}

/* Stores the coefficients as they are when the fix is defined, or in the first run if they are given later: an
 * array of pairs of types for each change. */
static enum ts_status store_first_coefficients(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	size_t types = (size_t)sim->particles->ntypes + 1, room = types * types;
	bool fresh = s->first_n == 0;

	for (size_t k = 0; k < s->n; k++)
		if (s->change[k].what == PAIR)
			TS_TRY(ts_pair_row(sim, s->change[k].style, s->change[k].number, &s->change[k].row));
	if (fresh && !all_given(s, sim))
		return TS_OK;
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

static void store_new_sizes(const struct state *s, const struct tsim *sim)
{
	for (size_t i = 0; i < sim->particles->n; i++)
		ts_first_size_note(sim, s->column, i);
}

static enum ts_status init_changes(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	TS_TRY(read_changes(self, sim));
	TS_TRY(ts_first_size_start(sim, self, &s->column));
	store_new_sizes(s, sim);
	return TS_OK;
}

static bool changes_particles(const struct state *s)
{
	for (size_t k = 0; k < s->n; k++)
		if (s->change[k].what != PAIR)
			return true;
	return false;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	if (!s->n)
		TS_TRY(init_changes(self, sim));
	if (changes_particles(s))
		TS_TRY(ts_rigid_refuse_resizing(sim, self->group, "fix adapt", &self->where));
	if (!s->applied)
		s->epoch++;
	return store_first_coefficients(self, sim);
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

static enum ts_status apply_particle_change(struct ts_instance *self, struct tsim *sim,
					    const struct change *c)
{
	struct state *s = self->state;
	const struct ts_particles *p = sim->particles;

	TS_TRY(ts_rigid_refuse_resizing(sim, self->group, "fix adapt", &self->where));
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

static enum ts_status apply_pair_change(struct ts_instance *self, struct tsim *sim, const struct change *c)
{
	const struct state *s = self->state;
	size_t types = (size_t)sim->particles->ntypes + 1;
	double value;

	if (!s->first_n)
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "fix adapt changes coefficients of types that no pair_coeff has given");
	TS_TRY(ts_number_now(sim, &c->value, &self->where, &value));
	for (int a = c->a.lo; a <= c->a.hi; a++)
		for (int b = c->b.lo; b <= c->b.hi; b++) {
			double first = c->first[(size_t)a * types + (size_t)b];

			TS_TRY(ts_pair_set_number(sim, c->row, a, b, s->scale ? value * first : value,
						  &self->where));
		}
	return TS_OK;
}

static enum ts_status apply_changes(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	store_new_sizes(s, sim);
	for (size_t k = 0; k < s->n; k++)
		TS_TRY(s->change[k].what == PAIR ? apply_pair_change(self, sim, &s->change[k])
						 : apply_particle_change(self, sim, &s->change[k]));
	s->applied = 1;
	return TS_OK;
}

/* Before the contact list is built, which depends on the new sizes. */
static enum ts_status post_integrate(struct ts_instance *self, struct tsim *sim)
{
	const struct state *s = self->state;

	if (sim->clock.step % s->every != 0)
		return TS_OK;
	sim->run.rebuild = true;
	return apply_changes(self, sim);
}

/* Applies the changes at the start of the first run. */
static enum ts_status exchange(struct ts_instance *self, struct tsim *sim)
{
	const struct state *s = self->state;

	return s->applied ? TS_OK : apply_changes(self, sim);
}

static enum ts_status finish(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	struct ts_particles *p = sim->particles;
	size_t types = (size_t)p->ntypes + 1;

	if (!s->reset || !s->applied)
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

/* Saves the present coefficients: the script that reads the restart file sets the original ones. */
static enum ts_status archive_coefficients(struct ts_instance *self, struct tsim *sim, const struct change *c,
					   struct ts_archive *a, const char *name)
{
	const struct state *s = self->state;
	size_t types = (size_t)sim->particles->ntypes + 1, n = types * types;
	double *now = ts_alloc(n, sizeof *now);
	enum ts_status status;

	if (!ts_sim_only(sim, TS_KIND_PAIR)) {
		ts_free(now);
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "fix adapt: the pair style whose coefficients it changes has been deleted");
	}
	if (!now)
		return ts_nomem(&sim->error);
	for (int i = c->a.lo; i <= c->a.hi; i++)
		for (int j = c->b.lo; j <= c->b.hi; j++)
			now[(size_t)i * types + (size_t)j] = ts_pair_number(sim, c->row, i, j);
	status = ts_archive_fixed(a, name, TS_SAVED_F64, now, n);
	for (int i = c->a.lo; s->applied && !ts_archive_writing(a) && status == TS_OK && i <= c->a.hi; i++)
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
			TS_TRY(archive_coefficients(self, sim, &s->change[k], a, name));
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
	/* the first change has three words, one of which may be the keyword `mass` */
	TS_LIST_STATEFUL("changes", struct state, words, .least = 3,
			 .help = "one or more of atom diameter|density|mass v_NAME and pair STYLE NUMBER I J "
				 "v_NAME; `atom mass` comes first"),
	TS_BOOL("scale", struct state, scale, .flags = TS_STATEFUL, .fallback = "no",
		.help = "the variables are factors of the values at the time when the fix was defined; of "
			"coefficients given later: of those at the first run"),
	TS_BOOL("reset", struct state, reset, .fallback = "no",
		.help = "restore the values of that time at the end of each run"),
	TS_BOOL("mass", struct state, mass, .fallback = "yes",
		.help = "a change of the diameter changes the mass at constant density; no: the mass is "
			"kept"),
	TS_ARGS_END,
};

static const struct ts_saved saved[] = {
	TS_SAVE_I64(struct state, applied),
	TS_SAVE_I64(struct state, epoch),
	TS_SAVED_ROWS_END,
};

static bool is_due(const struct ts_instance *self, const struct tsim *sim)
{
	const struct state *s = self->state;

	return sim->clock.step % s->every == 0;
}

TS_STYLE(fix, ts_style, ts_fix_adapt)
const struct ts_style ts_fix_adapt = {
	.name = "adapt",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_STEPS,
	.due = is_due,
	.summary = "Changes properties of particles or coefficients of contacts during a run",
	.doc = "At the start of the first run, and in each step that is a multiple of N, the variables are "
	       "evaluated and assigned: to the diameter, density or mass of the particles in the group, or to "
	       "a number of `pair_coeff` for all pairs of the types I and J.\n\n"
	       "With `scale yes` a variable is a factor of the value at the time when the fix was defined, "
	       "however many runs there have been since. With `mass no` a change of the diameter keeps the "
	       "mass. Members of rigid bodies, whose mass and inertia would not follow, are an error, except for "
	       "changes of pair_coeff.\n\n"
	       "The stability limit of the time step is checked only at the start of a run.",
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
