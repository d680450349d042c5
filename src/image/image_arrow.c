/* Arrows: a rod and a cone; those of particles. */
#include <math.h>

#include "image/image_arrow.h"
#include "math/vec3.h"
#include "particle/particles.h"

#include "base/banned.h"

/* Parts of the longest arrow, and of the width of the shaft. */
static const double SHAFT = 0.05, HEAD = 3, HEAD_LENGTH = 6, MOST_HEAD = 0.5;
/* Shorter arrows than this part of the longest one are left out. */
static const double LEAST = 0.02;

struct ts_image_arrow_size ts_image_arrow_size(const struct ts_image_arrow_style *style, double largest,
					       double usual)
{
	struct ts_image_arrow_size s = { .factor = style->factor, .width = style->width };

	if (isnan(s.factor)) {
		s.longest = isnan(style->longest) ? usual : style->longest;
		s.factor = largest > 0 ? s.longest / largest : 0;
	} else
		s.longest = s.factor * largest;
	if (isnan(s.width))
		s.width = SHAFT * s.longest;
	return s;
}

/* Shorter arrows than two heads are thinner, too. */
enum ts_status ts_image_add_arrow(struct ts_scene *scene, const double x[3], const double vector[3],
				  const struct ts_image_arrow_size *size, struct ts_colour colour)
{
	const double length = size->factor * ts_norm(vector);
	const double width = fmin(size->width, MOST_HEAD * length / HEAD_LENGTH),
		     head = HEAD_LENGTH * width / length;
	double neck[3], tip[3];

	if (!(length > LEAST * size->longest) || isinf(length))
		return TS_OK;
	for (int d = 0; d < 3; d++) {
		tip[d] = x[d] + size->factor * vector[d];
		neck[d] = x[d] + (1 - head) * size->factor * vector[d];
	}
	TS_TRY(ts_scene_add_rod(scene, x, neck, 0.5 * width, colour));
	return ts_scene_add_cone(scene, neck, tip, 0.5 * HEAD * width, colour);
}

enum ts_status ts_image_read_arrow_style(struct ts_instance *self, struct tsim *sim,
					 const struct ts_image_group *group,
					 struct ts_image_arrow_style *style)
{
	if (!isnan(style->longest) && !isnan(style->factor))
		return ts_fail(&sim->error, TS_SYNTAX, &group->keyword.place,
			       "dump image: %s: give the length of the longest arrow or a factor, not both",
			       group->keyword.text);
	if (ts_streq(style->colour_name, "atom"))
		return TS_OK;
	return ts_image_group_colour(self, sim, group, style->colour_name, &style->colour);
}

/* ---- particles */

static const struct ts_arg rows[] = {
	TS_WORD("Vx", struct ts_image_arrows, name[0], .flags = TS_POSITIONAL,
		.help = "x component of the vector: any quantity of particles, such as vx"),
	TS_WORD("Vy", struct ts_image_arrows, name[1], .flags = TS_POSITIONAL, .help = "its y component"),
	TS_WORD("Vz", struct ts_image_arrows, name[2], .flags = TS_POSITIONAL, .help = "its z component"),
	TS_IMAGE_ARROW_ROWS(struct ts_image_arrows, style, "atom"),
	TS_ARGS_END,
};

enum ts_status ts_image_read_arrows(struct ts_instance *self, struct tsim *sim)
{
	struct ts_image *d = self->state;
	void *array = d->arrows;

	TS_TRY(ts_image_read_groups(self, sim, "arrow", rows, d->arrow_words, sizeof *d->arrows, &array,
				    &d->narrows));
	d->arrows = array;
	for (size_t n = 0; n < d->narrows; n++) {
		struct ts_image_arrows *a = &d->arrows[n];

		TS_TRY(ts_image_read_arrow_style(self, sim, &a->group, &a->style));
		for (int k = 0; k < 3; k++) {
			a->component[k].input =
				(struct ts_ref_input){ .name = a->name[k],
						       .where = *ts_image_group_word(&a->group, a->name[k]) };
			TS_TRY(ts_dump_make_column(self, sim, &a->component[k], false));
		}
	}
	return TS_OK;
}

static void vector_of(const struct ts_image_arrows *a, size_t i, double out[3])
{
	for (int k = 0; k < 3; k++)
		out[k] = a->component[k].values.data[i];
}

/* Size of the largest finite vector, and the largest diameter of those that have one. */
static double largest_of(const struct ts_image *d, const struct ts_image_arrows *a, double *diameter)
{
	double most = 0, v[3];

	*diameter = 0;
	for (size_t k = 0; k < d->common.nrows; k++) {
		const size_t i = (size_t)d->common.order[k];

		vector_of(a, i, v);
		if (isfinite(ts_norm(v)))
			most = fmax(most, ts_norm(v));
		*diameter = fmax(*diameter, d->diameter[i]);
	}
	return most;
}

static enum ts_status add_arrows(struct ts_image *d, const struct tsim *sim, const struct ts_image_arrows *a)
{
	const bool own = ts_streq(a->style.colour_name, "atom");
	struct ts_image_arrow_size size;
	double diameter, largest = largest_of(d, a, &diameter), v[3];

	size = ts_image_arrow_size(&a->style, largest, 4 * diameter);
	for (size_t k = 0; k < d->common.nrows; k++) {
		const size_t i = (size_t)d->common.order[k];

		vector_of(a, i, v);
		TS_TRY(ts_image_add_arrow(&d->scene, sim->particles->x[i], v, &size,
					  own ? d->colour[i] : a->style.colour));
	}
	return TS_OK;
}

enum ts_status ts_image_add_arrows(struct ts_instance *self, struct tsim *sim)
{
	struct ts_image *d = self->state;

	for (size_t n = 0; n < d->narrows; n++) {
		for (int k = 0; k < 3; k++)
			TS_TRY(ts_dump_evaluate(&d->arrows[n].component[k], sim));
		if (add_arrows(d, sim, &d->arrows[n]) != TS_OK)
			return ts_nomem(&sim->error);
	}
	return TS_OK;
}

void ts_image_release_arrows(struct ts_image *d)
{
	for (size_t n = 0; n < d->narrows; n++)
		for (int k = 0; k < 3; k++)
			ts_table_release(&d->arrows[n].component[k].values);
}
