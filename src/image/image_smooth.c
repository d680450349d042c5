#include "image/image_smooth.h"

#include <math.h>
#include <string.h>

#include "base/alloc.h"
#include "base/sort.h"
#include "math/vec3.h"

#include "base/banned.h"

/* A corner of a triangle. */
struct corner {
	double x[3];
	size_t triangle;
	int at;
};

static int compare(const void *a, const void *b)
{
	const struct corner *p = a, *q = b;

	for (int d = 0; d < 3; d++)
		if (p->x[d] < q->x[d] || p->x[d] > q->x[d])
			return p->x[d] < q->x[d] ? -1 : 1;
	return p->triangle < q->triangle ? -1 : p->triangle > q->triangle;
}

static bool is_same_place(const struct corner *a, const struct corner *b)
{
	return !memcmp(a->x, b->x, sizeof a->x);
}

static double angle_at(const struct ts_mesh *mesh, size_t t, int c)
{
	double a[3], b[3], size;

	ts_sub(mesh->x[t][(c + 1) % 3], mesh->x[t][c], a);
	ts_sub(mesh->x[t][(c + 2) % 3], mesh->x[t][c], b);
	size = ts_norm(a) * ts_norm(b);
	return size > 0 ? acos(fmax(-1, fmin(1, ts_dot(a, b) / size))) : 0;
}

static void face_normal(const struct ts_mesh *mesh, size_t t, double n[3])
{
	double a[3], b[3], size;

	ts_sub(mesh->x[t][1], mesh->x[t][0], a);
	ts_sub(mesh->x[t][2], mesh->x[t][0], b);
	ts_cross(a, b, n);
	size = ts_norm(n);
	ts_scale(size > 0 ? 1 / size : 0, n, n);
}

/* The normals at one place, where n triangles meet. Triangles whose sides are the other way round count as if they were
 * not. */
static void set_normals(const struct ts_mesh *mesh, const struct corner *corner, size_t n, double least,
			float (*normal)[3][3])
{
	for (size_t k = 0; k < n; k++) {
		double own[3], sum[3] = { 0 }, size;

		face_normal(mesh, corner[k].triangle, own);
		for (size_t l = 0; l < n; l++) {
			double other[3], cosine, weight;

			if (ts_mesh_is_removed(mesh, corner[l].triangle))
				continue;
			face_normal(mesh, corner[l].triangle, other);
			cosine = ts_dot(own, other);
			if (fabs(cosine) < least)
				continue;
			weight = angle_at(mesh, corner[l].triangle, corner[l].at) * (cosine < 0 ? -1 : 1);
			for (int d = 0; d < 3; d++)
				sum[d] += weight * other[d];
		}
		size = ts_norm(sum);
		for (int d = 0; d < 3; d++)
			normal[corner[k].triangle][corner[k].at][d] =
				(float)(size > 0 ? sum[d] / size : own[d]);
	}
}

enum ts_status ts_image_corner_normals(const struct ts_mesh *mesh, double angle, float (*normal)[3][3])
{
	struct corner *corner = ts_alloc(3 * mesh->n + 1, sizeof *corner);
	double least = cos(angle * M_PI / 180);

	if (!corner)
		return TS_NOMEM;
	for (size_t k = 0; k < 3 * mesh->n; k++) {
		corner[k] = (struct corner){ .triangle = k / 3, .at = (int)(k % 3) };
		for (int d = 0; d < 3; d++)
			corner[k].x[d] = mesh->x[k / 3][k % 3][d] + 0.0; /* no -0 */
	}
	ts_sort(corner, 3 * mesh->n, sizeof *corner, compare);
	for (size_t from = 0, to; from < 3 * mesh->n; from = to) {
		for (to = from + 1; to < 3 * mesh->n && is_same_place(&corner[from], &corner[to]); to++)
			;
		set_normals(mesh, corner + from, to - from, least, normal);
	}
	ts_free(corner);
	return TS_OK;
}
