#include "geom/mesh.h"

#include <math.h>

#include "base/alloc.h"
#include "geom/mesh_links.h"
#include "math/vec3.h"

#include "base/banned.h"

static enum ts_status reserve(struct ts_mesh *m)
{
	size_t n = m->n;

	m->x = ts_alloc(n, sizeof *m->x);
	m->normal = ts_alloc(n, sizeof *m->normal);
	m->along = ts_alloc(n, sizeof *m->along);
	m->length = ts_alloc(n, sizeof *m->length);
	m->area = ts_alloc(n, sizeof *m->area);
	m->centre = ts_alloc(n, sizeof *m->centre);
	m->reach = ts_alloc(n, sizeof *m->reach);
	m->vertex = ts_alloc(n, sizeof *m->vertex);
	m->neighbour = ts_alloc(n, sizeof *m->neighbour);
	m->active = ts_alloc(n, sizeof *m->active);
	return m->x && m->normal && m->along && m->length && m->area && m->centre && m->reach &&
			       m->vertex && m->neighbour && m->active
		       ? TS_OK
		       : TS_NOMEM;
}

enum ts_status ts_mesh_build(struct ts_mesh *m, const double (*soup)[3][3], size_t n,
			     double precision, double curvature)
{
	enum ts_status status = TS_RANGE;

	*m = (struct ts_mesh){ .n = n, .flat = cos(curvature * TS_MESH_PI / 180) };
	if (n <= INT32_MAX / 64)
		status = reserve(m);
	if (status == TS_OK) {
		for (size_t t = 0; t < n; t++)
			for (int k = 0; k < 9; k++)
				m->x[t][k / 3][k % 3] = soup[t][k / 3][k % 3];
		ts_mesh_moved(m);
		status = ts_mesh_link(m, precision, NULL);
	}
	if (status != TS_OK)
		ts_mesh_release(m);
	return status;
}

enum ts_status ts_mesh_link_images(struct ts_mesh *m, const struct ts_box *box, double precision)
{
	bool any = false;

	for (int d = 0; d < 3; d++)
		any |= ts_box_periodic(box, d);
	return any ? ts_mesh_link(m, precision, box) : TS_OK;
}

void ts_mesh_release(struct ts_mesh *m)
{
	ts_free(m->x);
	ts_free(m->normal);
	ts_free(m->along);
	ts_free(m->length);
	ts_free(m->area);
	ts_free(m->centre);
	ts_free(m->reach);
	ts_free(m->vertex);
	ts_free(m->neighbour);
	ts_free(m->active);
	*m = (struct ts_mesh){ 0 };
}

void ts_mesh_triangle_moved(struct ts_mesh *m, size_t t)
{
	double(*x)[3] = m->x[t];
	double cross[3], twice;

	m->reach[t] = 0;
	for (int k = 0; k < 3; k++) {
		double *along = m->along[t][k];

		m->centre[t][k] = (x[0][k] + x[1][k] + x[2][k]) / 3;
		ts_sub(x[(k + 1) % 3], x[k], along);
		m->length[t][k] = ts_norm(along);
		if (m->length[t][k] > 0)
			ts_scale(1 / m->length[t][k], along, along);
	}
	for (int k = 0; k < 3; k++)
		m->reach[t] = fmax(m->reach[t], sqrt(ts_distance2(x[k], m->centre[t])));
	ts_cross(m->along[t][0], m->along[t][1], cross);
	twice = ts_norm(cross);
	m->area[t] = 0.5 * twice * m->length[t][0] * m->length[t][1];
	ts_scale(twice > 0 ? 1 / twice : 0, cross, m->normal[t]);
}

void ts_mesh_moved(struct ts_mesh *m)
{
	for (size_t t = 0; t < m->n; t++)
		ts_mesh_triangle_moved(m, t);
}

bool ts_mesh_flat_neighbours(const struct ts_mesh *m, size_t a, size_t b)
{
	bool share = false;

	for (int k = 0; k < 9; k++)
		share |= m->vertex[a][k / 3] == m->vertex[b][k % 3];
	return share && fabs(ts_dot(m->normal[a], m->normal[b])) > m->flat;
}

void ts_mesh_bounds(const struct ts_mesh *m, double lo[3], double hi[3])
{
	for (int d = 0; d < 3; d++) {
		lo[d] = INFINITY;
		hi[d] = -INFINITY;
	}
	for (size_t t = 0; t < m->n; t++) {
		for (int k = 0; k < 9; k++) {
			lo[k % 3] = fmin(lo[k % 3], m->x[t][k / 3][k % 3]);
			hi[k % 3] = fmax(hi[k % 3], m->x[t][k / 3][k % 3]);
		}
	}
}

double ts_mesh_area(const struct ts_mesh *m)
{
	double sum = 0;

	for (size_t t = 0; t < m->n; t++)
		sum += m->area[t];
	return sum;
}

/* Where it bends an edge acts in contacts, though it is no rim. */
bool ts_mesh_planar(const struct ts_mesh *m, size_t *corner)
{
	for (*corner = 0; *corner < 3 * m->n; ++*corner) {
		size_t t = *corner / 3;
		int k = (int)(*corner % 3);

		if (m->neighbour[t][k] == TS_MESH_MANY ||
		    (m->neighbour[t][k] >= 0 && ts_mesh_edge_active(m, t, k)))
			return false;
	}
	return true;
}
