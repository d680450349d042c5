/* The explicit predictor of a stage: convection, diffusion and body force in one pass over the rows of the
 * grid. */
#ifndef TS_FLOW_PREDICTOR_H
#define TS_FLOW_PREDICTOR_H

#include "flow/operators.h"
#include "rank/slabs.h"

/* out = keep * old + take * (u + dt rate(u)) at all faces where the velocity is not given. Arrays belong
 * to the caller. */
struct ts_predictor {
	const struct ts_fluid *fluid;
	const struct ts_operators *operators;
	enum ts_convection convection;
	enum ts_flow_form form;
	double gamma; /* donor cell: fraction of upwind differences */
	double nu;    /* kinematic viscosity */
	double acceleration[3];
	double dt, keep, take;
	const double *u[3], *old[3];
	/* form conservative (flow/void_fraction.c): e of the fluxes e u, and the e that multiplies u at
	 * the beginning of the step, u of the last stage and the new u. NULL in other forms. */
	const double *flow[3], *start[3], *last[3], *next[3];
	double *out[3];
	int threads;
	const struct ts_slabs *slabs; /* of ranks; NULL: all planes */
};
void ts_flow_predict(const struct ts_predictor *predictor);

/* The faces of component c at which the momentum equation is solved: from[d] <= index < to[d]. */
void ts_flow_unknowns(const struct ts_fluid *fluid, int c, int from[3], int to[3]);

/* Such faces of component c in the row j, k: from <= i < to. */
typedef void ts_flow_row_fn(void *context, int c, int j, int k, int from, int to);
/* Visits all rows of this rank; several threads at once. */
void ts_flow_visit_rows(const struct ts_fluid *fluid, const struct ts_slabs *slabs, int threads,
			ts_flow_row_fn *visit, void *context);

#endif
