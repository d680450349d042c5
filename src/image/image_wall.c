/* Plane and cylinder walls of a picture, as far as they are in the box. */
#include <math.h>

#include "box/domain.h"
#include "image/image_surfaces.h"
#include "wall/primitive_wall.h"

#include "base/banned.h"

enum { SEGMENTS = 120 /* of a cylinder */ };

static const struct ts_instance *next(const struct tsim *sim, size_t *k)
{
	const struct ts_instance *by;
	const struct ts_wall *w;

	while ((w = ts_walls_next(sim, k, &by)))
		if (w->shape && ts_primitive_wall_of(w))
			return by;
	return NULL;
}

static enum ts_status require(struct tsim *sim, const struct ts_word *id)
{
	struct ts_suggest suggest = ts_suggest_start(id->text);
	const struct ts_instance *by;

	for (size_t k = 0; (by = next(sim, &k));) {
		if (ts_streq(by->id, id->text))
			return TS_OK;
		ts_suggest_try(&suggest, by->id);
	}
	return ts_fail(&sim->error, TS_UNKNOWN, &id->place,
		       "dump image: there is no wall '%s' of planes or cylinders%s; walls of meshes and "
		       "height fields are drawn by `mesh` and `voxel`",
		       id->text, ts_suggest_text(&suggest));
}

static const struct ts_primitive_wall *wall_of(const struct ts_instance *by)
{
	return ts_primitive_wall_of(by->state);
}

static size_t elements(const struct ts_instance *by)
{
	return (size_t)wall_of(by)->n;
}

static enum ts_status add_plane(const struct ts_box *box, int dim, double position, struct ts_scene *scene,
				struct ts_colour colour, double opacity)
{
	const int e = (dim + 1) % 3, f = (dim + 2) % 3;
	double c[4][3];

	for (int k = 0; k < 4; k++) {
		c[k][dim] = position;
		c[k][e] = k == 1 || k == 2 ? box->hi[e] : box->lo[e];
		c[k][f] = k >= 2 ? box->hi[f] : box->lo[f];
	}
	return ts_scene_add_quadrangle(scene, (const double(*)[3])c, colour, opacity);
}

static enum ts_status add_cylinder(const struct ts_box *box, int axis, const double centre[3], double radius,
				   struct ts_scene *scene, struct ts_colour colour, double opacity)
{
	const int e = (axis + 1) % 3, f = (axis + 2) % 3;
	double c[4][3];

	for (int n = 0; n < SEGMENTS; n++) {
		for (int k = 0; k < 4; k++) {
			const double angle = 2 * M_PI * ((n + (k == 1 || k == 2)) % SEGMENTS) / SEGMENTS;

			c[k][axis] = k >= 2 ? box->hi[axis] : box->lo[axis];
			c[k][e] = centre[e] + radius * cos(angle);
			c[k][f] = centre[f] + radius * sin(angle);
		}
		TS_TRY(ts_scene_add_quadrangle(scene, (const double(*)[3])c, colour, opacity));
	}
	return TS_OK;
}

static enum ts_status add(struct tsim *sim, const struct ts_instance *by, struct ts_scene *scene,
			  const struct ts_image_surface *s)
{
	const struct ts_primitive_wall *w = wall_of(by);
	const struct ts_box *box = &sim->domain->box;

	for (int k = 0; k < w->n; k++) {
		const struct ts_colour colour = ts_image_element_colour(s, (size_t)k);
		const int shape = (int)w->primitive[k].shape;
		double centre[3]; /* with the displacement of `wiggle` */

		ts_primitive_wall_shape.surface.centre(by, sim, (size_t)k, centre);
		TS_TRY(shape <= TS_ZPLANE ? add_plane(box, shape, centre[shape], scene, colour, s->opacity)
					  : add_cylinder(box, shape - TS_XCYLINDER, centre,
							 w->primitive[k].radius, scene, colour, s->opacity));
	}
	return TS_OK;
}

const struct ts_image_sort ts_image_wall = {
	.name = "wall",
	.colour = 0xb0c4de, /* lightsteelblue */
	.opacity = 0.3,
	.require = require,
	.next = next,
	.elements = elements,
	.add = add,
};
