/* References between live styles: which style uses a region or a group, by its arguments. */
#ifndef TS_CORE_USES_H
#define TS_CORE_USES_H

#include "core/sim.h"

/* A live style whose arguments name this region, or NULL. */
const struct ts_instance *ts_uses_region(const struct tsim *sim, const struct ts_instance *region);
/* The same for a retired (deleted) region: only pointers count, since another region may have its name
 * now. */
const struct ts_instance *ts_uses_retired_region(const struct tsim *sim, const struct ts_instance *region);
/* A live style that acts on this group or has it as an argument, or NULL. */
const struct ts_instance *ts_uses_group(const struct tsim *sim, int bit);

#endif
