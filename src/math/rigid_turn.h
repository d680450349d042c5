/* Rotation of a rigid body: the torque changes the angular momentum L, and the orientation follows from
 * L (H. Goldstein, Classical Mechanics, chapter 5). */
#ifndef TS_MATH_RIGID_TURN_H
#define TS_MATH_RIGID_TURN_H

#include "base/inline.h"
#include "math/quaternion.h"
#include "math/vec3.h"

/* omega = R I^-1 R^T L with the principal moments I; 0 about axes without moment of inertia. spin: L. */
TS_INLINE void ts_rigid_omega(const double q[4], const double inertia[3], const double spin[3],
			      double omega[3])
{
	double m[3][3], body[3];

	ts_quaternion_matrix(q, m);
	ts_rotate_back(m, spin, body);
	for (int k = 0; k < 3; k++)
		body[k] = inertia[k] > 0 ? body[k] / inertia[k] : 0;
	ts_rotate(m, body, omega);
}

/* L = R I R^T omega. spin: L. */
TS_INLINE void ts_rigid_angular_momentum(const double q[4], const double inertia[3], const double omega[3],
					 double spin[3])
{
	double m[3][3], body[3];

	ts_quaternion_matrix(q, m);
	ts_rotate_back(m, omega, body);
	for (int k = 0; k < 3; k++)
		body[k] *= inertia[k];
	ts_rotate(m, body, spin);
}

TS_INLINE void ts_rigid_rotate_by(const double omega[3], double dt, double q[4])
{
	double rate[4];

	ts_quaternion_rate(omega, q, rate);
	for (int k = 0; k < 4; k++)
		q[k] += 0.5 * dt * rate[k];
	ts_quaternion_normalise(q);
}

/* Orientation after the time dt at constant L: one full step and two half steps, combined by Richardson
 * extrapolation 2 half - full to second order. `omega` is the angular velocity at the start, and is set
 * to that at mid-step. */
TS_INLINE void ts_rigid_advance_orientation(const double inertia[3], const double spin[3], double omega[3],
					    double dt, double q[4])
{
	double half[4] = { q[0], q[1], q[2], q[3] }, rate[4];

	ts_quaternion_rate(omega, q, rate);
	for (int k = 0; k < 4; k++) {
		q[k] += 0.5 * dt * rate[k];
		half[k] += 0.25 * dt * rate[k];
	}
	ts_quaternion_normalise(q);
	ts_quaternion_normalise(half);
	ts_rigid_omega(half, inertia, spin, omega);
	ts_rigid_rotate_by(omega, 0.5 * dt, half);
	for (int k = 0; k < 4; k++)
		q[k] = 2 * half[k] - q[k];
	ts_quaternion_normalise(q);
}

#endif
