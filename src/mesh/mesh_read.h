/* Files of triangles: STL as text or binary, Wavefront OBJ, legacy VTK as text or binary; each also
 * compressed by gzip. What a file is, is seen from its bytes, not from its name (OBJ excepted). */
#ifndef TS_MESH_MESH_READ_H
#define TS_MESH_MESH_READ_H

#include <stdint.h>

#include "base/files.h"
#include "mesh/triangles.h"

struct ts_pool;

/* Adds the triangles of the file to the soup. `where` is blamed if it cannot be opened; what is wrong in
 * the file is shown with its line there. */
enum ts_status ts_mesh_read(struct ts_triangles *soup, struct ts_files *files, struct ts_error *err,
			    struct ts_pool *pool, const struct ts_place *where, const char *path);
/* The same from memory; `name` stands for the file in messages. */
enum ts_status ts_mesh_parse(struct ts_triangles *soup, struct ts_error *err, struct ts_pool *pool,
			     const char *name, const char *bytes, size_t n);

/* A VTK file as it is, for those who want more than its surface. Zero-initialise. */
struct ts_vtk_cells {
	double (*point)[3];
	size_t npoints, ncells;
	int64_t *offset; /* ncells + 1: where the corners of a cell begin in `corner` */
	int64_t *corner; /* indices of points, all valid */
	int *type;	 /* VTK's number of the shape: 5 triangle, 9 quadrilateral, 10 tetrahedron ... */
	int *line;	 /* 0: binary */
	size_t point_capacity, offset_capacity, corner_capacity, type_capacity, line_capacity;
	const char *file;
};
enum ts_status ts_vtk_cells_read(struct ts_vtk_cells *cells, struct ts_files *files, struct ts_error *err,
				 struct ts_pool *pool, const struct ts_place *where, const char *path);
void ts_vtk_cells_release(struct ts_vtk_cells *cells);

#endif
