/* Compute rdf: radial distribution function. */
#include "box/domain.h"
#include "geom/pairs.h"
#include "math/constants.h"
#include "particle/particles.h"

#include <math.h>

#include "base/banned.h"

struct pair_of_types {
	struct ts_types a, b;
};

struct rdf {
	int64_t bins;
	struct ts_words words;
	double cutoff; /* length; NaN: twice the largest radius */
	struct pair_of_types *pair;
	size_t npairs;
	double *count; /* by bin and pair of types: number of ordered pairs */
	size_t capacity;
	struct tsim *sim;
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	static const struct ts_arg rows[] = {
		TS_TYPES("itype", struct pair_of_types, a, .flags = TS_POSITIONAL,
			 .help = "types of the central particles"),
		TS_TYPES("jtype", struct pair_of_types, b, .flags = TS_POSITIONAL,
			 .help = "types of their partners"),
		TS_ARGS_END,
	};
	struct rdf *s = self->state;

	s->sim = sim;
	if (s->pair)
		return TS_OK;
	s->npairs = s->words.n ? (s->words.n + 1) / 2 : 1;
	s->pair = ts_arena_alloc(&self->arena, s->npairs, sizeof *s->pair);
	if (!s->pair)
		return ts_nomem(&sim->error);
	for (size_t k = 0; k < s->words.n; k += 2) {
		struct ts_words two = { s->words.word + k, s->words.n - k < 2 ? 1 : 2 };

		TS_TRY(ts_args_parse(sim, "compute rdf", rows, two, &s->words.word[k].place, &self->arena,
				     &s->pair[k / 2]));
		TS_TRY(ts_particles_require_types(sim, "compute rdf", &s->pair[k / 2].a, &two.word[0].place));
		TS_TRY(ts_particles_require_types(sim, "compute rdf", &s->pair[k / 2].b, &two.word[1].place));
	}
	return TS_OK;
}

static bool type_matches(const struct ts_types *types, int type)
{
	return type >= types->lo && (!types->hi || type <= types->hi);
}

struct task {
	const struct ts_instance *self;
	const struct ts_particles *p;
	double cutoff;
};

static void count_pair(void *context, size_t i, size_t j, const double d[3])
{
	const struct task *t = context;
	const struct rdf *s = t->self->state;
	double r = sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
	int64_t bin = (int64_t)(r / t->cutoff * (double)s->bins);

	if (bin >= s->bins || !ts_in_group(t->p, i, t->self->group) || !ts_in_group(t->p, j, t->self->group))
		return;
	for (size_t k = 0; k < s->npairs; k++)
		s->count[(size_t)bin * s->npairs + k] += type_matches(&s->pair[k].a, t->p->type[i]) &&
							 type_matches(&s->pair[k].b, t->p->type[j]);
}

/* Number of central particles (the first types), and mean number of other particles of the second types for
 * each. */
static void count_populations(const struct ts_instance *self, const struct ts_particles *p, size_t pair,
			      double *centres, double *others)
{
	const struct rdf *s = self->state;
	double around = 0, both = 0;

	*centres = 0;
	for (size_t i = 0; i < p->n; i++) {
		bool a, b;

		if (!ts_in_group(p, i, self->group))
			continue;
		a = type_matches(&s->pair[pair].a, p->type[i]);
		b = type_matches(&s->pair[pair].b, p->type[i]);
		*centres += a;
		around += b;
		both += a && b;
	}
	*others = *centres > 0 ? around - both / *centres : 0;
}

/* Fraction of the volume of the box (in 2d its area) between two radii. */
static double shell_fraction(const struct tsim *sim, double inner, double outer)
{
	double box = 1;

	for (int d = 0; d < sim->dimension; d++)
		box *= ts_box_length(&sim->domain->box, d);
	if (sim->dimension == 2)
		return TS_PI * (outer * outer - inner * inner) / box;
	return 4 * TS_PI / 3 * (outer * outer * outer - inner * inner * inner) / box;
}

static void fill_table(const struct ts_instance *self, const struct tsim *sim, double cutoff,
		       struct ts_table *out)
{
	const struct rdf *s = self->state;
	double width = cutoff / (double)s->bins;

	for (size_t b = 0; b < (size_t)s->bins; b++)
		out->data[b * out->columns] = ((double)b + 0.5) * width;
	for (size_t k = 0; k < s->npairs; k++) {
		double centres, others, within = 0;

		count_populations(self, sim->particles, k, &centres, &others);
		for (size_t b = 0; b < (size_t)s->bins; b++) {
			double *row = out->data + b * out->columns + 1 + 2 * k;
			double counted = s->count[b * s->npairs + k];
			double expected = shell_fraction(sim, (double)b * width, (double)(b + 1) * width) *
					  others * centres;

			within += counted;
			row[0] = expected > 0 ? counted / expected : 0;
			row[1] = centres > 0 ? within / centres : 0;
		}
	}
}

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	struct rdf *s = self->state;
	const struct ts_particles *p = sim->particles;
	size_t numbers = (size_t)s->bins * s->npairs;
	struct task task = { self, p, s->cutoff };

	TS_TRY(ts_table_resize(out, (size_t)s->bins, 1 + 2 * s->npairs));
	TS_TRY(TS_GROW(s->count, s->capacity, numbers));
	for (size_t k = 0; k < numbers; k++)
		s->count[k] = 0;
	if (isnan(task.cutoff)) {
		task.cutoff = 0;
		for (size_t i = 0; i < p->n; i++)
			task.cutoff = fmax(task.cutoff, 2 * p->radius[i]);
	}
	if (task.cutoff > 0)
		TS_TRY(ts_pairs_visit(&sim->domain->box, sim->dimension, (const double(*)[3])p->x, p->n,
				      task.cutoff, count_pair, &task));
	fill_table(self, sim, task.cutoff, out);
	return TS_OK;
}

static void fini(struct ts_instance *self)
{
	ts_free(((struct rdf *)self->state)->count);
}

static size_t width(const struct ts_instance *self)
{
	return 1 + 2 * ((const struct rdf *)self->state)->npairs;
}

static const struct ts_value values[] = {
	{ "rdf", "",
	  "a row for each bin: its middle, then g and the coordination number for each pair of types",
	  TS_ARRAY, 0, NULL, eval },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_INT("Nbin", struct rdf, bins, .flags = TS_POSITIONAL, .range = TS_WITHIN, .lo = 1, .hi = 1e7,
	       .help = "number of bins from 0 to the cutoff"),
	{ .name = "types",
	  .type = TS_ARG_REST,
	  .flags = TS_POSITIONAL | TS_OPTIONAL | TS_TO_KEYWORD,
	  .offset = TS_FIELD(struct rdf, words, struct ts_words *),
	  .help = "pairs itype jtype of types, one g for each; none: * *" },
	TS_REAL("cutoff", struct rdf, cutoff, .flags = TS_OPTIONAL, .range = TS_POSITIVE, .unit = "length",
		.help = "largest distance; default: twice the largest radius"),
	TS_ARGS_END,
};

TS_STYLE(compute, ts_style, ts_compute_rdf)
const struct ts_style ts_compute_rdf = {
	.name = "rdf",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.summary = "Radial distribution function",
	.doc = "A table with a row for each of Nbin distances. c_ID[i][1] is the middle r of bin i; two "
	       "columns follow for each pair of types:\n\n"
	       "    g(r) = V n(r) / (4/3 pi (r_o^3 - r_i^3) N_i N_j'),  coord(r) = sum n(r') / N_i, r' <= "
	       "r\n\n"
	       "n(r) is the number of ordered pairs i, j of the group whose distance is in the bin, from r_i "
	       "to r_o, N_i the number of particles of the first types, N_j' that of the second types "
	       "without the central particle itself, V the volume of the box. In two dimensions pi (r_o^2 - "
	       "r_i^2) and the area take the place of the volumes. Periodic images count, also beyond half "
	       "the box; there is no correction for fixed faces. Average it with fix ave/time mode vector.",
	.example = "compute g all rdf 100 cutoff 0.03\n"
		   "compute g2 all rdf 100 1 1 1 2 cutoff 0.03\n"
		   "fix mean all ave/time 100 10 1000 c_g[*] mode vector file post/rdf.txt",
	.args = args,
	.state_size = sizeof(struct rdf),
	.values = values,
	.width = width,
	.init = init,
	.fini = fini,
};
