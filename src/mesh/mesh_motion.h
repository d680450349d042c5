/* Meshes that move. A mesh has a place where it is at home. One mover alone carries it from there by its
 * motion so far, which it knows exactly. Several act in each step one after the other, in script order, as
 * LIGGGHTS has it: each moves what the mesh is by then, and the centres, but not the axes, of those after
 * it. When a mover is gone, the mesh is at home where it stands. */
#ifndef TS_MESH_MESH_MOTION_H
#define TS_MESH_MESH_MOTION_H

#include "mesh/mesh_surface.h"

#define TS_FAMILY_MESH_MOVER "mesh mover"

/* First member of the state of every style of TS_FAMILY_MESH_MOVER. */
struct ts_mesh_mover {
	const char *mesh; /* the ID of its fix */
	int64_t serial;	  /* of its motion in the mesh, saved; 0: not moved yet */
	double origin[3]; /* about which it turns the mesh */
};

/* In init: the mesh exists and may move. */
enum ts_status ts_mesh_mover_check(struct ts_instance *self, struct tsim *sim);
/* In INITIAL_INTEGRATE: this is its motion now. */
enum ts_status ts_mesh_mover_move(struct ts_instance *self, struct tsim *sim, const struct ts_mesh_motion *m);

/* Later in the step: its velocity has changed, not its place. */
enum ts_status ts_mesh_mover_drift(struct ts_instance *self, struct tsim *sim, const double drift[3],
				   const double spin[3]);

/* A mesh that moves by itself, without movers: this is its motion from where it was at first. */
enum ts_status ts_mesh_surface_carry(struct tsim *sim, struct ts_mesh_surface *surface,
				     const struct ts_motion *motion);

/* For the mesh: before a run, motions whose mover is gone end. */
void ts_mesh_motions_settle(const struct ts_instance *by, struct tsim *sim);
enum ts_status ts_mesh_motions_archive(struct ts_mesh_surface *surface, struct tsim *sim,
				       struct ts_archive *archive);
void ts_mesh_motions_release(struct ts_mesh_surface *surface);

#endif
