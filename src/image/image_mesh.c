/* Triangle meshes of a picture. */
#include "image/image_surfaces.h"
#include "load/mesh_quantities.h"
#include "mesh/mesh_surface.h"

#include "base/banned.h"

static enum ts_status require(struct tsim *sim, const struct ts_word *id)
{
	struct ts_mesh_surface *surface;

	return ts_mesh_surface_require(sim, id, &surface);
}

static const struct ts_instance *next(const struct tsim *sim, size_t *k)
{
	struct ts_instance *by = NULL;

	return ts_mesh_surface_next(sim, k, &by) ? by : NULL;
}

static size_t elements(const struct ts_instance *by)
{
	return ((const struct ts_mesh_surface *)by->state)->mesh.n;
}

static bool value(const struct ts_instance *by, const char *name, double *out)
{
	return ts_mesh_quantity_sizes(by->state, name, out);
}

static enum ts_status add(struct tsim *sim, const struct ts_instance *by, struct ts_scene *scene,
			  const struct ts_image_surface *s)
{
	const struct ts_mesh *m = &((const struct ts_mesh_surface *)by->state)->mesh;

	(void)sim;
	for (size_t t = 0; t < m->n; t++)
		if (!ts_mesh_is_removed(m, t))
			TS_TRY(ts_scene_add_triangle(scene, (const double(*)[3])m->x[t],
						     ts_image_element_colour(s, t), s->opacity));
	return TS_OK;
}

const struct ts_image_sort ts_image_mesh = {
	.name = "mesh",
	.colour = 0xc0c0c0, /* silver */
	.opacity = 1,
	.require = require,
	.next = next,
	.elements = elements,
	.value = value,
	.add = add,
};
