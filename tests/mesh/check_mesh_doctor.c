/* Each illness of a mesh is found, where it is and nowhere else. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "asserts.h"
#include "base/alloc.h"
#include "mesh/mesh_doctor.h"

#define CURVATURE 0.256235

static struct ts_mesh mesh;
static struct ts_mesh_findings found;
static long before;

static void start(void)
{
	before = ts_alloc_balance();
}

static void stop(void)
{
	ts_mesh_release(&mesh);
	ts_mesh_findings_release(&found);
	ck_assert_int_eq(ts_alloc_balance(), before);
}

static void examine(const double (*soup)[3][3], size_t n)
{
	ts_mesh_release(&mesh);
	ck_assert_int_eq(ts_mesh_build(&mesh, soup, n, 1e-8, CURVATURE), TS_OK);
	ck_assert_int_eq(ts_mesh_examine(&mesh, CURVATURE, &found), TS_OK);
}

/* Besides open edges there are `n` findings; returns the first of this kind. */
static const struct ts_mesh_finding *only(enum ts_mesh_fault fault, size_t n)
{
	size_t others = found.n - found.count[TS_MESH_OPEN];

	ck_assert_uint_eq(found.count[fault], n);
	ck_assert_uint_eq(others, n);
	for (size_t k = 0; k < found.n; k++)
		if (found.list[k].fault == fault)
			return &found.list[k];
	return NULL;
}

#define A                                   \
	{                                   \
		{ 0, 0, 0 }, { 2.5, 0, 0 }, \
		{                           \
			0, 2.5, 0           \
		}                           \
	}
#define B                                       \
	{                                       \
		{ 2.5, 0, 0 }, { 2.5, 2.5, 0 }, \
		{                               \
			0, 2.5, 0               \
		}                               \
	}

START_TEST(healthy)
{
	const double plate[][3][3] = { A, B };
	const double tetrahedron[][3][3] = { { { 7, 0, 0 }, { 7, 1, 0 }, { 9.385, 0, 0 } },
					     { { 7, 0, 0 }, { 9.385, 0, 0 }, { 7, 0, 1.7 } },
					     { { 9.385, 0, 0 }, { 7, 1, 0 }, { 7, 0, 1.7 } },
					     { { 7, 1, 0 }, { 7, 0, 0 }, { 7, 0, 1.7 } } };

	examine(plate, 2);
	only(TS_MESH_FLIPPED, 0);
	ck_assert_uint_eq(found.count[TS_MESH_OPEN], 2); /* two triangles have a rim */
	examine(tetrahedron, 4);
	ck_assert_uint_eq(found.n, 0);
	ck_assert_double_eq_tol(ts_mesh_volume(&mesh), 2.385 * 1.7 / 6, 1e-14);
	/* the same with one face turned round */
	const double turned[][3][3] = { { { 7, 0, 0 }, { 7, 1, 0 }, { 9.385, 0, 0 } },
					{ { 7, 0, 0 }, { 9.385, 0, 0 }, { 7, 0, 1.7 } },
					{ { 9.385, 0, 0 }, { 7, 0, 1.7 }, { 7, 1, 0 } },
					{ { 7, 1, 0 }, { 7, 0, 0 }, { 7, 0, 1.7 } } };

	examine(turned, 4);
	ck_assert_int_eq(only(TS_MESH_FLIPPED, 1)->triangle, 2);
}
END_TEST

START_TEST(shapes)
{
	/* heights over a base of 2.385 that give smallest angles of 0.4, 0.1 and 0.01 degrees */
	double h[3], angle[] = { 0.4, 0.1, 0.01 };
	const enum ts_mesh_fault fault[] = { TS_MESH_SLIVER, TS_MESH_SHARP, TS_MESH_NEEDLE };

	for (int k = 0; k < 3; k++) {
		h[k] = 2.385 / 2 * tan(angle[k] * 3.14159265358979323846 / 180);
		const double soup[][3][3] = { { { 0, 0, 0 }, { 2.385, 0, 0 }, { 2.385 / 2, -h[k], 0 } } };

		examine(soup, 1);
		ck_assert_int_eq(only(fault[k], 1)->triangle, 0);
		ck_assert_double_eq_tol(only(fault[k], 1)->amount, angle[k], 1e-15);
	}
	const double collapsed[][3][3] = { A, { { 0, 0, 0 }, { 1e-9, 0, 0 }, { 0, 2.5, 0 } } };

	examine(collapsed, 2);
	ck_assert_int_eq(only(TS_MESH_COLLAPSED, 1)->triangle, 1);
	const double line[][3][3] = { { { 0, 0, 0 }, { 0.7, 0, 0 }, { 2.385, 0, 0 } } };

	examine(line, 1);
	ck_assert_uint_eq(found.count[TS_MESH_NEEDLE], 1);
}
END_TEST

START_TEST(duplicates)
{
	const double soup[][3][3] = { A,
				      B,
				      { { 2.5, 0, 0 }, { 0, 2.5, 0 }, { 0, 0, 0 } },
				      { { 2.5, 2.5, 0 }, { 2.5, 0, 0 }, { 0, 2.5, 0 } },
				      A };
	const int other[] = { 0, 1, 0 };
	const struct ts_mesh_finding *f;

	examine(soup, 5);
	f = only(TS_MESH_DUPLICATE, 3);
	for (int k = 0; k < 3; k++) {
		ck_assert_int_eq(f[k].triangle, 2 + k);
		ck_assert_int_eq(f[k].other, other[k]);
	}
}
END_TEST

/* n blades of a mill wheel share one edge */
static void blades(size_t n)
{
	double soup[8][3][3] = { 0 };

	for (size_t k = 0; k < n; k++) {
		soup[k][1][2] = 2.385;
		soup[k][2][0] = cos(0.7 * (double)k);
		soup[k][2][1] = sin(0.7 * (double)k);
	}
	examine((const double(*)[3][3])soup, n);
}

START_TEST(edges)
{
	const double folded[][3][3] = { A, { { 0, 0, 0 }, { 2.5, 0, 0 }, { 0.3, 1.5, 0 } } };
	const double flipped[][3][3] = { A,
					 { { 2.5, 0, 0 }, { 0, 2.5, 0 }, { 2.5, 2.5, 0 } },
					 { { 2.5, 0, 0 }, { 5, 0, 0 }, { 2.5, 2.5, 0 } } };
	const struct ts_mesh_finding *f;

	examine(folded, 2);
	ck_assert_uint_eq(found.count[TS_MESH_FOLDED], 1);
	ck_assert_uint_eq(found.count[TS_MESH_FLIPPED], 1);
	examine(flipped, 3);
	ck_assert_int_eq(only(TS_MESH_FLIPPED, 1)->triangle, 1);

	blades(3);
	f = only(TS_MESH_BRANCHED, 3);
	ck_assert_double_eq(f->amount, 3);
	ck_assert_double_eq(f->at[2], 2.385 / 2);
	blades(6); /* five neighbours: the most that are borne */
	only(TS_MESH_BRANCHED, 6);
	blades(7);
	ck_assert_uint_eq(found.count[TS_MESH_CROWDED], 7);
	ck_assert_double_eq(found.list[0].amount, 6);
}
END_TEST

START_TEST(cracks)
{
	/* half of the other side is missing: its corner lies in the middle of the long edge */
	const double t_junction[][3][3] = { A, { { 2.5, 0, 0 }, { 2.5, 2.5, 0 }, { 1.25, 1.25, 0 } } };
	/* two plates side by side that fail to meet by a little */
	const double gap[][3][3] = { A, { { 2.5001, 0, 0 }, { 2.5, 2.5, 0 }, { 0, 2.5001, 0 } } };
	/* and by so much that it is meant */
	const double slit[][3][3] = { A, { { 2.6, 0, 0 }, { 2.6, 2.5, 0 }, { 0.1, 2.5, 0 } } };
	const struct ts_mesh_finding *f;

	examine(t_junction, 2);
	f = only(TS_MESH_CRACKED, 1);
	ck_assert_int_eq(f->triangle, 1);
	ck_assert_int_eq(f->other, 0);
	ck_assert_double_eq(f->at[0], 1.25);
	examine(gap, 2);
	f = only(TS_MESH_CRACKED, 2);
	ck_assert_double_eq_tol(f->amount, 1e-4, 1e-12);
	examine(slit, 2);
	only(TS_MESH_CRACKED, 0);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("mesh doctor");
	TCase *tests = tcase_create("mesh doctor");
	SRunner *runner;
	int failed;

	tcase_add_checked_fixture(tests, start, stop);
	tcase_add_test(tests, healthy);
	tcase_add_test(tests, shapes);
	tcase_add_test(tests, duplicates);
	tcase_add_test(tests, edges);
	tcase_add_test(tests, cracks);
	suite_add_tcase(suite, tests);
	runner = srunner_create(suite);
	srunner_run_all(runner, CK_NORMAL);
	failed = srunner_ntests_failed(runner);
	srunner_free(runner);
	return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
