/* Who refers to what: searches the arguments of live styles. */
#ifndef TS_CORE_USES_H
#define TS_CORE_USES_H

#include "core/sim.h"

/* A live style whose arguments name this region, or NULL. */
const struct ts_instance *ts_uses_region(const struct tsim *sim, const struct ts_instance *region);
/* The same of a region that is retired: not by its name, which another may have now. */
const struct ts_instance *ts_uses_retired_region(const struct tsim *sim, const struct ts_instance *region);
/* A live style that acts on this group or names it, or NULL. */
const struct ts_instance *ts_uses_group(const struct tsim *sim, int bit);

#endif
