/* Impacts that ranks have computed, each those of its own particles, are given to all of them in each step: their sums
 * (forces on walls, loads, wear) are then those of one rank, also where a particle goes to another rank in this step. */
#ifndef TS_IMPACT_EXACT_SHARING_H
#define TS_IMPACT_EXACT_SHARING_H

#include "impact/exact_notices.h"

/* Adds an impact of this step with its nodes. */
enum ts_status ts_exact_take(struct tsim *sim, struct ts_exact_impacts *to,
			     const struct ts_exact_impact *impact, const struct ts_contact_node *node);
/* While the particles are divided: the impacts of the walls, and the notices, become those of all ranks, in any order. */
enum ts_status ts_exact_share(struct tsim *sim, const struct ts_exact_target *target, size_t targets,
			      struct ts_exact_notices *notices);

#endif
