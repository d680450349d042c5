/* Region: the union of other regions. */
#include "particles/region.h"

#include <math.h>

#include "base/banned.h"

struct union_set {
	struct ts_region region;
	int64_t n;
	struct ts_words rest; /* n names, then keywords */
	struct ts_instance **member;
};

static const struct ts_arg keywords[] = {
	TS_REGION_ARGS(struct union_set),
	TS_ARGS_END,
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct union_set *u = self->state;

	if ((size_t)u->n > u->rest.n)
		return ts_fail(&sim->error, TS_SYNTAX, &self->where,
			       "region union: expected the names of %lld regions, found %zu words",
			       (long long)u->n, u->rest.n);
	if (!u->member) {
		TS_TRY(ts_args_parse(sim, "region union", keywords,
				     ts_words_from(u->rest, (size_t)u->n), &self->where,
				     &self->arena, u));
		u->member = ts_arena_alloc(&self->arena, (size_t)u->n, sizeof *u->member);
		if (!u->member)
			return ts_nomem(&sim->error);
	}
	ts_region_init(self, sim);
	for (int64_t k = 0; k < u->n; k++)
		TS_TRY(ts_sim_require(sim, TS_KIND_REGION, &u->rest.word[k], &u->member[k]));
	return TS_OK;
}

static bool contains(const struct ts_instance *self, const double x[3])
{
	const struct union_set *u = self->state;

	for (int64_t k = 0; k < u->n; k++)
		if (ts_region_contains(u->member[k], x))
			return true;
	return false;
}

static void bounds(const struct ts_instance *self, double lo[3], double hi[3])
{
	const struct union_set *u = self->state;
	double a[3], b[3];

	for (int64_t k = 0; k < u->n; k++) {
		ts_region_bounds(u->member[k], a, b);
		for (int d = 0; d < 3; d++) {
			lo[d] = k ? fmin(lo[d], a[d]) : a[d];
			hi[d] = k ? fmax(hi[d], b[d]) : b[d];
		}
	}
}

static const struct ts_arg args[] = {
	TS_INT("n", struct union_set, n, .flags = TS_POSITIONAL, .range = TS_WITHIN, .lo = 1,
	       .hi = 1e6, .help = "number of regions"),
	TS_REST("regions", struct union_set, rest,
		.help = "the names of n regions, then the keywords side and units"),
	TS_REGION_ARGS(struct union_set),
	TS_ARGS_END,
};

TS_STYLE(region, ts_region_style, ts_region_union)
const struct ts_region_style ts_region_union = {
	.style = {
		.name = "union",
		.kind = TS_KIND_REGION,
		.summary = "All points of any of several regions",
		.doc = "A point belongs to it if it belongs to at least one of the n regions; the side of each\n"
		       "counts.",
		.example = "region both union 2 left right",
		.args = args,
		.state_size = sizeof(struct union_set),
		.init = init,
	},
	.contains = contains,
	.bounds = bounds,
};
