/* Legacy VTK files, text or binary: POLYDATA and UNSTRUCTURED_GRID. */
#ifndef TS_MESH_MESH_VTK_H
#define TS_MESH_MESH_VTK_H

#include <stdint.h>

#include "geom/triangles.h"

struct ts_scan;

/* The points and cells of a file. Zero-initialise. */
struct ts_vtk_cells {
	double (*point)[3]; /* [npoints], length */
	size_t npoints, ncells;
	int64_t *offset; /* [ncells + 1]: index in `corner` of the first corner of each cell */
	int64_t *corner; /* indices of points, all valid */
	int *type;	 /* [ncells]: VTK's cell type: 5 triangle, 9 quadrilateral, 10 tetrahedron ... */
	int *line;	 /* [ncells]: line of the file, for messages; 0: binary file */
	size_t point_capacity, offset_capacity, corner_capacity, type_capacity, line_capacity;
	const char *file; /* its name, owned by the pool of the scan */
};

/* Reads the cells; data of points and cells are ignored. */
enum ts_status ts_vtk_read(struct ts_scan *s, struct ts_vtk_cells *cells);
/* Appends the surface cells to the soup, split into triangles; refuses solid cells. */
enum ts_status ts_vtk_triangles(struct ts_scan *s, struct ts_triangles *soup);
void ts_vtk_cells_release(struct ts_vtk_cells *cells);

#endif
