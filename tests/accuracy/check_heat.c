/* Conduction between spheres that stand still, m c dT/dt = -h L T with L the Laplacian of the graph of
 * contacts: against the exponential of the matrix (GSL), against numbers computed elsewhere
 * (tests/data/heat_*.csv), the order of explicit Euler, its limit, conservation. */
#include "../deck.h"

#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_blas.h>
#include <gsl/gsl_eigen.h>
#include <gsl/gsl_linalg.h>

#include "law/conduction.h"

static const double RADIUS = 0.5e-3, DISTANCE = 0.9e-3, DENSITY = 7850, CONDUCTIVITY = 43;
static const double HOT = 773.15, COLD = 273.15;

enum { MOST = 125 };

/* nx x ny x nz spheres, one of them hot. */
struct scene {
	const char *file; /* of tests/data */
	int n[3], hot;
	bool held; /* the hot one keeps its temperature */
	double capacity;
};
static const struct scene scenes[] = {
	{ "chain5_hot0", { 5, 1, 1 }, 0, false, 490 },
	{ "chain5_hot0_cp0.49", { 5, 1, 1 }, 0, false, 0.49 },
	{ "chain5_hot2", { 5, 1, 1 }, 2, false, 490 },
	{ "chain5_hot2_cp0.49", { 5, 1, 1 }, 2, false, 0.49 },
	{ "5x5_cornerheld", { 5, 5, 1 }, 0, true, 490 },
	{ "5x5_centreheld", { 5, 5, 1 }, 12, true, 490 },
	{ "5x5x5_cornerheld", { 5, 5, 5 }, 0, true, 490 },
	{ "5x5x5_centreheld", { 5, 5, 5 }, 62, true, 490 },
};
enum { NSCENES = sizeof scenes / sizeof *scenes };

static size_t size_of(const struct scene *s)
{
	return (size_t)(s->n[0] * s->n[1] * s->n[2]);
}

/* m c / h */
static double tau(const struct scene *s)
{
	double mass = DENSITY * 4 * TS_PI / 3 * pow(RADIUS, 3);
	double area = ts_lens_of_spheres(DISTANCE, RADIUS, RADIUS);

	return mass * s->capacity /
	       ts_heat_conductance(ts_heat_pair_conductivity(CONDUCTIVITY, CONDUCTIVITY), area);
}

static struct tsim *scene_open(const struct scene *s, const char *words)
{
	struct tsim *sim = deck_open("units si\n"
				     "region box block -0.001 0.005 -0.001 0.005 -0.001 0.005 units box\n"
				     "create_box 1 box\n"
				     "neighbor 1e-4 bin\n"
				     "fix k all property/global thermalConductivity peratomtype %.17g\n"
				     "fix c all property/global thermalCapacity peratomtype %.17g",
				     CONDUCTIVITY, s->capacity);

	for (int z = 0; z < s->n[2]; z++)
		for (int y = 0; y < s->n[1]; y++)
			for (int x = 0; x < s->n[0]; x++)
				deck(sim, "create_atoms 1 single %.17g %.17g %.17g units box", x * DISTANCE,
				     y * DISTANCE, z * DISTANCE);
	deck(sim,
	     "set group all diameter %.17g density %.17g\n"
	     "group hot id %d\n"
	     "group cold subtract all hot\n"
	     "fix heat %s heat/gran initial_temperature %.17g %s\n"
	     "set group hot property/atom Temp %.17g",
	     2 * RADIUS, DENSITY, s->hot + 1, s->held ? "cold" : "all", COLD, words, HOT);
	return sim;
}

/* t A of dT/dt = A T, A = -L/tau without the rows of those that keep their temperature. */
static gsl_matrix *matrix_of(const struct scene *s, double t)
{
	size_t n = size_of(s);
	gsl_matrix *a = gsl_matrix_calloc(n, n);
	const size_t stride[3] = { 1, (size_t)s->n[0], (size_t)(s->n[0] * s->n[1]) };

	for (size_t i = 0; i < n; i++) {
		const size_t at[3] = { i % stride[1], i / stride[1] % (size_t)s->n[1], i / stride[2] };

		for (int side = 0; side < 6; side++) {
			size_t d = (size_t)side / 2, j = side % 2 ? i - stride[d] : i + stride[d];

			if (at[d] == (side % 2 ? 0 : (size_t)s->n[d] - 1))
				continue;
			if (s->held && i == (size_t)s->hot)
				continue;
			*gsl_matrix_ptr(a, i, j) += t / tau(s);
			*gsl_matrix_ptr(a, i, i) -= t / tau(s);
		}
	}
	return a;
}

/* T(t) = e^(A t) T(0) by GSL. */
static void exponential(const struct scene *s, double t, double *out)
{
	size_t n = size_of(s);
	gsl_matrix *a = matrix_of(s, t), *e = gsl_matrix_alloc(n, n);
	gsl_vector *before = gsl_vector_alloc(n);
	gsl_vector_view after = gsl_vector_view_array(out, n);

	for (size_t i = 0; i < n; i++)
		gsl_vector_set(before, i, i == (size_t)s->hot ? HOT : COLD);
	gsl_linalg_exponential_ss(a, e, GSL_PREC_DOUBLE);
	gsl_blas_dgemv(CblasNoTrans, 1, e, before, 0, &after.vector);
	gsl_matrix_free(a);
	gsl_matrix_free(e);
	gsl_vector_free(before);
}

/* 2/lambda, lambda the largest eigenvalue of -A. */
static double euler_limit(const struct scene *s)
{
	size_t n = size_of(s);
	gsl_matrix *a = matrix_of(s, -1);
	gsl_vector *values = gsl_vector_alloc(n);
	gsl_eigen_symm_workspace *work = gsl_eigen_symm_alloc(n);
	double most;

	for (size_t i = 0; s->held && i < n; i++) /* the held one is no part of what grows */
		gsl_matrix_set(a, i, (size_t)s->hot, 0);
	gsl_eigen_symm(a, values, work);
	most = gsl_vector_max(values);
	gsl_eigen_symm_free(work);
	gsl_matrix_free(a);
	gsl_vector_free(values);
	return 2 / most;
}

static double largest_error(struct tsim *sim, const struct scene *s, double t)
{
	double temperature[MOST], expected[MOST], most = 0;

	deck_column(sim, "Temp", temperature, size_of(s), 0);
	exponential(s, t, expected);
	for (size_t i = 0; i < size_of(s); i++)
		most = fmax(most, fabs(temperature[i] - expected[i]));
	return most;
}

/* Long and short steps alike. */
START_TEST(exact_over_the_step)
{
	const struct scene *s = &scenes[_i];
	static const double lengths[] = { 0.0385, 0.77, 7.7 };

	for (size_t k = 0; k < DECK_LENGTH(lengths); k++) {
		struct tsim *sim = scene_open(s, "scheme exact");
		double error;

		deck(sim, "timestep %.17g\nrun 3", lengths[k] * tau(s));
		error = largest_error(sim, s, 3 * lengths[k] * tau(s));
		ck_assert_msg(error < 1e-9, "%s: off by %g", s->file, error);
		tsim_close(sim);
	}
}
END_TEST

/* Which sphere a column of the file is of. */
static size_t sphere_of(const struct scene *s, size_t column)
{
	static const size_t some[] = { 0, 1, 6, 31, 62, 124 };

	return s->n[2] > 1 ? some[column] : column;
}

/* One line of numbers; how many. */
static size_t read_line(FILE *file, double *out)
{
	char line[4096], *at = line, *end;
	size_t n = 0;

	do {
		if (!fgets(line, sizeof line, file))
			return 0;
	} while (line[0] == '#');
	for (; *at && *at != '\n'; at = *end == ',' ? end + 1 : end)
		out[n++] = strtod(at, &end);
	return n;
}

START_TEST(printed_numbers)
{
	const struct scene *s = &scenes[_i];
	struct tsim *sim = scene_open(s, "scheme exact");
	double row[MOST + 1], temperature[MOST], before = 0;
	char path[1024];
	size_t lines = 0;
	FILE *file;

	snprintf(path, sizeof path, "%s/tests/data/heat_%s.csv", getenv("top_srcdir"), s->file);
	file = fopen(path, "r");
	ck_assert_msg(file != NULL, "cannot read %s", path);
	for (size_t n; (n = read_line(file, row)) > 0; before = row[0], lines++) {
		if (row[0] > before)
			deck(sim, "timestep %.17g\nrun 1", row[0] - before);
		deck_column(sim, "Temp", temperature, size_of(s), 0);
		for (size_t k = 1; k < n; k++)
			DECK_NEAR(temperature[sphere_of(s, k - 1)], row[k], 1.5e-6);
	}
	fclose(file);
	ck_assert_uint_ge(lines, 8);
	tsim_close(sim);
}
END_TEST

START_TEST(euler_is_first_order)
{
	const struct scene *s = &scenes[_i];
	double h[5], error[5], t = 0.77 * tau(s);

	for (int k = 0; k < 5; k++) {
		struct tsim *sim = scene_open(s, "");
		int steps = 40 << k;

		h[k] = 1.0 / steps;
		deck(sim, "timestep %.17g\nrun %d", t / steps, steps);
		error[k] = largest_error(sim, s, t);
		tsim_close(sim);
	}
	DECK_NEAR(deck_order(h, error, 5), 1, 0.02);
}
END_TEST

/* Free spheres keep their heat to the last digits, uneven ones too, whatever the scheme. */
START_TEST(heat_is_conserved)
{
	static const char *const words[] = { "", "scheme exact" };

	for (int k = 0; k < 2; k++) {
		struct scene s = { "", { 5, 5, 5 }, 31, false, 490 };
		struct tsim *sim = scene_open(&s, words[k]);
		double before;

		deck(sim,
		     "variable d atom 0.00098+0.00001*id/5\nset group all diameter v_d\n"
		     "timestep %.17g\nrun 0",
		     0.05 * tau(&s));
		before = deck_value(sim, "f_heat");
		deck(sim, "run 400");
		DECK_NEAR(deck_value(sim, "f_heat") / before, 1, 2e-15);
		tsim_close(sim);
	}
}
END_TEST

static bool stays_bounded(const struct scene *s, double h)
{
	struct tsim *sim = scene_open(s, "");
	double temperature[MOST];
	bool good;

	good = deck_accepts(sim, "timestep %.17g\nrun 4000", h);
	ck_assert(good || strstr(tsim_error(sim), "has reached the temperature"));
	deck_column(sim, "Temp", temperature, size_of(s), 0);
	for (size_t i = 0; i < size_of(s); i++)
		good = good && fabs(temperature[i]) < 1e4;
	tsim_close(sim);
	return good;
}

/* Measured by bisection: 2/lambda. m c/sum h, which the plan names, is below and at least half of it. */
START_TEST(limit_of_euler)
{
	const struct scene *s = &scenes[_i];
	double theory = euler_limit(s), lo = theory / 2, hi = 2 * theory;
	double neighbours = s->n[2] > 1 ? 6 : s->n[1] > 1 ? 4 : 2;

	ck_assert(stays_bounded(s, lo) && !stays_bounded(s, hi));
	while (hi / lo > 1.0005) {
		double h = sqrt(lo * hi);

		if (stays_bounded(s, h))
			lo = h;
		else
			hi = h;
	}
	DECK_NEAR(sqrt(lo * hi) / theory, 1, 2e-3);
	ck_assert_double_le(tau(s) / neighbours, lo);
	ck_assert_double_ge(tau(s) / neighbours, lo / 2);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("heat");
	TCase *tests = tcase_create("conduction");

	tcase_set_timeout(tests, 120);
	tcase_add_loop_test(tests, exact_over_the_step, 0, NSCENES);
	tcase_add_loop_test(tests, printed_numbers, 0, NSCENES);
	tcase_add_loop_test(tests, euler_is_first_order, 0, 6);
	tcase_add_test(tests, heat_is_conserved);
	tcase_add_loop_test(tests, limit_of_euler, 0, 1);
	tcase_add_loop_test(tests, limit_of_euler, 4, 6);
	suite_add_tcase(suite, tests);
	return deck_main(suite);
}
