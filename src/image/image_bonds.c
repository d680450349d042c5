/* Bonds of a picture: two rods from the partners to the middle between them, by the nearest image, so that a bond across a
 * periodic face is drawn as two halves at both faces. */
#include <math.h>

#include "bond/bonds.h"
#include "image/image.h"
#include "particle/identity.h"

#include "base/banned.h"

/* A bond that is drawn. */
struct drawn {
	size_t bond, partner[2];
	double d[3], length; /* vector from the first to the second partner */
	double value;
};

static bool find(const struct ts_image *s, const struct tsim *sim, const struct ts_identities *map, size_t k,
		 struct drawn *out)
{
	double back[3];

	for (int e = 0; e < 2; e++) {
		const int32_t row = ts_identity_row(map, sim->bonds->tag[k][e]);

		if (row < 0 || !s->drawn[row])
			return false;
		out->partner[e] = (size_t)row;
	}
	out->bond = k;
	out->length = ts_bond_separation(sim, out->partner[0], out->partner[1], back);
	for (int d = 0; d < 3; d++)
		out->d[d] = -back[d];
	return true;
}

/* Strain, or the row of the compute: of all bonds, or of those drawn. */
static double value_of(const struct ts_image *s, const struct tsim *sim, const struct drawn *b, size_t number)
{
	const struct ts_table *t = &s->bond.values;

	if (s->bond.colour_by == TS_IMAGE_NUMBER)
		return b->length / sim->bonds->rest[b->bond] - 1;
	return t->data[(t->rows == sim->bonds->n ? b->bond : number) * t->columns];
}

static double diameter_of(const struct ts_image *s, const struct tsim *sim, const struct drawn *b)
{
	const double least = fmin(s->diameter[b->partner[0]], s->diameter[b->partner[1]]);
	double given;

	if (s->bond.width_by == TS_IMAGE_NUMBER)
		return s->bond.diameter;
	if (s->bond.width_by == TS_IMAGE_ATOM)
		return least;
	given = ts_image_type_diameter(&s->bond_types, sim->bonds->type[b->bond]);
	return isnan(given) ? 0.5 * least : given;
}

static struct ts_colour colour_of(const struct ts_image *s, const struct tsim *sim, const struct drawn *b,
				  int end)
{
	if (s->bond.colour_by == TS_IMAGE_ATOM)
		return s->colour[b->partner[end]];
	if (s->bond.colour_by == TS_IMAGE_TYPE)
		return ts_image_type_colour(&s->bond_types, sim->bonds->type[b->bond]);
	if (isnan(b->value))
		return ts_colour_of_hex(TS_IMAGE_NAN);
	return ts_colour_map_at(&s->bond_map, s->range[1][0], s->range[1][1], b->value);
}

static enum ts_status add(struct ts_image *s, const struct tsim *sim, const struct drawn *b)
{
	const double radius = 0.5 * diameter_of(s, sim, b);

	for (int e = 0; e < 2; e++) {
		const double *from = sim->particles->x[b->partner[e]];
		double middle[3];

		for (int d = 0; d < 3; d++)
			middle[d] = from[d] + (e ? -0.5 : 0.5) * b->d[d];
		TS_TRY(ts_scene_add_rod(&s->scene, from, middle, radius, colour_of(s, sim, b, e)));
	}
	return TS_OK;
}

/* *n: number of bonds drawn; the range of their values. */
static void survey(struct ts_image *s, const struct tsim *sim, const struct ts_identities *map, size_t *n)
{
	double *range = s->range[1];
	bool complete = s->bond.colour_by != TS_IMAGE_VALUE || s->bond.values.rows == sim->bonds->n;
	struct drawn b;

	*n = 0;
	range[0] = INFINITY;
	range[1] = -INFINITY;
	for (size_t k = 0; k < sim->bonds->n; k++) {
		if (!find(s, sim, map, k, &b))
			continue;
		if (s->bond.colour_by >= TS_IMAGE_NUMBER && (complete || *n < s->bond.values.rows)) {
			b.value = value_of(s, sim, &b, *n);
			ts_colour_map_extend(&b.value, 1, 1, &range[0], &range[1]);
		}
		++*n;
	}
	ts_colour_map_range(&s->bond_map, &range[0], &range[1]);
}

static enum ts_status evaluate(struct ts_instance *self, struct tsim *sim)
{
	struct ts_image *s = self->state;

	return s->bond.colour_by == TS_IMAGE_VALUE ? ts_ref_input_eval(sim, &s->bond.input, &s->bond.values)
						   : TS_OK;
}

enum ts_status ts_image_add_bonds(struct ts_instance *self, struct tsim *sim)
{
	struct ts_image *s = self->state;
	struct ts_identities map;
	struct drawn b = { 0 };
	size_t n;

	if (s->bond.colour_by == TS_IMAGE_NONE || s->bond.width_by == TS_IMAGE_NONE || !sim->bonds->n)
		return TS_OK;
	TS_TRY(ts_identities(sim, false, &map));
	TS_TRY(evaluate(self, sim));
	survey(s, sim, &map, &n);
	if (s->bond.colour_by == TS_IMAGE_VALUE && s->bond.values.rows != sim->bonds->n &&
	    s->bond.values.rows != n)
		return ts_fail(&sim->error, TS_STATE, &s->bond.input.where,
			       "dump image: bond: %s has %zu rows, but there are %zu bonds and %zu are "
			       "drawn: define the compute for the group all",
			       s->bond.colour, s->bond.values.rows, sim->bonds->n, n);
	n = 0;
	for (size_t k = 0; k < sim->bonds->n; k++) {
		if (!find(s, sim, &map, k, &b))
			continue;
		if (s->bond.colour_by >= TS_IMAGE_NUMBER)
			b.value = value_of(s, sim, &b, n);
		n++;
		if (add(s, sim, &b) != TS_OK)
			return ts_nomem(&sim->error);
	}
	return TS_OK;
}
