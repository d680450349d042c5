/* The system of checks that end a run whose time step is too large: the limit of the network of contacts, in
 * plans, and particles that move farther than their radius in a step. */
#ifndef TS_LIMITS_LIMITS_SYSTEM_H
#define TS_LIMITS_LIMITS_SYSTEM_H

#include "core/style.h"

extern const struct ts_system_style ts_limits_system;

#endif
