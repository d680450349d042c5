/* Lattices that positions can be taken from. */
#ifndef TS_PARTICLES_LATTICE_H
#define TS_PARTICLES_LATTICE_H

struct ts_lattice {
	int dimension;
	double cell[3]; /* edges of the rectangular unit cell, in lattice constants */
	int nbasis;
	double basis[8][3]; /* in units of the edges */
};

/* Names, closed by NULL; domain->lattice_style is an index into it. The last one, none, has no
 * points. */
extern const char *const ts_lattice_names[];
/* The lattice of that index; NULL for none and for -1. */
const struct ts_lattice *ts_lattice_get(int style);

#endif
