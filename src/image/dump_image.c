/* Dump image: a file with a picture for each frame. */
#include <stdio.h>
#include <string.h>

#include "core/report.h"
#include "dump/dump_vtk.h"
#include "image/image.h"
#include "io/png.h"
#include "io/ppm.h"

#include "base/banned.h"

enum { MANY = 100000 /* frames of a run that are worth a warning */ };

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

/* Without a `*` the second frame replaces the first. */
static void warn_of_frames(struct ts_instance *self, struct tsim *sim)
{
	struct ts_image *s = self->state;
	const struct ts_dump_common *d = &s->common;
	const int64_t frames = d->variable ? 0 : ts_report_count(sim, d->every);

	if (d->frames == 2 && !strchr(d->file, '*'))
		ts_warn(&sim->log, &self->where,
			"dump %s: '%s' has no `*` for the step: each picture replaces the one before",
			self->id, d->file);
	if (d->frames == 1 && sim->run.inside && frames > MANY)
		ts_warn(&sim->log, &self->where, "dump %s: this run writes %lld pictures, one in %lld steps",
			self->id, (long long)frames, (long long)d->every);
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
	const double packed =
		ts_ends_with(s->common.file, ".png") ? 0.25 : 1; /* measured of packings of spheres */

	return ts_dump_price_frame(self, sim, 3 * packed * (double)s->size.width * (double)s->size.height,
				   report);
}

#define WORDS(name, f, ...) TS_SOME_KEYWORD(name, struct ts_image, f, 0, .help = __VA_ARGS__)
#define SURFACE(name_, help_)                                                                          \
	{                                                                                              \
		.name = name_, .type = TS_ARG_REST,                                                    \
		.flags = TS_OPTIONAL | TS_TO_KEYWORD | TS_REPEAT | TS_NAMED,                           \
		.offset = TS_FIELD(struct ts_image, surface_words, struct ts_words *), .help = (help_) \
	}
static const struct ts_arg args[] = {
	TS_INT("every", struct ts_image, common.every, .flags = TS_POSITIONAL, .range = TS_POSITIVE,
	       .help = "steps between frames"),
	TS_WORD("file", struct ts_image, common.file, .flags = TS_POSITIONAL | TS_WRITES,
		.help = "name of the file, ending in .png or .ppm, with a `*` for the step"),
	TS_WORD("color", struct ts_image, quantity[0], .flags = TS_POSITIONAL,
		.help = "color of the particles: type, element, or any quantity of them (vx, c_ID, f_ID, "
			"v_NAME ...)"),
	TS_WORD("diameter", struct ts_image, quantity[1], .flags = TS_POSITIONAL,
		.help = "diameter of the spheres: type, element, or any quantity; `diameter` is their own"),
	TS_BOOL("atom", struct ts_image, atoms, .fallback = "yes", .help = "whether particles are drawn"),
	TS_REAL("adiam", struct ts_image, adiam, .flags = TS_OPTIONAL, .range = TS_POSITIVE, .unit = "length",
		.help = "one diameter for all spheres, in place of DIAMETER"),
	WORDS("bond", bond_words, "COLOR WIDTH of bonds (none none)", .least = 2),
	SURFACE("mesh", "ID|all [color C] [trans T] [value f_ID[k]|stress|wear]: triangle meshes; trans from "
			"0, invisible, to 1, opaque (silver, 1)"),
	SURFACE("voxel", "ID|all [color C] [trans T] [value f_ID[k]|c_ID[k]|height]: height fields (tan, 1)"),
	SURFACE("wall", "ID|all [color C] [trans T] [value f_ID[k]]: planes and cylinders of fix wall/gran "
			"within the box (lightsteelblue, 0.3)"),
	WORDS("size", size_words, "width and height in pixels (512 512)"),
	WORDS("view", view_words,
	      "THETA PHI: direction of the camera, its angle from the z axis and that around it from the x "
	      "axis, degrees or variables (60 30; in two dimensions 0 0)"),
	WORDS("center", center_words,
	      "s|d Cx Cy Cz: point in the middle of the picture, as fractions of the box at the definition "
	      "(s) or of the frame (d); numbers or variables (s 0.5 0.5 0.5)"),
	WORDS("up", up_words,
	      "Ux Uy Uz: direction that is upwards in the picture; numbers or variables (0 0 1; in two "
	      "dimensions 0 1 0)"),
	TS_NUMBER("zoom", struct ts_image, zoom, .range = TS_POSITIVE, .fallback = "1",
		  .help = "magnification; number or variable"),
	TS_REAL("persp", struct ts_image, persp, .range = TS_NOT_NEGATIVE, .fallback = "0",
		.help = "0: the projection is parallel"),
	WORDS("box", box_words,
	      "yes|no DIAM: edges of the simulation box, their diameter as a fraction of its shortest length "
	      "(yes 0.02)"),
	WORDS("axes", axes_words,
	      "no|yes|lowerleft|center LENGTH DIAM: axes x red, y green, z blue, as fractions of the lengths "
	      "of the box (no)"),
	WORDS("subbox", subbox_words, "yes|no DIAM: as `box`, since there is one process (no)"),
	TS_REAL("shiny", struct ts_image, shiny, .range = TS_FRACTION, .fallback = "1",
		.help = "0: dull surfaces, 1: highlights"),
	TS_BOOL("fsaa", struct ts_image, fsaa, .fallback = "no",
		.help = "whether edges are smoothed: four samples per pixel"),
	WORDS("ssao", ssao_words,
	      "yes|no SEED DFACTOR: darkens crevices, with strength DFACTOR from 0 to 1 (no)"),
	TS_ARGS_END,
};

static const struct ts_saved saved[] = {
	TS_SAVE_I64(struct ts_image, common.last),
	TS_SAVE_I64(struct ts_image, common.frames),
	TS_SAVE_F64(struct ts_image, first_box),
	TS_SAVE_U8(struct ts_image, placed),
	TS_SAVED_ROWS_END,
};

static const char *const more[] = {
	"Color `type`: types have the colors red, forestgreen, blue, gold, cyan, magenta, silver, orange, "
	"lime, gray, darkred, darkgreen, darkblue, darkcyan, darkmagenta, darkgray, again after the "
	"sixteenth, or those of dump_modify acolor. `element`: types with the same name in dump_modify "
	"element have one color. Another quantity goes through the map of dump_modify amap, by default from "
	"blue at the least to red at the largest value of the frame. Values that are no numbers (NaN) are "
	"drawn in magenta, with a warning.",
	"Diameter `type` or `element`: that of dump_modify adiam; types without one have the diameter of "
	"each particle (LAMMPS: 1.0). Any other quantity is the diameter itself: `diameter` draws particles "
	"at their size, `radius` at half of it. Particles whose diameter is not positive are not drawn.",
	"Bonds are drawn if both partners are, as two halves from each partner towards the nearest image of "
	"the other: a bond across a periodic face appears at both faces. Color `atom`: each half has that of "
	"its partner; `type`: dump_modify bcolor; `strain`: length / rest length - 1; c_ID[k]: a compute "
	"such as bond/local with a row for each bond; numbers go through dump_modify bmap. Width `atom`: the "
	"lesser diameter of the partners; `type`: dump_modify bdiam, else half of the lesser diameter.",
	"Surfaces: `mesh`, `voxel` and `wall` may be given several times. With `value` the color of each "
	"triangle, column or wall is that of its number in the map of dump_modify smap, whose range min and "
	"max is that of each surface: an output with a row for each element (fix wear/finnie, fix "
	"surface/heat, compute surface/contact ...), or what the surface has: stress (normal) and wear of "
	"fix mesh/surface/stress, height. A mesh that moves is drawn where it is, removed triangles are not "
	"drawn. Of height fields with more than 262144 columns blocks of columns are drawn, with the height "
	"of their highest.",
	"The projection is parallel. The directions of the lights, the default view and the scale at zoom 1 "
	"(the height of the picture is twice the longest edge of the box) are those of LAMMPS. Particles are "
	"drawn at their wrapped positions. The picture is the same for any number of threads and after a "
	"restart. If variables give a view that does not exist (zoom <= 0), the picture is left out with a "
	"warning.",
	NULL,
};

TS_STYLE(dump, ts_style, ts_dump_image)
const struct ts_style ts_dump_image = {
	.name = "image",
	.kind = TS_KIND_DUMP,
	.summary = "Writes pictures of particles, bonds and surfaces",
	.doc = "Draws the particles of the group as spheres and writes a picture for each frame. The words "
	       "are those of dump image of LAMMPS and LIGGGHTS; doc/pictures.md shows examples. A file that "
	       "ends in .png is compressed without loss; one that ends in .ppm is not compressed.",
	.doc_more = more,
	.example = "dump view all image 1000 post/view*.png vx diameter size 1280 720 zoom 1.6 fsaa yes\n"
		   "dump_modify view pad 8 amap -1 1 cf 0 3 min blue 0.5 white max red backcolor white",
	.args = args,
	.state_size = sizeof(struct ts_image),
	.saved = saved,
	.archive = ts_dump_archive,
	.init = init,
	.modify = ts_image_modify,
	.plan = plan,
	.hook[TS_STAGE_OUTPUT] = output,
	.fini = ts_image_release,
};
