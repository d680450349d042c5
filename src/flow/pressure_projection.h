/* The projection: solves for the pressure and makes the velocity free of divergence. */
#ifndef TS_FLOW_PRESSURE_PROJECTION_H
#define TS_FLOW_PRESSURE_PROJECTION_H

#include "flow/fluid.h"

/* Chooses the pressure solver and prepares it for the present faces and weights; `held` as below. */
enum ts_status ts_projection_solver(struct ts_instance *self, struct tsim *sim, double held);
/* Makes the velocity, whose boundary values are set, free of divergence: u -= dt/rho grad p. `held`: time
 * over which the exchange coefficient k acts in it, dt or 0. */
enum ts_status ts_projection_project_velocity(struct ts_instance *self, struct tsim *sim, double dt,
					      double held);
/* Computes div(e u) + de/dt in a row of cells. */
void ts_flow_divergence_row(const struct ts_fluid *fluid, int j, int k, double *out);
/* Projects an initial velocity field; the pressure is zero afterwards. */
enum ts_status ts_projection_project_initial(struct ts_instance *self, struct tsim *sim);

#endif
