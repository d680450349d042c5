#include "mesh/mesh_sweep.h"

#include <math.h>

#include "math/vec3.h"
#include "mesh/mesh_touch.h"

#include "base/banned.h"

/* Times nearer to each other than this part of the span are the same. */
static const double SAME_TIME = 1e-12;

static void take_earlier(const struct ts_sweep *path, const struct ts_sweep_hit *hit, size_t t, int part,
			 bool *found, struct ts_mesh_hit *best)
{
	double later = hit->time - best->hit.time, same = SAME_TIME * path->span;

	if (*found && !(later < -same) && !(later < same && part < best->part))
		return;
	*found = true;
	*best = (struct ts_mesh_hit){ *hit, (int32_t)t, part };
}

static bool touches_face(const struct ts_mesh *m, size_t t, const struct ts_sweep *path,
			 struct ts_sweep_hit *hit)
{
	struct ts_mesh_contact_point at;
	double x[3];

	if (!(m->area[t] > 0) || !ts_sweep_plane(path, m->x[t][0], m->normal[t], hit))
		return false;
	ts_scale(1, path->x, x);
	ts_axpy(hit->time, path->v, x);
	return ts_mesh_nearest(m, t, x, &at) == TS_MESH_FACE;
}

/* An edge that is active in another triangle is left to that one. */
static bool owns_edge(const struct ts_mesh *m, size_t t, int k)
{
	int32_t other = m->neighbour[t][k];

	return ts_mesh_edge_active(m, t, k) || other == -1 ||
	       (other >= 0 && ts_mesh_flat_neighbours(m, t, (size_t)other));
}

static void sweep_triangle(const struct ts_mesh *m, size_t t, const struct ts_sweep *path, bool *found,
			   struct ts_mesh_hit *best)
{
	struct ts_sweep_hit hit;

	if (ts_mesh_is_removed(m, t))
		return;
	if (touches_face(m, t, path, &hit))
		take_earlier(path, &hit, t, TS_MESH_FACE, found, best);
	for (int k = 0; k < 3; k++) {
		if (owns_edge(m, t, k) &&
		    ts_sweep_line(path, m->x[t][k], m->along[t][k], m->length[t][k], &hit))
			take_earlier(path, &hit, t, TS_MESH_EDGE, found, best);
		if (ts_sweep_point(path, m->x[t][k], &hit))
			take_earlier(path, &hit, t, TS_MESH_CORNER, found, best);
	}
}

enum ts_status ts_mesh_sweep(const struct ts_mesh *mesh, const struct ts_mesh_tree *tree,
			     const struct ts_sweep *path, struct ts_mesh_list *list, bool *found,
			     struct ts_mesh_hit *out)
{
	double lo[3], hi[3];

	*found = false;
	for (int d = 0; d < 3; d++) {
		double end = path->x[d] + path->span * path->v[d], r = path->radius * (1 + 1e-9);

		lo[d] = fmin(path->x[d], end) - r;
		hi[d] = fmax(path->x[d], end) + r;
	}
	TS_TRY(ts_mesh_tree_within(tree, mesh, lo, hi, list));
	for (size_t k = 0; k < list->n; k++)
		sweep_triangle(mesh, (size_t)list->item[k], path, found, out);
	return TS_OK;
}
