/* Regions: sets of points with a name in the script. A region style implements its shape as it was
 * defined; side, units, motion and open faces are common to all.
 *
 * Regions may move or change their size by variables: ts_region_update must be called before points are
 * tested, once for a loop over particles (checked by tests/house.sh). */
#ifndef TS_REGION_REGION_H
#define TS_REGION_REGION_H

#include "core/sim.h"
#include "math/minstd.h"

/* First member of every region's state. */
struct ts_region {
	int side;  /* 0 in, 1 out */
	int units; /* 0 lattice, 1 box, -1 not given; ts_domain_scale */
	struct ts_words move_words, rotate_words, open_words;
	double volume_limit; /* insertion in a region of smaller volume is an error */
	int64_t seed;	     /* no effect */

	/* set by ts_region_init */
	bool defined;
	double scale[3];   /* length of one unit: 1 or the lattice spacing */
	double edge[2][3]; /* lower and upper faces of the box; NaN before it exists */
	struct ts_number move[3], angle;
	double pivot[3], axis[3]; /* of the rotation; |axis| = 1 */
	unsigned open;		  /* bit k: face k + 1 is open in walls made of the region */
	struct ts_minstd random;  /* stream of fixes that insert in it; state 0: not seeded */

	/* of the last ts_region_update: a point y of the shape is at turn (y - pivot) + pivot + shift */
	bool moves;
	double shift[3], turn[3][3], turned; /* turned: angle of the rotation matrix, radians */

	bool varies;   /* the surface changes with time */
	bool reshapes; /* the shape changes with time, not only its position */
};
#define TS_REGION_SIDE_ARGS(T)                                                                             \
	TS_ENUM("side", T, region.side, ts_region_sides, .fallback = "in",                                 \
		.help = "whether the region is the inside or the outside of the shape"),                   \
		TS_ENUM("units", T, region.units, ts_region_units, .flags = TS_OPTIONAL,                   \
			.help = "whether lengths are in lattice spacings or in units of length; see the "  \
				"command lattice for the default"),                                        \
		TS_REAL("volume_limit", T, region.volume_limit, .fallback = "0", .range = TS_NOT_NEGATIVE, \
			.unit = "length^3",                                                                \
			.help = "insertion in the region is an error if its volume is smaller"),           \
		TS_INT("seed", T, region.seed, .flags = TS_OPTIONAL, .range = TS_POSITIVE,                 \
		       .help = "no effect: fixes that insert particles in a region have their own seeds")
#define TS_REGION_ARGS(T)                                                                               \
	TS_REGION_SIDE_ARGS(T),                                                                         \
		TS_SOME_KEYWORD("move", T, region.move_words, 0,                                        \
				.help = "v_x v_y v_z: displacement, equal-style variables or NULL"),    \
		TS_SOME_KEYWORD("rotate", T, region.rotate_words, 0,                                    \
				.help = "v_theta Px Py Pz Rx Ry Rz: rotation by the angle theta "       \
					"(radians) about the axis R through P"),                        \
		TS_SOME_KEYWORD("open", T, region.open_words, TS_REPEAT,                                \
				.help = "number of a face, from 1, that is open if the region is used " \
					"as a wall; may be repeated")
extern const char *const ts_region_sides[], *const ts_region_units[];

/* A contact point: the point of the surface closest to a point x. */
struct ts_region_contact_point {
	double distance, n[3]; /* n: unit vector to x; 0 if x is on the surface and n is undefined */
	double curvature;      /* mean curvature of the surface, > 0: convex as seen from x */
	int face;	       /* counted from 0 */
	const struct ts_instance *mover; /* the region whose move and rotate apply to it; NULL: none */
};

struct ts_region_style {
	struct ts_style style;
	/* Whether x is in the shape, irrespective of `side`. */
	bool (*contains)(const struct ts_instance *self, const double x[3]);
	/* Bounding box of the shape; +-INFINITY if it is unbounded. */
	void (*bounds)(const struct ts_instance *self, double lo[3], double hi[3]);
	/* Exact volume of the shape; NULL: not supported. */
	double (*volume)(const struct ts_instance *self);
	/* Depth of x in the shape: distance from its surface, < 0 outside, or a bound that is closer to
	 * 0. NULL: not supported. */
	double (*depth)(const struct ts_instance *self, const double x[3]);
	/* The same, which also outside of edges where faces of members meet is the distance, not a bound. NULL: `depth` is that. */
	double (*depth_at_edges)(const struct ts_instance *self, const double x[3]);
	/* Distance from the centre or axis divided by the radius. NULL: the shape has no radius. */
	double (*radial)(const struct ts_instance *self, const double x[3]);
	int faces; /* number of faces that can be open */
	/* Contact points of x on faces that are not open: from inside one on each face, from outside the
	 * closest of all, with face 0. Returns their number. NULL: not supported. */
	int (*contact_points)(const struct ts_instance *self, const double x[3], bool inside,
			      struct ts_region_contact_point *out);
	/* Whether the rotation of the region leaves its shape where it is. NULL: it does not. */
	bool (*turns_in_place)(const struct ts_instance *self);
	/* Of a union or intersection the k-th member; NULL: k is beyond the last. */
	const struct ts_instance *(*member)(const struct ts_instance *self, int64_t k);
	/* Evaluates variables of the shape. NULL: nothing to do. */
	ts_hook_fn *update;
};

/* Evaluates the variables of motion and size at the present time; region may be NULL. */
enum ts_status ts_region_update(struct ts_instance *region, struct tsim *sim);
/* Whether x is in the region; its bounding box. */
bool ts_region_contains(const struct ts_instance *region, const double x[3]);
void ts_region_bounds(const struct ts_instance *region, double lo[3], double hi[3]);
/* Depth of x in the region: distance from its surface or a lower bound of it, < 0 outside; NaN: not
 * implemented. */
double ts_region_depth(const struct ts_instance *region, const double x[3]);
/* The same, of an intersection outside of its edges, too, the distance from its surface, if its members are convex there. */
double ts_region_depth_at_edges(const struct ts_instance *region, const double x[3]);
/* Differences of the depth, by one of these functions, over `step` on both sides of x along each axis: twice the step by its
 * gradient, which points inwards. */
typedef double ts_region_depth_fn(const struct ts_instance *region, const double x[3]);
void ts_region_depth_slope(ts_region_depth_fn *depth, const struct ts_instance *region, const double x[3],
			   double step, double out[3]);
/* Distance of x from the centre or axis of a round region, divided by its radius; NaN: it has no radius. */
double ts_region_radial(const struct ts_instance *region, const double x[3]);
/* Volume: NaN if not supported, infinite with side out. */
double ts_region_volume(const struct ts_instance *region);

/* Region walls: the largest number of contact points of a particle; 0: the region cannot be a wall. */
int ts_region_faces(const struct ts_instance *region);
/* Contact points of x on the surface; returns their number. Without open faces only for x in the region. */
int ts_region_contact_points(const struct ts_instance *region, const double x[3],
			     struct ts_region_contact_point *out);
/* The same for x on either side. */
int ts_region_contact_points_all(const struct ts_instance *region, const double x[3],
				 struct ts_region_contact_point *out);
/* Whether the surface changes with time; and whether it does other than by rigid motion. */
bool ts_region_varies(const struct ts_instance *region);
bool ts_region_reshapes(const struct ts_instance *region);
/* Whether a region that moves is one whose surface only slides along itself: a round one that turns about its axis. */
bool ts_region_turns_in_place(const struct ts_instance *region);
/* Lists, of the region and its members, those with move or rotate, at most `room`; returns their number,
 * which may be larger. */
int ts_region_movers(const struct ts_instance *region, const struct ts_instance **out, int room);

/* For region styles; must be the first call in init. Sets scale, edges and motion in the first call. */
enum ts_status ts_region_init(struct ts_instance *self, struct tsim *sim);
/* Converts a coordinate of a TS_COORD argument to units of length; EDGE becomes the face of the box. */
enum ts_status ts_region_coord(struct ts_instance *self, struct tsim *sim, double given, int dim,
			       double *out);
/* Evaluates a length, which may be a variable, in units of length; dim: dimension of the lattice spacing. */
enum ts_status ts_region_length(struct ts_instance *self, struct tsim *sim, const struct ts_number *given,
				int dim, double *out);

/* Functions of formulas over regions: volume(region). */
extern const struct ts_system_style ts_regions_system;

#endif
