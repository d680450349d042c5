#include "image/image_surfaces.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/banned.h"

static const struct ts_image_sort *const sorts[] = { &ts_image_mesh, &ts_image_voxel, &ts_image_wall };
enum { NSORTS = sizeof sorts / sizeof *sorts };

static const struct ts_arg rows[] = {
	TS_WORD("id", struct ts_image_surface, id, .flags = TS_POSITIONAL, .help = "of its fix, or all"),
	TS_WORD("color", struct ts_image_surface, colour_name, .flags = TS_OPTIONAL,
		.help = "name of a color"),
	TS_REAL("trans", struct ts_image_surface, opacity, .flags = TS_OPTIONAL, .range = TS_FRACTION,
		.help = "from 0, invisible, to 1, opaque"),
	TS_REAL("smooth", struct ts_image_surface, smooth, .fallback = "0", .range = TS_WITHIN, .lo = 0,
		.hi = 180,
		.help = "of meshes: edges at which the normal turns by less than this angle (degrees) are "
			"shaded as "
			"curved surfaces; 0: flat triangles"),
	TS_WORD("value", struct ts_image_surface, value, .flags = TS_OPTIONAL,
		.help = "f_ID[k] or c_ID[k] with a row for each element, or a number that the surface has"),
	TS_ARGS_END,
};

static const struct ts_image_sort *sort_of(const char *word)
{
	for (int k = 0; k < NSORTS; k++)
		if (ts_streq(sorts[k]->name, word))
			return sorts[k];
	return NULL;
}

/* ---- words */

/* Values that the surface itself has. */
static enum ts_status find_own_values(struct tsim *sim, struct ts_image_surface *s,
				      const struct ts_instance *by)
{
	if (ts_table_resize(&s->values, s->sort->elements(by), 1) != TS_OK)
		return ts_nomem(&sim->error);
	if (s->sort->value && s->sort->value(by, s->value, s->values.data))
		return TS_OK;
	s->values.rows = 0;
	return ts_fail(&sim->error, TS_UNKNOWN, &s->id_word.place,
		       "dump image: %s %s has no value '%s': a mesh has those of dump mesh/vtk (stress and "
		       "wear if it is a fix mesh/surface/stress with them, vel, temp, area ...), a height "
		       "field `height`; others are f_ID[k], c_ID[k]",
		       s->sort->name, by->id, s->value);
}

/* Whether the surface is one of those that the words name. */
static bool is_named(const struct ts_image_surface *s, const struct ts_instance *by)
{
	return ts_streq(s->id, "all") || ts_streq(s->id, by->id);
}

/* In init: all surfaces named have the value. */
static enum ts_status check_own_values(struct tsim *sim, struct ts_image_surface *s)
{
	const struct ts_instance *by;
	enum ts_status status = TS_OK;

	for (size_t k = 0; status == TS_OK && s->value && !s->input.name && (by = s->sort->next(sim, &k));)
		if (is_named(s, by))
			status = find_own_values(sim, s, by);
	ts_table_release(&s->values);
	return status;
}

static enum ts_status read_value(struct tsim *sim, struct ts_image_surface *s, const struct ts_place *where)
{
	if (!s->value || (strncmp(s->value, "f_", 2) != 0 && strncmp(s->value, "c_", 2) != 0))
		return TS_OK;
	s->input = (struct ts_ref_input){ .name = s->value, .where = *where };
	TS_TRY(ts_ref_input_resolve(sim, "dump image", TS_WANT(SURFACE), &s->input));
	if (!ts_streq(s->id, "all"))
		return TS_OK;
	return ts_fail(&sim->error, TS_SYNTAX, where,
		       "dump image: %s: '%s' belongs to one surface: name this in place of all",
		       s->sort->name, s->value);
}

static enum ts_status read_one(struct ts_instance *self, struct tsim *sim, struct ts_words words,
			       struct ts_image_surface *s)
{
	struct ts_image *d = self->state;
	char what[32];
	struct ts_table values = s->values;

	*s = (struct ts_image_surface){ .sort = sort_of(words.word[0].text), .values = values };
	snprintf(what, sizeof what, "dump image: %s", s->sort->name);
	TS_TRY(ts_args_parse(sim, what, rows, ts_words_from(words, 1), &words.word[0].place, &self->arena,
			     s));
	if (s->smooth > 0 && s->sort != &ts_image_mesh)
		return ts_fail(&sim->error, TS_SYNTAX, &words.word[0].place,
			       "dump image: %s: smooth is for meshes", s->sort->name);
	s->id_word = words.word[1];
	s->colour = ts_colour_of_hex(s->sort->colour);
	if (s->colour_name) {
		const struct ts_word colour = { .text = s->colour_name,
						.place = *ts_instance_word(self, s->colour_name) };

		TS_TRY(ts_image_find_colour(sim, d, &colour, &s->colour));
	}
	if (isnan(s->opacity))
		s->opacity = s->sort->opacity;
	TS_TRY(read_value(sim, s, s->value ? ts_instance_word(self, s->value) : &words.word[0].place));
	if (!ts_streq(s->id, "all"))
		TS_TRY(s->sort->require(sim, &s->id_word));
	return check_own_values(sim, s);
}

/* Number of words up to the next keyword. */
static size_t words_of_one(struct ts_words words)
{
	size_t n = words.n < 2 ? words.n : 2; /* the ID may have the name of a keyword */

	while (n < words.n && !sort_of(words.word[n].text))
		n++;
	return n;
}

enum ts_status ts_image_read_surfaces(struct ts_instance *self, struct tsim *sim)
{
	struct ts_image *d = self->state;
	size_t n = 0;

	if (!d->surface && d->surface_words.n) {
		d->surface = ts_arena_alloc(&self->arena, d->surface_words.n, sizeof *d->surface);
		if (!d->surface)
			return ts_nomem(&sim->error);
	}
	for (struct ts_words rest = d->surface_words; rest.n; n++) {
		const size_t used = words_of_one(rest);

		TS_TRY(read_one(self, sim, (struct ts_words){ rest.word, used }, &d->surface[n]));
		d->nsurfaces = n + 1;
		rest = ts_words_from(rest, used);
	}
	return TS_OK;
}

/* ---- frames */

static enum ts_status evaluate(struct tsim *sim, struct ts_image_surface *s, const struct ts_instance *by)
{
	const size_t n = s->sort->elements(by);

	s->values.rows = 0;
	if (!s->value)
		return TS_OK;
	if (!s->input.name)
		return find_own_values(sim, s, by);
	TS_TRY(ts_ref_input_eval(sim, &s->input, &s->values));
	if (s->values.rows == n && s->values.columns == 1)
		return TS_OK;
	return ts_fail(&sim->error, TS_STATE, &s->input.where,
		       "dump image: %s: '%s' has %zu rows, but %s has %zu elements: it belongs to another "
		       "surface, or lacks [k]",
		       s->sort->name, s->value, s->values.rows, by->id, n);
}

static enum ts_status add_one(struct ts_image *d, struct tsim *sim, struct ts_image_surface *s,
			      const struct ts_instance *by)
{
	TS_TRY(evaluate(sim, s, by));
	s->map = &d->surface_map;
	s->range[0] = INFINITY;
	s->range[1] = -INFINITY;
	ts_colour_map_extend(s->values.data, s->values.rows, 1, &s->range[0], &s->range[1]);
	ts_colour_map_range(s->map, &s->range[0], &s->range[1]);
	return s->sort->add(sim, by, &d->scene, s) == TS_OK ? TS_OK : ts_nomem(&sim->error);
}

enum ts_status ts_image_add_surfaces(struct ts_instance *self, struct tsim *sim)
{
	struct ts_image *d = self->state;

	for (size_t n = 0; n < d->nsurfaces; n++) {
		struct ts_image_surface *s = &d->surface[n];
		const struct ts_instance *by;

		for (size_t k = 0; (by = s->sort->next(sim, &k));)
			if (is_named(s, by))
				TS_TRY(add_one(d, sim, s, by));
	}
	return TS_OK;
}

void ts_image_release_surfaces(struct ts_image *d)
{
	for (size_t n = 0; n < d->nsurfaces; n++)
		ts_table_release(&d->surface[n].values);
}
