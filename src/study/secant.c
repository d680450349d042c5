#include "study/secant.h"

#include <math.h>
#include <string.h>

#include <gsl/gsl_blas.h>
#include <gsl/gsl_linalg.h>

#include "base/alloc.h"

#include "base/banned.h"

/* Weight of the previous matrix in the regression, and the least root mean square distance of pairs, in any direction,
 * that determines the matrix. */
static const double RIDGE = 1, LEAST_SPREAD = 0.02;
/* Singular values below this part of the largest one are taken as zero. */
static const double SINGULAR = 1e-6;

static double squared_length(const double *x, size_t n)
{
	double sum = 0;

	for (size_t k = 0; k < n; k++)
		sum += x[k] * x[k];
	return sum;
}

/* Minimises |A x - b| with the shortest x. A is overwritten; rows >= columns. */
static int solve(gsl_matrix *a, const gsl_vector *b, gsl_vector *x, double *smallest)
{
	gsl_matrix *v = gsl_matrix_alloc(a->size2, a->size2);
	gsl_vector *s = gsl_vector_alloc(a->size2), *work = gsl_vector_alloc(a->size2);
	int bad = !v || !s || !work;

	if (!bad)
		bad = gsl_linalg_SV_decomp(a, v, s, work);
	if (!bad) {
		for (size_t k = 0; k < s->size; k++)
			if (gsl_vector_get(s, k) <= SINGULAR * gsl_vector_get(s, 0))
				gsl_vector_set(s, k, 0); /* SV_solve leaves such directions out */
		if (smallest)
			*smallest = gsl_vector_get(s, s->size - 1);
		bad = gsl_linalg_SV_solve(a, v, s, b, x);
	}
	gsl_matrix_free(v);
	gsl_vector_free(s);
	gsl_vector_free(work);
	return bad;
}

/* Whether the pairs reach into all directions. */
static bool spans(const struct ts_secant_pair *pair, size_t pairs, size_t n)
{
	gsl_matrix *a = gsl_matrix_alloc(pairs, n);
	gsl_vector *b = gsl_vector_calloc(pairs), *x = gsl_vector_alloc(n);
	double smallest = 0;
	bool good = a && b && x;

	for (size_t i = 0; i < pairs && good; i++)
		for (size_t j = 0; j < n; j++)
			gsl_matrix_set(a, i, j, pair[i].dx[j]);
	good = good && solve(a, b, x, &smallest) == 0 && smallest >= LEAST_SPREAD;
	gsl_matrix_free(a);
	gsl_vector_free(b);
	gsl_vector_free(x);
	return good;
}

/* Row `target` of the matrix: the regression with the rows of the ridge behind those of the pairs. */
static int fit_row(const struct ts_secant_pair *pair, size_t pairs, size_t n, size_t target, double noise,
		   bool keep, double *row)
{
	size_t rows = pairs + (keep ? n : 0);
	gsl_matrix *a = gsl_matrix_calloc(rows, n);
	gsl_vector *b = gsl_vector_calloc(rows), *x = gsl_vector_alloc(n);
	int bad = !a || !b || !x;

	for (size_t i = 0; i < pairs && !bad; i++) {
		double length2 = squared_length(pair[i].dx, n),
		       w = 1 / sqrt(noise * noise + length2 * length2);

		for (size_t j = 0; j < n; j++)
			gsl_matrix_set(a, i, j, w * pair[i].dx[j]);
		gsl_vector_set(b, i, w * pair[i].df[target]);
	}
	for (size_t j = 0; j < n && keep && !bad; j++) {
		gsl_matrix_set(a, pairs + j, j, RIDGE);
		gsl_vector_set(b, pairs + j, RIDGE * row[j]);
	}
	if (!bad)
		bad = solve(a, b, x, NULL);
	for (size_t j = 0; j < n && !bad; j++)
		row[j] = gsl_vector_get(x, j);
	gsl_matrix_free(a);
	gsl_vector_free(b);
	gsl_vector_free(x);
	return bad;
}

enum ts_status ts_secant_jacobian(const struct ts_secant_pair *pair, size_t pairs, size_t variables,
				  size_t targets, double noise, bool keep, double *jacobian)
{
	if (!keep && (pairs < variables || !spans(pair, pairs, variables)))
		return TS_RANGE;
	for (size_t k = 0; k < targets; k++)
		if (fit_row(pair, pairs, variables, k, noise, keep, jacobian + k * variables))
			return TS_NOMEM;
	return TS_OK;
}

/* ---- the step */

struct search {
	size_t n, m;
	const double *jacobian, *f, *tolerance, *lo, *hi;
	double *dx, best;	      /* the best step so far, and its merit */
	double trial[TS_SECANT_MOST]; /* [n]: of the variables at their bounds */
	size_t free[TS_SECANT_MOST], nfree;
	int bad;
};

static double residual2(const struct search *s, const double *dx)
{
	double sum = 0;

	for (size_t k = 0; k < s->m; k++) {
		double r = s->f[k];

		for (size_t j = 0; j < s->n; j++)
			r += s->jacobian[k * s->n + j] * dx[j];
		sum += (r / s->tolerance[k]) * (r / s->tolerance[k]);
	}
	return sum;
}

/* Least squares over the free variables. */
static int solve_free(struct search *s)
{
	size_t rows = s->m > s->nfree ? s->m : s->nfree; /* zero rows below, as SV_decomp needs */
	gsl_matrix *a = gsl_matrix_calloc(rows, s->nfree);
	gsl_vector *b = gsl_vector_calloc(rows), *x = gsl_vector_alloc(s->nfree);
	int bad = !a || !b || !x;

	for (size_t j = 0; j < s->nfree; j++)
		s->trial[s->free[j]] = 0;
	for (size_t k = 0; k < s->m && !bad; k++) {
		double r = s->f[k];

		for (size_t j = 0; j < s->n; j++)
			r += s->jacobian[k * s->n + j] * s->trial[j];
		for (size_t j = 0; j < s->nfree; j++)
			gsl_matrix_set(a, k, j, s->jacobian[k * s->n + s->free[j]] / s->tolerance[k]);
		gsl_vector_set(b, k, -r / s->tolerance[k]);
	}
	if (!bad)
		bad = solve(a, b, x, NULL);
	for (size_t j = 0; j < s->nfree && !bad; j++)
		s->trial[s->free[j]] = gsl_vector_get(x, j);
	gsl_matrix_free(a);
	gsl_vector_free(b);
	gsl_vector_free(x);
	return bad;
}

static void judge(struct search *s)
{
	/* steps that are equally good are told apart by their length */
	static const double PREFER_SHORT = 1e-9;
	double merit;

	if (s->nfree && solve_free(s)) {
		s->bad = 1;
		return;
	}
	for (size_t j = 0; j < s->n; j++)
		if (s->trial[j] < s->lo[j] - 1e-12 || s->trial[j] > s->hi[j] + 1e-12)
			return;
	merit = residual2(s, s->trial) + PREFER_SHORT * squared_length(s->trial, s->n);
	if (merit < s->best) {
		s->best = merit;
		memcpy(s->dx, s->trial, s->n * sizeof *s->dx);
	}
}

/* Each variable from the j-th on is free, or at one of its bounds. */
static void choose(struct search *s, size_t j)
{
	if (j == s->n) {
		double kept[TS_SECANT_MOST];

		memcpy(kept, s->trial, sizeof kept);
		judge(s);
		memcpy(s->trial, kept, sizeof kept);
		return;
	}
	s->free[s->nfree++] = j;
	choose(s, j + 1);
	s->nfree--;
	s->trial[j] = s->lo[j];
	choose(s, j + 1);
	s->trial[j] = s->hi[j];
	choose(s, j + 1);
}

enum ts_status ts_secant_step(size_t variables, size_t targets, const double *jacobian, const double *f,
			      const double *tolerance, const double *lo, const double *hi, double *dx,
			      double *left)
{
	struct search s = { .n = variables,
			    .m = targets,
			    .jacobian = jacobian,
			    .f = f,
			    .tolerance = tolerance,
			    .lo = lo,
			    .hi = hi,
			    .dx = dx,
			    .best = INFINITY };

	for (size_t j = 0; j < variables; j++)
		dx[j] = 0;
	choose(&s, 0);
	*left = sqrt(residual2(&s, dx));
	return s.bad ? TS_NOMEM : isfinite(s.best) ? TS_OK : TS_RANGE;
}
