/* Depth worn from each triangle of a mesh by the particles that touch it (law/contact_wear.h). */
#ifndef TS_LOAD_MESH_WEAR_H
#define TS_LOAD_MESH_WEAR_H

#include "mesh/mesh_surface.h"
#include "wall/surface_contacts.h"

struct ts_mesh_wear {
	int law;
	double *depth; /* [triangle], so far; zeros with TS_MESH_WEAR_OFF */
	double *k;     /* [type], wear constant of particles of each type, from 1 */
};
enum { TS_MESH_WEAR_OFF, TS_MESH_WEAR_FINNIE };
extern const char *const ts_mesh_wear_names[];

/* In the init and the POST_BUILD of the fix of the mesh; its word `wear` is the place of errors. */
enum ts_status ts_mesh_wear_init(struct ts_instance *self, struct tsim *sim,
				 const struct ts_mesh_surface *surface, struct ts_mesh_wear *wear);
enum ts_status ts_mesh_wear_find_constants(struct ts_instance *self, struct tsim *sim,
					   const struct ts_mesh_surface *surface, struct ts_mesh_wear *wear);
/* What a contact wears off in a step. */
void ts_mesh_wear_add(const struct ts_mesh_surface *surface, const struct ts_surface_contact *c,
		      struct ts_mesh_wear *wear);
void ts_mesh_wear_release(struct ts_mesh_wear *wear);

#endif
