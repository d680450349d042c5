#include "coupling/cell_rehearsal.h"

#include "base/alloc.h"
#include "coupling/cell_order.h"
#include "coupling/interpolation_weights.h"
#include "particle/particles.h"
#include "rank/rehearsal.h"

#include "base/banned.h"

struct rehearsal {
	const struct tsim *sim;
	const struct ts_fluid *fluid;
	const struct ts_rank_layout *layout;
	struct ts_world world; /* its rank: the present one */
	int sorts;	       /* how often particles are sorted in a step, and sent for it */
	int reach;	       /* number of cells to which they add beyond their own */
	bool near;	       /* what they add is counted elsewhere */
	struct ts_cell_owners owners;
	struct ts_cell_senders senders;
	/* Particles by rank: those of rank r are first[r] .. first[r + 1] - 1. Owned, as the arrays below */
	size_t *first;
	double (*x)[3], *radius;
	int32_t *tag, *cell;
	uint32_t *mask;
};

/* ---- the fixes that take part */

static const struct ts_flow_part *next_part(const struct tsim *sim, size_t *k)
{
	const struct ts_instance *part;

	while ((part = ts_sim_next_of(sim, TS_KIND_FIX, TS_FAMILY_FLOW_PART, k)))
		if (((const struct ts_flow_part *)part->state)->sends.particles)
			return part->state;
	return NULL;
}

/* Fixes share the sorted particles of the first one that offers them. */
static void find_sorts(struct rehearsal *r)
{
	const struct ts_flow_part *part;
	bool shared = false;

	r->reach = 1;
	for (size_t k = 0; (part = next_part(r->sim, &k)); r->sorts++) {
		shared |= part->order != NULL;
		if (part->order && part->order->own.reach > r->reach)
			r->reach = part->order->own.reach;
	}
	if (shared)
		r->sorts = 1;
}

/* ---- particles by rank */

static int32_t cell_of(const struct rehearsal *r, const double x[3])
{
	const int *n = r->fluid->grid.n;
	double place[3];
	int cell[3];

	if (!ts_coupling_locate(r->fluid, x, place, cell))
		return -1;
	return (cell[2] * n[1] + cell[1]) * n[0] + cell[0];
}

/* Only places matter: radius, tag and mask are sent as they are. */
static enum ts_status sort_particles(struct rehearsal *r)
{
	const struct ts_particles *p = r->sim->particles;
	const size_t ranks = (size_t)r->layout->ranks;

	r->first = ts_alloc(ranks + 2, sizeof *r->first);
	r->x = ts_alloc(p->n, sizeof *r->x);
	r->radius = ts_alloc(p->n, sizeof *r->radius);
	r->tag = ts_alloc(p->n, sizeof *r->tag);
	r->mask = ts_alloc(p->n, sizeof *r->mask);
	r->cell = ts_alloc(p->n, sizeof *r->cell);
	if (!r->first || !r->x || !r->radius || !r->tag || !r->mask || !r->cell)
		return TS_NOMEM;
	for (size_t k = 0; k < ranks; k++)
		r->first[k + 2] = r->first[k + 1] + r->layout->part[k].particles;
	for (size_t i = 0; i < p->n; i++) {
		const size_t at = r->first[r->layout->owner[i] + 1]++;

		for (int d = 0; d < 3; d++)
			r->x[at][d] = p->x[i][d];
		r->cell[at] = cell_of(r, p->x[i]);
	}
	return TS_OK;
}

static enum ts_status make_owners(struct rehearsal *r)
{
	double most = 0;

	for (int k = 0; k < r->layout->ranks; k++)
		if ((double)r->layout->part[k].particles > most)
			most = (double)r->layout->part[k].particles;
	return ts_cell_owners_make(&r->owners, 0, &r->fluid->grid, &r->layout->blocks,
				   !r->near && ts_cell_order_few(most, r->layout->ranks,
								 ts_grid_cells(&r->fluid->grid)));
}

/* ---- what the present rank sends */

/* Counts so many fields of which all ranks get all cells, in one message. */
static void send_cells(struct rehearsal *r, int fields)
{
	const size_t cells = ts_cell_owners_count(&r->owners, r->world.rank);

	if (!fields || !cells || r->owners.all || r->near)
		return;
	r->world.counts.messages++;
	r->world.counts.bytes += (int64_t)((size_t)fields * sizeof(double) * cells);
}

static enum ts_status send_numbers(struct rehearsal *r)
{
	static const double numbers[TS_FLOW_PART_NUMBERS] = { 0 };
	const struct ts_flow_part *part;
	struct ts_parcel received = { 0 };
	enum ts_status status = TS_OK;

	for (size_t k = 0; (part = next_part(r->sim, &k)) && status == TS_OK;)
		if (part->sends.numbers)
			status = ts_cell_senders_numbers(&r->senders, &r->world, numbers, 0,
							 (size_t)part->sends.numbers, &received);
	ts_parcel_release(&received);
	return status;
}

static void send_fields(struct rehearsal *r)
{
	const struct ts_fluid *fluid = r->fluid;
	const struct ts_flow_part *part;
	bool reacts = false;
	int fields = 0;

	for (size_t k = 0; (part = next_part(r->sim, &k));) {
		reacts |= part->sends.reaction;
		for (int f = 0; f < part->sends.fields + part->sends.sums; f++)
			send_cells(r, 1);
	}
	for (int d = 0; d < 3 && reacts; d++)
		fields += (fluid->force[d] != NULL) + (fluid->exchange[d] != NULL);
	send_cells(r, fields);
}

static enum ts_status send_all(struct rehearsal *r)
{
	const size_t from = r->first[r->world.rank], n = r->first[r->world.rank + 1] - from;
	struct ts_cell_rows rows = { .n = n,
				     .own = n,
				     .x = (const double(*)[3])r->x + from,
				     .radius = r->radius + from,
				     .tag = r->tag + from,
				     .mask = r->mask + from };

	const struct ts_cell_space space = { &r->fluid->grid, &r->layout->blocks, &r->owners,
					     ts_cell_frame_of_grid(&r->fluid->grid) };

	for (int k = 0; k < r->sorts; k++)
		TS_TRY(ts_cell_senders_rows(&r->senders, &r->world, &space, r->reach, r->cell + from, &rows));
	TS_TRY(send_numbers(r));
	send_fields(r);
	/* the other ranks of a cell depend on the rank that asks */
	for (size_t k = from; k < from + n; k++)
		if (r->cell[k] >= 0)
			r->senders.cell[r->cell[k]].n = -1;
	r->senders.nother = 0;
	return TS_OK;
}

static enum ts_status rehearse(struct rehearsal *r, int64_t steps, struct ts_world_counts *sent)
{
	find_sorts(r);
	TS_TRY(sort_particles(r));
	TS_TRY(make_owners(r));
	for (int rank = 0; rank < r->layout->ranks; rank++) {
		ts_rehearsal_make(&r->world, rank, r->layout->ranks);
		TS_TRY(send_all(r));
		sent[rank].messages += steps * r->world.counts.messages;
		sent[rank].bytes += steps * r->world.counts.bytes;
	}
	return TS_OK;
}

enum ts_status ts_cell_rehearse(struct tsim *sim, const struct ts_fluid *fluid,
				const struct ts_rank_layout *layout, int64_t steps, bool near,
				struct ts_world_counts *sent)
{
	struct rehearsal r = { .sim = sim, .fluid = fluid, .layout = layout, .near = near };
	enum ts_status status = TS_OK;
	size_t k = 0;

	if (next_part(sim, &k))
		status = rehearse(&r, steps, sent);
	ts_cell_senders_release(&r.senders);
	ts_cell_owners_release(&r.owners);
	ts_free(r.first);
	ts_free(r.x);
	ts_free(r.radius);
	ts_free(r.tag);
	ts_free(r.mask);
	ts_free(r.cell);
	return status;
}
