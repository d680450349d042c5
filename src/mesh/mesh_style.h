/* Common slots of the styles of TS_FAMILY_MESH. Their init is in mesh/mesh_load.h. */
#ifndef TS_MESH_MESH_STYLE_H
#define TS_MESH_MESH_STYLE_H

#include "mesh/mesh_surface.h"

void ts_mesh_surface_release(struct ts_mesh_surface *surface);

/* Slots for the styles of the family. */
enum ts_status ts_mesh_surface_post_build(struct ts_instance *self, struct tsim *sim);
enum ts_status ts_mesh_surface_archive(struct ts_instance *self, struct tsim *sim,
				       struct ts_archive *archive);
void ts_mesh_surface_fingerprint(const struct ts_instance *self, const struct tsim *sim,
				 struct ts_hash *hash);
enum ts_status ts_mesh_surface_plan(struct ts_instance *self, struct tsim *sim,
				    struct ts_plan_report *report);
void ts_mesh_surface_extent(const struct ts_instance *self, int dim, double *lo, double *hi);
void ts_mesh_surface_fini(struct ts_instance *self);

/* Before a run: fails unless the centre of each triangle is in the box, or beyond a periodic or moving
 * face. */
enum ts_status ts_mesh_surface_check_box(const struct ts_instance *by, struct tsim *sim,
					 const struct ts_mesh_surface *surface);

#endif
