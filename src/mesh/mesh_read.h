/* Files of triangles: STL as text or binary, Wavefront OBJ, legacy VTK as text or binary; each also
 * compressed by gzip. What a file is, is seen from its bytes, not from its name (OBJ excepted). */
#ifndef TS_MESH_MESH_READ_H
#define TS_MESH_MESH_READ_H

#include "base/files.h"
#include "mesh/mesh_vtk.h"
#include "mesh/triangles.h"

struct ts_pool;

/* Adds the triangles of the file to the soup. `where` is blamed if it cannot be opened; what is wrong in
 * the file is shown with its line there. */
enum ts_status ts_mesh_read(struct ts_triangles *soup, struct ts_files *files, struct ts_error *err,
			    struct ts_pool *pool, const struct ts_place *where, const char *path);
/* The same from memory; `name` stands for the file in messages. */
enum ts_status ts_mesh_parse(struct ts_triangles *soup, struct ts_error *err, struct ts_pool *pool,
			     const char *name, const char *bytes, size_t n);

/* Reads the points and cells of a VTK file, of any cell type. Release them by ts_vtk_cells_release. */
enum ts_status ts_vtk_cells_read(struct ts_vtk_cells *cells, struct ts_files *files, struct ts_error *err,
				 struct ts_pool *pool, const struct ts_place *where, const char *path);

#endif
