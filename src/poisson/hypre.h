/* One V-cycle of hypre's PFMG, as a preconditioner: R. D. Falgout & J. E. Jones, Multigrid Methods VI (2000) 101. Semi-
 * coarsening, Galerkin operators, red and black smoothing. Only where configure --with-hypre has found the library,
 * which brings MPI; the process is then one of one. */
#ifndef TS_POISSON_HYPRE_H
#define TS_POISSON_HYPRE_H

#include "poisson/stencil.h"

struct ts_hypre;

/* Whether this program has it. */
bool ts_hypre_available(void);
/* For the shape of s; NULL without memory or without hypre. */
struct ts_hypre *ts_hypre_make(const struct ts_stencil *s);
void ts_hypre_release(struct ts_hypre *h);
/* Takes the links as they are now, and sets up the levels. */
enum ts_status ts_hypre_set_weights(struct ts_hypre *h);
/* z = one cycle for A z = r from z = 0: a ts_precondition_fn. */
void ts_hypre_cycle(void *hypre, const double *r, double *z);

#endif
