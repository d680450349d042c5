/* Wavefront OBJ files. */
#ifndef TS_MESH_MESH_OBJ_H
#define TS_MESH_MESH_OBJ_H

#include "mesh/mesh_scan.h"

/* Appends the triangles of the file to the soup; polygons are split into triangles. */
enum ts_status ts_obj_read(struct ts_scan *s, struct ts_triangles *soup);

#endif
