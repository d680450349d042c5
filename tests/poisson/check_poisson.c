/* Solvers for the pressure: each against the operator itself, for all conditions at boundaries. */
#include <gsl/gsl_fft_complex.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "asserts.h"
#include "core/life.h"
#include "library/tsim_tables.h"
#include "math/rng.h"
#include "math/fourier.h"
#include "poisson/poisson.h"
#include "poisson/pressure_choice.h"

enum { MOST = 600 }; /* cells along an axis */

struct problem {
	struct ts_grid grid;
	struct ts_poisson poisson;
	struct ts_rng rng;
	double *p, *rhs, *solution, *weight[3];
};

static const enum ts_pressure_condition PER = TS_PRESSURE_PERIODIC, NEU = TS_PRESSURE_NO_GRADIENT,
					DIR = TS_PRESSURE_GIVEN;

/* Faces of an axis: `grading` is how much a cell is wider than the one before, 1: all alike. */
static void make_faces(double *face, int n, double length, double grading)
{
	double sum = 0, width = 1;

	face[0] = -0.385;
	for (int i = 0; i < n; i++, width *= i == n / 2 ? 1 : i < n / 2 ? grading : 1 / grading) {
		sum += width;
		face[i + 1] = sum;
	}
	for (int i = 0; i < n; i++)
		face[i + 1] = face[0] + face[i + 1] * length / sum;
}

static void fill(struct problem *q, double *field)
{
	for (size_t i = 0; i < q->grid.size; i++)
		field[i] = ts_rng_uniform(&q->rng) - 0.5;
}

/* `code`: conditions of the axes, one figure of 0 .. 4 for each. */
static void set_conditions(struct ts_poisson *poisson, int axes, int code)
{
	const enum ts_pressure_condition pairs[5][2] = {
		{ PER, PER }, { NEU, NEU }, { DIR, DIR }, { NEU, DIR }, { DIR, NEU }
	};

	poisson->singular = true;
	for (int d = 0; d < 3; d++, code /= 5) {
		const enum ts_pressure_condition *pair = pairs[d < axes ? code % 5 : 1];

		memcpy(poisson->condition[d], pair, sizeof poisson->condition[d]);
		if (pair[0] == DIR || pair[1] == DIR)
			poisson->singular = false;
	}
}

static void make(struct problem *q, int axes, const int n[3], int code, const double grading[3], bool weights)
{
	static const double lengths[3] = { 2.385, 1.7, 1.13 };
	static double face[3][MOST + 1];
	const double *faces[3] = { face[0], face[1], face[2] };
	bool periodic[3];

	*q = (struct problem){ .rng = ts_rng_start(86028157, (uint64_t)code) };
	set_conditions(&q->poisson, axes, code);
	for (int d = 0; d < 3; d++) {
		make_faces(face[d], n[d], lengths[d] * n[d] / 20, grading[d]);
		periodic[d] = q->poisson.condition[d][0] == PER;
	}
	ck_assert(ts_grid_make(&q->grid, axes, n, faces, periodic) == TS_OK);
	q->poisson.grid = &q->grid;
	q->poisson.threads = 1;
	q->p = ts_grid_field(&q->grid);
	q->rhs = ts_grid_field(&q->grid);
	q->solution = ts_grid_field(&q->grid);
	fill(q, q->p);
	for (int d = 0; weights && d < axes; d++) {
		q->poisson.weight[d] = q->weight[d] = ts_grid_field(&q->grid);
		fill(q, q->weight[d]);
		for (size_t i = 0; i < q->grid.size; i++)
			q->weight[d][i] = 0.7 + 0.6 * q->weight[d][i];
	}
}

static void done(struct problem *q)
{
	ts_grid_field_free(q->p);
	ts_grid_field_free(q->rhs);
	ts_grid_field_free(q->solution);
	for (int d = 0; d < 3; d++)
		ts_grid_field_free(q->weight[d]);
	ts_grid_release(&q->grid);
}

#define EACH_CELL(grid, i, j, k)                       \
	for (int k = 0; k < (grid)->n[2]; k++)         \
		for (int j = 0; j < (grid)->n[1]; j++) \
			for (int i = 0; i < (grid)->n[0]; i++)

static double mean(const struct problem *q, const double *p)
{
	double sum = 0, volume = 0;

	EACH_CELL(&q->grid, i, j, k)
	{
		sum += ts_grid_volume(&q->grid, i, j, k) * p[ts_at(&q->grid, i, j, k)];
		volume += ts_grid_volume(&q->grid, i, j, k);
	}
	return sum / volume;
}

/* The largest difference of two fields; where they are known up to a constant, of those without mean. */
static double difference(const struct problem *q, const double *a, const double *b)
{
	double shift = q->poisson.singular ? mean(q, a) - mean(q, b) : 0, most = 0;

	EACH_CELL(&q->grid, i, j, k)
	{
		size_t at = ts_at(&q->grid, i, j, k);

		most = fmax(most, fabs(a[at] - b[at] - shift));
	}
	return most;
}

static double largest(const struct problem *q, const double *a)
{
	double most = 0;

	EACH_CELL(&q->grid, i, j, k)
	most = fmax(most, fabs(a[ts_at(&q->grid, i, j, k)]));
	return most;
}

/* pressure_style NAME ARGUMENTS, ready to solve */
static struct ts_instance *solver(struct tsim *sim, const char *line, const struct ts_poisson *poisson)
{
	static char text[200];
	struct ts_word word[16];
	struct ts_words words = { word, 0 };
	struct ts_instance *inst = NULL;
	char *rest = text;

	snprintf(text, sizeof text, "%s", line);
	for (char *w; (w = strsep(&rest, " "));)
		word[words.n++] = (struct ts_word){ .text = w };
	ck_assert(ts_sim_choose(sim, TS_KIND_PRESSURE, words, &(struct ts_place){ .line = 1 }) == TS_OK);
	ck_assert_msg(ts_pressure_choose(sim, poisson, &(struct ts_place){ .line = 1 }, &inst) == TS_OK, "%s",
		      sim->error.message);
	ck_assert_msg(ts_pressure_style_of(inst)->prepare(inst, sim, poisson) == TS_OK, "%s",
		      sim->error.message);
	return inst;
}

/* Whether a solver takes part: weights vary, periods of odd length, a library that is not there. */
static bool serves(const char *line, const struct ts_poisson *poisson)
{
	char name[32];
	const struct ts_style *style;
	const char *why;

	snprintf(name, sizeof name, "%.*s", (int)strcspn(line, " "), line);
	style = ts_style_find(&ts_tables, TS_KIND_PRESSURE, name);
	ck_assert_ptr_nonnull(style);
	return ts_pressure_suits((const struct ts_pressure_style *)style, poisson, &why);
}

static struct ts_poisson_report solve(struct tsim *sim, struct ts_instance *inst, struct problem *q)
{
	struct ts_poisson_report report;

	memset(q->solution, 0, q->grid.size * sizeof(double));
	ck_assert_msg(ts_pressure_style_of(inst)->solve(inst, sim, q->rhs, q->solution, &report) == TS_OK,
		      "%s", sim->error.message);
	return report;
}

static const struct shape {
	const char *name;
	int axes, n[3];
	double grading[3];
	bool weights;
} shapes[] = {
	{ "even", 2, { 16, 12, 1 }, { 1, 1, 1 }, false },
	{ "odd", 2, { 15, 9, 1 }, { 1, 1, 1 }, false },
	{ "primes, graded along x", 2, { 13, 11, 1 }, { 1.1, 1, 1 }, false },
	{ "graded", 2, { 20, 17, 1 }, { 1.1, 1.15, 1 }, false },
	{ "weights", 2, { 17, 20, 1 }, { 1, 1.2, 1 }, true },
	{ "narrow", 2, { 2, 1, 1 }, { 1, 1, 1 }, false },
	{ "even in space", 3, { 12, 8, 10 }, { 1, 1, 1 }, false },
	{ "graded in space", 3, { 9, 7, 10 }, { 1.1, 1, 1.15 }, false },
	{ "weights in space", 3, { 9, 8, 7 }, { 1.1, 1, 1 }, true },
	{ "thin in space", 3, { 1, 9, 3 }, { 1, 1, 1 }, false },
};

static const struct {
	const char *line;
	bool direct; /* to round-off, without weights */
} solvers[] = {
	{ "cg tolerance 1e-10", false },
	{ "direct", true },
	{ "cg preconditioner diagonal tolerance 1e-10", false },
	{ "multigrid tolerance 1e-10", false },
	{ "sor tolerance 1e-10", false },
	{ "hypre tolerance 1e-10", false }, /* where there is hypre */
};

/* rhs = div grad p for a random p, all combinations of conditions: the solution is p, or p less its mean. */
START_TEST(gives_back_what_the_operator_made)
{
	struct tsim *sim = ts_sim_new(&ts_tables);

	for (size_t s = 0; s < sizeof shapes / sizeof *shapes; s++) {
		const struct shape *shape = &shapes[s];
		int codes = shape->axes == 2 ? 25 : 125;

		for (int code = 0; code < codes; code++) {
			struct problem q;
			double scale, limit = solvers[_i].direct ? 2e-13 : 2e-8;

			make(&q, shape->axes, shape->n, code, shape->grading, shape->weights);
			if (!serves(solvers[_i].line, &q.poisson)) {
				done(&q);
				continue;
			}
			ts_poisson_apply(&q.poisson, q.p, q.rhs);
			scale = largest(&q, q.p);
			solve(sim, solver(sim, solvers[_i].line, &q.poisson), &q);
			ck_assert_msg(difference(&q, q.p, q.solution) <= limit * scale,
				      "%s, %s, conditions %d: off by %g", solvers[_i].line, shape->name, code,
				      difference(&q, q.p, q.solution) / scale);
			if (q.poisson.singular)
				ck_assert_double_le(fabs(mean(&q, q.solution)), 1e-14 * scale);
			done(&q);
		}
	}
	ts_sim_free(sim);
}
END_TEST

/* A solution that is smooth: cosines and sines that meet the conditions; the error falls with the square
 * of the width of cells. */
static double smooth_error(struct tsim *sim, const char *line, int n)
{
	const double a = 3.14159265358979323846 / 2.385;
	const int cells[3] = { n, n, 1 };
	struct problem q;
	double most = 0;

	make(&q, 2, cells, 3 + 5 * 1, (double[3]){ 1, 1, 1 }, false); /* no gradient, given; no gradient */
	if (!serves(line, &q.poisson)) {
		done(&q);
		return 1.0 / (n * n);
	}
	for (int d = 0; d < 2; d++) /* from 0, of length n/20 times 2.385 or 1.7 */
		ck_assert(q.grid.uniform[d]);
	EACH_CELL(&q.grid, i, j, k)
	{
		double x = (q.grid.centre[0][i] - q.grid.face[0][0]) * 20 / n;
		double y = (q.grid.centre[1][j] - q.grid.face[1][0]) * 20 / n;
		double b = 2 * 3.14159265358979323846 / 1.7;
		size_t at = ts_at(&q.grid, i, j, k);

		q.p[at] = cos(0.5 * a * x) * cos(b * y);
		q.rhs[at] = -(0.25 * a * a + b * b) * q.p[at] * (20.0 / n) * (20.0 / n);
	}
	solve(sim, solver(sim, line, &q.poisson), &q);
	most = difference(&q, q.p, q.solution);
	done(&q);
	return most;
}

START_TEST(of_second_order)
{
	struct tsim *sim = ts_sim_new(&ts_tables);
	double coarse = smooth_error(sim, solvers[_i].line, 24);
	double fine = smooth_error(sim, solvers[_i].line, 72);

	ck_assert_double_lt(fabs(log(coarse / fine) / log(3) - 2), 0.02);
	ts_sim_free(sim);
}
END_TEST

/* One, two and three threads: the same bits, after some iterations where these are made. */
START_TEST(threads_do_not_matter)
{
	struct tsim *sim = ts_sim_new(&ts_tables);
	char line[100];

	snprintf(line, sizeof line, "%s%s", solvers[_i].line,
		 solvers[_i].direct ? "" : " iterations 5 unfinished warn");
	sim->grain = 1;
	sim->threads = 3;

	for (size_t s = 0; s < sizeof shapes / sizeof *shapes; s++) {
		double *first;
		struct problem q;
		int code = shapes[s].axes == 2 ? 6 : 31;

		if (shapes[s].weights == solvers[_i].direct)
			continue;
		make(&q, shapes[s].axes, shapes[s].n, code, shapes[s].grading, shapes[s].weights);
		if (!serves(solvers[_i].line, &q.poisson)) {
			done(&q);
			continue;
		}
		ts_poisson_apply(&q.poisson, q.p, q.rhs);
		first = ts_grid_field(&q.grid);
		for (int threads = 1; threads <= 3; threads++) {
			q.poisson.threads = threads;
			solve(sim, solver(sim, line, &q.poisson), &q);
			if (threads == 1)
				memcpy(first, q.solution, q.grid.size * sizeof *first);
			ck_assert_msg(!memcmp(first, q.solution, q.grid.size * sizeof *first),
				      "%s, %s: %d threads", solvers[_i].line, shapes[s].name, threads);
		}
		ts_grid_field_free(first);
		done(&q);
	}
	ts_sim_free(sim);
}
END_TEST

/* Lengths with every prime factor: each transform against the operator, in one dimension. */
START_TEST(transforms_of_any_length)
{
	struct tsim *sim = ts_sim_new(&ts_tables);

	for (int n = 1; n <= 131; n += n < 50 ? 1 : 3)
		for (int code = 0; code < 5; code++) {
			const int cells[3] = { n, 3, 1 };
			struct problem q;

			make(&q, 2, cells, code + 5, (double[3]){ 1, 1.3, 1 }, false);
			ts_poisson_apply(&q.poisson, q.p, q.rhs);
			solve(sim, solver(sim, "direct", &q.poisson), &q);
			ck_assert_msg(difference(&q, q.p, q.solution) < 1e-12, "%d cells, conditions %d: %g",
				      n, code, difference(&q, q.p, q.solution));
			done(&q);
		}
	ts_sim_free(sim);
}
END_TEST

/* Complex transforms of three lines at once beside GSL's. */
START_TEST(fourier_as_gsl)
{
	static const int lengths[] = { 1, 2, 3, 5, 12, 37, 60, 61, 64, 77, 127, 128, 202, 243, 500, 509 };

	for (size_t k = 0; k < sizeof lengths / sizeof *lengths; k++) {
		enum { LINES = 3 };
		size_t n = (size_t)lengths[k];
		struct ts_rng rng = ts_rng_start(86028157, n);
		gsl_fft_complex_wavetable *table = gsl_fft_complex_wavetable_alloc(n);
		gsl_fft_complex_workspace *work = gsl_fft_complex_workspace_alloc(n);
		double *re = malloc(n * LINES * sizeof *re), *im = malloc(n * LINES * sizeof *im);
		double *theirs = malloc(2 * n * LINES * sizeof *theirs), *spare;
		struct ts_fourier f;

		ck_assert(ts_fourier_make(&f, lengths[k]) == TS_OK);
		spare = malloc(ts_fourier_work_size(&f, LINES) * sizeof *spare);
		for (size_t i = 0; i < n * LINES; i++) {
			theirs[2 * i] = re[i] = ts_rng_uniform(&rng) - 0.5;
			theirs[2 * i + 1] = im[i] = ts_rng_uniform(&rng) - 0.5;
		}
		ts_fourier_apply(&f, LINES, re, im, spare);
		for (size_t l = 0; l < LINES; l++)
			gsl_fft_complex_forward(theirs + 2 * l, LINES, n, table, work);
		for (size_t i = 0; i < n * LINES; i++) {
			double limit = 3e-16 * sqrt((double)n) * (2 + log((double)n));

			ck_assert_msg(fabs(re[i] - theirs[2 * i]) <= limit &&
					      fabs(im[i] - theirs[2 * i + 1]) <= limit,
				      "length %zu: off by %g, %g, limit %g", n, re[i] - theirs[2 * i],
				      im[i] - theirs[2 * i + 1], limit);
		}
		ts_fourier_release(&f);
		gsl_fft_complex_wavetable_free(table);
		gsl_fft_complex_workspace_free(work);
		free(re);
		free(im);
		free(theirs);
		free(spare);
	}
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("poisson");
	TCase *tcase = tcase_create("solvers");
	SRunner *runner = srunner_create(suite);
	int failed;

	suite_add_tcase(suite, tcase);
	tcase_add_loop_test(tcase, gives_back_what_the_operator_made, 0,
			    (int)(sizeof solvers / sizeof *solvers));
	tcase_add_loop_test(tcase, of_second_order, 0, (int)(sizeof solvers / sizeof *solvers));
	tcase_add_loop_test(tcase, threads_do_not_matter, 0, (int)(sizeof solvers / sizeof *solvers));
	tcase_add_test(tcase, transforms_of_any_length);
	tcase_add_test(tcase, fourier_as_gsl);
	srunner_run_all(runner, CK_NORMAL);
	failed = srunner_ntests_failed(runner);
	srunner_free(runner);
	return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
