/* Fourier and cosine transforms of many lines, there and back: poisson/transform.h beside FFTW (plans by
 * estimate, lines one after the other or interleaved, whichever is faster) and GSL (real transforms, Fourier
 * only). Nanoseconds of processor time for each value, the least of several passes:
 *
 *   cc -O2 -fopenmp -Isrc bench/transforms.c BUILD/libtsim.a -lfftw3 -lgsl -lgslcblas -lz -lm && ./a.out
 */
#include <fftw3.h>
#include <gsl/gsl_fft_halfcomplex.h>
#include <gsl/gsl_fft_real.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "poisson/direct.h"

enum { LINES = 64 * TS_LINES, PASSES = 9 };

static double now(void)
{
	struct timespec t;

	clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
	return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

typedef void pass_fn(void *context, double *values, int n);

static double best_of(pass_fn *pass, void *context, double *values, int n)
{
	double best = INFINITY;

	for (int k = 0; k < PASSES; k++) {
		double start;

		for (int i = 0; i < n * LINES; i++)
			values[i] = rand() / (double)RAND_MAX;
		start = now();
		pass(context, values, n);
		best = fmin(best, (now() - start) / n / LINES);
	}
	return 1e9 * best;
}

struct ours {
	struct ts_transform transform;
	double *spare;
};

static void ours(void *context, double *values, int n)
{
	struct ours *o = context;

	for (int l = 0; l < LINES; l += TS_LINES) {
		ts_transform_forward(&o->transform, values + l * n, o->spare);
		ts_transform_backward(&o->transform, values + l * n, o->spare);
	}
}

static void theirs(void *context, double *values, int n)
{
	fftw_plan *plan = context;

	fftw_execute_r2r(plan[0], values, values);
	fftw_execute_r2r(plan[1], values, values);
	for (int i = 0; i < n * LINES; i++)
		values[i] /= n;
}

static void gsl(void *context, double *values, int n)
{
	void **c = context;

	for (int l = 0; l < LINES; l++) {
		gsl_fft_real_transform(values + l * n, 1, (size_t)n, c[0], c[2]);
		gsl_fft_halfcomplex_inverse(values + l * n, 1, (size_t)n, c[1], c[2]);
	}
}

static void make_grid(struct ts_grid *grid, struct ts_poisson *problem, int dimensions, int n, bool periodic)
{
	double *face = malloc(((size_t)n + 1) * sizeof *face);
	const double *const faces[3] = { face, face, face };
	const int cells[3] = { n, n, dimensions == 3 ? n : 1 };

	for (int i = 0; i <= n; i++)
		face[i] = i;
	if (ts_grid_make(grid, dimensions, cells, faces, (bool[3]){ periodic, periodic, periodic }) != TS_OK)
		exit(1);
	*problem = (struct ts_poisson){ .grid = grid, .singular = true, .threads = 1 };
	for (int d = 0; d < dimensions; d++)
		for (int side = 0; side < 2; side++)
			problem->condition[d][side] =
				periodic ? TS_PRESSURE_PERIODIC : TS_PRESSURE_NO_GRADIENT;
	free(face);
}

static double of_fftw(double *values, int n, bool periodic)
{
	const fftw_r2r_kind kind[2] = { periodic ? FFTW_R2HC : FFTW_REDFT10,
					periodic ? FFTW_HC2R : FFTW_REDFT01 };
	double best = INFINITY;

	for (int apart = 1; apart <= TS_LINES; apart += TS_LINES - 1) {
		const fftw_iodim64 along = { n, apart, apart };
		const fftw_iodim64 lines[2] = { { LINES / apart, (ptrdiff_t)n * apart, (ptrdiff_t)n * apart },
						{ apart, 1, 1 } };
		fftw_plan plan[2];

		for (int k = 0; k < 2; k++)
			plan[k] = fftw_plan_guru64_r2r(1, &along, 2, lines, values, values, &kind[k],
						       FFTW_ESTIMATE);
		best = fmin(best, best_of(theirs, plan, values, n));
		fftw_destroy_plan(plan[0]);
		fftw_destroy_plan(plan[1]);
	}
	return best;
}

static double of_gsl(double *values, int n)
{
	void *c[3] = { gsl_fft_real_wavetable_alloc((size_t)n),
		       gsl_fft_halfcomplex_wavetable_alloc((size_t)n),
		       gsl_fft_real_workspace_alloc((size_t)n) };

	return best_of(gsl, c, values, n);
}

static void compare(int n)
{
	double *values = fftw_malloc((size_t)n * LINES * sizeof *values);

	for (int periodic = 1; periodic >= 0; periodic--) {
		struct ts_grid grid;
		struct ts_poisson problem;
		struct ours o;

		make_grid(&grid, &problem, 2, n, periodic);
		if (ts_transform_make(&o.transform, &problem, 0) != TS_OK)
			exit(1);
		o.spare = aligned_alloc(64, (ts_transform_work_size(&o.transform) * sizeof(double) + 63) /
						    64 * 64);
		printf("%6d %-10s %8.2f %8.2f", n, periodic ? "Fourier" : "cosine",
		       best_of(ours, &o, values, n), of_fftw(values, n, periodic));
		if (periodic)
			printf(" %8.2f", of_gsl(values, n));
		printf("\n");
	}
	fftw_free(values);
}

static void whole(int dimensions, int n)
{
	struct ts_grid grid;
	struct ts_poisson problem;
	struct ts_direct solver;
	double *rhs, *p, best = INFINITY;

	make_grid(&grid, &problem, dimensions, n, false);
	rhs = ts_grid_field(&grid);
	p = ts_grid_field(&grid);
	for (size_t i = 0; i < grid.size; i++)
		rhs[i] = rand() / (double)RAND_MAX - 0.5;
	if (ts_direct_make(&solver, &problem, 1) != TS_OK)
		exit(1);
	for (int k = 0; k < 4 * PASSES; k++) {
		double start = now();

		ts_direct_solve(&solver, rhs, p);
		best = fmin(best, (now() - start) / (double)ts_grid_cells(&grid));
	}
	printf("%d^%d cells: %.1f ns a cell\n", n, dimensions, 1e9 * best);
}

int main(void)
{
	static const int lengths[] = { 64, 128, 100, 250, 61, 127, 509 };

	printf("length kind           ours     FFTW      GSL   ns a value, there and back\n");
	for (size_t k = 0; k < sizeof lengths / sizeof *lengths; k++)
		compare(lengths[k]);
	printf("pressure_style direct, a solve:\n");
	whole(3, 64);
	whole(2, 128);
	whole(3, 100);
	whole(3, 61);
	whole(2, 127);
	return 0;
}
