/* Volume, centroid and moments of inertia of the space that a closed mesh encloses. */
#ifndef TS_MESH_MESH_VOLUME_H
#define TS_MESH_MESH_VOLUME_H

#include "mesh/mesh.h"

struct ts_mesh_volume {
	double volume;	   /* < 0: normals point inwards */
	double centre[3];  /* centroid, length */
	double inertia[6]; /* for density 1 about the centroid: xx, yy, zz, xy, xz, yz; length^5 */
};

/* Sums over the tetrahedra of each triangle and the middle of the bounding box, exact to round-off (B.
 * Mirtich, J. Graphics Tools 1 (1996) 31, has the equivalent sums over faces). False: the triangles do not
 * enclose a volume: the mesh has a hole, ends at periodic faces, or some normals point inwards and others
 * outwards. */
bool ts_mesh_measure_volume(const struct ts_mesh *mesh, struct ts_mesh_volume *out);

#endif
