/* Vectors of three doubles. */
#ifndef TS_MATH_VEC3_H
#define TS_MATH_VEC3_H

#include <math.h>

static inline double ts_dot(const double a[3], const double b[3])
{
	return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline double ts_norm(const double a[3])
{
	return sqrt(ts_dot(a, a));
}

static inline void ts_cross(const double a[3], const double b[3], double out[3])
{
	double x = a[1] * b[2] - a[2] * b[1], y = a[2] * b[0] - a[0] * b[2];

	out[2] = a[0] * b[1] - a[1] * b[0];
	out[0] = x;
	out[1] = y;
}

static inline void ts_add(const double a[3], const double b[3], double out[3])
{
#pragma GCC unroll 3
	for (int d = 0; d < 3; d++)
		out[d] = a[d] + b[d];
}

static inline void ts_sub(const double a[3], const double b[3], double out[3])
{
#pragma GCC unroll 3
	for (int d = 0; d < 3; d++)
		out[d] = a[d] - b[d];
}

static inline void ts_scale(double s, const double a[3], double out[3])
{
#pragma GCC unroll 3
	for (int d = 0; d < 3; d++)
		out[d] = s * a[d];
}

/* y += s x */
static inline void ts_axpy(double s, const double x[3], double y[3])
{
#pragma GCC unroll 3
	for (int d = 0; d < 3; d++)
		y[d] += s * x[d];
}

static inline double ts_distance2(const double a[3], const double b[3])
{
	double d[3];

	ts_sub(a, b, d);
	return ts_dot(d, d);
}

#endif
