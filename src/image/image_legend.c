/* Legends: the colour maps of a picture, the first two of them, at the right and at the left edge. */
#include "image/image_contact.h"
#include "image/image_film.h"
#include "image/image_slice.h"
#include "image/image_surfaces.h"
#include "render/legend.h"

#include "base/banned.h"

struct legends {
	struct ts_image *d;
	struct ts_colour ink, ground;
	int n;
};

static void add(struct legends *l, const struct ts_colour_map *map, const double range[2], const char *name)
{
	const char *title;

	if (l->n >= TS_LEGEND_SIDES)
		return;
	title = l->d->legend.title[l->n];
	ts_legend_draw(&l->d->picture, (enum ts_legend_side)l->n, map, range[0], range[1],
		       title ? title : name, l->ink, l->ground);
	l->n++;
}

static void add_contacts(struct legends *l)
{
	for (size_t n = 0; n < l->d->ncontacts; n++)
		if (ts_streq(l->d->contacts[n].colour_name, "force")) {
			add(l, &l->d->contact_map, l->d->contact_range, "force");
			return;
		}
}

static void add_slices(struct legends *l)
{
	for (size_t n = 0; n < l->d->nslices; n++) {
		const struct ts_image_slice *s = &l->d->slice[n];

		if (!ts_streq(s->quantity, "none")) {
			add(l, &l->d->field_map, (const double[]){ s->scale.lo, s->scale.hi }, s->quantity);
			return;
		}
	}
}

static void add_films(struct legends *l)
{
	const struct ts_image_film *film = l->d->film;

	if (l->d->nfilms)
		add(l, &l->d->field_map, (const double[]){ film->scale.lo, film->scale.hi },
		    ts_image_film_quantity(film));
}

static void add_surfaces(struct legends *l)
{
	for (size_t n = 0; n < l->d->nsurfaces; n++) {
		const struct ts_image_surface *s = &l->d->surface[n];

		if (s->values.rows) {
			add(l, s->map, s->range, s->value);
			return;
		}
	}
}

/* Whether the colours of particles are seen: on themselves or on arrows. */
static bool shows_particles(const struct ts_image *d)
{
	for (size_t n = 0; n < d->narrows; n++)
		if (ts_streq(d->arrows[n].style.colour_name, "atom"))
			return true;
	return d->atoms;
}

void ts_image_add_legends(struct ts_image *d)
{
	const struct ts_dump_column *c = &d->common.column[TS_IMAGE_COLOUR];
	struct legends l = { .d = d, .ground = d->gradient ? d->ground_top : d->ground };
	const float *ground = l.ground.c;

	l.ink = ts_colour_of_hex(ground[0] + 2 * ground[1] + ground[2] > 2 ? 0 : 0xffffff);
	if (!c->element && !ts_streq(c->input.name, "type") && shows_particles(d))
		add(&l, &d->atom_map, d->range[0], c->input.name);
	if (d->bond.colour_by >= TS_IMAGE_NUMBER)
		add(&l, &d->bond_map, d->range[1], d->bond.colour);
	add_contacts(&l);
	add_slices(&l);
	add_films(&l);
	add_surfaces(&l);
}
