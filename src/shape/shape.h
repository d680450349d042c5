/* Shapes made of triangles from a few sizes: box, drum, hopper, screw ... Words of a script become triangles:
 *
 *   SHAPE sizes ... [base x y z] [axis x y z] [angle a] [segments n | error e] [size s] [normals ...]
 *       [primitive SHAPE ...]
 *
 * Each shape stands at the origin of its own coordinates, upright along z. `base` is where this origin comes to,
 * `axis` is where z points; x of a shape then points along the next coordinate axis (y if the axis is that of x,
 * z if it is that of y), made perpendicular to the axis, and turned about the axis by `angle`. Shapes along
 * coordinate axes are copied without rounding, except for the sum with `base`.
 *
 * Corners lie on the exact surface, so a curved one is approximated from inside: a circle of radius R becomes a
 * polygon of n segments, at most R (1 - cos(pi/n)) inside of it; areas and volumes are too small by O(1/n^2).
 * A shape is closed and its triangles have one orientation, unless a part is left open. */
#ifndef TS_SHAPE_SHAPE_H
#define TS_SHAPE_SHAPE_H

#include "core/arg.h"
#include "geom/triangles.h"

/* Ends at the lower and upper end of the axis that are left out. */
enum ts_shape_open { TS_SHAPE_CLOSED, TS_SHAPE_LOWER = 1, TS_SHAPE_UPPER = 2, TS_SHAPE_BOTH = 3 };

struct ts_shape_sizes {
	int kind; /* index of ts_shape_modes */
	double base[3], axis[3], angle;
	int64_t segments;      /* INT64_MIN: not given */
	double error, size;    /* NaN: not given */
	int normals;	       /* 1: inward */
	struct ts_words other; /* the next shape */
	/* sizes of each shape, lengths */
	struct {
		double bound[6];
		struct ts_words open;
	} box;
	struct {
		double length, width;
	} plate;
	struct {
		double radius, hole;
	} disk;
	struct {
		double radius, length, thickness;
		int open;
	} cylinder, tube;
	struct {
		double radlo, radhi, length;
		int open;
	} cone;
	struct {
		struct ts_words profile;
	} revolve;
	struct {
		double radius, outlet, angle, height, stem;
	} hopper;
	struct {
		double width, outlet, angle, height, depth;
		bool ends;
	} wedge;
	struct {
		double radius, length, height, width;
		int64_t lifters;
		int open;
	} drum;
	struct {
		double radius;
	} sphere;
	struct {
		double radius, shaft, pitch, turns, thickness, length;
		int hand;
		bool periodic;
	} screw;
	struct {
		double radius, shaft, length, width, thickness, tilt, at;
		int64_t blades;
	} mixer;
};

extern const struct ts_mode ts_shape_modes[];
extern const char *const ts_shape_normals_names[];
/* Rows for a table whose struct begins with a struct ts_shape_sizes: the name of the shape with its own rows, and the
 * keywords that all shapes have. */
#define TS_SHAPE_ARGS                                                                                        \
	TS_MODE("shape", struct ts_shape_sizes, kind, ts_shape_modes, .help = "the shape"),                  \
		TS_VEC3("base", struct ts_shape_sizes, base, .fallback = "0 0 0", .unit = "length",          \
			.help = "where the origin of the shape is"),                                         \
		TS_VEC3("axis", struct ts_shape_sizes, axis, .fallback = "0 0 1",                            \
			.help = "direction of z of the shape"),                                              \
		TS_REAL("angle", struct ts_shape_sizes, angle, .fallback = "0", .unit = "degrees",           \
			.help = "rotation of the shape about its axis"),                                     \
		TS_INT("segments", struct ts_shape_sizes, segments, .flags = TS_OPTIONAL,                    \
		       .range = TS_WITHIN, .lo = 3, .hi = 100000,                                            \
		       .help = "number of sides of a circle; default: 64"),                                  \
		TS_REAL("error", struct ts_shape_sizes, error, .flags = TS_OPTIONAL, .range = TS_POSITIVE,   \
			.unit = "length", .help = "instead: largest distance of the sides from the circle"), \
		TS_REAL("size", struct ts_shape_sizes, size, .flags = TS_OPTIONAL, .range = TS_POSITIVE,     \
			.unit = "length",                                                                    \
			.help = "largest side of the cells that the surface is divided into, two triangles " \
				"each, "                                                                     \
				"for results on triangles such as wear; default: as few triangles as "       \
				"possible"),                                                                 \
		TS_ENUM("normals", struct ts_shape_sizes, normals, ts_shape_normals_names,                   \
			.fallback = "outward",                                                               \
			.help = "side of the normals: away from the inside of the shape, or towards it"),    \
		TS_LIST_KEYWORD("primitive", struct ts_shape_sizes, other, .flags = TS_OPTIONAL | TS_NAMED,  \
				.help = "SHAPE ...: another shape, as part of the same mesh")
/* These rows. */
extern const struct ts_arg ts_shape_args[];

/* What was made, for reports. */
struct ts_shape_report {
	size_t triangles;
	double chord; /* upper bound of the distance of a triangle from the exact surface, length */
};

/* Appends the triangles of the shape, and of those that are joined to it by `primitive`. `what` is the name of
 * the owner for messages. */
enum ts_status ts_shape_make(struct tsim *sim, const char *what, const struct ts_shape_sizes *shape,
			     const struct ts_place *where, struct ts_arena *arena, struct ts_triangles *soup,
			     struct ts_shape_report *report);
/* The same from the words `primitive SHAPE ... [primitive SHAPE ...]`. */
enum ts_status ts_shape_read(struct tsim *sim, const char *what, struct ts_words words,
			     struct ts_arena *arena, struct ts_triangles *soup,
			     struct ts_shape_report *report);

#endif
