/* Voxel height fields: contact points against a search of all local minima of the distance, the signed distance
 * against that from all columns, maxima of blocks, and
 * the statistics of Gaussian surfaces. */
#include <stdlib.h>

#include "base/alloc.h"
#include "math/rng.h"
#include "math/vec3.h"
#include "tests/deck.h"
#include "voxel/voxel_distance.h"
#include "voxel/voxel_gaussian.h"
#include "voxel/voxel_touch.h"

enum { MOST = 4096 };

static double pick(struct ts_rng *rng, double lo, double hi)
{
	return lo + (hi - lo) * ts_rng_uniform(rng);
}

/* Heights of few different values, so that neighbours are often equal, and some columns empty. */
static void make_field(struct ts_voxel_field *f, struct ts_rng *rng, int nx, int ny, bool periodic, bool base)
{
	*f = (struct ts_voxel_field){
		.axis = { 0, 1, 2 },
		.n = { nx, ny },
		.origin = { -0.7, 0.31 },
		.width = { 0.1, 0.13 },
		.base = base ? -0.21 : -INFINITY,
		.periodic = { periodic, periodic && ts_rng_uniform(rng) < 0.5 },
	};
	ck_assert(ts_voxel_field_make(f) == TS_OK);
	for (int k = 0; k < nx * ny; k++)
		ts_voxel_heights(f)[k] = 0.07 * floor(pick(rng, base ? -4 : 0, 4));
	ts_voxel_field_update(f);
}

/* Whether a point is in the solid, by all columns that may contain it. */
static bool is_inside(const struct ts_voxel_field *f, const double p[3])
{
	for (int d = 0; d < 2; d++)
		if (isnan(p[d]))
			return false;
	for (int64_t j = -2 * f->n[1]; j < 3 * f->n[1]; j++) {
		if (p[1] < ts_voxel_border(f, 1, j) || p[1] > ts_voxel_border(f, 1, j + 1))
			continue;
		for (int64_t i = -2 * f->n[0]; i < 3 * f->n[0]; i++)
			if (p[0] >= ts_voxel_border(f, 0, i) && p[0] <= ts_voxel_border(f, 0, i + 1) &&
			    p[2] >= f->base && p[2] <= ts_voxel_top(f, i, j))
				return true;
	}
	return false;
}

/* A box is a product of intervals: if a point of it is not the nearest one, a step along one axis towards c leads
 * to a nearer point of the box. So p is a local minimum unless such a step stays in the solid. */
static bool is_minimum(const struct ts_voxel_field *f, const double p[3], const double c[3])
{
	for (int d = 0; d < 3; d++) {
		double q[3] = { p[0], p[1], p[2] };

		q[d] += c[d] > p[d] ? 1e-9 : c[d] < p[d] ? -1e-9 : 0;
		if (q[d] != p[d] && is_inside(f, q))
			return false;
	}
	return true;
}

struct minimum {
	double p[3], distance;
};

static double clamp(double x, double lo, double hi)
{
	return x < lo ? lo : x > hi ? hi : x;
}

/* All local minima nearer than `reach`, each once. */
static size_t find_minima(const struct ts_voxel_field *f, const double c[3], double reach,
			  struct minimum *out)
{
	size_t n = 0;

	for (int64_t j = -2 * f->n[1]; j < 3 * f->n[1]; j++)
		for (int64_t i = -2 * f->n[0]; i < 3 * f->n[0]; i++) {
			double top = ts_voxel_top(f, i, j);
			struct minimum m = {
				{ clamp(c[0], ts_voxel_border(f, 0, i), ts_voxel_border(f, 0, i + 1)),
				  clamp(c[1], ts_voxel_border(f, 1, j), ts_voxel_border(f, 1, j + 1)),
				  clamp(c[2], f->base, top) },
				0
			};
			bool known = false;

			m.distance = sqrt(ts_distance2(c, m.p));
			if (!(top > f->base) || !(m.distance < reach) || !is_minimum(f, m.p, c))
				continue;
			for (size_t k = 0; k < n; k++)
				known |= ts_distance2(out[k].p, m.p) == 0;
			if (!known)
				out[n++] = m;
		}
	return n;
}

/* A centre anywhere near, with coordinates on borders and at heights as often as not. */
static void place_centre(const struct ts_voxel_field *f, struct ts_rng *rng, double c[3])
{
	for (int d = 0; d < 2; d++) {
		double at = pick(rng, -1, (double)f->n[d] + 1);

		c[d] = ts_rng_uniform(rng) < 0.5 ? ts_voxel_border(f, d, (int64_t)floor(at))
						 : f->origin[d] + at * f->width[d];
	}
	c[2] = ts_rng_uniform(rng) < 0.5 ? 0.07 * floor(pick(rng, -4, 6)) : pick(rng, -0.4, 0.5);
}

static void compare_at(const struct ts_voxel_field *f, const double c[3], double reach, size_t *total)
{
	static struct minimum minimum[MOST];
	static struct ts_voxel_contact contact[MOST];
	size_t n = find_minima(f, c, reach, minimum);
	size_t m = ts_voxel_contacts(f, c, reach, contact, MOST);
	double least = INFINITY;

	ck_assert(m == n);
	for (size_t k = 0; k < n; k++) {
		bool found = false;

		for (size_t a = 0; a < m && !found; a++) {
			double p[3] = { c[0], c[1], c[2] };

			ts_axpy(-contact[a].distance, contact[a].n, p);
			found = fabs(contact[a].distance - minimum[k].distance) < 1e-15 &&
				ts_distance2(p, minimum[k].p) < 1e-28;
		}
		ck_assert(found);
		least = fmin(least, minimum[k].distance);
	}
	ck_assert(n ? fabs(ts_voxel_distance(f, c, reach) - least) < 1e-15
		    : isinf(ts_voxel_distance(f, c, reach)));
	*total += n;
}

static void compare(int nx, int ny, double reach, int fields, int centres)
{
	struct ts_rng rng = ts_rng_start(15485863, (uint64_t)(nx + 100 * ny));
	size_t total = 0;

	for (int k = 0; k < 4 * fields; k++) {
		struct ts_voxel_field f;

		make_field(&f, &rng, nx, ny, k & 1, k & 2);
		for (int l = 0; l < centres; l++) {
			double c[3];

			place_centre(&f, &rng, c);
			compare_at(&f, c, reach, &total);
		}
		ts_voxel_field_release(&f);
	}
	ck_assert_int_gt((int)total, fields * centres);
}

START_TEST(contacts_are_all_local_minima)
{
	compare(5, 4, 0.3, 40, 60);  /* about three columns */
	compare(6, 7, 0.05, 40, 60); /* less than a column */
	compare(1, 1, 0.3, 20, 60);  /* one column, its own neighbour if it is periodic */
	compare(2, 3, 0.11, 20, 60); /* two images of the same column */
	compare(21, 17, 0.9, 2, 30); /* blocks of columns */
}
END_TEST

/* Below each point of a flat field there is one contact, also where columns meet. */
START_TEST(flat_field_has_no_seams)
{
	struct ts_rng rng = ts_rng_start(32452843, 0);

	for (int periodic = 0; periodic < 2; periodic++) {
		struct ts_voxel_field f = { .axis = { 1, 2, 0 },
					    .n = { 33, 20 },
					    .origin = { 0.1, -3 },
					    .width = { 1e-6 / 3, 1e-6 / 7 },
					    .base = -INFINITY,
					    .periodic = { periodic, periodic } };
		struct ts_voxel_contact contact[2];

		ck_assert(ts_voxel_field_make(&f) == TS_OK);
		for (int k = 0; k < 33 * 20; k++)
			ts_voxel_heights(&f)[k] = 0.3;
		ts_voxel_field_update(&f);
		for (int k = 0; k < 4000; k++) {
			double u = pick(&rng, 0, 33), v = pick(&rng, 0, 20);
			double x[3] = { 0.3 + 1.3e-6, 0.1 + u * f.width[0], -3 + v * f.width[1] };

			if (k % 2)
				x[1] = ts_voxel_border(&f, 0, (int64_t)u);
			if (k % 3)
				x[2] = ts_voxel_border(&f, 1, (int64_t)v);
			ck_assert(ts_voxel_contacts(&f, x, 2e-6, contact, 2) == 1);
			ck_assert(contact[0].distance == x[0] - 0.3);
			ck_assert(contact[0].n[0] == 1 && contact[0].n[1] == 0 && contact[0].n[2] == 0);
			ck_assert(contact[0].column[0] == ts_voxel_index(&f, 0, x[1]));
			ck_assert(contact[0].column[1] == ts_voxel_index(&f, 1, x[2]));
		}
		ts_voxel_field_release(&f);
	}
}
END_TEST

/* Steps of the size of rounding make no contacts: those of a field are the same in number and, to the steps, in place if
 * its heights are disturbed a little. */
START_TEST(steps_of_rounding_are_none)
{
	struct ts_rng rng = ts_rng_start(49979687, 0);
	static struct ts_voxel_contact plain[MOST], disturbed[MOST];
	size_t total = 0;

	for (int k = 0; k < 40; k++) {
		struct ts_voxel_field f;

		make_field(&f, &rng, 6, 7, k & 1, k & 2);
		for (int l = 0; l < 100; l++) {
			double c[3], height[42], difference = 0;
			size_t n, m;

			place_centre(&f, &rng, c);
			c[2] = pick(&rng, -0.4, 0.5);
			n = ts_voxel_contacts(&f, c, 0.3, plain, MOST);
			for (int j = 0; j < 42; j++) {
				height[j] = ts_voxel_heights(&f)[j];
				if (height[j] > f.base + 0.01)
					ts_voxel_heights(&f)[j] += pick(&rng, -1e-12, 1e-12);
			}
			ts_voxel_field_update(&f);
			m = ts_voxel_contacts(&f, c, 0.3, disturbed, MOST);
			ck_assert_uint_eq(m, n);
			for (size_t j = 0; j < n; j++) /* on a border in another order */
				difference += disturbed[j].distance - plain[j].distance;
			ck_assert(fabs(difference) < 1e-11);
			for (int j = 0; j < 42; j++)
				ts_voxel_heights(&f)[j] = height[j];
			ts_voxel_field_update(&f);
			total += n;
		}
		ts_voxel_field_release(&f);
	}
	ck_assert_uint_gt(total, 4000);
}
END_TEST

/* ---- signed distance */

/* Distance of c from the solid (`sign` 1), or from the space outside (-1), by all columns. */
static double distance_to_all(const struct ts_voxel_field *f, const double c[3], int sign)
{
	double least = INFINITY;

	for (int64_t j = -2 * f->n[1]; j < 3 * f->n[1]; j++)
		for (int64_t i = -2 * f->n[0]; i < 3 * f->n[0]; i++) {
			double top = ts_voxel_top(f, i, j), d[2], low = f->base - c[2];
			double aside[3] = {
				fmax(ts_voxel_border(f, 0, i) - c[0], c[0] - ts_voxel_border(f, 0, i + 1)),
				fmax(ts_voxel_border(f, 1, j) - c[1], c[1] - ts_voxel_border(f, 1, j + 1)),
				sign > 0 ? fmax(low, c[2] - top) : top - c[2]
			};

			if (sign > 0 && !(top > f->base))
				continue;
			d[0] = hypot(fmax(0, aside[0]), fmax(0, aside[1]));
			d[1] = hypot(d[0], fmax(0, aside[2]));
			least = fmin(least, sign < 0 && !(top > f->base) ? d[0] : d[1]);
		}
	return sign < 0 ? fmin(least, fmax(0, c[2] - f->base)) : least;
}

/* Whether there is a point outside (or inside) ahead of the surface point p along n, to some side: p may be on an
 * edge. */
static bool is_ahead(const struct ts_voxel_field *f, const double p[3], const double n[3], double step,
		     bool outside)
{
	for (int corner = 0; corner < 8; corner++) {
		double q[3];

		for (int d = 0; d < 3; d++)
			q[d] = p[d] + step * n[d] + (corner >> d & 1 ? 0.3 : -0.3) * step;
		if ((distance_to_all(f, q, 1) > 0) == outside)
			return true;
	}
	return false;
}

static void check_distance(const struct ts_voxel_field *f, const struct ts_voxel_space *space,
			   const double c[3], double reach, int *count)
{
	double out = distance_to_all(f, c, 1), in = distance_to_all(f, c, -1), p[3] = { c[0], c[1], c[2] };
	struct ts_voxel_distance found;
	bool near = ts_voxel_signed_distance(f, space, c, reach, &found);

	ck_assert(near == (fmax(out, in) < reach));
	if (out > 0 || in > 0)
		ck_assert(ts_voxel_inside(f, c) == (in > out));
	if (!near)
		return;
	DECK_NEAR(found.distance, out > 0 ? out : -in, 1e-15);
	DECK_NEAR(ts_norm(found.n), 1, 1e-15);
	ts_axpy(-found.distance, found.n, p);
	ck_assert(is_ahead(f, p, found.n, 1e-9, true) && is_ahead(f, p, found.n, -1e-9, false));
	count[out > 0 ? 0 : in > 0 ? 1 : 2]++;
}

START_TEST(signed_distance_is_that_of_all_columns)
{
	struct ts_rng rng = ts_rng_start(86028121, 0);
	int count[3] = { 0 };

	for (int k = 0; k < 160; k++) {
		struct ts_voxel_field f;
		struct ts_voxel_space space = { .field = { .nlevels = 0 } };
		bool changed;

		make_field(&f, &rng, k % 7 + 1, k % 5 + 1, k & 1, k & 2);
		ck_assert(ts_voxel_space_update(&space, &f, &changed) == TS_OK && changed);
		ts_voxel_set_height(&f, 0, 0, 0.137);
		ck_assert(ts_voxel_space_update(&space, &f, &changed) == TS_OK && changed);
		ck_assert(ts_voxel_space_update(&space, &f, &changed) == TS_OK && !changed);
		for (int l = 0; l < 80; l++) {
			double c[3];

			place_centre(&f, &rng, c);
			check_distance(&f, &space, c, l % 2 ? 0.3 : 0.04, count);
		}
		ts_voxel_field_release(&f);
		ts_voxel_field_release(&space.field);
	}
	for (int k = 0; k < 3; k++)
		ck_assert_int_gt(count[k], 200);
}
END_TEST

START_TEST(columns_contain_their_lower_border)
{
	struct ts_voxel_field f = { .n = { 1000, 1 }, .origin = { 0.1, 0 }, .width = { 0.3 / 7, 1 } };

	for (int64_t i = -2000; i < 2000; i++) {
		double x = ts_voxel_border(&f, 0, i);

		ck_assert(ts_voxel_index(&f, 0, x) == i);
		ck_assert(ts_voxel_index(&f, 0, nextafter(x, -INFINITY)) == i - 1);
		ck_assert(ts_voxel_index(&f, 0, nextafter(x, INFINITY)) == i);
	}
	ck_assert(ts_voxel_index(&f, 0, 1e300) > INT64_C(1000000000000));
	ck_assert(ts_voxel_index(&f, 0, -1e300) < -INT64_C(1000000000000));
}
END_TEST

/* Changes of single heights leave the same maxima as computing all of them. */
START_TEST(maxima_follow_changes)
{
	struct ts_rng rng = ts_rng_start(49979687, 0);
	struct ts_voxel_field f, whole;

	make_field(&f, &rng, 37, 70, false, false);
	whole = f;
	ck_assert(ts_voxel_field_make(&whole) == TS_OK);
	for (int k = 0; k < 37 * 70; k++)
		ts_voxel_heights(&whole)[k] = ts_voxel_heights(&f)[k];
	for (int k = 0; k < 20000; k++) {
		int64_t i = (int64_t)pick(&rng, 0, 37), j = (int64_t)pick(&rng, 0, 70);
		double height = k < 10000 ? pick(&rng, -1, 1) : ts_voxel_top(&f, i, j) - 0.1;

		ts_voxel_set_height(&f, i, j, height);
		ts_voxel_heights(&whole)[j * 37 + i] = height;
	}
	ts_voxel_field_update(&whole);
	ck_assert_int_eq(f.nlevels, 5);
	for (int l = 0; l < f.nlevels; l++)
		for (int64_t k = 0; k < f.level[l].n[0] * f.level[l].n[1]; k++)
			ck_assert(f.level[l].top[k] == whole.level[l].top[k]);
	ts_voxel_field_release(&f);
	ts_voxel_field_release(&whole);
}
END_TEST

/* ---- Gaussian surfaces */

/* Covariance of the surface at a distance of k columns along one axis, summed over the periodic images. */
static double covariance(const struct ts_voxel_gaussian *g, int d, int64_t k)
{
	double sum = 0, all = 0, length = (double)g->n[d] * g->width[d];

	for (int m = -20; m <= 20; m++) {
		double r = (double)k * g->width[d] + m * length, l = g->correlation[d];

		sum += l > 0 ? exp(-r * r / (l * l)) : r == 0;
		all += l > 0 ? exp(-m * m * length * length / (l * l)) : m == 0;
	}
	return sum / all;
}

/* The response b to noise in one column only: the covariance at k of white noise is sum_i b_i b_(i+k). */
START_TEST(filter_has_the_covariance)
{
	static const double length[3][2] = { { 0.31, 0.14 }, { 0.05, 0 }, { 0.6, 0.02 } };

	for (int s = 0; s < 3; s++) {
		struct ts_voxel_gaussian g = { .n = { 21, 16 },
					       .width = { 0.1, 0.05 },
					       .correlation = { length[s][0], length[s][1] } };
		double b[21 * 16] = { [5 * 21 + 3] = 1 };

		ck_assert(ts_voxel_gaussian_filter(&g, b) == TS_OK);
		for (int v = 0; v < 16; v++)
			for (int u = 0; u < 21; u++) {
				double sum = 0;

				for (int k = 0; k < 21 * 16; k++)
					sum += b[k] * b[(k / 21 + v) % 16 * 21 + (k % 21 + u) % 21];
				DECK_NEAR(sum, covariance(&g, 0, u) * covariance(&g, 1, v), 1e-14);
			}
	}
}
END_TEST

struct statistics {
	double mean, deviation, skewness, kurtosis, at_length[2];
};

static struct statistics measure(const struct ts_voxel_gaussian *g, const double *h)
{
	int64_t nx = g->n[0], n = nx * g->n[1];
	int64_t u = (int64_t)rint(g->correlation[0] / g->width[0]);
	int64_t v = (int64_t)rint(g->correlation[1] / g->width[1]);
	struct statistics s = { 0 };
	double m2 = 0, m3 = 0, m4 = 0;

	for (int64_t k = 0; k < n; k++)
		s.mean += h[k] / (double)n;
	for (int64_t k = 0; k < n; k++) {
		double d = h[k] - s.mean;

		m2 += d * d / (double)n;
		m3 += d * d * d / (double)n;
		m4 += d * d * d * d / (double)n;
		s.at_length[0] += d * (h[k / nx * nx + (k + u) % nx] - s.mean) / (double)n;
		s.at_length[1] += d * (h[(k + v * nx) % n] - s.mean) / (double)n;
	}
	s.deviation = sqrt(m2);
	s.skewness = m3 / (m2 * s.deviation);
	s.kurtosis = m4 / (m2 * m2);
	s.at_length[0] /= m2;
	s.at_length[1] /= m2;
	return s;
}

/* A surface of N ~ L_x L_y/(l_x l_y) independent spots; its statistics differ from those of the ensemble by some
 * 1/sqrt(N). At the correlation length the correlation is 1/e. */
START_TEST(surface_has_its_statistics)
{
	struct ts_voxel_gaussian g = { .n = { 512, 384 },
				       .width = { 0.01, 0.02 },
				       .mean = 3e-3,
				       .deviation = 7e-6,
				       .correlation = { 0.04, 0.1 },
				       .seed = 17 };
	double *h = ts_alloc(512 * 384, sizeof *h), *again = ts_alloc(512 * 384, sizeof *h);
	double spots = 512 * 0.01 * 384 * 0.02 / (0.04 * 0.1);
	struct statistics s;

	ck_assert(ts_voxel_gaussian(&g, h) == TS_OK && ts_voxel_gaussian(&g, again) == TS_OK);
	for (int k = 0; k < 512 * 384; k++)
		ck_assert(h[k] == again[k]);
	s = measure(&g, h);
	DECK_NEAR((s.mean - 3e-3) / 7e-6, 0,
		  3 * sqrt(3.15 / spots)); /* integral of the covariance: pi l_x l_y */
	DECK_NEAR(s.deviation / 7e-6, 1, 4 / sqrt(spots));
	DECK_NEAR(s.skewness, 0, 10 / sqrt(spots));
	DECK_NEAR(s.kurtosis, 3, 20 / sqrt(spots));
	DECK_NEAR(s.at_length[0], exp(-1), 4 / sqrt(spots));
	DECK_NEAR(s.at_length[1], exp(-1), 4 / sqrt(spots));
	g.exact = true;
	ck_assert(ts_voxel_gaussian(&g, h) == TS_OK);
	s = measure(&g, h);
	DECK_NEAR(s.mean, 3e-3, 1e-14);
	DECK_NEAR(s.deviation, 7e-6, 1e-16);
	g.seed = 18;
	ck_assert(ts_voxel_gaussian(&g, again) == TS_OK);
	ck_assert(h[1000] != again[1000]);
	ts_free(h);
	ts_free(again);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("voxel");
	TCase *touch = tcase_create("contact points"), *random = tcase_create("Gaussian surfaces");

	tcase_set_timeout(touch, 60);
	tcase_add_test(touch, contacts_are_all_local_minima);
	tcase_add_test(touch, flat_field_has_no_seams);
	tcase_add_test(touch, steps_of_rounding_are_none);
	tcase_add_test(touch, signed_distance_is_that_of_all_columns);
	tcase_add_test(touch, columns_contain_their_lower_border);
	tcase_add_test(touch, maxima_follow_changes);
	suite_add_tcase(suite, touch);
	tcase_add_test(random, filter_has_the_covariance);
	tcase_add_test(random, surface_has_its_statistics);
	suite_add_tcase(suite, random);
	return deck_main(suite);
}
