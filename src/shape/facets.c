#include "shape/facets.h"

#include <math.h>

#include "math/constants.h"
#include "math/vec3.h"

#include "base/banned.h"

/* A mesh of so many triangles is a mistake in a size or in the number of segments. */
enum { MOST_TRIANGLES = 2000000 };

void ts_rim_add(struct ts_facets *f, struct ts_rim *rim, double t, double x, double y, double z)
{
	if (f->status != TS_OK)
		return;
	if (TS_GROW(rim->node, rim->capacity, rim->n + 1) != TS_OK) {
		f->status = ts_nomem(&f->sim->error);
		return;
	}
	rim->node[rim->n++] = (struct ts_rim_node){ .t = t, .x = { x, y, z } };
}

void ts_rim_clear(struct ts_rim *rim)
{
	rim->n = 0;
}

void ts_rim_release(struct ts_rim *rim)
{
	ts_free(rim->node);
	*rim = (struct ts_rim){ 0 };
}

void ts_rim_circle(struct ts_facets *f, struct ts_rim *rim, double radius, double z, int segments)
{
	double cs[2];

	if (!(radius > 0)) {
		ts_rim_add(f, rim, 0.5, 0, 0, z);
		return;
	}
	for (int k = 0; k <= segments; k++) {
		ts_facets_direction(k, segments, cs);
		ts_rim_add(f, rim, (double)k / segments, radius * cs[0], radius * cs[1], z);
	}
}

void ts_facets_direction(int64_t k, int64_t n, double cs[2])
{
	int64_t at = ((k % n) + n) % n, quadrant = 4 * at / n, rest = 4 * at - quadrant * n;
	bool upper = 2 * rest > n; /* beyond the diagonal of the quadrant */
	double angle = TS_PI / 2 * (double)(upper ? n - rest : rest) / (double)n;
	double c = 2 * rest == n ? sqrt(0.5) : cos(angle), s = 2 * rest == n ? sqrt(0.5) : sin(angle);
	double x = upper ? s : c, y = upper ? c : s;

	cs[0] = quadrant == 0 ? x : quadrant == 1 ? -y : quadrant == 2 ? -x : y;
	cs[1] = quadrant == 0 ? y : quadrant == 1 ? x : quadrant == 2 ? -y : -x;
}

double ts_facets_between(double a, double b, int i, int n)
{
	if (i == 0 || a == b)
		return a;
	return i == n ? b : (a * (n - i) + b * i) / n;
}

int ts_facets_count(struct ts_facets *f, double length, double across, double aspect)
{
	double n = ceil(length / fmin(f->size, aspect * across) * (1 - 1e-9));

	if (n <= MOST_TRIANGLES)
		return n > 1 ? (int)n : 1;
	ts_facets_fail(f, TS_RANGE,
		       "%s: more than %d triangles; take fewer segments, a larger `size` or `error`, or "
		       "sizes that differ less",
		       f->name, MOST_TRIANGLES);
	return 1;
}

/* From the coordinates of the shape to those of the script. */
static void place(const struct ts_facets *f, const double x[3], double out[3])
{
	for (int d = 0; d < 3; d++) {
		out[d] = x[0] * f->unit[0][d] + (f->mirrored ? -x[1] : x[1]) * f->unit[1][d] +
			 x[2] * f->unit[2][d];
		out[d] += f->origin[d];
	}
}

void ts_facets_triangle(struct ts_facets *f, const double a[3], const double b[3], const double c[3])
{
	struct ts_triangle t = { .solid = "" };
	bool turn = f->inward ^ f->mirrored ^ f->reversed;

	if (f->status != TS_OK)
		return;
	if (f->soup->n >= MOST_TRIANGLES) {
		ts_facets_fail(f, TS_RANGE,
			       "%s: more than %d triangles; take fewer segments, a larger `size` or `error`, "
			       "or sizes that differ less",
			       f->name, MOST_TRIANGLES);
		return;
	}
	place(f, a, t.v[0]);
	place(f, turn ? c : b, t.v[1]);
	place(f, turn ? b : c, t.v[2]);
	if (ts_triangles_add(f->soup, &t) != TS_OK)
		f->status = ts_nomem(&f->sim->error);
}

static void patch_point(const double corner[4][3], int i, int nu, int j, int nv, double out[3])
{
	for (int d = 0; d < 3; d++)
		out[d] = ts_facets_between(ts_facets_between(corner[0][d], corner[1][d], i, nu),
					   ts_facets_between(corner[3][d], corner[2][d], i, nu), j, nv);
}

void ts_facets_patch(struct ts_facets *f, const double corner[4][3], int nu, int nv)
{
	double x[4][3];

	for (int j = 0; j < nv; j++)
		for (int i = 0; i < nu && f->status == TS_OK; i++) {
			patch_point(corner, i, nu, j, nv, x[0]);
			patch_point(corner, i + 1, nu, j, nv, x[1]);
			patch_point(corner, i + 1, nu, j + 1, nv, x[2]);
			patch_point(corner, i, nu, j + 1, nv, x[3]);
			ts_facets_triangle(f, x[0], x[1], x[2]);
			ts_facets_triangle(f, x[0], x[2], x[3]);
		}
}

/* The middle of the step from point k to the next; beyond the last: never. */
static double middle(const struct ts_rim *rim, size_t k)
{
	return k + 1 < rim->n ? rim->node[k].t + rim->node[k + 1].t : INFINITY;
}

void ts_facets_zip(struct ts_facets *f, const struct ts_rim *lower, const struct ts_rim *upper)
{
	size_t i = 0, j = 0;

	while (f->status == TS_OK && (i + 1 < lower->n || j + 1 < upper->n)) {
		const struct ts_rim_node *a = &lower->node[i], *b = &upper->node[j];

		if (middle(lower, i) <= middle(upper, j)) {
			ts_facets_triangle(f, a->x, lower->node[++i].x, b->x);
		} else {
			ts_facets_triangle(f, a->x, upper->node[++j].x, b->x);
		}
	}
}
