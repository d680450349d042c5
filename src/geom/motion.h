/* Rigid motions: y = turn (x - origin) + origin + shift, with the rotation matrix turn. */
#ifndef TS_GEOM_MOTION_H
#define TS_GEOM_MOTION_H

#include <math.h>

#include "math/vec3.h"

struct ts_motion {
	double turn[3][3], origin[3], shift[3];
};

static inline struct ts_motion ts_motion_none(void)
{
	return (struct ts_motion){ .turn = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } } };
}

/* Rotation about a unit axis by an angle in radian, right-handed: turn = c 1 + (1 - c) e e^T + s [e x]
 * (O. Rodrigues, J. Math. Pures Appl. 5 (1840) 380). */
static inline void ts_motion_set_turn(struct ts_motion *m, const double e[3], double angle)
{
	double c = cos(angle), s = sin(angle);
	const double skew[3][3] = { { 0, -e[2], e[1] }, { e[2], 0, -e[0] }, { -e[1], e[0], 0 } };

	for (int i = 0; i < 3; i++)
		for (int j = 0; j < 3; j++)
			m->turn[i][j] = c * (i == j) + (1 - c) * e[i] * e[j] + s * skew[i][j];
}

/* Rotates a direction, without translation. */
static inline void ts_motion_rotate(const struct ts_motion *m, const double x[3], double y[3])
{
	double in[3] = { x[0], x[1], x[2] };

	for (int i = 0; i < 3; i++)
		y[i] = ts_dot(m->turn[i], in);
}

static inline void ts_motion_apply(const struct ts_motion *m, const double x[3], double y[3])
{
	double arm[3];

	ts_sub(x, m->origin, arm);
	ts_motion_rotate(m, arm, y);
	for (int i = 0; i < 3; i++)
		y[i] = y[i] + m->origin[i] + m->shift[i];
}

/* Inverse motion: the point that is mapped to y. */
static inline void ts_motion_undo(const struct ts_motion *m, const double y[3], double x[3])
{
	double arm[3];

	for (int i = 0; i < 3; i++)
		arm[i] = y[i] - m->shift[i] - m->origin[i];
	for (int i = 0; i < 3; i++)
		x[i] = m->turn[0][i] * arm[0] + m->turn[1][i] * arm[1] + m->turn[2][i] * arm[2] +
		       m->origin[i];
}

/* Composition: `first`, followed by `then`; its origin is 0. The rows of turn are re-orthonormalised,
 * so that rounding errors do not accumulate. */
static inline struct ts_motion ts_motion_compose(const struct ts_motion *first, const struct ts_motion *then)
{
	static const double zero[3] = { 0 };
	struct ts_motion m = { .origin = { 0 } };
	double(*r)[3] = m.turn;

	ts_motion_apply(first, zero, m.shift);
	ts_motion_apply(then, m.shift, m.shift);
	for (int i = 0; i < 3; i++)
		for (int j = 0; j < 3; j++)
			for (int k = 0; k < 3; k++)
				r[i][j] += then->turn[i][k] * first->turn[k][j];
	ts_scale(1 / ts_norm(r[0]), r[0], r[0]);
	ts_axpy(-ts_dot(r[0], r[1]), r[0], r[1]);
	ts_scale(1 / ts_norm(r[1]), r[1], r[1]);
	ts_cross(r[0], r[1], r[2]);
	return m;
}

#endif
