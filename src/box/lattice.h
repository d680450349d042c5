/* Lattices: points that particles can be put on, and the lengths of `units lattice`. */
#ifndef TS_BOX_LATTICE_H
#define TS_BOX_LATTICE_H

#include <stdbool.h>
#include <stddef.h>

#include "core/sim.h"

struct ts_lattice {
	int style;	      /* index into ts_lattice_names; -1: none defined */
	double constant;      /* length of 1 in the edges below */
	double edge[3][3];    /* of the unit cell: a1, a2, a3 */
	double turn[3][3];    /* row d: what of the crystal points along d, a unit vector */
	double origin[3];     /* in spacings */
	double spacing[3];    /* extent of the unit cell along x, y, z: the unit of lengths */
	double inverse[3][3]; /* of the matrix with columns a1, a2, a3 */
	double (*basis)[3];   /* in units of the edges */
	size_t nbasis, capacity;
};

extern const char *const ts_lattice_names[]; /* closed by NULL */
enum { TS_LATTICE_NONE = 8, TS_LATTICE_CUSTOM };

/* Dimension of a named lattice; 0 for none and custom. */
int ts_lattice_dimension(int style);
/* Constant 1, no points. */
void ts_lattice_clear(struct ts_lattice *lattice);
/* Edges and points of a named lattice, orientation along the axes; only edges 1 for none and custom. */
enum ts_status ts_lattice_start(struct ts_lattice *lattice, int style);
enum ts_status ts_lattice_add_basis(struct ts_lattice *lattice, const double point[3]);
/* a1 . (a2 x a3) */
double ts_lattice_cell_volume(const struct ts_lattice *lattice);
/* After edges, turn, constant have been set: fills inverse and spacing. */
void ts_lattice_finish(struct ts_lattice *lattice);
void ts_lattice_release(struct ts_lattice *lattice);
enum ts_status ts_lattice_archive(struct ts_lattice *lattice, struct tsim *sim, struct ts_archive *archive);

/* From coordinates along a1, a2, a3 to space, and back. */
void ts_lattice_to_space(const struct ts_lattice *lattice, const double cell[3], double x[3]);
void ts_lattice_from_space(const struct ts_lattice *lattice, const double x[3], double cell[3]);

#endif
