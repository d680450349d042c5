/* Lattices: points for create_atoms, and the unit of lengths with `units lattice`. */
#ifndef TS_BOX_LATTICE_H
#define TS_BOX_LATTICE_H

#include <stdbool.h>
#include <stddef.h>

#include "core/sim.h"

struct ts_lattice {
	int style;	   /* index into ts_lattice_names; -1: none defined */
	double constant;   /* lattice constant: length of the unit of the edges below */
	double edge[3][3]; /* edges a1, a2, a3 of the unit cell, in lattice constants */
	double turn[3][3]; /* rotation matrix; row d: unit vector of the crystal that points along axis d */
	double origin[3];  /* in units of the spacings */
	/* extent of the rotated unit cell along x, y, z: the unit of lengths with `units lattice` */
	double spacing[3];
	double inverse[3][3]; /* of the matrix with columns a1, a2, a3 */
	double (*basis)[3];   /* points of the unit cell, in units of the edges */
	size_t nbasis, capacity;
};

extern const char *const ts_lattice_names[]; /* NULL-terminated */
enum { TS_LATTICE_NONE = 8, TS_LATTICE_CUSTOM };

/* Dimension of a named lattice; 0 for none and custom. */
int ts_lattice_dimension(int style);
/* No lattice: constant 1, no points. */
void ts_lattice_clear(struct ts_lattice *lattice);
/* Sets edges and points of a named lattice, oriented along the axes; unit edges and no points for none
 * and custom. */
enum ts_status ts_lattice_start(struct ts_lattice *lattice, int style);
enum ts_status ts_lattice_add_basis(struct ts_lattice *lattice, const double point[3]);
/* a1 . (a2 x a3) */
double ts_lattice_cell_volume(const struct ts_lattice *lattice);
/* Computes inverse and spacing, after edges, rotation and constant have been set. */
void ts_lattice_finish(struct ts_lattice *lattice);
void ts_lattice_release(struct ts_lattice *lattice);
enum ts_status ts_lattice_archive(struct ts_lattice *lattice, struct tsim *sim, struct ts_archive *archive);

/* Coordinates along a1, a2, a3 to positions, and back. */
void ts_lattice_to_space(const struct ts_lattice *lattice, const double cell[3], double x[3]);
void ts_lattice_from_space(const struct ts_lattice *lattice, const double x[3], double cell[3]);

#endif
