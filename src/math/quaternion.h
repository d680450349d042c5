/* Unit quaternions (w, x, y, z) for rotations, and rotation matrices whose columns are the rotated
 * axes. */
#ifndef TS_MATH_QUATERNION_H
#define TS_MATH_QUATERNION_H

#include <math.h>

static inline void ts_quaternion_normalise(double q[4])
{
	double s = 1 / sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);

	for (int k = 0; k < 4; k++)
		q[k] *= s;
}

/* Composition: rotation b, followed by a. */
static inline void ts_quaternion_multiply(const double a[4], const double b[4], double out[4])
{
	out[0] = a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3];
	out[1] = a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2];
	out[2] = a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1];
	out[3] = a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0];
}

/* The product (0, w) q: twice the time derivative of q at the angular velocity w in the space frame. */
static inline void ts_quaternion_rate(const double w[3], const double q[4], double out[4])
{
	out[0] = -w[0] * q[1] - w[1] * q[2] - w[2] * q[3];
	out[1] = q[0] * w[0] + w[1] * q[3] - w[2] * q[2];
	out[2] = q[0] * w[1] + w[2] * q[1] - w[0] * q[3];
	out[3] = q[0] * w[2] + w[0] * q[2] - w[1] * q[1];
}

static inline void ts_quaternion_matrix(const double q[4], double m[3][3])
{
	double w = q[0], x = q[1], y = q[2], z = q[3];

	m[0][0] = w * w + x * x - y * y - z * z;
	m[1][1] = w * w - x * x + y * y - z * z;
	m[2][2] = w * w - x * x - y * y + z * z;
	m[0][1] = 2 * (x * y - w * z);
	m[1][0] = 2 * (x * y + w * z);
	m[0][2] = 2 * (x * z + w * y);
	m[2][0] = 2 * (x * z - w * y);
	m[1][2] = 2 * (y * z - w * x);
	m[2][1] = 2 * (y * z + w * x);
}

/* Quaternion of a right-handed rotation matrix; of the four formulas the one that divides by the
 * largest component. */
static inline void ts_quaternion_of_matrix(double m[3][3], double q[4])
{
	double square[4] = { 1 + m[0][0] + m[1][1] + m[2][2], 1 + m[0][0] - m[1][1] - m[2][2],
			     1 - m[0][0] + m[1][1] - m[2][2], 1 - m[0][0] - m[1][1] + m[2][2] };
	double part[4][4] = { { square[0], m[2][1] - m[1][2], m[0][2] - m[2][0], m[1][0] - m[0][1] },
			      { m[2][1] - m[1][2], square[1], m[0][1] + m[1][0], m[0][2] + m[2][0] },
			      { m[0][2] - m[2][0], m[0][1] + m[1][0], square[2], m[1][2] + m[2][1] },
			      { m[1][0] - m[0][1], m[0][2] + m[2][0], m[1][2] + m[2][1], square[3] } };
	int best = 0;

	for (int k = 1; k < 4; k++)
		if (square[k] > square[best])
			best = k;
	for (int k = 0; k < 4; k++)
		q[k] = part[best][k];
	ts_quaternion_normalise(q);
}

/* out = m v: from the body frame to the space frame; ts_rotate_back is the inverse. */
static inline void ts_rotate(double m[3][3], const double v[3], double out[3])
{
	for (int k = 0; k < 3; k++)
		out[k] = m[k][0] * v[0] + m[k][1] * v[1] + m[k][2] * v[2];
}

static inline void ts_rotate_back(double m[3][3], const double v[3], double out[3])
{
	for (int k = 0; k < 3; k++)
		out[k] = m[0][k] * v[0] + m[1][k] * v[1] + m[2][k] * v[2];
}

#endif
