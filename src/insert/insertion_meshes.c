#include "insert/insertion_meshes.h"

#include "box/domain.h"
#include "geom/box_images.h"
#include "mesh/mesh_distance.h"
#include "mesh/mesh_surface.h"

#include "base/banned.h"

enum ts_status ts_insertion_meshes_check(struct tsim *sim, const struct ts_words *ids)
{
	struct ts_mesh_surface *surface;

	for (size_t k = 0; k < ids->n; k++)
		TS_TRY(ts_mesh_surface_require(sim, &ids->word[k], &surface));
	return TS_OK;
}

enum ts_status ts_insertion_meshes_start(struct ts_insertion_meshes *m, struct tsim *sim,
					 const struct ts_words *ids)
{
	struct ts_mesh_surface *surface;

	m->item = ts_alloc(ids->n, sizeof *m->item);
	if (!m->item)
		return ts_nomem(&sim->error);
	for (m->n = 0; m->n < ids->n; m->n++) {
		TS_TRY(ts_mesh_surface_require(sim, &ids->word[m->n], &surface));
		m->item[m->n].mesh = &surface->mesh;
		if (ts_mesh_tree_build(&m->item[m->n].tree, &surface->mesh) != TS_OK)
			return ts_nomem(&sim->error);
	}
	return TS_OK;
}

static enum ts_status touch_one(struct ts_insertion_meshes *m, struct tsim *sim,
				const struct ts_insertion_mesh *one, const double x[3], double radius,
				bool *touches)
{
	if (ts_mesh_tree_near(&one->tree, one->mesh, x, radius, &m->near) != TS_OK)
		return ts_nomem(&sim->error);
	for (size_t k = 0; k < m->near.n && !*touches; k++) {
		size_t t = (size_t)m->near.item[k];

		*touches = !ts_mesh_is_removed(one->mesh, t) && ts_mesh_distance(one->mesh, t, x) < radius;
	}
	return TS_OK;
}

enum ts_status ts_insertion_meshes_touch(struct ts_insertion_meshes *m, struct tsim *sim, const double x[3],
					 double radius, bool *touches)
{
	const struct ts_box *box = &sim->domain->box;

	*touches = false;
	for (size_t k = 0; k < m->n; k++) {
		const struct ts_mesh_tree *tree = &m->item[k].tree;
		struct ts_box_images images = ts_box_images(box, tree->lo[1], tree->hi[1], x, x, radius);
		double image[3];

		while (!*touches && ts_box_images_next(&images)) {
			ts_box_images_place(box, images.shift, x, image);
			TS_TRY(touch_one(m, sim, &m->item[k], image, radius, touches));
		}
	}
	return TS_OK;
}

void ts_insertion_meshes_release(struct ts_insertion_meshes *m)
{
	for (size_t k = 0; k < m->n; k++)
		ts_mesh_tree_release(&m->item[k].tree);
	ts_free(m->item);
	ts_free(m->near.item);
	*m = (struct ts_insertion_meshes){ 0 };
}
