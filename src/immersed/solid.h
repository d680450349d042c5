/* Solids in a fluid: where their surface is, and how it moves. Regions, closed meshes, and spheres (particles)
 * answer the same questions. */
#ifndef TS_IMMERSED_SOLID_H
#define TS_IMMERSED_SOLID_H

#include <stdbool.h>

#include "core/sim.h"
#include "grid/grid.h"

struct ts_mesh_surface;

/* The surface as seen from a place. */
struct ts_solid_surface {
	double distance; /* < 0 inside */
	double n[3];	 /* unit vector out of the solid */
	double v[3];	 /* velocity of the nearest point of the surface; inside: of the solid at the place */
};

enum ts_solid_side { TS_SOLID_NEAR, TS_SOLID_FAR };

struct ts_solid;
struct ts_solid_kind {
	/* Where it is now; sets `moved` if that has changed since the last time. */
	enum ts_status (*update)(struct ts_solid *solid, struct tsim *sim);
	void (*bounds)(const struct ts_solid *solid, size_t part, double lo[3], double hi[3]);
	/* TS_SOLID_FAR: the surface is farther than `reach`, and nothing is said - not even on which side.
	 * Workers look side by side, each with its own number from 0. */
	enum ts_status (*look)(struct ts_solid *solid, size_t worker, size_t part, const double x[3],
			       double reach, enum ts_solid_side *side, struct ts_solid_surface *spot);
	bool (*inside)(const struct ts_solid *solid, size_t part, const double x[3]);
	void (*release)(struct ts_solid *solid);
	enum ts_status (*team)(struct ts_solid *solid, size_t workers); /* so many will look; NULL: any may */
};

/* A rigid motion at one time. */
struct ts_solid_motion {
	double centre[3], velocity[3], omega[3];
};

/* Common to all; first member of each kind. */
struct ts_solid {
	const struct ts_solid_kind *kind;
	size_t parts; /* each has its own force: spheres */
	struct ts_solid_motion *motion; /* of each part; forces turn about the centre */
	size_t motion_capacity;
	int dimensions;
	bool moved;
};

static inline void ts_solid_velocity(const struct ts_solid_motion *m, const double x[3], double v[3])
{
	double a = x[0] - m->centre[0], b = x[1] - m->centre[1], c = x[2] - m->centre[2];

	v[0] = m->velocity[0] + m->omega[1] * c - m->omega[2] * b;
	v[1] = m->velocity[1] + m->omega[2] * a - m->omega[0] * c;
	v[2] = m->velocity[2] + m->omega[0] * b - m->omega[1] * a;
}

/* v of a spot whose distance and n are known, if the solid moves rigidly. */
void ts_solid_rigid_velocity(const struct ts_solid_motion *motion, const double x[3],
			 struct ts_solid_surface *spot);

/* How a region or a mesh moves, where its own motion does not say it. */
struct ts_solid_prescribed {
	bool velocity, omega, centre; /* given */
	struct ts_solid_motion motion;
};

/* Where a region stood at the last step of the fluid, its velocity comes from that; kept by who makes the
 * solid, in saved state. Zero: not seen yet. */
struct ts_solid_pose {
	double shift[3], turn[3][3], time;
	bool seen;
};

/* Each makes a solid, or returns NULL without memory. `given` is looked at in each update. */
struct ts_solid *ts_solid_of_region(struct ts_instance *region, int dimensions,
				    const struct ts_solid_prescribed *given,
				    struct ts_solid_pose *before);
struct ts_solid *ts_solid_of_mesh(struct ts_mesh_surface *mesh, int dimensions,
				  const struct ts_solid_prescribed *given);
struct ts_solid *ts_solid_of_spheres(int group, int dimensions);
void ts_solid_free(struct ts_solid *solid);

/* How many cells of the grid lie side by side between lo and hi, along the axis where they are fewest; INFINITY
 * where no axis has both ends. Beyond the grid cells are as wide as at its end. */
double ts_solid_cells(const struct ts_grid *grid, const double lo[3], const double hi[3], int *axis);

/* Row of the particle that part k is. */
int32_t ts_solid_sphere_row(const struct ts_solid *solid, size_t part);

#endif
