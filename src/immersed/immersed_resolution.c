/* Check of the number of cells across a body. */
#include <math.h>
#include <stdio.h>

#include "immersed/immersed.h"
#include "particle/particles.h"
#include "rigid/rigid.h"

#include "base/banned.h"

/* Relative tolerance for round-off of lengths in the script. */
static const double ROUNDING = 1e-9;

/* Radius of the largest sphere of the body to which particle i belongs. */
static double largest_radius_of_body(const struct tsim *sim, size_t i)
{
	const struct ts_particles *p = sim->particles;
	const struct ts_body *body = ts_rigid_body_of(sim, i);
	const struct ts_rigid *rigid = sim->rigid;
	double most = p->radius[i];
	size_t b;

	if (!body)
		return most;
	b = (size_t)(body - rigid->body);
	for (size_t k = rigid->start[b]; k < rigid->start[b + 1]; k++)
		most = fmax(most, p->radius[rigid->member[k]]);
	return most;
}

static enum ts_status fail_too_small(struct tsim *sim, const struct ts_place *where, const char *what,
				     int axis, double cells, double least)
{
	return ts_fail(&sim->error, TS_RANGE, where,
		       "fix immersed/boundary: %s is %.3g cells across along %c, fewer than %g: its drag and "
		       "torque would be wrong by 10 %% and more; make the grid finer there, or say "
		       "`min_cells %g` to take it as it is",
		       what, cells, "xyz"[axis], least, floor(10 * cells) / 10);
}

enum ts_status ts_immersed_check_size(struct tsim *sim, const struct ts_place *where,
				      const struct ts_solid *solid, const struct ts_grid *grid, bool spheres,
				      double least)
{
	if (spheres)
		TS_TRY(ts_rigid_list(sim));
	for (size_t part = 0; part < solid->parts; part++) {
		char what[64] = "the body";
		double lo[3], hi[3], cells;
		int axis = 0;

		solid->kind->bounds(solid, part, lo, hi);
		cells = ts_solid_cells(grid, lo, hi, &axis);
		if (!(cells < (1 - ROUNDING) * least))
			continue;
		if (spheres) {
			size_t i = (size_t)ts_solid_sphere_row(solid, part);

			cells *= largest_radius_of_body(sim, i) / sim->particles->radius[i];
			if (!(cells < (1 - ROUNDING) * least))
				continue;
			snprintf(what, sizeof what, "particle %d of diameter %.4g", sim->particles->tag[i],
				 2 * sim->particles->radius[i]);
		}
		return fail_too_small(sim, where, what, axis, cells, least);
	}
	return TS_OK;
}
