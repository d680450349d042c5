#include "particles/integrators.h"

#include "base/banned.h"

uint32_t ts_integrated(const struct tsim *sim, unsigned what)
{
	const struct ts_instances *fixes = &sim->instances[TS_KIND_FIX];
	uint32_t groups = 0;

	for (size_t k = 0; k < fixes->n; k++)
		if ((fixes->item[k]->style->integrates & what) == what)
			groups |= (uint32_t)1 << fixes->item[k]->group;
	return groups;
}
