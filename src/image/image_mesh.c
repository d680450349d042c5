/* Triangle meshes of a picture. */
#include <string.h>

#include "image/image_smooth.h"
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

static enum ts_status add_smooth(const struct ts_mesh *m, struct ts_scene *scene,
				 const struct ts_image_surface *s)
{
	struct ts_scene_triangle triangle = { .opacity = (float)s->opacity, .smooth = true };
	float(*normal)[3][3] = ts_alloc(m->n + 1, sizeof *normal);
	enum ts_status status = normal ? ts_image_corner_normals(m, s->smooth, normal) : TS_NOMEM;

	for (size_t t = 0; t < m->n && status == TS_OK; t++) {
		if (ts_mesh_is_removed(m, t))
			continue;
		memcpy(triangle.corner, m->x[t], sizeof triangle.corner);
		memcpy(triangle.normal, normal[t], sizeof triangle.normal);
		triangle.colour = ts_image_element_colour(s, t);
		status = ts_scene_add_painted(scene, &triangle);
	}
	ts_free(normal);
	return status;
}

static enum ts_status add(struct tsim *sim, const struct ts_instance *by, struct ts_scene *scene,
			  const struct ts_image_surface *s)
{
	const struct ts_mesh *m = &((const struct ts_mesh_surface *)by->state)->mesh;

	(void)sim;
	if (s->smooth > 0)
		return add_smooth(m, scene, s);
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
