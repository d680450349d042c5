/* The nodes of a mesh: the triangles around each vertex, and on which side of each triangle the outside is. Files of
 * meshes may have any winding of the triangles; here those of each connected part are made consistent across shared
 * edges. Depends on the topology of the mesh only: stays valid when it moves. */
#ifndef TS_MESH_MESH_NODES_H
#define TS_MESH_MESH_NODES_H

#include "mesh/mesh.h"

/* Why the nodes of a mesh cannot be moved. */
enum ts_mesh_nodes_fault {
	TS_MESH_NODES_FINE,
	TS_MESH_NODES_BRANCHED,	 /* more than two triangles share an edge */
	TS_MESH_NODES_ONE_SIDED, /* the windings cannot be made consistent: a Moebius strip */
	TS_MESH_NODES_PINCHED	 /* two parts share a vertex, but no edge there */
};

struct ts_mesh_nodes {
	size_t n;	 /* vertices of the mesh */
	uint32_t *start; /* [n + 1] corners at vertex v: corner[start[v]] .. corner[start[v + 1] - 1] */
	int32_t *corner; /* 3 * triangle + k, ascending for each vertex */
	int8_t *side;	 /* [triangles] 1; -1: wound against the first triangle of its part */
	int32_t *part;	 /* [triangles] connected part, 0 .. parts-1 */
	int32_t parts;
};

/* *fault is not FINE: *triangle is where, and nothing is allocated. Fails without memory. The nodes must be zero or
 * released before. */
enum ts_status ts_mesh_nodes_build(struct ts_mesh_nodes *nodes, const struct ts_mesh *mesh,
				   enum ts_mesh_nodes_fault *fault, size_t *triangle);
void ts_mesh_nodes_release(struct ts_mesh_nodes *nodes);

#endif
