/* Keywords of dump_modify that only pictures have. */
#include <math.h>
#include <string.h>

#include "bond/bonds.h"
#include "image/image.h"
#include "particle/particles.h"

#include "base/banned.h"

void ts_image_set_defaults(struct ts_image *s)
{
	if (s->modified)
		return;
	s->modified = true;
	s->atom_map = s->bond_map = s->surface_map = s->field_map = s->contact_map = ts_colour_map_default;
	s->box_colour = ts_colour_of_hex(0xffd700); /* gold */
	s->lights = (struct ts_lights)TS_LIGHTS_DEFAULT;
	s->framerate = 24;
}

/* ---- types */

static enum ts_status reserve_types(struct ts_instance *self, struct tsim *sim, struct ts_image_types *types,
				    size_t n)
{
	if (types->colour)
		return TS_OK;
	types->colour = ts_arena_alloc(&self->arena, n + 1, sizeof *types->colour);
	types->diameter = ts_arena_alloc(&self->arena, n + 1, sizeof *types->diameter);
	types->opacity = ts_arena_alloc(&self->arena, n + 1, sizeof *types->opacity);
	if (!types->colour || !types->diameter || !types->opacity)
		return ts_nomem(&sim->error);
	types->n = n;
	for (size_t t = 0; t <= n; t++) {
		types->colour[t] = ts_colour_of_type(t - 1);
		types->diameter[t] = NAN;
		types->opacity[t] = 1;
	}
	return TS_OK;
}

/* First and last type of a word such as 2, *, 1*3. */
static enum ts_status read_types(struct tsim *sim, const struct ts_word *word,
				 const struct ts_image_types *types, size_t *lo, size_t *hi)
{
	struct ts_types range;

	if (!ts_parse_types(word->text, &range))
		return ts_fail(&sim->error, TS_SYNTAX, &word->place,
			       "dump_modify: '%s' is no type, nor a range such as * or 1*3", word->text);
	*lo = (size_t)range.lo;
	*hi = range.hi ? (size_t)range.hi : types->n;
	if (*hi > types->n || *lo > types->n)
		return ts_fail(&sim->error, TS_RANGE, &word->place,
			       "dump_modify: '%s' is beyond the last type, %zu", word->text, types->n);
	return TS_OK;
}

/* `red` or `red/green/blue`, taken in turn by the types. */
static enum ts_status set_type_colours(struct ts_instance *self, struct tsim *sim,
				       struct ts_image_types *types, const struct ts_word *word)
{
	const struct ts_image *s = self->state;
	struct ts_word part = word[1];
	char *text = ts_arena_strdup(&self->arena, word[1].text), *rest;
	size_t lo = 1, hi = 0, n = 0, first = 0;
	struct ts_colour colour[64];

	if (!text)
		return ts_nomem(&sim->error);
	TS_TRY(read_types(sim, &word[0], types, &lo, &hi));
	for (part.text = strtok_r(text, "/", &rest); part.text && n < 64;
	     part.text = strtok_r(NULL, "/", &rest))
		TS_TRY(ts_image_find_colour(sim, s, &part, &colour[n++]));
	if (!n || part.text)
		return ts_fail(&sim->error, TS_SYNTAX, &word[1].place,
			       "dump_modify: found '%s', expected a color, or up to 64 separated by /",
			       word[1].text);
	for (size_t t = lo; t <= hi; t++)
		types->colour[t] = colour[first++ % n];
	return TS_OK;
}

static enum ts_status set_type_diameters(struct tsim *sim, struct ts_image_types *types,
					 const struct ts_word *word)
{
	size_t lo = 1, hi = 0;
	double diameter;

	TS_TRY(read_types(sim, &word[0], types, &lo, &hi));
	if (!ts_parse_real(word[1].text, &diameter) || !(diameter > 0))
		return ts_fail(&sim->error, TS_SYNTAX, &word[1].place,
			       "dump_modify: diameter is '%s', expected a length > 0", word[1].text);
	for (size_t t = lo; t <= hi; t++)
		types->diameter[t] = diameter;
	return TS_OK;
}

static enum ts_status set_type_opacities(struct tsim *sim, struct ts_image_types *types,
					 const struct ts_word *word)
{
	size_t lo = 1, hi = 0;
	double opacity;

	TS_TRY(read_types(sim, &word[0], types, &lo, &hi));
	if (!ts_parse_real(word[1].text, &opacity) || !(opacity >= 0 && opacity <= 1))
		return ts_fail(&sim->error, TS_SYNTAX, &word[1].place,
			       "dump_modify: atrans: found '%s', expected a number from 0, invisible, to 1, "
			       "opaque",
			       word[1].text);
	for (size_t t = lo; t <= hi; t++)
		types->opacity[t] = opacity;
	return TS_OK;
}

/* ---- the keywords: each gets the words after its name, at least as many as its row says, and reports in *used how many
 * it has taken */

typedef enum ts_status keyword_fn(struct ts_instance *self, struct tsim *sim, struct ts_words words,
				  size_t *used);

static struct ts_image_types *types_of(struct ts_instance *self, struct tsim *sim, bool bonds,
				       enum ts_status *status)
{
	struct ts_image *s = self->state;
	struct ts_image_types *types = bonds ? &s->bond_types : &s->atom_types;
	const int n = bonds ? sim->bonds->ntypes : sim->particles->ntypes;

	*status = reserve_types(self, sim, types, n > 0 ? (size_t)n : 0);
	return types;
}

static enum ts_status acolor(struct ts_instance *self, struct tsim *sim, struct ts_words words, size_t *used)
{
	enum ts_status status;
	struct ts_image_types *types = types_of(self, sim, false, &status);

	(void)used;
	return status == TS_OK ? set_type_colours(self, sim, types, words.word) : status;
}

static enum ts_status bcolor(struct ts_instance *self, struct tsim *sim, struct ts_words words, size_t *used)
{
	enum ts_status status;
	struct ts_image_types *types = types_of(self, sim, true, &status);

	(void)used;
	return status == TS_OK ? set_type_colours(self, sim, types, words.word) : status;
}

static enum ts_status adiam(struct ts_instance *self, struct tsim *sim, struct ts_words words, size_t *used)
{
	enum ts_status status;
	struct ts_image_types *types = types_of(self, sim, false, &status);

	(void)used;
	return status == TS_OK ? set_type_diameters(sim, types, words.word) : status;
}

static enum ts_status atrans(struct ts_instance *self, struct tsim *sim, struct ts_words words, size_t *used)
{
	enum ts_status status;
	struct ts_image_types *types = types_of(self, sim, false, &status);

	(void)used;
	return status == TS_OK ? set_type_opacities(sim, types, words.word) : status;
}

static enum ts_status bdiam(struct ts_instance *self, struct tsim *sim, struct ts_words words, size_t *used)
{
	enum ts_status status;
	struct ts_image_types *types = types_of(self, sim, true, &status);

	(void)used;
	return status == TS_OK ? set_type_diameters(sim, types, words.word) : status;
}

static enum ts_status backcolor(struct ts_instance *self, struct tsim *sim, struct ts_words words,
				size_t *used)
{
	struct ts_image *s = self->state;

	(void)used;
	return ts_image_find_colour(sim, s, words.word, &s->ground);
}

static enum ts_status backcolor2(struct ts_instance *self, struct tsim *sim, struct ts_words words,
				 size_t *used)
{
	struct ts_image *s = self->state;

	(void)used;
	s->gradient = !ts_streq(words.word[0].text, "none");
	return s->gradient ? ts_image_find_colour(sim, s, words.word, &s->ground_top) : TS_OK;
}

static enum ts_status boxcolor(struct ts_instance *self, struct tsim *sim, struct ts_words words,
			       size_t *used)
{
	struct ts_image *s = self->state;

	(void)used;
	return ts_image_find_colour(sim, s, words.word, &s->box_colour);
}

/* Numbers from lo to hi. */
static enum ts_status read_numbers(struct tsim *sim, const char *what, struct ts_words words, size_t n,
				   double lo, double hi, double *out)
{
	for (size_t k = 0; k < n; k++)
		if (!ts_parse_real(words.word[k].text, &out[k]) || !(out[k] >= lo && out[k] <= hi))
			return ts_fail(&sim->error, TS_SYNTAX, &words.word[k].place,
				       "dump_modify: %s: found '%s', expected a number from %g to %g", what,
				       words.word[k].text, lo, hi);
	return TS_OK;
}

/* color NAME R G B, or color NAME 0xRRGGBB */
static enum ts_status color(struct ts_instance *self, struct tsim *sim, struct ts_words words, size_t *used)
{
	struct ts_image *s = self->state;
	struct ts_colour_name *all = ts_arena_alloc(&self->arena, s->palette.n + 1, sizeof *all);
	struct ts_colour_name new = { .name = ts_arena_strdup(&self->arena, words.word[0].text) };
	double part[3];

	if (!all || !new.name)
		return ts_nomem(&sim->error);
	if (!ts_colour_read_hex(words.word[1].text, &new.colour)) {
		if (words.n < 4)
			return ts_fail(&sim->error, TS_SYNTAX, &words.word[1].place,
				       "dump_modify: color %s: expected red, green and blue from 0 to 1, or "
				       "0xRRGGBB",
				       new.name);
		TS_TRY(read_numbers(sim, "color", ts_words_from(words, 1), 3, 0, 1, part));
		for (int k = 0; k < 3; k++)
			new.colour.c[k] = (float)part[k];
		*used = 4;
	}
	for (size_t k = 0; k < s->palette.n; k++)
		all[k] = s->palette.own[k];
	all[s->palette.n] = new;
	s->palette = (struct ts_palette){ all, s->palette.n + 1 };
	return TS_OK;
}

static enum ts_status lights(struct ts_instance *self, struct tsim *sim, struct ts_words words, size_t *used)
{
	struct ts_image *s = self->state;
	double value[4];

	(void)used;
	TS_TRY(read_numbers(sim, "lights", words, 4, 0, 1, value));
	s->lights = (struct ts_lights){ value[0], value[1], value[2], value[3] };
	return TS_OK;
}

static enum ts_status framerate(struct ts_instance *self, struct tsim *sim, struct ts_words words,
				size_t *used)
{
	(void)used;
	return read_numbers(sim, "framerate", words, 1, 0.01, 1000,
			    &((struct ts_image *)self->state)->framerate);
}

static enum ts_status bitrate(struct ts_instance *self, struct tsim *sim, struct ts_words words, size_t *used)
{
	(void)used;
	return read_numbers(sim, "bitrate", words, 1, 1, 1e6, &((struct ts_image *)self->state)->bitrate);
}

static enum ts_status amap(struct ts_instance *self, struct tsim *sim, struct ts_words words, size_t *used)
{
	return ts_image_read_map(self, sim, "amap", words, &((struct ts_image *)self->state)->atom_map, used);
}

static enum ts_status bmap(struct ts_instance *self, struct tsim *sim, struct ts_words words, size_t *used)
{
	return ts_image_read_map(self, sim, "bmap", words, &((struct ts_image *)self->state)->bond_map, used);
}

static enum ts_status smap(struct ts_instance *self, struct tsim *sim, struct ts_words words, size_t *used)
{
	return ts_image_read_map(self, sim, "smap", words, &((struct ts_image *)self->state)->surface_map,
				 used);
}

static enum ts_status gmap(struct ts_instance *self, struct tsim *sim, struct ts_words words, size_t *used)
{
	return ts_image_read_map(self, sim, "gmap", words, &((struct ts_image *)self->state)->field_map,
				 used);
}

static enum ts_status cmap(struct ts_instance *self, struct tsim *sim, struct ts_words words, size_t *used)
{
	return ts_image_read_map(self, sim, "cmap", words, &((struct ts_image *)self->state)->contact_map,
				 used);
}

static const struct {
	const char *name;
	size_t words; /* after the name */
	keyword_fn *take;
} keywords[] = {
	{ "acolor", 2, acolor }, { "adiam", 2, adiam },		{ "amap", 3, amap },
	{ "atrans", 2, atrans }, { "backcolor", 1, backcolor }, { "backcolor2", 1, backcolor2 },
	{ "bcolor", 2, bcolor }, { "bdiam", 2, bdiam },		{ "bitrate", 1, bitrate },
	{ "bmap", 3, bmap },	 { "boxcolor", 1, boxcolor },	{ "cmap", 3, cmap },
	{ "color", 2, color },	 { "framerate", 1, framerate }, { "gmap", 3, gmap },
	{ "lights", 4, lights }, { "smap", 3, smap },
};

enum ts_status ts_image_modify(struct ts_instance *self, struct tsim *sim, struct ts_words words,
			       size_t *used)
{
	ts_image_set_defaults(self->state);
	for (size_t k = 0; k < sizeof keywords / sizeof *keywords; k++) {
		if (!ts_streq(keywords[k].name, words.word[0].text))
			continue;
		if (words.n <= keywords[k].words)
			return ts_fail(&sim->error, TS_SYNTAX, &words.word[0].place,
				       "dump_modify: %s takes %zu words%s", keywords[k].name,
				       keywords[k].words, keywords[k].words == 3 ? " or more" : "");
		*used = keywords[k].words;
		TS_TRY(keywords[k].take(self, sim, ts_words_from(words, 1), used));
		++*used;
		return TS_OK;
	}
	*used = 0;
	return TS_OK;
}
