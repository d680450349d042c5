/* The system of all walls: what the search for neighbours and the count of lost particles ask of them. */
#ifndef TS_WALL_WALL_SYSTEM_H
#define TS_WALL_WALL_SYSTEM_H

#include "core/style.h"

extern const struct ts_system_style ts_walls_system;

#endif
