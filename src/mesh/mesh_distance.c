#include "mesh/mesh_distance.h"

#include <math.h>

#include "math/constants.h"
#include "math/vec3.h"

#include "base/banned.h"

static void edge_weights(int a, int b, double fraction, double weight[3])
{
	weight[a] = 1 - fraction;
	weight[b] = fraction;
	weight[3 - a - b] = 0;
}

static void corner_weights(int a, double weight[3])
{
	for (int k = 0; k < 3; k++)
		weight[k] = k == a;
}

void ts_mesh_nearest_point(const struct ts_mesh *mesh, size_t t, const double x[3], double weight[3])
{
	const double(*corner)[3] = (const double(*)[3])mesh->x[t];
	double e1[3], e2[3], arm[3], d[6], va, vb, vc;

	ts_sub(corner[1], corner[0], e1);
	ts_sub(corner[2], corner[0], e2);
	for (int k = 0; k < 3; k++) { /* projections of x - corner k onto both edges */
		ts_sub(x, corner[k], arm);
		d[2 * k] = ts_dot(e1, arm);
		d[2 * k + 1] = ts_dot(e2, arm);
	}
	va = d[2] * d[5] - d[4] * d[3];
	vb = d[4] * d[1] - d[0] * d[5];
	vc = d[0] * d[3] - d[2] * d[1];
	if (d[0] <= 0 && d[1] <= 0)
		corner_weights(0, weight);
	else if (d[2] >= 0 && d[3] <= d[2])
		corner_weights(1, weight);
	else if (d[5] >= 0 && d[4] <= d[5])
		corner_weights(2, weight);
	else if (vc <= 0 && d[0] >= 0 && d[2] <= 0)
		edge_weights(0, 1, d[0] / (d[0] - d[2]), weight);
	else if (vb <= 0 && d[1] >= 0 && d[5] <= 0)
		edge_weights(0, 2, d[1] / (d[1] - d[5]), weight);
	else if (va <= 0 && d[3] - d[2] >= 0 && d[4] - d[5] >= 0)
		edge_weights(1, 2, (d[3] - d[2]) / (d[3] - d[2] + d[4] - d[5]), weight);
	else {
		weight[0] = va / (va + vb + vc);
		weight[1] = vb / (va + vb + vc);
		weight[2] = 1 - weight[0] - weight[1];
	}
}

/* Unsigned distance: vector and distance from the nearest point of triangle t to x. */
static void triangle_distance(const struct ts_mesh *mesh, size_t t, const double x[3],
			      struct ts_mesh_distance *d)
{
	ts_mesh_nearest_point(mesh, t, x, d->weight);
	for (int k = 0; k < 3; k++)
		d->n[k] = x[k] - d->weight[0] * mesh->x[t][0][k] - d->weight[1] * mesh->x[t][1][k] -
			  d->weight[2] * mesh->x[t][2][k];
	d->distance = ts_norm(d->n);
	d->triangle = (int32_t)t;
}

double ts_mesh_distance(const struct ts_mesh *mesh, size_t t, const double x[3])
{
	struct ts_mesh_distance d;

	triangle_distance(mesh, t, x, &d);
	return d.distance;
}

double ts_mesh_distance_least(const struct ts_mesh *mesh, const struct ts_mesh_tree *tree, const double x[3])
{
	struct ts_mesh_descent d;
	double least = INFINITY;
	size_t t;

	for (ts_mesh_tree_descend(&d, tree, x); ts_mesh_tree_next(&d, least, &t);)
		least = fmin(least, ts_mesh_distance(mesh, t, x));
	return least;
}

enum ts_status ts_mesh_signed_distance(const struct ts_mesh *mesh, const struct ts_mesh_tree *tree,
				       const double x[3], double reach, struct ts_mesh_list *list, bool *near,
				       struct ts_mesh_distance *out)
{
	double front = 0; /* cosine of the angle between the normal and the line to x */

	*near = false;
	list->n = 0;
	TS_TRY(ts_mesh_tree_near(tree, mesh, x, reach, list));
	for (size_t k = 0; k < list->n; k++) {
		struct ts_mesh_distance one;
		double cosine, tie = 1e-9 * reach;
		bool as_near;

		triangle_distance(mesh, (size_t)list->item[k], x, &one);
		cosine = ts_dot(mesh->normal[one.triangle], one.n) / fmax(one.distance, 1e-300);
		as_near = *near && fabs(one.distance - out->distance) <= tie;
		if (one.distance > reach || (*near && !as_near && one.distance > out->distance) ||
		    (as_near && fabs(cosine) <= fabs(front)))
			continue;
		*near = true;
		*out = one;
		front = cosine;
	}
	if (!*near)
		return TS_OK;
	for (int k = 0; k < 3; k++)
		out->n[k] = out->distance > 1e-12 * reach ? (front < 0 ? -1 : 1) * out->n[k] / out->distance
							  : mesh->normal[out->triangle][k];
	out->distance *= front < 0 ? -1 : 1;
	return TS_OK;
}

bool ts_mesh_inside(const struct ts_mesh *mesh, const double x[3])
{
	double angle = 0;

	for (size_t t = 0; t < mesh->n; t++) {
		double r[3][3], l[3], cross[3];

		for (int k = 0; k < 3; k++) {
			ts_sub(mesh->x[t][k], x, r[k]);
			l[k] = ts_norm(r[k]);
		}
		ts_cross(r[1], r[2], cross);
		angle += 2 * atan2(ts_dot(r[0], cross), l[0] * l[1] * l[2] + ts_dot(r[0], r[1]) * l[2] +
								ts_dot(r[1], r[2]) * l[0] +
								ts_dot(r[2], r[0]) * l[1]);
	}
	return fabs(angle) > 2 * TS_PI; /* half of 4 pi; < 0 with normals inwards */
}

bool ts_mesh_closed(const struct ts_mesh *mesh, size_t *t)
{
	for (*t = 0; *t < mesh->n; ++*t)
		for (int k = 0; k < 3; k++)
			if (mesh->neighbour[*t][k] < 0)
				return false;
	return true;
}
