/* The search for points that are near, against all pairs. */
#include <check.h>
#include <math.h>
#include <stdlib.h>

#include "geom/pointhash.h"
#include "math/rng.h"
#include "math/vec3.h"

enum { N = 400 };

static bool near_directly(double x[][3], int n, const struct ts_box *box, const double at[3], double distance)
{
	for (int i = 0; i < n; i++) {
		double d[3];

		ts_sub(at, x[i], d);
		for (int k = 0; k < 3; k++)
			if (ts_box_periodic(box, k))
				d[k] -= ts_box_length(box, k) * rint(d[k] / ts_box_length(box, k));
		if (ts_dot(d, d) < distance * distance)
			return true;
	}
	return false;
}

/* Against all pairs, with two periodic faces, in a box that has the origin inside. */
START_TEST(pointhash_agrees_with_all_pairs)
{
	const struct ts_box box = { .lo = { -1.3, -0.2, 2 },
				    .hi = { 0.7, 1.9, 3.1 },
				    .face = { { TS_FACE_PERIODIC, TS_FACE_PERIODIC },
					      { TS_FACE_FIXED, TS_FACE_FIXED },
					      { TS_FACE_PERIODIC, TS_FACE_PERIODIC } } };
	struct ts_rng rng = ts_rng_start(86028157, 0);
	struct ts_pointhash hash;
	static double x[N][3];
	int found = 0;

	ck_assert(ts_pointhash_start(&hash, 0.17) == TS_OK);
	for (int i = 0; i < N; i++) {
		double distance = 0.17 * ts_rng_uniform(&rng);

		for (int d = 0; d < 3; d++)
			x[i][d] = box.lo[d] + ts_box_length(&box, d) * ts_rng_uniform(&rng);
		ck_assert(ts_pointhash_near_periodic(&hash, &box, x[i], distance) ==
			  near_directly(x, i, &box, x[i], distance));
		found += near_directly(x, i, &box, x[i], distance);
		ck_assert(ts_pointhash_add(&hash, x[i]) == TS_OK);
	}
	ck_assert_int_gt(found, N / 20);
	ck_assert_int_lt(found, N);
	ts_pointhash_release(&hash);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("geom");
	TCase *tests = tcase_create("geom");
	SRunner *runner;
	int failed;

	tcase_add_test(tests, pointhash_agrees_with_all_pairs);
	suite_add_tcase(suite, tests);
	runner = srunner_create(suite);
	srunner_run_all(runner, CK_NORMAL);
	failed = srunner_ntests_failed(runner);
	srunner_free(runner);
	return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
