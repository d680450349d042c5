#include "base/clones.h"
TS_UNROLLED

#include "mesh/mesh.h"

#include <math.h>

#include "base/alloc.h"
#include "base/four.h"
#include "math/constants.h"
#include "math/vec3.h"
#include "mesh/mesh_links.h"

#include "base/banned.h"

static enum ts_status allocate_arrays(struct ts_mesh *m)
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
	return m->x && m->normal && m->along && m->length && m->area && m->centre && m->reach && m->vertex &&
			       m->neighbour && m->active
		       ? TS_OK
		       : TS_NOMEM;
}

enum ts_status ts_mesh_build(struct ts_mesh *m, const double (*soup)[3][3], size_t n, double precision,
			     double curvature)
{
	enum ts_status status = TS_RANGE;

	*m = (struct ts_mesh){ .n = n, .flat = cos(curvature * TS_PI / 180) };
	if (n <= INT32_MAX / 64)
		status = allocate_arrays(m);
	if (status == TS_OK) {
		for (size_t t = 0; t < n; t++)
			for (int k = 0; k < 9; k++)
				m->x[t][k / 3][k % 3] = soup[t][k / 3][k % 3];
		ts_mesh_update_geometry(m);
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

/* The edges of a triangle as unit vectors, and their lengths. */
TS_INLINE void unit_edges(const double x[9], double along[9], double length[3])
{
	for (int k = 0; k < 3; k++) {
		ts_sub(x + 3 * ((k + 1) % 3), x + 3 * k, along + 3 * k);
		length[k] = ts_norm(along + 3 * k);
		ts_scale(length[k] > 0 ? 1 / length[k] : 1, along + 3 * k, along + 3 * k);
	}
}

TS_INLINE double bounding_radius(const double x[9], const double centre[3])
{
	double most = 0;

	for (int k = 0; k < 3; k++) {
		double far = sqrt(ts_distance2(x + 3 * k, centre));

		most = far > most ? far : most;
	}
	return most;
}

/* Geometry of a batch of triangles, in columns. */
struct triangle_batch {
	double x[9][TS_BATCH], along[9][TS_BATCH], length[3][TS_BATCH], normal[3][TS_BATCH],
		centre[3][TS_BATCH];
	double area[TS_BATCH], reach[TS_BATCH];
};

/* Without branches, so that the loop over triangles is vectorised. */
TS_INLINE void update_triangle(struct triangle_batch *c, size_t t)
{
	double x[9], along[9], length[3], centre[3], cross[3], twice;

	for (int k = 0; k < 9; k++)
		x[k] = c->x[k][t];
	for (int k = 0; k < 3; k++)
		centre[k] = (x[k] + x[3 + k] + x[6 + k]) / 3;
	unit_edges(x, along, length);
	ts_cross(along, along + 3, cross);
	twice = ts_norm(cross);
	c->area[t] = 0.5 * twice * length[0] * length[1];
	c->reach[t] = bounding_radius(x, centre);
	ts_scale(twice > 0 ? 1 / twice : 0, cross, cross);
	for (int k = 0; k < 9; k++)
		c->along[k][t] = along[k];
	for (int k = 0; k < 3; k++) {
		c->centre[k][t] = centre[k];
		c->length[k][t] = length[k];
		c->normal[k][t] = cross[k];
	}
}

/* Updates triangles t .. t+n-1; the batch is padded to whole vectors with copies of triangle t. */
TS_CLONES static void update_batch(struct ts_mesh *m, size_t t, size_t n)
{
	size_t whole = (n + 7) & ~(size_t)7;
	struct triangle_batch c;

	for (size_t j = 0; j < whole; j++)
		for (size_t k = 0; k < 9; k++)
			c.x[k][j] = m->x[t + (j < n ? j : 0)][k / 3][k % 3];
#pragma omp simd
	for (size_t j = 0; j < whole; j++)
		update_triangle(&c, j);
	for (size_t j = 0; j < n; j++) {
		m->area[t + j] = c.area[j];
		m->reach[t + j] = c.reach[j];
		for (size_t k = 0; k < 9; k++)
			m->along[t + j][k / 3][k % 3] = c.along[k][j];
		for (size_t k = 0; k < 3; k++) {
			m->centre[t + j][k] = c.centre[k][j];
			m->length[t + j][k] = c.length[k][j];
			m->normal[t + j][k] = c.normal[k][j];
		}
	}
}

void ts_mesh_update_triangles(struct ts_mesh *m, size_t from, size_t to)
{
	for (; from < to; from += TS_BATCH)
		update_batch(m, from, to - from < TS_BATCH ? to - from : TS_BATCH);
}

void ts_mesh_update_geometry(struct ts_mesh *m)
{
	ts_mesh_update_triangles(m, 0, m->n);
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

/* The surface is not flat at an active edge that has a neighbour. */
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
