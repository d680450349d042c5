#include "polish/balance.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

#include "base/banned.h"

enum { MOST_STEPS = 400 };
static const double TOLERANCE = 1e-12, GOOD = 1e-8;

void ts_balance_step(struct ts_balance *b, double dt, double last, const double q[2][3], const double v[2][3])
{
	const double longest =
		1 + sqrt(2); /* ratio of steps up to which the method of second order is stable */
	double ratio = last > 0 && dt < longest * last ? dt / last : 0, now = -(1 + ratio) / dt, before = 0;

	b->rate = 1 / dt;
	if (ratio > 0) {
		b->rate = (1 + 2 * ratio) / ((1 + ratio) * dt);
		before = ratio * ratio / ((1 + ratio) * dt);
	}
	for (int d = 0; d < 3; d++) {
		b->velocity[d] = now * q[0][d] + before * q[1][d];
		b->acceleration[d] = now * v[0][d] + before * v[1][d];
	}
}

/* State of the search. */
struct search {
	const struct ts_balance *b;
	double q[3], rest[3], most; /* most: the largest rest relative to its scale */
};

static enum ts_status evaluate(struct search *s)
{
	double v[3], force[3], scale;

	for (int d = 0; d < 3; d++)
		v[d] = s->b->rate * s->q[d] + s->b->velocity[d];
	TS_TRY(s->b->forces(s->b->context, s->q, v, force));
	s->most = 0;
	for (int d = 0; d < 3; d++) {
		s->rest[d] = force[d] - s->b->mass[d] * (s->b->rate * v[d] + s->b->acceleration[d]);
		scale = s->b->scale[d] + 0.01 * s->b->mass[d] * s->b->rate * s->b->rate * fabs(s->q[d]);
		s->most = fmax(s->most, fabs(s->rest[d]) / scale); /* q is rounded, too */
		if (!isfinite(s->rest[d]))
			s->most = INFINITY;
	}
	return TS_OK;
}

/* Gauss' elimination with pivoting of rows; false: singular. */
static bool solve(double A[3][3], double x[3])
{
	for (int k = 0; k < 3; k++) {
		int top = k;
		double swap[3], y;

		for (int i = k + 1; i < 3; i++)
			if (fabs(A[i][k]) > fabs(A[top][k]))
				top = i;
		if (!(fabs(A[top][k]) > 1e-300))
			return false;
		memcpy(swap, A[k], sizeof swap);
		memcpy(A[k], A[top], sizeof swap);
		memcpy(A[top], swap, sizeof swap);
		y = x[k];
		x[k] = x[top];
		x[top] = y;
		for (int i = k + 1; i < 3; i++) {
			double factor = A[i][k] / A[k][k];

			for (int j = k; j < 3; j++)
				A[i][j] -= factor * A[k][j];
			x[i] -= factor * x[k];
		}
	}
	for (int k = 2; k >= 0; k--) {
		for (int j = k + 1; j < 3; j++)
			x[k] -= A[k][j] * x[j];
		x[k] /= A[k][k];
	}
	return isfinite(x[0] + x[1] + x[2]);
}

/* The matrix of Newton's method, and that of the damping: of the forces on v, in units in which it moves the body by
 * `length`. */
static enum ts_status find_matrix(const struct search *s, double matrix[3][3], double damping[3][3])
{
	const struct ts_balance *b = s->b;
	double by_q[3][3], by_v[3][3], unit, stiffness = b->scale[0] / b->length(b->context);

	TS_TRY(b->slopes(b->context, by_q, by_v));
	unit = -by_v[0][0];
	for (int i = 0; i < 3; i++)
		for (int j = 0; j < 3; j++) {
			double arm = b->scale[i] / b->scale[0], own = i == j ? arm * arm : 0;

			matrix[i][j] = -by_q[i][j] - b->rate * by_v[i][j] +
				       (i == j ? b->rate * b->rate * b->mass[i] : 0);
			damping[i][j] = stiffness * (unit > 0 ? -by_v[i][j] / unit : own);
		}
	return TS_OK;
}

static enum ts_status try_step(const struct search *from, double matrix[3][3], double damping[3][3],
			       double ridge, struct search *to)
{
	double A[3][3], x[3], reach;

	*to = *from;
	to->most = INFINITY;
	for (int i = 0; i < 3; i++) {
		x[i] = from->rest[i];
		for (int j = 0; j < 3; j++)
			A[i][j] = matrix[i][j] + ridge * damping[i][j];
	}
	for (int i = 0; i < 3; i++) /* a coordinate on which nothing acts stays */
		if (!(fabs(A[i][0]) + fabs(A[i][1]) + fabs(A[i][2]) > 0) && !(fabs(x[i]) > 0))
			A[i][i] = 1;
	if (!solve(A, x))
		return TS_OK;
	reach = from->b->reach(from->b->context, x);
	for (int d = 0; d < 3; d++)
		to->q[d] += reach * x[d];
	return evaluate(to);
}

/* Back at the best place. */
static enum ts_status finish(struct search *s, double q[3], double *rest)
{
	TS_TRY(evaluate(s));
	memcpy(q, s->q, sizeof s->q);
	*rest = s->most;
	return s->most <= GOOD ? TS_OK : TS_PHYSICS;
}

enum ts_status ts_balance_solve(const struct ts_balance *b, double q[3], double *rest)
{
	struct search s = { .b = b }, next;
	double ridge, matrix[3][3] = { { 0 } }, damping[3][3] = { { 0 } };
	bool fresh = false;

	memcpy(s.q, q, sizeof s.q);
	TS_TRY(evaluate(&s));
	ridge = s.most > 0.1 ? 1 : 0;
	for (int k = 0; k < MOST_STEPS && s.most > TOLERANCE; k++) {
		if (!fresh)
			TS_TRY(find_matrix(&s, matrix, damping));
		fresh = true;
		TS_TRY(try_step(&s, matrix, damping, ridge, &next));
		if (next.most < (ridge > 0 ? 10 * fmax(s.most, 1) : s.most)) {
			ridge *= 0.7 * fmin(fmax(next.most / s.most, 0.3), 2);
			ridge = ridge > 1e-4 ? ridge : 0;
			s = next;
			fresh = false;
			continue;
		}
		if (s.most <= GOOD && ridge == 0)
			break; /* at round-off */
		ridge = fmax(5 * ridge, 1);
		if (ridge > 1e12)
			break;
		TS_TRY(evaluate(&s)); /* reach is that of the last evaluation */
	}
	return finish(&s, q, rest);
}
