/* Motion of meshes by movers, fixes of TS_FAMILY_MESH_MOVER. A mesh has reference positions of its
 * corners. With a single mover the positions are the total motion of this mover applied to the reference,
 * without accumulation of rounding errors. Several movers act in each step one after the other, in script
 * order, as in LIGGGHTS: each moves the mesh as left by the ones before, and the centres, but not the
 * axes, of those after it. When a mover is deleted, the present positions become the reference. */
#ifndef TS_MESH_MESH_MOTION_H
#define TS_MESH_MESH_MOTION_H

#include "mesh/mesh_surface.h"

#define TS_FAMILY_MESH_MOVER "mesh mover"

/* First member of the state of every style of TS_FAMILY_MESH_MOVER. */
struct ts_mesh_mover {
	const char *mesh; /* ID of the fix of the mesh */
	int64_t serial;	  /* serial number of its motion in the mesh, saved; 0: not moved yet */
	double origin[3]; /* centre of rotation, length */
	bool turns;	  /* it rotates the mesh whatever variables say; set in init */
};

/* In init: fails unless the mesh exists and may move. */
enum ts_status ts_mesh_mover_check(struct ts_instance *self, struct tsim *sim);
/* In INITIAL_INTEGRATE: moves the mesh to the motion m of this mover, and sets the velocity of its
 * corners. */
enum ts_status ts_mesh_mover_move(struct ts_instance *self, struct tsim *sim, const struct ts_mesh_motion *m);

/* Later in the step: changes the velocity and angular velocity (radian/time) of the motion, not the
 * positions. */
enum ts_status ts_mesh_mover_set_velocity(struct ts_instance *self, struct tsim *sim, const double drift[3],
					  const double spin[3]);

/* The first mover of this mesh; NULL: none. */
const struct ts_instance *ts_mesh_mover_of(const struct tsim *sim, const char *mesh);

/* Whether a mover rotates this mesh whatever variables say; between the init of all and the end of the run. */
bool ts_mesh_mover_turns(const struct tsim *sim, const char *mesh);

/* For a mesh that moves by itself, without movers: moves it to `motion`, relative to its initial position. */
enum ts_status ts_mesh_surface_set_motion(struct tsim *sim, struct ts_mesh_surface *surface,
					  const struct ts_motion *motion);

/* After a change of the reference positions of a mesh that moves: computes the present ones. */
void ts_mesh_surface_place(const struct tsim *sim, struct ts_mesh_surface *surface);

/* Before a run: ends the motions whose mover has been deleted. */
void ts_mesh_motions_remove_ended(const struct ts_instance *by, struct tsim *sim);
/* Fails if the mesh has moved, and the script that reads gives another one. */
enum ts_status ts_mesh_motions_archive(struct ts_instance *self, struct tsim *sim,
				       struct ts_archive *archive);
void ts_mesh_motions_release(struct ts_mesh_surface *surface);

#endif
