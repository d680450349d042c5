#include "contact/contact_columns.h"

#include <stdint.h>

#include "math/constants.h"
#include "math/vec3.h"

#include "base/banned.h"

typedef void quantity_fn(const struct ts_contact_facts *facts, size_t history, double *out);

static void copy_numbers(const double *from, size_t n, double *to)
{
	for (size_t k = 0; k < n; k++)
		to[k] = from[k];
}

static void write_pos(const struct ts_contact_facts *f, size_t history, double *out)
{
	(void)history;
	copy_numbers(f->pos, 6, out);
}

static void write_vel(const struct ts_contact_facts *f, size_t history, double *out)
{
	(void)history;
	copy_numbers(f->vel, 6, out);
}

static void write_id(const struct ts_contact_facts *f, size_t history, double *out)
{
	(void)history;
	copy_numbers(f->id, 3, out);
}

static void write_force(const struct ts_contact_facts *f, size_t history, double *out)
{
	(void)history;
	copy_numbers(f->force, 3, out);
}

static void write_force_normal(const struct ts_contact_facts *f, size_t history, double *out)
{
	(void)history;
	ts_scale(ts_dot(f->force, f->n), f->n, out);
}

static void write_force_tangential(const struct ts_contact_facts *f, size_t history, double *out)
{
	double normal[3];

	write_force_normal(f, history, normal);
	ts_sub(f->force, normal, out);
}

static void write_torque(const struct ts_contact_facts *f, size_t history, double *out)
{
	(void)history;
	copy_numbers(f->torque, 3, out);
}

static void write_history(const struct ts_contact_facts *f, size_t history, double *out)
{
	copy_numbers(f->history, history, out);
}

static void write_area(const struct ts_contact_facts *f, size_t history, double *out)
{
	(void)history;
	*out = f->area;
}

static void write_delta(const struct ts_contact_facts *f, size_t history, double *out)
{
	(void)history;
	*out = f->delta;
}

static void write_point(const struct ts_contact_facts *f, size_t history, double *out)
{
	(void)history;
	copy_numbers(f->point, 3, out);
}

static void write_heat(const struct ts_contact_facts *f, size_t history, double *out)
{
	(void)history;
	*out = f->heat;
}

/* In the order of the output, which does not depend on the order of the words. */
static const struct quantity {
	const char *name;
	quantity_fn *write;
	size_t width;	      /* 0: number of history numbers of the contact law */
	bool usual;	      /* written if no word is given */
	const char *array[3]; /* names of arrays in files; several arrays share the columns evenly */
} quantities[] = {
	{ "pos", write_pos, 6, true, { NULL } },
	{ "vel", write_vel, 6, true, { "vel1", "vel2", NULL } },
	{ "id", write_id, 3, true, { "id1", "id2", "id3" } },
	{ "force", write_force, 3, true, { "force" } },
	{ "force_normal", write_force_normal, 3, false, { "force_normal" } },
	{ "force_tangential", write_force_tangential, 3, false, { "force_tangential" } },
	{ "torque", write_torque, 3, false, { "torque" } },
	{ "history", write_history, 0, true, { "history" } },
	{ "contactArea", write_area, 1, true, { "contact_area" } },
	{ "delta", write_delta, 1, false, { "delta" } },
	{ "contactPoint", write_point, 3, false, { "contact_point" } },
	{ "heatFlux", write_heat, 1, false, { "heatFlux" } },
	{ .name = NULL },
};
_Static_assert(sizeof quantities / sizeof *quantities == TS_CONTACT_COLUMNS + 1, "one flag each");

const char ts_contact_columns_help[] = "pos, vel, id, force, force_normal, force_tangential, torque, "
				       "history, contactArea, delta, contactPoint, heatFlux";

enum ts_status ts_contact_columns_init(struct ts_instance *self, struct tsim *sim)
{
	struct ts_contact_columns *c = self->state;

	TS_TRY(ts_name_list_read(sim, self->style->name, &self->arena, c->words, quantities,
				 sizeof *quantities, &c->list));
	for (int k = 0; k < TS_CONTACT_COLUMNS; k++)
		c->wanted[k] = c->list.n == 0 && quantities[k].usual;
	for (size_t k = 0; k < c->list.n; k++)
		c->wanted[c->list.item[k]] = true;
	return TS_OK;
}

static size_t width_of(int k, size_t history)
{
	return quantities[k].width ? quantities[k].width : history;
}

size_t ts_contact_columns_width(const struct ts_contact_columns *c, size_t history)
{
	size_t width = 0;

	for (int k = 0; k < TS_CONTACT_COLUMNS; k++)
		width += c->wanted[k] ? width_of(k, history) : 0;
	return width;
}

size_t ts_contact_columns_known_width(const struct ts_instance *self)
{
	const struct ts_contact_columns *c = self->state;
	size_t width = ts_contact_columns_width(c, 0);

	return width == ts_contact_columns_width(c, 1) ? width : 0;
}

void ts_contact_columns_write(const struct ts_contact_columns *c, size_t history,
			      const struct ts_contact_facts *facts, double *out)
{
	for (int k = 0; k < TS_CONTACT_COLUMNS; k++) {
		if (!c->wanted[k])
			continue;
		quantities[k].write(facts, history, out);
		out += width_of(k, history);
	}
}

double ts_contact_area(double a, double b, double r)
{
	return -TS_PI / 4 * ((r - a - b) * (r + a - b) * (r - a + b) * (r + a + b)) / (r * r);
}

double ts_contact_area_plane(double radius, double distance)
{
	return TS_PI * (radius * radius - distance * distance);
}

size_t ts_contact_columns_arrays(const struct ts_contact_columns *c, size_t width,
				 struct ts_contact_array array[TS_CONTACT_ARRAYS], size_t *where)
{
	size_t history = width - ts_contact_columns_width(c, 0), at = 0, n = 0;

	*where = SIZE_MAX;
	for (int k = 0; k < TS_CONTACT_COLUMNS; k++) {
		size_t columns = c->wanted[k] ? width_of(k, history) : 0, parts = 0;

		if (columns && !quantities[k].array[0])
			*where = at;
		while (parts < 3 && quantities[k].array[parts])
			parts++;
		for (size_t j = 0; columns && j < parts; j++)
			array[n++] = (struct ts_contact_array){ quantities[k].array[j],
								at + j * (columns / parts), columns / parts };
		at += columns;
	}
	return n;
}
