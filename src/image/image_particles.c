/* Particles of a picture: spheres with the colours and diameters of the two columns of the dump. */
#include <math.h>

#include "image/image.h"
#include "particle/particles.h"

#include "base/banned.h"

struct ts_colour ts_image_type_colour(const struct ts_image_types *types, double type)
{
	const size_t t = type >= 1 ? (size_t)type : 1;

	return types->colour && t <= types->n ? types->colour[t] : ts_colour_of_type(t - 1);
}

double ts_image_type_diameter(const struct ts_image_types *types, double type)
{
	return types->diameter && type >= 1 && type <= (double)types->n ? types->diameter[(size_t)type] : NAN;
}

/* Colours by element: types that have the same name in `dump_modify element` have the colour of the first of them. */
static struct ts_colour element_colour(const struct ts_image *s, double type)
{
	const struct ts_words *names = &s->common.element;
	const size_t t = type >= 1 ? (size_t)type : 1;

	for (size_t k = 0; t <= names->n && k < t; k++)
		if (ts_streq(names->word[k].text, names->word[t - 1].text))
			return ts_image_type_colour(&s->atom_types, (double)(k + 1));
	return ts_image_type_colour(&s->atom_types, names->n ? type : 1);
}

double ts_image_type_opacity(const struct ts_image_types *types, double type)
{
	return types->opacity && type >= 1 && type <= (double)types->n ? types->opacity[(size_t)type] : 1;
}

void ts_image_warn_nan(struct ts_instance *self, struct tsim *sim, const char *what)
{
	struct ts_image *s = self->state;

	if (s->told_nan)
		return;
	s->told_nan = true;
	ts_warn(&sim->log, &self->where,
		"dump %s: '%s' has values that are no numbers; they are drawn in magenta", self->id, what);
}

static struct ts_colour colour_of(struct ts_instance *self, struct tsim *sim, size_t i)
{
	struct ts_image *s = self->state;
	const struct ts_dump_column *c = &s->common.column[TS_IMAGE_COLOUR];
	const double value = c->values.data[i];

	if (c->element)
		return element_colour(s, value);
	if (ts_streq(c->input.name, "type"))
		return ts_image_type_colour(&s->atom_types, value);
	if (isnan(value)) {
		ts_image_warn_nan(self, sim, c->input.name);
		return ts_colour_of_hex(TS_IMAGE_NAN);
	}
	return ts_colour_map_at(&s->atom_map, s->range[0][0], s->range[0][1], value);
}

/* By type or element those of dump_modify adiam, else of the particle itself. */
static double diameter_of(const struct ts_image *s, const struct tsim *sim, size_t i)
{
	const struct ts_dump_column *c = &s->common.column[TS_IMAGE_DIAMETER];
	const double own = 2 * sim->particles->radius[i];
	double given;

	if (!isnan(s->adiam))
		return s->adiam;
	if (!c->element && !ts_streq(c->input.name, "type"))
		return c->values.data[i];
	given = ts_image_type_diameter(&s->atom_types, sim->particles->type[i]);
	return isnan(given) ? own : given;
}

static void find_range(struct ts_image *s)
{
	const struct ts_dump_common *d = &s->common;
	double *range = s->range[0];

	range[0] = INFINITY;
	range[1] = -INFINITY;
	for (size_t k = 0; k < d->nrows; k++)
		ts_colour_map_extend(&d->column[TS_IMAGE_COLOUR].values.data[d->order[k]], 1, 1, &range[0],
				     &range[1]);
	ts_colour_map_range(&s->atom_map, &range[0], &range[1]);
}

enum ts_status ts_image_add_particles(struct ts_instance *self, struct tsim *sim)
{
	struct ts_image *s = self->state;
	const struct ts_dump_common *d = &s->common;
	const size_t n = sim->particles->n;

	if (TS_GROW(s->drawn, s->drawn_capacity, n) != TS_OK ||
	    TS_GROW(s->colour, s->colour_capacity, n) != TS_OK ||
	    TS_GROW(s->diameter, s->diameter_capacity, n) != TS_OK)
		return ts_nomem(&sim->error);
	for (size_t i = 0; i < n; i++)
		s->drawn[i] = 0;
	find_range(s);
	for (size_t k = 0; k < d->nrows; k++) {
		const size_t i = (size_t)d->order[k];

		s->drawn[i] = 1;
		s->colour[i] = colour_of(self, sim, i);
		s->diameter[i] = diameter_of(s, sim, i);
		if (s->atoms &&
		    ts_scene_add_sphere(&s->scene, sim->particles->x[i], 0.5 * s->diameter[i], s->colour[i],
					ts_image_type_opacity(&s->atom_types, sim->particles->type[i])) !=
			    TS_OK)
			return ts_nomem(&sim->error);
	}
	return TS_OK;
}
