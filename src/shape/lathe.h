/* Surfaces of revolution about z. */
#ifndef TS_SHAPE_LATHE_H
#define TS_SHAPE_LATHE_H

#include "shape/facets.h"

/* Longest cells of curved surfaces and of flat ones, in units of their width. */
enum { TS_LATHE_ASPECT = 8, TS_LATHE_FLAT_ASPECT = 50 };

/* Revolves the polyline of n points (r, z) about z. Its normals point to the right of the direction from the
 * first point to the last: outwards, if a solid is traced from its bottom on the axis over its side to its
 * top. */
void ts_lathe(struct ts_facets *f, const double (*profile)[2], size_t n);

#endif
