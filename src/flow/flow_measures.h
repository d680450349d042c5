/* Sums over the fields of a fluid, and what follows from them: energy, vorticity, fluxes, forces on the faces
 * of the grid. Sums run in the order of the cells, row by row: they do not depend on threads. */
#ifndef TS_FLOW_FLOW_MEASURES_H
#define TS_FLOW_FLOW_MEASURES_H

#include "flow/fluid.h"

/* "xlo", "xhi", "ylo" ...: 2 axis + side; closed by NULL. */
extern const char *const ts_flow_face_names[];

/* Sum over cells of rho e V times the mean of u^2/2 at their two faces across each axis: the energy that
 * central differences with exact projection conserve. */
double ts_flow_kinetic_energy(const struct ts_fluid *fluid);

/* Momentum along axis d: sum over cells of V times the mean of rho e u at their two faces. With form conservative e is the
 * one that belongs to u (flow/void_fraction.c). */
double ts_flow_momentum(const struct ts_fluid *fluid, int d);

/* In the middle of a cell: mean of its faces, mean of its edges. */
void ts_flow_centre_velocity(const struct ts_fluid *fluid, const int cell[3], double u[3]);
void ts_flow_centre_vorticity(const struct ts_fluid *fluid, const int cell[3], double w[3]);
/* Component a of curl u where it lives: on the edge along axis a that is the lower one of the cell. */
double ts_flow_edge_vorticity(const struct ts_fluid *fluid, int a, const int cell[3]);

struct ts_flow_flux_sums {
	double flux; /* of fluid volume, sum of e u A, > 0 along the axis */
	double area; /* of the faces */
};
/* Through the plane across axis d at the coordinate x, between the planes of faces by linear interpolation;
 * where faces have their centres in the region, if one is given. */
enum ts_status ts_flow_flux(const struct ts_fluid *fluid, struct tsim *sim, int d, double x,
			    struct ts_instance *region, struct ts_flow_flux_sums *out);

struct ts_flow_face_load {
	double pressure[3], shear[3]; /* forces */
	double area;
};
/* What the fluid does to what bounds it at a face of the grid. Pressure on the face: extrapolated from two
 * cells, at an outlet 0. Shear: viscosity times the gradient between the ghosts and the first cell, which is
 * what the fluid's own momentum loses there. */
enum ts_status ts_flow_face_force(const struct ts_fluid *fluid, struct tsim *sim, int d,
				  enum ts_grid_side side, struct ts_instance *region,
				  struct ts_flow_face_load *out);

#endif
