/* One V-cycle of hypre's PFMG, as a preconditioner: R. D. Falgout & J. E. Jones, Multigrid Methods VI
 * (2000) 101. Semi- coarsening, Galerkin operators, red and black smoothing. Available if configure
 * --with-hypre has found the library, which needs MPI; the process is then the only MPI rank. */
#ifndef TS_POISSON_HYPRE_H
#define TS_POISSON_HYPRE_H

#include "poisson/stencil.h"

struct ts_hypre;

/* Whether this program was built with hypre. */
bool ts_hypre_available(void);
/* For grids of the shape of s; NULL if out of memory or built without hypre. */
struct ts_hypre *ts_hypre_make(const struct ts_stencil *s);
void ts_hypre_release(struct ts_hypre *h);
/* Takes the present coefficients of the stencil and sets up the levels. */
enum ts_status ts_hypre_set_weights(struct ts_hypre *h);
/* z = one cycle for A z = r from z = 0: a ts_precondition_fn. */
void ts_hypre_cycle(void *hypre, const double *r, double *z);

#endif
