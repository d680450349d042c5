/* How a rigid body turns: its angular momentum L changes by the torque, its orientation follows from L
 * alone (H. Goldstein, Classical Mechanics, chapter 5). */
#ifndef TS_MATH_RIGID_TURN_H
#define TS_MATH_RIGID_TURN_H

#include "math/quaternion.h"
#include "math/vec3.h"

/* omega = R I^-1 R^T L with principal moments I; about an axis without inertia nothing turns. */
static inline void ts_rigid_omega(const double q[4], const double inertia[3], const double spin[3],
				  double omega[3])
{
	double m[3][3], body[3];

	ts_quaternion_matrix(q, m);
	ts_rotate_back(m, spin, body);
	for (int k = 0; k < 3; k++)
		body[k] = inertia[k] > 0 ? body[k] / inertia[k] : 0;
	ts_rotate(m, body, omega);
}

/* L = R I R^T omega. */
static inline void ts_rigid_spin(const double q[4], const double inertia[3], const double omega[3],
				 double spin[3])
{
	double m[3][3], body[3];

	ts_quaternion_matrix(q, m);
	ts_rotate_back(m, omega, body);
	for (int k = 0; k < 3; k++)
		body[k] *= inertia[k];
	ts_rotate(m, body, spin);
}

static inline void ts_rigid_turn_by(const double omega[3], double dt, double q[4])
{
	double rate[4];

	ts_quaternion_turn(omega, q, rate);
	for (int k = 0; k < 4; k++)
		q[k] += 0.5 * dt * rate[k];
	ts_quaternion_normalise(q);
}

/* The orientation a step dt later, L constant meanwhile: one whole step and two half steps, from which
 * Richardson's extrapolation 2 half - whole takes the first error away. `omega` is that at the start,
 * and afterwards that in the middle of the step. */
static inline void ts_rigid_turn(const double inertia[3], const double spin[3], double omega[3], double dt,
				 double q[4])
{
	double half[4] = { q[0], q[1], q[2], q[3] }, rate[4];

	ts_quaternion_turn(omega, q, rate);
	for (int k = 0; k < 4; k++) {
		q[k] += 0.5 * dt * rate[k];
		half[k] += 0.25 * dt * rate[k];
	}
	ts_quaternion_normalise(q);
	ts_quaternion_normalise(half);
	ts_rigid_omega(half, inertia, spin, omega);
	ts_rigid_turn_by(omega, 0.5 * dt, half);
	for (int k = 0; k < 4; k++)
		q[k] = 2 * half[k] - q[k];
	ts_quaternion_normalise(q);
}

#endif
