/* Walls that are planes or cylinders: where they stand, how their surfaces move. */
#ifndef TS_WALL_PRIMITIVE_WALL_H
#define TS_WALL_PRIMITIVE_WALL_H

#include "geom/primitive.h"
#include "wall/wall.h"

enum { TS_PRIMITIVE_SHAPES = 6, TS_MOST_PRIMITIVES = 2 };

struct ts_primitive_wall {
	struct ts_words shape_words[TS_PRIMITIVE_SHAPES], shear_words, wiggle_words;
	double velocity[3], temperature; /* NaN: none */

	struct ts_primitive primitive[TS_MOST_PRIMITIVES]; /* where they stand without wiggle */
	int n;
	int shear_dim;
	double shear;	/* along it, or about the axis of a cylinder */
	bool lammps;	/* which way and how fast: see the docs of fix wall/gran */
	int wiggle_dim; /* -1: none */
	double amplitude, period;
	/* saved: the time when wiggling began, the displacement at the last rebuild, whether it has begun */
	double origin, held, begun;
};

/* How many shapes are given. */
int ts_primitive_wall_shapes(const struct ts_primitive_wall *w);
/* In init; with one shape given. */
enum ts_status ts_primitive_wall_read(struct ts_instance *self, struct tsim *sim,
				      struct ts_primitive_wall *w);
/* Whether it moves along its normal. */
bool ts_primitive_wall_moves(const struct ts_primitive_wall *w);
/* Whether the wall has gone so far since the last rebuild that another is due. */
bool ts_primitive_wall_has_moved(const struct tsim *sim, const struct ts_primitive_wall *w);
/* Whether one of its planes, as it stands now, bounds the dimension between the places a and b; where. */
bool ts_primitive_wall_between(const struct tsim *sim, const struct ts_primitive_wall *w, int dim, double a,
			       double b, double *position);
/* Refuses a plane that moves through particles in one step. */
enum ts_status ts_primitive_wall_check_displacement(struct ts_instance *self, struct tsim *sim,
						    const struct ts_primitive_wall *w);
/* Between ts_wall_rebuild_start and _finish: lists particles of the group. */
enum ts_status ts_primitive_wall_list(struct ts_instance *self, struct tsim *sim, struct ts_wall *wall,
				      struct ts_primitive_wall *w);
/* All forces; the surface has the material of this type. */
enum ts_status ts_primitive_wall_enqueue_contacts(struct tsim *sim, struct ts_wall *wall,
						  const struct ts_primitive_wall *w, int type);
/* How far a place is from the wall now, less what this moves in a step. */
double ts_primitive_wall_gap(const struct ts_primitive_wall *w, const struct tsim *sim, const double x[3]);
/* How far a place is from element k now. */
double ts_primitive_wall_distance(const struct ts_primitive_wall *w, const struct tsim *sim, int k,
				  const double x[3]);
/* Warnings before a run. */
void ts_primitive_wall_plan(struct ts_instance *self, struct tsim *sim, const struct ts_primitive_wall *w);
enum ts_status ts_primitive_wall_archive(struct ts_archive *a, struct ts_primitive_wall *w);

#define TS_PRIMITIVE_PLANE(T, f, axis, k)                                       \
	TS_SOME_KEYWORD(axis "plane", T, f.shape_words[k], 0, .unit = "length", \
			.help = "the plane " axis " = this; two numbers: two planes, either may be NULL")
#define TS_PRIMITIVE_CYLINDER(T, f, axis, k, first, second)                                     \
	TS_SOME_KEYWORD(axis "cylinder", T, f.shape_words[k], 0, .unit = "length",              \
			.help = "cylinder along " axis ": radius, then its centre along " first \
				" and " second " (0 0)")
#define TS_PRIMITIVE_WALL_ARGS(T, f)                                                                      \
	TS_PRIMITIVE_PLANE(T, f, "x", 0), TS_PRIMITIVE_PLANE(T, f, "y", 1),                               \
		TS_PRIMITIVE_PLANE(T, f, "z", 2), TS_PRIMITIVE_CYLINDER(T, f, "x", 3, "y", "z"),          \
		TS_PRIMITIVE_CYLINDER(T, f, "y", 4, "z", "x"),                                            \
		TS_PRIMITIVE_CYLINDER(T, f, "z", 5, "x", "y"),                                            \
		TS_SOME_KEYWORD("shear", T, f.shear_words, 0,                                             \
				.help = "dimension and velocity of the surface, the wall stays where it " \
					"is; across the axis of a cylinder it turns about it"),           \
		TS_SOME_KEYWORD("wiggle", T, f.wiggle_words, 0,                                           \
				.help = "dimension, amplitude A and period: the wall moves by A "         \
					"(1 - cos wt)"),                                                  \
		TS_REAL("temperature", T, f.temperature, .flags = TS_OPTIONAL, .unit = "temperature",     \
			.help = "of the wall, for fix heat/gran; meshes have their own"),                 \
		TS_VEC3("velocity", T, f.velocity, .fallback = "0 0 0", .unit = "velocity",               \
			.help = "velocity of the surface in its own plane; the wall stays where it is")

#endif
