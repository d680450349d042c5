/* Levels of a multigrid that ranks divide: each computes the planes of its slab, in which sweeps by colour do not depend on the
 * order of the rows. Coarse levels, which take less time than messages, each computes as a whole. */
#ifndef TS_POISSON_MULTIGRID_SLABS_H
#define TS_POISSON_MULTIGRID_SLABS_H

#include "poisson/multigrid.h"

/* Chooses the levels that are divided. */
enum ts_status ts_multigrid_divide(struct ts_multigrid *m, struct ts_world *world);
/* Before a cycle: divides it if the finest level is divided. */
void ts_multigrid_set_slabs(struct ts_multigrid *m);

/* After the links of its own planes: those beside them of which it computes the links of the next level; all links of the first
 * level that is not divided. */
void ts_multigrid_share_links(const struct ts_multigrid_level *l);
/* Of ranks that divide a level: planes of the residual that its restriction needs. */
void ts_multigrid_share_residual(const struct ts_multigrid_level *l);
/* All get the whole right-hand side of the first level that is not divided. */
void ts_multigrid_share_rhs(const struct ts_multigrid_level *l);

#endif
