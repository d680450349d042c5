/* Integrals over the fields of a fluid: energy, momentum, fluxes, forces on the faces of the grid;
 * velocity and vorticity of cells. Sums run in the order of the cells, row by row, and do not depend on
 * the number of threads. */
#ifndef TS_FLOW_FLOW_MEASURES_H
#define TS_FLOW_FLOW_MEASURES_H

#include "flow/fluid.h"

/* "xlo", "xhi", "ylo" ...: index 2 axis + side; terminated by NULL. */
extern const char *const ts_flow_face_names[];

/* Kinetic energy: sum over cells of rho e V times the mean of u^2/2 at the two faces across each axis, the
 * energy that central differences with exact projection conserve. */
double ts_flow_kinetic_energy(const struct ts_fluid *fluid);

/* Momentum along axis d: sum over cells of V times the mean of rho e u at their two faces. With form
 * conservative e is that of the product e u (flow/void_fraction.c). */
double ts_flow_momentum(const struct ts_fluid *fluid, int d);

/* Velocity and vorticity at the centre of a cell: mean over its faces, mean over its edges. */
void ts_flow_centre_velocity(const struct ts_fluid *fluid, const int cell[3], double u[3]);
void ts_flow_centre_vorticity(const struct ts_fluid *fluid, const int cell[3], double w[3]);
/* Component a of curl u on the lower edge of the cell along axis a. */
double ts_flow_edge_vorticity(const struct ts_fluid *fluid, int a, const int cell[3]);

struct ts_flow_flux_sums {
	double flux; /* volume flow, sum of e u A (volume/time), > 0 along the axis */
	double area; /* sum of A */
};
/* Flux through the plane across axis d at the coordinate x, interpolated linearly between the planes of
 * faces; only faces with their centre in the region, if one is given. */
enum ts_status ts_flow_flux(const struct ts_fluid *fluid, struct tsim *sim, int d, double x,
			    struct ts_instance *region, struct ts_flow_flux_sums *out);

struct ts_flow_face_load {
	double pressure[3], shear[3]; /* force by pressure, force by shear stress */
	double area;
};
/* Force of the fluid on a face of the grid. The pressure on the face is extrapolated from two cells; on an
 * open face it is the one given. Shear stress: viscosity times the gradient between ghosts and first cell,
 * which is the momentum flux in the equations of the fluid. */
enum ts_status ts_flow_face_force(const struct ts_fluid *fluid, struct tsim *sim, int d,
				  enum ts_grid_side side, struct ts_instance *region,
				  struct ts_flow_face_load *out);

#endif
