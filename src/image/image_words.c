/* Arguments of dump image. Keywords with several values are parsed by tables of their own. */
#include <math.h>
#include <string.h>

#include "box/domain.h"
#include "image/image_clip.h"
#include "image/image_contact.h"
#include "image/image_region.h"
#include "image/image_film.h"
#include "image/image_slice.h"

#include "base/banned.h"

static const char *const answers[] = { "no", "yes", NULL };
static const char *const axes[] = { "no", "yes", "lowerleft", "center", NULL };
static const char *const centers[] = { "s", "d", NULL };

#define NUMBER(T, name_, f) \
	TS_NUMBER(name_, T, f, .flags = TS_POSITIONAL, .help = "number or variable v_NAME")
static const struct ts_arg size_rows[] = {
	TS_INT("width", struct ts_image_size, width, .flags = TS_POSITIONAL, .range = TS_WITHIN, .lo = 1,
	       .hi = TS_PICTURE_EDGE, .help = "pixels"),
	TS_INT("height", struct ts_image_size, height, .flags = TS_POSITIONAL, .range = TS_WITHIN, .lo = 1,
	       .hi = TS_PICTURE_EDGE, .help = "pixels"),
	TS_ARGS_END,
};
static const struct ts_arg view_rows[] = {
	NUMBER(struct ts_image_view, "theta", theta),
	NUMBER(struct ts_image_view, "phi", phi),
	TS_ARGS_END,
};
static const struct ts_arg center_rows[] = {
	TS_ENUM("flag", struct ts_image_center, dynamic, centers, .flags = TS_POSITIONAL,
		.help = "s: of the box at the definition; d: of the present box"),
	NUMBER(struct ts_image_center, "Cx", part[0]),
	NUMBER(struct ts_image_center, "Cy", part[1]),
	NUMBER(struct ts_image_center, "Cz", part[2]),
	TS_ARGS_END,
};
static const struct ts_arg up_rows[] = {
	NUMBER(struct ts_image_up, "Ux", part[0]),
	NUMBER(struct ts_image_up, "Uy", part[1]),
	NUMBER(struct ts_image_up, "Uz", part[2]),
	TS_ARGS_END,
};
#define DIAMETER(fallback_)                                                                              \
	TS_REAL("diameter", struct ts_image_lines, diameter, .flags = TS_POSITIONAL, .range = TS_WITHIN, \
		.lo = 0, .hi = 1, .fallback = fallback_,                                                 \
		.help = "fraction of the shortest length of the box")
static const struct ts_arg box_rows[] = {
	TS_ENUM("shown", struct ts_image_lines, shown, answers, .flags = TS_POSITIONAL, .help = "yes or no"),
	DIAMETER("0.02"),
	TS_ARGS_END,
};
static const struct ts_arg axes_rows[] = {
	TS_ENUM("shown", struct ts_image_lines, shown, axes, .flags = TS_POSITIONAL,
		.help = "no, yes (lowerleft), lowerleft or center"),
	TS_REAL("length", struct ts_image_lines, length, .flags = TS_POSITIONAL, .range = TS_WITHIN, .lo = 0,
		.hi = 10, .fallback = "0.2", .help = "fraction of the lengths of the box"),
	DIAMETER("0.02"),
	TS_ARGS_END,
};
static const struct ts_arg ssao_rows[] = {
	TS_BOOL("shading", struct ts_image_occlusion, on, .flags = TS_POSITIONAL, .help = "yes or no"),
	TS_INT("seed", struct ts_image_occlusion, seed, .flags = TS_POSITIONAL, .range = TS_WITHIN, .lo = 1,
	       .hi = 2147483647, .fallback = "1", .help = "of the directions that are sampled"),
	TS_REAL("dfactor", struct ts_image_occlusion, strength, .flags = TS_POSITIONAL, .range = TS_FRACTION,
		.fallback = "0.6", .help = "strength"),
	TS_ARGS_END,
};
static const struct ts_arg legend_rows[] = {
	TS_BOOL("shown", struct ts_image_legend, on, .flags = TS_POSITIONAL, .help = "yes or no"),
	TS_WORD("title", struct ts_image_legend, title[0], .flags = TS_POSITIONAL | TS_OPTIONAL,
		.help = "text above the bar at the right"),
	TS_WORD("title2", struct ts_image_legend, title[1], .flags = TS_POSITIONAL | TS_OPTIONAL,
		.help = "text above the bar at the left"),
	TS_ARGS_END,
};
static const struct ts_arg bond_rows[] = {
	TS_WORD("color", struct ts_image_bond, colour, .flags = TS_POSITIONAL,
		.help = "atom, type, none, strain, or c_ID[k] of a compute with a row for each bond"),
	TS_WORD("width", struct ts_image_bond, width, .flags = TS_POSITIONAL,
		.help = "a length, atom, type or none"),
	TS_ARGS_END,
};

/* Which rows belong to the words of which keyword, and what stands for a keyword that is not given, in three dimensions
 * and in two. */
static const struct {
	const char *what;
	const struct ts_arg *rows;
	size_t words, values; /* offsets in struct ts_image */
	const char *fallback[2];
} keywords[] = {
#define KEYWORD(name, f, ...)                                                               \
	{                                                                                   \
		"dump image: " #name, name##_rows, offsetof(struct ts_image, name##_words), \
			offsetof(struct ts_image, f),                                       \
		{                                                                           \
			__VA_ARGS__                                                         \
		}                                                                           \
	}
	KEYWORD(size, size, "512 512", "512 512"),
	KEYWORD(view, view, "60 30", "0 0"),
	KEYWORD(center, center, "s 0.5 0.5 0.5", "s 0.5 0.5 0.5"),
	KEYWORD(up, up, "0 0 1", "0 1 0"),
	KEYWORD(box, box, "yes 0.02", "yes 0.02"),
	KEYWORD(axes, axes, "no", "no"),
	KEYWORD(ssao, ssao, "no", "no"),
	KEYWORD(legend, legend, "no", "no"),
	KEYWORD(bond, bond, "none none", "none none"),
	{ "dump image: subbox",
	  box_rows,
	  offsetof(struct ts_image, subbox_words),
	  offsetof(struct ts_image, subbox),
	  { "no", "no" } },
};

static enum ts_status read_keywords(struct ts_instance *self, struct tsim *sim)
{
	char *state = self->state;

	for (size_t k = 0; k < sizeof keywords / sizeof *keywords; k++) {
		struct ts_words words = *(struct ts_words *)(state + keywords[k].words);
		struct ts_place where = words.n ? words.word[0].place : self->where;

		if (!words.n && ts_words_split(&self->arena, keywords[k].fallback[sim->dimension == 2],
					       &where, &words) != TS_OK)
			return ts_nomem(&sim->error);
		TS_TRY(ts_args_parse(sim, keywords[k].what, keywords[k].rows, words, &where, &self->arena,
				     state + keywords[k].values));
	}
	return TS_OK;
}

/* ---- bonds */

static enum ts_status read_bond_colour(struct ts_instance *self, struct tsim *sim)
{
	struct ts_image *s = self->state;
	struct ts_image_bond *b = &s->bond;
	const struct ts_place *where = ts_instance_word(self, b->colour);
	static const struct {
		const char *name;
		enum ts_image_by by;
	} sources[] = { { "none", TS_IMAGE_NONE },
			{ "atom", TS_IMAGE_ATOM },
			{ "type", TS_IMAGE_TYPE },
			{ "strain", TS_IMAGE_NUMBER } };

	for (size_t k = 0; k < sizeof sources / sizeof *sources; k++)
		if (ts_streq(sources[k].name, b->colour)) {
			b->colour_by = sources[k].by;
			return TS_OK;
		}
	if (strncmp(b->colour, "c_", 2) != 0)
		return ts_fail(&sim->error, TS_SYNTAX, where,
			       "dump image: bond: color is '%s', expected atom, type, none, strain, or "
			       "c_ID[k]",
			       b->colour);
	b->colour_by = TS_IMAGE_VALUE;
	b->input = (struct ts_ref_input){ .name = b->colour, .where = *where };
	return ts_ref_input_resolve(sim, "dump image: bond", TS_WANT(LOCAL), &b->input);
}

static enum ts_status read_bond_width(struct ts_instance *self, struct tsim *sim)
{
	struct ts_image *s = self->state;
	struct ts_image_bond *b = &s->bond;

	b->width_by = ts_streq(b->width, "none")   ? TS_IMAGE_NONE
		      : ts_streq(b->width, "atom") ? TS_IMAGE_ATOM
		      : ts_streq(b->width, "type") ? TS_IMAGE_TYPE
						   : TS_IMAGE_NUMBER;
	if (b->width_by != TS_IMAGE_NUMBER || (ts_parse_real(b->width, &b->diameter) && b->diameter > 0))
		return TS_OK;
	return ts_fail(&sim->error, TS_SYNTAX, ts_instance_word(self, b->width),
		       "dump image: bond: width is '%s', expected a length > 0, atom, type or none",
		       b->width);
}

/* ---- checks */

/* Angles and zoom that are constant. */
static enum ts_status check_view(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_image *s = self->state;
	const struct ts_number *theta = &s->view.theta, *phi = &s->view.phi, *up = s->up.part;
	struct ts_camera camera;
	bool constant = !theta->variable && !phi->variable;

	if (!theta->variable && !(theta->value >= 0 && theta->value <= 180))
		return ts_fail(&sim->error, TS_RANGE, &self->where,
			       "dump image: view: theta is %g, expected an angle from 0 to 180 degrees",
			       theta->value);
	for (int d = 0; d < 3; d++)
		constant &= !up[d].variable;
	if (constant && !ts_camera_look(&camera, theta->value * M_PI / 180, phi->value * M_PI / 180,
					(const double[3]){ up[0].value, up[1].value, up[2].value }))
		return ts_fail(&sim->error, TS_RANGE, &self->where,
			       "dump image: up is (%g %g %g), which is zero or parallel to the view: choose "
			       "another direction",
			       up[0].value, up[1].value, up[2].value);
	return TS_OK;
}

static enum ts_status check_size(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_image *s = self->state;
	const size_t samples = (size_t)(s->size.width * s->size.height) * (s->fsaa ? 4 : 1);

	if (samples > TS_PICTURE_SAMPLES)
		return ts_fail(&sim->error, TS_RANGE, &self->where,
			       "dump image: a picture of %lld x %lld pixels%s has %zu samples, more than "
			       "%zu: choose a smaller size",
			       (long long)s->size.width, (long long)s->size.height,
			       s->fsaa ? " with fsaa" : "", samples, TS_PICTURE_SAMPLES);
	if (s->persp > 0)
		return ts_fail(&sim->error, TS_RANGE, &self->where,
			       "dump image: persp is %g, but the projection is parallel, as in LAMMPS: leave "
			       "it out",
			       s->persp);
	return TS_OK;
}

/* The value is the diameter, as in LAMMPS. */
static void warn_of_radius(struct ts_instance *self, struct tsim *sim)
{
	struct ts_image *s = self->state;

	if (s->told_radius || !ts_streq(s->quantity[TS_IMAGE_DIAMETER], "radius") || !isnan(s->adiam))
		return;
	s->told_radius = true;
	ts_warn(&sim->log, &self->where,
		"dump %s: with the diameter 'radius' spheres are drawn at half of their size; 'diameter' "
		"draws them at their size",
		self->id);
}

enum ts_status ts_image_read(struct ts_instance *self, struct tsim *sim)
{
	struct ts_image *s = self->state;
	struct ts_word name[TS_IMAGE_COLUMNS];

	ts_image_set_defaults(s);
	warn_of_radius(self, sim);
	for (int k = 0; k < TS_IMAGE_COLUMNS; k++)
		name[k] = (struct ts_word){ .text = s->quantity[k],
					    .place = *ts_instance_word(self, s->quantity[k]) };
	TS_TRY(ts_dump_columns(self, sim, (struct ts_words){ name, TS_IMAGE_COLUMNS }, false));
	if (s->common.ncolumns != TS_IMAGE_COLUMNS)
		return ts_fail(&sim->error, TS_SYNTAX, &self->where,
			       "dump image: color and diameter are one quantity each, found several columns");
	TS_TRY(read_keywords(self, sim));
	TS_TRY(read_bond_colour(self, sim));
	TS_TRY(read_bond_width(self, sim));
	TS_TRY(ts_image_read_surfaces(self, sim));
	TS_TRY(ts_image_read_clips(self, sim));
	TS_TRY(ts_image_read_slices(self, sim));
	TS_TRY(ts_image_read_films(self, sim));
	TS_TRY(ts_image_read_arrows(self, sim));
	TS_TRY(ts_image_read_contacts(self, sim));
	TS_TRY(ts_image_read_regions(self, sim));
	TS_TRY(check_view(self, sim));
	TS_TRY(check_size(self, sim));
	for (int d = 0; d < 3 && !s->placed; d++) {
		s->first_box[0][d] = sim->domain->box.lo[d];
		s->first_box[1][d] = sim->domain->box.hi[d];
	}
	s->placed = true;
	return TS_OK;
}
