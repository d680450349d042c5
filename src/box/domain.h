/* The simulation box, its boundary conditions and its lattice. */
#ifndef TS_BOX_DOMAIN_H
#define TS_BOX_DOMAIN_H

#include "box/lattice.h"
#include "core/sim.h"
#include "geom/box.h"

struct ts_domain {
	struct ts_box box;
	/* box as created or last changed by a command: the minimum box of `m` faces */
	double first_lo[3], first_hi[3];
	/* box at the last rebuild of the contact list: periodic images refer to it */
	double held_lo[3], held_hi[3];
	double drift[3]; /* velocity of a periodic image relative to its original, for fix deform remap v */
	double held_offset; /* box.shear.offset at the last rebuild */
	double shear_drift; /* velocity along box.shear.flow of the images across its sheared faces */
	int drift_group;    /* group whose velocities change by the drift when they cross a periodic face */
	struct ts_lattice lattice; /* lattice constant 1 without a `lattice` command */
	bool units_warned;
	int processors[3]; /* command processors: blocks along each dimension; 0: any number */
};

/* Returns an error if there is no box yet. */
enum ts_status ts_domain_require(struct tsim *sim, const struct ts_place *where);

/* Parses the boundary styles of x, y and z: p, f, s, m, or two letters for low and high face. */
enum ts_status ts_domain_read_faces(struct tsim *sim, const char *const text[3], const struct ts_place *where,
				    enum ts_face face[3][2]);

/* Sets the box to lo .. hi, which is also the minimum box of `m` faces; `s` faces start a margin
 * outside. Returns an error if the box has no volume, or is not valid for `dimension 2`. */
enum ts_status ts_domain_set_box(struct tsim *sim, const double lo[3], const double hi[3],
				 const struct ts_place *where);
/* Called at each rebuild of the contact list: periodic images refer to the present box. */
void ts_domain_hold(struct ts_domain *domain);
/* Upper bound of the distance that periodic images have moved relative to their originals since the
 * last rebuild. */
double ts_domain_moved(const struct ts_domain *domain);
/* Returns an error if fix deform has sheared the box, which the command `what` does not know. */
enum ts_status ts_domain_refuse_shear(struct tsim *sim, const char *what, const struct ts_place *where);
/* Before a rebuild: keeps the offset of a sheared box within half its length. */
void ts_domain_reduce_shear(struct ts_domain *domain);
/* Whether all faces of the box are of style f, so that particles that cross a face are deleted. */
bool ts_domain_all_fixed(const struct tsim *sim);
/* Distance between an `s` or `m` face and the outermost particle. */
double ts_domain_margin(const struct ts_domain *domain, int dim);

/* Factor from a length along `dim` with `units lattice|box` (0|1) to a length of the simulation. -1,
 * not given: box as in LIGGGHTS, but with units lj lattice as in LAMMPS. */
double ts_domain_scale(const struct tsim *sim, int units, int dim);
/* Warns once if units are not given and LIGGGHTS and LAMMPS would interpret lengths differently. */
void ts_domain_units_said(struct tsim *sim, int units, const struct ts_place *where);

extern const struct ts_system_style ts_domain_system;

#endif
