#include "neigh/heat.h"

#include <math.h>
#include <string.h>

#include "base/parallel.h"
#include "neigh/pair.h"
#include "neigh/row_loop.h"
#include "particles/moments.h"
#include "particles/property.h"
#include "particles/template.h"

#include "base/banned.h"

const char *const ts_heat_schemes[] = { "euler", "exact", NULL };

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
			       "%s: contact_area is '%s', expected an area > 0", who,
			       words.word[1].text);
	}
	return ts_fail(&sim->error, TS_SYNTAX, &words.word[0].place,
		       "%s: contact_area is '%s', expected overlap, constant A or projection%s", who,
		       words.word[0].text, ts_suggest_text(&suggest));
}

/* ---- columns ---- */

/* A fix property/atom of the user's keeps this name: it says what particles start with. */
static bool is_users(const struct tsim *sim, const char *name)
{
	const struct ts_instances *fixes = &sim->instances[TS_KIND_FIX];

	for (size_t k = 0; k < fixes->n; k++)
		if (ts_streq(fixes->item[k]->style->name, "property/atom") &&
		    ts_streq(fixes->item[k]->words.word[0].text, name))
			return true;
	return false;
}

/* Values that are there stay: of an earlier fix heat/gran. */
static enum ts_status add_column(struct tsim *sim, const char *name, size_t width, unsigned flags,
				 double initial, size_t *column)
{
	struct ts_particles *p = sim->particles;
	double first[3] = { initial, initial, initial };
	size_t known = p->ncolumns;

	TS_TRY(ts_particles_add_column(sim, name, width, flags, column));
	p->column[*column].flags |= flags;
	if (is_users(sim, name))
		return TS_OK;
	TS_TRY(ts_particles_column_initial(sim, *column, first));
	if (*column == known)
		ts_particles_fill_initial(&p->column[*column], 0, p->n);
	return TS_OK;
}

static enum ts_status add_columns(struct ts_heat *h, struct tsim *sim)
{
	const unsigned result = TS_COL_NAMED | TS_COL_RESULT;

	TS_TRY(add_column(sim, "Temp", 1, TS_COL_NAMED | TS_COL_BORDER | TS_COL_FORWARD, h->initial,
			  &h->temperature));
	TS_TRY(add_column(sim, "heatFlux", 1, result, 0, &h->flux));
	TS_TRY(add_column(sim, "heatSource", 1, TS_COL_NAMED, 0, &h->source));
	TS_TRY(add_column(sim, "directionalHeatFlux", 3, result, 0, &h->directed));
	TS_TRY(add_column(sim, "heat at walls", 1, TS_COL_RESULT, 0, &h->wall_conductance));
	if (h->scheme == TS_HEAT_EXACT)
		TS_TRY(add_column(sim, "heat rate", 1,
				  TS_COL_RESULT | TS_COL_BORDER | TS_COL_FORWARD, 0, &h->rate));
	if (!h->store)
		return TS_OK;
	TS_TRY(add_column(sim, "nContactsConduction", 1, result, 0, &h->contacts));
	TS_TRY(add_column(sim, "contactAreaConduction", 1, result, 0, &h->area));
	return add_column(sim, "wallHeatFlux", 1, result, 0, &h->wall_flux);
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
			       "fix %s: there is one already (%s, line %d), and particles have one "
			       "temperature",
			       self->style->name, other->id, other->where.line);
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

enum ts_status ts_heat_conductivity(struct tsim *sim, int type, const char *who,
				    const struct ts_place *where, double *out)
{
	const struct ts_instance *by;

	TS_TRY(ts_property_value(sim, "thermalConductivity", type, 0, who, where, out));
	if (*out >= 0)
		return TS_OK;
	ts_property_find(sim, "thermalConductivity", &by);
	return ts_fail(&sim->error, TS_RANGE, &by->where,
		       "property/global thermalConductivity must be >= 0, found %.15g", *out);
}

/* Y* of two types. */
static enum ts_status stiffness(struct tsim *sim, const char *name, int a, int b,
				const struct ts_place *where, double *out)
{
	const int types[2] = { a, b };
	double sum = 0;

	for (int k = 0; k < 2; k++) {
		double young, nu;

		TS_TRY(ts_property_value(sim, name, types[k], 0, "fix heat/gran", where, &young));
		TS_TRY(ts_property_value(sim, "poissonsRatio", types[k], 0, "fix heat/gran", where,
					 &nu));
		sum += (1 - nu * nu) / young;
	}
	*out = 1 / sum;
	return TS_OK;
}

/* The elastic force is proportional to overlap^a. */
static double force_exponent(const struct tsim *sim)
{
	const struct ts_instance *inst = ts_sim_only(sim, TS_KIND_PAIR);
	const struct ts_pair *pair = inst ? inst->state : NULL;

	return pair && (pair->model.normal == TS_NORMAL_HERTZ ||
			pair->model.normal == TS_NORMAL_HERTZ_STIFFNESS)
		       ? 1.5
		       : 1;
}

static enum ts_status pair_constants(struct ts_instance *self, struct tsim *sim, int a, int b)
{
	struct ts_heat *h = self->state;
	size_t k = (size_t)a * (size_t)(h->ntypes + 1) + (size_t)b;
	double now, original;

	h->pair[k] = ts_heat_pair_conductivity(h->conductivity[a], h->conductivity[b]);
	if (!h->correction)
		return TS_OK;
	TS_TRY(stiffness(sim, "youngsModulus", a, b, &self->where, &now));
	TS_TRY(stiffness(sim, "youngsModulusOriginal", a, b, &self->where, &original));
	h->softening[k] = pow(now / original, 1 / force_exponent(sim));
	return TS_OK;
}

static enum ts_status make_room(struct ts_instance *self, struct tsim *sim)
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

static enum ts_status capacity_of(struct tsim *sim, int type, const struct ts_place *where,
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

/* The constants of all types up to the largest that particles have. */
static enum ts_status materials(struct ts_instance *self, struct tsim *sim)
{
	struct ts_heat *h = self->state;
	int most = ts_largest_type(sim);

	TS_TRY(make_room(self, sim));
	for (int t = 1; t <= most; t++) {
		TS_TRY(ts_heat_conductivity(sim, t, "fix heat/gran", &self->where,
					    &h->conductivity[t]));
		TS_TRY(capacity_of(sim, t, &self->where, &h->capacity[t]));
	}
	for (int a = 1; a <= most; a++)
		for (int b = 1; b <= most; b++)
			TS_TRY(pair_constants(self, sim, a, b));
	return TS_OK;
}

/* ---- contacts ---- */

/* Contact rows are pairs of which one moves. Held partners that touch conduct all the same. */
static enum ts_status list_held(struct ts_heat *h, struct tsim *sim)
{
	const struct ts_particles *p = sim->particles;
	size_t held = 0;

	for (size_t i = 0; i < p->n; i++)
		held += p->imass[i] == 0;
	h->held.both_held = true;
	h->held.n = 0;
	return held < 2 ? TS_OK
			: ts_rows_build(sim, &h->held, sim->neigh->built_skin,
					ts_neigh_excluded(sim));
}

enum ts_status ts_heat_built(struct ts_instance *self, struct tsim *sim)
{
	struct ts_heat *h = self->state;

	TS_TRY(materials(self, sim));
	TS_TRY(list_held(h, sim));
	h->pairs[0].rows = &sim->neigh->rows;
	h->pairs[1].rows = &h->held;
	for (int k = 0; k < 2; k++)
		if (TS_GROW(h->pairs[k].conductance, h->pairs[k].capacity, h->pairs[k].rows->n) !=
		    TS_OK)
			return ts_nomem(&sim->error);
	h->examine = true;
	return TS_OK;
}

struct task {
	const struct ts_heat *h;
	const struct ts_particles *p;
	const struct ts_heat_pairs *pairs;
	int group;
};

/* The area of contact of row r; 0: they do not touch. */
static double area_of(const struct ts_heat *h, const struct ts_particles *p, size_t i, size_t j,
		      size_t types)
{
	double d[3], d2 = ts_row_distance2(p, i, j, d), sum = p->radius[i] + p->radius[j];

	return d2 < sum * sum ? ts_heat_area_of_spheres(&h->contact, sqrt(d2), p->radius[i],
							p->radius[j],
							h->softening ? h->softening[types] : 1)
			      : 0;
}

static void find_share(void *context, size_t from, size_t to)
{
	const struct task t = *(const struct task *)context;
	const struct ts_rows *rows = t.pairs->rows;

	for (size_t r = from; r < to; r++) {
		size_t i = (size_t)rows->i[r], j = (size_t)rows->j[r];
		size_t types = (size_t)(t.p->type[i] * (t.h->ntypes + 1) + t.p->type[j]);
		bool takes_part = ts_in_group(t.p, i, t.group) || ts_in_group(t.p, j, t.group);

		t.pairs->conductance[r] =
			takes_part ? ts_heat_conductance(t.h->pair[types],
							 area_of(t.h, t.p, i, j, types))
				   : 0;
	}
}

void ts_heat_find(const struct ts_instance *self, struct tsim *sim)
{
	const struct ts_heat *h = self->state;

	for (int k = 0; k < 2; k++) {
		struct task task = { h, sim->particles, &h->pairs[k], self->group };
		size_t n = h->pairs[k].rows->n;

		ts_parallel(ts_team(sim, n), n, find_share, &task);
	}
}

/* Calls visit for each contact of particle i with its partner, in the order of identities. */
typedef void visit_fn(void *context, size_t i, size_t j, double conductance);

static inline __attribute__((always_inline)) void each_contact(const struct ts_heat *h, size_t i,
							       visit_fn *visit, void *context)
{
	for (int l = 0; l < 2; l++) {
		const struct ts_rows *rows = h->pairs[l].rows;
		const struct ts_gather *g = &rows->gather;

		for (size_t k = rows->n ? g->first[i] : 0; rows->n && k < g->first[i + 1]; k++) {
			uint32_t r = g->entry[k] >> 1;
			int32_t j = g->entry[k] & 1 ? rows->i[r] : rows->j[r];

			visit(context, i, (size_t)j, h->pairs[l].conductance[r]);
		}
	}
}

struct sum {
	const double *value;
	double total;
};

static void add_difference(void *context, size_t i, size_t j, double conductance)
{
	struct sum *s = context;

	s->total += conductance * (s->value[j] - s->value[i]);
}

double ts_heat_sum(const struct ts_heat *h, size_t i, const double *value)
{
	struct sum sum = { value, 0 };

	each_contact(h, i, add_difference, &sum);
	return sum.total;
}

static void add_conductance(void *context, size_t i, size_t j, double conductance)
{
	(void)i, (void)j;
	*(double *)context += conductance;
}

double ts_heat_conductances(const struct ts_heat *h, const struct tsim *sim, size_t i)
{
	double sum = ts_heat_column(sim, h->wall_conductance)[i];

	each_contact(h, i, add_conductance, &sum);
	return sum;
}

/* ---- fluxes ---- */

struct flow {
	const struct ts_particles *p;
	const double *temperature;
	double total, directed[3];
};

/* Half of each contact's flux along the line of centres is the particle's, half its partner's. */
static void add_flow(void *context, size_t i, size_t j, double conductance)
{
	struct flow *f = context;
	double q = conductance * (f->temperature[j] - f->temperature[i]);

	f->total += q;
	for (int k = 0; k < 3; k++)
		f->directed[k] += 0.5 * q * (f->p->x[i][k] - f->p->x[j][k]);
}

static void flow_share(void *context, size_t from, size_t to)
{
	const struct task t = *(const struct task *)context;
	double *flux = t.p->column[t.h->flux].data, *directed = t.p->column[t.h->directed].data;

	for (size_t i = from; i < to; i++) {
		struct flow flow = { t.p, t.p->column[t.h->temperature].data, 0, { 0 } };

		each_contact(t.h, i, add_flow, &flow);
		flux[i] += flow.total;
		for (int k = 0; k < 3; k++)
			directed[3 * i + (size_t)k] = flow.directed[k];
	}
}

struct contact_data {
	const struct ts_heat *h;
	const struct ts_particles *p;
	double n, area;
};

static void add_contact(void *context, size_t i, size_t j, double conductance)
{
	struct contact_data *c = context;
	size_t types = (size_t)(c->p->type[i] * (c->h->ntypes + 1) + c->p->type[j]);

	if (!(conductance > 0))
		return;
	c->n++;
	c->area += area_of(c->h, c->p, i, j, types);
}

static void store_contacts(const struct ts_heat *h, struct tsim *sim)
{
	for (size_t i = 0; i < sim->particles->n; i++) {
		struct contact_data c = { h, sim->particles, 0, 0 };

		each_contact(h, i, add_contact, &c);
		ts_heat_column(sim, h->contacts)[i] = c.n;
		ts_heat_column(sim, h->area)[i] = c.n > 0 ? c.area / c.n : 0;
	}
}

/* Walls may act before or after this fix. */
enum ts_status ts_heat_clear(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_heat *h = self->state;

	/* before a run the fluxes stay those of the last step, as in LIGGGHTS */
	for (size_t i = 0; !sim->in_setup && i < sim->particles->n; i++) {
		ts_heat_column(sim, h->flux)[i] = ts_heat_column(sim, h->wall_conductance)[i] = 0;
		if (h->store)
			ts_heat_column(sim, h->wall_flux)[i] = 0;
	}
	return TS_OK;
}

enum ts_status ts_heat_conduct(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_heat *h = self->state;
	struct task task = { .h = h, .p = sim->particles };
	size_t n = sim->particles->n;

	if (sim->in_setup)
		return TS_OK;
	ts_heat_find(self, sim);
	ts_parallel(ts_team(sim, n), n, flow_share, &task);
	if (h->store)
		store_contacts(h, sim);
	return TS_OK;
}

void ts_heat_from_wall(const struct ts_heat *h, struct tsim *sim, size_t i, double conductance,
		       double temperature)
{
	double q = conductance * (temperature - ts_heat_column(sim, h->temperature)[i]);

	if (sim->in_setup)
		return;
	ts_heat_column(sim, h->flux)[i] += q;
	ts_heat_column(sim, h->wall_conductance)[i] += conductance;
	if (h->store)
		ts_heat_column(sim, h->wall_flux)[i] += q;
}

/* ---- outputs and restart files ---- */

struct energy {
	struct ts_heat *h;
	struct ts_instance *self;
	enum ts_status status;
};

static void energy_of(const struct tsim *sim, size_t i, void *context, double *term)
{
	struct energy *e = context;
	double capacity = 0;

	if (e->status == TS_OK)
		e->status = capacity_of(e->h->sim, sim->particles->type[i], &e->self->where,
					&capacity);
	*term = sim->particles->mass[i] * capacity * ts_heat_column(sim, e->h->temperature)[i];
}

static enum ts_status eval_energy(struct ts_instance *self, const struct tsim *sim,
				  struct ts_table *out)
{
	struct energy e = { self->state, self, TS_OK };

	ts_group_sum(sim, 0, 1, energy_of, &e, out->data);
	return e.status;
}

const struct ts_value ts_heat_values[] = {
	{ .name = "heat",
	  .unit = "energy",
	  .help = "sum of m c T over all particles",
	  .shape = TS_SCALAR,
	  .columns = 1,
	  .eval = eval_energy },
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

	ts_rows_release(&h->held);
	ts_free(h->work);
	for (int k = 0; k < 2; k++)
		ts_free(h->pairs[k].conductance);
}
