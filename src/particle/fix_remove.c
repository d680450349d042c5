/* Fix remove: removes mass of particles at a given rate. */
#include <stdlib.h>

#include "base/sort.h"
#include "core/sim.h"
#include "group/chosen.h"
#include "math/rng.h"
#include "particle/columns.h"
#include "particle/sphere_shape.h"
#include "rigid/rigid.h"

#include "base/banned.h"

/* A particle of which mass may be removed. */
struct candidate {
	double number; /* random, uniform in (0, 1) */
	int32_t tag;
	size_t row;
};

struct state {
	/* arguments */
	int64_t every, seed, type;
	struct ts_number rate;
	const char *rate_variable;
	int mode;
	double min_radius; /* delete_below; NaN: not given */
	bool carry_error, verbose, compress;
	struct ts_instance *region;

	struct candidate *candidate; /* [n], of this event */
	size_t n, capacity;
	unsigned char *deleted;
	size_t deleted_capacity;
	bool due, begun;
	/* saved */
	double since;	   /* time of the last event */
	double owed, mass; /* mass still to be removed (< 0: too much was); mass removed so far */
	int64_t number;	   /* particles deleted so far */
};

enum { SHRINK, DELETE };
static const char *const modes[] = { "shrink", "delete", NULL };

static enum ts_status find_variable(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	struct ts_suggest suggest = ts_suggest_start(s->rate_variable);
	const struct ts_place *where = ts_instance_word(self, s->rate_variable);

	s->rate = (struct ts_number){ .variable = s->rate_variable };
	if (!sim->script_api || sim->script_api->has_variable(sim->script_api_data, s->rate_variable)) {
		s->rate_variable = NULL;
		return ts_number_check(sim, &s->rate, where);
	}
	sim->script_api->suggest_variable(sim->script_api_data, &suggest);
	return ts_missing(&sim->error, "variable", s->rate_variable, where,
			  "fix remove: unknown variable '%s'%s", s->rate_variable, ts_suggest_text(&suggest));
}

static bool is_candidate(const struct ts_instance *self, const struct ts_particles *p, size_t i)
{
	const struct state *s = self->state;

	return ts_chosen(p, i, self->group, s->region) && (s->type <= 0 || p->type[i] == s->type);
}

/* Updates the region, too. */
static enum ts_status refuse_members(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_particles *p = sim->particles;

	TS_TRY(ts_region_update(((struct state *)self->state)->region, sim));
	for (size_t i = 0; i < p->n; i++)
		if (ts_rigid_member(p, i) && is_candidate(self, p, i))
			return ts_fail(&sim->error, TS_STATE, &self->where,
				       "fix remove: particle %d belongs to a rigid body, which cannot lose "
				       "mass; give the fix a group without such particles",
				       p->tag[i]);
	return TS_OK;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	bool has_rate = s->rate.variable || !s->rate.null;

	if (has_rate == (s->rate_variable != NULL))
		return ts_fail(&sim->error, TS_SYNTAX, &self->where,
			       "fix remove: expected one of massrate, massratevariable, found %s",
			       has_rate ? "both" : "none");
	if (s->mode == SHRINK && isnan(s->min_radius))
		return ts_fail(&sim->error, TS_SYNTAX, ts_instance_word(self, "shrink"),
			       "fix remove: style shrink needs delete_below, the radius below which "
			       "particles are deleted");
	if (s->mode == DELETE && !isnan(s->min_radius))
		return ts_fail(&sim->error, TS_SYNTAX, ts_instance_word(self, "delete_below"),
			       "fix remove: delete_below has a meaning with style shrink only");
	if (s->type > sim->particles->ntypes)
		return ts_fail(&sim->error, TS_RANGE, ts_instance_word(self, "atomtype"),
			       "fix remove: atomtype is %d, and there are %d types", (int)s->type,
			       sim->particles->ntypes);
	if (s->rate_variable)
		TS_TRY(find_variable(self, sim));
	if (!s->begun)
		s->since = ts_sim_time(sim);
	s->begun = true;
	return refuse_members(self, sim);
}

/* ---- candidates ---- */

static int compare_candidates(const void *a, const void *b)
{
	const struct candidate *s = a, *t = b;

	if (s->number < t->number || s->number > t->number)
		return s->number < t->number ? -1 : 1;
	return (s->tag > t->tag) - (s->tag < t->tag);
}

/* Lists the candidates in random order: the random number of each is a function of seed, step and tag. */
static enum ts_status find_candidates(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	const struct ts_particles *p = sim->particles;

	TS_TRY(refuse_members(self, sim));
	if (TS_GROW(s->candidate, s->capacity, p->n) != TS_OK ||
	    TS_GROW(s->deleted, s->deleted_capacity, p->n) != TS_OK)
		return ts_nomem(&sim->error);
	s->n = 0;
	for (size_t i = 0; i < p->n; i++) {
		struct ts_rng rng = ts_rng_start((uint64_t)s->seed, (uint64_t)p->tag[i]);

		s->deleted[i] = 0;
		if (!is_candidate(self, p, i))
			continue;
		rng.counter = (uint64_t)sim->clock.step;
		s->candidate[s->n++] = (struct candidate){ ts_rng_uniform(&rng), p->tag[i], i };
	}
	ts_sort(s->candidate, s->n, sizeof *s->candidate, compare_candidates);
	return TS_OK;
}

/* ---- removal ---- */

static void account_mass(struct state *s, double mass)
{
	s->owed -= mass;
	s->mass += mass;
}

static void mark_deleted(struct state *s, const struct tsim *sim, size_t i)
{
	s->deleted[i] = 1;
	s->number++;
	account_mass(s, sim->particles->mass[i]);
}

/* Deletes particles until the mass due is reached; the last one may exceed it. With `integrated_error
 * yes` the excess is subtracted from the next event; else the last particle is deleted with the
 * probability (mass due) / (its mass), so that the mean rate is exact. */
static void delete_particles(struct ts_instance *self, const struct tsim *sim)
{
	struct state *s = self->state;

	for (size_t k = 0; k < s->n && s->owed > 0; k++) {
		size_t i = s->candidate[k].row;
		double mass = sim->particles->mass[i];
		struct ts_rng rng = ts_rng_start((uint64_t)s->seed, UINT64_MAX);

		rng.counter = (uint64_t)sim->clock.step;
		if (!s->carry_error && mass > s->owed && ts_rng_uniform(&rng) * mass > s->owed)
			return;
		mark_deleted(s, sim, i);
	}
}

/* Removes the same fraction of mass from each candidate, in their random order, so that the sum of masses
 * does not depend on the order in memory. */
static void shrink_particles(struct ts_instance *self, const struct tsim *sim)
{
	struct state *s = self->state;
	struct ts_particles *p = sim->particles;
	double sum = 0, keep, size;

	for (size_t k = 0; k < s->n; k++)
		sum += p->mass[s->candidate[k].row];
	if (!(s->owed > 0) || !(sum > 0))
		return;
	keep = s->owed < sum ? 1 - s->owed / sum : 0;
	size = sim->dimension == 2 ? sqrt(keep) : cbrt(keep);
	for (size_t k = 0; k < s->n; k++) {
		size_t i = s->candidate[k].row;

		if (size * p->radius[i] < s->min_radius || !(keep > 0)) {
			mark_deleted(s, sim, i);
			continue;
		}
		account_mass(s, (1 - keep) * p->mass[i]);
		p->mass[i] *= keep;
		p->radius[i] *= size;
		if (p->imass[i] > 0)
			p->imass[i] = 1 / p->mass[i];
	}
}

static enum ts_status add_due_mass(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	double rate, now = ts_sim_time(sim);

	TS_TRY(ts_number_now(sim, &s->rate, &self->where, &rate));
	if (!(rate >= 0) || !isfinite(rate))
		return ts_fail(&sim->error, TS_RANGE, &self->where,
			       "fix remove: the rate v_%s is %g, expected a mass per time >= 0",
			       s->rate.variable, rate);
	s->owed = (s->carry_error ? s->owed : 0) + rate * (now - s->since);
	s->since = now;
	return TS_OK;
}

static enum ts_status remove_mass(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	double mass = s->mass;
	int64_t number = s->number;

	TS_TRY(add_due_mass(self, sim));
	TS_TRY(find_candidates(self, sim));
	if (s->mode == DELETE)
		delete_particles(self, sim);
	else
		shrink_particles(self, sim);
	if (s->verbose)
		ts_log(&sim->log,
		       "fix remove %s: step %lld, mass %g removed, %lld particles deleted, %zu chosen from\n",
		       self->id, (long long)sim->clock.step, s->mass - mass, (long long)(s->number - number),
		       s->n);
	return s->number > number ? ts_particles_delete(sim, s->deleted) : TS_OK;
}

/* The contact list must be rebuilt if particles shrink or are deleted. */
static enum ts_status post_integrate(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	s->due = sim->clock.step % s->every == 0;
	sim->run.rebuild |= s->due;
	return TS_OK;
}

static enum ts_status exchange(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	bool due = s->due;

	s->due = false;
	return due ? remove_mass(self, sim) : TS_OK;
}

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct state *s = self->state;

	(void)sim;
	TS_TRY(ts_table_resize(out, 3, 1));
	out->data[0] = s->mass;
	out->data[1] = (double)s->number;
	out->data[2] = s->owed;
	return TS_OK;
}

static void fini(struct ts_instance *self)
{
	struct state *s = self->state;

	ts_free(s->candidate);
	ts_free(s->deleted);
}

static const struct ts_arg args[] = {
	TS_INT("nevery", struct state, every, .range = TS_WITHIN, .lo = 1, .hi = 1e15,
	       .help = "steps between events"),
	TS_NUMBER("massrate", struct state, rate, .flags = TS_OPTIONAL, .unit = "mass/time",
		  .range = TS_NOT_NEGATIVE, .help = "mass removed per time"),
	TS_WORD("massratevariable", struct state, rate_variable, .flags = TS_OPTIONAL,
		.help = "NAME of an equal-style variable for the rate; the same as massrate v_NAME"),
	TS_ENUM("style", struct state, mode, modes,
		.help = "shrink: all particles become smaller; delete: randomly chosen particles are "
			"deleted"),
	TS_REAL("delete_below", struct state, min_radius, .flags = TS_OPTIONAL, .unit = "length",
		.range = TS_NOT_NEGATIVE, .help = "style shrink: radius below which a particle is deleted"),
	TS_INT("seed", struct state, seed, .flags = TS_STATEFUL, .range = TS_POSITIVE,
	       .help = "seed of the random numbers"),
	TS_REGION_KEYWORD(struct state),
	TS_INT("atomtype", struct state, type, .fallback = "0", .range = TS_NOT_NEGATIVE,
	       .help = "only particles of this type; 0: of any type"),
	TS_BOOL("integrated_error", struct state, carry_error, .fallback = "yes", .flags = TS_STATEFUL,
		.help = "carry the difference between the mass removed and the mass due over to the next "
			"event"),
	TS_BOOL("verbose", struct state, verbose, .fallback = "no", .help = "print each event to the log"),
	TS_BOOL("compress", struct state, compress, .fallback = "no", .help = "no effect: atom IDs are kept"),
	TS_ARGS_END,
};

static const struct ts_value values[] = {
	{ "removed", "mass, 1, mass", "mass removed, particles deleted, mass still due", TS_VECTOR, 3, NULL,
	  eval },
	{ .name = NULL },
};

static const struct ts_saved saved[] = {
	TS_SAVE_F64(struct state, since),
	TS_SAVE_F64(struct state, owed),
	TS_SAVE_F64(struct state, mass),
	TS_SAVE_I64(struct state, number),
	TS_SAVED_ROWS_END,
};

static bool is_due(const struct ts_instance *self, const struct tsim *sim)
{
	const struct state *s = self->state;

	return sim->clock.step % s->every == 0;
}

TS_STYLE(fix, ts_style, ts_fix_remove)
const struct ts_style ts_fix_remove = {
	.name = "remove",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_STEPS,
	.due = is_due,
	.summary = "Removes mass of particles at a given rate",
	.doc = "In each step that is a multiple of nevery, mass is removed from the particles of the group "
	       "whose centres are in the region. The mass due is rate*t, where t is the time since the last "
	       "event, or since the fix was defined.\n\n"
	       "Style delete: randomly chosen particles are deleted until the mass due is reached; the last "
	       "one may exceed it. With `integrated_error yes` the excess, or the mass that could not be "
	       "removed for lack of particles, is carried over to the next event, so the total mass removed "
	       "differs from the integral of the rate by less than one particle. With `integrated_error no` "
	       "events are independent, and the last particle is deleted with the probability (remaining "
	       "mass due)/(mass of the particle), so that the mean rate is exact.\n\n"
	       "Style shrink: all particles lose the same fraction of their mass. With M the mass of all of "
	       "them,\n\n"
	       "    m' = m (1 - rate*t/M),   R' = R (m'/m)^(1/3)   (exponent 1/2 in two dimensions)\n\n"
	       "The density is kept. A particle that would become smaller than delete_below is deleted.\n\n"
	       "f_ID[1] is the mass removed, f_ID[2] the number of particles deleted, f_ID[3] the mass still "
	       "due (negative if too much was removed). Random numbers are functions of seed, step and atom "
	       "ID: results do not depend on the number of threads and are the same after a restart.\n\n"
	       "Particles of rigid bodies among them are an error, before a run if they are known then. The "
	       "fix exists in another edition of LIGGGHTS (PFM), which chooses other particles.",
	.example =
		"fix out all remove nevery 500 massrate 3.5 style delete seed 5143 region hole atomtype 1\n"
		"fix burn all remove nevery 500 massrate v_rate style shrink delete_below 0.001 seed 7543",
	.args = args,
	.state_size = sizeof(struct state),
	.saved = saved,
	.values = values,
	.init = init,
	.hook = { [TS_STAGE_POST_INTEGRATE] = post_integrate, [TS_STAGE_EXCHANGE] = exchange },
	.fini = fini,
};
