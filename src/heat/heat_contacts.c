/* The contacts that conduct heat: conductances and their sums by particle. Heat flows are in
 * heat_flow.c. */
#include "heat/heat.h"

#include "base/inline.h"
#include "base/parallel.h"
#include "heat/heat_block.h"
#include "neigh/neigh.h"
#include "particle/division.h"

#include "base/banned.h"

/* The contact list has no pairs of two frozen particles, but they conduct heat: they get a list of
 * their own. */
static enum ts_status list_frozen_pairs(struct ts_heat *h, struct tsim *sim)
{
	const struct ts_particles *p = sim->particles;
	size_t held = 0;

	for (size_t i = 0; i < p->n; i++)
		held += p->imass[i] == 0;
	h->held.both_frozen = true;
	h->held.n = 0;
	/* the other one may be of another rank */
	return held < (sim->division ? 1 : 2)
		       ? TS_OK
		       : ts_contact_list_build(sim, &h->held, sim->neigh->built_skin, ts_neigh_excluded(sim));
}

enum ts_status ts_heat_update_contacts(struct ts_instance *self, struct tsim *sim)
{
	struct ts_heat *h = self->state;

	TS_TRY(ts_heat_materials(self, sim));
	TS_TRY(list_frozen_pairs(h, sim));
	h->pairs[0].rows = &sim->neigh->contacts;
	h->pairs[1].rows = &h->held;
	for (int k = 0; k < 2; k++) {
		struct ts_heat_pairs *pairs = &h->pairs[k];

		if (TS_GROW(pairs->conductance, pairs->capacity, pairs->rows->n) != TS_OK)
			return ts_nomem(&sim->error);
	}
	if (!sim->particles->division || !sim->particles->division->rebuilding)
		h->examine = true;
	else if (!sim->division) /* all ranks have got all particles: outputs may read conductances */
		ts_heat_find_conductances(self, sim);
	return TS_OK;
}

/* ---- conductances of all pairs */

static void find_conductances_range(void *context, size_t from, size_t to)
{
	const struct ts_heat_task t = *(const struct ts_heat_task *)context;

	ts_heat_compute_range(&t, from, to, NULL);
}

void ts_heat_find_conductances(const struct ts_instance *self, struct tsim *sim)
{
	const struct ts_heat *h = self->state;

	for (int k = 0; k < 2; k++) {
		struct ts_heat_task task = ts_heat_task(self, k);
		size_t n = h->pairs[k].rows->n;

		task.keeps = true;
		ts_parallel(ts_team(sim, n), n, find_conductances_range, &task);
	}
}

/* ---- sums over the contacts of a particle */

/* Calls visit for each contact of particle i with its partner j, in the order of the identities. */
typedef void visit_fn(void *context, size_t i, size_t j, double conductance);

TS_INLINE void visit_contacts(const struct ts_heat *h, size_t i, visit_fn *visit, void *context)
{
	for (int l = 0; l < 2; l++) {
		const struct ts_contact_list *rows = h->pairs[l].rows;
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

double ts_heat_sum_differences(const struct ts_heat *h, size_t i, const double *value)
{
	struct sum sum = { value, 0 };

	visit_contacts(h, i, add_difference, &sum);
	return sum.total;
}

static void add_conductance(void *context, size_t i, size_t j, double conductance)
{
	(void)i, (void)j;
	*(double *)context += conductance;
}

double ts_heat_sum_conductances(const struct ts_heat *h, const struct tsim *sim, size_t i)
{
	double sum = ts_heat_column(sim, h->wall_conductance)[i];

	visit_contacts(h, i, add_conductance, &sum);
	return sum;
}

/* ---- data of contacts */

struct contact_data {
	struct ts_heat_task task;
	double n, area;
};

static void add_contact(void *context, size_t i, size_t j, double conductance)
{
	struct contact_data *c = context;

	if (!(conductance > 0))
		return;
	c->n++;
	c->area += ts_heat_area(&c->task, i, j);
}

void ts_heat_store_contacts(const struct ts_instance *self, struct tsim *sim)
{
	const struct ts_heat *h = self->state;

	for (size_t i = 0; i < sim->particles->n; i++) {
		struct contact_data c = { ts_heat_task(self, 0), 0, 0 };

		visit_contacts(h, i, add_contact, &c);
		ts_heat_column(sim, h->contacts)[i] = c.n;
		ts_heat_column(sim, h->area)[i] = c.n > 0 ? c.area / c.n : 0;
	}
}
