#include "polish/slurry.h"

#include "rough/pressed_surface.h"

#include "base/banned.h"

enum ts_status ts_slurry_contact_init(struct ts_instance *self, struct tsim *sim, ts_active_fn *count)
{
	struct ts_slurry_contact *s = self->state;
	struct ts_word id = { .text = s->contact_id, .place = *ts_instance_word(self, s->contact_id) };

	s->count = count;
	return ts_pressed_surface_require(sim, &id, &s->pressed);
}

/* What models read of the contact. Asperities in contact stand in the slurry, whose thickness is the mean gap. */
static struct ts_polish_contact polish_contact(const struct ts_slurry_contact *s)
{
	const struct ts_pressed_surface *pad = s->pressed->state;
	const struct ts_rough_result *r = &pad->result;
	double nominal = (double)pad->n * pad->field->width[0] * pad->field->width[1];

	return (struct ts_polish_contact){
		.nominal_area = nominal,
		.real_area = r->area * nominal,
		.gap_volume = r->mean_gap * nominal,
		.asperity_volume = r->area * r->mean_gap * nominal,
		.pressure = pad->solved_pressure / r->area,
		.pad_hardness = isnan(pad->hardness) ? INFINITY : pad->hardness,
		.wafer_hardness = s->wafer_hardness,
	};
}

static enum ts_status count(struct ts_instance *self, struct ts_active_particles *out)
{
	const struct ts_slurry_contact *s = self->state;
	struct ts_polish_contact contact;

	TS_TRY(ts_pressed_surface_solve(s->pressed));
	contact = polish_contact(s);
	*out = s->count(&s->slurry, &contact);
	return TS_OK;
}

static enum ts_status eval_active(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	struct ts_active_particles n;

	(void)sim;
	TS_TRY(count(self, &n));
	out->data[0] = n.active;
	return TS_OK;
}

static enum ts_status eval_numbers(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	struct ts_active_particles n;

	(void)sim;
	TS_TRY(count(self, &n));
	out->data[0] = n.all;
	out->data[1] = n.eligible;
	out->data[2] = n.active;
	return TS_OK;
}

static const char *const names[] = { "all", "eligible", "active" };

const struct ts_value ts_slurry_values[] = {
	{ "active", "-", "number of active particles", TS_SCALAR, 1, NULL, eval_active },
	{ "numbers", "-, -, -", "number of particles in the gap, of those eligible, and of the active ones",
	  TS_VECTOR, 3, names, eval_numbers },
	{ .name = NULL },
};
