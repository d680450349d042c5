/* Builds the surface of a shape from patches and strips of triangles. Errors are kept in `status`: after the
 * first nothing is added, and one check at the end is sufficient. */
#ifndef TS_SHAPE_FACETS_H
#define TS_SHAPE_FACETS_H

#include "core/sim.h"
#include "geom/triangles.h"

struct ts_facets {
	struct tsim *sim;
	const struct ts_place *where; /* of the shape, for messages */
	const char *name;	      /* "fix mesh/surface: primitive drum" */
	struct ts_triangles *soup;
	double origin[3], unit[3][3]; /* place and directions of the axes of the shape */
	bool inward;		      /* normals are reversed */
	bool mirrored;		      /* y of the shape is reversed */
	bool reversed;		      /* the next triangles have the other orientation */
	int segments;		      /* of a whole circle */
	int rows;		      /* least number of rows along the axis */
	double size;		      /* largest side of the cells of the surface, length; INFINITY: none */
	double chord;		      /* see struct ts_shape_report */
	enum ts_status status;
};

/* A row of points; t increases from the first to the last and tells which points of two rows are near. */
struct ts_rim {
	struct ts_rim_node {
		double t, x[3];
	} * node;
	size_t n, capacity;
};
void ts_rim_add(struct ts_facets *f, struct ts_rim *rim, double t, double x, double y, double z);
void ts_rim_clear(struct ts_rim *rim);
void ts_rim_release(struct ts_rim *rim);
/* Adds the points of a circle about z; its first and last are the same. radius 0: a single point. */
void ts_rim_circle(struct ts_facets *f, struct ts_rim *rim, double radius, double z, int segments);

/* Cosine and sine of 2 pi k/n: with the symmetries of a circle in all bits. */
void ts_facets_direction(int64_t k, int64_t n, double cs[2]);
/* Point i of n from a to b; the same bits as point n - i from b to a. */
double ts_facets_between(double a, double b, int i, int n);
/* Number of cells that a length is divided into, so that none is longer than `size`, nor than `aspect` times
 * `across`. */
int ts_facets_count(struct ts_facets *f, double length, double across, double aspect);

/* Triangle with its corners in anticlockwise order, seen from outside. */
void ts_facets_triangle(struct ts_facets *f, const double a[3], const double b[3], const double c[3]);
/* nu x nv cells between four corners, which are in anticlockwise order seen from outside; u runs from 0 to 1. */
void ts_facets_patch(struct ts_facets *f, const double corner[4][3], int nu, int nv);
/* Strip of triangles between two rows: its normal is along `lower` x (from lower to upper). */
void ts_facets_zip(struct ts_facets *f, const struct ts_rim *lower, const struct ts_rim *upper);

/* Stores an error at the shape. */
#define ts_facets_fail(f, code, ...)                                                                   \
	((f)->status = (f)->status == TS_OK ? ts_fail(&(f)->sim->error, code, (f)->where, __VA_ARGS__) \
					    : (f)->status)

#endif
