/* Volume, centre and moments of the space that a closed mesh encloses. */
#ifndef TS_MESH_MESH_VOLUME_H
#define TS_MESH_MESH_VOLUME_H

#include "mesh/mesh.h"

struct ts_mesh_volume {
	double volume; /* < 0: normals point inwards */
	double centre[3];
	double inertia[6]; /* of density 1 about the centre: xx, yy, zz, xy, xz, yz */
};

/* False: the triangles enclose no volume, or not one and the same from all sides: the mesh has a hole,
 * ends at periodic faces, or some normals point inwards and others outwards. Exact to round-off: each
 * triangle makes a tetrahedron with a place amid the corners (B. Mirtich, J. Graphics Tools 1 (1996) 31,
 * says the same by faces). */
bool ts_mesh_measure_volume(const struct ts_mesh *mesh, struct ts_mesh_volume *out);

#endif
