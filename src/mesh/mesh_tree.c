#include "mesh/mesh_tree.h"

#include <math.h>
#include <stdlib.h>

#include "base/alloc.h"
#include "base/sort.h"
#include "math/vec3.h"

#include "base/banned.h"

enum { LEAF = 4, BITS = 21 };

struct curve_point {
	uint64_t code;
	int32_t triangle;
};

static int by_code(const void *a, const void *b)
{
	const struct curve_point *p = a, *q = b;

	if (p->code != q->code)
		return p->code < q->code ? -1 : 1;
	return (p->triangle > q->triangle) - (p->triangle < q->triangle);
}

/* Morton code: the interleaved bits of the three coordinates. */
static uint64_t morton(const double x[3], const double lo[3], const double hi[3])
{
	uint64_t code = 0, cell[3];

	for (int d = 0; d < 3; d++) {
		double part = hi[d] > lo[d] ? (x[d] - lo[d]) / (hi[d] - lo[d]) : 0;

		cell[d] = (uint64_t)(fmax(0, fmin(1, part)) * ((1 << BITS) - 1));
	}
	for (int b = BITS - 1; b >= 0; b--)
		for (int d = 0; d < 3; d++)
			code = code << 1 | (cell[d] >> b & 1);
	return code;
}

static enum ts_status sort_along_curve(struct ts_mesh_tree *tree, const struct ts_mesh *m)
{
	struct curve_point *list = ts_alloc(m->n, sizeof *list);
	double lo[3], hi[3];

	if (!list)
		return TS_NOMEM;
	ts_mesh_bounds(m, lo, hi);
	for (size_t t = 0; t < m->n; t++)
		list[t] = (struct curve_point){ morton(m->centre[t], lo, hi), (int32_t)t };
	ts_sort(list, m->n, sizeof *list, by_code);
	for (size_t t = 0; t < m->n; t++)
		tree->triangle[t] = list[t].triangle;
	ts_free(list);
	return TS_OK;
}

static void extend_box(const struct ts_mesh *m, size_t t, double lo[3], double hi[3])
{
	for (int k = 0; k < 3; k++) {
		for (int d = 0; d < 3; d++) {
			double x = m->x[t][k][d];

			lo[d] = x < lo[d] ? x : lo[d];
			hi[d] = x > hi[d] ? x : hi[d];
		}
	}
}

static void compute_boxes(struct ts_mesh_tree *tree, const struct ts_mesh *m)
{
	for (size_t k = 2 * tree->leaves; k-- > 1;) {
		for (int d = 0; d < 3; d++) {
			tree->lo[k][d] = k < tree->leaves ? fmin(tree->lo[2 * k][d], tree->lo[2 * k + 1][d])
							  : INFINITY;
			tree->hi[k][d] = k < tree->leaves ? fmax(tree->hi[2 * k][d], tree->hi[2 * k + 1][d])
							  : -INFINITY;
		}
		for (size_t j = 0; k >= tree->leaves && j < LEAF; j++) {
			size_t at = (k - tree->leaves) * LEAF + j;

			if (at < tree->n)
				extend_box(m, (size_t)tree->triangle[at], tree->lo[k], tree->hi[k]);
		}
	}
}

enum ts_status ts_mesh_tree_build(struct ts_mesh_tree *tree, const struct ts_mesh *m)
{
	*tree = (struct ts_mesh_tree){ .n = m->n, .leaves = 1 };
	while (tree->leaves * LEAF < m->n)
		tree->leaves *= 2;
	tree->triangle = ts_alloc(m->n, sizeof *tree->triangle);
	tree->lo = ts_alloc(2 * tree->leaves, sizeof *tree->lo);
	tree->hi = ts_alloc(2 * tree->leaves, sizeof *tree->hi);
	if (!tree->triangle || !tree->lo || !tree->hi || sort_along_curve(tree, m) != TS_OK) {
		ts_mesh_tree_release(tree);
		return TS_NOMEM;
	}
	compute_boxes(tree, m);
	return TS_OK;
}

void ts_mesh_tree_release(struct ts_mesh_tree *tree)
{
	ts_free(tree->triangle);
	ts_free(tree->lo);
	ts_free(tree->hi);
	*tree = (struct ts_mesh_tree){ 0 };
}

static bool is_outside_box(const double lo[3], const double hi[3], const double x[3], double distance)
{
	bool is = false;

	for (int d = 0; d < 3; d++)
		is |= !(lo[d] - distance <= x[d] && x[d] <= hi[d] + distance);
	return is;
}

/* Whether neither the bounding box nor the plane of the triangle is farther from x than `distance`. */
static bool may_be_near(const struct ts_mesh *m, size_t t, const double x[3], double distance)
{
	double lo[3] = { INFINITY, INFINITY, INFINITY }, hi[3] = { -INFINITY, -INFINITY, -INFINITY };
	double arm[3];

	ts_sub(x, m->x[t][0], arm);
	if (!(fabs(ts_dot(arm, m->normal[t])) <= distance * (1 + 1e-9)))
		return false;
	extend_box(m, t, lo, hi);
	return !is_outside_box(lo, hi, x, distance);
}

static enum ts_status collect_leaf(const struct ts_mesh_tree *tree, const struct ts_mesh *m, size_t leaf,
				   const double x[3], double distance, struct ts_mesh_list *list)
{
	for (size_t at = leaf * LEAF; at < tree->n && at < (leaf + 1) * LEAF; at++) {
		if (!may_be_near(m, (size_t)tree->triangle[at], x, distance))
			continue;
		TS_TRY(TS_GROW(list->item, list->capacity, list->n + 1));
		list->item[list->n++] = tree->triangle[at];
	}
	return TS_OK;
}

static int by_index(const void *a, const void *b)
{
	const int32_t *p = a, *q = b;

	return (*p > *q) - (*p < *q);
}

/* Whether the box lo .. hi is farther than `distance` from the box from .. to. */
static bool are_boxes_apart(const double lo[3], const double hi[3], const double from[3], const double to[3],
			    double distance)
{
	bool are = false;

	for (int d = 0; d < 3; d++)
		are |= !(lo[d] - distance <= to[d] && from[d] <= hi[d] + distance);
	return are;
}

enum ts_status ts_mesh_tree_near(const struct ts_mesh_tree *tree, const struct ts_mesh *m, const double x[3],
				 double distance, struct ts_mesh_list *list)
{
	size_t stack[TS_MESH_TREE_STACK], depth = 0;

	list->n = 0;
	if (tree->n)
		stack[depth++] = 1;
	while (depth > 0) {
		size_t k = stack[--depth];

		if (is_outside_box(tree->lo[k], tree->hi[k], x, distance))
			continue;
		if (k >= tree->leaves) {
			TS_TRY(collect_leaf(tree, m, k - tree->leaves, x, distance, list));
		} else {
			stack[depth++] = 2 * k;
			stack[depth++] = 2 * k + 1;
		}
	}
	ts_sort(list->item, list->n, sizeof *list->item, by_index);
	return TS_OK;
}

static double distance_from_box(const double lo[3], const double hi[3], const double x[3])
{
	double off[3];

	for (int d = 0; d < 3; d++)
		off[d] = fmax(0, fmax(lo[d] - x[d], x[d] - hi[d]));
	return ts_norm(off);
}

static double distance_from_node(const struct ts_mesh_descent *d, size_t k)
{
	return distance_from_box(d->tree->lo[k], d->tree->hi[k], d->x);
}

void ts_mesh_tree_descend(struct ts_mesh_descent *d, const struct ts_mesh_tree *tree, const double x[3])
{
	*d = (struct ts_mesh_descent){ .tree = tree, .x = x };
	if (tree->n)
		d->stack[d->depth++] = 1;
}

bool ts_mesh_tree_next(struct ts_mesh_descent *d, double least, size_t *t)
{
	while (d->at == d->end) {
		size_t k, far;

		if (!d->depth)
			return false;
		k = d->stack[--d->depth];
		if (distance_from_node(d, k) > least)
			continue;
		if (k >= d->tree->leaves) {
			d->at = (k - d->tree->leaves) * LEAF;
			d->end = d->at + LEAF < d->tree->n ? d->at + LEAF : d->tree->n;
			d->at = d->at < d->end ? d->at : d->end;
			continue;
		}
		far = distance_from_node(d, 2 * k) > distance_from_node(d, 2 * k + 1) ? 2 * k : 2 * k + 1;
		d->stack[d->depth++] = far;
		d->stack[d->depth++] = far ^ 1;
	}
	*t = (size_t)d->tree->triangle[d->at++];
	return true;
}

static enum ts_status collect_within(const struct ts_mesh_tree *tree, const struct ts_mesh *m, size_t leaf,
				     const double from[3], const double to[3], struct ts_mesh_list *list)
{
	for (size_t at = leaf * LEAF; at < tree->n && at < (leaf + 1) * LEAF; at++) {
		double lo[3] = { INFINITY, INFINITY, INFINITY }, hi[3] = { -INFINITY, -INFINITY, -INFINITY };

		extend_box(m, (size_t)tree->triangle[at], lo, hi);
		if (are_boxes_apart(lo, hi, from, to, 0))
			continue;
		TS_TRY(TS_GROW(list->item, list->capacity, list->n + 1));
		list->item[list->n++] = tree->triangle[at];
	}
	return TS_OK;
}

enum ts_status ts_mesh_tree_within(const struct ts_mesh_tree *tree, const struct ts_mesh *m,
				   const double lo[3], const double hi[3], struct ts_mesh_list *list)
{
	size_t stack[TS_MESH_TREE_STACK], depth = 0;

	list->n = 0;
	if (tree->n)
		stack[depth++] = 1;
	while (depth > 0) {
		size_t k = stack[--depth];

		if (are_boxes_apart(tree->lo[k], tree->hi[k], lo, hi, 0))
			continue;
		if (k >= tree->leaves) {
			TS_TRY(collect_within(tree, m, k - tree->leaves, lo, hi, list));
		} else {
			stack[depth++] = 2 * k;
			stack[depth++] = 2 * k + 1;
		}
	}
	ts_sort(list->item, list->n, sizeof *list->item, by_index);
	return TS_OK;
}
