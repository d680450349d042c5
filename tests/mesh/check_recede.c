/* Surfaces of triangles that recede by given volumes: geometry, account of the volume, and what is refused. */
#include <math.h>
#include <string.h>

#include "asserts.h"
#include "base/alloc.h"
#include "math/constants.h"
#include "math/vec3.h"
#include "mesh/mesh_links.h"
#include "mesh/mesh_recession.h"

enum { SIDE = 8 }; /* cells of the square sheets */

/* A mesh that recedes. */
struct scene {
	struct ts_mesh m;
	struct ts_mesh_nodes nodes;
	double *volume, *swept; /* [nodes] */
	double (*to)[3][3];
	struct ts_mesh_recession_finding f;
};

/* A number between -1 and 1 for each k. */
static double noise(size_t k)
{
	double s = sin(12.9898 * ((double)k + 1)) * 43758.5453;

	return 2 * (s - floor(s)) - 1;
}

static void start(struct scene *s, const double (*soup)[3][3], size_t n, double size)
{
	enum ts_mesh_nodes_fault fault;
	size_t t;

	*s = (struct scene){ 0 };
	ck_assert(ts_mesh_build(&s->m, soup, n, 1e-7 * size, 0.256235) == TS_OK);
	ck_assert(ts_mesh_nodes_build(&s->nodes, &s->m, &fault, &t) == TS_OK);
	ck_assert_int_eq(fault, TS_MESH_NODES_FINE);
	s->volume = ts_alloc(s->m.nvertices, sizeof *s->volume);
	s->swept = ts_alloc(s->m.nvertices, sizeof *s->swept);
	s->to = ts_alloc(s->m.n, sizeof *s->to);
}

static void end(struct scene *s)
{
	ts_mesh_nodes_release(&s->nodes);
	ts_mesh_release(&s->m);
	ts_free(s->volume);
	ts_free(s->swept);
	ts_free(s->to);
}

/* A square sheet in z = 0, 2 SIDE^2 triangles; `rough`: its nodes are moved at random, of the size of a cell. Every third
 * triangle is wound the other way round with `mixed`. */
static void make_sheet(struct scene *s, double size, double rough, bool mixed)
{
	static const int cell[2][3][2] = { { { 0, 0 }, { 1, 0 }, { 1, 1 } },
					   { { 0, 0 }, { 1, 1 }, { 0, 1 } } };
	double soup[2 * SIDE * SIDE][3][3], width = size / SIDE;

	for (int t = 0; t < 2 * SIDE * SIDE; t++)
		for (int k = 0; k < 3; k++) {
			int at = mixed && t % 3 == 1 ? 2 - k : k;
			int i = t / 2 % SIDE + cell[t % 2][at][0], j = t / 2 / SIDE + cell[t % 2][at][1];
			size_t node = (size_t)(3 * (j * (SIDE + 1) + i));

			soup[t][k][0] = width * (i + rough * noise(node));
			soup[t][k][1] = width * (j + rough * noise(node + 1));
			soup[t][k][2] = width * rough * noise(node + 2);
		}
	start(s, (const double(*)[3][3])soup, 2 * SIDE * SIDE, size);
}

/* Icosahedron whose triangles are divided into four twice, on a sphere. */
static void make_sphere(struct scene *s, double radius)
{
	static const int face[20][3] = { { 0, 11, 5 },	{ 0, 5, 1 },  { 0, 1, 7 },  { 0, 7, 10 },
					 { 0, 10, 11 }, { 1, 5, 9 },  { 5, 11, 4 }, { 11, 10, 2 },
					 { 10, 7, 6 },	{ 7, 1, 8 },  { 3, 9, 4 },  { 3, 4, 2 },
					 { 3, 2, 6 },	{ 3, 6, 8 },  { 3, 8, 9 },  { 4, 9, 5 },
					 { 2, 4, 11 },	{ 6, 2, 10 }, { 8, 6, 7 },  { 9, 8, 1 } };
	static double soup[320][3][3];
	const double g = (1 + sqrt(5)) / 2;
	const double corner[12][3] = { { -1, g, 0 }, { 1, g, 0 }, { -1, -g, 0 }, { 1, -g, 0 },
				       { 0, -1, g }, { 0, 1, g }, { 0, -1, -g }, { 0, 1, -g },
				       { g, 0, -1 }, { g, 0, 1 }, { -g, 0, -1 }, { -g, 0, 1 } };
	size_t n = 20;

	for (size_t t = 0; t < n; t++)
		for (int k = 0; k < 3; k++)
			ts_scale(1, corner[face[t][k]], soup[t][k]);
	for (int level = 0; level < 2; level++, n *= 4)
		for (size_t t = n; t-- > 0;) {
			double x[6][3];

			for (int k = 0; k < 3; k++) {
				ts_scale(1, soup[t][k], x[k]);
				ts_add(soup[t][k], soup[t][(k + 1) % 3], x[3 + k]);
				ts_scale(0.5, x[3 + k], x[3 + k]);
			}
			for (int part = 0; part < 4; part++)
				for (int k = 0; k < 3; k++) {
					static const int of[4][3] = {
						{ 0, 3, 5 }, { 3, 1, 4 }, { 5, 4, 2 }, { 3, 4, 5 }
					};

					ts_scale(1, x[of[part][k]],
						 soup[part ? n + 3 * t + (size_t)part - 1 : t][k]);
				}
		}
	for (size_t c = 0; c < 3 * n; c++)
		ts_scale(radius / ts_norm(soup[c / 3][c % 3]), soup[c / 3][c % 3], soup[c / 3][c % 3]);
	start(s, (const double(*)[3][3])soup, n, 2 * radius);
}

/* Gives a volume, worn on the side of the first triangle, to the nodes of triangle t. */
static void wear(struct scene *s, size_t t, double volume)
{
	for (int k = 0; k < 3; k++)
		s->volume[s->m.vertex[t][k]] += volume / 3;
}

static void recede(struct scene *s)
{
	ck_assert(ts_mesh_recession(&s->m, &s->nodes, (const double(*)[3][3])s->m.x, s->volume, s->to,
				    s->swept, &s->f) == TS_OK);
}

/* Makes the new positions those of the mesh. */
static void accept(struct scene *s)
{
	ck_assert_int_eq(s->f.fault, TS_MESH_RECESSION_FINE);
	memcpy(s->m.x, s->to, s->m.n * sizeof *s->m.x);
	ts_mesh_update_geometry(&s->m);
	ck_assert(ts_mesh_update_active(&s->m) == TS_OK);
}

/* Six times the volume of the tetrahedron of the origin and a triangle. */
static double six_volumes(const double a[3], const double b[3], const double c[3])
{
	double across[3];

	ts_cross(b, c, across);
	return ts_dot(a, across);
}

/* The part of the walls that the rim sweeps: the integral of x . n over the ruled surface of a moving edge, by Simpson's
 * rule, which is exact for this cubic. */
static double six_walls(const double from[2][3], const double to[2][3])
{
	static const double at[3] = { 0, 0.5, 1 }, weight[3] = { 1, 4, 1 };
	double sum = 0;

	for (int i = 0; i < 3; i++)
		for (int j = 0; j < 3; j++) {
			double x[3], u[3], v[3];

			for (int d = 0; d < 3; d++) {
				double p = (1 - at[j]) * from[0][d] + at[j] * to[0][d];
				double q = (1 - at[j]) * from[1][d] + at[j] * to[1][d];

				x[d] = p + at[i] * (q - p);
				u[d] = q - p;
				v[d] = (1 - at[i]) * (to[0][d] - from[0][d]) +
				       at[i] * (to[1][d] - from[1][d]);
			}
			sum += weight[i] * weight[j] / 36 * six_volumes(x, u, v);
		}
	return 2 * sum;
}

/* Volume between the old surface and the new one, by the divergence theorem over both and the walls of the rim; its sign
 * is that of the side of the first triangle. Independent of ts_mesh_recession. */
static double volume_between(const struct scene *s)
{
	double sum = 0;

	for (size_t t = 0; t < s->m.n; t++) {
		double from[3][3], to[3][3];

		for (int k = 0; k < 3; k++) {
			int at = s->nodes.side[t] > 0 ? k : 2 - k;

			ts_sub(s->m.x[t][at], s->m.x[0][0], from[k]); /* against rounding */
			ts_sub(s->to[t][at], s->m.x[0][0], to[k]);
		}
		sum += six_volumes(from[0], from[1], from[2]) - six_volumes(to[0], to[1], to[2]);
		for (int k = 0; k < 3; k++) {
			int at = s->nodes.side[t] > 0
					 ? k
					 : (4 - k) % 3; /* the edge from corner k of the copies */
			double edge[2][2][3];

			if (s->m.neighbour[t][at] >= 0)
				continue;
			for (int e = 0; e < 2; e++) {
				ts_scale(1, from[(k + e) % 3], edge[0][e]);
				ts_scale(1, to[(k + e) % 3], edge[1][e]);
			}
			sum -= six_walls((const double(*)[3])edge[0], (const double(*)[3])edge[1]);
		}
	}
	return sum / 6;
}

static double sum_of(const double *list, size_t n)
{
	double sum = 0;

	for (size_t k = 0; k < n; k++)
		sum += list[k];
	return sum;
}

#define ck_close(a, b, tolerance) ck_assert_double_eq_tol((a) / (b), 1, tolerance)

/* Also in micrometres and kilometres, and at the rim. */
START_TEST(sheet_sinks_by_volume_over_area)
{
	static const double sizes[3] = { 1, 2.385e-6, 2.385e3 };
	const double size = sizes[_i];
	struct scene s;

	make_sheet(&s, size, 0, false);
	for (size_t t = 0; t < s.m.n; t++)
		wear(&s, t, 0.01 * size * s.m.area[t]);
	recede(&s);
	for (size_t c = 0; c < 3 * s.m.n; c++) {
		ck_close(s.to[c / 3][c % 3][2], -0.01 * size, 1e-14);
		for (int d = 0; d < 2; d++)
			ck_assert(s.to[c / 3][c % 3][d] == s.m.x[c / 3][c % 3][d]);
	}
	ck_close(volume_between(&s), 0.01 * size * size * size, 1e-12);
	end(&s);
}
END_TEST

/* All nodes of a sphere that loses volume in proportion to the areas keep nearly the same radius, which the volume of the
 * polyhedron gives. */
START_TEST(sphere_loses_its_volume)
{
	struct scene s;
	double before, area, least = INFINITY, most = 0;

	make_sphere(&s, 2.385);
	before = 0;
	for (size_t t = 0; t < s.m.n; t++)
		before += six_volumes(s.m.x[t][0], s.m.x[t][1], s.m.x[t][2]) / 6;
	area = ts_mesh_area(&s.m);
	for (size_t t = 0; t < s.m.n; t++)
		wear(&s, t, 0.1 * before * s.m.area[t] / area);
	recede(&s);
	ck_close(volume_between(&s), 0.1 * before, 1e-12);
	ck_close(sum_of(s.swept, s.nodes.n), 0.1 * before, 1e-12);
	accept(&s);
	for (size_t c = 0; c < 3 * s.m.n; c++) {
		least = fmin(least, ts_norm(s.m.x[c / 3][c % 3]));
		most = fmax(most, ts_norm(s.m.x[c / 3][c % 3]));
	}
	ck_assert_double_lt(least, 2.385 * cbrt(0.9));
	ck_assert_double_gt(most, 2.385 * cbrt(0.9));
	ck_assert_double_lt(most / least, 1.003);
	ck_close(0.5 * (least + most), 2.385 * cbrt(0.9), 1e-3);
	end(&s);
}
END_TEST

/* Radius by many small steps: the account stays, and the sphere stays round. */
START_TEST(many_steps_keep_the_account)
{
	struct scene s;
	double before = 0, after = 0, taken = 0;

	make_sphere(&s, 1e-6);
	for (size_t t = 0; t < s.m.n; t++)
		before += six_volumes(s.m.x[t][0], s.m.x[t][1], s.m.x[t][2]) / 6;
	for (int step = 0; step < 50; step++) {
		memset(s.volume, 0, s.nodes.n * sizeof *s.volume);
		for (size_t t = 0; t < s.m.n; t++) {
			double volume = 2e-3 * before / (double)s.m.n * (1 + noise(t + 1000 * (size_t)step));

			wear(&s, t, volume);
			taken += volume;
		}
		recede(&s);
		accept(&s);
	}
	for (size_t t = 0; t < s.m.n; t++)
		after += six_volumes(s.m.x[t][0], s.m.x[t][1], s.m.x[t][2]) / 6;
	ck_close(before - after, taken, 1e-12);
	ck_assert_double_lt(after, 0.91 * before);
	end(&s);
}
END_TEST

/* Random volumes on a rough sheet, also with triangles wound the other way round: the volume of each node is that of its
 * triangles. */
START_TEST(rough_sheet_with_any_winding)
{
	struct scene s[2];

	for (int mixed = 0; mixed < 2; mixed++) {
		double all = 0;

		make_sheet(&s[mixed], 2.385, 0.3, mixed);
		for (size_t t = 0; t < s[mixed].m.n; t++) {
			double volume = 0.05 * s[mixed].m.area[t] * (1 + noise(t));

			wear(&s[mixed], t, volume);
			all += volume;
		}
		recede(&s[mixed]);
		ck_assert_int_eq(s[mixed].f.fault, TS_MESH_RECESSION_FINE);
		ck_close(volume_between(&s[mixed]), all, 1e-12);
		for (size_t v = 0; v < s[mixed].nodes.n; v++)
			ck_close(s[mixed].swept[v], s[mixed].volume[v], 1e-11);
	}
	for (size_t c = 0; c < 3 * s[0].m.n; c++) {
		size_t t = c / 3, k = c % 3;

		for (int d = 0; d < 3; d++)
			ck_assert_double_eq_tol(s[0].to[t][k][d], s[1].to[t][t % 3 == 1 ? 2 - k : k][d],
						1e-13);
	}
	end(&s[0]);
	end(&s[1]);
}
END_TEST

/* Nodes without volume stay, also next to others; without any volume all positions are the same numbers. */
START_TEST(no_volume_no_motion)
{
	struct scene s;

	make_sheet(&s, 1, 0.3, false);
	recede(&s);
	ck_assert(memcmp(s.to, s.m.x, s.m.n * sizeof *s.to) == 0);
	wear(&s, 0, 1e-5);
	recede(&s);
	for (size_t c = 0; c < 3 * s.m.n; c++) {
		bool worn = s.volume[s.m.vertex[c / 3][c % 3]] > 0;

		ck_assert(worn != !memcmp(s.to[c / 3][c % 3], s.m.x[c / 3][c % 3], sizeof(double[3])));
	}
	ck_close(volume_between(&s), 1e-5, 1e-9);
	end(&s);
}
END_TEST

/* The sheet bends where it has been worn: its edges and corners are those of a mesh that is built in the new shape. */
START_TEST(edges_of_a_dent_are_active)
{
	struct ts_mesh fresh;
	struct scene s;
	uint8_t before[2 * SIDE * SIDE];

	make_sheet(&s, 1, 0, false);
	memcpy(before, s.m.active, sizeof before);
	wear(&s, SIDE * SIDE + SIDE, 1e-3);
	recede(&s);
	accept(&s);
	ck_assert(memcmp(before, s.m.active, sizeof before) != 0);
	ck_assert(ts_mesh_build(&fresh, (const double(*)[3][3])s.m.x, s.m.n, 1e-7, 0.256235) == TS_OK);
	ck_assert(memcmp(fresh.active, s.m.active, sizeof before) == 0);
	ck_assert_double_lt(s.m.normal[SIDE * SIDE + SIDE + 1][2], 0.999);
	ts_mesh_release(&fresh);
	end(&s);
}
END_TEST

/* Triangles that are removed leave a rim: edges and corners are those of a mesh without them; they take no part in what
 * their nodes sweep. */
START_TEST(removed_triangles)
{
	const size_t hole[2] = { SIDE * SIDE + SIDE, SIDE * SIDE + SIDE + 1 };
	double soup[2 * SIDE * SIDE][3][3];
	struct ts_mesh fresh;
	struct scene s;
	size_t n = 0;

	make_sheet(&s, 1, 0, false);
	for (size_t k = 0; k < 2; k++)
		s.m.active[hole[k]] |= TS_MESH_REMOVED;
	ck_assert(ts_mesh_update_active(&s.m) == TS_OK);
	for (size_t t = 0; t < s.m.n; t++)
		if (t != hole[0] && t != hole[1])
			memcpy(soup[n++], s.m.x[t], sizeof *soup);
	ck_assert(ts_mesh_build(&fresh, (const double(*)[3][3])soup, n, 1e-7, 0.256235) == TS_OK);
	for (size_t t = 0; t < s.m.n; t++) {
		bool removed = t == hole[0] || t == hole[1];

		ck_assert_int_eq(s.m.active[t],
				 removed ? TS_MESH_REMOVED : fresh.active[t > hole[1] ? t - 2 : t]);
	}
	for (size_t t = 0; t < s.m.n; t++)
		if (t != hole[0] && t != hole[1])
			wear(&s, t, 0.01 * s.m.area[t]);
	recede(&s);
	ck_assert_int_eq(s.f.fault, TS_MESH_RECESSION_FINE);
	for (size_t c = 0; c < 3 * s.m.n; c++)
		ck_close(s.to[c / 3][c % 3][2], -0.01, 1e-13);
	ck_close(sum_of(s.swept, s.nodes.n), 0.01 * (1 - 1.0 / (SIDE * SIDE)), 1e-13);
	ts_mesh_release(&fresh);
	end(&s);
}
END_TEST

/* Whichever allocation fails, the error is returned, and nothing stays allocated. */
START_TEST(without_memory)
{
	struct ts_mesh_nodes nodes = { 0 };
	enum ts_mesh_nodes_fault fault;
	enum ts_status status = TS_NOMEM;
	struct scene s;
	size_t t;
	long before;

	make_sheet(&s, 1, 0.3, false);
	wear(&s, 60, 1e-4);
	before = ts_alloc_balance();
	for (long k = 1; status != TS_OK; k++) {
		ts_alloc_fail_at(k);
		status = ts_mesh_nodes_build(&nodes, &s.m, &fault, &t);
		ts_alloc_fail_at(0);
		ck_assert(status == TS_OK || (status == TS_NOMEM && ts_alloc_balance() == before && k < 10));
	}
	ts_mesh_nodes_release(&nodes);
	status = TS_NOMEM;
	for (long k = 1; status != TS_OK; k++) {
		ts_alloc_fail_at(k);
		status = ts_mesh_recession(&s.m, &s.nodes, (const double(*)[3][3])s.m.x, s.volume, s.to,
					   s.swept, &s.f);
		ts_alloc_fail_at(0);
		ck_assert((status == TS_OK || status == TS_NOMEM) && ts_alloc_balance() == before && k < 20);
	}
	end(&s);
}
END_TEST

/* More volume than there is, and a node deeper than its triangles are wide next to nodes that rest. */
START_TEST(folds_are_refused)
{
	struct scene s;

	make_sphere(&s, 1);
	for (size_t t = 0; t < s.m.n; t++) /* more than there is */
		wear(&s, t, 0.02);
	recede(&s);
	ck_assert_int_ne(s.f.fault, TS_MESH_RECESSION_FINE);
	end(&s);
	make_sheet(&s, 1, 0.3, false);
	wear(&s, 60, 0.05);
	recede(&s);
	ck_assert_int_ne(s.f.fault, TS_MESH_RECESSION_FINE);
	end(&s);
}
END_TEST

/* Two sheets of one mesh, one above the other: the upper one cannot be worn through the lower one locally. */
START_TEST(intersection_is_refused)
{
	static const double soup[2][3][3] = { { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } },
					      { { -3, -3, -0.1 }, { 4, -3, -0.1 }, { 0.3, 4, -0.1 } } };
	struct scene s;

	start(&s, soup, 2, 7);
	s.volume[s.m.vertex[0][0]] = 0.05 / 6;
	recede(&s);
	ck_assert_int_eq(s.f.fault, TS_MESH_RECESSION_FINE);
	s.volume[s.m.vertex[0][0]] = 0.2 / 6;
	recede(&s);
	ck_assert_int_eq(s.f.fault, TS_MESH_RECESSION_PIERCED);
	ck_assert_int_eq((int)s.f.triangle, 0);
	ck_assert_int_eq((int)s.f.other, 1);
	end(&s);
}
END_TEST

/* An edge of three triangles, two surfaces that share a corner, a strip with one side. */
START_TEST(odd_surfaces_are_refused)
{
	static const double fin[3][3][3] = { { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } },
					     { { 0, 0, 0 }, { 1, 0, 0 }, { 0, -1, 0 } },
					     { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 0, 1 } } };
	static const double bow[2][3][3] = { { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } },
					     { { 0, 0, 0 }, { -1, 0, 0 }, { 0, -1, 0 } } };
	double strip[16][3][3];
	const struct {
		const double (*soup)[3][3];
		size_t n;
		enum ts_mesh_nodes_fault fault;
	} of[3] = { { fin, 3, TS_MESH_NODES_BRANCHED },
		    { bow, 2, TS_MESH_NODES_PINCHED },
		    { (const double(*)[3][3])strip, 16, TS_MESH_NODES_ONE_SIDED } };

	for (int t = 0; t < 16; t++)
		for (int k = 0; k < 3; k++) { /* a Moebius strip of 8 cells */
			int i = t / 2 + (t % 2 ? k > 0 : k == 1), up = t % 2 ? k < 2 : k == 2;
			double turn = TS_PI * (i % 8) / 8, s = (i == 8 ? -1 : 1) * (up ? 0.2 : -0.2);

			strip[t][k][0] = (1 + s * cos(turn)) * cos(2 * turn);
			strip[t][k][1] = (1 + s * cos(turn)) * sin(2 * turn);
			strip[t][k][2] = s * sin(turn);
		}
	for (int k = 0; k < 3; k++) {
		struct ts_mesh m;
		struct ts_mesh_nodes nodes;
		enum ts_mesh_nodes_fault fault;
		size_t t;

		ck_assert(ts_mesh_build(&m, of[k].soup, of[k].n, 1e-8, 0.256235) == TS_OK);
		ck_assert(ts_mesh_nodes_build(&nodes, &m, &fault, &t) == TS_OK);
		ck_assert_int_eq(fault, of[k].fault);
		ts_mesh_release(&m);
	}
}
END_TEST

/* Two triangles over the whole of a periodic box have one node: they sink together. */
START_TEST(periodic_floor_sinks)
{
	const struct ts_box box = { .hi = { 2, 3, 1 },
				    .face = { { TS_FACE_PERIODIC, TS_FACE_PERIODIC },
					      { TS_FACE_PERIODIC, TS_FACE_PERIODIC },
					      { TS_FACE_FIXED, TS_FACE_FIXED } } };
	static const double soup[2][3][3] = { { { 0, 0, 0.5 }, { 2, 0, 0.5 }, { 2, 3, 0.5 } },
					      { { 0, 0, 0.5 }, { 2, 3, 0.5 }, { 0, 3, 0.5 } } };
	enum ts_mesh_nodes_fault fault;
	struct scene s;
	size_t t;

	start(&s, soup, 2, 3);
	ts_mesh_nodes_release(&s.nodes);
	ck_assert(ts_mesh_link_images(&s.m, &box, 1e-8) == TS_OK);
	ck_assert(ts_mesh_nodes_build(&s.nodes, &s.m, &fault, &t) == TS_OK);
	ck_assert_int_eq(fault, TS_MESH_NODES_FINE);
	s.volume[0] = 0.6;
	recede(&s);
	for (size_t c = 0; c < 6; c++)
		ck_assert_double_eq_tol(s.to[c / 3][c % 3][2], 0.4, 1e-15);
	ck_assert_int_eq(s.f.fault, TS_MESH_RECESSION_FINE);
	end(&s);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("mesh");
	TCase *tc = tcase_create("recession");
	SRunner *runner = srunner_create(suite);
	int failed;

	tcase_add_loop_test(tc, sheet_sinks_by_volume_over_area, 0, 3);
	tcase_add_test(tc, sphere_loses_its_volume);
	tcase_add_test(tc, many_steps_keep_the_account);
	tcase_add_test(tc, rough_sheet_with_any_winding);
	tcase_add_test(tc, no_volume_no_motion);
	tcase_add_test(tc, edges_of_a_dent_are_active);
	tcase_add_test(tc, removed_triangles);
	tcase_add_test(tc, without_memory);
	tcase_add_test(tc, folds_are_refused);
	tcase_add_test(tc, intersection_is_refused);
	tcase_add_test(tc, odd_surfaces_are_refused);
	tcase_add_test(tc, periodic_floor_sinks);
	suite_add_tcase(suite, tc);
	srunner_run_all(runner, CK_ENV);
	failed = srunner_ntests_failed(runner);
	srunner_free(runner);
	return failed ? 1 : 0;
}
