/* Functions of formulas over groups: count(g), mass(g), xcm(g,x) ... */
#ifndef TS_GROUP_GROUP_FUNCTION_H
#define TS_GROUP_GROUP_FUNCTION_H

#include "core/sim.h"

extern const struct ts_system_style ts_groups_system;

#endif
