#include "voxel/voxel_distance.h"

#include "voxel/voxel_touch.h"

#include "base/banned.h"

enum ts_status ts_voxel_space_update(struct ts_voxel_space *space, const struct ts_voxel_field *f,
				     bool *changed)
{
	struct ts_voxel_field *free = &space->field;
	double *depth;

	*changed = free->nlevels == 0;
	if (*changed) {
		*free = *f;
		free->base = -INFINITY;
		if (ts_voxel_field_make(free) != TS_OK)
			return TS_NOMEM;
	}
	depth = ts_voxel_heights(free);
	for (int64_t j = 0; j < f->n[1]; j++)
		for (int64_t i = 0; i < f->n[0]; i++) {
			double *old = &depth[j * f->n[0] + i], now = -ts_voxel_top(f, i, j);

			*changed |= now < *old || now > *old;
			*old = now;
		}
	if (*changed)
		ts_voxel_field_update(free);
	return TS_OK;
}

bool ts_voxel_inside(const struct ts_voxel_field *f, const double x[3])
{
	double z = x[f->axis[2]];

	return z > f->base &&
	       z < ts_voxel_top(f, ts_voxel_index(f, 0, x[f->axis[0]]), ts_voxel_index(f, 1, x[f->axis[1]]));
}

/* A plane at the signed distance `depth` inside, with the normal along an axis. */
static void keep_nearer(struct ts_voxel_distance *out, double depth, int axis, double normal)
{
	if (!(depth < -out->distance))
		return;
	*out = (struct ts_voxel_distance){ .distance = -depth };
	out->n[axis] = normal;
}

/* The normal at a point exactly on the surface: of the top of its column, or of the side of a higher column, of
 * which the border across index d is at x. */
static void find_normal(const struct ts_voxel_field *f, const struct ts_voxel_space *space, const double x[3],
			struct ts_voxel_distance *out)
{
	int64_t at[2] = { ts_voxel_index(f, 0, x[f->axis[0]]), ts_voxel_index(f, 1, x[f->axis[1]]) };
	double z = x[f->axis[2]];
	bool solid = z <= ts_voxel_top(f, at[0], at[1]);

	*out = (struct ts_voxel_distance){ .distance = 0 };
	for (int d = 0; d < 2; d++) {
		bool end = !f->periodic[d] &&
			   (at[d] == 0 ? space->continues[d][0] : at[d] == f->n[d] && space->continues[d][1]);
		bool before = end || solid == (z <= ts_voxel_top(f, at[0] - (d == 0), at[1] - (d == 1)));

		if (before || x[f->axis[d]] > ts_voxel_border(f, d, at[d]))
			continue;
		out->n[f->axis[d]] = solid ? -1 : 1;
		return;
	}
	out->n[f->axis[2]] = z <= f->base && !space->bottomless ? -1 : 1;
}

/* Distance of a point inside from the space outside. */
static bool find_depth(const struct ts_voxel_field *f, const struct ts_voxel_space *space, const double x[3],
		       double reach, struct ts_voxel_distance *out)
{
	double y[3] = { x[0], x[1], x[2] };
	struct ts_voxel_contact near;

	*out = (struct ts_voxel_distance){ .distance = -reach };
	y[f->axis[2]] = -y[f->axis[2]];
	if (ts_voxel_nearest(&space->field, y, reach, &near)) {
		out->distance = -near.distance;
		for (int d = 0; d < 3; d++)
			out->n[f->axis[d]] = (d < 2 ? -1 : 1) * near.n[f->axis[d]];
	}
	for (int d = 0; d < 2; d++) {
		if (f->periodic[d])
			continue;
		if (!space->continues[d][0])
			keep_nearer(out, x[f->axis[d]] - f->origin[d], f->axis[d], -1);
		if (!space->continues[d][1])
			keep_nearer(out, ts_voxel_border(f, d, f->n[d]) - x[f->axis[d]], f->axis[d], 1);
	}
	if (!space->bottomless)
		keep_nearer(out, x[f->axis[2]] - f->base, f->axis[2], -1);
	if (!(out->distance < 0))
		find_normal(f, space, x, out);
	return -out->distance < reach;
}

bool ts_voxel_signed_distance(const struct ts_voxel_field *f, const struct ts_voxel_space *space,
			      const double x[3], double reach, struct ts_voxel_distance *out)
{
	struct ts_voxel_contact solid;

	if (!ts_voxel_nearest(f, x, reach, &solid))
		return false;
	if (!(solid.distance > 0))
		return find_depth(f, space, x, reach, out);
	out->distance = solid.distance;
	for (int d = 0; d < 3; d++)
		out->n[d] = solid.n[d];
	return true;
}
