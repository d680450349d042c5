/* Convection and diffusion on the staggered grid, in rows.
 *
 * For component c the rate of change without pressure, on the control volume around its face:
 *   - sum_e [q_e phi]/width + nu sum_e d/de (du_c/de)
 * q_e the velocity across the sides of the control volume, phi = u_c there by a convection scheme.
 * Where particles leave the void fraction e
 *   1/e sum_e { - [e q_e phi]/width + u_c [e q_e]/width + nu d/de (e du_c/de) },
 * or, where e u is stepped forward, of e u_c: sum_e { - [e q_e phi]/width + nu d/de (e du_c/de) }.
 * Second order on smooth grids: both differences are centred (donor cell: first order as far as gamma). */
#ifndef TS_FLOW_OPERATORS_H
#define TS_FLOW_OPERATORS_H

#include "flow/fluid.h"

/* Coefficients along one axis for values at points of that axis: centres, or faces. Side m lies between
 * points m - 1 and m. By index from -1 to n. */
struct ts_operator_line {
	const double *inverse; /* 1/width of the control volume of point m */
	const double *below, *above; /* diffusion: 1/(width of the volume * distance to the neighbour) */
	const double *part;    /* linear interpolation at side m: what point m - 1 counts; m: the rest */
	/* Quadratic: up (flow towards higher m) of the points m - 2, m - 1, m; down of m + 1, m, m - 1. */
	const double *up[3], *down[3];
};

struct ts_operators {
	struct ts_operator_line centred[3], staggered[3];
	const double *mass[3]; /* at face m: what the velocity of cell m - 1 counts for the flow across, m: the rest */
	double *memory;
};

enum ts_status ts_operators_make(struct ts_operators *operators, const struct ts_grid *grid);
void ts_operators_release(struct ts_operators *operators);

/* How phi is found. */
enum ts_convection { TS_CONVECTION_DONOR, TS_CONVECTION_CENTRAL, TS_CONVECTION_QUICK,
		     TS_CONVECTION_CUBISTA, TS_NCONVECTION };
struct ts_convection_scheme {
	const char *name, *help;
	int order;	/* of phi on uniform grids */
	bool bounded;	/* phi never lies beyond its neighbours */
	double decay;	/* of the shortest waves, per |u|/h: what it takes from the limit of the step; donor: times
			 * gamma */
	bool difference; /* known in the form of finite differences as well */
};
extern const struct ts_convection_scheme ts_convection_schemes[TS_NCONVECTION];
/* conservative: volumes, and e u is what is stepped forward. */
enum ts_flow_form { TS_FORM_VOLUME, TS_FORM_DIFFERENCE, TS_FORM_CONSERVATIVE };
extern const char *const ts_convection_names[], *const ts_flow_form_names[];

/* out = keep * old + take * (u + dt rate(u)) at all faces where the velocity is not given. */
struct ts_predictor {
	const struct ts_fluid *fluid;
	const struct ts_operators *operators;
	enum ts_convection convection;
	enum ts_flow_form form;
	double gamma;	    /* donor cell: share of upwind */
	double nu;	    /* kinematic viscosity */
	double acceleration[3];
	double dt, keep, take;
	const double *u[3], *old[3];
	/* Where e u is stepped forward: e of the fluxes e u, and what u of the beginning, u and the new one are multiplied
	 * by (flow/void_fraction.c). */
	const double *flow[3], *start[3], *last[3], *next[3];
	double *out[3];
	int threads;
};
void ts_flow_predict(const struct ts_predictor *predictor);

/* The faces of component c between which the momentum equation holds: from[d] <= index < to[d]. */
void ts_flow_unknowns(const struct ts_fluid *fluid, int c, int from[3], int to[3]);

#endif
