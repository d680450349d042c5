/* Topology of a mesh: shared vertices, neighbours, active edges and corners. */
#ifndef TS_MESH_MESH_LINKS_H
#define TS_MESH_MESH_LINKS_H

#include "geom/box.h"
#include "mesh/mesh.h"

/* Computes vertex, neighbour and active of a mesh from its geometry. `box`: corners that differ by lengths of
 * its periodic dimensions are the same vertex; NULL: they are not. */
enum ts_status ts_mesh_link(struct ts_mesh *mesh, double precision, const struct ts_box *box);

/* After a change of the shape: computes which edges and corners are active; the topology is as before. Edges that more
 * than two triangles share stay as they are. To be called after ts_mesh_update_geometry. */
enum ts_status ts_mesh_update_active(struct ts_mesh *mesh);

#endif
