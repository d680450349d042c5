#include "mesh/mesh_pierce.h"

#include <math.h>

#include "base/alloc.h"
#include "math/vec3.h"
#include "mesh/mesh_tree.h"

#include "base/banned.h"

static const double SHALLOW = 1e-9; /* of the length of the edge */

/* Whether the line from p to q passes through the inside of the triangle. */
static bool passes_through(const double p[3], const double q[3], const double x[3][3])
{
	double e[2][3], normal[3], arm[3], at[3], height[2], least;

	ts_sub(x[1], x[0], e[0]);
	ts_sub(x[2], x[0], e[1]);
	ts_cross(e[0], e[1], normal);
	ts_sub(p, x[0], arm);
	height[0] = ts_dot(arm, normal);
	ts_sub(q, x[0], arm);
	height[1] = ts_dot(arm, normal);
	least = SHALLOW * sqrt(ts_distance2(p, q)) * ts_norm(normal);
	if (!(height[0] * height[1] < 0) || !(fmin(fabs(height[0]), fabs(height[1])) > least))
		return false;
	ts_sub(q, p, arm);
	ts_scale(1, p, at);
	ts_axpy(height[0] / (height[0] - height[1]), arm, at);
	for (int k = 0; k < 3; k++) {
		double across[3];

		ts_sub(x[(k + 1) % 3], x[k], e[0]);
		ts_sub(at, x[k], e[1]);
		ts_cross(e[0], e[1], across);
		if (!(ts_dot(across, normal) > SHALLOW * ts_dot(normal, normal)))
			return false;
	}
	return true;
}

static bool has_vertex(const struct ts_mesh *m, size_t t, int32_t v)
{
	return m->vertex[t][0] == v || m->vertex[t][1] == v || m->vertex[t][2] == v;
}

/* Whether an edge of a that does not end on b passes through b. */
static bool edges_pass(const struct ts_mesh *m, const double (*x)[3][3], size_t a, size_t b)
{
	for (int k = 0; k < 3; k++) {
		int next = (k + 1) % 3;

		if (!has_vertex(m, b, m->vertex[a][k]) && !has_vertex(m, b, m->vertex[a][next]) &&
		    passes_through(x[a][k], x[a][next], x[b]))
			return true;
	}
	return false;
}

static bool intersect(const struct ts_mesh *m, const double (*x)[3][3], size_t a, size_t b)
{
	return edges_pass(m, x, a, b) || edges_pass(m, x, b, a);
}

static int count_shared(const struct ts_mesh *m, size_t a, size_t b)
{
	int n = 0;

	for (int k = 0; k < 3; k++)
		n += has_vertex(m, b, m->vertex[a][k]);
	return n;
}

struct search {
	const struct ts_mesh *m; /* at the new positions */
	const double (*from)[3][3], (*to)[3][3];
	const uint8_t *moved;
	struct ts_mesh_tree tree;
	struct ts_mesh_list list;
};

static enum ts_status search_around(struct search *s, size_t t, bool *found, size_t *other)
{
	double lo[3] = { INFINITY, INFINITY, INFINITY }, hi[3] = { -INFINITY, -INFINITY, -INFINITY };

	for (int k = 0; k < 9; k++) {
		lo[k % 3] = fmin(lo[k % 3], s->to[t][k / 3][k % 3]);
		hi[k % 3] = fmax(hi[k % 3], s->to[t][k / 3][k % 3]);
	}
	s->list.n = 0;
	TS_TRY(ts_mesh_tree_within(&s->tree, s->m, lo, hi, &s->list));
	for (size_t k = 0; k < s->list.n && !*found; k++) {
		*other = (size_t)s->list.item[k];
		*found = *other != t && !ts_mesh_is_removed(s->m, *other) &&
			 (!s->moved[*other] || *other > t) && count_shared(s->m, t, *other) < 2 &&
			 intersect(s->m, s->to, t, *other) && !intersect(s->m, s->from, t, *other);
	}
	return TS_OK;
}

enum ts_status ts_mesh_pierce(const struct ts_mesh *mesh, const double (*from)[3][3],
			      const double (*to)[3][3], const uint8_t *moved, bool *found, size_t pair[2])
{
	struct ts_mesh now = *mesh; /* of which the tree uses corners and centres */
	struct search s = { .m = &now, .from = from, .to = to, .moved = moved };
	enum ts_status status;

	*found = false;
	now.x = ts_alloc(mesh->n, sizeof *now.x);
	now.centre = ts_alloc(mesh->n, sizeof *now.centre);
	status = now.x && now.centre ? TS_OK : TS_NOMEM;
	for (size_t c = 0; status == TS_OK && c < 9 * mesh->n; c++) {
		now.x[c / 9][c / 3 % 3][c % 3] = to[c / 9][c / 3 % 3][c % 3];
		now.centre[c / 9][c % 3] += to[c / 9][c / 3 % 3][c % 3] / 3;
	}
	if (status == TS_OK)
		status = ts_mesh_tree_build(&s.tree, &now);
	for (size_t t = 0; t < mesh->n && status == TS_OK && !*found; t++) {
		pair[0] = t;
		if (moved[t])
			status = search_around(&s, t, found, &pair[1]);
	}
	ts_mesh_tree_release(&s.tree);
	ts_free(s.list.item);
	ts_free(now.x);
	ts_free(now.centre);
	return status;
}
