/* Where particles are to be made: positions with their types, collected before any is made. */
#ifndef TS_INSERT_SITES_H
#define TS_INSERT_SITES_H

#include "core/sim.h"

struct ts_site {
	double x[3];
	int type;
};

struct ts_sites {
	struct ts_site *site;
	size_t n, capacity;
};

enum ts_status ts_sites_add(struct tsim *sim, struct ts_sites *sites, const double x[3], int type);
void ts_sites_release(struct ts_sites *sites);

/* In the box, whose upper faces are outside of it: they are the lower ones of the next box. */
bool ts_sites_in_box(const struct tsim *sim, const double x[3]);

/* The part of the box that a region, or NULL, can reach; lo >= hi where there is none. */
void ts_sites_limits(const struct tsim *sim, const struct ts_instance *region, double lo[3], double hi[3]);

/* All lattice points in the box and the region, or NULL, in the order z, y, x of cells, then of the points
 * in a cell. type_of_basis[k]: type of point k. Across periodic faces the window that is filled is 1e-6
 * lengths below the box, and 1e-6 shorter, so that rounding neither loses nor doubles points on faces. */
enum ts_status ts_sites_on_lattice(struct tsim *sim, const struct ts_instance *region,
				   const int *type_of_basis, const struct ts_place *where,
				   struct ts_sites *sites);

/* Keeps `count` of them, chosen at random; in their order. */
enum ts_status ts_sites_choose(struct tsim *sim, struct ts_sites *sites, size_t count, uint64_t seed);

#endif
