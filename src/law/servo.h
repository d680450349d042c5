/* Stability of a surface whose speed is set after each step by the force that it has met.
 *
 * With the stiffness K and the damping C of all its contacts together, particles held (in a step of a
 * stable run they hardly move), the surface goes on by x += v h and the force of the next step is F = K x
 * + C v. The controller gives, with the gains as speed by force, v = -(p F + i h sum(F) + d (F -
 * F_last)/h). In z that is
 *
 *   z^2 (z - 1)^2 + (K h z + C (z - 1)) (p z (z - 1) + i h z^2 + d/h (z - 1)^2) = 0,
 *
 * stable where all |z| <= 1; with p alone where p (K h + 2 C) < 2: the force must not change by more
 * within a step than twice what has caused it. */
#ifndef TS_LAW_SERVO_H
#define TS_LAW_SERVO_H

#include <math.h>
#include <stdbool.h>

struct ts_servo_loop {
	double stiffness, damping; /* K, C */
	double gain[3];		   /* p, i, d: of the force, its integral over time, its rate */
};

enum { TS_SERVO_ORDER = 4 };

/* Schur and Cohn: whether all zeros of c[0] + c[1] z + ... + c[n] z^n are within the unit circle. */
static inline bool ts_zeros_within(double *c, int n)
{
	for (; n > 0; n--) {
		double first = c[0], last = c[n], next[TS_SERVO_ORDER + 1];

		if (!(fabs(first) < fabs(last)))
			return false;
		for (int k = 0; k < n; k++)
			next[k] = last * c[k + 1] - first * c[n - 1 - k];
		for (int k = 0; k < n; k++)
			c[k] = next[k] / (last * last);
	}
	return true;
}

/* With the gains times `factor`. Without integral the polynomial has a zero at 1, the place, which is
 * divided out. Growth by 1e-6 in a step is let be: an integral alone swings without end. */
static inline bool ts_servo_stable(const struct ts_servo_loop *s, double factor, double h)
{
	double p = factor * s->gain[0], i = factor * s->gain[1] * h, d = factor * s->gain[2] / h;
	double k = s->stiffness * h + s->damping, c = s->damping, scale = 1;
	int order = i > 0 ? 4 : 3;
	double g[3] = { d, -p - 2 * d, p + i + d }; /* of 1, z, z^2 */
	double a[TS_SERVO_ORDER + 1] = { 0, 0, 1, -2, 1 };

	if (order == 3) {
		a[2] = -1, a[3] = 1;
		g[0] = -d, g[1] = p + d, g[2] = 0;
	}
	for (int n = 0; n < order - 1; n++) {
		a[n] -= c * g[n];
		a[n + 1] += k * g[n];
	}
	for (int n = 0; n <= order; n++, scale *= 1 + 1e-6)
		a[n] *= scale;
	return ts_zeros_within(a, order);
}

/* By what the gains may be multiplied at most; infinite where nothing follows the speed. */
static inline double ts_servo_margin(const struct ts_servo_loop *s, double h)
{
	double low = -30, high = 30; /* natural logarithms */

	if (ts_servo_stable(s, exp(high), h))
		return INFINITY;
	while (high - low > 1e-9) {
		double middle = 0.5 * (low + high);

		if (ts_servo_stable(s, exp(middle), h))
			low = middle;
		else
			high = middle;
	}
	return exp(low);
}

#endif
