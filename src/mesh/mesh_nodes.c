#include "mesh/mesh_nodes.h"

#include <math.h>

#include "base/alloc.h"
#include "math/vec3.h"

#include "base/banned.h"

/* Whether both triangles have edge k of t in the same direction, so that their normals are on opposite sides. Told by
 * the directions, too: in a small periodic mesh several edges have the same vertices. */
static bool same_direction(const struct ts_mesh *m, size_t t, int k, size_t other)
{
	double most = 0;

	for (int j = 0; j < 3; j++) {
		double along = ts_dot(m->along[t][k], m->along[other][j]);

		if (m->neighbour[other][j] == (int32_t)t && fabs(along) > fabs(most))
			most = along;
	}
	return most > 0;
}

struct flood {
	const struct ts_mesh *m;
	struct ts_mesh_nodes *nodes;
	int32_t *queue; /* [triangles] */
	size_t triangle;
};

/* Goes from triangle t of the queue to those that share an edge with it. */
static enum ts_mesh_nodes_fault flood_neighbours(struct flood *f, size_t t, size_t *n)
{
	struct ts_mesh_nodes *nodes = f->nodes;

	f->triangle = t;
	for (int k = 0; k < 3; k++) {
		int32_t other = f->m->neighbour[t][k];
		int side;

		if (other == TS_MESH_MANY)
			return TS_MESH_NODES_BRANCHED;
		if (other < 0 || (size_t)other == t)
			continue;
		side = same_direction(f->m, t, k, (size_t)other) ? -nodes->side[t] : nodes->side[t];
		if (nodes->side[other] && nodes->side[other] != side)
			return TS_MESH_NODES_ONE_SIDED;
		if (nodes->side[other])
			continue;
		nodes->side[other] = (int8_t)side;
		nodes->part[other] = nodes->parts;
		f->queue[(*n)++] = other;
	}
	return TS_MESH_NODES_FINE;
}

static enum ts_mesh_nodes_fault flood_part(struct flood *f, size_t first)
{
	size_t n = 0;

	f->queue[n++] = (int32_t)first;
	f->nodes->side[first] = 1;
	f->nodes->part[first] = f->nodes->parts;
	for (size_t at = 0; at < n; at++) {
		enum ts_mesh_nodes_fault fault = flood_neighbours(f, (size_t)f->queue[at], &n);

		if (fault)
			return fault;
	}
	f->nodes->parts++;
	return TS_MESH_NODES_FINE;
}

static void list_corners(const struct ts_mesh *m, struct ts_mesh_nodes *nodes)
{
	uint32_t *start = nodes->start;

	for (size_t c = 0; c < 3 * m->n; c++)
		start[m->vertex[c / 3][c % 3] + 2]++;
	for (size_t v = 2; v < nodes->n + 2; v++)
		start[v] += start[v - 1];
	for (size_t c = 0; c < 3 * m->n; c++)
		nodes->corner[start[m->vertex[c / 3][c % 3] + 1]++] = (int32_t)c;
}

static enum ts_mesh_nodes_fault check_vertices(struct flood *f)
{
	const struct ts_mesh_nodes *nodes = f->nodes;

	for (size_t v = 0; v < nodes->n; v++)
		for (uint32_t k = nodes->start[v]; k < nodes->start[v + 1]; k++) {
			f->triangle = (size_t)nodes->corner[k] / 3;
			if (nodes->part[f->triangle] != nodes->part[nodes->corner[nodes->start[v]] / 3])
				return TS_MESH_NODES_PINCHED;
		}
	return TS_MESH_NODES_FINE;
}

enum ts_status ts_mesh_nodes_build(struct ts_mesh_nodes *nodes, const struct ts_mesh *m,
				   enum ts_mesh_nodes_fault *fault, size_t *triangle)
{
	struct flood f = { m, nodes, ts_alloc(m->n, sizeof *f.queue), 0 };

	*nodes = (struct ts_mesh_nodes){ .n = m->nvertices };
	*fault = TS_MESH_NODES_FINE;
	nodes->start = ts_alloc(m->nvertices + 2, sizeof *nodes->start);
	nodes->corner = ts_alloc(3 * m->n, sizeof *nodes->corner);
	nodes->side = ts_alloc(m->n, sizeof *nodes->side);
	nodes->part = ts_alloc(m->n, sizeof *nodes->part);
	if (!f.queue || !nodes->start || !nodes->corner || !nodes->side || !nodes->part) {
		ts_free(f.queue);
		ts_mesh_nodes_release(nodes);
		return TS_NOMEM;
	}
	for (size_t t = 0; t < m->n && !*fault; t++)
		if (!nodes->side[t])
			*fault = flood_part(&f, t);
	list_corners(m, nodes);
	if (!*fault)
		*fault = check_vertices(&f);
	*triangle = f.triangle;
	ts_free(f.queue);
	if (*fault)
		ts_mesh_nodes_release(nodes);
	return TS_OK;
}

void ts_mesh_nodes_release(struct ts_mesh_nodes *nodes)
{
	ts_free(nodes->start);
	ts_free(nodes->corner);
	ts_free(nodes->side);
	ts_free(nodes->part);
	*nodes = (struct ts_mesh_nodes){ 0 };
}
