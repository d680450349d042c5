/* With several ranks: whether an output that is due in a step reads lists of pairs or contacts, which all ranks then have to
 * make of all particles. */
#ifndef TS_CORE_DUE_LISTS_H
#define TS_CORE_DUE_LISTS_H

#include "core/plan.h"

/* Whether a hook of END_OF_STEP or OUTPUT that is due names a compute, fix or keyword that reads lists, in its arguments, by its
 * slot `names`, or through computes, fixes, regions and variables that these name. Names are looked for in the texts: one that
 * is not evaluated counts, too. */
bool ts_due_lists_named(const struct ts_plan *plan, const struct tsim *sim);

#endif
