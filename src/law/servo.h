/* Stability of a servo-controlled surface, whose velocity is set after each step from the measured
 * force.
 *
 * Let K and C be the total stiffness and damping of its contacts. With the particles fixed (in a step
 * of a stable run they hardly move), the surface moves by x += v h and the force of the next step is F
 * = K x + C v. The controller sets, with gains in velocity/force, v = -(p F + i h sum(F) + d (F -
 * F_last)/h). The characteristic equation is
 *
 *   z^2 (z - 1)^2 + (K h z + C (z - 1)) (p z (z - 1) + i h z^2 + d/h (z - 1)^2) = 0,
 *
 * stable if all |z| <= 1. With p alone this is p (K h + 2 C) < 2: within a step the force must not
 * change by more than twice the force that caused the change. */
#ifndef TS_LAW_SERVO_H
#define TS_LAW_SERVO_H

#include <math.h>
#include <stdbool.h>

struct ts_servo_loop {
	double stiffness, damping; /* K, C */
	double gain[3]; /* p, i, d: gains of the force, its time integral and its rate, velocity/force */
};

enum { TS_SERVO_ORDER = 4 };

/* Schur-Cohn test: whether all zeros of c[0] + c[1] z + ... + c[n] z^n are inside the unit circle.
 * Overwrites c. */
static inline bool ts_servo_zeros_in_unit_circle(double *c, int n)
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

/* Whether the loop is stable with the gains times `factor`. Without integral gain the polynomial has a
 * zero at 1 (the position), which is divided out. Growth by up to 1e-6 a step is accepted, as a pure
 * integral controller is only marginally stable. */
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
	return ts_servo_zeros_in_unit_circle(a, order);
}

/* Largest factor of the gains for which the loop is stable; infinite if the velocity has no effect on
 * the force. It is looked for from above: with an integral gain the test is dull for very small factors, where two zeros
 * near 1 nearly coincide. */
static inline double ts_servo_margin(const struct ts_servo_loop *s, double h)
{
	const double least = -30, most = 30, pace = 0.25; /* natural logarithms */
	double high = most, low = most - pace;

	if (ts_servo_stable(s, exp(most), h))
		return INFINITY;
	for (; low > least && !ts_servo_stable(s, exp(low), h); low -= pace)
		high = low;
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
