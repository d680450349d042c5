#include "rigid/rigid_share.h"

#include <string.h>

#include "math/quaternion.h"
#include "math/vec3.h"
#include "particle/group_moments.h"

#include "base/banned.h"

const struct ts_body *ts_rigid_clump_of(const struct tsim *sim, size_t i)
{
	const struct ts_body *body = ts_rigid_body_of(sim, i);

	return body && body->kind > 0 ? body : NULL;
}

void ts_rigid_share_place(const struct tsim *sim, size_t i, double x[3])
{
	const struct ts_body *clump = ts_rigid_clump_of(sim, i);

	if (clump)
		memcpy(x, clump->x, sizeof clump->x);
	else
		ts_unwrapped(sim, i, x);
}

const double *ts_rigid_share_velocity(const struct tsim *sim, size_t i)
{
	const struct ts_body *clump = ts_rigid_clump_of(sim, i);

	return clump ? clump->v : sim->particles->v[i];
}

void ts_rigid_share_spin(const struct tsim *sim, size_t i, double spin[3])
{
	const struct ts_body *clump = ts_rigid_clump_of(sim, i);

	memset(spin, 0, 3 * sizeof *spin);
	if (clump)
		ts_scale(sim->particles->mass[i] / clump->mass, clump->spin, spin);
}

/* R I R^T with the principal moments I. */
void ts_rigid_share_inertia(const struct tsim *sim, size_t i, double tensor[6])
{
	const struct ts_body *clump = ts_rigid_clump_of(sim, i);
	double m[3][3], share;

	memset(tensor, 0, 6 * sizeof *tensor);
	if (!clump)
		return;
	share = sim->particles->mass[i] / clump->mass;
	ts_quaternion_matrix(clump->q, m);
	for (int k = 0; k < 6; k++)
		for (int axis = 0; axis < 3; axis++)
			tensor[k] += share * clump->inertia[axis] * m[ts_tensor_row[k]][axis] *
				     m[ts_tensor_column[k]][axis];
}
