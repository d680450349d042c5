#include "math/symmetric3.h"

#include <math.h>

#include "base/banned.h"

/* Jacobi rotation in the plane p, q that makes m[p][q] zero. */
static void jacobi_rotate(double m[3][3], double v[3][3], int p, int q)
{
	double theta, t, c, s;

	if (!(fabs(m[p][q]) > 0))
		return;
	theta = (m[q][q] - m[p][p]) / (2 * m[p][q]);
	t = copysign(1, theta) / (fabs(theta) + sqrt(theta * theta + 1));
	c = 1 / sqrt(t * t + 1);
	s = t * c;
	for (int k = 0; k < 3; k++) {
		double a = m[k][p], b = m[k][q];

		m[k][p] = c * a - s * b;
		m[k][q] = s * a + c * b;
	}
	for (int k = 0; k < 3; k++) {
		double a = m[p][k], b = m[q][k], f = v[k][p], g = v[k][q];

		m[p][k] = c * a - s * b;
		m[q][k] = s * a + c * b;
		v[k][p] = c * f - s * g;
		v[k][q] = s * f + c * g;
	}
	m[p][q] = m[q][p] = 0;
}

void ts_symmetric3_eigen(const double a[6], double value[3], double v[3][3])
{
	double m[3][3] = { { a[0], a[3], a[4] }, { a[3], a[1], a[5] }, { a[4], a[5], a[2] } };

	for (int i = 0; i < 3; i++)
		for (int j = 0; j < 3; j++)
			v[i][j] = i == j;
	for (int sweep = 0; sweep < 30; sweep++) {
		double off = fabs(m[0][1]) + fabs(m[0][2]) + fabs(m[1][2]);
		double size = fabs(m[0][0]) + fabs(m[1][1]) + fabs(m[2][2]);

		if (!(off > 1e-17 * size))
			break;
		jacobi_rotate(m, v, 0, 1);
		jacobi_rotate(m, v, 0, 2);
		jacobi_rotate(m, v, 1, 2);
	}
	for (int i = 0; i < 3; i++)
		value[i] = m[i][i];
}

void ts_symmetric3_solve(const double a[6], const double b[3], double x[3])
{
	double value[3], v[3][3], largest = 0;

	ts_symmetric3_eigen(a, value, v);
	for (int k = 0; k < 3; k++) {
		largest = fmax(largest, fabs(value[k]));
		x[k] = 0;
	}
	for (int k = 0; k < 3; k++) {
		double along = v[0][k] * b[0] + v[1][k] * b[1] + v[2][k] * b[2];

		for (int i = 0; i < 3; i++)
			if (fabs(value[k]) > 1e-12 * largest)
				x[i] += v[i][k] * along / value[k];
	}
}
