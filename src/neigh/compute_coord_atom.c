/* Compute coord/atom: coordination numbers within a cutoff. */
#include "box/domain.h"
#include "geom/pairs.h"
#include "neigh/neigh.h"
#include "particle/particles.h"

#include "base/banned.h"

struct coord {
	struct ts_words words;
	double cutoff;
	bool same; /* only partners of the same type count */
	int with;
	struct ts_types *types; /* type range of each column */
	size_t ncolumns;
	struct tsim *sim;
};

/* Parser state: the words not yet read. */
struct reader {
	struct ts_instance *self;
	struct tsim *sim;
	struct ts_words rest;
};

static bool next_is(struct reader *r, const char *text)
{
	if (!r->rest.n || !ts_streq(r->rest.word[0].text, text))
		return false;
	r->rest = ts_words_from(r->rest, 1);
	return true;
}

static enum ts_status read_cutoff(struct reader *r)
{
	struct coord *s = r->self->state;
	const struct ts_word *word = r->rest.word;

	(void)next_is(r, "cutoff");
	word = r->rest.word;
	if (!r->rest.n || !ts_parse_real(word->text, &s->cutoff) || !(s->cutoff > 0))
		return ts_fail(&r->sim->error, TS_SYNTAX, r->rest.n ? &word->place : &r->self->where,
			       "compute coord/atom: expected a cutoff > 0");
	r->rest = ts_words_from(r->rest, 1);
	return TS_OK;
}

static enum ts_status read_types(struct reader *r)
{
	static const struct ts_arg row[] = {
		TS_TYPES(
			"type", struct { struct ts_types types; }, types, .flags = TS_POSITIONAL,
			.help = "types of the partners"),
		TS_ARGS_END,
	};
	struct coord *s = r->self->state;
	size_t n = r->rest.n ? r->rest.n : 1;

	s->ncolumns = n;
	s->types = ts_arena_alloc(&r->self->arena, n, sizeof *s->types);
	if (!s->types)
		return ts_nomem(&r->sim->error);
	for (size_t k = 0; k < r->rest.n; k++) {
		const struct ts_place *where = &r->rest.word[k].place;

		TS_TRY(ts_args_parse(r->sim, "compute coord/atom", row,
				     (struct ts_words){ r->rest.word + k, 1 }, where, &r->self->arena,
				     &s->types[k]));
		TS_TRY(ts_particles_require_types(r->sim, "compute coord/atom", &s->types[k], where));
	}
	return TS_OK;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct coord *s = self->state;
	struct reader r = { self, sim, s->words };

	s->sim = sim;
	if (s->types)
		return TS_OK;
	TS_TRY(read_cutoff(&r));
	if (next_is(&r, "group")) {
		if (!r.rest.n)
			return ts_fail(&sim->error, TS_SYNTAX, &self->where,
				       "compute coord/atom: expected the name of a group");
		TS_TRY(ts_group_require(sim, r.rest.word, &s->with));
		r.rest = ts_words_from(r.rest, 1);
	}
	if (next_is(&r, "mix"))
		s->same = !next_is(&r, "no");
	(void)next_is(&r, "yes");
	return read_types(&r);
}

struct task {
	const struct tsim *sim;
	const struct ts_particles *p;
	const struct coord *s;
	ts_excluded_fn *excluded; /* NULL: no pair is */
	double *count;
	int group;
};

static void count_partner(void *context, size_t i, size_t j, const double d[3])
{
	const struct task *t = context;
	const struct coord *s = t->s;
	int type = t->p->type[j];

	if (!ts_in_group(t->p, i, t->group) || !ts_in_group(t->p, j, s->with) ||
	    (s->same && type != t->p->type[i]) || (t->excluded && t->excluded(t->sim, i, j, d)))
		return;
	for (size_t k = 0; k < s->ncolumns; k++)
		t->count[i * s->ncolumns + k] +=
			type >= s->types[k].lo && (!s->types[k].hi || type <= s->types[k].hi);
}

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	struct coord *s = self->state;
	const struct ts_particles *p = sim->particles;
	struct task task = {
		.sim = sim, .p = p, .s = s, .excluded = ts_neigh_excluded(sim), .group = self->group
	};

	TS_TRY(ts_table_resize(out, p->n, s->ncolumns));
	task.count = out->data;
	for (size_t k = 0; k < p->n * s->ncolumns; k++)
		out->data[k] = 0;
	return ts_pairs_visit(&sim->domain->box, sim->dimension, (const double(*)[3])p->x, p->n, s->cutoff,
			      count_partner, &task);
}

static size_t width(const struct ts_instance *self)
{
	return ((const struct coord *)self->state)->ncolumns;
}

static const struct ts_value values[] = {
	{ "neighbours", "", "number of particles within the cutoff; 0 outside the group", TS_PERATOM, 0, NULL,
	  eval },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_REST("cutoff", struct coord, words, .unit = "length",
		.help = "[cutoff] R [group NAME] [mix yes|no] [types ...]"),
	TS_ARGS_END,
};

TS_STYLE(compute, ts_style, ts_compute_coord_atom)
const struct ts_style ts_compute_coord_atom = {
	.name = "coord/atom",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.summary = "Number of particles within a cutoff of each particle",
	.doc = "Counts, for each particle of the group, the other particles whose centres are nearer than R "
	       "(length). With types (n, *, n*m ...) the output has a column for each, which counts "
	       "partners of these types. With `mix yes` only partners of the particle's own type count; "
	       "with `group` only those of that group. Pairs excluded by neigh_modify, special_bonds or a "
	       "common rigid body do not count, as in LAMMPS. R may have any value: beyond half a periodic "
	       "box several images of a particle count. `cutoff` before R is LAMMPS' spelling.",
	.example = "compute near all coord/atom 0.012\ncompute kinds all coord/atom cutoff 0.012 1 2*3",
	.args = args,
	.state_size = sizeof(struct coord),
	.values = values,
	.width = width,
	.init = init,
};
