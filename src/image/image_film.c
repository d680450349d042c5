/* Lubrication films of flow_style reynolds: a rectangle for each cell, coloured by pressure, gap or void fraction, in a plane or
 * as a relief of the gap. A cell has the value of its centre, which is what the film computes; the relief passes through the
 * means at the corners of cells. */
#include <math.h>
#include <string.h>

#include "film/film_flow.h"
#include "image/image_film.h"

#include "base/banned.h"

enum { PRESSURE, GAP, VOID };
static const char *const quantities[] = { [PRESSURE] = "p", [GAP] = "gap", [VOID] = "void", NULL };

static const struct ts_arg rows[] = {
	TS_ENUM("quantity", struct ts_image_film, quantity, quantities, .flags = TS_POSITIONAL,
		.help = "p, pressure; gap; void, part of the gap without fluid where the film cavitates"),
	TS_NUMBER("height", struct ts_image_film, height, .fallback = "0",
		  .help = "z of the plane (length), number or variable"),
	TS_REAL("relief", struct ts_image_film, relief, .fallback = "0",
		.help = "factor of the gap by which the surface is raised; 0: flat"),
	TS_REAL("trans", struct ts_image_film, opacity, .range = TS_FRACTION, .fallback = "1",
		.help = "from 0, invisible, to 1, opaque"),
	TS_ARGS_END,
};

const char *ts_image_film_quantity(const struct ts_image_film *film)
{
	return quantities[film->quantity];
}

enum ts_status ts_image_read_films(struct ts_instance *self, struct tsim *sim)
{
	struct ts_image *d = self->state;
	void *array = d->film;

	TS_TRY(ts_image_read_groups(self, sim, "film", rows, d->film_words, sizeof *d->film, &array,
				    &d->nfilms));
	d->film = array;
	for (size_t n = 0; n < d->nfilms; n++) {
		struct ts_film_flow *flow;

		TS_TRY(ts_film_flow_require(sim, "dump image: film", &d->film[n].group.keyword.place, &flow));
	}
	return TS_OK;
}

static const double *values_of(const struct ts_film *f, int quantity)
{
	return quantity == PRESSURE ? f->p : quantity == GAP ? f->gap : f->empty;
}

/* The mean gap of the cells around corner (i, j). */
static double gap_at_corner(const struct ts_film *f, int i, int j)
{
	double sum = 0;
	int n = 0;

	for (int b = j - 1; b <= j; b++)
		for (int a = i - 1; a <= i; a++)
			if (a >= 0 && a < f->n[0] && b >= 0 && b < f->n[1]) {
				sum += f->gap[ts_film_at(f, a, b)];
				n++;
			}
	return sum / n;
}

static void place_corner(const struct ts_film *f, const struct ts_image_film *film, double height, int i,
			 int j, double x[3])
{
	double a = f->face[0][i], b = f->face[1][j];

	x[0] = f->polar ? a * cos(b) : a;
	x[1] = f->polar ? a * sin(b) : b;
	x[2] = height + (fabs(film->relief) > 0 ? film->relief * gap_at_corner(f, i, j) : 0);
}

static enum ts_status add_cell(struct ts_scene *scene, const struct ts_film *f,
			       const struct ts_image_film *film, double height, int i, int j)
{
	static const int corner[4][2] = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } };
	struct ts_scene_triangle t = { .opacity = (float)film->opacity,
				       .unlit = !(fabs(film->relief) > 0),
				       .scale = &film->scale };
	double x[4][3];

	for (int k = 0; k < 4; k++)
		place_corner(f, film, height, i + corner[k][0], j + corner[k][1], x[k]);
	for (int k = 0; k < 3; k++)
		t.value[k] = (float)values_of(f, film->quantity)[ts_film_at(f, i, j)];
	for (int half = 0; half < 2; half++) {
		memcpy(t.corner[0], x[0], sizeof t.corner[0]);
		memcpy(t.corner[1], x[1 + half], sizeof t.corner[1]);
		memcpy(t.corner[2], x[2 + half], sizeof t.corner[2]);
		TS_TRY(ts_scene_add_painted(scene, &t));
	}
	return TS_OK;
}

/* Before the first set-up of a run all gaps are 0. */
static bool is_computed(const struct ts_film *f)
{
	for (size_t k = 0; k < ts_film_cells(f); k++)
		if (!(fabs(f->gap[k]) <= 0))
			return true;
	return false;
}

/* The range of the cells; whether all of them are numbers. */
static bool find_range(const struct ts_image *d, struct ts_image_film *film, const struct ts_film *f)
{
	const double *value = values_of(f, film->quantity);
	bool numbers = true;

	film->scale = (struct ts_scene_scale){ &d->field_map, INFINITY, -INFINITY };
	ts_colour_map_extend(value, ts_film_cells(f), 1, &film->scale.lo, &film->scale.hi);
	for (size_t k = 0; k < ts_film_cells(f); k++)
		numbers &= !isnan(value[k]);
	ts_colour_map_range(&d->field_map, &film->scale.lo, &film->scale.hi);
	return numbers;
}

static enum ts_status add_film(struct ts_instance *self, struct tsim *sim, struct ts_image_film *film)
{
	struct ts_image *d = self->state;
	const struct ts_place *where = &film->group.keyword.place;
	struct ts_film_flow *flow;
	double height;

	TS_TRY(ts_film_flow_require(sim, "dump image: film", where, &flow));
	TS_TRY(ts_number_now(sim, &film->height, where, &height));
	if (!is_computed(&flow->film)) {
		film->scale = (struct ts_scene_scale){ &d->field_map, 0, 0 };
		ts_warn(&sim->log, where,
			"dump image: film: it has not been computed yet and is left out; `run 0` does");
		return TS_OK;
	}
	if (!find_range(d, film, &flow->film))
		ts_image_warn_nan(self, sim, ts_image_film_quantity(film));
	for (int j = 0; j < flow->film.n[1]; j++)
		for (int i = 0; i < flow->film.n[0]; i++)
			if (add_cell(&d->scene, &flow->film, film, height, i, j) != TS_OK)
				return ts_nomem(&sim->error);
	return TS_OK;
}

enum ts_status ts_image_add_films(struct ts_instance *self, struct tsim *sim)
{
	struct ts_image *d = self->state;

	for (size_t n = 0; n < d->nfilms; n++)
		TS_TRY(add_film(self, sim, &d->film[n]));
	return TS_OK;
}
