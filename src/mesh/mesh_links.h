/* How the triangles of a mesh hang together: shared corners, neighbours, active edges and corners. */
#ifndef TS_MESH_MESH_LINKS_H
#define TS_MESH_MESH_LINKS_H

#include "geom/box.h"
#include "mesh/mesh.h"

/* Fills vertex, neighbour and active of a mesh whose shape is known. `box`: corners that differ by lengths of
 * its periodic dimensions are the same; NULL: they are not. */
enum ts_status ts_mesh_link(struct ts_mesh *mesh, double precision, const struct ts_box *box);

#endif
