/* Particles on which a fix acts: those of its group and, if one is given, in a region. */
#ifndef TS_GROUP_CHOSEN_H
#define TS_GROUP_CHOSEN_H

#include "particle/particles.h"
#include "region/region.h"

static inline bool ts_chosen(const struct ts_particles *p, size_t i, int group,
			     const struct ts_instance *region)
{
	return ts_in_group(p, i, group) && (!region || ts_region_contains(region, p->x[i]));
}

#define TS_REGION_KEYWORD(T)                                 \
	TS_REGION("region", T, region, .flags = TS_OPTIONAL, \
		  .help = "the fix acts only on particles whose centres are in the region at that step")

#endif
