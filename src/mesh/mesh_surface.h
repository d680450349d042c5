/* Meshes by name, as defined by `fix mesh/surface` and related fixes. Styles that need a mesh (walls, movers,
 * insertion, dumps) find it by the ID of its fix:
 *
 *   struct ts_mesh_surface *surface;
 *   TS_TRY(ts_mesh_surface_require(sim, &word, &surface));
 *
 * in init (which is called again before each run): the mesh exists until its fix is deleted or defined again.
 * ts_mesh_surface_next iterates over all meshes in script order. */
#ifndef TS_MESH_MESH_SURFACE_H
#define TS_MESH_MESH_SURFACE_H

#include "core/sim.h"
#include "geom/motion.h"
#include "math/minstd.h"
#include "math/vec3.h"
#include "mesh/mesh.h"

#define TS_FAMILY_MESH "mesh"

/* Motion of a mesh by a mover; see mesh/mesh_motion.h. */
struct ts_mesh_motion {
	struct ts_motion now;	  /* total motion since the mover was defined, without other movers */
	double drift[3], spin[3]; /* velocity; angular velocity about the centre, radian/time */
	double centre[3];	  /* now.origin, moved by the movers before, length */
};
enum { TS_MESH_MOTION = sizeof(struct ts_mesh_motion) / sizeof(double) };

/* First member of the state of every style of TS_FAMILY_MESH. */
struct ts_mesh_surface {
	struct ts_mesh mesh;	 /* at its present position */
	int64_t type;		 /* particle type whose material it has */
	struct ts_minstd random; /* generator for random points on the mesh; state 0: not used yet */
	double temperature;	 /* for fix heat/gran; NaN: it conducts no heat */
	double extrusion; /* length by which its outer edges are extruded to make another mesh; NaN: none */
	/* Velocity of the surface at each corner, [triangle][corner]; within a triangle it is linear.
	 * NULL: at rest. */
	double (*v)[3][3];
	bool has_mover;		       /* a mover is, or was, defined for it */
	uint64_t moves;		       /* incremented whenever the positions of the corners change */
	struct ts_mesh_stress *stress; /* forces on it, of fix mesh/surface/stress; else NULL */

	/* motion by movers, see mesh/mesh_motion.h */
	double (*home)[3][3];		  /* reference positions of the corners; NULL: never moved */
	double anchor[3], anchor_home[3]; /* a point that moves with the mesh, and its reference position */
	/* as the script gives them, to compare with a restart file: a hash of the corners, the anchor, whether the surface
	 * moves as a belt */
	uint64_t given;
	double anchor_given[3];
	bool belt;
	struct ts_motion carried;      /* total motion from the reference by several movers */
	struct ts_mesh_motion *motion; /* [nmotions] */
	int64_t *serial;	       /* [nmotions], serial numbers of the motions */
	size_t nmotions, motion_capacity, serial_capacity;
	int64_t serials;	   /* last serial number used */
	double travelled;	   /* upper bound of the displacement since the last rebuild, length */
	struct ts_mesh_worn *worn; /* how far it has receded by wear, see mesh/mesh_recede.h; NULL: not */
};

/* Velocity of the surface at the point sum of weight[k] * corner k of triangle t. */
static inline void ts_mesh_surface_velocity(const struct ts_mesh_surface *s, size_t t, const double weight[3],
					    double v[3])
{
	v[0] = v[1] = v[2] = 0;
	for (int k = 0; s->v && k < 3; k++)
		ts_axpy(weight[k], s->v[t][k], v);
}

/* Returns the mesh of this ID; NULL: there is none. */
struct ts_mesh_surface *ts_mesh_surface_find(const struct tsim *sim, const char *id);
/* The same; fails with an error at the word, and a suggestion, if there is none. */
enum ts_status ts_mesh_surface_require(struct tsim *sim, const struct ts_word *id,
				       struct ts_mesh_surface **out);
/* Iterates over all meshes in script order: start with *k = 0; returns NULL at the end. *by is the fix of
 * the mesh; `by` may be NULL. */
struct ts_mesh_surface *ts_mesh_surface_next(const struct tsim *sim, size_t *k, struct ts_instance **by);

#endif
