/* Which particles the live fixes step forward. */
#ifndef TS_INTEGRATE_INTEGRATORS_H
#define TS_INTEGRATE_INTEGRATORS_H

#include "core/sim.h"

/* The groups of the fixes that do all of `what` (enum ts_integrates), as bits of particles->mask. */
uint32_t ts_integrated(const struct tsim *sim, unsigned what);

/* Refuses particles that would be moved twice in a step by two fixes; by a fix and with their rigid body is a finding of
 * the review. */
enum ts_status ts_integrators_check(struct tsim *sim);
/* The same for members of rigid bodies that come in a run: rows[0..n-1]. */
enum ts_status ts_integrators_check_members(struct tsim *sim, const int32_t *row, size_t n);

#endif
