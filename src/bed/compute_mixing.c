/* Compute mixing: indices of mixing from the concentrations in samples. */
#include <math.h>

#include "average/chunk.h"
#include "bed/mixing_samples.h"
#include "particle/group_moments.h"
#include "particle/particles.h"

#include "base/banned.h"

struct state {
	struct ts_component component;
	int index, weight;
	const char *chunks; /* id of a compute chunk/atom; NULL: cells */
	double cell, origin[3];
	int64_t least;

	struct ts_mixing_member *member;
	struct ts_mixing_sample *sample;
	size_t member_capacity, sample_capacity;
};

enum index { LACEY, KRAMER, POOLE, RSD, INTENSITY };
static const char *const indices[] = { "lacey", "kramer", "poole", "rsd", "intensity", NULL };

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	struct ts_instance *owner;
	struct ts_chunks *chunks;

	if ((s->chunks != NULL) == (s->cell > 0))
		return ts_fail(&sim->error, TS_SYNTAX, &self->where,
			       "compute mixing: expected either `chunks ID`, of a compute chunk/atom, or "
			       "`cell D`, the edge length of cubic samples");
	if (s->chunks)
		TS_TRY(ts_chunks_find(sim, self, s->chunks, &owner, &chunks));
	return ts_component_init(self, sim);
}

/* Lists the particles of the group that are in a sample; *nchunks: number of chunks, or 0 for cells. */
static enum ts_status list_members(struct ts_instance *self, size_t *n, size_t *nchunks)
{
	struct state *s = self->state;
	struct tsim *sim = s->component.sim;
	const struct ts_particles *p = sim->particles;
	struct ts_instance *owner;
	struct ts_chunks *chunks = NULL;

	if (s->chunks) {
		TS_TRY(ts_chunks_find(sim, self, s->chunks, &owner, &chunks));
		TS_TRY(ts_chunks_assign(owner, chunks, TS_CHUNK_NO_SAMPLE));
	}
	*n = 0;
	*nchunks = chunks ? chunks->n : 0;
	if (TS_GROW(s->member, s->member_capacity, p->n + 1) != TS_OK ||
	    TS_GROW(s->sample, s->sample_capacity, p->n + 1) != TS_OK)
		return ts_nomem(&sim->error);
	for (size_t i = 0; i < p->n; i++) {
		struct ts_mixing_member m = { .tag = p->tag[i], .row = (int32_t)i };
		double x[3];
		int32_t image[3];

		if (!ts_in_group(p, i, self->group) || (chunks && chunks->id[i] == 0))
			continue;
		if (chunks)
			m.key[0] = chunks->id[i];
		ts_wrapped(sim, i, x, image);
		for (int d = 0; !chunks && d < sim->dimension; d++)
			m.key[d] = floor((x[d] - s->origin[d]) / s->cell);
		s->member[(*n)++] = m;
	}
	return TS_OK;
}

static enum ts_status take_samples(struct ts_instance *self, size_t *nsamples, size_t *nchunks,
				   struct ts_mixing_statistics *out)
{
	struct state *s = self->state;
	size_t n;

	TS_TRY(ts_component_update(self));
	TS_TRY(list_members(self, &n, nchunks));
	ts_mixing_sort(s->member, n);
	ts_mixing_tally(&s->component, (enum ts_weight)s->weight, s->member, n, (size_t)s->least, s->sample,
			nsamples, out);
	return TS_OK;
}

static double index_of(enum index index, const struct ts_mixing_statistics *m)
{
	if (index == RSD)
		return m->mean > 0 ? sqrt(m->variance) / m->mean : 0;
	if (index == INTENSITY)
		return m->segregated > 0 ? m->variance / m->segregated : 0;
	if (!m->defined)
		return 0;
	if (index == POOLE)
		return sqrt(m->variance / m->random);
	if (index == KRAMER)
		return (sqrt(m->segregated) - sqrt(m->variance)) / (sqrt(m->segregated) - sqrt(m->random));
	return (m->segregated - m->variance) / (m->segregated - m->random);
}

static enum ts_status eval_index(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	struct ts_mixing_statistics m;
	size_t nsamples, nchunks;

	(void)sim;
	TS_TRY(take_samples(self, &nsamples, &nchunks, &m));
	out->data[0] = index_of((enum index)((struct state *)self->state)->index, &m);
	return TS_OK;
}

static enum ts_status eval_statistics(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	struct ts_mixing_statistics m;
	size_t nsamples, nchunks;

	(void)sim;
	TS_TRY(take_samples(self, &nsamples, &nchunks, &m));
	out->data[0] = m.mean;
	out->data[1] = m.variance;
	out->data[2] = m.segregated;
	out->data[3] = m.random;
	out->data[4] = (double)m.samples;
	out->data[5] = (double)m.particles;
	return TS_OK;
}

/* The row of sample k: samples of chunks are rows of all chunks, cells are listed without empty ones. */
static size_t row_of(const struct ts_mixing_sample *sample, size_t k, size_t nchunks)
{
	return nchunks ? (size_t)sample[k].key[0] - 1 : k;
}

static enum ts_status eval_samples(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	enum { WIDTH = 3 };
	const struct state *s = self->state;
	struct ts_mixing_statistics m;
	size_t nsamples, nchunks;

	(void)sim;
	TS_TRY(take_samples(self, &nsamples, &nchunks, &m));
	TS_TRY(ts_table_resize(out, nchunks ? nchunks : nsamples, WIDTH));
	for (size_t k = 0; k < out->rows * WIDTH; k++)
		out->data[k] = 0;
	for (size_t k = 0; k < nsamples; k++) {
		double *row = out->data + WIDTH * row_of(s->sample, k, nchunks);

		row[0] = s->sample[k].concentration;
		row[1] = (double)s->sample[k].particles;
		row[2] = s->sample[k].weight;
	}
	return TS_OK;
}

static void fini(struct ts_instance *self)
{
	struct state *s = self->state;

	ts_component_fini(self);
	ts_free(s->member);
	ts_free(s->sample);
}

static const char *const statistics[] = { "mean",    "variance",  "segregated", "random",
					  "samples", "particles", NULL };
static const char *const columns[] = { "concentration", "particles", "weight", NULL };

static const struct ts_value values[] = {
	{ "index", "", "the index; 0 where it is not defined", TS_SCALAR, 1, NULL, eval_index },
	{ "statistics", "",
	  "concentration p; variance s^2 of the concentrations; s_0^2 of the segregated and s_r^2 of the "
	  "random mixture; number of samples, and of particles in them",
	  TS_VECTOR, 6, statistics, eval_statistics },
	{ "samples", "",
	  "a row for each chunk, or for each cell with particles (ordered by x, y, z): concentration, number "
	  "of particles, sum of their weights",
	  TS_ARRAY, 3, columns, eval_samples },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_ENUM("index", struct state, index, indices, .flags = TS_POSITIONAL, .help = "which index c_ID is"),
	TS_COMPONENT_ROW(struct state),
	TS_WORD("chunks", struct state, chunks, .flags = TS_OPTIONAL,
		.help = "ID of a compute chunk/atom: each chunk is a sample"),
	TS_REAL("cell", struct state, cell, .flags = TS_OPTIONAL, .range = TS_POSITIVE, .unit = "length",
		.help = "edge length of cubic cells, each of which is a sample (squares in two dimensions)"),
	TS_VEC3("origin", struct state, origin, .fallback = "0 0 0", .unit = "length",
		.help = "a corner of a cell"),
	TS_ENUM("weight", struct state, weight, ts_weight_names, .fallback = "number",
		.help = "what concentrations and sizes of samples are measured by"),
	TS_INT("least", struct state, least, .fallback = "1", .range = TS_POSITIVE,
	       .help = "samples of fewer particles are left out"),
	TS_ARGS_END,
};

TS_STYLE(compute, ts_style, ts_compute_mixing)
const struct ts_style ts_compute_mixing = {
	.name = "mixing",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.summary = "How well a component is mixed, from its concentration in samples",
	.doc = "The particles of the group are a mixture of a component and the rest. Samples are chunks or "
	       "cubic cells; c_k is the concentration of the component in sample k, by number, mass or "
	       "volume, W_k the size of the sample (number, mass, volume of its particles), p the "
	       "concentration in all samples. Samples count by their size, so that one at the surface or in "
	       "a corner with few particles counts little:\n\n"
	       "    s^2   = sum W_k (c_k - p)^2 / sum W_k\n"
	       "    s_0^2 = p (1 - p)                                   segregated\n"
	       "    s_r^2 = (K - 1)/(N - 1) <w^2 (b - p)^2>/<w>^2       random\n\n"
	       "with K samples, N particles, the weight w of a particle (1, its mass, its volume), b = 1 for "
	       "the component and 0 for the rest, <> the mean over the particles. The indices are\n\n"
	       "    lacey      (s_0^2 - s^2)/(s_0^2 - s_r^2)    0 segregated, 1 random\n"
	       "    kramer     (s_0 - s)/(s_0 - s_r)            0 segregated, 1 random\n"
	       "    poole      s/s_r                            > 1 segregated, 1 random\n"
	       "    rsd        s/p                              relative standard deviation\n"
	       "    intensity  s^2/s_0^2                        1 segregated, 0 uniform (Danckwerts)\n\n"
	       "Slices along an axis (bin/1d) as chunks make `intensity` that of axial segregation, rings "
	       "(bin/cylinder) that of radial segregation. A random mixture scatters around the limit: lacey "
	       "exceeds 1 as often as it is below. A mixture more uniform than random, such as an ordered "
	       "one, has lacey > 1.",
	.doc_more =
		(const char *const[]){
			"s_r^2 is the mean of s^2 over all ways to place the particles: for w = 1 it is "
			"exact, (K - 1)/(N - 1) p (1 - p), the variance of sampling without replacement, and "
			"p (1 - p)/n for many samples of n particles (Lacey). For particles of unequal size "
			"it holds to first order in 1/n, and is for many samples the formula of Stange and "
			"of Poole, Taylor and Wall: p q (p w_q + q w_p)/W, with the effective weights w_p = "
			"sum w^2/sum w of the component, w_q of the rest, q = 1 - p. Published values with "
			"the variance sum (c_k - p)^2/(K - 1) differ by the order 1/K.",
			"The indices depend on the size of the samples; compare values of equal samples. "
			"Cells begin at `origin` and extend without end; those without particles are no "
			"samples. `least` leaves out small samples: their particles then do not count at "
			"all, neither for p. lacey, kramer and poole are 0 where they are not defined: "
			"without particles, with a single component, with a single sample, or if all samples "
			"have a single particle. intensity and rsd are 0 where p or 1 - p is 0. c_ID[5] is "
			"the number of samples, which tells.",
			NULL },
	.example = "compute m all mixing lacey type 1 cell 0.02\n"
		   "compute slices all chunk/atom bin/1d x lower 0.05 units box\n"
		   "compute axial all mixing intensity group red chunks slices weight mass\n"
		   "compute m all mixing lacey above radius 0.002 chunks bins least 5",
	.cite = "P. M. C. Lacey, J. Appl. Chem. 4 (1954) 257; K. R. Poole, R. F. Taylor, G. P. Wall, Trans. "
		"Inst. Chem. Eng. 42 (1964) T305; K. Stange, Chem. Ing. Tech. 26 (1954) 331; P. V. "
		"Danckwerts, Appl. Sci. Res. A 3 (1952) 279",
	.args = args,
	.state_size = sizeof(struct state),
	.values = values,
	.init = init,
	.fini = fini,
};
