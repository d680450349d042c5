/* Fix heat/gran: particle columns, material constants, heat content and restart state. */
#include "heat/heat.h"

#include <math.h>
#include <string.h>

#include "contact/pair.h"
#include "insert/template.h"
#include "law/granular_limit.h"
#include "material/property.h"
#include "particle/columns.h"
#include "particle/group_moments.h"
#include "particle/style_column.h"

#include "base/banned.h"

struct ts_heat *ts_heat_of(const struct tsim *sim)
{
	size_t k = 0;
	const struct ts_instance *inst = ts_sim_next_of(sim, TS_KIND_FIX, TS_FAMILY_HEAT, &k);

	return inst ? inst->state : NULL;
}

enum ts_status ts_heat_read_area(struct tsim *sim, const char *who, struct ts_words words,
				 struct ts_heat_contact *out)
{
	static const char *const kinds[] = { "overlap", "constant", "projection" };
	struct ts_suggest suggest;

	*out = (struct ts_heat_contact){ .kind = TS_HEAT_OVERLAP };
	if (!words.n)
		return TS_OK;
	suggest = ts_suggest_start(words.word[0].text);
	for (int k = 0; k < 3; k++) {
		ts_suggest_try(&suggest, kinds[k]);
		if (!ts_streq(words.word[0].text, kinds[k]))
			continue;
		out->kind = k;
		if (words.n != (k == TS_HEAT_CONSTANT ? 2 : 1))
			return ts_fail(&sim->error, TS_SYNTAX, &words.word[words.n - 1].place,
				       "%s: contact_area %s", who,
				       k == TS_HEAT_CONSTANT ? "constant takes one number, an area"
							     : "is overlap, constant A or projection");
		if (k != TS_HEAT_CONSTANT || (ts_parse_real(words.word[1].text, &out->constant) &&
					      out->constant > 0 && isfinite(out->constant)))
			return TS_OK;
		return ts_fail(&sim->error, TS_RANGE, &words.word[1].place,
			       "%s: contact_area is '%s', expected an area > 0", who, words.word[1].text);
	}
	return ts_fail(&sim->error, TS_SYNTAX, &words.word[0].place,
		       "%s: contact_area is '%s', expected overlap, constant A or projection%s", who,
		       words.word[0].text, ts_suggest_text(&suggest));
}

/* ---- columns ---- */

static enum ts_status add_columns(struct ts_heat *h, struct tsim *sim)
{
	const unsigned result = TS_COL_NAMED | TS_COL_RESULT;

	TS_TRY(ts_particles_style_column(sim, "Temp", 1, TS_COL_NAMED | TS_COL_BORDER | TS_COL_FORWARD,
					 h->initial, &h->temperature));
	TS_TRY(ts_particles_style_column(sim, "heatFlux", 1, result, 0, &h->flux));
	TS_TRY(ts_particles_style_column(sim, "heatSource", 1, TS_COL_NAMED, 0, &h->source));
	TS_TRY(ts_particles_style_column(sim, "directionalHeatFlux", 3, result, 0, &h->directed));
	TS_TRY(ts_particles_style_column(sim, "heat at walls", 1, TS_COL_RESULT, 0, &h->wall_conductance));
	if (h->scheme == TS_HEAT_EXACT)
		TS_TRY(ts_particles_style_column(sim, "heat rate", 1,
						 TS_COL_RESULT | TS_COL_BORDER | TS_COL_FORWARD, 0,
						 &h->rate));
	if (!h->store)
		return TS_OK;
	TS_TRY(ts_particles_style_column(sim, "nContactsConduction", 1, result, 0, &h->contacts));
	TS_TRY(ts_particles_style_column(sim, "contactAreaConduction", 1, result, 0, &h->area));
	return ts_particles_style_column(sim, "wallHeatFlux", 1, result, 0, &h->wall_flux);
}

enum ts_status ts_heat_init(struct ts_instance *self, struct tsim *sim)
{
	struct ts_heat *h = self->state;
	const struct ts_instance *other;
	size_t k = 0;

	sim->neigh->wanted = true;
	if (h->ready)
		return TS_OK;
	other = ts_sim_next_of(sim, TS_KIND_FIX, TS_FAMILY_HEAT, &k);
	if (other && !ts_streq(other->id, self->id))
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "fix %s: there is one already (%s, %s:%d), and particles have one "
			       "temperature",
			       self->style->name, other->id, TS_FILE_AND_LINE(other->where));
	h->sim = sim;
	TS_TRY(ts_heat_read_area(sim, "fix heat/gran", h->area_words, &h->contact));
	if (h->correction && h->contact.kind != TS_HEAT_OVERLAP)
		return ts_fail(&sim->error, TS_STATE, ts_instance_word(self, "area_correction"),
			       "fix heat/gran: area_correction is for contact_area overlap");
	TS_TRY(add_columns(h, sim));
	h->ready = true;
	return TS_OK;
}

/* ---- materials ---- */

enum ts_status ts_heat_conductivity(struct tsim *sim, int type, const char *who, const struct ts_place *where,
				    double *out)
{
	const struct ts_instance *by;

	TS_TRY(ts_property_value(sim, "thermalConductivity", type, 0, who, where, out));
	if (*out >= 0)
		return TS_OK;
	ts_property_find(sim, "thermalConductivity", &by);
	return ts_fail(&sim->error, TS_RANGE, &by->where,
		       "property/global thermalConductivity must be >= 0, found %.15g", *out);
}

/* Effective modulus Y* of two types: 1/Y* = (1 - nu_a^2)/Y_a + (1 - nu_b^2)/Y_b. */
static enum ts_status effective_modulus(struct tsim *sim, const char *name, int a, int b,
					const struct ts_place *where, double *out)
{
	const int types[2] = { a, b };
	double sum = 0;

	for (int k = 0; k < 2; k++) {
		double young, nu;

		TS_TRY(ts_property_value(sim, name, types[k], 0, "fix heat/gran", where, &young));
		TS_TRY(ts_property_value(sim, "poissonsRatio", types[k], 0, "fix heat/gran", where, &nu));
		sum += (1 - nu * nu) / young;
	}
	*out = 1 / sum;
	return TS_OK;
}

/* Of particles of these types; NULL: they have no contact law. */
static const struct ts_granular_model *model_of_types(const struct tsim *sim, int a, int b)
{
	const struct ts_instance *inst = ts_sim_only(sim, TS_KIND_PAIR);
	const struct ts_pair *pair = inst ? inst->state : NULL;

	return pair && a <= pair->ntypes && b <= pair->ntypes ? ts_pair_model(pair, a, b) : NULL;
}

enum ts_status ts_heat_softening(struct tsim *sim, const struct ts_heat *heat,
				 const struct ts_granular_model *model, int a, int b,
				 const struct ts_place *where, double *out)
{
	/* exponent of the elastic force, F ~ overlap^a */
	const double exponent = model && ts_granular_stiffens(model) ? 1.5 : 1;
	double now, original;

	*out = 1;
	if (!heat->correction)
		return TS_OK;
	TS_TRY(effective_modulus(sim, "youngsModulus", a, b, where, &now));
	TS_TRY(effective_modulus(sim, "youngsModulusOriginal", a, b, where, &original));
	*out = pow(now / original, 1 / exponent);
	return TS_OK;
}

static enum ts_status set_pair_constants(struct ts_instance *self, struct tsim *sim, int a, int b)
{
	struct ts_heat *h = self->state;
	size_t k = (size_t)a * (size_t)(h->ntypes + 1) + (size_t)b;

	h->pair[k] = ts_heat_pair_conductivity(h->conductivity[a], h->conductivity[b]);
	if (!h->correction)
		return TS_OK;
	return ts_heat_softening(sim, h, model_of_types(sim, a, b), a, b, &self->where, &h->softening[k]);
}

static enum ts_status allocate_constants(struct ts_instance *self, struct tsim *sim)
{
	struct ts_heat *h = self->state;
	size_t n = (size_t)sim->particles->ntypes + 1;

	if (h->ntypes >= sim->particles->ntypes)
		return TS_OK;
	h->conductivity = ts_arena_alloc(&self->arena, n, sizeof *h->conductivity);
	h->capacity = ts_arena_alloc(&self->arena, n, sizeof *h->capacity);
	h->pair = ts_arena_alloc(&self->arena, n * n, sizeof *h->pair);
	if (h->correction)
		h->softening = ts_arena_alloc(&self->arena, n * n, sizeof *h->softening);
	if (!h->conductivity || !h->capacity || !h->pair || (h->correction && !h->softening))
		return ts_nomem(&sim->error);
	h->ntypes = sim->particles->ntypes;
	return TS_OK;
}

static enum ts_status heat_capacity_of_type(struct tsim *sim, int type, const struct ts_place *where,
					    double *out)
{
	const struct ts_instance *by;

	TS_TRY(ts_property_value(sim, "thermalCapacity", type, 0, "fix heat/gran", where, out));
	if (*out > 0)
		return TS_OK;
	ts_property_find(sim, "thermalCapacity", &by);
	return ts_fail(&sim->error, TS_RANGE, &by->where,
		       "property/global thermalCapacity must be > 0, found %.15g", *out);
}

enum ts_status ts_heat_materials(struct ts_instance *self, struct tsim *sim)
{
	struct ts_heat *h = self->state;
	int last_type = ts_template_max_type(sim);

	TS_TRY(allocate_constants(self, sim));
	for (int t = 1; t <= last_type; t++) {
		TS_TRY(ts_heat_conductivity(sim, t, "fix heat/gran", &self->where, &h->conductivity[t]));
		TS_TRY(heat_capacity_of_type(sim, t, &self->where, &h->capacity[t]));
	}
	for (int a = 1; a <= last_type; a++)
		for (int b = 1; b <= last_type; b++)
			TS_TRY(set_pair_constants(self, sim, a, b));
	return TS_OK;
}

/* ---- outputs and restart files ---- */

struct content {
	const double *temperature, *capacity; /* by particle; by type */
};

static void heat_content_term(const struct tsim *sim, size_t i, const void *context, double *term)
{
	const struct content *c = context;

	*term = sim->particles->mass[i] * c->capacity[sim->particles->type[i]] * c->temperature[i];
}

/* Of the types that particles have; a type without particles needs none. */
static enum ts_status find_capacities(const struct ts_instance *self, struct tsim *sim, double *capacity)
{
	const struct ts_particles *p = sim->particles;

	for (size_t i = 0; i < p->n; i++)
		if (!(capacity[p->type[i]] > 0))
			TS_TRY(heat_capacity_of_type(sim, p->type[i], &self->where, &capacity[p->type[i]]));
	return TS_OK;
}

static enum ts_status eval_energy(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct ts_heat *h = self->state;
	const struct ts_particles *p = sim->particles;
	struct content content = { ts_heat_column(sim, h->temperature), NULL };
	enum ts_status status;
	double *capacity;
	int last = 0;

	for (size_t i = 0; i < p->n; i++)
		last = p->type[i] > last ? p->type[i] : last;
	content.capacity = capacity = ts_alloc((size_t)last + 1, sizeof *capacity);
	if (!capacity)
		return ts_nomem(&h->sim->error);
	status = find_capacities(self, h->sim, capacity);
	ts_group_sum(sim, 0, 1, heat_content_term, &content,
		     out->data); /* all ranks, whatever the status of one */
	ts_free(capacity);
	return status;
}

static enum ts_status eval_temperature(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct ts_heat *h = self->state;

	TS_TRY(ts_table_resize(out, sim->particles->n, 1));
	if (sim->particles->n)
		memcpy(out->data, ts_heat_column(sim, h->temperature), sim->particles->n * sizeof *out->data);
	return TS_OK;
}

const struct ts_value ts_heat_values[] = {
	{ .name = "heat",
	  .unit = "energy",
	  .help = "sum of m c T over all particles",
	  .shape = TS_SCALAR,
	  .columns = 1,
	  .eval = eval_energy },
	{ .name = "temperature",
	  .unit = "temperature",
	  .help = "temperature of each particle",
	  .shape = TS_PERATOM,
	  .columns = 1,
	  .eval = eval_temperature },
	{ .name = NULL },
};

enum ts_status ts_heat_archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a)
{
	const struct ts_heat *h = self->state;
	const size_t columns[] = { h->temperature, h->flux, h->source,	 h->directed,
				   h->contacts,	   h->area, h->wall_flux };

	for (size_t k = 0; k < (h->store ? 7 : 4); k++)
		TS_TRY(ts_particles_archive_column(a, sim, sim->particles->column[columns[k]].name,
						   columns[k]));
	return TS_OK;
}

void ts_heat_fini(struct ts_instance *self)
{
	struct ts_heat *h = self->state;

	ts_contact_list_release(&h->held);
	ts_free(h->work);
	ts_free(h->inner);
	ts_free(h->mean_rise);
	for (int k = 0; k < 2; k++) {
		ts_free(h->pairs[k].conductance);
		ts_free(h->pairs[k].flow);
	}
}
