/* Triangle meshes: shapes and how triangles hang together. */
#include <math.h>
#include <string.h>

#include "asserts.h"
#include "base/alloc.h"
#include "math/vec3.h"
#include "mesh/mesh_distance.h"
#include "mesh/mesh_touch.h"
#include "mesh/mesh_vicinity.h"

/* A cuboid of 12 triangles, as corner numbers: bit 0 x, bit 1 y, bit 2 z. */
static const int cuboid[12][3] = {
	{ 0, 2, 3 }, { 0, 3, 1 }, { 4, 5, 7 }, { 4, 7, 6 }, { 0, 1, 5 }, { 0, 5, 4 },
	{ 2, 6, 7 }, { 2, 7, 3 }, { 0, 4, 6 }, { 0, 6, 2 }, { 1, 3, 7 }, { 1, 7, 5 },
};
static const double half[3] = { 0.5, 0.4, 0.3 };

static void make_cuboid(struct ts_mesh *m)
{
	double soup[12][3][3];

	for (int t = 0; t < 12; t++)
		for (int k = 0; k < 9; k++)
			soup[t][k / 3][k % 3] = (cuboid[t][k / 3] >> k % 3 & 1 ? 1 : -1) * half[k % 3];
	ck_assert(ts_mesh_build(m, (const double(*)[3][3])soup, 12, 1e-8, 0.256235) == TS_OK);
}

static int count(const struct ts_mesh *m, size_t t, int first)
{
	int n = 0;

	for (int k = first; k < first + 3; k++)
		n += m->active[t] >> k & 1;
	return n;
}

START_TEST(cuboid_has_its_shape)
{
	struct ts_mesh m;
	double lo[3], hi[3];

	make_cuboid(&m);
	ck_assert_double_eq_tol(ts_mesh_area(&m), 8 * (0.2 + 0.12 + 0.15), 1e-15);
	ts_mesh_bounds(&m, lo, hi);
	for (int d = 0; d < 3; d++) {
		ck_assert(lo[d] == -half[d]);
		ck_assert(hi[d] == half[d]);
	}
	for (size_t t = 0; t < 12; t++) /* normals point outwards */
		ck_assert_double_gt(ts_dot(m.normal[t], m.centre[t]), 0.29);
	ck_assert_int_eq((int)m.nvertices, 8);
	ts_mesh_release(&m);
}
END_TEST

/* Each of the 12 edges and 8 corners is active once, in the last triangle that has it. */
START_TEST(cuboid_has_every_edge_once)
{
	static const int edges[12] = { 0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2 },
			 corners[12] = { 0, 0, 0, 0, 0, 0, 0, 0, 1, 3, 1, 3 };
	struct ts_mesh m;

	make_cuboid(&m);
	for (size_t t = 0; t < 12; t++) {
		ck_assert_int_eq(count(&m, t, 0), edges[t]);
		ck_assert_int_eq(count(&m, t, 3), corners[t]);
		for (int k = 0; k < 3; k++)
			ck_assert_int_ge(m.neighbour[t][k], 0);
	}
	ck_assert(ts_mesh_flat_neighbours(&m, 0, 1));
	ck_assert(!ts_mesh_flat_neighbours(&m, 0, 4));
	ts_mesh_release(&m);
}
END_TEST

/* Two triangles over the whole of a periodic box hang together with their images: nothing is an edge. */
START_TEST(floor_of_a_periodic_box_has_no_rim)
{
	const struct ts_box box = { .lo = { -1.7, 0.3, 0 },
				    .hi = { 0.685, 2.1, 1 },
				    .face = { { TS_FACE_PERIODIC, TS_FACE_PERIODIC },
					      { TS_FACE_PERIODIC, TS_FACE_PERIODIC },
					      { TS_FACE_FIXED, TS_FACE_FIXED } } };
	static const int corner[2][3] = { { 0, 1, 3 }, { 0, 3, 2 } };
	double soup[2][3][3] = { { { 0 } } };
	struct ts_mesh m;

	for (int c = 0; c < 6; c++) {
		int at = corner[c / 3][c % 3];

		soup[c / 3][c % 3][0] = at & 1 ? box.hi[0] : box.lo[0];
		soup[c / 3][c % 3][1] = at & 2 ? box.hi[1] : box.lo[1];
		soup[c / 3][c % 3][2] = 0.2385;
	}
	ck_assert(ts_mesh_build(&m, (const double(*)[3][3])soup, 2, 1e-8, 0.256235) == TS_OK);
	ck_assert_int_eq((int)m.nvertices, 4);
	ck_assert_int_eq(count(&m, 0, 0) + count(&m, 1, 0), 4);
	ck_assert(ts_mesh_link_images(&m, &box, 1e-8) == TS_OK);
	ck_assert_int_eq((int)m.nvertices, 1);
	for (size_t t = 0; t < 2; t++) {
		ck_assert_int_eq(m.active[t], 0);
		for (int k = 0; k < 3; k++)
			ck_assert_int_eq(m.neighbour[t][k], 1 - (int)t);
	}
	ts_mesh_release(&m);
}
END_TEST

/* Beyond both edges of a corner of 135 degrees, before one of them: in the edge; LIGGGHTS takes the
 * corner, but for the last of the three. */
START_TEST(beyond_an_obtuse_corner)
{
	static const double corner[3][3] = { { -1, 0, 0 }, { 0, 0, 0 }, { 1, 1, 0 } };
	/* -0.0385 from the corner along the first edge */
	static const double x[3] = { -0.0385, -0.2385, 0.3 };
	double soup[1][3][3];
	struct ts_mesh_contact_point at;
	struct ts_mesh m = { 0 };

	for (int first = 0; first < 3; first++) {
		for (int k = 0; k < 9; k++)
			soup[0][k / 3][k % 3] = corner[(k / 3 + first) % 3][k % 3];
		ck_assert(ts_mesh_build(&m, (const double(*)[3][3])soup, 1, 1e-8, 0.256235) == TS_OK);
		ck_assert(ts_mesh_nearest(&m, 0, x, &at) == TS_MESH_EDGE);
		ck_assert_double_eq_tol(at.distance, hypot(0.2385, 0.3), 1e-15);
		m.legacy = true;
		ck_assert(ts_mesh_nearest(&m, 0, x, &at) == (first == 2 ? TS_MESH_EDGE : TS_MESH_CORNER));
		ts_mesh_release(&m);
	}
}
END_TEST

/* A place in a cube of this edge. */
static void next_place(unsigned *seed, double edge, double x[3])
{
	for (int d = 0; d < 3; d++) {
		*seed = *seed * 1664525u + 1013904223u;
		x[d] = edge * ((double)*seed / 4294967296.0 - 0.5);
	}
}

/* Who is farther than a sphere's radius from a triangle does not look whether it touches. */
START_TEST(no_touch_is_nearer_than_the_triangle)
{
	unsigned seed = 387;
	struct ts_mesh m;

	make_cuboid(&m);
	for (int k = 0; k < 20000; k++) {
		size_t t = (size_t)k % 12;
		struct ts_mesh_contact_point s;
		double x[3], far;

		next_place(&seed, 1.6, x);
		far = ts_mesh_distance(&m, t, x);
		for (int legacy = 0; legacy < 2; legacy++) {
			m.legacy = legacy;
			if (ts_mesh_nearest(&m, t, x, &s) != TS_MESH_NOTHING)
				ck_assert_double_ge(s.distance, far - 2e-8);
		}
	}
	ts_mesh_release(&m);
}
END_TEST

START_TEST(trees_find_the_same_again)
{
	struct ts_mesh_list once = { 0 }, again = { 0 };
	struct ts_mesh_vicinity vicinity = { 0 };
	struct ts_mesh_tree tree;
	unsigned seed = 991;
	size_t found = 0;
	struct ts_mesh m;
	double from[3] = { 0 };

	make_cuboid(&m);
	ck_assert(ts_mesh_tree_build(&tree, &m) == TS_OK);
	for (int k = 0; k < 2000; k++) {
		double x[3], distance = 0.02 + 0.01 * (k % 7);

		if (k % 16 == 0)
			next_place(&seed, 1.6, from);
		next_place(&seed, 0.2, x);
		ts_add(from, x, x);
		ck_assert(ts_mesh_tree_near(&tree, &m, x, distance, &once) == TS_OK);
		ck_assert(ts_mesh_vicinity_near(&tree, &m, x, distance, &vicinity, &again) == TS_OK);
		ck_assert_uint_eq(once.n, again.n);
		ck_assert(!once.n || !memcmp(once.item, again.item, once.n * sizeof *once.item));
		found += once.n;
	}
	ck_assert_uint_gt(found, 300);
	ts_free(once.item);
	ts_free(again.item);
	ts_mesh_vicinity_release(&vicinity);
	ts_mesh_tree_release(&tree);
	ts_mesh_release(&m);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("mesh");
	TCase *tc = tcase_create("triangles");
	SRunner *runner = srunner_create(suite);
	int failed;

	tcase_add_test(tc, cuboid_has_its_shape);
	tcase_add_test(tc, cuboid_has_every_edge_once);
	tcase_add_test(tc, floor_of_a_periodic_box_has_no_rim);
	tcase_add_test(tc, beyond_an_obtuse_corner);
	tcase_add_test(tc, no_touch_is_nearer_than_the_triangle);
	tcase_add_test(tc, trees_find_the_same_again);
	suite_add_tcase(suite, tc);
	srunner_run_all(runner, CK_ENV);
	failed = srunner_ntests_failed(runner);
	srunner_free(runner);
	return failed ? 1 : 0;
}
