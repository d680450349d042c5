/* What a picture shows: spheres, rods, cones and triangles in the coordinates of the simulation. Planes cut off parts of
 * them; of spheres, rods and cones the faces of the cut are closed, so that one looks into a solid. */
#ifndef TS_RENDER_SCENE_H
#define TS_RENDER_SCENE_H

#include <stdint.h>

#include "base/alloc.h"
#include "render/colour_map.h"

struct ts_scene_sphere {
	double x[3], radius; /* length */
	struct ts_colour colour;
	float opacity; /* 0: invisible; 1: nothing behind it is seen */
	bool whole;    /* not cut */
};

/* A cylinder with round ends; or a cone whose base is at the first end, its tip at the second. */
struct ts_scene_rod {
	double end[2][3], radius; /* length */
	struct ts_colour colour;
	bool cone, whole;
};

/* How numbers become colours. */
struct ts_scene_scale {
	const struct ts_colour_map *map;
	double lo, hi; /* range of the map */
};

struct ts_scene_triangle {
	double corner[3][3]; /* length; either side is seen */
	struct ts_colour colour;
	float opacity;
	bool unlit, whole; /* unlit: its colour is seen as it is, whatever the lights are */
	/* NULL: one colour; else each point has that of its number, between those of the corners */
	const struct ts_scene_scale *scale;
	float value[3];
	bool smooth;	    /* shaded by the normals of the corners, linear between them */
	float normal[3][3]; /* unit vectors, of either sign */
};

/* What is beyond the plane is not drawn: x with normal . x > offset. */
struct ts_scene_cut {
	double normal[3], offset; /* unit vector; length */
};
enum { TS_SCENE_CUTS = 6 };

/* Zero-initialise. */
struct ts_scene {
	struct ts_scene_sphere *sphere;
	struct ts_scene_rod *rod;
	struct ts_scene_triangle *triangle;
	size_t nspheres, nrods, ntriangles, sphere_capacity, rod_capacity, triangle_capacity;
	struct ts_scene_cut cut[TS_SCENE_CUTS];
	int ncuts;
	bool whole; /* what is added while this is set is not cut */
};

/* These return TS_OK or TS_NOMEM. What has a coordinate that is not finite, or no size, is left out. */
enum ts_status ts_scene_add_sphere(struct ts_scene *s, const double x[3], double radius,
				   struct ts_colour colour, double opacity);
enum ts_status ts_scene_add_rod(struct ts_scene *s, const double a[3], const double b[3], double radius,
				struct ts_colour colour);
enum ts_status ts_scene_add_cone(struct ts_scene *s, const double base[3], const double tip[3], double radius,
				 struct ts_colour colour);
enum ts_status ts_scene_add_triangle(struct ts_scene *s, const double corner[3][3], struct ts_colour colour,
				     double opacity);
/* Two triangles; the corners in the order around it. */
enum ts_status ts_scene_add_quadrangle(struct ts_scene *s, const double corner[4][3], struct ts_colour colour,
				       double opacity);
/* A triangle as given, with numbers or without. `scale` must live until the picture is drawn. */
enum ts_status ts_scene_add_painted(struct ts_scene *s, const struct ts_scene_triangle *t);
/* Removes all objects and cuts, keeps the memory. */
void ts_scene_clear(struct ts_scene *s);
void ts_scene_release(struct ts_scene *s);

#endif
