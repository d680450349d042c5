/* Conjugate gradients with one of the preconditioners there are. */
#ifndef TS_FLOW_PRECONDITIONED_H
#define TS_FLOW_PRECONDITIONED_H

#include "flow/conjugate.h"
#include "flow/direct.h"
#include "flow/multigrid.h"
#include "flow/pressure.h"

enum ts_preconditioner {
	TS_PRECONDITION_AUTO, /* direct, if at most one axis is dear to transform, else multigrid */
	TS_PRECONDITION_DIAGONAL,
	TS_PRECONDITION_DIRECT, /* the problem without weights */
	TS_PRECONDITION_MULTIGRID
};
extern const char *const ts_preconditioner_names[];

struct ts_preconditioned {
	struct ts_iteration iteration;
	int wanted; /* enum ts_preconditioner */
	enum ts_preconditioner preconditioner;
	struct ts_conjugate conjugate;
	struct ts_direct direct;
	struct ts_multigrid multigrid;
};

enum ts_preconditioner ts_precondition_choose(int wanted, const struct ts_poisson *problem);
enum ts_status ts_preconditioned_prepare(struct ts_preconditioned *c, struct tsim *sim,
					 const struct ts_poisson *problem);
void ts_preconditioned_release(struct ts_preconditioned *c);
enum ts_status ts_preconditioned_solve(struct ts_preconditioned *c, struct ts_instance *self,
				       struct tsim *sim, const double *rhs, double *p,
				       struct ts_poisson_report *report);

#endif
