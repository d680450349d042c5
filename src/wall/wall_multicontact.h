/* Loads of wall contacts on particles, for fix multicontact/halfspace. */
#ifndef TS_WALL_WALL_MULTICONTACT_H
#define TS_WALL_WALL_MULTICONTACT_H

#include "contact/multicontact.h"

extern const struct ts_multicontact_walls ts_wall_multicontact;

#endif
