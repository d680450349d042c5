/* Meshes that recede as they are worn (geom/recession.h): the volume of a triangle goes to its three nodes, a third to
 * each, which move along their normals (mesh_recession.h), away from the side on which particles touch.
 *
 * A mesh has no thickness and no inside: the material is behind the side of a connected part of the mesh on which most of
 * its volume has been worn so far. What has been worn on the other side, as at rims and sharp edges, is taken from there,
 * too. Of parts with a rim, which can be touched on both sides, more than a tenth of all is refused, as they would have to
 * move both ways.
 *
 * A triangle that has lost the volume `thickness` times its area, as defined, gives no more, or is removed (TS_MESH_REMOVED):
 * then it has no part in the volume that its nodes sweep.
 *
 * Positions are rounded, so a node may move by up to one digit less or more than its volume asks for; the difference is
 * kept and taken when its triangles are worn again: it does not grow. */
#ifndef TS_MESH_MESH_RECEDE_H
#define TS_MESH_MESH_RECEDE_H

#include "geom/recession.h"
#include "mesh/mesh_surface.h"

/* In init: fails if this mesh cannot recede in this way. `where`: place of the error. */
enum ts_status ts_mesh_recede_check(struct tsim *sim, struct ts_mesh_surface *surface,
				    const struct ts_recession *how, const struct ts_place *where);

/* Between the force computations of two steps: moves the nodes by what is due of the elements e[0 .. n-1], and renews all
 * that depends on their positions; sets taken, surplus and through of each. The sum of `taken` is the volume between old
 * and new surface. Fails, TS_PHYSICS, with the triangle that would be folded; then the mesh is as before. */
enum ts_status ts_mesh_recede(struct tsim *sim, struct ts_mesh_surface *surface,
			      const struct ts_recession *how, const struct ts_place *where,
			      struct ts_recession_element *e, size_t n);

/* Saved state of a mesh that has receded; after its motions are restored. */
enum ts_status ts_mesh_recede_archive(struct ts_mesh_surface *surface, struct tsim *sim,
				      struct ts_archive *archive);
void ts_mesh_recede_release(struct ts_mesh_surface *surface);

#endif
