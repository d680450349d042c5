/* Walls of meshes with `impact exact`: the first touch of a moving sphere, in all periodic images. */
#include "box/domain.h"
#include "geom/box_images.h"
#include "mesh/mesh_motion.h"
#include "mesh/mesh_sweep.h"
#include "wall/exact_surface.h"
#include "wall/mesh_wall.h"

#include "base/banned.h"

/* Whether the corners have different velocities: the mesh rotates. */
static bool rotates(const struct ts_mesh_surface *s)
{
	for (size_t t = 0; s->v && t < s->mesh.n; t++)
		for (int k = 0; k < 3; k++)
			for (int d = 0; d < 3; d++)
				if (s->v[t][k][d] != s->v[0][0][d])
					return true;
	return false;
}

static enum ts_status update(struct tsim *sim, void *shape)
{
	static const double rest[3] = { 0 };
	struct ts_mesh_wall *mw = shape;

	for (size_t k = 0; k < mw->nmeshes; k++) {
		const struct ts_mesh_surface *s = mw->mesh[k].surface;

		ts_scale(1, s->v && s->mesh.n && !rotates(s) ? s->v[0][0] : rest, mw->mesh[k].velocity);
	}
	return ts_mesh_wall_update_trees(sim, mw);
}

static enum ts_status refuse_rotation(struct tsim *sim, const struct ts_instance *mesh)
{
	return ts_fail(&sim->error, TS_STATE, &mesh->where,
		       "mesh %s rotates; walls with `impact exact` are at rest or move along a line",
		       mesh->id);
}

static enum ts_status plan(struct tsim *sim, const void *shape)
{
	const struct ts_mesh_wall *mw = shape;

	for (size_t k = 0; k < mw->nmeshes; k++)
		if (ts_mesh_mover_turns(sim, mw->mesh[k].by->id) || rotates(mw->mesh[k].surface))
			return refuse_rotation(sim, mw->mesh[k].by);
	return TS_OK;
}

static enum ts_status prepare(struct tsim *sim, void *shape)
{
	const struct ts_mesh_wall *mw = shape;

	for (size_t k = 0; k < mw->nmeshes; k++)
		if (rotates(mw->mesh[k].surface))
			return refuse_rotation(sim, mw->mesh[k].by);
	return update(sim, shape);
}

/* `path`: in the frame of the image that is looked at, relative to the mesh at the end of the step. */
static enum ts_status sweep_image(const struct ts_mesh_wall *mw, size_t k, const struct ts_sweep *path,
				  struct ts_mesh_list *list, bool *found, struct ts_exact_touch *out)
{
	const struct ts_mesh_part_of_wall *part = &mw->mesh[k];
	struct ts_mesh_hit hit;
	bool here;

	TS_TRY(ts_mesh_sweep(&part->surface->mesh, &part->tree, path, list, &here, &hit));
	if (!here || (*found && !(hit.hit.time < out->hit.time)))
		return TS_OK;
	*found = true;
	*out = (struct ts_exact_touch){ .hit = hit.hit,
					.type = (int)part->surface->type,
					.surface = k,
					.element = (size_t)hit.triangle };
	ts_scale(1, part->velocity, out->velocity);
	ts_scale(1, path->x, out->point);
	ts_axpy(hit.hit.time, path->v, out->point);
	ts_axpy(-path->radius, hit.hit.n, out->point);
	return TS_OK;
}

static enum ts_status sweep(const struct tsim *sim, const void *shape, size_t i, const struct ts_sweep *path,
			    struct ts_mesh_list *list, bool *found, struct ts_exact_touch *out)
{
	const struct ts_mesh_wall *mw = shape;
	const struct ts_box *box = &sim->domain->box;

	*found = false;
	for (size_t k = 0; k < mw->nmeshes; k++) {
		const double *v = mw->mesh[k].velocity;
		const struct ts_mesh_tree *tree = &mw->mesh[k].tree;
		struct ts_sweep relative = *path;
		struct ts_box_images images;
		double x[3];

		if (!mw->mesh[k].surface->mesh.n || !ts_in_group(sim->particles, i, mw->mesh[k].by->group))
			continue;
		ts_sub(path->v, v, relative.v);
		ts_scale(1, path->x, x);
		ts_axpy(path->span, v, x);
		images = ts_box_images(box, tree->lo[1], tree->hi[1], x, x,
				       path->radius +
					       ts_box_images_way(box, path->span * ts_norm(relative.v)));
		while (ts_box_images_next(&images)) {
			ts_box_images_place(box, images.shift, x, relative.x);
			TS_TRY(sweep_image(mw, k, &relative, list, found, out));
		}
	}
	return TS_OK;
}

const struct ts_exact_surface ts_mesh_wall_exact = {
	.plan = plan, .prepare = prepare, .update = update, .sweep = sweep
};
