/* Recession of a surface of triangles: its nodes move along their normals so that the volume between old and new surface
 * is a given one, node by node.
 *
 * While all corners move along straight lines, x + s d with s from 0 to 1, a triangle of area vector a(s) sweeps
 *
 *	V = int_0^1 (d_0 + d_1 + d_2)/3 . a(s) ds,  a = (x_1 - x_0) x (x_2 - x_0) / 2
 *
 * exactly: the velocity of its points is linear in the triangle, and a quadratic in s. Summed over the triangles this is
 * the volume between the surfaces: of a closed mesh its change, of an open one with the walls that its rim sweeps. So
 * node v has the part d_v . A_v, A_v = sum over its triangles of int a ds/3, and the displacement -h_v n_v along the
 * normal n_v, the direction of A_v before, is found from h_v n_v . A_v = V_v. These equations are coupled, as A_v depends
 * on all nodes around v; they are iterated node after node (Gauss-Seidel). Nodes with V_v = 0 do not move. */
#ifndef TS_MESH_MESH_RECESSION_H
#define TS_MESH_MESH_RECESSION_H

#include "mesh/mesh_nodes.h"

/* name, what is wrong with the triangle */
#define TS_MESH_RECESSION_LIST(X)                                                              \
	X(FINE, "")                                                                            \
	X(NO_NORMAL, "has a corner around which the areas cancel: no normal is defined there") \
	X(TOO_FAR, "has a corner that would recede farther than the surface around it allows") \
	X(TURNED, "would turn by more than a right angle, or lose its area")                   \
	X(NEEDLE, "would have an angle below 0.0181185 degrees")                               \
	X(FOLDED, "would be folded onto its neighbour")                                        \
	X(PIERCED, "would pass through another triangle")

#define TS_MESH_RECESSION_ENUM(name, what) TS_MESH_RECESSION_##name,
enum ts_mesh_recession_fault { TS_MESH_RECESSION_LIST(TS_MESH_RECESSION_ENUM) TS_NMESH_RECESSION_FAULTS };
#undef TS_MESH_RECESSION_ENUM
extern const char *const ts_mesh_recession_texts[TS_NMESH_RECESSION_FAULTS];

struct ts_mesh_recession_finding {
	enum ts_mesh_recession_fault fault;
	size_t triangle, other; /* `other`: the second one of FOLDED and PIERCED */
};

/* Moves the nodes. volume[v] is what node v loses, length^3, on the side to which the normal of a triangle times
 * nodes->side points; swept[v] what it has lost in the positions `to`, which are rounded. `from` and `to` are corners
 * [triangle][corner][dimension]. `mesh`: topology. With a fault, which refuses the motion, `to` and `swept` are
 * undefined. Fails without memory. */
enum ts_status ts_mesh_recession(const struct ts_mesh *mesh, const struct ts_mesh_nodes *nodes,
				 const double (*from)[3][3], const double *volume, double (*to)[3][3],
				 double *swept, struct ts_mesh_recession_finding *finding);

#endif
