#include "mesh/mesh_volume.h"

#include <math.h>

#include "math/vec3.h"

#include "base/banned.h"

/* Integrals over volume and surface, as sums over the triangles. */
struct sums {
	double volume, first[3], second[3][3]; /* int 1, x_i, x_i x_j dV */
	double flux[3][3], area[3];	       /* int x_i n_j dA, n_j dA */
};

/* Adds the tetrahedron of the origin and a, b, c, of volume V = a.(b x c)/6: with s = a + b + c
 *   int x = V s/4,  int x x^T = V (s s^T + a a^T + b b^T + c c^T)/20 */
static void add_tetrahedron(struct sums *sums, double x[3][3])
{
	double s[3], across[3], ab[3], ac[3], volume;

	ts_cross(x[1], x[2], across);
	volume = ts_dot(x[0], across) / 6;
	ts_sub(x[1], x[0], ab);
	ts_sub(x[2], x[0], ac);
	ts_cross(ab, ac, across); /* n dA, doubled */
	sums->volume += volume;
	for (int i = 0; i < 3; i++)
		s[i] = x[0][i] + x[1][i] + x[2][i];
	for (int i = 0; i < 3; i++) {
		sums->first[i] += volume * s[i] / 4;
		sums->area[i] += 0.5 * across[i];
		for (int j = 0; j < 3; j++) {
			double product = s[i] * s[j];

			for (int k = 0; k < 3; k++)
				product += x[k][i] * x[k][j];
			sums->second[i][j] += volume * product / 20;
			sums->flux[i][j] += s[i] / 3 * 0.5 * across[j];
		}
	}
}

/* By Gauss' theorem int n dA = 0 and int x_i n_j dA = V delta_ij over a surface that encloses V. */
static bool encloses_volume(const struct sums *s, double area, double size)
{
	bool so = fabs(s->volume) > 1e-9 * area * size;

	for (int i = 0; i < 3; i++) {
		so &= fabs(s->area[i]) <= 1e-6 * area;
		for (int j = 0; j < 3; j++)
			so &= fabs(s->flux[i][j] - (i == j) * s->volume) <= 1e-6 * area * size;
	}
	return so;
}

bool ts_mesh_measure_volume(const struct ts_mesh *mesh, struct ts_mesh_volume *out)
{
	static const int pair[6][2] = { { 0, 0 }, { 1, 1 }, { 2, 2 }, { 0, 1 }, { 0, 2 }, { 1, 2 } };
	struct sums s = { 0 };
	double lo[3], hi[3], middle[3], trace = 0, moment[3][3];

	ts_mesh_bounds(mesh, lo, hi);
	for (int k = 0; k < 3; k++)
		middle[k] = 0.5 * (lo[k] + hi[k]);
	for (size_t t = 0; t < mesh->n; t++) {
		double x[3][3];

		for (int k = 0; k < 3; k++)
			ts_sub(mesh->x[t][k], middle, x[k]);
		add_tetrahedron(&s, x);
	}
	if (mesh->n == 0 || !encloses_volume(&s, ts_mesh_area(mesh), sqrt(ts_distance2(lo, hi))))
		return false;
	out->volume = s.volume;
	ts_scale(1 / s.volume, s.first, out->centre);
	for (int i = 0; i < 3; i++) {
		for (int j = 0; j < 3; j++)
			moment[i][j] = s.second[i][j] - s.first[i] * s.first[j] / s.volume;
		trace += moment[i][i];
	}
	for (int k = 0; k < 6; k++)
		out->inertia[k] = (k < 3) * trace - moment[pair[k][0]][pair[k][1]];
	ts_add(out->centre, middle, out->centre);
	return true;
}
