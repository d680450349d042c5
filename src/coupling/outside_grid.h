/* Particles outside the grid of a fluid that is solved for: no force of the fluid acts on them. */
#ifndef TS_COUPLING_OUTSIDE_GRID_H
#define TS_COUPLING_OUTSIDE_GRID_H

#include "flow/fluid.h"
#include "particle/particles.h"

/* Their number, and the lowest identity among them (INT64_MAX: there is none). */
struct ts_coupling_outside {
	size_t n;
	int64_t tag;
};

static inline void ts_coupling_outside_add(struct ts_coupling_outside *outside, const struct ts_particles *p,
					   size_t i)
{
	outside->n++;
	outside->tag = p->tag[i] < outside->tag ? p->tag[i] : outside->tag;
}

/* Records that n particles of a fix are outside in this step; `tag`: the lowest identity among them
 * (ignored if n is 0). Warns once in a run. */
enum ts_status ts_coupling_count_outside(struct ts_fluid *fluid, struct tsim *sim,
					 const struct ts_instance *self, size_t n, int64_t tag);
/* While the particles are divided among ranks, once in a step: all ranks sum what they have counted. */
enum ts_status ts_coupling_sum_outside(struct ts_fluid *fluid, struct tsim *sim);
/* At the end of a run: logs the largest number and the number of steps. */
void ts_coupling_report_outside(struct ts_fluid *fluid, struct tsim *sim);

#endif
