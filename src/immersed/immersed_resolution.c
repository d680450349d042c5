/* Checks of the number of cells across a body, and of height fields as bodies. */
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
	if (spheres && solid->dimensions > grid->dimensions)
		return ts_fail(&sim->error, TS_STATE, where,
			       "fix immersed/boundary: spheres in a grid of one cell along z would be "
			       "cylinders as long as the box: use `dimension 2`, with forces per depth, or "
			       "more cells along z in flow_style");
	for (size_t part = 0; part < solid->parts; part++) {
		char what[64] = "the body";
		double lo[3], hi[3], cells;
		int axis = 0;

		solid->kind->bounds(solid, part, lo, hi);
		cells = ts_solid_cells(grid, lo, hi, &axis);
		if (!(cells < (1 - ROUNDING) * least))
			continue;
		if (spheres) {
			int32_t i = ts_solid_sphere_row(solid, part);

			if (i < 0) /* the rank that has the particle checks it */
				continue;
			cells *= largest_radius_of_body(sim, (size_t)i) / sim->particles->radius[i];
			if (!(cells < (1 - ROUNDING) * least))
				continue;
			snprintf(what, sizeof what, "particle %d of diameter %.4g", sim->particles->tag[i],
				 2 * sim->particles->radius[i]);
		}
		return fail_too_small(sim, where, what, axis, cells, least);
	}
	return TS_OK;
}

void ts_immersed_warn_thin(struct tsim *sim, const struct ts_place *where, const struct ts_immersed *ib)
{
	if (ib->inside == 0)
		ts_warn(&sim->log, where,
			"fix immersed/boundary: no point of the grid is inside: the body is outside the grid "
			"or thinner than a cell, and the fluid does not feel it");
	else if (ib->thickness < 2)
		ts_warn(&sim->log, where,
			"fix immersed/boundary: the body is nowhere thicker than %.3g cells; the fluid leaks "
			"through it; use at least 2",
			ib->thickness);
}

/* ---- height fields */

static enum ts_status check_plane(struct tsim *sim, const struct ts_place *where, const char *id,
				  const struct ts_voxel_field *f)
{
	int d = f->axis[0] == 2 ? 0 : 1;

	if (f->axis[2] == 2)
		return ts_fail(&sim->error, TS_STATE, where,
			       "fix immersed/boundary: in two dimensions the heights of %s cannot be along "
			       "z; use `normal y` or `normal x`",
			       id);
	if (f->n[d] == 1 && f->periodic[d])
		return TS_OK;
	return ts_fail(&sim->error, TS_STATE, where,
		       "fix immersed/boundary: in two dimensions %s must have one column along z, as long as "
		       "the box; use `cells %s`, without `origin` and `size`",
		       id, d == 0 ? "1 N" : "N 1");
}

enum ts_status ts_immersed_check_voxels(struct tsim *sim, const struct ts_place *where, const char *id,
					const struct ts_voxel_surface *surface, const struct ts_grid *grid)
{
	const struct ts_voxel_field *f = &surface->field;

	if (grid->dimensions == 2)
		TS_TRY(check_plane(sim, where, id, f));
	for (int d = 0; d < 2; d++) {
		int axis = f->axis[d];
		double lo = f->origin[d] + surface->shift[axis];
		double hi = ts_voxel_border(f, d, f->n[d]) + surface->shift[axis];
		double from = grid->face[axis][0], to = grid->face[axis][grid->n[axis]];
		double slack = ROUNDING * (to - from);

		if (f->periodic[d] || hi - lo < to - from - slack || (lo <= from + slack && hi >= to - slack))
			continue;
		return ts_fail(&sim->error, TS_STATE, where,
			       "fix immersed/boundary: %s has moved away from an end of the grid: it reaches "
			       "from %g to %g along %c, the grid from %g to %g; make the box periodic along "
			       "%c, or the field longer by `origin` and `size`",
			       id, lo, hi, "xyz"[axis], from, to, "xyz"[axis]);
	}
	return TS_OK;
}

/* Largest step between neighbours along index d that both exist. */
static double largest_step(const struct ts_voxel_field *f, int d)
{
	double most = 0;

	for (int64_t j = 0; j < f->n[1]; j++)
		for (int64_t i = 0; i < f->n[0]; i++) {
			double step =
				fabs(ts_voxel_top(f, i, j) - ts_voxel_top(f, i + (d == 0), j + (d == 1)));

			if (isfinite(step))
				most = fmax(most, step);
		}
	return most;
}

/* Width of the widest cell along an axis. */
static double widest_cell(const struct ts_grid *grid, int axis)
{
	double most = 0;

	for (int i = 0; i < grid->n[axis]; i++)
		most = fmax(most, grid->width[axis][i]);
	return most;
}

void ts_immersed_warn_columns(struct tsim *sim, const struct ts_place *where, const char *id,
			      const struct ts_voxel_field *f, const struct ts_grid *grid)
{
	double height = widest_cell(grid, f->axis[2]);

	for (int d = 0; d < 2; d++) {
		double cell = widest_cell(grid, f->axis[d]);

		if (f->axis[d] >= grid->dimensions || f->width[d] >= (1 - ROUNDING) * cell ||
		    largest_step(f, d) <= height)
			continue;
		ts_warn(&sim->log, where,
			"fix immersed/boundary: columns of %s are %.3g cells wide along %c: the fluid does "
			"not feel those between its grid points; use two cells or more a column",
			id, f->width[d] / cell, "xyz"[f->axis[d]]);
		return;
	}
}
