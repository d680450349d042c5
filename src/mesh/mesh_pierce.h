/* Triangles of a mesh that pass through each other after some of its nodes have moved. */
#ifndef TS_MESH_MESH_PIERCE_H
#define TS_MESH_MESH_PIERCE_H

#include "mesh/mesh.h"

/* Finds a pair of triangles, one of them with `moved`, of which an edge of one passes through the inside of the other in
 * the positions `to` of the corners, but not in `from`. Pairs that share an edge are not looked at. Contacts shallower
 * than 1e-9 of the edge do not count. *found false: there is none. */
enum ts_status ts_mesh_pierce(const struct ts_mesh *mesh, const double (*from)[3][3],
			      const double (*to)[3][3], const uint8_t *moved, bool *found, size_t pair[2]);

#endif
