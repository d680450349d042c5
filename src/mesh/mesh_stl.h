/* STL files, text or binary. */
#ifndef TS_MESH_MESH_STL_H
#define TS_MESH_MESH_STL_H

#include "mesh/mesh_scan.h"

/* Appends the triangles of the file to the soup. */
enum ts_status ts_stl_read(struct ts_scan *s, struct ts_triangles *soup);

#endif
