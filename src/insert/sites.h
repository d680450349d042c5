/* Positions and types of particles to be created; they are collected before any particle is created. */
#ifndef TS_INSERT_SITES_H
#define TS_INSERT_SITES_H

#include "core/sim.h"

struct ts_site {
	double x[3];
	int32_t type;
	int32_t number; /* in the order of all sites, from 0 on; set by ts_sites_divide */
};

struct ts_sites {
	struct ts_site *site;
	size_t n, capacity;
	/* Consecutive parts of the sites: this one, of so many. 0 parts: these are all sites. */
	int part, parts;
};

enum ts_status ts_sites_add(struct tsim *sim, struct ts_sites *sites, const double x[3], int type);
void ts_sites_release(struct ts_sites *sites);

/* Of n rows those of this part begin at the returned one, and end before *end. */
size_t ts_sites_first(const struct ts_sites *sites, size_t n, size_t *end);

/* Numbers the sites; *all: of all parts. With several ranks, each of which has found one of the parts, or all sites, each gets
 * those in its block (particle/division.h) if particles can be made divided. All ranks call it. */
enum ts_status ts_sites_divide(struct tsim *sim, struct ts_sites *sites, size_t *all);

/* Whether lo <= x < hi: upper faces belong to the next periodic image. */
bool ts_sites_in_box(const struct tsim *sim, const double x[3]);

/* Intersection of the box and the bounds of the region (NULL: the box); lo >= hi if it is empty. */
void ts_sites_limits(const struct tsim *sim, const struct ts_instance *region, double lo[3], double hi[3]);

/* Adds all lattice points in the box and the region (or NULL), in the order z, y, x of cells, then of basis
 * points; of parts those of some rows of cells. type_of_basis[k]: type of basis point k. In periodic dimensions
 * the window is shifted by 1e-6 box lengths downwards and is 1e-6 shorter, so that rounding neither loses nor
 * duplicates points on faces. */
enum ts_status ts_sites_on_lattice(struct tsim *sim, const struct ts_instance *region,
				   const int *type_of_basis, const struct ts_place *where,
				   struct ts_sites *sites);

/* Keeps `count` of the sites, selected at random, in their order. */
enum ts_status ts_sites_choose(struct tsim *sim, struct ts_sites *sites, size_t count, uint64_t seed);

#endif
