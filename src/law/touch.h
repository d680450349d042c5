/* Geometry and kinematics of a contact: the input of contact laws for pairs, walls, meshes, tests and
 * outputs.
 *
 * A wall is a partner of infinite radius and mass: R* = R_i, m* = m_i, and only the lever arm of the
 * particle counts. All vectors refer to i; j gets the opposite force. */
#ifndef TS_LAW_TOUCH_H
#define TS_LAW_TOUCH_H

#include <stdbool.h>

#include "base/inline.h"
#include "math/vec3.h"

struct ts_touch {
	double n[3];	     /* unit vector from j to i */
	double distance;     /* distance of the centres; at a wall: of centre and surface */
	double overlap;	     /* delta > 0 */
	double bulge;	     /* part of the overlap by surface displacement, in models with `multi` */
	double radius[2];    /* of i and j; [1] = 0 for a wall */
	double mass[2];	     /* of i and j; [1] = 0 for a wall */
	double r_eff, m_eff; /* R*, m* */
	double arm[2];	     /* from the centres to the contact point: R - delta/2 */
	double lever[2];     /* lever arms in the slip velocity */
	double vn;	     /* (v_i - v_j).n, < 0 while approaching */
	double slip[3];	     /* tangential velocity of i relative to j at the contact point */
	double roll[3];	     /* relative angular velocity in rolling friction */
	double spin[3];	     /* w_i - w_j */
	/* liquid contents of i and j, in models with liquid bridges; [1] = 0 for a wall */
	double liquid[2];
	double solved; /* precomputed root, if ts_granular_model.solved or .rooted */
	bool wall;
};

/* Removes the component along n. */
TS_INLINE void ts_project(const double n[3], double v[3])
{
	ts_axpy(-ts_dot(v, n), n, v);
}

/* Relative velocities at the contact: slip = v_t + n x (lever_i w_i + lever_j w_j), with v = v_i - v_j.
 * n, lever, wall and distance must be set. */
TS_INLINE void ts_touch_motion(struct ts_touch *t, const double v[3], const double wi[3], const double wj[3])
{
	double turn[3], lift[3];

	t->vn = ts_dot(v, t->n);
	for (int k = 0; k < 3; k++) {
		t->slip[k] = v[k] - t->vn * t->n[k];
		t->spin[k] = wi[k] - wj[k];
		turn[k] = t->lever[0] * wi[k] + t->lever[1] * wj[k];
		t->roll[k] = t->wall ? turn[k] / t->distance : wi[k] - wj[k];
	}
	ts_cross(t->n, turn, lift);
	ts_add(t->slip, lift, t->slip);
}

#endif
