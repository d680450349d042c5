/* Normals at the corners of triangles, for meshes that are shaded as curved surfaces: the word smooth. */
#ifndef TS_IMAGE_IMAGE_SMOOTH_H
#define TS_IMAGE_IMAGE_SMOOTH_H

#include "mesh/mesh.h"

/* normal[t][c]: at corner c of triangle t the mean of the normals of the triangles that share the corner and whose planes
 * differ from that of t by less than `angle` (degrees), weighted by their angles there. Edges that are sharper stay sharp. */
enum ts_status ts_image_corner_normals(const struct ts_mesh *mesh, double angle, float (*normal)[3][3]);

#endif
