/* The system of all walls: callbacks for the neighbour search, for fix multicontact/halfspace and for the
 * message about lost particles. */
#ifndef TS_WALL_WALL_SYSTEM_H
#define TS_WALL_WALL_SYSTEM_H

#include "core/style.h"

extern const struct ts_system_style ts_walls_system;

#endif
