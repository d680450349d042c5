/* The search for points and for periodic images that are near, against all pairs and images. */
#include <math.h>
#include <stdlib.h>

#include "asserts.h"
#include "geom/box_images.h"
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

/* Against all images out to 60 box lengths; the third axis is not periodic. A body longer than the box has several near, one
 * that is smaller may have none. */
START_TEST(images_near_agree_with_all_images)
{
	const struct ts_box box = { .lo = { -1, 0, 2 },
				    .hi = { 1, 0.5, 3 },
				    .face = { { TS_FACE_PERIODIC, TS_FACE_PERIODIC },
					      { TS_FACE_PERIODIC, TS_FACE_PERIODIC },
					      { TS_FACE_FIXED, TS_FACE_FIXED } } };
	const double r = 0.15, size[3] = { 0.3, 2.2, 0.1 };
	struct ts_rng rng = ts_rng_start(49979687, 0);
	int none = 0, several = 0;

	for (int n = 0; n < 200; n++) {
		double lo[3], hi[3], x[3], at[3];
		struct ts_box_images images;
		int found = 0, expected = 0;

		for (int d = 0; d < 3; d++) {
			lo[d] = 20 * (ts_rng_uniform(&rng) - 0.5);
			hi[d] = lo[d] + size[d];
			x[d] = box.lo[d] + ts_box_length(&box, d) * ts_rng_uniform(&rng);
		}
		images = ts_box_images(&box, lo, hi, x, x, r);
		while (ts_box_images_next(&images)) {
			ts_box_images_place(&box, images.shift, x, at);
			for (int d = 0; d < 2; d++)
				ck_assert(at[d] >= lo[d] - r && at[d] <= hi[d] + r);
			ck_assert_int_eq(images.shift[2], 0);
			found++;
		}
		for (int k = -60; k <= 60; k++)
			for (int m = -60; m <= 60; m++) {
				ts_box_images_place(&box, (const int[3]){ k, m, 0 }, x, at);
				expected += at[0] >= lo[0] - r && at[0] <= hi[0] + r && at[1] >= lo[1] - r &&
					    at[1] <= hi[1] + r;
			}
		ck_assert_int_eq(found, expected);
		none += !found;
		several += found > 1;
	}
	ck_assert_int_gt(none, 20);
	ck_assert_int_gt(several, 20);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("geom");
	TCase *tests = tcase_create("geom");
	SRunner *runner;
	int failed;

	tcase_add_test(tests, pointhash_agrees_with_all_pairs);
	tcase_add_test(tests, images_near_agree_with_all_images);
	suite_add_tcase(suite, tests);
	runner = srunner_create(suite);
	srunner_run_all(runner, CK_NORMAL);
	failed = srunner_ntests_failed(runner);
	srunner_free(runner);
	return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
