/* The shapes: argument rows and makers, one pair for each. */
#ifndef TS_SHAPE_INTERNAL_H
#define TS_SHAPE_INTERNAL_H

#include "shape/facets.h"
#include "shape/shape.h"

/* name, help, radius of its largest circle (0: it has none) as an expression of `s` */
#define TS_SHAPE_LIST(X)                                                                               \
	X(box, "block with its faces along the axes", 0)                                               \
	X(plate, "rectangle in the plane z = 0 about the origin", 0)                                   \
	X(disk, "flat disc in the plane z = 0 about the origin", s->disk.radius)                       \
	X(sphere, "sphere about the origin", s->sphere.radius)                                         \
	X(cylinder, "cylinder along z, from z = 0 to `length`", s->cylinder.radius)                    \
	X(tube, "cylinder with a wall of a thickness, from z = 0 to `length`", s->tube.radius)         \
	X(cone, "cone or frustum along z, from z = 0 to `length`", fmax(s->cone.radlo, s->cone.radhi)) \
	X(revolve, "surface of revolution about z", ts_shape_revolve_radius(s))                        \
	X(hopper, "conical hopper or funnel along z, its lower end at z = 0", s->hopper.radius)        \
	X(wedge, "wedge-shaped hopper with a slot along y, its lower end at z = 0", 0)                 \
	X(drum, "hollow cylinder along z with bars (lifters) inside, from z = 0 to `length`",          \
	  s->drum.radius)                                                                              \
	X(screw, "screw of Archimedes: a shaft along z from z = 0 to `length` with a helical flight",  \
	  s->screw.radius)                                                                             \
	X(mixer, "shaft along z from z = 0 to `length` with flat blades", s->mixer.radius)

extern const struct ts_arg ts_shape_box_args[];
extern const struct ts_arg ts_shape_plate_args[];
extern const struct ts_arg ts_shape_disk_args[];
extern const struct ts_arg ts_shape_sphere_args[];
extern const struct ts_arg ts_shape_cylinder_args[];
extern const struct ts_arg ts_shape_tube_args[];
extern const struct ts_arg ts_shape_cone_args[];
extern const struct ts_arg ts_shape_revolve_args[];
extern const struct ts_arg ts_shape_hopper_args[];
extern const struct ts_arg ts_shape_wedge_args[];
extern const struct ts_arg ts_shape_drum_args[];
extern const struct ts_arg ts_shape_screw_args[];
extern const struct ts_arg ts_shape_mixer_args[];

/* Each adds its triangles. */
void ts_shape_box(struct ts_facets *f, const struct ts_shape_sizes *s);
void ts_shape_plate(struct ts_facets *f, const struct ts_shape_sizes *s);
void ts_shape_disk(struct ts_facets *f, const struct ts_shape_sizes *s);
void ts_shape_sphere(struct ts_facets *f, const struct ts_shape_sizes *s);
void ts_shape_cylinder(struct ts_facets *f, const struct ts_shape_sizes *s);
void ts_shape_tube(struct ts_facets *f, const struct ts_shape_sizes *s);
void ts_shape_cone(struct ts_facets *f, const struct ts_shape_sizes *s);
void ts_shape_revolve(struct ts_facets *f, const struct ts_shape_sizes *s);
void ts_shape_hopper(struct ts_facets *f, const struct ts_shape_sizes *s);
void ts_shape_wedge(struct ts_facets *f, const struct ts_shape_sizes *s);
void ts_shape_drum(struct ts_facets *f, const struct ts_shape_sizes *s);
void ts_shape_screw(struct ts_facets *f, const struct ts_shape_sizes *s);
void ts_shape_mixer(struct ts_facets *f, const struct ts_shape_sizes *s);

/* Ends that are open meet across the faces of a periodic box: with fewer rows of cells a triangle would share more than
 * one edge with another. */
enum { TS_SHAPE_PERIODIC_ROWS = 3 };

extern const char *const ts_shape_open_names[];
/* `open`: which ends are left out. */
#define TS_SHAPE_OPEN(field)                                                                   \
	TS_ENUM("open", struct ts_shape_sizes, field, ts_shape_open_names, .fallback = "none", \
		.help = "which ends are left out; both for a box that is periodic along the axis")
#define TS_SHAPE_LENGTH(name, field, text) \
	TS_REAL(name, struct ts_shape_sizes, field, .range = TS_POSITIVE, .unit = "length", .help = text)
#define TS_SHAPE_LENGTH_OR(name, field, value, text)                                             \
	TS_REAL(name, struct ts_shape_sizes, field, .fallback = value, .range = TS_NOT_NEGATIVE, \
		.unit = "length", .help = text)

/* Largest radius of the profile; 0 if it is not one of numbers. */
double ts_shape_revolve_radius(const struct ts_shape_sizes *s);

#endif
