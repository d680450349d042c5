#include "mesh/mesh_recession.h"

#include <math.h>

#include "base/alloc.h"
#include "math/constants.h"
#include "math/vec3.h"
#include "mesh/mesh_doctor.h"
#include "mesh/mesh_pierce.h"

#include "base/banned.h"

#define RECESSION_TEXT(name, what) what,
const char *const ts_mesh_recession_texts[] = { TS_MESH_RECESSION_LIST(RECESSION_TEXT) };

/* |sum of area vectors| / sum of areas around a node below which its normal is not defined */
static const double LEAST_AREA = 1e-3;
/* n_v . A_v, relative to that before the motion, below which the node has gone too far */
static const double LEAST_FACING = 0.05;
/* relative change of all h_v at which the iteration ends; what is left is measured and returned in `swept` */
static const double CONVERGED = 1e-14;
enum { MOST_SWEEPS = 200 };

struct recession {
	const struct ts_mesh *m;
	const struct ts_mesh_nodes *nodes;
	const double (*from)[3][3];
	const double *volume;
	double (*to)[3][3];
	double *swept;
	struct ts_mesh_recession_finding *finding;
	double (*normal)[3]; /* [nodes] unit vectors */
	double *area;	     /* [nodes] |A_v| before */
	double *depth;	     /* [nodes] h_v */
	uint8_t *moved;	     /* [triangles] whether a corner moves */
};

static bool refuse(struct recession *r, enum ts_mesh_recession_fault fault, size_t triangle, size_t other)
{
	*r->finding = (struct ts_mesh_recession_finding){ fault, triangle, other };
	return false;
}

/* int_0^1 a(s) ds of a triangle whose corners x move by d. */
static void mean_area(const double x[3][3], const double d[3][3], double out[3])
{
	double e[2][3], f[2][3], c[4][3];

	for (int k = 0; k < 2; k++) {
		ts_sub(x[k + 1], x[0], e[k]);
		ts_sub(d[k + 1], d[0], f[k]);
	}
	ts_cross(e[0], e[1], c[0]);
	ts_cross(e[0], f[1], c[1]);
	ts_cross(f[0], e[1], c[2]);
	ts_cross(f[0], f[1], c[3]);
	for (int i = 0; i < 3; i++)
		out[i] = (c[0][i] + (c[1][i] + c[2][i]) / 2 + c[3][i] / 3) / 2;
}

/* Normal and area of node v, from the positions before; false: they cancel. */
static bool find_normal(struct recession *r, size_t v)
{
	static const double rest[3][3] = { { 0 } };
	const struct ts_mesh_nodes *nodes = r->nodes;
	double sum[3] = { 0 }, all = 0;

	for (uint32_t k = nodes->start[v]; k < nodes->start[v + 1]; k++) {
		size_t t = (size_t)nodes->corner[k] / 3;
		double a[3];

		if (ts_mesh_is_removed(r->m, t))
			continue;
		mean_area(r->from[t], rest, a);
		ts_axpy(nodes->side[t] / 3.0, a, sum);
		all += ts_norm(a) / 3;
		r->moved[t] = 1;
	}
	r->area[v] = ts_norm(sum);
	if (!(r->area[v] > LEAST_AREA * all))
		return refuse(r, TS_MESH_RECESSION_NO_NORMAL, (size_t)nodes->corner[nodes->start[v]] / 3, 0);
	ts_scale(1 / r->area[v], sum, r->normal[v]);
	return true;
}

/* n_v . A_v with the present depths. */
static double facing_area(const struct recession *r, size_t v)
{
	const struct ts_mesh_nodes *nodes = r->nodes;
	double sum = 0;

	for (uint32_t k = nodes->start[v]; k < nodes->start[v + 1]; k++) {
		size_t t = (size_t)nodes->corner[k] / 3;
		double d[3][3], a[3];

		if (ts_mesh_is_removed(r->m, t))
			continue;
		for (int c = 0; c < 3; c++) {
			size_t node = (size_t)r->m->vertex[t][c];

			ts_scale(-r->depth[node], r->normal[node], d[c]);
		}
		mean_area(r->from[t], (const double(*)[3])d, a);
		sum += nodes->side[t] * ts_dot(r->normal[v], a) / 3;
	}
	return sum;
}

static bool moves(const struct recession *r, size_t v)
{
	return r->volume[v] < 0 || r->volume[v] > 0;
}

/* One sweep over the nodes; *change: of the depths, relative. */
static bool improve_depths(struct recession *r, double *change)
{
	*change = 0;
	for (size_t v = 0; v < r->nodes->n; v++) {
		double area, depth;

		if (!moves(r, v))
			continue;
		area = facing_area(r, v);
		if (!(area > LEAST_FACING * r->area[v]))
			return refuse(r, TS_MESH_RECESSION_TOO_FAR,
				      (size_t)r->nodes->corner[r->nodes->start[v]] / 3, 0);
		depth = r->volume[v] / area;
		*change = fmax(*change, fabs(depth - r->depth[v]) / fabs(depth));
		r->depth[v] = depth;
	}
	return true;
}

static bool find_depths(struct recession *r)
{
	double change = INFINITY;

	for (size_t v = 0; v < r->nodes->n; v++)
		if (moves(r, v) && !find_normal(r, v))
			return false;
	for (int sweep = 0; sweep < MOST_SWEEPS && change > CONVERGED; sweep++)
		if (!improve_depths(r, &change))
			return false;
	if (change < 1e-6) /* limited by rounding: what is left is measured */
		return true;
	for (size_t v = 0; v < r->nodes->n; v++)
		if (moves(r, v))
			return refuse(r, TS_MESH_RECESSION_TOO_FAR,
				      (size_t)r->nodes->corner[r->nodes->start[v]] / 3, 0);
	return true;
}

/* Moves the corners, and measures what they sweep. */
static void place_corners(struct recession *r)
{
	for (size_t v = 0; v < r->nodes->n; v++)
		r->swept[v] = 0;
	for (size_t t = 0; t < r->m->n; t++) {
		double d[3][3], a[3];

		for (int k = 0; k < 3; k++) {
			size_t v = (size_t)r->m->vertex[t][k];

			ts_scale(1, r->from[t][k], r->to[t][k]);
			if (moves(r, v))
				ts_axpy(-r->depth[v], r->normal[v], r->to[t][k]);
			ts_sub(r->to[t][k], r->from[t][k], d[k]);
		}
		if (!r->moved[t])
			continue;
		mean_area(r->from[t], (const double(*)[3])d, a);
		for (int k = 0; k < 3; k++)
			r->swept[r->m->vertex[t][k]] -= r->nodes->side[t] * ts_dot(d[k], a) / 3;
	}
}

/* ---- what is refused ---- */

static void double_area(const double x[3][3], double out[3])
{
	double e[2][3];

	ts_sub(x[1], x[0], e[0]);
	ts_sub(x[2], x[0], e[1]);
	ts_cross(e[0], e[1], out);
}

/* Whether the area vector keeps a component along that at the begin on the whole way: the quadratic p + q s + r s^2. */
static bool keeps_direction(const double from[3][3], const double to[3][3])
{
	double old[3], now[3], half[3], middle[3][3], p, q, r, end, at;

	for (int k = 0; k < 3; k++) {
		ts_add(from[k], to[k], middle[k]);
		ts_scale(0.5, middle[k], middle[k]);
	}
	double_area(from, old);
	double_area(to, now);
	double_area((const double(*)[3])middle, half);
	p = ts_dot(old, old);
	end = ts_dot(old, now);
	r = 2 * (end + p - 2 * ts_dot(old, half));
	q = end - p - r;
	at = r > 0 ? fmin(1, fmax(0, -q / (2 * r))) : 1;
	return end > 0 && p + at * (q + at * r) > 0;
}

/* The sine of the smallest angle: twice the area divided by the two longest edges. */
static bool is_needle(const double x[3][3])
{
	double area[3], length[3], shortest = INFINITY, product = 1;

	double_area(x, area);
	for (int k = 0; k < 3; k++) {
		length[k] = sqrt(ts_distance2(x[k], x[(k + 1) % 3]));
		shortest = fmin(shortest, length[k]);
		product *= length[k];
	}
	return !(ts_norm(area) * shortest > product * sin(TS_MESH_HARD_ANGLE * TS_PI / 180));
}

/* The angle by which the surface bends at edge k of t, -pi .. pi; at +-pi the neighbour lies on t. */
static double bend(const struct recession *r, const double (*x)[3][3], size_t t, int k)
{
	size_t other = (size_t)r->m->neighbour[t][k];
	double a[3], b[3], c[3], along[3];

	double_area(x[t], a);
	double_area(x[other], b);
	ts_sub(x[t][(k + 1) % 3], x[t][k], along);
	ts_scale(1 / ts_norm(along), along, along);
	ts_scale(r->nodes->side[t], a, a);
	ts_scale(r->nodes->side[other], b, b);
	ts_cross(a, b, c);
	return atan2(ts_dot(along, c), ts_dot(a, b));
}

/* A bend that jumps by more than pi has passed through the fold. */
static bool is_folded(const struct recession *r, size_t t, int k)
{
	double before = bend(r, r->from, t, k), after = bend(r, (const double(*)[3][3])r->to, t, k);
	double fold = TS_PI - acos(fmin(1, r->m->flat));

	return fabs(after - before) > TS_PI || (fabs(after) > fold && fabs(after) > fabs(before));
}

static bool check_triangle(struct recession *r, size_t t)
{
	const double(*to)[3] = (const double(*)[3])r->to[t];

	if (!keeps_direction(r->from[t], to))
		return refuse(r, TS_MESH_RECESSION_TURNED, t, 0);
	if (is_needle(to) && !is_needle(r->from[t]))
		return refuse(r, TS_MESH_RECESSION_NEEDLE, t, 0);
	for (int k = 0; k < 3; k++) {
		int32_t other = r->m->neighbour[t][k];

		if (other >= 0 && (size_t)other != t && !ts_mesh_is_removed(r->m, (size_t)other) &&
		    is_folded(r, t, k))
			return refuse(r, TS_MESH_RECESSION_FOLDED, t, (size_t)other);
	}
	return true;
}

static enum ts_status check_surface(struct recession *r)
{
	bool found;
	size_t pair[2];

	for (size_t t = 0; t < r->m->n; t++)
		if (r->moved[t] && !check_triangle(r, t))
			return TS_OK;
	TS_TRY(ts_mesh_pierce(r->m, r->from, (const double(*)[3][3])r->to, r->moved, &found, pair));
	if (found)
		refuse(r, TS_MESH_RECESSION_PIERCED, pair[0], pair[1]);
	return TS_OK;
}

static enum ts_status recede(struct recession *r)
{
	if (!find_depths(r))
		return TS_OK;
	place_corners(r);
	return check_surface(r);
}

enum ts_status ts_mesh_recession(const struct ts_mesh *mesh, const struct ts_mesh_nodes *nodes,
				 const double (*from)[3][3], const double *volume, double (*to)[3][3],
				 double *swept, struct ts_mesh_recession_finding *finding)
{
	struct recession r = { .m = mesh,
			       .nodes = nodes,
			       .from = from,
			       .volume = volume,
			       .to = to,
			       .swept = swept,
			       .finding = finding };
	enum ts_status status = TS_NOMEM;

	*finding = (struct ts_mesh_recession_finding){ .fault = TS_MESH_RECESSION_FINE };
	r.normal = ts_alloc(nodes->n, sizeof *r.normal);
	r.area = ts_alloc(nodes->n, sizeof *r.area);
	r.depth = ts_alloc(nodes->n, sizeof *r.depth);
	r.moved = ts_alloc(mesh->n, 1);
	if (r.normal && r.area && r.depth && r.moved)
		status = recede(&r);
	ts_free(r.normal);
	ts_free(r.area);
	ts_free(r.depth);
	ts_free(r.moved);
	return status;
}
