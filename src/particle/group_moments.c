#include "particle/group_moments.h"

#include "math/exactsum.h"
#include "particle/rank_sums.h"

#include "base/banned.h"

const int ts_tensor_row[6] = { 0, 1, 2, 0, 0, 1 }, ts_tensor_column[6] = { 0, 1, 2, 1, 2, 2 };
const char *const ts_tensor_names[] = { "xx", "yy", "zz", "xy", "xz", "yz", NULL };

/* A term costs about as much as three rounds of a simple loop. */
enum { TERM_COST = 3 };

void ts_group_sum(const struct tsim *sim, int group, size_t width, ts_term_fn *term, const void *context,
		  double *out)
{
	const struct ts_particles *p = sim->particles;
	struct ts_exactsum sum[TS_MOST_TERMS];

	for (size_t k = 0; k < width; k++)
		sum[k] = ts_exactsum_start();
#pragma omp parallel num_threads(ts_team(sim, TERM_COST *width * p->n))
	{
		struct ts_exactsum part[TS_MOST_TERMS];
		double t[TS_MOST_TERMS];

		for (size_t k = 0; k < width; k++)
			part[k] = ts_exactsum_start();
#pragma omp for schedule(static)
		for (size_t i = 0; i < p->n; i++) {
			if (!ts_in_group(p, i, group))
				continue;
			term(sim, i, context, t);
			ts_exactsum_add_each(part, width, t);
		}
#pragma omp critical(ts_group_sum)
		for (size_t k = 0; k < width; k++)
			ts_exactsum_merge(&sum[k], &part[k]);
	}
	ts_rank_sums_merge(sim, sum, width);
	for (size_t k = 0; k < width; k++)
		out[k] = ts_exactsum_value(&sum[k]);
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
