#include "poisson/conjugate_gradient.h"

#include <math.h>

#include "base/clones.h"

#include "base/banned.h"

enum ts_status ts_conjugate_gradient_make(struct ts_conjugate_gradient *c, const struct ts_stencil *s)
{
	c->r = ts_stencil_field(s);
	c->z = ts_stencil_field(s);
	c->d = ts_stencil_field(s);
	c->q = ts_stencil_field(s);
	return c->r && c->z && c->d && c->q ? TS_OK : TS_NOMEM;
}

void ts_conjugate_gradient_release(struct ts_conjugate_gradient *c)
{
	ts_stencil_field_free(c->r);
	ts_stencil_field_free(c->z);
	ts_stencil_field_free(c->d);
	ts_stencil_field_free(c->q);
	*c = (struct ts_conjugate_gradient){ 0 };
}

TS_CLONES
static void multiply_row_elements(const double *restrict a, const double *restrict b, double *restrict out,
				  int n)
{
#pragma omp simd
	for (int i = 0; i < n; i++)
		out[i] = a[i] * b[i];
}

/* d = z + beta d */
TS_CLONES
static void update_direction(const double *restrict z, double beta, double *restrict d, int n)
{
#pragma omp simd
	for (int i = 0; i < n; i++)
		d[i] = z[i] + (beta == 0 ? 0 : beta * d[i]);
}

/* p += alpha d, r -= alpha q */
TS_CLONES
static void update_solution(double alpha, const double *restrict d, const double *restrict q,
			    double *restrict p, double *restrict r, int n)
{
#pragma omp simd
	for (int i = 0; i < n; i++) {
		p[i] += alpha * d[i];
		r[i] -= alpha * q[i];
	}
}

static void update_search_direction(const struct ts_stencil *s, const double *z, double beta, double *d)
{
	int first, end;

	ts_stencil_own(s, &first, &end);
#pragma omp parallel for num_threads(s->threads) schedule(static)
	for (int row = first; row < end; row++) {
		size_t at = ts_stencil_row(s, row);

		update_direction(z + at, beta, d + at, s->n[0]);
	}
	ts_stencil_ghosts(s, d);
}

static void update_iterate(const struct ts_stencil *s, double alpha, const struct ts_conjugate_gradient *c,
			   double *p)
{
	int first, end;

	ts_stencil_own(s, &first, &end);
#pragma omp parallel for num_threads(s->threads) schedule(static)
	for (int row = first; row < end; row++) {
		size_t at = ts_stencil_row(s, row);

		update_solution(alpha, c->d + at, c->q + at, p + at, c->r + at, s->n[0]);
	}
}

static void precondition_by_diagonal(const struct ts_stencil *s, const double *r, double *z)
{
	int first, end;

	ts_stencil_own(s, &first, &end);
#pragma omp parallel for num_threads(s->threads) schedule(static)
	for (int row = first; row < end; row++) {
		size_t at = ts_stencil_row(s, row);

		multiply_row_elements(r + at, s->inverse + at, z + at, s->n[0]);
	}
}

/* The part of the last direction in the next one. `before`, `now`: r.z of the last iteration, and of this one; flexible:
 * z.(r - r of the last one) instead, in which that difference is -step q. */
static double weight_of_last_direction(const struct ts_conjugate_gradient *c, const struct ts_stencil *s,
				       double before, double now)
{
	if (!(before > 0))
		return 0;
	return (c->flexible ? fmax(0, -c->step * ts_stencil_dot(s, c->q, c->z)) : now) / before;
}

void ts_conjugate_gradient_rehearse(struct ts_conjugate_gradient *c, const struct ts_stencil *s,
				    ts_precondition_fn *precondition, void *context, int iterations)
{
	for (int look = 0; look < 2; look++) {
		ts_stencil_ghosts(s, c->d);
		ts_stencil_max_rows(s);
	}
	for (int k = 0; k < iterations; k++) {
		if (precondition)
			precondition(context, c->r, c->z);
		ts_stencil_sum_rows(s);
		ts_stencil_ghosts(s, c->d);
		ts_stencil_sum_rows(s);
		ts_stencil_max_rows(s);
	}
}

/* One iteration; `before`: r.z of the last one, 0 to restart the direction. Returns r.z; 0 if the residual
 * cannot be reduced further, or if there is a NaN. */
static double cg_iteration(struct ts_conjugate_gradient *c, const struct ts_stencil *s,
			   ts_precondition_fn *precondition, void *context, double before, double *p)
{
	double now, curvature;

	if (precondition)
		precondition(context, c->r, c->z);
	else
		precondition_by_diagonal(s, c->r, c->z);
	now = ts_stencil_dot(s, c->r, c->z);
	update_search_direction(s, c->z, weight_of_last_direction(c, s, before, now), c->d);
	curvature = ts_stencil_apply(s, c->d, c->q);
	if (!(curvature > 0) || !(now > 0))
		return 0;
	c->step = now / curvature;
	update_iterate(s, c->step, c, p);
	return now;
}

struct ts_poisson_report ts_conjugate_gradient_solve(struct ts_conjugate_gradient *c,
						     const struct ts_stencil *s,
						     ts_precondition_fn *precondition, void *context,
						     const double *b, double *p, double largest, double goal,
						     int most)
{
	struct ts_poisson_report report = { .iterations = 0 };
	double rz = 0;

	ts_stencil_ghosts(s, p);
	report.residual = ts_stencil_residual_of_guess(s, p, b, largest, c->r);
	while (report.residual > goal && report.iterations < most) {
		rz = cg_iteration(c, s, precondition, context, rz, p);
		if (rz == 0)
			break;
		report.iterations++;
		report.residual = ts_stencil_largest(s, c->r);
		if (report.residual <= goal) { /* the updated residual has errors of its own */
			ts_stencil_ghosts(s, p);
			report.residual = ts_stencil_residual(s, p, b, c->r);
			rz = 0;
		}
	}
	return report;
}
