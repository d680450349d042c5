/* The surface of a union of tetrahedra or hexahedra: the faces that have cells on one side only. */
#ifndef TS_MESH_CELL_SURFACE_H
#define TS_MESH_CELL_SURFACE_H

#include "mesh/mesh_tree.h"

/* Zero-initialise. */
struct ts_cell_surface {
	struct ts_mesh mesh; /* quadrangles are split into two triangles */
	struct ts_mesh_tree tree;
};

/* Builds the surface of n cells of `corners` corners each: 4, a tetrahedron, or 8, a hexahedron, in the order of VTK. x: their
 * corners one cell after the other, length; those nearer to each other than `precision` are one. Cells that overlap keep faces
 * inside of the union, so that distances are lower bounds. Fails without memory (TS_NOMEM), or with too many faces (TS_RANGE);
 * nothing is allocated then. */
enum ts_status ts_cell_surface_build(struct ts_cell_surface *surface, const double (*x)[3], size_t n,
				     int corners, double precision);
/* The distance of x from the surface; INFINITY if there is none. */
double ts_cell_surface_distance(const struct ts_cell_surface *surface, const double x[3]);
void ts_cell_surface_release(struct ts_cell_surface *surface);

#endif
