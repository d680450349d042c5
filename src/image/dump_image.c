/* Dump image: a file with a picture for each frame. */
#include <stdio.h>
#include <string.h>

#include "dump/dump_vtk.h"
#include "core/report.h"
#include "image/image.h"
#include "io/png.h"
#include "io/ppm.h"

#include "base/banned.h"

static enum ts_status check_name(struct ts_instance *self, struct tsim *sim)
{
	const char *file = ((const struct ts_image *)self->state)->common.file;
	const struct ts_place *where = ts_instance_word(self, file);

	if (ts_ends_with(file, ".png") || ts_ends_with(file, ".ppm"))
		return TS_OK;
	if (ts_ends_with(file, ".jpg") || ts_ends_with(file, ".jpeg"))
		return ts_fail(&sim->error, TS_SYNTAX, where,
			       "dump image: '%s': JPEG blurs edges and is not written; name it .png, which "
			       "is as small for such pictures, or convert .png files by `mogrify -format "
			       "jpg`",
			       file);
	return ts_fail(&sim->error, TS_SYNTAX, where,
		       "dump image: the name of the file must end in .png or .ppm, found '%s'", file);
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	TS_TRY(check_name(self, sim));
	return ts_image_read(self, sim);
}

/* Estimated size of a file, bytes: of .png files as measured of packings of spheres. */
static double file_size(const struct ts_image *s)
{
	return (ts_ends_with(s->common.file, ".png") ? 0.75 : 3) * (double)s->size.width *
	       (double)s->size.height;
}

/* Without a `*` the second frame replaces the first. */
static void warn_of_frames(struct ts_instance *self, struct tsim *sim)
{
	struct ts_image *s = self->state;
	const struct ts_dump_common *d = &s->common;
	const bool several = strchr(d->file, '*') != NULL;

	if (d->frames == 2 && !several)
		ts_warn(&sim->log, &self->where,
			"dump %s: '%s' has no `*` for the step: each picture replaces the one before",
			self->id, d->file);
	ts_image_warn_frames(self, sim, several ? file_size(s) : 0);
}

static enum ts_status output(struct ts_instance *self, struct tsim *sim)
{
	struct ts_image *s = self->state;
	const struct ts_picture *p = &s->picture;
	bool due, drawn;
	const char *path;

	TS_TRY(ts_dump_due(self, sim, &due));
	if (!due)
		return TS_OK;
	warn_of_frames(self, sim);
	TS_TRY(ts_image_draw(self, sim, &drawn));
	if (!drawn)
		return TS_OK;
	TS_TRY(ts_dump_vtk_path(&s->common, sim));
	path = ts_str_text(&s->common.path);
	if (ts_ends_with(path, ".png"))
		return ts_png_write(sim, path, ts_instance_word(self, s->common.file), p->width, p->height,
				    p->rgb);
	return ts_ppm_write(sim, path, ts_instance_word(self, s->common.file), p->width, p->height, p->rgb);
}

static enum ts_status plan(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report)
{
	const struct ts_image *s = self->state;

	report->bytes += ts_image_memory(s);
	return ts_dump_price_frame(self, sim, file_size(s), report);
}

TS_STYLE(dump, ts_style, ts_dump_image)
const struct ts_style ts_dump_image = {
	.name = "image",
	.kind = TS_KIND_DUMP,
	.dump_words = "element thresh region",
	.ranks = TS_RANKS_WHOLE,
	.due = ts_dump_may_be_due,
	.names = ts_dump_names,
	.summary = "Writes pictures of particles, bonds and surfaces",
	.purpose = "Pictures of the simulation without another program: grains, bonds, meshes, walls, slices "
		   "of the fluid. `write_dump all image FILE ...` writes a single one; the colours are set "
		   "by dump_modify.",
	.doc = "Draws the particles of the group as spheres and writes a picture for each frame. The words "
	       "are those of dump image of LAMMPS and LIGGGHTS; doc/pictures.md shows examples. A file that "
	       "ends in .png is compressed without loss; one that ends in .ppm is not compressed.",
	.doc_more = ts_image_text,
	.example = "dump view all image 1000 post/view*.png vx diameter size 1280 720 zoom 1.6 fsaa yes\n"
		   "dump_modify view pad 8 amap -1 1 cf 0 3 min blue 0.5 white max red backcolor white",
	.args = ts_image_args,
	.groups = ts_image_groups,
	.state_size = sizeof(struct ts_image),
	.saved = ts_image_saved,
	.archive = ts_dump_archive,
	.init = init,
	.modify = ts_image_modify,
	.plan = plan,
	.hook[TS_STAGE_OUTPUT] = output,
	.defers = TS_DEFERS(OUTPUT),
	.fini = ts_image_release,
};
