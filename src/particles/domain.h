/* The box of a simulation, its boundary conditions, lattice and periodic wrapping. */
#ifndef TS_PARTICLES_DOMAIN_H
#define TS_PARTICLES_DOMAIN_H

#include "core/sim.h"
#include "geom/box.h"

struct ts_domain {
	struct ts_box box;
	double first_lo[3], first_hi[3]; /* as created: the least box of `m` faces */
	bool exists;                     /* after create_box or read_restart */
	double lattice;                  /* lattice constant, 1 without `lattice` command */
	int lattice_style;               /* index into the styles of the lattice command, -1: none */
};

/* Refuses commands that need a box before there is one. */
enum ts_status ts_domain_require(struct tsim *sim, const struct ts_place *where);
/* Makes the box with room for so many types of particles. */
enum ts_status ts_domain_make(struct tsim *sim, int ntypes, const double lo[3], const double hi[3]);
/* Fits `s` and `m` faces to the particles. */
void ts_domain_shrink(struct tsim *sim);


extern const struct ts_system_style ts_domain_system;

#endif
