/* The box of a simulation, its boundary conditions and its lattice. */
#ifndef TS_BOX_DOMAIN_H
#define TS_BOX_DOMAIN_H

#include "box/lattice.h"
#include "core/sim.h"
#include "geom/box.h"

struct ts_domain {
	struct ts_box box;
	double first_lo[3], first_hi[3]; /* as created or changed: the least box of `m` faces */
	double held_lo[3], held_hi[3];	 /* as the rows were built: periodic images are of this box */
	double drift[3];	   /* velocity of an image relative to its original, for fix deform remap v */
	int drift_group;	   /* whose velocities change so when they cross a face */
	struct ts_lattice lattice; /* of constant 1 without `lattice` command */
	bool units_warned;
};

/* Refuses commands that need a box before there is one. */
enum ts_status ts_domain_require(struct tsim *sim, const struct ts_place *where);

/* The faces that three words of the boundary command mean: p, f, s, m, or two letters. */
enum ts_status ts_domain_read_faces(struct tsim *sim, const char *const text[3], const struct ts_place *where,
				    enum ts_face face[3][2]);

/* Makes lo to hi the box, the least one of `m` faces as well; `s` faces start a margin outside. Refused
 * where it has no volume, or does not fit `dimension 2`. */
enum ts_status ts_domain_set_box(struct tsim *sim, const double lo[3], const double hi[3],
				 const struct ts_place *where);
/* The rows are built now: images are of the box as it is. */
void ts_domain_hold(struct ts_domain *domain);
/* How much the periodic images have moved relative to their originals since then, at most. */
double ts_domain_moved(const struct ts_domain *domain);
/* Whether particles that reach a face leave: all faces of the box are of style f. */
bool ts_domain_all_fixed(const struct tsim *sim);
/* How far an `s` or `m` face stays outside of what it encloses. */
double ts_domain_margin(const struct ts_domain *domain, int dim);

/* A length along a dimension given with `units lattice|box` (0|1) times this is one of the simulation.
 * -1, not said: as LIGGGHTS takes it, box, but in lj units as LAMMPS does, lattice. */
double ts_domain_scale(const struct tsim *sim, int units, int dim);
/* Warns, once, where units are not said and the two programs would take lengths differently. */
void ts_domain_units_said(struct tsim *sim, int units, const struct ts_place *where);

extern const struct ts_system_style ts_domain_system;

#endif
