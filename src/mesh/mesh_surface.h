/* Meshes by name, as `fix mesh/surface` and its kin give them. Fixes that need a mesh - walls, moves,
 * stresses, insertion faces, dumps - find it here by the id of its fix:
 *
 *   struct ts_mesh_surface *surface;
 *   TS_TRY(ts_mesh_surface_require(sim, &word, &surface));
 *
 * in init (which is called again before each run): the mesh lives until its fix is deleted or given anew.
 * All of them in script order: ts_mesh_surface_next. */
#ifndef TS_MESH_MESH_SURFACE_H
#define TS_MESH_MESH_SURFACE_H

#include "core/sim.h"
#include "geom/motion.h"
#include "math/minstd.h"
#include "math/vec3.h"
#include "mesh/mesh.h"

#define TS_FAMILY_MESH "mesh"

/* What a mover does to a mesh; see mesh/mesh_motion.h. */
struct ts_mesh_motion {
	struct ts_motion now;	  /* since the mover was made, were it alone */
	double drift[3], spin[3]; /* velocity; angular velocity about the centre */
	double centre[3];	  /* now.origin, moved by the movers before */
};
enum { TS_MESH_MOTION = sizeof(struct ts_mesh_motion) / sizeof(double) };

/* First member of the state of every style of TS_FAMILY_MESH. */
struct ts_mesh_surface {
	struct ts_mesh mesh;	 /* as it stands now */
	int64_t type;		 /* particle type whose material it has */
	struct ts_minstd random; /* of who draws points on it; state 0: nobody yet */
	double temperature;	 /* for fix heat/gran; NaN: it conducts no heat */
	double extrusion; /* length by which its outer edges are moved to make another mesh; NaN: none */
	/* Velocity of the surface at each corner, [triangle][corner]; within a triangle it is linear.
	 * NULL: at rest. */
	double (*v)[3][3];
	uint64_t moves; /* grows whenever the mesh changes its place */
	bool observed; /* a fix reads its contacts (wall/surface_contacts.h); those of immobile particles count */
	struct ts_mesh_stress *stress; /* forces on it, of fix mesh/surface/stress; else NULL */

	/* of its movers; mesh/mesh_motion.h */
	double (*home)[3][3];		  /* corners without the motions; NULL: never moved */
	double anchor[3], anchor_home[3]; /* a point that goes along, for who needs one */
	struct ts_motion carried;	  /* from home, by several movers together */
	struct ts_mesh_motion *motion;
	int64_t *serial; /* of each motion */
	size_t nmotions, motion_capacity, serial_capacity;
	int64_t serials;  /* given so far */
	double travelled; /* since the last rebuild, at most */
};

/* Velocity at the point of a triangle that is the sum of weight[k] * corner k. */
static inline void ts_mesh_surface_velocity(const struct ts_mesh_surface *s, size_t t, const double weight[3],
					    double v[3])
{
	v[0] = v[1] = v[2] = 0;
	for (int k = 0; s->v && k < 3; k++)
		ts_axpy(weight[k], s->v[t][k], v);
}

/* NULL: there is no mesh of that id. */
struct ts_mesh_surface *ts_mesh_surface_find(const struct tsim *sim, const char *id);
/* The same, or an error at the word with a suggestion. */
enum ts_status ts_mesh_surface_require(struct tsim *sim, const struct ts_word *id,
				       struct ts_mesh_surface **out);
/* The k-th in script order, start with *k = 0; NULL: no more. `by` may be NULL: its fix. */
struct ts_mesh_surface *ts_mesh_surface_next(const struct tsim *sim, size_t *k, struct ts_instance **by);

#endif
