#include "mesh/mesh_doctor.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/sort.h"
#include "math/constants.h"
#include "math/vec3.h"
#include "mesh/mesh_cracks.h"

#include "base/banned.h"

#define FAULT_TEXT(name, what, unit, remedy) { what, unit, remedy },
const struct ts_mesh_fault_text ts_mesh_fault_texts[] = { TS_MESH_FAULT_LIST(FAULT_TEXT) };

struct examination {
	const struct ts_mesh *m;
	double curvature;
	struct ts_mesh_findings *out;
	uint8_t *excluded;   /* collapsed or duplicate triangles, which are not examined further */
	int32_t *neighbours; /* number of neighbours of each triangle over all its edges */
	struct ts_mesh_edge *edge;
	size_t nedges;
};

static enum ts_status add_finding(struct examination *d, enum ts_mesh_fault fault, int32_t t, int32_t other,
				  const double at[3], double amount)
{
	struct ts_mesh_findings *out = d->out;

	TS_TRY(TS_GROW(out->list, out->capacity, out->n + 1));
	out->list[out->n++] = (struct ts_mesh_finding){
		.fault = fault, .triangle = t, .other = other, .at = { at[0], at[1], at[2] }, .amount = amount
	};
	return TS_OK;
}

static enum ts_status add_finding_at_centre(struct examination *d, enum ts_mesh_fault fault, int32_t t,
					    int32_t other, double amount)
{
	return add_finding(d, fault, t, other, d->m->centre[t], amount);
}

/* ---- single triangles ---- */

static double smallest_angle(const struct ts_mesh *m, size_t t)
{
	double smallest = INFINITY, c[3];

	for (int k = 0; k < 3; k++) {
		const double *on = m->along[t][k], *back = m->along[t][(k + 2) % 3];

		ts_cross(back, on, c);
		smallest = fmin(smallest, atan2(ts_norm(c), -ts_dot(on, back)));
	}
	return smallest * (180 / TS_PI);
}

static enum ts_status examine_shape(struct examination *d, int32_t t)
{
	const int32_t *v = d->m->vertex[t];
	double angle;

	if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0]) {
		d->excluded[t] = 1;
		return add_finding_at_centre(d, TS_MESH_COLLAPSED, t, -1, 0);
	}
	angle = smallest_angle(d->m, (size_t)t);
	if (angle < TS_MESH_HARD_ANGLE)
		TS_TRY(add_finding_at_centre(d, TS_MESH_NEEDLE, t, -1, angle));
	else if (angle < d->curvature)
		TS_TRY(add_finding_at_centre(d, TS_MESH_SHARP, t, -1, angle));
	else if (angle < TS_MESH_SOFT_ANGLE)
		TS_TRY(add_finding_at_centre(d, TS_MESH_SLIVER, t, -1, angle));
	return TS_OK;
}

/* ---- duplicates ---- */

struct key {
	int32_t v[3], triangle;
};

static int compare_ints(const int32_t *a, const int32_t *b, int n)
{
	for (int k = 0; k < n; k++)
		if (a[k] != b[k])
			return a[k] < b[k] ? -1 : 1;
	return 0;
}

static int by_key(const void *a, const void *b)
{
	return compare_ints(((const struct key *)a)->v, ((const struct key *)b)->v, 4);
}

static void sort3(int32_t v[3])
{
	for (int k = 0; k < 3; k++) {
		int i = k == 1, j = i + 1; /* compare and exchange (0, 1), (1, 2), (0, 1) */
		int32_t lo = v[i] < v[j] ? v[i] : v[j], hi = v[i] < v[j] ? v[j] : v[i];

		v[i] = lo;
		v[j] = hi;
	}
}

static enum ts_status mark_duplicates(struct examination *d, const struct key *key)
{
	for (size_t k = 1, first = 0; k < d->m->n; k++) {
		if (compare_ints(key[first].v, key[k].v, 3) != 0) {
			first = k;
		} else if (!d->excluded[key[k].triangle]) {
			d->excluded[key[k].triangle] = 1;
			TS_TRY(add_finding_at_centre(d, TS_MESH_DUPLICATE, key[k].triangle,
						     key[first].triangle, 0));
		}
	}
	return TS_OK;
}

static enum ts_status examine_duplicates(struct examination *d)
{
	struct key *key = ts_alloc(d->m->n, sizeof *key);
	enum ts_status status;

	if (!key)
		return TS_NOMEM;
	for (size_t t = 0; t < d->m->n; t++) {
		memcpy(key[t].v, d->m->vertex[t], sizeof key[t].v);
		sort3(key[t].v);
		key[t].triangle = (int32_t)t;
	}
	ts_sort(key, d->m->n, sizeof *key, by_key);
	status = mark_duplicates(d, key);
	ts_free(key);
	return status;
}

/* ---- edges ---- */

static int by_edge(const void *a, const void *b)
{
	const struct ts_mesh_edge *p = a, *q = b;

	return compare_ints((int32_t[]){ p->lo, p->hi, p->triangle },
			    (int32_t[]){ q->lo, q->hi, q->triangle }, 3);
}

static enum ts_status list_edges(struct examination *d)
{
	const struct ts_mesh *m = d->m;

	d->edge = ts_alloc(3 * m->n, sizeof *d->edge);
	if (!d->edge)
		return TS_NOMEM;
	for (size_t c = 0; c < 3 * m->n; c++) {
		int32_t a = m->vertex[c / 3][c % 3], b = m->vertex[c / 3][(c + 1) % 3];

		if (!d->excluded[c / 3])
			d->edge[d->nedges++] = (struct ts_mesh_edge){ .lo = a < b ? a : b,
								      .hi = a < b ? b : a,
								      .triangle = (int32_t)(c / 3),
								      .k = (int32_t)(c % 3) };
	}
	ts_sort(d->edge, d->nedges, sizeof *d->edge, by_edge);
	return TS_OK;
}

static size_t count_same_edges(const struct examination *d, size_t from)
{
	size_t n = 1;

	while (from + n < d->nedges && d->edge[from].lo == d->edge[from + n].lo &&
	       d->edge[from].hi == d->edge[from + n].hi)
		n++;
	return n;
}

/* Whether two triangles that share an edge are (nearly) in the same plane and on the same side of the
 * edge. */
static bool is_folded(const struct ts_mesh *m, const struct ts_mesh_edge *e)
{
	int32_t a = e[0].triangle, b = e[1].triangle;
	double p[3], q[3];
	const double *along = m->along[a][e[0].k], *corner = m->x[a][e[0].k];

	if (fabs(ts_dot(m->normal[a], m->normal[b])) <= m->flat)
		return false;
	ts_sub(m->x[a][(e[0].k + 2) % 3], corner, p);
	ts_sub(m->x[b][(e[1].k + 2) % 3], corner, q);
	ts_axpy(-ts_dot(p, along), along, p);
	ts_axpy(-ts_dot(q, along), along, q);
	return ts_dot(p, q) > 0;
}

static void edge_middle(const struct ts_mesh *m, const struct ts_mesh_edge *e, double out[3])
{
	ts_add(m->x[e->triangle][e->k], m->x[e->triangle][(e->k + 1) % 3], out);
	ts_scale(0.5, out, out);
}

static enum ts_status examine_edge(struct examination *d, const struct ts_mesh_edge *e, size_t n)
{
	double at[3];

	edge_middle(d->m, e, at);
	for (size_t k = 0; k < n; k++)
		d->neighbours[e[k].triangle] += (int32_t)n - 1;
	if (n == 1)
		return add_finding(d, TS_MESH_OPEN, e->triangle, -1, at, 0);
	if (n == 2 && is_folded(d->m, e))
		return add_finding(d, TS_MESH_FOLDED, e[1].triangle, e[0].triangle, at, 0);
	for (size_t k = 0; n > 2 && k < n; k++)
		TS_TRY(add_finding(d, TS_MESH_BRANCHED, e[k].triangle, e[!k].triangle, at, (double)n));
	return TS_OK;
}

static enum ts_status examine_edges(struct examination *d)
{
	TS_TRY(list_edges(d));
	for (size_t k = 0, n; k < d->nedges; k += n) {
		n = count_same_edges(d, k);
		TS_TRY(examine_edge(d, &d->edge[k], n));
	}
	for (size_t t = 0; t < d->m->n; t++)
		if (d->neighbours[t] > 5)
			TS_TRY(add_finding_at_centre(d, TS_MESH_CROWDED, (int32_t)t, -1, d->neighbours[t]));
	return TS_OK;
}

/* ---- orientation ---- */

/* Whether both triangles have edge k of t in the same direction, so that their normals are on opposite
 * sides. */
static bool same_direction(const struct ts_mesh *m, int32_t t, int k, int32_t other)
{
	for (int j = 0; j < 3; j++)
		if (m->vertex[other][j] == m->vertex[t][k] &&
		    m->vertex[other][(j + 1) % 3] == m->vertex[t][(k + 1) % 3])
			return true;
	return false;
}

/* Flood fill over edges shared by two triangles, from triangle `first`. side[t] is set to 1 or 2 for the two
 * orientations. Returns the number of connected triangles, which are left in `queue`. */
static size_t flood_orientation(const struct examination *d, int32_t first, uint8_t *side, int32_t *queue)
{
	size_t n = 0;

	queue[n++] = first;
	side[first] = 1;
	for (size_t at = 0; at < n; at++) {
		int32_t t = queue[at];

		for (int k = 0; k < 3; k++) {
			int32_t other = d->m->neighbour[t][k];

			if (other < 0 || d->excluded[other] || side[other])
				continue;
			side[other] = same_direction(d->m, t, k, other) ? 3 - side[t] : side[t];
			queue[n++] = other;
		}
	}
	return n;
}

/* In each connected part the triangles of the less frequent orientation are reported as flipped. */
static enum ts_status examine_orientation(struct examination *d, uint8_t *side, int32_t *queue)
{
	for (size_t first = 0; first < d->m->n; first++) {
		size_t n, ones = 0;

		if (d->excluded[first] || side[first])
			continue;
		n = flood_orientation(d, (int32_t)first, side, queue);
		for (size_t k = 0; k < n; k++)
			ones += side[queue[k]] == 1;
		for (size_t k = 0; k < n; k++)
			if (side[queue[k]] == (2 * ones < n ? 1 : 2))
				TS_TRY(add_finding_at_centre(d, TS_MESH_FLIPPED, queue[k], -1, 0));
	}
	return TS_OK;
}

/* ---- all ---- */

static enum ts_status add_crack(void *context, int32_t t, int32_t other, const double at[3], double width)
{
	return add_finding(context, TS_MESH_CRACKED, t, other, at, width);
}

static int by_fault(const void *a, const void *b)
{
	const struct ts_mesh_finding *p = a, *q = b;

	return compare_ints((int32_t[]){ (int32_t)p->fault, p->triangle, p->other },
			    (int32_t[]){ (int32_t)q->fault, q->triangle, q->other }, 3);
}

/* Sorts and counts the findings, and removes repeated ones of the same triangle and fault. */
static void sort_findings(struct ts_mesh_findings *f)
{
	size_t n = 0;

	ts_sort(f->list, f->n, sizeof *f->list, by_fault);
	for (size_t k = 0; k < f->n; k++) {
		if (n && f->list[n - 1].fault == f->list[k].fault &&
		    f->list[n - 1].triangle == f->list[k].triangle)
			continue;
		f->list[n++] = f->list[k];
		f->count[f->list[k].fault]++;
	}
	f->n = n;
}

static enum ts_status examine(struct examination *d, uint8_t *side, int32_t *queue)
{
	for (size_t t = 0; t < d->m->n; t++)
		TS_TRY(examine_shape(d, (int32_t)t));
	TS_TRY(examine_duplicates(d));
	TS_TRY(examine_edges(d));
	TS_TRY(examine_orientation(d, side, queue));
	return ts_mesh_cracks(d->m, d->edge, d->nedges, add_crack, d);
}

enum ts_status ts_mesh_examine(const struct ts_mesh *mesh, double curvature, struct ts_mesh_findings *out)
{
	struct examination d = { .m = mesh, .curvature = curvature, .out = out };
	uint8_t *side = ts_alloc(mesh->n, 1);
	int32_t *queue = ts_alloc(mesh->n, sizeof *queue);
	enum ts_status status = TS_NOMEM;

	ts_mesh_findings_release(out);
	d.excluded = ts_alloc(mesh->n, 1);
	d.neighbours = ts_alloc(mesh->n, sizeof *d.neighbours);
	if (side && queue && d.excluded && d.neighbours)
		status = examine(&d, side, queue);
	sort_findings(out);
	ts_free(side);
	ts_free(queue);
	ts_free(d.excluded);
	ts_free(d.neighbours);
	ts_free(d.edge);
	return status;
}

void ts_mesh_findings_release(struct ts_mesh_findings *findings)
{
	ts_free(findings->list);
	*findings = (struct ts_mesh_findings){ 0 };
}

/* Relative to the first corner, to avoid cancellation far from the origin. */
double ts_mesh_volume(const struct ts_mesh *m)
{
	double sum = 0;

	for (size_t t = 0; t < m->n; t++) {
		double a[3];

		ts_sub(m->x[t][0], m->x[0][0], a);
		sum += ts_dot(a, m->normal[t]) * m->area[t];
	}
	return sum / 3;
}
