#include "bed/mixing_samples.h"

#include "base/sort.h"

#include "base/banned.h"

static int compare_keys(const double a[3], const double b[3])
{
	for (int k = 0; k < 3; k++)
		if (a[k] != b[k])
			return a[k] < b[k] ? -1 : 1;
	return 0;
}

static int compare_members(const void *a, const void *b)
{
	const struct ts_mixing_member *x = a, *y = b;
	int order = compare_keys(x->key, y->key);

	return order ? order : (x->tag > y->tag) - (x->tag < y->tag);
}

void ts_mixing_sort(struct ts_mixing_member *member, size_t n)
{
	ts_sort(member, n, sizeof *member, compare_members);
}

/* Sums over the samples that count: weights, and squares of weights, of the component [1] and of the rest [0]. */
struct sums {
	double weight[2], square[2];
};

/* The sample that begins with the first of n members; returns its number of particles. */
static size_t tally_sample(const struct ts_component *c, enum ts_weight weight,
			   const struct ts_mixing_member *member, size_t n, struct ts_mixing_sample *out,
			   struct sums *sums)
{
	size_t k = 0;

	*sums = (struct sums){ 0 };
	for (; k < n && compare_keys(member[k].key, member[0].key) == 0; k++) {
		double w = ts_particle_weight(c->sim, weight, (size_t)member[k].row);
		bool has = ts_component_has(c, (size_t)member[k].row);

		sums->weight[has] += w;
		sums->square[has] += w * w;
	}
	out->particles = k;
	out->weight = sums->weight[0] + sums->weight[1];
	out->concentration = out->weight > 0 ? sums->weight[1] / out->weight : 0;
	for (int d = 0; d < 3; d++)
		out->key[d] = member[0].key[d];
	return k;
}

static void enter_statistics(const struct sums *sums, const struct ts_mixing_sample *sample, size_t n,
			     size_t least, struct ts_mixing_statistics *out)
{
	double weight = sums->weight[0] + sums->weight[1], p, q, squares, N = (double)out->particles;

	if (!(weight > 0) || out->samples < 1)
		return;
	out->mean = p = sums->weight[1] / weight;
	q = sums->weight[0] / weight;
	for (size_t k = 0; k < n; k++) {
		double d = sample[k].concentration - p;

		if (sample[k].particles >= least)
			out->variance += sample[k].weight * d * d;
	}
	out->variance /= weight;
	out->segregated = p * q;
	squares = q * q * sums->square[1] + p * p * sums->square[0];
	if (out->particles > 1)
		out->random = ((double)out->samples - 1) / (N - 1) * N * squares / (weight * weight);
	out->defined = out->samples > 1 && out->samples < out->particles && out->random < out->segregated;
}

void ts_mixing_tally(const struct ts_component *component, enum ts_weight weight,
		     const struct ts_mixing_member *member, size_t n, size_t least,
		     struct ts_mixing_sample *sample, size_t *nsamples, struct ts_mixing_statistics *out)
{
	struct sums total = { 0 }, sums;

	*out = (struct ts_mixing_statistics){ 0 };
	*nsamples = 0;
	for (size_t k = 0; k < n; (*nsamples)++) {
		struct ts_mixing_sample *s = &sample[*nsamples];

		k += tally_sample(component, weight, member + k, n - k, s, &sums);
		if (s->particles < least)
			continue;
		out->samples++;
		out->particles += s->particles;
		for (int has = 0; has < 2; has++) {
			total.weight[has] += sums.weight[has];
			total.square[has] += sums.square[has];
		}
	}
	enter_statistics(&total, sample, *nsamples, least, out);
}
