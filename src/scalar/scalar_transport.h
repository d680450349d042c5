/* Transport of a scalar T by the fluid: d(e T)/dt + div(e u T) = div(e D grad T) + s + x T, T at cell centres;
 * x = div(e u) + de/dt is 0 except in closed grids.
 *
 * Conservative finite volumes. Convection by donor cell, central differences, or van Leer's limiter, which
 * is of second order and bounded (J. Comput. Phys. 14 (1974) 361); in time the Runge-Kutta methods of Shu & Osher (J.
 * Comput. Phys. 77 (1988) 439), which preserve the bounds for steps up to 1/(max of sum 2 |u|/h + 2 D/h^2): with central
 * differences that of third order, which is stable without conduction, else Heun's. The velocity is that at the end of
 * the step of the fluid. */
#ifndef TS_SCALAR_SCALAR_TRANSPORT_H
#define TS_SCALAR_SCALAR_TRANSPORT_H

#include "flow/fluid.h"

enum ts_scalar_scheme { TS_SCALAR_VANLEER, TS_SCALAR_CENTRAL, TS_SCALAR_DONOR };
extern const char *const ts_scalar_schemes[];

enum ts_scalar_condition { TS_SCALAR_NONE, TS_SCALAR_VALUE, TS_SCALAR_FLUX };
struct ts_scalar_face {
	int condition; /* enum ts_scalar_condition */
	double now;    /* present value: T on the face, or flux into the fluid (T times velocity) */
};

struct ts_transport {
	enum ts_scalar_scheme scheme;
	double diffusivity;
	struct ts_scalar_face face[3][2];
	double *value, *source; /* T; s without its constant part (T/time). Owned */
	double constant;	/* constant part of s (T/time) */
	double excess;		/* x (1/time) */
	double *void_fraction;	/* at the time of T; NULL: 1 everywhere. Owned */
	double *rate, *stage;	/* work fields; owned */
};

/* Allocates the fields; source and T are 0. To be released by ts_transport_release, also after a failure. */
enum ts_status ts_transport_make(struct ts_transport *transport, const struct ts_fluid *fluid);
void ts_transport_release(struct ts_transport *transport);

/* Sets the ghosts of T. */
void ts_transport_fill(const struct ts_transport *transport, const struct ts_fluid *fluid, double *value);

/* Largest stable step. */
double ts_transport_limit(const struct ts_transport *transport, const struct ts_fluid *fluid);
/* The number of substeps that the limit requires over dt. */
double ts_transport_parts(const struct ts_transport *transport, const struct ts_fluid *fluid, double dt);
/* Advances T over dt, in so many substeps; its ghosts are not set. */
void ts_transport_advance(struct ts_transport *transport, const struct ts_fluid *fluid, double dt, long parts,
			  int threads);
/* Exchanges among ranks what that exchanges, without computing it. */
void ts_transport_rehearse(const struct ts_transport *transport, const struct ts_fluid *fluid, double dt);

#endif
