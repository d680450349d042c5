/* Contact history that changes ranks with the particles: core/carried.h. */
#ifndef TS_NEIGH_CARRIED_HISTORY_H
#define TS_NEIGH_CARRIED_HISTORY_H

#include "core/carried.h"

extern const struct ts_carrier ts_carried_history;

#endif
