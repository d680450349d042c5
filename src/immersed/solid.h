/* Solids in a fluid: distance from their surface, and its velocity. One interface for regions, closed
 * meshes, height fields and spheres (particles). */
#ifndef TS_IMMERSED_SOLID_H
#define TS_IMMERSED_SOLID_H

#include <stdbool.h>

#include "core/sim.h"
#include "grid/grid.h"

struct ts_mesh;
struct ts_mesh_surface;
struct ts_voxel_surface;

/* The nearest point of the surface to a position. */
struct ts_solid_surface {
	double distance; /* length units; < 0 inside */
	double n[3];	 /* unit normal, out of the solid */
	double v[3];	 /* velocity of that point; inside the solid: velocity of the solid at the position */
};

enum ts_solid_side { TS_SOLID_NEAR, TS_SOLID_FAR };

struct ts_solid;
struct ts_solid_kind {
	/* Updates position and motion; sets `moved` if the solid has moved or changed since the last call. */
	enum ts_status (*update)(struct ts_solid *solid, struct tsim *sim);
	/* Bounding box of a part; infinite along axes without bound. */
	void (*bounds)(const struct ts_solid *solid, size_t part, double lo[3], double hi[3]);
	/* Finds the surface point nearest to x. TS_SOLID_FAR: the surface is farther than `reach`;
	 * *surface is undefined, also the side on which x lies. Called in parallel, with a different
	 * `worker` (0, 1, ...) in each thread. */
	enum ts_status (*find_surface)(struct ts_solid *solid, size_t worker, size_t part, const double x[3],
				       double reach, enum ts_solid_side *side,
				       struct ts_solid_surface *surface);
	bool (*inside)(const struct ts_solid *solid, size_t part, const double x[3]);
	void (*release)(struct ts_solid *solid);
	/* Allocates work memory for that many workers; NULL: none is needed. */
	enum ts_status (*team)(struct ts_solid *solid, size_t workers);
};

/* A rigid motion at one time: velocity of the centre, angular velocity. */
struct ts_solid_motion {
	double centre[3], velocity[3], omega[3];
};

/* Common part, first member of each kind of solid. */
struct ts_solid {
	const struct ts_solid_kind *kind;
	size_t parts;			/* number of parts with a force of their own: spheres; else 1 */
	struct ts_solid_motion *motion; /* of each part; torques are about the centre. Owned */
	size_t motion_capacity;
	int dimensions;
	bool moved; /* set by update */
};

static inline void ts_solid_velocity(const struct ts_solid_motion *m, const double x[3], double v[3])
{
	double a = x[0] - m->centre[0], b = x[1] - m->centre[1], c = x[2] - m->centre[2];

	v[0] = m->velocity[0] + m->omega[1] * c - m->omega[2] * b;
	v[1] = m->velocity[1] + m->omega[2] * a - m->omega[0] * c;
	v[2] = m->velocity[2] + m->omega[0] * b - m->omega[1] * a;
}

/* Sets surface->v for a solid that moves rigidly; distance and n are known. */
void ts_solid_rigid_velocity(const struct ts_solid_motion *motion, const double x[3],
			     struct ts_solid_surface *surface);

/* Motion of a region, mesh or height field as prescribed by the keywords velocity, omega, centre of the fix. */
struct ts_solid_prescribed {
	bool velocity, omega, centre; /* which of them are prescribed */
	struct ts_solid_motion motion;
};

/* Position and orientation of a region at the last step of the fluid, from which its velocity is computed.
 * Owned by the fix, in its saved state. */
struct ts_solid_pose {
	double shift[3], turn[3][3], time; /* translation, rotation matrix, time of the simulation */
	bool seen;			   /* false: not set yet */
};

/* Each makes a solid, to be freed by ts_solid_free; NULL if out of memory. `prescribed` is read in each
 * update and stays with the caller. */
struct ts_solid *ts_solid_of_region(struct ts_instance *region, int dimensions,
				    const struct ts_solid_prescribed *prescribed,
				    struct ts_solid_pose *before);
/* Refuses a mesh that is not closed. *inwards: its normals point inwards. */
enum ts_status ts_solid_check_mesh(struct tsim *sim, const struct ts_word *id, const struct ts_mesh *mesh,
				   bool *inwards);
struct ts_solid *ts_solid_of_mesh(struct ts_mesh_surface *mesh, bool inwards, int dimensions,
				  const struct ts_solid_prescribed *prescribed);
struct ts_solid *ts_solid_of_voxels(const struct ts_voxel_surface *surface, const struct ts_grid *grid,
				    int dimensions, const struct ts_solid_prescribed *prescribed);
struct ts_solid *ts_solid_of_spheres(int group, int dimensions);
void ts_solid_free(struct ts_solid *solid);

/* Number of cells of the grid between lo and hi along the axis where it is smallest, which is *axis;
 * INFINITY if no axis has two finite bounds. Beyond the grid cells have the width of the last one. */
double ts_solid_cells(const struct ts_grid *grid, const double lo[3], const double hi[3], int *axis);

/* Bytes of a sphere that the ranks send each other. */
enum { TS_SOLID_SPHERE_BYTES = 88 };
/* Index of the particle that is part k; -1: it is on another rank. */
int32_t ts_solid_sphere_row(const struct ts_solid *solid, size_t part);

#endif
