/* The heat that touching particles conduct: conductances of contacts, and what flows through them. */
#include "neigh/heat.h"

#include <math.h>
#include <string.h>

#include "base/clones.h"
#include "base/inline.h"
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
	for (int k = 0; k < 2; k++) {
		struct ts_heat_pairs *pairs = &h->pairs[k];

		if (TS_GROW(pairs->conductance, pairs->capacity, pairs->rows->n) != TS_OK ||
		    TS_GROW(pairs->flow, pairs->flow_capacity, pairs->rows->n) != TS_OK)
			return ts_nomem(&sim->error);
	}
	h->examine = true;
	return TS_OK;
}

/* What rows are read by, out of the structures: nothing that is written can change it. */
struct task {
	const struct ts_heat *h;
	const struct ts_particles *p;
	const struct ts_heat_pairs *pairs;
	int group;
	bool known; /* which rows touch: the forces of this step have been computed */
	const double (*x)[3];
	const double *radius;
	const int *type;
};

/* The area of contact at the distance d from j to i; 0: they do not touch. */
TS_INLINE double area_of(const struct task *t, size_t i, size_t j, size_t types, double d[3])
{
	double sum = t->radius[i] + t->radius[j], d2;

	for (int k = 0; k < 3; k++)
		d[k] = t->x[i][k] - t->x[j][k];
	d2 = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
	return d2 < sum * sum
		       ? ts_heat_area_of_spheres(&t->h->contact, sqrt(d2), t->radius[i],
						 t->radius[j],
						 t->h->softening ? t->h->softening[types] : 1)
		       : 0;
}

TS_INLINE size_t types_of(const struct task *t, size_t i, size_t j)
{
	return (size_t)(t->type[i] * (t->h->ntypes + 1) + t->type[j]);
}

/* A number of rows at once, of those of a range that may touch. */
struct block {
	double d[4][TS_COLUMN], other[TS_COLUMN]; /* vector from j to i and radius of i; radius of j */
	double pair[TS_COLUMN], softening[TS_COLUMN], h[TS_COLUMN]; /* by types; conductance */
	size_t n;
	uint32_t row[TS_COLUMN + 8];
} __attribute__((aligned(64)));

static void load_block(const struct task *t, size_t n, struct block *b)
{
	const struct ts_rows *rows = t->pairs->rows;
	const double *softening = t->h->softening;

	for (size_t at = 0; at < n; at += 4) {
		ts_four d[4];

		for (size_t k = 0; k < 4; k++) {
			size_t i = (size_t)rows->i[b->row[at + k]], j = (size_t)rows->j[b->row[at + k]];
			size_t types = types_of(t, i, j);

			d[k] = TS_FOUR_AT(t->x[i]) - TS_FOUR_AT(t->x[j]);
			d[k][3] = t->radius[i];
			b->other[at + k] = t->radius[j];
			b->pair[at + k] = t->h->pair[types];
			b->softening[at + k] = softening ? softening[types] : 1;
		}
		ts_four_columns(d, b->d, at);
	}
}

/* Where surfaces cut each other, in a loop without branches; the same numbers as area_of. */
TS_CLONES static void overlap_block(size_t n, struct block *b)
{
#pragma omp simd
	for (size_t r = 0; r < n; r++) {
		double ri = b->d[3][r], rj = b->other[r], sum = ri + rj;
		double square = b->d[0][r] * b->d[0][r] + b->d[1][r] * b->d[1][r] + b->d[2][r] * b->d[2][r];
		double distance = sum - b->softening[r] * (sum - sqrt(square));
		double larger = ri > rj ? ri : rj, smaller = ri > rj ? rj : ri;
		double lens = ts_lens_of_spheres(distance, ri, rj);
		double area = distance < larger ? TS_PI * smaller * smaller : lens;

		area = square < sum * sum ? area : 0;
		b->h[r] = ts_heat_conductance(b->pair[r], area > 0 ? area : 0);
	}
}

static void other_block(const struct task *t, struct block *b)
{
	for (size_t r = 0; r < b->n; r++) {
		size_t i = (size_t)t->pairs->rows->i[b->row[r]], j = (size_t)t->pairs->rows->j[b->row[r]];
		size_t types = types_of(t, i, j);
		double d[3];

		b->h[r] = ts_heat_conductance(t->h->pair[types], area_of(t, i, j, types, d));
		for (int k = 0; k < 3; k++)
			b->d[k][r] = d[k];
	}
}

/* The rows of from .. to-1 that may touch; behind them the last again and again. */
static void list_block(const struct task *t, size_t from, size_t to, struct block *b)
{
	const uint8_t *touching = t->pairs->rows->touching;

	b->n = 0;
	for (size_t r = from; r < to; r++) {
		b->row[b->n] = (uint32_t)r;
		b->n += !t->known || touching[r];
	}
	for (size_t k = b->n; k < b->n + 8; k++)
		b->row[k] = b->n ? b->row[b->n - 1] : (uint32_t)from;
}

static void find_block(const struct task *t, size_t from, size_t to, struct block *b)
{
	const struct ts_rows *rows = t->pairs->rows;
	double *conductance = t->pairs->conductance;

	list_block(t, from, to, b);
	if (t->h->contact.kind == TS_HEAT_OVERLAP) {
		size_t n = (b->n + 7) & ~(size_t)7;

		load_block(t, n, b);
		overlap_block(n, b);
	} else {
		other_block(t, b);
	}
	memset(conductance + from, 0, (to - from) * sizeof *conductance);
	for (size_t k = 0; k < b->n; k++) {
		size_t r = b->row[k];

		if (t->group && !ts_in_group(t->p, (size_t)rows->i[r], t->group) &&
		    !ts_in_group(t->p, (size_t)rows->j[r], t->group))
			b->h[k] = 0;
		conductance[r] = b->h[k];
	}
}

static void find_share(void *context, size_t from, size_t to)
{
	struct block b;

	for (size_t end; from < to; from = end) {
		end = to - from < TS_COLUMN ? to : from + TS_COLUMN;
		find_block(context, from, end, &b);
	}
}

static struct task task_of(const struct ts_heat *h, const struct tsim *sim,
			   const struct ts_heat_pairs *pairs, int group)
{
	const struct ts_particles *p = sim->particles;

	return (struct task){ h, p, pairs, group, false, (const double (*)[3])p->x, p->radius, p->type };
}

static void for_rows(const struct ts_instance *self, struct tsim *sim, bool known, ts_share_fn *share)
{
	const struct ts_heat *h = self->state;

	for (int k = 0; k < 2; k++) {
		struct task task = task_of(h, sim, &h->pairs[k], self->group);
		size_t n = h->pairs[k].rows->n;

		task.known = known && k == 0;
		ts_parallel(ts_team(sim, n), n, share, &task);
	}
}

void ts_heat_find(const struct ts_instance *self, struct tsim *sim)
{
	for_rows(self, sim, false, find_share);
}

/* Calls visit for each contact of particle i with its partner, in the order of identities. */
typedef void visit_fn(void *context, size_t i, size_t j, double conductance);

TS_INLINE void each_contact(const struct ts_heat *h, size_t i, visit_fn *visit, void *context)
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

/* What flows into i; half of it along the line of centres is either partner's share of the vector, since flux and line
 * change sign together. */
static void flow_share(void *context, size_t from, size_t to)
{
	const struct task t = *(const struct task *)context;
	const double *temperature = t.p->column[t.h->temperature].data;
	const struct ts_rows *rows = t.pairs->rows;
	struct block b;

	for (size_t end; from < to; from = end) {
		end = to - from < TS_COLUMN ? to : from + TS_COLUMN;
		find_block(&t, from, end, &b);
		memset(t.pairs->flow + from, 0, (end - from) * sizeof *t.pairs->flow);
		for (size_t k = 0; k < b.n; k++) {
			size_t r = b.row[k];
			double q = b.h[k] * (temperature[rows->j[r]] - temperature[rows->i[r]]);

			t.pairs->flow[r] = (struct ts_heat_flow){
				{ q, 0.5 * q * b.d[0][k], 0.5 * q * b.d[1][k], 0.5 * q * b.d[2][k] }
			};
		}
	}
}

/* Adds what flows through the pairs of a list: flux and vector as four numbers. */
TS_INLINE void gather_list(const struct ts_heat_pairs *pairs, size_t i, double sum[4])
{
	static const double signs[2][4] = { { 1, 1, 1, 1 }, { -1, 1, 1, 1 } };
	const struct ts_gather *g = &pairs->rows->gather;

	for (size_t k = g->first[i]; k < g->first[i + 1]; k++) {
		const double *sign = signs[g->entry[k] & 1];
		const double *flow = pairs->flow[g->entry[k] >> 1].number;

#pragma omp simd
		for (int c = 0; c < 4; c++)
			sum[c] += sign[c] * flow[c];
	}
}

static void gather_share(void *context, size_t from, size_t to)
{
	const struct task t = *(const struct task *)context;
	double *flux = t.p->column[t.h->flux].data, *directed = t.p->column[t.h->directed].data;
	bool any[2] = { t.h->pairs[0].rows->n > 0, t.h->pairs[1].rows->n > 0 };

	for (size_t i = from; i < to; i++) {
		double sum[4] = { 0 };

		for (int l = 0; l < 2; l++)
			if (any[l])
				gather_list(&t.h->pairs[l], i, sum);
		flux[i] += sum[0];
		for (int c = 0; c < 3; c++)
			directed[3 * i + (size_t)c] = sum[1 + c];
	}
}

struct contact_data {
	struct task task;
	double n, area;
};

static void add_contact(void *context, size_t i, size_t j, double conductance)
{
	struct contact_data *c = context;
	double d[3];

	if (!(conductance > 0))
		return;
	c->n++;
	c->area += area_of(&c->task, i, j, types_of(&c->task, i, j), d);
}

static void store_contacts(const struct ts_heat *h, struct tsim *sim)
{
	for (size_t i = 0; i < sim->particles->n; i++) {
		struct contact_data c = { task_of(h, sim, NULL, 0), 0, 0 };

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
	struct task task = task_of(h, sim, NULL, self->group);
	size_t n = sim->particles->n;

	if (sim->in_setup)
		return TS_OK;
	for_rows(self, sim, ts_sim_only(sim, TS_KIND_PAIR) != NULL, flow_share);
	ts_parallel(ts_team(sim, n), n, gather_share, &task);
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
