#include "particle/group_moments.h"

#include "base/clones.h"
#include "particle/rank_sums.h"

#include "base/banned.h"

const int ts_tensor_row[6] = { 0, 1, 2, 0, 0, 1 }, ts_tensor_column[6] = { 0, 1, 2, 1, 2, 2 };
const char *const ts_tensor_names[] = { "xx", "yy", "zz", "xy", "xz", "yz", NULL };

/* A term costs about as much as three rounds of a simple loop. */
enum { TERM_COST = 3 };

/* Of a block of particles. */
enum membership { NONE, SOME, EACH };

TS_CLONES static enum membership members_of(const struct ts_particles *p, size_t from, size_t n, int group)
{
	uint32_t any = 0, each = UINT32_MAX;

#pragma omp simd reduction(| : any) reduction(& : each)
	for (size_t k = 0; k < n; k++) {
		any |= p->mask[from + k];
		each &= p->mask[from + k];
	}
	return (each >> group) & 1u ? EACH : (any >> group) & 1u ? SOME : NONE;
}

/* Terms of particles outside the group are not added, whatever they are. */
static void clear_others(const struct ts_particles *p, size_t from, size_t n, int group, size_t width,
			 double (*term)[TS_TERM_BLOCK])
{
	for (size_t i = 0; i < n; i++)
		for (size_t k = 0; k < width && !ts_in_group(p, from + i, group); k++)
			term[k][i] = 0;
}

void ts_group_sum_blocks(const struct tsim *sim, int group, size_t width, ts_terms_fn *terms,
			 const void *context, double *out)
{
	const struct ts_particles *p = sim->particles;
	struct ts_exactsum sum[TS_MOST_TERMS];

	for (size_t k = 0; k < width; k++)
		sum[k] = ts_exactsum_start();
#pragma omp parallel num_threads(ts_team(sim, TERM_COST *width * p->n))
	{
		struct ts_exactsum part[TS_MOST_TERMS];
		double term[TS_MOST_TERMS][TS_TERM_BLOCK];

		for (size_t k = 0; k < width; k++)
			part[k] = ts_exactsum_start();
#pragma omp for schedule(static)
		for (size_t from = 0; from < p->n; from += TS_TERM_BLOCK) {
			size_t n = p->n - from < TS_TERM_BLOCK ? p->n - from : TS_TERM_BLOCK;

			enum membership members = members_of(p, from, n, group);

			if (members == NONE)
				continue;
			terms(sim, from, n, context, term);
			if (members == SOME)
				clear_others(p, from, n, group, width, term);
			for (size_t k = 0; k < width; k++)
				ts_exactsum_add_block(&part[k], term[k], n);
		}
#pragma omp critical(ts_group_sum)
		for (size_t k = 0; k < width; k++)
			ts_exactsum_merge(&sum[k], &part[k]);
	}
	ts_rank_sums_merge(sim, sum, width);
	for (size_t k = 0; k < width; k++)
		out[k] = ts_exactsum_value(&sum[k]);
}

/* A function of one particle, which is not called for others than those of the group. */
struct one_by_one {
	ts_term_fn *term;
	const void *context;
	size_t width;
	int group;
};

static void terms_one_by_one(const struct tsim *sim, size_t from, size_t n, const void *context,
			     double (*term)[TS_TERM_BLOCK])
{
	const struct one_by_one *one = context;
	double t[TS_MOST_TERMS] = { 0 };

	for (size_t i = 0; i < n; i++) {
		if (ts_in_group(sim->particles, from + i, one->group))
			one->term(sim, from + i, one->context, t);
		for (size_t k = 0; k < one->width; k++)
			term[k][i] = t[k];
	}
}

void ts_group_sum(const struct tsim *sim, int group, size_t width, ts_term_fn *term, const void *context,
		  double *out)
{
	struct one_by_one one = { term, context, width, group };

	ts_group_sum_blocks(sim, group, width, terms_one_by_one, &one, out);
}

static void count_term(const struct tsim *sim, size_t i, const void *context, double *term)
{
	(void)sim, (void)i, (void)context;
	term[0] = 1;
}

static void mass_term(const struct tsim *sim, size_t i, const void *context, double *term)
{
	(void)context;
	term[0] = sim->particles->mass[i];
}

double ts_group_count(const struct tsim *sim, int group)
{
	double out;

	ts_group_sum(sim, group, 1, count_term, NULL, &out);
	return out;
}

double ts_group_mass(const struct tsim *sim, int group)
{
	double out;

	ts_group_sum(sim, group, 1, mass_term, NULL, &out);
	return out;
}

TS_CLONES static void multiply(const double *m, size_t n, const double *a, const double *b, double *out)
{
	for (size_t i = 0; i < n; i++)
		out[i] = m[i] * a[i] * b[i];
}

void ts_group_tensor_terms(const double *m, size_t n, double (*v)[TS_TERM_BLOCK],
			   double (*term)[TS_TERM_BLOCK])
{
	for (int k = 0; k < 6; k++)
		multiply(m, n, v[ts_tensor_row[k]], v[ts_tensor_column[k]], term[k]);
}
