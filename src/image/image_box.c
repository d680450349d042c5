/* The edges of the simulation box and the axes of a picture. */
#include <math.h>

#include "box/domain.h"
#include "image/image.h"

#include "base/banned.h"

/* Shortest length of the box, of two dimensions in the plane. */
static double shortest(const struct tsim *sim)
{
	const struct ts_box *box = &sim->domain->box;
	double least = fmin(ts_box_length(box, 0), ts_box_length(box, 1));

	return sim->dimension == 2 ? least : fmin(least, ts_box_length(box, 2));
}

/* The twelve edges; in two dimensions those of the lower face. */
static enum ts_status add_edges(struct ts_image *s, const struct tsim *sim, double diameter,
				struct ts_colour colour)
{
	const struct ts_box *box = &sim->domain->box;
	const double *corner[2] = { box->lo, box->hi };

	for (int d = 0; d < (sim->dimension == 2 ? 2 : 3); d++)
		for (int k = 0; k < (sim->dimension == 2 ? 2 : 4); k++) {
			const int e = (d + 1) % 3, f = (d + 2) % 3;
			double a[3], b[3];

			a[d] = box->lo[d];
			b[d] = box->hi[d];
			a[e] = b[e] = corner[sim->dimension == 2 && e == 2 ? 0 : k & 1][e];
			a[f] = b[f] = corner[sim->dimension == 2 ? (f == 2 ? 0 : k) : k >> 1][f];
			TS_TRY(ts_scene_add_rod(&s->scene, a, b, 0.5 * diameter, colour));
		}
	return TS_OK;
}

/* Red, green and blue rods along x, y and z. */
static enum ts_status add_axes(struct ts_image *s, const struct tsim *sim, double unit)
{
	static const unsigned colours[3] = { 0xff0000, 0x00ff00, 0x0000ff };
	const struct ts_box *box = &sim->domain->box;
	double from[3], to[3];

	for (int d = 0; d < 3; d++)
		from[d] = s->axes.shown == TS_AXES_CENTER ? 0.5 * (box->lo[d] + box->hi[d])
							  : box->lo[d] - 0.1 * ts_box_length(box, d);
	for (int d = 0; d < (sim->dimension == 2 ? 2 : 3); d++) {
		for (int k = 0; k < 3; k++)
			to[k] = from[k];
		to[d] += s->axes.length * ts_box_length(box, d);
		TS_TRY(ts_scene_add_rod(&s->scene, from, to, 0.5 * s->axes.diameter * unit,
					ts_colour_of_hex(colours[d])));
	}
	return TS_OK;
}

enum ts_status ts_image_add_box(struct ts_instance *self, struct tsim *sim)
{
	struct ts_image *s = self->state;
	const double unit = shortest(sim);
	enum ts_status status = TS_OK;

	/* the picture does not depend on the ranks: the one subdomain is the box */
	if (s->box.shown)
		status = add_edges(s, sim, s->box.diameter * unit, s->box_colour);
	if (status == TS_OK && s->subbox.shown)
		status = add_edges(s, sim, s->subbox.diameter * unit, s->box_colour);
	if (status == TS_OK && s->axes.shown)
		status = add_axes(s, sim, unit);
	return status == TS_OK ? TS_OK : ts_nomem(&sim->error);
}
