/* Which particles the live fixes integrate. */
#ifndef TS_INTEGRATE_INTEGRATORS_H
#define TS_INTEGRATE_INTEGRATORS_H

#include "core/sim.h"

/* Bits (of particles->mask) of the groups of the fixes that do all of `what` (enum ts_integrates). */
uint32_t ts_integrated_groups(const struct tsim *sim, unsigned what);

/* Fails if two fixes integrate the same particle; a fix that integrates a member of a rigid body is a finding
 * of the review. Checked before a run, and for members of rigid bodies that are inserted in it. */
extern const struct ts_system_style ts_integrators_system;

#endif
