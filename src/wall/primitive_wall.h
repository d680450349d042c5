/* Walls that are planes or cylinders: their position, and the velocity of their surface. */
#ifndef TS_WALL_PRIMITIVE_WALL_H
#define TS_WALL_PRIMITIVE_WALL_H

#include "geom/primitive.h"
#include "wall/wall.h"

enum { TS_PRIMITIVE_SHAPES = 6, TS_MOST_PRIMITIVES = 2 };

struct ts_primitive_wall {
	struct ts_words shape_words[TS_PRIMITIVE_SHAPES], shear_words, wiggle_words;
	double velocity[3]; /* of the surface */
	double temperature; /* NaN: none */

	struct ts_primitive primitive[TS_MOST_PRIMITIVES]; /* without the displacement of wiggle */
	int n;						   /* of them */
	int shear_dim;
	double shear;	  /* velocity along shear_dim, or angular velocity about the axis of a cylinder */
	bool lammps;	  /* shear of cylinders as in LAMMPS: see the manual of fix wall/gran */
	int wiggle_dim;	  /* -1: none */
	double amplitude; /* length */
	double period;	  /* time */
	/* saved: start time of wiggle, displacement at the last rebuild (length), 1 if wiggle has begun */
	double origin, built_displacement, begun;
	int type; /* particle type whose material it has */
};

extern const struct ts_wall_shape ts_primitive_wall_shape;

/* The planes or cylinders of a wall; NULL: it is of another shape. */
const struct ts_primitive_wall *ts_primitive_wall_of(const struct ts_wall *w);
/* Whether the wall moves along its normal (`wiggle`). */
bool ts_primitive_wall_moves(const struct ts_primitive_wall *w);
/* Its plane k, 0 <= k < w->n: present position along the axis `dim`, and velocity of the surface. */
struct ts_primitive_plane {
	int dim;
	double position, velocity[3];
};
/* false: it is a cylinder. */
bool ts_primitive_wall_plane(const struct tsim *sim, const struct ts_primitive_wall *w, int k,
			     struct ts_primitive_plane *out);
/* Whether one of its planes normal to `dim` is now between the coordinates a and b; stores its position. */
bool ts_primitive_wall_between(const struct tsim *sim, const struct ts_primitive_wall *w, int dim, double a,
			       double b, double *position);

#define TS_PRIMITIVE_PLANE(T, f, axis, k)                                       \
	TS_SOME_KEYWORD(axis "plane", T, f.shape_words[k], 0, .unit = "length", \
			.help = "plane at this " axis "; two numbers: two planes, either may be NULL")
#define TS_PRIMITIVE_CYLINDER(T, f, axis, k, first, second)                                     \
	TS_SOME_KEYWORD(axis "cylinder", T, f.shape_words[k], 0, .unit = "length",              \
			.help = "cylinder along " axis ": radius, then its centre along " first \
				" and " second " (0 0)")
#define TS_PRIMITIVE_WALL_ARGS(T, f)                                                                        \
	TS_PRIMITIVE_PLANE(T, f, "x", 0), TS_PRIMITIVE_PLANE(T, f, "y", 1),                                 \
		TS_PRIMITIVE_PLANE(T, f, "z", 2), TS_PRIMITIVE_CYLINDER(T, f, "x", 3, "y", "z"),            \
		TS_PRIMITIVE_CYLINDER(T, f, "y", 4, "z", "x"),                                              \
		TS_PRIMITIVE_CYLINDER(T, f, "z", 5, "x", "y"),                                              \
		TS_SOME_KEYWORD("shear", T, f.shear_words, 0,                                               \
				.help = "dimension and velocity of the surface, the wall stays in place; "  \
					"across the axis of a cylinder it rotates about this axis"),        \
		TS_SOME_KEYWORD("wiggle", T, f.wiggle_words, 0,                                             \
				.help = "dimension, amplitude A and period T: displacement "                \
					"A (1 - cos(2 pi t/T))"),                                           \
		TS_REAL("temperature", T, f.temperature, .flags = TS_OPTIONAL, .unit = "temperature",       \
			.help = "temperature of the wall, for fix heat/gran; that of a mesh is given with " \
				"the mesh"),                                                                \
		TS_VEC3("velocity", T, f.velocity, .fallback = "0 0 0", .unit = "velocity",                 \
			.help = "velocity of the surface in its own plane; the wall stays in place")

#endif
