/* The first touch of a sphere on its path with the surface of a wall: for `impact exact` (impact/exact_impacts.h) and for
 * particles that are inserted where they have flown (wall/wall_flight.h). */
#ifndef TS_WALL_EXACT_SURFACE_H
#define TS_WALL_EXACT_SURFACE_H

#include "core/sim.h"
#include "geom/sweep.h"
#include "mesh/mesh_tree.h"

/* The first touch of a particle with a surface. */
struct ts_exact_touch {
	struct ts_sweep_hit hit;
	double velocity[3];	 /* of the surface at the point of contact */
	double point[3];	 /* of contact, in the frame of the surface */
	double curvature;	 /* see struct ts_wall_contact_point */
	int type;		 /* particle type whose material it has */
	size_t surface, element; /* number of the mesh in the wall, or 0; of the triangle or plane */
};

/* A sort of surface, at rest or moving without rotation and with a constant velocity during the step. `shape`: the
 * struct ts_primitive_wall, ts_mesh_wall or ts_voxel_wall. */
struct ts_exact_surface {
	/* Before a run: fails if the surface will rotate. NULL: it does not. */
	enum ts_status (*plan)(struct tsim *sim, const void *shape);
	/* Before the search of a step; may fail if the surface rotates. NULL: nothing to do. */
	enum ts_status (*prepare)(struct tsim *sim, void *shape);
	/* The same where a surface that rotates is taken to be at rest in its present position. */
	enum ts_status (*update)(struct tsim *sim, void *shape);
	/* Whether the sphere touches the surface on its path, which ends with the step; the present position of
	 * the surface is that at the end of the step. Called by several threads. `list`: buffer. */
	enum ts_status (*sweep)(const struct tsim *sim, const void *shape, size_t i,
				const struct ts_sweep *path, struct ts_mesh_list *list, bool *found,
				struct ts_exact_touch *out);
};

#endif
