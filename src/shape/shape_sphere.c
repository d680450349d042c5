/* Sphere: the faces of an icosahedron, divided into nearly equal triangles and projected onto the sphere. A sphere of
 * meridians and parallels would have slender triangles at its poles. */
#include <math.h>

#include "math/constants.h"
#include "math/vec3.h"
#include "shape/internal.h"

#include "base/banned.h"

const struct ts_arg ts_shape_sphere_args[] = {
	TS_SHAPE_LENGTH("radius", sphere.radius,
			"radius; corners are on the sphere, about `segments` around it"),
	TS_ARGS_END,
};

/* Two corners on the axis, five each at z = 1/sqrt 5 and -1/sqrt 5. */
static void icosahedron_corner(int k, double x[3])
{
	double cs[2] = { 1, 0 }, r = 2 / sqrt(5), z = 1 / sqrt(5);

	if (k == 0 || k == 11) {
		x[0] = x[1] = 0;
		x[2] = k ? -1 : 1;
		return;
	}
	ts_facets_direction(2 * ((k - 1) % 5) + (k > 5), 10, cs);
	x[0] = r * cs[0];
	x[1] = r * cs[1];
	x[2] = k > 5 ? -z : z;
}

/* Corners of face k, anticlockwise seen from outside: 5 at the top, 10 between, 5 at the bottom. */
static void icosahedron_face(int k, double corner[3][3])
{
	int i = k % 5, next = (i + 1) % 5;
	const int faces[4][3] = { { 0, 1 + i, 1 + next },
				  { 1 + i, 6 + i, 1 + next },
				  { 6 + i, 6 + next, 1 + next },
				  { 11, 6 + next, 6 + i } };

	for (int j = 0; j < 3; j++)
		icosahedron_corner(faces[k / 5][j], corner[j]);
}

/* Point (i, j) of the n-fold division of a face, on the sphere; the sum is taken in the order of the corners'
 * heights, so that both faces at an edge find the same bits. */
static void sphere_point(const double corner[3][3], int i, int j, int n, double radius, double x[3])
{
	const double weight[3] = { n - i - j, i, j };
	double length;

	for (int d = 0; d < 3; d++)
		x[d] = weight[0] * corner[0][d] + (weight[1] * corner[1][d] + weight[2] * corner[2][d]);
	length = ts_norm(x);
	ts_scale(radius / length, x, x);
}

static void add_divided_face(struct ts_facets *f, const double corner[3][3], int n, double radius)
{
	double a[3], b[3], c[3], d[3];

	for (int i = 0; i < n; i++)
		for (int j = 0; j < n - i && f->status == TS_OK; j++) {
			sphere_point(corner, i, j, n, radius, a);
			sphere_point(corner, i + 1, j, n, radius, b);
			sphere_point(corner, i, j + 1, n, radius, c);
			ts_facets_triangle(f, a, b, c);
			if (i + j + 2 > n)
				continue;
			sphere_point(corner, i + 1, j + 1, n, radius, d);
			ts_facets_triangle(f, b, d, c);
		}
}

/* The largest triangles are in the middle of the faces: with edges of length sqrt(2 - 2/sqrt 5) that are stretched
 * by 1/0.7947 in the projection, their circumscribed circle has the radius 0.764 R/n, and their plane is 0.292 R/n^2
 * inside of the sphere, to first order; with n = 1 it is (1 - 0.7947) R. */
#define SAG 0.292

void ts_shape_sphere(struct ts_facets *f, const struct ts_shape_sizes *s)
{
	double radius = s->sphere.radius, corner[3][3];
	int n = (f->segments + 4) / 5;

	if (!isnan(s->error))
		n = ts_facets_count(f, sqrt(SAG * radius / s->error), 1, 1);
	if (isfinite(f->size)) /* the longest edge is 1.05 / 0.7947 R/n */
		n = (int)fmax(n, ceil(1.324 * radius / f->size));
	f->chord = SAG * radius / n / n;
	for (int k = 0; k < 20; k++) {
		icosahedron_face(k, corner);
		add_divided_face(f, (const double(*)[3])corner, n, radius);
	}
}
