/* Compute quantile: d10, d50, d90 and other quantiles of a value of the particles. */
#include "core/ref_list.h"
#include "math/weighted_quantile.h"
#include "particle/weight.h"

#include "base/banned.h"

struct state {
	const char *name; /* of the value, as written */
	struct ts_words words;
	int weight;

	double *part; /* the quantiles wanted, 0 to 1 */
	struct ts_ref_input value;
	struct ts_table each;
	struct ts_weighted *number;
	size_t capacity;
	struct tsim *sim;
};

static enum ts_status read_parts(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	s->part = ts_arena_alloc(&self->arena, s->words.n, sizeof *s->part);
	if (!s->part)
		return ts_nomem(&sim->error);
	for (size_t k = 0; k < s->words.n; k++) {
		const struct ts_word *word = &s->words.word[k];

		if (!ts_parse_real(word->text, &s->part[k]) || !(s->part[k] >= 0 && s->part[k] <= 1))
			return ts_fail(&sim->error, TS_SYNTAX, &word->place,
				       "compute quantile: expected a part from 0 to 1, such as 0.5 of the "
				       "median, found '%s'",
				       word->text);
	}
	return TS_OK;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	s->sim = sim;
	s->value.name = s->name;
	s->value.where = *ts_instance_word(self, s->name);
	TS_TRY(ts_ref_input_resolve(sim, "compute quantile", TS_WANT(PERATOM), &s->value));
	return s->part ? TS_OK : read_parts(self, sim);
}

/* Lists the values of the group's particles, sorted. */
static enum ts_status list_numbers(struct ts_instance *self, size_t *n)
{
	struct state *s = self->state;
	const struct ts_particles *p = s->sim->particles;

	TS_TRY(ts_ref_input_eval(s->sim, &s->value, &s->each));
	if (TS_GROW(s->number, s->capacity, p->n + 1) != TS_OK)
		return ts_nomem(&s->sim->error);
	*n = 0;
	for (size_t i = 0; i < p->n; i++) {
		struct ts_weighted number = { s->each.data[i],
					      ts_particle_weight(s->sim, (enum ts_weight)s->weight, i) };

		if (!ts_in_group(p, i, self->group) || !(number.weight > 0))
			continue;
		if (isnan(number.value))
			return ts_fail(&s->sim->error, TS_STATE, &self->where,
				       "compute quantile: '%s' of particle %d is not a number", s->name,
				       (int)p->tag[i]);
		s->number[(*n)++] = number;
	}
	ts_weighted_sort(s->number, *n);
	return TS_OK;
}

static enum ts_status eval_count(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	size_t n;

	(void)sim;
	TS_TRY(list_numbers(self, &n));
	out->data[0] = (double)n;
	return TS_OK;
}

static enum ts_status eval_quantiles(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct state *s = self->state;
	size_t n;

	(void)sim;
	TS_TRY(list_numbers(self, &n));
	TS_TRY(ts_table_resize(out, s->words.n, 1));
	for (size_t k = 0; k < s->words.n; k++)
		out->data[k] = ts_weighted_quantile(s->number, n, s->part[k]);
	return TS_OK;
}

static void fini(struct ts_instance *self)
{
	struct state *s = self->state;

	ts_table_release(&s->each);
	ts_free(s->number);
}

static size_t width(const struct ts_instance *self)
{
	return ((const struct state *)self->state)->words.n;
}

static const struct ts_value values[] = {
	{ "count", "", "number of particles", TS_SCALAR, 1, NULL, eval_count },
	{ "quantiles", "", "the quantiles, in the order given; 0 without particles", TS_VECTOR, 0, NULL,
	  eval_quantiles },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_WORD("value", struct state, name, .flags = TS_POSITIONAL,
		.help = "a number of each particle: diameter, mass, vz, c_ID, c_ID[k], f_ID, v_name ..."),
	TS_LIST("parts", struct state, words, .help = "one or more numbers from 0 to 1: 0.1 0.5 0.9"),
	TS_ENUM("weight", struct state, weight, ts_weight_names, .fallback = "number",
		.help = "what the particles are counted by"),
	TS_ARGS_END,
};

TS_STYLE(compute, ts_style, ts_compute_quantile)
const struct ts_style ts_compute_quantile = {
	.name = "quantile",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.summary = "Quantiles of a per-particle value, such as d10, d50 and d90 of a grain size",
	.doc = "The quantile q of a value is the smallest one up to which the particles of the group make up "
	       "more than the part q of the whole, by number, mass or volume. With `diameter` and `weight "
	       "mass` these are the sizes d10, d50 and d90 of a sieve curve. Where the particles up to one "
	       "make up exactly q, it is the mean of this and the next greater value, as in the median of an "
	       "even number. 0 is the least and 1 the greatest value. They are values of the particles and "
	       "not interpolated between classes: no bins need be chosen, as for fix ave/histo.\n\n"
	       "Results do not depend on the order of the particles. Particles of weight 0 do not count. "
	       "c_ID is the number of particles that do; where there are none, all quantiles are 0.",
	.example = "compute d all quantile diameter 0.1 0.5 0.9 weight mass\n"
		   "thermo_style custom step atoms c_d[1] c_d[2] c_d[3]\n"
		   "variable span equal (c_d[3]-c_d[1])/c_d[2]\n"
		   "compute fast all quantile c_speed 0.99",
	.cite = "R. J. Hyndman, Y. Fan, Am. Stat. 50 (1996) 361, definition 2",
	.args = args,
	.state_size = sizeof(struct state),
	.values = values,
	.width = width,
	.init = init,
	.fini = fini,
};
