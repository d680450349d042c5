#include "mesh/mesh_links.h"

#include <math.h>
#include <stdlib.h>

#include "base/alloc.h"
#include "base/sort.h"
#include "geom/pointhash.h"
#include "math/vec3.h"

#include "base/banned.h"

/* Farther away than this, in box lengths, rounding exceeds the box: the periodic image is meaningless. */
static const double MOST_BOXES = 1e9;

/* Wraps a corner into the box; `shift`: its periodic image, in box lengths. */
static void wrap_corner(const struct ts_box *box, double precision, const double x[3], double at[3],
			int32_t shift[3])
{
	for (int d = 0; d < 3; d++) {
		double boxes;

		at[d] = x[d];
		shift[d] = 0;
		if (!box || !ts_box_periodic(box, d))
			continue;
		/* a corner within `precision` of the upper face is wrapped to the lower one */
		boxes = floor((x[d] - box->lo[d] + precision) / ts_box_length(box, d));
		if (!(fabs(boxes) < MOST_BOXES))
			continue;
		shift[d] = (int32_t)boxes;
		at[d] -= shift[d] * ts_box_length(box, d);
	}
}

/* Upper bound of the rounding errors of coordinates of this mesh, length. */
static double coordinate_rounding(const struct ts_mesh *m)
{
	double most = 0;

	for (size_t c = 0; c < 9 * m->n; c++)
		most = fmax(most, fabs(m->x[c / 9][c / 3 % 3][c % 3]));
	return 0x1p-50 * most;
}

static enum ts_status number_vertices(struct ts_mesh *m, double precision, const struct ts_box *box,
				      int32_t (*shift)[3])
{
	double distance = fmax(precision, 1e-300), apart = 0;
	struct ts_pointhash places;
	enum ts_status status = ts_pointhash_start(&places, distance);

	for (size_t c = 0; status == TS_OK && c < 3 * m->n; c++) {
		int32_t *number = &m->vertex[c / 3][c % 3];
		double at[3];

		wrap_corner(box, precision, m->x[c / 3][c % 3], at, shift[c]);
		*number = ts_pointhash_find(&places, at, distance);
		if (*number >= 0) {
			apart = fmax(apart, ts_distance2(at, places.x[*number]));
			continue;
		}
		*number = (int32_t)places.n;
		status = ts_pointhash_add(&places, at);
	}
	m->nvertices = places.n;
	m->loose = 2 * sqrt(apart) +
		   coordinate_rounding(m); /* two corners may each be this far from the first one */
	ts_pointhash_release(&places);
	return status;
}

/* An edge: its vertices, and the box lengths between their periodic images. Shared edges compare equal. */
struct edge {
	int32_t end[2], apart[3], triangle, k;
};

static int compare_ends(const struct edge *p, const struct edge *q)
{
	for (int k = 0; k < 2; k++)
		if (p->end[k] != q->end[k])
			return p->end[k] < q->end[k] ? -1 : 1;
	for (int k = 0; k < 3; k++)
		if (p->apart[k] != q->apart[k])
			return p->apart[k] < q->apart[k] ? -1 : 1;
	return 0;
}

/* Edge k of triangle t, with its ends in an order that does not depend on the triangle. */
static struct edge canonical_edge(const struct ts_mesh *m, size_t t, int k, int32_t (*shift)[3])
{
	size_t from = 3 * t + (size_t)k, to = 3 * t + (size_t)(k + 1) % 3;
	struct edge e = { .end = { m->vertex[t][k], m->vertex[t][(k + 1) % 3] },
			  .triangle = (int32_t)t,
			  .k = k },
		    back = e;

	for (int d = 0; d < 3; d++) {
		e.apart[d] = shift[to][d] - shift[from][d];
		back.apart[d] = -e.apart[d];
	}
	back.end[0] = e.end[1];
	back.end[1] = e.end[0];
	return compare_ends(&e, &back) <= 0 ? e : back;
}

static int by_vertices(const void *a, const void *b)
{
	const struct edge *p = a, *q = b;

	int order = compare_ends(p, q);

	if (order)
		return order;
	return (p->triangle > q->triangle) - (p->triangle < q->triangle);
}

static bool are_flat(const struct ts_mesh *m, int32_t a, int32_t b)
{
	return fabs(ts_dot(m->normal[a], m->normal[b])) > m->flat;
}

static void set_edge(struct ts_mesh *m, const struct edge *e, bool active)
{
	m->active[e->triangle] =
		(uint8_t)((m->active[e->triangle] & ~(1u << e->k)) | (unsigned)active << e->k);
}

/* n triangles share an edge: it is active in the last one, unless that has a flat neighbour there. */
static void link_edge(struct ts_mesh *m, const struct edge *e, size_t n)
{
	for (size_t a = 0; a < n; a++) {
		bool active = a + 1 == n;

		for (size_t b = 0; b < n; b++)
			active &= a == b || !are_flat(m, e[a].triangle, e[b].triangle);
		set_edge(m, &e[a], active);
		m->neighbour[e[a].triangle][e[a].k] = n == 1 ? -1 : n == 2 ? e[1 - a].triangle : TS_MESH_MANY;
	}
}

static enum ts_status link_edges(struct ts_mesh *m, int32_t (*shift)[3])
{
	size_t n = 3 * m->n;
	struct edge *list = ts_alloc(n, sizeof *list);

	if (!list)
		return TS_NOMEM;
	for (size_t c = 0; c < n; c++)
		list[c] = canonical_edge(m, c / 3, (int)(c % 3), shift);
	ts_sort(list, n, sizeof *list, by_vertices);
	for (size_t k = 0, same; k < n; k += same) {
		for (same = 1; k + same < n && !compare_ends(&list[k], &list[k + same]);)
			same++;
		link_edge(m, &list[k], same);
	}
	ts_free(list);
	return TS_OK;
}

/* The corners at each vertex: corner[start[v]] .. corner[start[v + 1] - 1]. */
struct vertex_corners {
	uint32_t *start; /* [nvertices + 1] */
	int32_t *corner; /* 3 * triangle + k, ascending for each vertex */
};

static enum ts_status list_vertex_corners(const struct ts_mesh *m, struct vertex_corners *a)
{
	a->start = ts_alloc(m->nvertices + 2, sizeof *a->start);
	a->corner = ts_alloc(3 * m->n, sizeof *a->corner);
	if (!a->start || !a->corner)
		return TS_NOMEM;
	for (size_t c = 0; c < 3 * m->n; c++)
		a->start[m->vertex[c / 3][c % 3] + 2]++;
	for (size_t v = 2; v < m->nvertices + 2; v++)
		a->start[v] += a->start[v - 1];
	for (size_t c = 0; c < 3 * m->n; c++)
		a->corner[a->start[m->vertex[c / 3][c % 3] + 1]++] = (int32_t)c;
	return TS_OK;
}

/* Unit vectors along the two edges of a triangle that meet at a corner, pointing away from it. `corner`: 3
 * t + k. */
static void edges_from_corner(const struct ts_mesh *m, int32_t corner, double out[2][3])
{
	int32_t t = corner / 3, k = corner % 3;

	ts_scale(1, m->along[t][k], out[0]);
	ts_scale(-1, m->along[t][(k + 2) % 3], out[1]);
}

static bool has_straight_edges(const struct ts_mesh *m, const int32_t *corner, size_t n)
{
	double a[2][3], b[2][3];

	for (size_t i = 0; i < n; i++) {
		edges_from_corner(m, corner[i], a);
		for (size_t j = 0; j < i; j++) {
			edges_from_corner(m, corner[j], b);
			for (int k = 0; k < 4; k++)
				if (ts_dot(a[k / 2], b[k % 2]) < -m->flat)
					return true;
		}
	}
	return false;
}

static bool any_edge_active(const struct ts_mesh *m, const int32_t *corner, size_t n)
{
	for (size_t i = 0; i < n; i++) {
		int32_t t = corner[i] / 3, k = corner[i] % 3;

		if (ts_mesh_edge_active(m, (size_t)t, k) || ts_mesh_edge_active(m, (size_t)t, (k + 2) % 3))
			return true;
	}
	return false;
}

/* Removes the corners of removed triangles from a list; returns the number of the others. */
static size_t leave_out_removed(const struct ts_mesh *m, int32_t *corner, size_t n)
{
	size_t kept = 0;

	for (size_t k = 0; k < n; k++)
		if (!ts_mesh_is_removed(m, (size_t)corner[k] / 3))
			corner[kept++] = corner[k];
	return kept;
}

static enum ts_status link_corners(struct ts_mesh *m)
{
	struct vertex_corners a = { 0 };
	enum ts_status status = list_vertex_corners(m, &a);

	for (size_t v = 0; status == TS_OK && v < m->nvertices; v++) {
		int32_t *corner = a.corner + a.start[v];
		size_t n = leave_out_removed(m, corner, a.start[v + 1] - a.start[v]);

		if (any_edge_active(m, corner, n) && !has_straight_edges(m, corner, n))
			m->active[corner[n - 1] / 3] |= (uint8_t)(8u << corner[n - 1] % 3);
	}
	ts_free(a.start);
	ts_free(a.corner);
	return status;
}

enum ts_status ts_mesh_link(struct ts_mesh *m, double precision, const struct ts_box *box)
{
	int32_t(*shift)[3] = ts_alloc(3 * m->n, sizeof *shift);
	enum ts_status status = shift ? TS_OK : TS_NOMEM;

	for (size_t t = 0; t < m->n; t++)
		m->active[t] = 0;
	if (status == TS_OK)
		status = number_vertices(m, precision, box, shift);
	if (status == TS_OK)
		status = link_edges(m, shift);
	ts_free(shift);
	return status == TS_OK ? link_corners(m) : status;
}

/* As link_edge does. */
static bool is_edge_active(const struct ts_mesh *m, size_t t, int k)
{
	int32_t other = m->neighbour[t][k];

	if (ts_mesh_is_removed(m, t))
		return false;
	if (other == TS_MESH_MANY)
		return ts_mesh_edge_active(m, t, k);
	return other < 0 || ts_mesh_is_removed(m, (size_t)other) ||
	       ((size_t)other < t && !are_flat(m, (int32_t)t, other));
}

enum ts_status ts_mesh_update_active(struct ts_mesh *m)
{
	for (size_t t = 0; t < m->n; t++) {
		uint8_t active = m->active[t] & TS_MESH_REMOVED;

		for (int k = 0; k < 3; k++)
			active |= (uint8_t)(is_edge_active(m, t, k) << k);
		m->active[t] = active;
	}
	return link_corners(m);
}
