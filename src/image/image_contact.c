/* Force chains: a rod for each contact of a compute pair/gran/local or wall/gran/local, as wide as its force is large. */
#include <math.h>
#include <string.h>

#include "box/domain.h"
#include "contact/contact_columns.h"
#include "image/image_contact.h"
#include "math/vec3.h"

#include "base/banned.h"

static const struct ts_arg rows[] = {
	TS_WORD("compute", struct ts_image_contacts, id, .flags = TS_POSITIONAL,
		.help = "ID of a compute pair/gran/local or wall/gran/local with pos and force"),
	TS_REAL("width", struct ts_image_contacts, width, .flags = TS_OPTIONAL, .range = TS_POSITIVE,
		.unit = "length", .help = "diameter of the rod of the largest force of the frame"),
	TS_REAL("factor", struct ts_image_contacts, factor, .flags = TS_OPTIONAL, .range = TS_POSITIVE,
		.unit = "length/force", .help = "diameter by force, in place of `width`"),
	TS_WORD("color", struct ts_image_contacts, colour_name, .fallback = "force",
		.help = "name of a color, or force: by dump_modify cmap"),
	TS_ARGS_END,
};

/* ---- words */

static enum ts_status find_compute(struct tsim *sim, struct ts_image_contacts *c)
{
	const char *prefixed = strncmp(c->id, "c_", 2) == 0 ? c->id + 2 : c->id;
	const struct ts_word id = { .text = prefixed, .place = *ts_image_group_word(&c->group, c->id) };

	TS_TRY(ts_sim_require(sim, TS_KIND_COMPUTE, &id, &c->compute));
	if (c->compute->style->family && ts_streq(c->compute->style->family, TS_FAMILY_CONTACTS))
		return TS_OK;
	return ts_fail(&sim->error, TS_STATE, &id.place,
		       "dump image: contact needs a compute pair/gran/local or wall/gran/local; '%s' is %s",
		       prefixed, c->compute->style->name);
}

/* Finds the columns of positions and forces, which stand before those that depend on the contact law. */
static enum ts_status find_columns(struct tsim *sim, struct ts_image_contacts *c)
{
	struct ts_contact_array array[TS_CONTACT_ARRAYS];
	const size_t width = ts_contact_columns_width(c->compute->state, 0);
	const size_t n = ts_contact_columns_arrays(c->compute->state, width, array, &c->pos);

	c->force = SIZE_MAX;
	for (size_t k = 0; k < n; k++)
		if (ts_streq(array[k].name, "force"))
			c->force = array[k].first;
	if (c->pos != SIZE_MAX && c->force != SIZE_MAX)
		return TS_OK;
	return ts_fail(&sim->error, TS_STATE, ts_image_group_word(&c->group, c->id),
		       "dump image: contact: compute %s has no %s: add that keyword to it", c->compute->id,
		       c->pos == SIZE_MAX ? "pos" : "force");
}

static enum ts_status read_one(struct ts_instance *self, struct tsim *sim, struct ts_image_contacts *c)
{
	TS_TRY(find_compute(sim, c));
	TS_TRY(find_columns(sim, c));
	if (!isnan(c->width) && !isnan(c->factor))
		return ts_fail(&sim->error, TS_SYNTAX, &c->group.keyword.place,
			       "dump image: contact: give the width of the largest force or a factor, not "
			       "both");
	return ts_streq(c->colour_name, "force")
		       ? TS_OK
		       : ts_image_group_colour(self, sim, &c->group, c->colour_name, &c->colour);
}

enum ts_status ts_image_read_contacts(struct ts_instance *self, struct tsim *sim)
{
	struct ts_image *d = self->state;
	void *array = d->contacts;

	TS_TRY(ts_image_read_groups(self, sim, "contact", rows, d->contact_words, sizeof *d->contacts, &array,
				    &d->ncontacts));
	d->contacts = array;
	for (size_t n = 0; n < d->ncontacts; n++)
		TS_TRY(read_one(self, sim, &d->contacts[n]));
	return TS_OK;
}

/* ---- frames */

static double force_of(const struct ts_image_contacts *c, size_t row)
{
	return ts_norm(c->compute->table.data + row * c->compute->table.columns + c->force);
}

/* Two halves, so that a contact across a periodic face is drawn at both faces. */
static enum ts_status add_contact(struct ts_scene *scene, const struct tsim *sim, const double ends[6],
				  double diameter, struct ts_colour colour)
{
	double apart[3], middle[2][3];

	ts_sub(ends + 3, ends, apart);
	ts_box_nearest(&sim->domain->box, apart);
	for (int k = 0; k < 3; k++) {
		middle[0][k] = ends[k] + 0.5 * apart[k];
		middle[1][k] = ends[3 + k] - 0.5 * apart[k];
	}
	TS_TRY(ts_scene_add_rod(scene, ends, middle[0], 0.5 * diameter, colour));
	return ts_scene_add_rod(scene, ends + 3, middle[1], 0.5 * diameter, colour);
}

/* The width of the largest force, if the words do not say it: half of the mean diameter drawn. */
static double usual_width(const struct ts_image *d)
{
	double sum = 0;

	for (size_t k = 0; k < d->common.nrows; k++)
		sum += d->diameter[d->common.order[k]];
	return d->common.nrows ? 0.5 * sum / (double)d->common.nrows : 0;
}

/* The range of the forces of all keywords, and the largest force. */
static void find_range(struct ts_image *d, double range[2], double *largest)
{
	range[0] = INFINITY;
	range[1] = -INFINITY;
	for (size_t n = 0; n < d->ncontacts; n++)
		for (size_t row = 0; row < d->contacts[n].compute->table.rows; row++) {
			const double force = force_of(&d->contacts[n], row);

			ts_colour_map_extend(&force, 1, 1, &range[0], &range[1]);
		}
	*largest = fmax(range[1], 0);
	ts_colour_map_range(&d->contact_map, &range[0], &range[1]);
}

static enum ts_status add_all(struct ts_image *d, const struct tsim *sim, const struct ts_image_contacts *c,
			      double largest)
{
	const struct ts_table *t = &c->compute->table;
	const double *range = d->contact_range;
	const bool mapped = ts_streq(c->colour_name, "force");
	double factor = c->factor;

	if (isnan(factor))
		factor = (isnan(c->width) ? usual_width(d) : c->width) / largest;
	for (size_t row = 0; row < t->rows; row++) {
		const double force = force_of(c, row);

		TS_TRY(add_contact(&d->scene, sim, t->data + row * t->columns + c->pos, factor * force,
				   mapped ? ts_colour_map_at(&d->contact_map, range[0], range[1], force)
					  : c->colour));
	}
	return TS_OK;
}

enum ts_status ts_image_add_contacts(struct ts_instance *self, struct tsim *sim)
{
	struct ts_image *d = self->state;
	double largest;

	for (size_t n = 0; n < d->ncontacts; n++) {
		struct ts_instance *compute = d->contacts[n].compute;

		TS_TRY(ts_value_cached(compute, sim, ts_value_find(compute, TS_LOCAL)));
	}
	find_range(d, d->contact_range, &largest);
	for (size_t n = 0; n < d->ncontacts; n++)
		if (add_all(d, sim, &d->contacts[n], largest) != TS_OK)
			return ts_nomem(&sim->error);
	return TS_OK;
}
