/* Heat flows through contacts, and their sums by particle.
 *
 * Temperatures change only at the end of a step, so the heat flows of a block of pairs are computed as
 * soon as its contact forces are (contact_pass.h): it is known then which pairs are in contact, and
 * their data are in the caches. The sums are kept in an array of their own until stage POST_FORCE, as
 * walls may add heat before. Without a pair style, and for pairs of frozen particles, all pairs of the
 * list are computed. */
#include "base/clones.h"
TS_UNROLLED

#include "heat/heat.h"

#include <string.h>

#include "base/parallel.h"
#include "contact/contact_pass.h"
#include "core/deferred_loops.h"
#include "heat/heat_block.h"
#include "neigh/touching_sums.h"

#include "base/banned.h"

/* ---- flows through contacts */

/* Heat flow into i. The directional flux is the same for both partners, as flow and vector change sign
 * together: each gets half. */
TS_INLINE void compute_flows(const struct ts_heat_task *t, struct ts_heat_block *b)
{
	ts_four *flow = (ts_four *)t->pairs->flow;

#pragma omp simd
	for (size_t k = 0; k < b->whole; k++) {
		double q = b->h[k] * b->rise[k];

		b->flow[0][k] = q;
		for (int c = 0; c < 3; c++)
			b->flow[1 + c][k] = 0.5 * q * b->d[c][k];
	}
	for (size_t at = 0; at < b->whole; at += 4) {
		const struct ts_active_pair *near = ts_heat_batch_pair(b, at);
		ts_four row[4];

		ts_four_rows((const double(*)[TS_BATCH])b->flow, at, row);
		for (size_t k = 0; k < 4; k++)
			flow[near[k].slot] = row[k];
	}
}

/* All pairs from .. to-1 of a list. */
TS_CLONES static void compute_flows_range(void *context, size_t from, size_t to)
{
	const struct ts_heat_task t = *(const struct ts_heat_task *)context;

	ts_heat_compute_range(&t, from, to, compute_flows);
}

/* Prefetches the data of the active pairs of a block; those of the first particles are contiguous in
 * memory. */
TS_INLINE void prefetch_block(const struct ts_heat_task *t, const struct ts_active_block *block)
{
	const struct ts_active_pair *near = t->pairs->rows->active + block->first,
				    *end = near + block->touching;
	const struct ts_contact_sphere *sphere = t->pairs->rows->sphere;
	const double *temperature = t->temperature;
	const struct ts_heat_flow *flow = t->pairs->flow;

	for (; near < end; near++) {
		__builtin_prefetch(sphere[near->j].position);
		__builtin_prefetch(temperature + near->j);
		__builtin_prefetch(flow + near->slot, 1);
	}
}

/* The touching pairs of the blocks from .. to-1; the flows of all others are not summed. */
TS_CLONES static void compute_flows_of_blocks(void *context, size_t from, size_t to)
{
	const struct ts_heat_task t = ts_heat_task(context, 0);
	const struct ts_contact_list *rows = t.pairs->rows;
	struct ts_heat_block b;

	for (size_t l = from; l < to; l++) {
		const struct ts_active_block *block = &rows->block[l];
		const struct ts_active_pair *near = rows->active + block->first;
		size_t types = (size_t)(block->type[0] * (t.h->ntypes + 1) + block->type[1]);

		prefetch_block(&t, block + 1);
		for (size_t k = 0; k < TS_BATCH; k++)
			ts_heat_batch_constants(&t, types, &b, k);
		for (size_t at = 0; at < block->touching; at += TS_BATCH) {
			ts_heat_batch_start(&b, near + at,
					    block->touching - at < TS_BATCH ? block->touching - at
									    : TS_BATCH);
			ts_heat_batch_load(&t, true, &b);
			ts_heat_batch_conductances(&t, &b);
			compute_flows(&t, &b);
		}
	}
}

/* ---- sums by particle */

/* `entry`: 2 slot + side. */
TS_INLINE void add_flows(const struct ts_heat_flow *flow, const uint32_t *entry, size_t n, ts_four *sum)
{
	static const ts_four signs[2] = { { 1, 1, 1, 1 }, { -1, 1, 1, 1 } };
	const ts_four *flows = (const ts_four *)flow;

	for (size_t k = 0; k < n; k++)
		*sum += signs[entry[k] & 1] * flows[entry[k] >> 1];
}

TS_INLINE void add_flows_of_touching(const struct ts_heat_pairs *pairs, size_t i, ts_four *sum)
{
	const struct ts_contact_list *rows = pairs->rows;
	size_t n = rows->sums[i], in_row = n < TS_SUM_ROW ? n : TS_SUM_ROW;

	add_flows(pairs->flow, rows->sum + TS_SUM_ROW * i, in_row, sum);
	add_flows(pairs->flow, rows->sum_rest + rows->rest_first[i], n - in_row, sum);
}

TS_INLINE void add_flows_of_list(const struct ts_heat_pairs *pairs, size_t i, ts_four *sum)
{
	const struct ts_gather *g = &pairs->rows->gather;

	if (pairs->rows->n)
		add_flows(pairs->flow, g->entry + g->first[i], g->first[i + 1] - g->first[i], sum);
}

/* Sums the heat flows into the particles from .. to-1. */
TS_CLONES static void sum_flows_range(void *context, size_t from, size_t to)
{
	const struct ts_heat *h = ((const struct ts_instance *)context)->state;
	const struct ts_heat_pairs *pairs = h->pairs;
	double *inner = h->inner, *directed = ts_heat_column(h->sim, h->directed);
	bool known = h->fused_pass.begun, held = pairs[1].rows->n > 0;

	for (size_t i = from; i < to; i++) {
		ts_four sum = { 0 };

		if (known)
			add_flows_of_touching(pairs, i, &sum);
		else
			add_flows_of_list(&pairs[0], i, &sum);
		if (held)
			add_flows_of_list(&pairs[1], i, &sum);
		inner[i] = sum[0];
		for (int c = 0; c < 3; c++)
			directed[3 * i + (size_t)c] = sum[1 + c];
	}
}

/* ---- stages */

struct columns {
	double *flux, *wall_conductance, *wall_flux; /* wall_flux: NULL unless store_contact_data */
	const double *inner;
};

static struct columns columns_of(const struct ts_heat *h)
{
	return (struct columns){ ts_heat_column(h->sim, h->flux), ts_heat_column(h->sim, h->wall_conductance),
				 h->store ? ts_heat_column(h->sim, h->wall_flux) : NULL, h->inner };
}

static void clear_fluxes_range(void *context, size_t from, size_t to)
{
	const struct columns c = *(const struct columns *)context;
	size_t bytes = (to - from) * sizeof *c.flux;

	memset(c.flux + from, 0, bytes);
	memset(c.wall_conductance + from, 0, bytes);
	if (c.wall_flux)
		memset(c.wall_flux + from, 0, bytes);
}

static void add_conducted_heat(void *context, size_t from, size_t to)
{
	const struct columns c = *(const struct columns *)context;

	for (size_t i = from; i < to; i++)
		c.flux[i] += c.inner[i];
}

/* Allocates the flows of a list; sets all conductances to 0, as only contacts are stored below. */
static enum ts_status allocate_flows(const struct ts_heat *h, struct ts_heat_pairs *pairs, size_t slots)
{
	size_t n = pairs->rows->n;

	if (h->keeps && n)
		memset(pairs->conductance, 0, n * sizeof *pairs->conductance);
	return TS_RENEW(pairs->flow, pairs->flow_capacity, slots);
}

/* Start of the pass: pairs of frozen particles are in no block, so their flows are computed here. */
static enum ts_status start_pass(struct tsim *sim, void *context)
{
	const struct ts_instance *self = context;
	struct ts_heat *h = self->state;
	const struct ts_contact_list *rows = h->pairs[0].rows;
	struct ts_heat_task held;
	size_t n = h->held.n;

	h->keeps = h->scheme == TS_HEAT_EXACT || h->store || sim->run.complete;
	if (TS_RENEW(h->inner, h->inner_capacity, sim->particles->n) != TS_OK ||
	    allocate_flows(h, &h->pairs[0],
			   h->fused_pass.begun ? rows->result_capacity / (size_t)rows->parts : rows->n) !=
		    TS_OK ||
	    allocate_flows(h, &h->pairs[1], n) != TS_OK)
		return ts_nomem(&sim->error);
	held = ts_heat_task(self, 1);
	ts_parallel(ts_team(sim, n), n, compute_flows_range, &held);
	return TS_OK;
}

/* Clears the fluxes at the start of a step: walls may add to them before or after this fix. */
enum ts_status ts_heat_clear(struct ts_instance *self, struct tsim *sim)
{
	struct ts_heat *h = self->state;
	struct columns c = columns_of(h);

	TS_TRY(ts_heat_check_divergence(self, sim)); /* temperatures after the last step */
	/* in the set-up of a run the fluxes keep their values of the last step, as in LIGGGHTS */
	if (sim->run.in_setup)
		return TS_OK;
	h->fused_pass = (struct ts_fused_pass){ { compute_flows_of_blocks, sum_flows_range, self, true },
						start_pass,
						false };
	ts_contacts_fuse(sim, &h->fused_pass);
	TS_DEFER_LOOP(sim, sim->particles->n, clear_fluxes_range, &c);
	return TS_OK;
}

/* Computes all pairs of the list: without a pair style no pass of forces runs. */
static enum ts_status conduct_without_forces(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_heat *h = self->state;
	size_t rows = h->pairs[0].rows->n, n = sim->particles->n;
	struct ts_heat_task task;

	TS_TRY(start_pass(sim, self));
	task = ts_heat_task(self, 0);
	ts_parallel(ts_team(sim, rows), rows, compute_flows_range, &task);
	ts_parallel(ts_team(sim, n), n, sum_flows_range, self);
	return TS_OK;
}

enum ts_status ts_heat_conduct(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_heat *h = self->state;
	struct columns c;

	if (sim->run.in_setup)
		return TS_OK;
	if (!h->fused_pass.begun)
		TS_TRY(conduct_without_forces(self, sim));
	c = columns_of(h);
	TS_DEFER_LOOP(sim, sim->particles->n, add_conducted_heat, &c);
	if (h->store)
		ts_heat_store_contacts(self, sim);
	return TS_OK;
}

double ts_heat_from_outside(const struct ts_heat *h, struct tsim *sim, size_t i, double conductance,
			    double temperature)
{
	double q = conductance * (temperature - ts_heat_column(sim, h->temperature)[i]);

	if (sim->run.in_setup)
		return q;
	ts_heat_column(sim, h->flux)[i] += q;
	ts_heat_column(sim, h->wall_conductance)[i] += conductance;
	return q;
}

double ts_heat_from_wall(const struct ts_heat *h, struct tsim *sim, size_t i, double conductance,
			 double temperature)
{
	const double q = ts_heat_from_outside(h, sim, i, conductance, temperature);

	if (h->store && !sim->run.in_setup)
		ts_heat_column(sim, h->wall_flux)[i] += q;
	return q;
}
