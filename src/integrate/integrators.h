/* Which particles the live fixes step forward. */
#ifndef TS_INTEGRATE_INTEGRATORS_H
#define TS_INTEGRATE_INTEGRATORS_H

#include "core/sim.h"

/* The groups of the fixes that do all of `what` (enum ts_integrates), as bits of particles->mask. */
uint32_t ts_integrated(const struct tsim *sim, unsigned what);

/* Refuses particles that would be moved twice in a step by two fixes; by a fix and with their rigid body
 * is a finding of the review. Checked before a run, and for members of rigid bodies that come in it. */
extern const struct ts_system_style ts_integrators_system;

#endif
