/* Convection and diffusion on the staggered grid: coefficients of the differences along each axis, and the
 * schemes.
 *
 * For component c the rate of change without pressure, on the control volume around its face:
 *   - sum_e [q_e phi]/width + nu sum_e d/de (du_c/de)
 * with q_e the velocity across the sides of the control volume and phi = u_c on the side by a convection
 * scheme. With a void fraction e
 *   1/e sum_e { - [e q_e phi]/width + u_c [e q_e]/width + nu d/de (e du_c/de) },
 * or, if e u is stepped forward, of e u_c: sum_e { - [e q_e phi]/width + nu d/de (e du_c/de) }. Second
 * order on smooth grids: both differences are central (donor cell: first order in the fraction gamma). */
#ifndef TS_FLOW_OPERATORS_H
#define TS_FLOW_OPERATORS_H

#include "flow/fluid.h"

/* Coefficients along one axis for values at points of that axis, which are cell centres or faces. Side m
 * lies between points m - 1 and m. Indexed from -1 to n. */
struct ts_operator_line {
	const double *inverse; /* 1/width of the control volume of point m (1/length) */
	/* diffusion: 1/(width of the control volume * distance to the neighbour) */
	const double *below, *above;
	/* linear interpolation at side m: weight of point m - 1; point m has 1 - part */
	const double *part;
	/* Quadratic interpolation at side m: weights `up` of the points m - 2, m - 1, m for flow towards
	 * higher m, `down` of m + 1, m, m - 1 for flow towards lower m. */
	const double *up[3], *down[3];
};

struct ts_operators {
	struct ts_operator_line centred[3], staggered[3];
	/* Linear interpolation across axis d to face m: weight of cell m - 1; cell m has 1 - mass. */
	const double *mass[3];
	double *memory; /* of all these arrays; owned */
};

enum ts_status ts_operators_make(struct ts_operators *operators, const struct ts_grid *grid);
void ts_operators_release(struct ts_operators *operators);

/* Convection schemes: how phi is found. */
enum ts_convection {
	TS_CONVECTION_DONOR,
	TS_CONVECTION_CENTRAL,
	TS_CONVECTION_QUICK,
	TS_CONVECTION_CUBISTA,
	TS_NCONVECTION
};
struct ts_convection_scheme {
	const char *name, *help;
	int order;    /* of phi on uniform grids */
	bool bounded; /* phi lies between the neighbouring values */
	/* Decay rate of the shortest waves by |u|/h, which reduces the limit of the step; donor: times
	 * gamma. */
	double decay;
	bool difference; /* available in form fd (finite differences), too */
};
extern const struct ts_convection_scheme ts_convection_schemes[TS_NCONVECTION];
/* Form of the convection term: finite volumes for u, finite differences, finite volumes for e u. */
enum ts_flow_form { TS_FORM_VOLUME, TS_FORM_DIFFERENCE, TS_FORM_CONSERVATIVE };
extern const char *const ts_convection_names[], *const ts_flow_form_names[];

#endif
