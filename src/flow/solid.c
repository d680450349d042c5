#include "flow/solid.h"

#include "math/vec3.h"

#include "base/banned.h"

void ts_solid_rigid_spot(const struct ts_solid_motion *motion, const double x[3],
			 struct ts_solid_spot *spot)
{
	double at[3] = { x[0], x[1], x[2] };

	if (spot->distance > 0)
		ts_axpy(-spot->distance, spot->n, at);
	ts_solid_velocity(motion, at, spot->v);
}

void ts_solid_free(struct ts_solid *solid)
{
	if (!solid)
		return;
	if (solid->kind->release)
		solid->kind->release(solid);
	ts_free(solid->motion);
	ts_free(solid);
}
