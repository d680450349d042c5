/* The heat that touching particles conduct: conductances of contacts, and what flows through them. */
#include "neigh/heat.h"

#include <math.h>

#include "base/parallel.h"
#include "neigh/row_loop.h"

#include "base/banned.h"

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

	TS_TRY(ts_heat_materials(self, sim));
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
