#include "neigh/active_pairs.h"

#include <math.h>
#include <string.h>

#include "base/clones.h"
#include "base/four.h"
#include "base/parallel.h"
#include "core/deferred_loops.h"
#include "particle/particles.h"

#include "base/banned.h"

/* ---- packed particles, and their displacements */

/* Packs the particles from .. to-1. most: squares of the largest displacements since they were packed last, less the
 * drift, in x, y and z, length^2; most[3] > 0 if a radius has changed. */
TS_CLONES static void pack_spheres(const struct ts_particles *p, const struct ts_contact_list *list,
				   size_t from, size_t to, double most[4])
{
	struct ts_contact_sphere *sphere = list->sphere;
	struct ts_contact_motion *motion = list->motion;
	const ts_four drift = { list->drift[0], list->drift[1], list->drift[2], 0 };
	ts_four largest = { 0 };

	for (size_t i = from; i < to; i++) {
		const ts_four radius = TS_FOUR_BROADCAST(p->radius[i]),
			      imass = TS_FOUR_BROADCAST(p->imass[i]);
		ts_four now = TS_FOUR_LOAD(p->x[i]), velocity = TS_FOUR_LOAD(p->v[i]), omega = { 0 }, step;

		now = TS_FOUR_LAST(now, radius);
		velocity = TS_FOUR_LAST(velocity, imass);
		if (p->omega)
			omega = TS_FOUR_LOAD(p->omega[i]);
		omega = TS_FOUR_LAST(omega, radius);
		step = now - *(ts_four *)sphere[i].position - drift;
		step *= step;
		*(ts_four *)sphere[i].position = now;
		*(ts_four *)motion[i].velocity = velocity;
		*(ts_four *)motion[i].omega = omega;
		ts_four_max(&largest, &step);
	}
	for (int k = 0; k < 4; k++)
		most[k] = largest[k];
}

struct packing {
	const struct ts_particles *p;
	struct ts_contact_list *list;
};

static void pack_share(void *context, size_t from, size_t to)
{
	const struct packing *g = context;
	double most[4], displacement, known;

	pack_spheres(g->p, g->list, from, to, most);
	/* after a change of radius there is no bound of the approach of surfaces */
	displacement = most[3] > 0 ? INFINITY : sqrt(most[0] + most[1] + most[2]);
#pragma omp atomic read
	known = g->list->displacement;
	if (displacement <= known) /* as a rule: blocks are small, and a lock for each would be contended */
		return;
#pragma omp critical(ts_displacement)
	g->list->displacement = fmax(g->list->displacement, displacement);
}

void ts_contact_list_locate_locals(struct tsim *sim, struct ts_contact_list *list)
{
	struct packing g = { sim->particles, list };

	if (!list->sphere || list->particles != sim->particles->n)
		return;
	TS_DEFER_LOOP(sim, list->particles, pack_share, &g);
	list->locals_packed = true;
}

static void pack_remaining_share(void *context, size_t from, size_t to)
{
	const struct packing *g = context;
	size_t first = g->list->locals_packed ? g->list->particles : 0;

	pack_share(context, first + from, first + to);
}

void ts_contact_list_locate(const struct tsim *sim, struct ts_contact_list *list)
{
	size_t n = sim->particles->n + sim->particles->nghost - (list->locals_packed ? list->particles : 0);
	struct packing g = { sim->particles, list };

	ts_parallel(ts_team(sim, n), n, pack_remaining_share, &g);
	if (list->active_chosen) {
		list->max_displacement = list->displacement;
		list->approach += 2 * list->displacement;
	}
	list->displacement = 0;
	list->locals_packed = false;
}

/* 0.999: margin for the rounding of positions, which is far smaller than that. */
bool ts_active_pairs_outdated(const struct ts_contact_list *list)
{
	return !list->active_chosen || !(list->approach <= 0.999 * list->inner_skin);
}

/* ---- which pairs are active */

/* Active pairs are sorted by contact law in groups of GROUP_LEAST; with many laws, whose blocks would be
 * short, in groups of GROUP_PER_LAW for each law, at most GROUP_MOST. */
enum { GROUP_LEAST = 512, GROUP_PER_LAW = 128, GROUP_MOST = 4096 };

struct choice {
	struct ts_contact_list *list;
	const struct ts_particles *p;
	size_t kinds; /* number of pairs of particle types */
	size_t group;
};

/* The next active pairs among the candidate pairs *r .. end-1, at most a group. A pair that touched is active
 * whatever its distance, since the law must see it part. */
static size_t collect_active(const struct choice *c, size_t *r, size_t end, uint32_t *chosen)
{
	const struct ts_contact_list *list = c->list;
	size_t n = 0, k = *r;

	for (; k < end && n < c->group; k++) {
		const double *a = list->sphere[list->i[k]].position, *b = list->sphere[list->j[k]].position;
		double x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2],
		       reach = a[3] + b[3] + list->inner_skin;

		chosen[n] = (uint32_t)k;
		ts_contact_set_slot(list, k, TS_PAIR_INACTIVE);
		n += (x * x + y * y + z * z < reach * reach) | ts_contact_touches(list, k);
	}
	*r = k;
	return n;
}

/* Moves the pairs with these two particle types, in either order, to the front of the list; returns their
 * number. Contact laws do not depend on which of the two particles is i. */
static size_t move_types_to_front(const struct choice *c, const int32_t type[2], uint32_t *chosen, size_t n)
{
	size_t same = 0;

	for (size_t k = 0; k < n; k++) {
		uint32_t r = chosen[k];
		int32_t i = c->p->type[c->list->i[r]], j = c->p->type[c->list->j[r]];

		chosen[k] = chosen[same];
		chosen[same] = r;
		same += (i == type[0] && j == type[1]) || (i == type[1] && j == type[0]);
	}
	return same;
}

/* Moves the pairs that touch to the front; returns their number. Both parts stay in order. */
static size_t touching_first(const struct ts_contact_list *list, uint32_t *chosen, size_t n)
{
	uint32_t apart[GROUP_MOST];
	size_t touching = 0;

	for (size_t k = 0; k < n; k++) {
		uint32_t r = chosen[k];

		chosen[touching] = apart[k - touching] = r;
		touching += ts_contact_touches(list, r);
	}
	memcpy(chosen + touching, apart, (n - touching) * sizeof *chosen);
	return touching;
}

static void append_pairs(struct ts_contact_list *list, struct ts_contact_span *span, const uint32_t *chosen,
			 size_t n)
{
	for (size_t k = 0; k < n; k++) {
		uint32_t r = chosen[k];

		ts_contact_set_slot(list, r, (uint32_t)span->active_end);
		list->active[span->active_end++] = (struct ts_active_pair){ r, 0, list->i[r], list->j[r] };
	}
}

/* Appends pairs of one contact law to the span, as blocks. The touching pairs of a block leave room for some
 * that begin to touch, so that the batches of the contact loop (TS_BATCH) stay full. */
enum { TOUCHING_PER_BLOCK = TS_BATCH - 8, OTHERS_PER_BLOCK = TS_ACTIVE_BLOCK - TOUCHING_PER_BLOCK };

static void append_blocks(struct ts_contact_list *list, struct ts_contact_span *span, const int32_t type[2],
			  uint32_t *chosen, size_t n)
{
	size_t touching = touching_first(list, chosen, n), apart = n - touching;
	size_t blocks = (touching + TOUCHING_PER_BLOCK - 1) / TOUCHING_PER_BLOCK,
	       least = (apart + OTHERS_PER_BLOCK - 1) / OTHERS_PER_BLOCK;

	blocks = blocks > least ? blocks : least;
	for (size_t b = 0; b < blocks; b++) {
		size_t from = touching * b / blocks, some = touching * (b + 1) / blocks - from;
		size_t rest = apart * b / blocks, others = apart * (b + 1) / blocks - rest;

		list->block[span->block_end++] = (struct ts_active_block){
			.first = (uint32_t)span->active_end,
			.n = (uint32_t)(some + others),
			.touching = (uint32_t)some,
			.type = { type[0], type[1] },
		};
		append_pairs(list, span, chosen + from, some);
		append_pairs(list, span, chosen + touching + rest, others);
	}
}

static void choose_share(const struct choice *c, size_t share)
{
	struct ts_contact_list *list = c->list;
	struct ts_contact_span *span = &list->span[share];
	uint32_t chosen[GROUP_MOST];
	size_t r, end;

	ts_contact_range(list, share, &r, &end);
	while (r < end) {
		size_t n = collect_active(c, &r, end, chosen);

		for (size_t k = 0, some; k < n; k += some) {
			int32_t type[2] = { c->p->type[list->i[chosen[k]]], c->p->type[list->j[chosen[k]]] };

			some = c->kinds == 1 ? n : move_types_to_front(c, type, chosen + k, n - k);
			append_blocks(list, span, type, chosen + k, some);
		}
	}
	for (size_t k = 0; k < TS_BLOCKS_AHEAD; k++)
		list->block[span->block_end + k] =
			(struct ts_active_block){ .first = (uint32_t)span->active_end };
}

static void choose_shares_range(void *context, size_t from, size_t to)
{
	for (size_t k = from; k < to; k++)
		choose_share(context, k);
}

/* Allocates the lists of all shares: for as many active pairs as there are candidate pairs; for as many
 * blocks as the groups can make, and the sentinel blocks. */
static enum ts_status reserve_lists(const struct choice *c)
{
	struct ts_contact_list *list = c->list;
	size_t most = c->kinds < c->group ? c->kinds : c->group, blocks = 0;

	TS_TRY(TS_RENEW(list->span, list->span_capacity, (size_t)list->shares));
	for (size_t k = 0; k < (size_t)list->shares; k++) {
		size_t from, to;

		ts_contact_range(list, k, &from, &to);
		list->span[k] = (struct ts_contact_span){ from, from, blocks, blocks };
		blocks += (to - from) / TOUCHING_PER_BLOCK + ((to - from) / c->group + 1) * most +
			  TS_BLOCKS_AHEAD;
	}
	TS_TRY(TS_RENEW_UNSET(list->active, list->active_capacity, list->n));
	return TS_RENEW_UNSET(list->block, list->block_capacity, blocks);
}

/* Cost of an inner skin g: in each step a fraction g/skin of all pairs is computed needlessly; and every g/(2
 * u) steps, u the largest displacement per step, all pairs are chosen again, which costs as much as
 * REBUILD_COST evaluations of all. g/skin + REBUILD_COST 2 u/g is least at g = sqrt(2 REBUILD_COST u skin).
 */
static const double REBUILD_COST = 12;
/* bounds of g/skin; above the upper one an inner skin does not pay */
static const double LEAST_PART = 0.02, MOST_PART = 0.7;

static double choose_inner_skin(const struct tsim *sim, const struct ts_contact_list *list)
{
	double inner =
		fmax(sqrt(2 * REBUILD_COST * list->max_displacement * list->skin), LEAST_PART * list->skin);

	return list->all_active || sim->full & TS_FULL_ACTIVE_PAIRS || !(inner < MOST_PART * list->skin)
		       ? INFINITY
		       : inner;
}

enum ts_status ts_active_pairs_choose(struct tsim *sim, struct ts_contact_list *list)
{
	size_t ntypes = (size_t)sim->particles->ntypes;
	struct choice c = { list, sim->particles, ntypes * (ntypes + 1) / 2, 0 };

	c.group = c.kinds * GROUP_PER_LAW < GROUP_LEAST	 ? GROUP_LEAST
		  : c.kinds * GROUP_PER_LAW < GROUP_MOST ? c.kinds * GROUP_PER_LAW
							 : GROUP_MOST;
	list->inner_skin = choose_inner_skin(sim, list);
	list->approach = 0;
	if (reserve_lists(&c) != TS_OK)
		return ts_nomem(&sim->error);
	ts_parallel(list->shares, (size_t)list->shares, choose_shares_range, &c);
	return TS_OK;
}
