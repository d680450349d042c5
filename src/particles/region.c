#include "particles/region.h"

#include <math.h>

#include "particles/domain.h"

#include "base/banned.h"

const char *const ts_region_sides[] = { "in", "out", NULL };
const char *const ts_region_units[] = { "lattice", "box", NULL };

static const struct ts_region_style *style_of(const struct ts_instance *region)
{
	return (const struct ts_region_style *)region->style;
}

bool ts_region_contains(const struct ts_instance *region, const double x[3])
{
	const struct ts_region *common = region->state;

	return style_of(region)->contains(region, x) != (common->side == 1);
}

void ts_region_bounds(const struct ts_instance *region, double lo[3], double hi[3])
{
	const struct ts_region *common = region->state;

	if (common->side == 0) {
		style_of(region)->bounds(region, lo, hi);
		return;
	}
	for (int d = 0; d < 3; d++) {
		lo[d] = -INFINITY;
		hi[d] = INFINITY;
	}
}

void ts_region_init(struct ts_instance *self, struct tsim *sim)
{
	struct ts_region *common = self->state;

	common->scale = common->units == 0 ? sim->domain->lattice : 1;
}

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
	ts_region_init(self, sim);
	for (size_t k = 0; k < set->names.n; k++)
		TS_TRY(ts_sim_require(sim, TS_KIND_REGION, &set->names.word[k], &set->member[k]));
	return TS_OK;
}
