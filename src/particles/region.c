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
