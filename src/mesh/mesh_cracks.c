#include "mesh/mesh_cracks.h"

#include <math.h>
#include <stdlib.h>

#include "base/alloc.h"
#include "base/sort.h"
#include "math/vec3.h"

#include "base/banned.h"

/* The ends of open edges are sorted along the longest dimension of the mesh, and each open edge is
 * compared with the ends in its range. With many unconnected triangles the number of comparisons grows as
 * n^2: after MOST_COMPARISONS the search is ended. NARROW: largest width of a crack relative to the length
 * of the edge. */
#define NARROW 1e-3
enum { MOST_COMPARISONS = 50000000 };

struct end {
	double x[3];
	int32_t vertex, triangle;
};

struct search {
	const struct ts_mesh *m;
	struct end *end;
	size_t nends;
	int axis;
	long comparisons;
	ts_mesh_crack_fn *found;
	void *context;
};

static double distance_to_edge(const double x[3], const double a[3], const double along[3], double length)
{
	double d[3], s;

	ts_sub(x, a, d);
	s = fmin(fmax(ts_dot(d, along), 0), length);
	ts_axpy(-s, along, d);
	return ts_norm(d);
}

/* Index of the first end with a coordinate >= `from` along the axis of sorting. */
static size_t first_end(const struct search *s, double from)
{
	size_t lo = 0, hi = s->nends;

	while (lo < hi) {
		size_t mid = (lo + hi) / 2;

		if (s->end[mid].x[s->axis] < from)
			lo = mid + 1;
		else
			hi = mid;
	}
	return lo;
}

static bool has_vertex(const int32_t of[3], int32_t vertex)
{
	return of[0] == vertex || of[1] == vertex || of[2] == vertex;
}

static enum ts_status compare_edge(struct search *s, const struct ts_mesh_edge *e)
{
	const double *a = s->m->x[e->triangle][e->k];
	const double *b = s->m->x[e->triangle][(e->k + 1) % 3];
	double length = s->m->length[e->triangle][e->k], reach = NARROW * length;
	double last = fmax(a[s->axis], b[s->axis]) + reach;

	for (size_t k = first_end(s, fmin(a[s->axis], b[s->axis]) - reach);
	     k < s->nends && s->end[k].x[s->axis] <= last && s->comparisons < MOST_COMPARISONS; k++) {
		const struct end *end = &s->end[k];
		double width;

		s->comparisons++;
		if (has_vertex(s->m->vertex[e->triangle], end->vertex))
			continue;
		width = distance_to_edge(end->x, a, s->m->along[e->triangle][e->k], length);
		if (width < reach)
			TS_TRY(s->found(s->context, end->triangle, e->triangle, end->x, width));
	}
	return TS_OK;
}

static int order_along(const struct end *p, const struct end *q, int axis)
{
	double a = p->x[axis], b = q->x[axis];

	return a < b ? -1 : a > b ? 1 : (p->vertex > q->vertex) - (p->vertex < q->vertex);
}

static int by_x(const void *a, const void *b)
{
	return order_along(a, b, 0);
}

static int by_y(const void *a, const void *b)
{
	return order_along(a, b, 1);
}

static int by_z(const void *a, const void *b)
{
	return order_along(a, b, 2);
}

static bool is_open_edge(const struct ts_mesh_edge *edge, size_t n, size_t k)
{
	const struct ts_mesh_edge *e = &edge[k];

	return !(k && e[-1].lo == e->lo && e[-1].hi == e->hi) &&
	       !(k + 1 < n && e[1].lo == e->lo && e[1].hi == e->hi);
}

static void list_ends(struct search *s, const struct ts_mesh_edge *edge, size_t n)
{
	static int (*const sorts[])(const void *, const void *) = { by_x, by_y, by_z };
	double lo[3], hi[3];

	for (size_t k = 0; k < n; k++)
		for (int side = 0; is_open_edge(edge, n, k) && side < 2; side++) {
			int32_t t = edge[k].triangle, c = (edge[k].k + side) % 3;
			const double *x = s->m->x[t][c];

			s->end[s->nends++] = (struct end){ { x[0], x[1], x[2] }, s->m->vertex[t][c], t };
		}
	ts_mesh_bounds(s->m, lo, hi);
	ts_sub(hi, lo, hi);
	s->axis = hi[0] >= hi[1] && hi[0] >= hi[2] ? 0 : hi[1] >= hi[2] ? 1 : 2;
	ts_sort(s->end, s->nends, sizeof *s->end, sorts[s->axis]);
}

enum ts_status ts_mesh_cracks(const struct ts_mesh *mesh, const struct ts_mesh_edge *edge, size_t n,
			      ts_mesh_crack_fn *found, void *context)
{
	struct search s = { .m = mesh, .found = found, .context = context };
	enum ts_status status = TS_OK;

	s.end = ts_alloc(2 * n, sizeof *s.end);
	if (!s.end)
		return TS_NOMEM;
	list_ends(&s, edge, n);
	for (size_t k = 0; status == TS_OK && k < n; k++)
		if (is_open_edge(edge, n, k))
			status = compare_edge(&s, &edge[k]);
	ts_free(s.end);
	return status;
}
