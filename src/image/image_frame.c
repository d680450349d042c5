/* A frame: camera, scene, picture. */
#include <math.h>

#include "box/domain.h"
#include "image/image_clip.h"
#include "image/image_contact.h"
#include "image/image_region.h"
#include "image/image_film.h"
#include "image/image_slice.h"
#include "image/image_surfaces.h"

#include "base/banned.h"

static enum ts_status numbers_now(struct ts_instance *self, struct tsim *sim, const struct ts_number *number,
				  size_t n, double *out)
{
	for (size_t k = 0; k < n; k++)
		TS_TRY(ts_number_now(sim, &number[k], &self->where, &out[k]));
	return TS_OK;
}

/* The middle of the picture: static at the place where it was at the definition. */
static void place(const struct ts_image *s, const struct tsim *sim, const double part[3], double out[3])
{
	const struct ts_box *box = &sim->domain->box;

	for (int d = 0; d < 3; d++) {
		const double lo = s->center.dynamic ? box->lo[d] : s->first_box[0][d];
		const double hi = s->center.dynamic ? box->hi[d] : s->first_box[1][d];

		out[d] = lo + part[d] * (hi - lo);
	}
}

/* Whether the view may change from frame to frame; then the scale follows the box, as in LAMMPS. */
static bool view_changes(const struct ts_image *s)
{
	bool changes =
		s->center.dynamic || s->view.theta.variable || s->view.phi.variable || s->zoom.variable;

	for (int d = 0; d < 3; d++)
		changes |= s->up.part[d].variable || s->center.part[d].variable;
	return changes;
}

static void scale(const struct ts_image *s, const struct tsim *sim, double zoom, struct ts_camera *out)
{
	const bool changes = view_changes(s);
	double length[3];

	for (int d = 0; d < 3; d++)
		length[d] = changes ? ts_box_length(&sim->domain->box, d)
				    : s->first_box[1][d] - s->first_box[0][d];
	ts_camera_zoom(out, length, zoom);
}

enum ts_status ts_image_camera(struct ts_instance *self, struct tsim *sim, struct ts_camera *out, bool *valid)
{
	struct ts_image *s = self->state;
	double theta, phi, zoom, up[3], part[3];

	TS_TRY(numbers_now(self, sim, &s->view.theta, 1, &theta));
	TS_TRY(numbers_now(self, sim, &s->view.phi, 1, &phi));
	TS_TRY(numbers_now(self, sim, &s->zoom, 1, &zoom));
	TS_TRY(numbers_now(self, sim, s->up.part, 3, up));
	TS_TRY(numbers_now(self, sim, s->center.part, 3, part));
	out->width = (uint32_t)s->size.width;
	out->height = (uint32_t)s->size.height;
	place(s, sim, part, out->centre);
	*valid = zoom > 0 && isfinite(zoom) && isfinite(part[0] + part[1] + part[2]) &&
		 ts_camera_look(out, theta * M_PI / 180, phi * M_PI / 180, up);
	if (*valid)
		scale(s, sim, zoom, out);
	else if (!s->told_view)
		ts_warn(&sim->log, &self->where,
			"dump %s: no picture at step %lld: its variables give zoom %g, theta %g, phi %g, up "
			"(%g %g %g), center (%g %g %g); zoom must be > 0, and up not along the view",
			self->id, (long long)sim->clock.step, zoom, theta, phi, up[0], up[1], up[2], part[0],
			part[1], part[2]);
	s->told_view |= !*valid;
	return TS_OK;
}

static struct ts_picture_style style_of(const struct ts_image *s, const struct tsim *sim)
{
	const struct ts_box *box = &sim->domain->box;
	const double largest =
		fmax(fmax(ts_box_length(box, 0), ts_box_length(box, 1)), ts_box_length(box, 2));

	return (struct ts_picture_style){
		.ground = { s->ground, s->gradient ? s->ground_top : s->ground },
		.lights = s->lights,
		.shiny = s->shiny,
		.haze = s->depthcue,
		.smooth = s->fsaa,
		.occlusion = s->ssao.on ? s->ssao.strength : 0,
		.crevice = 0.05 * largest,
		.seed = (uint32_t)s->ssao.seed,
	};
}

enum ts_status ts_image_draw(struct ts_instance *self, struct tsim *sim, bool *drawn)
{
	struct ts_image *s = self->state;
	struct ts_picture_style style;
	struct ts_camera camera;

	TS_TRY(ts_image_camera(self, sim, &camera, drawn));
	if (!*drawn)
		return TS_OK;
	TS_TRY(ts_dump_gather(self, sim, false));
	ts_scene_clear(&s->scene);
	TS_TRY(ts_image_add_clips(self, sim));
	TS_TRY(ts_image_add_particles(self, sim));
	TS_TRY(ts_image_add_bonds(self, sim));
	TS_TRY(ts_image_add_contacts(self, sim));
	TS_TRY(ts_image_add_surfaces(self, sim));
	TS_TRY(ts_image_add_regions(self, sim));
	s->scene.whole = true; /* not cut */
	TS_TRY(ts_image_add_slices(self, sim));
	TS_TRY(ts_image_add_films(self, sim));
	TS_TRY(ts_image_add_arrows(self, sim));
	*drawn = !s->unless_empty || s->scene.nspheres || s->scene.ntriangles;
	if (!*drawn)
		return TS_OK;
	TS_TRY(ts_image_add_box(self, sim));
	style = style_of(s, sim);
	if (ts_picture_draw(&s->picture, &s->scene, &camera, &style, sim->threads) != TS_OK)
		return ts_nomem(&sim->error);
	if (s->legend.on)
		ts_image_add_legends(s);
	return TS_OK;
}

void ts_image_release(struct ts_instance *self)
{
	struct ts_image *s = self->state;

	ts_image_release_surfaces(s);
	ts_image_release_slices(s);
	ts_image_release_arrows(s);
	ts_image_release_regions(s);
	ts_scene_release(&s->scene);
	ts_picture_release(&s->picture);
	ts_table_release(&s->bond.values);
	ts_free(s->drawn);
	ts_free(s->colour);
	ts_free(s->diameter);
	ts_dump_fini(self);
}
