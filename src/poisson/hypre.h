/* One V-cycle of hypre's PFMG, as a preconditioner: R. D. Falgout & J. E. Jones, Multigrid Methods VI
 * (2000) 101. Semi- coarsening, Galerkin operators, red and black smoothing. Available if configure
 * --with-hypre has found the library, which needs MPI. */
#ifndef TS_POISSON_HYPRE_H
#define TS_POISSON_HYPRE_H

#include "poisson/stencil.h"

struct ts_hypre;

/* Whether this program was built with hypre. */
bool ts_hypre_available(void);
/* Whether its library was built with MPI, so that ranks can divide a grid. */
bool ts_hypre_divides(void);
/* For grids of the shape of s; NULL if out of memory or built without hypre. `world`: the ranks that divide it, of planes across
 * the last axis each a slab; NULL: each solves the whole. While s->slabs are not active all get the whole result. */
struct ts_hypre *ts_hypre_make(const struct ts_stencil *s, struct ts_world *world);
void ts_hypre_release(struct ts_hypre *h);
/* Takes the present coefficients of the stencil and sets up the levels. */
enum ts_status ts_hypre_set_weights(struct ts_hypre *h);
/* z = one cycle for A z = r from z = 0: a ts_precondition_fn. */
void ts_hypre_cycle(void *hypre, const double *r, double *z);

#endif
