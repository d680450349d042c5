/* The nearest neighbours of points, against all pairs. */
#include <math.h>
#include <stdlib.h>

#include "asserts.h"
#include "bed/nearest.h"
#include "math/rng.h"
#include "math/vec3.h"

enum { N = 500, MOST = 12 };

static double x[N][3];
static int32_t tag[N], row[N * MOST];

static double distance2(const struct ts_box *box, size_t i, size_t j)
{
	double d[3];

	ts_sub(x[i], x[j], d);
	ts_box_nearest(box, d);
	return ts_dot(d, d);
}

/* Whether j is nearer to i than k is, or as near with a smaller tag. */
static bool is_before(const struct ts_box *box, size_t i, size_t j, size_t k)
{
	double a = distance2(box, i, j), b = distance2(box, i, k);

	return a < b || (a == b && tag[j] < tag[k]);
}

/* The neighbours of i are in order, and exactly k - 1 points are before the last. */
static void check_neighbours(const struct ts_box *box, size_t i, size_t k)
{
	const int32_t *mine = row + i * k;
	size_t before = 0;

	for (size_t m = 1; m < k; m++)
		ck_assert(is_before(box, i, (size_t)mine[m - 1], (size_t)mine[m]));
	for (size_t j = 0; j < N; j++)
		before += j != i && is_before(box, i, j, (size_t)mine[k - 1]);
	ck_assert_uint_eq(before, k - 1);
	for (size_t m = 0; m < k; m++)
		ck_assert_uint_ne((size_t)mine[m], i);
}

static void place_points(const struct ts_box *box, double spread)
{
	struct ts_rng rng = ts_rng_start(49979687, 0);

	for (int i = 0; i < N; i++) {
		tag[i] = 1 + (i * 7) % N;
		for (int d = 0; d < 3; d++)
			x[i][d] = box->lo[d] + spread * ts_rng_uniform(&rng) * ts_box_length(box, d);
	}
}

static struct ts_box box_of(enum ts_face face)
{
	struct ts_box box = { .lo = { -1.3, -0.2, 2 }, .hi = { 0.7, 1.9, 3.1 } };

	for (int d = 0; d < 3; d++)
		box.face[d][0] = box.face[d][1] = d == 1 ? TS_FACE_FIXED : face;
	return box;
}

/* Any first reach gives the same; so do walls and periodic faces. */
START_TEST(nearest_agree_with_all_pairs)
{
	const enum ts_face faces[] = { TS_FACE_FIXED, TS_FACE_PERIODIC };
	const double reach[] = { 1e-6, 0.1, 10 };
	const size_t wanted[] = { 1, 5, MOST };

	for (int f = 0; f < 2; f++) {
		const struct ts_box box = box_of(faces[f]);

		place_points(&box, 1);
		for (int k = 0; k < 3; k++) {
			ck_assert(ts_nearest_find(&box, 3, (const double(*)[3])x, tag, N, wanted[k], reach[k],
						  row) == TS_OK);
			for (size_t i = 0; i < N; i++)
				check_neighbours(&box, i, wanted[k]);
		}
	}
}
END_TEST

/* A dense bed with some points far above it; equal distances on a lattice. */
START_TEST(nearest_of_lonely_points)
{
	const struct ts_box box = box_of(TS_FACE_FIXED);

	place_points(&box, 0.05);
	for (int i = 0; i < 20; i++)
		x[i * 20][1] += 1 + 0.01 * i;
	ck_assert(ts_nearest_find(&box, 3, (const double(*)[3])x, tag, N, MOST, 0.02, row) == TS_OK);
	for (size_t i = 0; i < N; i++)
		check_neighbours(&box, i, MOST);
	for (int i = 0; i < N; i++) {
		x[i][0] = i % 8;
		x[i][1] = i / 8 % 8;
		x[i][2] = i / 64;
	}
	ck_assert(ts_nearest_find(&box, 3, (const double(*)[3])x, tag, N, 4, 1, row) == TS_OK);
	for (size_t i = 0; i < N; i++)
		check_neighbours(&box, i, 4);
}
END_TEST

/* Fewer points than a periodic box has images: each neighbour once. */
START_TEST(nearest_of_few_points)
{
	const struct ts_box box = box_of(TS_FACE_PERIODIC);

	place_points(&box, 1);
	ck_assert(ts_nearest_find(&box, 3, (const double(*)[3])x, tag, 4, 3, 1, row) == TS_OK);
	for (size_t i = 0; i < 4; i++) {
		bool seen[4] = { false };

		seen[i] = true;
		for (size_t m = 0; m < 3; m++)
			seen[row[3 * i + m]] = true;
		ck_assert(seen[0] && seen[1] && seen[2] && seen[3]);
	}
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("nearest");
	TCase *tcase = tcase_create("nearest");
	SRunner *runner = srunner_create(suite);
	int failed;

	tcase_add_test(tcase, nearest_agree_with_all_pairs);
	tcase_add_test(tcase, nearest_of_lonely_points);
	tcase_add_test(tcase, nearest_of_few_points);
	suite_add_tcase(suite, tcase);
	srunner_run_all(runner, CK_NORMAL);
	failed = srunner_ntests_failed(runner);
	srunner_free(runner);
	return failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
