/* A scalar T that the fluid carries: d(e T)/dt + div(e u T) = div(e D grad T) + s, T at the centres of cells.
 *
 * Conservative: what leaves a cell enters its neighbour. Convection of donor cell, central, or of second order and
 * bounded (van Leer's limiter, J. Comput. Phys. 14 (1974) 361); time by Heun's method, which keeps the bounds
 * (Shu & Osher, J. Comput. Phys. 77 (1988) 439) for steps up to 1/(max of sum 2 |u|/h + 2 D/h^2). The velocity is
 * that of the end of the fluid's step. */
#ifndef TS_FLOW_SCALAR_TRANSPORT_H
#define TS_FLOW_SCALAR_TRANSPORT_H

#include "flow/fluid.h"

enum ts_scalar_scheme { TS_SCALAR_VANLEER, TS_SCALAR_CENTRAL, TS_SCALAR_DONOR };
extern const char *const ts_scalar_schemes[];

enum ts_scalar_condition { TS_SCALAR_NONE, TS_SCALAR_VALUE, TS_SCALAR_FLUX };
struct ts_scalar_face {
	int condition; /* enum ts_scalar_condition */
	double now;    /* T on the face, or T times velocity into the fluid */
};

struct ts_transport {
	enum ts_scalar_scheme scheme;
	double diffusivity;
	struct ts_scalar_face face[3][2];
	double *value, *source; /* T; s without its constant part */
	double constant;	/* the same everywhere */
	double *empty;		/* void fraction at the time of T; NULL: 1 */
	double *rate, *stage;	/* work */
};

/* Memory for the fields; source and T are 0. Released by ts_transport_release, also after a failure. */
enum ts_status ts_transport_make(struct ts_transport *transport, const struct ts_fluid *fluid);
void ts_transport_release(struct ts_transport *transport);

/* Ghosts of T, for reading it anywhere. */
void ts_transport_fill(const struct ts_transport *transport, const struct ts_fluid *fluid, double *value);

double ts_transport_limit(const struct ts_transport *transport, const struct ts_fluid *fluid);
/* Over dt, in as many parts as the limit asks for; how many. */
long ts_transport_advance(struct ts_transport *transport, const struct ts_fluid *fluid, double dt,
			  int threads);

#endif
