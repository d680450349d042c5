/* Readers of mesh files: STL (text or binary), Wavefront OBJ, legacy VTK (text or binary), each also
 * compressed by gzip. The format is recognised by the content of the file, that of OBJ by the name. */
#ifndef TS_MESH_MESH_READ_H
#define TS_MESH_MESH_READ_H

#include "base/files.h"
#include "mesh/mesh_vtk.h"
#include "geom/triangles.h"

struct ts_pool;

/* Appends the triangles of the file to the soup. `where`: place of the message if the file cannot be
 * opened; messages about its content show the line of the file. */
enum ts_status ts_mesh_read(struct ts_triangles *soup, struct ts_files *files, struct ts_error *err,
			    struct ts_pool *pool, const struct ts_place *where, const char *path);
/* The same from memory; `name`: file name in messages. */
enum ts_status ts_mesh_parse(struct ts_triangles *soup, struct ts_error *err, struct ts_pool *pool,
			     const char *name, const char *bytes, size_t n);

/* Reads the points and cells of a VTK file, of any cell type. Release them by ts_vtk_cells_release. */
enum ts_status ts_vtk_cells_read(struct ts_vtk_cells *cells, struct ts_files *files, struct ts_error *err,
				 struct ts_pool *pool, const struct ts_place *where, const char *path);

#endif
