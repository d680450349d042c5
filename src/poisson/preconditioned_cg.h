/* The conjugate gradient method with a choice of preconditioners: state and slots of pressure styles cg
 * and others. */
#ifndef TS_POISSON_PRECONDITIONED_CG_H
#define TS_POISSON_PRECONDITIONED_CG_H

#include "poisson/conjugate_gradient.h"
#include "poisson/direct.h"
#include "poisson/hypre.h"
#include "poisson/multigrid.h"
#include "poisson/pressure_style.h"

enum ts_preconditioner {
	TS_PRECONDITION_AUTO, /* chosen for each solve: direct, or multigrid if the weights differ too much */
	TS_PRECONDITION_DIAGONAL,
	TS_PRECONDITION_DIRECT, /* the direct solver, with all weights 1 */
	TS_PRECONDITION_MULTIGRID,
	TS_PRECONDITION_HYPRE /* pressure_style hypre only */
};
extern const char *const ts_preconditioner_names[];

struct ts_preconditioned {
	struct ts_iteration iteration;
	int wanted; /* enum ts_preconditioner */
	struct ts_conjugate_gradient conjugate;
	struct ts_direct direct;
	struct ts_multigrid multigrid;
	struct ts_hypre *hypre;
	bool ranks; /* ranks divide the grid of hypre, whose digits depend on their number then */
};

/* Estimated time of a solve in seconds with the fastest preconditioner. */
double ts_preconditioned_cost(const struct ts_preconditioned *c, const struct ts_poisson *problem);
/* Slots of pressure styles whose state is struct ts_preconditioned. */
enum ts_status ts_preconditioned_prepare(struct ts_instance *self, struct tsim *sim,
					 const struct ts_poisson *problem);
/* While ranks have slabs: whether they divide the next solve. */
bool ts_preconditioned_divided(const struct ts_instance *self);
bool ts_preconditioned_always_divided(const struct ts_instance *self);
enum ts_status ts_preconditioned_solve(struct ts_instance *self, struct tsim *sim, const double *rhs,
				       double *p, struct ts_poisson_report *report);
enum ts_status ts_preconditioned_rehearse(struct ts_instance *self, int iterations);
void ts_preconditioned_fini(struct ts_instance *self);

#endif
