/* Forces of particles on a mesh: on each triangle; force and torque on all of it; wear.
 *
 *   late[TS_LATE_CONTACTS]  ts_mesh_stress_sum
 *   FINAL_INTEGRATE         ts_mesh_stress_settle: outputs are those of the last whole step */
#ifndef TS_LOAD_MESH_STRESS_H
#define TS_LOAD_MESH_STRESS_H

#include "load/mesh_wear.h"

struct ts_mesh_stress {
	/* arguments */
	bool tracks;
	struct ts_mesh_wear wear;
	double given[3]; /* torques are about it; the mesh carries it along as its anchor */
	bool followed;	 /* the force moves the mesh: it is needed in each step */
	bool unsummed; /* particles are divided among ranks, and no output has needed the force of this step */

	double (*load)[3]; /* force on each triangle, in the last computation of forces */
	double sum[2][3];  /* of it: force, torque */
	/* as of the last whole step */
	double total[2][3];
	double *normal, *shear; /* of each triangle: |force| / area, across and along it */
};

#define TS_MESH_STRESS_ARGS(T, f)                                                     \
	TS_VEC3("reference_point", T, f.given, .fallback = "0 0 0", .unit = "length", \
		.help = "torques are about this point of the mesh as it is placed"),  \
		TS_BOOL("stress", T, f.tracks, .fallback = "yes",                     \
			.help = "whether force, torque and stresses are summed"),     \
		TS_ENUM("wear", T, f.wear.law, ts_mesh_wear_names, .fallback = "off", \
			.help = "finnie: depth worn from each triangle; needs property/global k_finnie")

/* f_ID[1..9]; the first member of the state is the surface. */
enum ts_status ts_mesh_stress_eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out);
#define TS_MESH_STRESS_NAMES "fx", "fy", "fz", "tx", "ty", "tz", "x", "y", "z"

/* f_ID[1..6] of each triangle. */
enum ts_status ts_mesh_stress_eval_triangles(struct ts_instance *self, const struct tsim *sim,
					     struct ts_table *out);
const struct ts_instance *ts_mesh_stress_surface(const struct ts_instance *self);
extern const char *const ts_mesh_stress_triangle_names[];
#define TS_MESH_STRESS_TRIANGLES                                                                         \
	{                                                                                                \
		"triangles", "stress, length",                                                           \
			"of each triangle: normal stress, shear stress, the vector force / area, depth " \
			"worn",                                                                          \
			TS_SURFACE, 6, ts_mesh_stress_triangle_names, ts_mesh_stress_eval_triangles      \
	}

/* In init, when the mesh is there: gives it the stress. */
enum ts_status ts_mesh_stress_init(struct ts_instance *self, struct tsim *sim,
				   struct ts_mesh_surface *surface, struct ts_mesh_stress *stress);

/* Slots of such a fix, for its surface as well: archive, fini, POST_BUILD; and for the stress alone. */
enum ts_status ts_mesh_stress_archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *archive);
void ts_mesh_stress_fini(struct ts_instance *self);
enum ts_status ts_mesh_stress_post_build(struct ts_instance *self, struct tsim *sim);
enum ts_status ts_mesh_stress_sum(struct ts_instance *self, struct tsim *sim);
enum ts_status ts_mesh_stress_settle(struct ts_instance *self, struct tsim *sim);
/* Slot `join`. */
enum ts_status ts_mesh_stress_join(struct ts_instance *self, struct tsim *sim);

/* Order of TS_MESH_STRESS_ARGS in the manual pages. */
#define TS_MESH_STRESS_GROUP                                                    \
	{                                                                       \
		"Force, torque, stress and wear", "stress reference_point wear" \
	}

#endif
