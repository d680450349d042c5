#include "particles/region_set.h"

#include "base/banned.h"

const struct ts_arg ts_region_set_args[] = {
	TS_INT("n", struct ts_region_set, n, .flags = TS_POSITIONAL, .range = TS_WITHIN, .lo = 1,
	       .hi = 1e6, .help = "number of regions"),
	TS_LIST("regions", struct ts_region_set, names, .help = "the names of n regions"),
	TS_REGION_ARGS(struct ts_region_set),
	TS_ARGS_END,
};

enum ts_status ts_region_set_init(struct ts_instance *self, struct tsim *sim)
{
	struct ts_region_set *set = self->state;

	if ((size_t)set->n != set->names.n)
		return ts_fail(&sim->error, TS_SYNTAX, &self->where,
			       "region %s: expected the names of %lld regions, found %zu",
			       self->style->name, (long long)set->n, set->names.n);
	if (!set->member)
		set->member = ts_arena_alloc(&self->arena, set->names.n, sizeof *set->member);
	if (!set->member)
		return ts_nomem(&sim->error);
	TS_TRY(ts_region_init(self, sim));
	for (size_t k = 0; k < set->names.n; k++)
		TS_TRY(ts_sim_require(sim, TS_KIND_REGION, &set->names.word[k], &set->member[k]));
	return TS_OK;
}

enum ts_status ts_region_set_update(struct ts_instance *self, struct tsim *sim)
{
	struct ts_region_set *set = self->state;

	for (int64_t k = 0; k < set->n; k++)
		TS_TRY(ts_region_update(set->member[k], sim));
	return TS_OK;
}
