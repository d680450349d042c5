#include "mesh/mesh_touch.h"

#include <math.h>

#include "math/vec3.h"

#include "base/banned.h"

/* Barycentric coordinates w of the projection of x onto the plane of the triangle: w_1 e_1 + w_2 e_2 is
 * the part of x - x_0 in the plane, e_1 and e_2 being the edges that start at corner 0. */
static void barycentric_weights(const struct ts_mesh *m, size_t t, const double arm[3], double w[3])
{
	const double *e1 = m->along[t][0], *back = m->along[t][2];
	double l1 = m->length[t][0], l2 = m->length[t][2];
	double a = l1 * l1, b = -l1 * l2 * ts_dot(e1, back), c = l2 * l2;
	double p = l1 * ts_dot(arm, e1), q = -l2 * ts_dot(arm, back), det = a * c - b * b;

	w[1] = (c * p - b * q) / det;
	w[2] = (a * q - b * p) / det;
	w[0] = 1 - w[1] - w[2];
}

static void set_direction(const double point[3], const double x[3], struct ts_mesh_contact_point *s)
{
	ts_sub(x, point, s->n);
	s->distance = ts_norm(s->n);
	ts_scale(s->distance > 0 ? 1 / s->distance : 0, s->n, s->n);
}

static enum ts_mesh_part touch_face(const struct ts_mesh *m, size_t t, const double x[3], const double arm[3],
				    struct ts_mesh_contact_point *s)
{
	double foot[3] = { x[0], x[1], x[2] };

	ts_axpy(-ts_dot(m->normal[t], arm), m->normal[t], foot);
	set_direction(foot, x, s);
	return TS_MESH_FACE;
}

/* ---- seams of flat neighbours
 *
 * No edge or corner is active where the surface is flat to `curvature`. If it bulges there, a strip above the edge is
 * beyond the faces of both triangles: the last of them has the contact, as one with its face. */

/* The corner of triangle t that coincides with point x of the same vertex; 3: none, as of a periodic image. */
static int coincident_corner(const struct ts_mesh *m, size_t t, int32_t vertex, const double x[3])
{
	double tolerance = ts_mesh_tolerance(m, t);
	int k = 0;

	while (k < 3 && (m->vertex[t][k] != vertex || ts_distance2(m->x[t][k], x) > tolerance * tolerance))
		k++;
	return k;
}

static bool is_flat_neighbour(const struct ts_mesh *m, size_t t, int32_t other)
{
	return other >= 0 && !ts_mesh_is_removed(m, (size_t)other) &&
	       ts_mesh_flat_neighbours(m, t, (size_t)other);
}

static double inside_limit(const struct ts_mesh *m, size_t t)
{
	return -ts_mesh_tolerance(m, t) / (2 * m->reach[t]);
}

/* Whether triangle t has the contact above its edge k, beside which x is not above its face. */
static bool owns_seam_edge(const struct ts_mesh *m, size_t t, int k, const double x[3])
{
	const int32_t other = m->neighbour[t][k];
	double arm[3], weight[3];
	int a, b;

	if (m->legacy || !is_flat_neighbour(m, t, other) || (size_t)other > t)
		return false;
	a = coincident_corner(m, (size_t)other, m->vertex[t][k], m->x[t][k]);
	b = coincident_corner(m, (size_t)other, m->vertex[t][(k + 1) % 3], m->x[t][(k + 1) % 3]);
	if (a > 2 || b > 2)
		return false;
	ts_sub(x, m->x[other][0], arm);
	barycentric_weights(m, (size_t)other, arm, weight);
	return !(weight[3 - a - b] > inside_limit(m, (size_t)other));
}

/* Whether x is farther from the edges of triangle t that meet in its corner k than from the corner. */
static bool is_beyond_corner(const struct ts_mesh *m, size_t t, int k, const double arm[3])
{
	double tolerance = ts_mesh_tolerance(m, t);

	return ts_dot(arm, m->along[t][k]) < -tolerance && ts_dot(arm, m->along[t][(k + 2) % 3]) > tolerance;
}

/* Whether triangle t has the contact above its corner k: x is beyond that corner of all triangles around it, which are flat
 * neighbours, and t is the last of them. */
static bool owns_seam_corner(const struct ts_mesh *m, size_t t, int k, const double x[3])
{
	size_t at = t, steps = 0;
	int corner = k, edge = k;
	double arm[3];

	ts_sub(x, m->x[t][k], arm);
	do {
		const int32_t next = m->neighbour[at][edge];

		if (m->legacy || !is_flat_neighbour(m, at, next) || (size_t)next > t || steps++ > m->n ||
		    !is_beyond_corner(m, at, corner, arm))
			return false;
		corner = coincident_corner(m, (size_t)next, m->vertex[t][k], m->x[t][k]);
		if (corner > 2)
			return false;
		edge = m->neighbour[next][corner] == (int32_t)at ? (corner + 2) % 3 : corner;
		at = (size_t)next;
	} while (at != t);
	return true;
}

static enum ts_mesh_part touch_corner(const struct ts_mesh *m, size_t t, int k, const double x[3],
				      struct ts_mesh_contact_point *s)
{
	const bool active = ts_mesh_corner_active(m, t, k);

	if (!active && !owns_seam_corner(m, t, k, x))
		return TS_MESH_NOTHING;
	for (int d = 0; d < 3; d++)
		s->weight[d] = d == k;
	set_direction(m->x[t][k], x, s);
	return active ? TS_MESH_CORNER : TS_MESH_FACE;
}

static enum ts_mesh_part touch_edge(const struct ts_mesh *m, size_t t, int k, const double x[3],
				    struct ts_mesh_contact_point *s)
{
	const double *along = m->along[t][k];
	double length = m->length[t][k], tolerance = ts_mesh_tolerance(m, t), arm[3], position, point[3];
	const bool active = ts_mesh_edge_active(m, t, k);

	ts_sub(x, m->x[t][k], arm);
	position = ts_dot(arm, along);
	if (position < -tolerance)
		return touch_corner(m, t, k, x, s);
	if (position > length + tolerance)
		return touch_corner(m, t, (k + 1) % 3, x, s);
	if (!active && !owns_seam_edge(m, t, k, x))
		return TS_MESH_NOTHING;
	s->weight[k] = 1 - position / length;
	s->weight[(k + 1) % 3] = position / length;
	s->weight[(k + 2) % 3] = 0;
	for (int d = 0; d < 3; d++)
		point[d] = m->x[t][k][d] + position * along[d];
	set_direction(point, x, s);
	return active ? TS_MESH_EDGE : TS_MESH_FACE;
}

/* The projection is beyond both edges of corner k; if the angle of the corner is obtuse, the nearest point
 * may still be on one of these edges. LIGGGHTS checks this at the last corner of a triangle only: at the
 * others, if the corner is not active, a contact ends there. */
static enum ts_mesh_part touch_beyond_corner(const struct ts_mesh *m, size_t t, int k, const double x[3],
					     struct ts_mesh_contact_point *s)
{
	int before = (k + 2) % 3;
	double arm[3];

	if (m->legacy && k != 2)
		return touch_corner(m, t, k, x, s);
	ts_sub(x, m->x[t][k], arm);
	if (ts_dot(arm, m->along[t][k]) > 0)
		return touch_edge(m, t, k, x, s);
	if (ts_dot(arm, m->along[t][before]) < 0)
		return touch_edge(m, t, before, x, s);
	return touch_corner(m, t, k, x, s);
}

enum ts_mesh_part ts_mesh_nearest(const struct ts_mesh *m, size_t t, const double x[3],
				  struct ts_mesh_contact_point *s)
{
	double arm[3], least = inside_limit(m, t);
	int inside = 0, negative = 0;

	ts_sub(x, m->x[t][0], arm);
	barycentric_weights(m, t, arm, s->weight);
	for (int k = 0; k < 3; k++) {
		bool in = s->weight[k] > least;

		inside += in ? 1 : 0;
		negative += in ? 0 : k; /* the only one, if two are inside */
	}
	if (inside == 3)
		return touch_face(m, t, x, arm, s);
	if (inside == 2)
		return touch_edge(m, t, (negative + 1) % 3, x, s);
	return touch_beyond_corner(m, t, 3 - negative, x, s); /* the only one that is inside */
}
