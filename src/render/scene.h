/* What a picture shows: spheres, rods and triangles in the coordinates of the simulation. */
#ifndef TS_RENDER_SCENE_H
#define TS_RENDER_SCENE_H

#include <stdint.h>

#include "base/alloc.h"
#include "render/colour.h"

struct ts_scene_sphere {
	double x[3], radius; /* length */
	struct ts_colour colour;
};

/* A cylinder with round ends. */
struct ts_scene_rod {
	double end[2][3], radius; /* length */
	struct ts_colour colour;
};

struct ts_scene_triangle {
	double corner[3][3]; /* length; either side is seen */
	struct ts_colour colour;
	float opacity; /* 0: invisible; 1: nothing behind it is seen */
};

/* Zero-initialise. */
struct ts_scene {
	struct ts_scene_sphere *sphere;
	struct ts_scene_rod *rod;
	struct ts_scene_triangle *triangle;
	size_t nspheres, nrods, ntriangles, sphere_capacity, rod_capacity, triangle_capacity;
};

/* These return TS_OK or TS_NOMEM. What has a coordinate that is not finite, or no size, is left out. */
enum ts_status ts_scene_add_sphere(struct ts_scene *s, const double x[3], double radius,
				   struct ts_colour colour);
enum ts_status ts_scene_add_rod(struct ts_scene *s, const double a[3], const double b[3], double radius,
				struct ts_colour colour);
enum ts_status ts_scene_add_triangle(struct ts_scene *s, const double corner[3][3], struct ts_colour colour,
				     double opacity);
/* Two triangles: the corners in order around it. */
enum ts_status ts_scene_add_quadrangle(struct ts_scene *s, const double corner[4][3], struct ts_colour colour,
				       double opacity);
/* Removes all, and keeps the memory for the next picture. */
void ts_scene_clear(struct ts_scene *s);
void ts_scene_release(struct ts_scene *s);

#endif
