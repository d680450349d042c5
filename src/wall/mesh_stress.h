/* What particles do to a mesh: force on each triangle, force and torque on all of it, wear.
 *
 *   PRE_FORCE        ts_mesh_stress_clear by the fix of the mesh
 *   POST_FORCE       ts_mesh_stress_collect by each wall made of it
 *   FINAL_INTEGRATE  ts_mesh_stress_settle: outputs are those of the last whole step
 *
 * Sums are made triangle by triangle and there in the order of the particles' identities: they do not
 * depend on where particles are in memory. */
#ifndef TS_WALL_MESH_STRESS_H
#define TS_WALL_MESH_STRESS_H

#include "wall/mesh_wall.h"

struct ts_mesh_stress {
	/* arguments */
	bool tracks;
	int wear_law;
	double given[3]; /* torques are about it; the mesh carries it along as its anchor */

	double (*load)[3]; /* force on each triangle, in the last computation of forces */
	double sum[2][3];  /* of it: force, torque */
	size_t near;	   /* contacts that may be before the next rebuild */
	/* as of the last whole step */
	double total[2][3];
	double *normal, *shear; /* of each triangle: |force| / area, across and along it */
	double *wear;		/* depth so far */
	double *k;		/* wear constant for particles of each type */
	int ntypes;
};
enum { TS_MESH_WEAR_OFF, TS_MESH_WEAR_FINNIE };
extern const char *const ts_mesh_wear_names[], *const ts_mesh_stress_names[];

#define TS_MESH_STRESS_ARGS(T, f)                                                     \
	TS_VEC3("reference_point", T, f.given, .fallback = "0 0 0", .unit = "length", \
		.help = "torques are about this point of the mesh as it is placed"),  \
		TS_BOOL("stress", T, f.tracks, .fallback = "yes",                     \
			.help = "whether force, torque and stresses are summed"),     \
		TS_ENUM("wear", T, f.wear_law, ts_mesh_wear_names, .fallback = "off", \
			.help = "finnie: depth worn from each triangle; needs property/global k_finnie")

/* f_ID[1..9]; the first member of the state is the surface. */
enum ts_status ts_mesh_stress_eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out);
#define TS_MESH_STRESS_VALUE                                                                        \
	{                                                                                           \
		"stress", "force, torque, length",                                                  \
			"force on the mesh and torque about the reference point in the last step, " \
			"and that point",                                                           \
			TS_VECTOR, 9, ts_mesh_stress_names, ts_mesh_stress_eval                     \
	}

/* In init, when the mesh is there: gives it the stress. */
enum ts_status ts_mesh_stress_init(struct ts_instance *self, struct tsim *sim,
				   struct ts_mesh_surface *surface, struct ts_mesh_stress *stress);

/* Slots of such a fix, for its surface as well: archive, fini, POST_BUILD; and for the stress alone:
 * PRE_FORCE, FINAL_INTEGRATE. */
enum ts_status ts_mesh_stress_archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *archive);
void ts_mesh_stress_fini(struct ts_instance *self);
enum ts_status ts_mesh_stress_post_build(struct ts_instance *self, struct tsim *sim);
enum ts_status ts_mesh_stress_clear(struct ts_instance *self, struct tsim *sim);
enum ts_status ts_mesh_stress_settle(struct ts_instance *self, struct tsim *sim);

/* Whether a mesh of the wall wants to know: then contacts keep reports. */
bool ts_mesh_stress_wanted(const struct ts_mesh_wall *mw);
enum ts_status ts_mesh_stress_collect(struct tsim *sim, const struct ts_wall *w, struct ts_mesh_wall *mw);

#endif
