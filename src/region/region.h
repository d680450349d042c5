/* Regions: sets of points a script can name. A region style describes its shape where it was defined;
 * side, units, motion and open faces are the same for all.
 *
 * Regions may move, or change their size, by variables: whoever asks about points calls
 * ts_region_update first, once for a loop over particles. A test looks for it. */
#ifndef TS_REGION_REGION_H
#define TS_REGION_REGION_H

#include "core/sim.h"
#include "math/minstd.h"

/* First member of every region's state. */
struct ts_region {
	int side;  /* 0 in, 1 out */
	int units; /* 0 lattice, 1 box, -1 not said; ts_domain_scale */
	struct ts_words move_words, rotate_words, open_words;
	double volume_limit; /* for who fills it: of a smaller volume it is refused */
	int64_t seed;	     /* of no effect */

	/* as it was defined; set by ts_region_init */
	bool defined;
	double scale[3];   /* factor for lengths */
	double edge[2][3]; /* faces of the box: low, high; NaN before there is one */
	struct ts_number move[3], angle;
	double pivot[3], axis[3]; /* of the rotation; |axis| = 1 */
	unsigned open;		  /* bit k: face k + 1 is open, for walls made of the region */
	struct ts_minstd random;  /* of who draws points in it; state 0: nobody yet */

	/* as of the last ts_region_update: a point y of the shape stands at
	 * turn (y - pivot) + pivot + shift */
	bool moves;
	double shift[3], turn[3][3], turned; /* by the angle */

	bool varies;   /* the surface may change with time */
	bool reshapes; /* not only by moving */
};
#define TS_REGION_SIDE_ARGS(T)                                                                             \
	TS_ENUM("side", T, region.side, ts_region_sides, .fallback = "in",                                 \
		.help = "which side belongs to the region"),                                               \
		TS_ENUM("units", T, region.units, ts_region_units, .flags = TS_OPTIONAL,                   \
			.help = "whether lengths are given in lattice spacings or as they are; see the "   \
				"command lattice for the default"),                                        \
		TS_REAL("volume_limit", T, region.volume_limit, .fallback = "0", .range = TS_NOT_NEGATIVE, \
			.unit = "length^3",                                                                \
			.help = "insertion is refused where the region's volume is smaller"),              \
		TS_INT("seed", T, region.seed, .flags = TS_OPTIONAL, .range = TS_POSITIVE,                 \
		       .help = "no effect: who draws points in a region has a seed of its own")
#define TS_REGION_ARGS(T)                                                                                 \
	TS_REGION_SIDE_ARGS(T),                                                                           \
		TS_SOME_KEYWORD("move", T, region.move_words, 0,                                          \
				.help = "v_x v_y v_z: displacement by equal-style variables, or NULL"),   \
		TS_SOME_KEYWORD("rotate", T, region.rotate_words, 0,                                      \
				.help = "v_theta Px Py Pz Rx Ry Rz: turned by the angle theta (radians) " \
					"about the axis R through P"),                                    \
		TS_SOME_KEYWORD("open", T, region.open_words, TS_REPEAT,                                  \
				.help = "number of a face, from 1, without wall where the region is "     \
					"used as one; may be repeated")
extern const char *const ts_region_sides[], *const ts_region_units[];

/* Where the surface is nearest to a point. */
struct ts_region_contact_point {
	/* n: unit vector towards the point; 0 on the surface where none is distinguished */
	double distance, n[3];
	double curvature;		 /* mean curvature of the surface, > 0: bulging towards the point */
	int face;			 /* counted from 0 */
	const struct ts_instance *mover; /* the region with whose move and rotate it goes; NULL: none */
};

struct ts_region_style {
	struct ts_style style;
	/* The shape itself, without `side`. */
	bool (*contains)(const struct ts_instance *self, const double x[3]);
	/* Box around the shape; ±INFINITY where it has no end. */
	void (*bounds)(const struct ts_instance *self, double lo[3], double hi[3]);
	/* Exact volume of the shape; NULL: not known. */
	double (*volume)(const struct ts_instance *self);
	/* How deep x lies in the shape: distance from its surface, < 0 outside. Where the distance is
	 * not known exactly, a bound nearer to 0. NULL: not known at all. */
	double (*depth)(const struct ts_instance *self, const double x[3]);
	/* Distance from the centre or axis, as a part of the radius. NULL: it has no radius. */
	double (*radial)(const struct ts_instance *self, const double x[3]);
	int faces; /* how many faces can be open */
	/* The spots of x on faces that are not open: seen from inside the nearest of each face, from outside
	 * the nearest of all, with face 0. NULL: not known. */
	int (*spots)(const struct ts_instance *self, const double x[3], bool inside,
		     struct ts_region_contact_point *out);
	/* Of regions made of others the k-th one, NULL: there are no more. */
	const struct ts_instance *(*member)(const struct ts_instance *self, int64_t k);
	/* Evaluates variables of the shape. NULL: nothing to do. */
	ts_hook_fn *update;
};

/* Brings a region, or NULL, up to the present: motion and variable sizes. */
enum ts_status ts_region_update(struct ts_instance *region, struct tsim *sim);
bool ts_region_contains(const struct ts_instance *region, const double x[3]);
void ts_region_bounds(const struct ts_instance *region, double lo[3], double hi[3]);
/* Of x in the region: distance from its surface, or a lower bound of it, < 0 outside; NaN: not known. */
double ts_region_depth(const struct ts_instance *region, const double x[3]);
/* Distance of x from the centre or axis of a round region, as a part of its radius; NaN: it has none. */
double ts_region_radial(const struct ts_instance *region, const double x[3]);
/* NaN where it is not known, infinite outside of a shape. */
double ts_region_volume(const struct ts_instance *region);

/* The surface of a region as a wall. How many spots a point may have on it; 0: it cannot be a wall. */
int ts_region_faces(const struct ts_instance *region);
/* The spots of x on the surface; returns how many. A region without open faces is met from its side only. */
int ts_region_contact_points(const struct ts_instance *region, const double x[3],
			     struct ts_region_contact_point *out);
/* The same from whatever side x is on. */
int ts_region_contact_points_all(const struct ts_instance *region, const double x[3],
				 struct ts_region_contact_point *out);
bool ts_region_varies(const struct ts_instance *region);
/* Whether it may otherwise than by moving. */
bool ts_region_reshapes(const struct ts_instance *region);
/* The region and those that it is made of that have move or rotate, at most `room`; returns how many there
 * are. */
int ts_region_movers(const struct ts_instance *region, const struct ts_instance **out, int room);

/* For region styles. Call first in init: the first time it fixes scale, edges and motion. */
enum ts_status ts_region_init(struct ts_instance *self, struct tsim *sim);
/* A coordinate given by a TS_COORD row, in simulation units: EDGE becomes the face of the box. */
enum ts_status ts_region_coord(struct ts_instance *self, struct tsim *sim, double given, int dim,
			       double *out);
/* The value of a length that may be a variable, times the scale of a dimension. */
enum ts_status ts_region_length(struct ts_instance *self, struct tsim *sim, const struct ts_number *given,
				int dim, double *out);

extern const char *const ts_region_axes[];

/* Functions of formulas over regions: volume(region). */
extern const struct ts_system_style ts_regions_system;

#endif
