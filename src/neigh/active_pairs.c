#include "neigh/active_pairs.h"

#include <math.h>
#include <string.h>

#include "base/clones.h"
#include "base/four.h"
#include "base/parallel.h"
#include "core/deferred_loops.h"
#include "particle/particles.h"

#include "base/banned.h"

/* ---- how far particles go */

/* The squares of the largest steps from the places noted before, in each direction and of the radius. */
TS_CLONES static void place(const struct ts_particles *p, struct ts_contact_sphere *out, size_t from,
			    size_t to, double most[4])
{
	ts_four all = { 0 };

	for (size_t i = from; i < to; i++) {
		ts_four now = TS_FOUR_AT(p->x[i]), motion = TS_FOUR_AT(p->v[i]), spin = { 0 }, step;

		now[3] = p->radius[i];
		motion[3] = p->imass[i];
		if (p->omega)
			spin = TS_FOUR_AT(p->omega[i]);
		spin[3] = p->radius[i];
		step = now - *(ts_four *)out[i].position;
		step *= step;
		*(ts_four *)out[i].position = now;
		*(ts_four *)out[i].velocity = motion;
		*(ts_four *)out[i].omega = spin;
		ts_four_most(&all, &step);
	}
	for (int k = 0; k < 4; k++)
		most[k] = all[k];
}

struct placing {
	const struct ts_particles *p;
	struct ts_contact_list *list;
};

static void place_share(void *context, size_t from, size_t to)
{
	const struct placing *g = context;
	double most[4], pace;

	place(g->p, g->list->sphere, from, to, most);
	/* after a particle has grown nothing is known */
	pace = most[3] > 0 ? INFINITY : sqrt(most[0] + most[1] + most[2]);
#pragma omp critical
	g->list->displacement = fmax(g->list->displacement, pace);
}

void ts_contact_list_locate_locals(struct tsim *sim, struct ts_contact_list *list)
{
	struct placing g = { sim->particles, list };

	if (!list->sphere || list->particles != sim->particles->n)
		return;
	TS_DEFER_LOOP(sim, list->particles, place_share, &g);
	list->locals_packed = true;
}

static void place_others(void *context, size_t from, size_t to)
{
	const struct placing *g = context;
	size_t first = g->list->locals_packed ? g->list->particles : 0;

	place_share(context, first + from, first + to);
}

void ts_contact_list_locate(const struct tsim *sim, struct ts_contact_list *list)
{
	size_t n = sim->particles->n + sim->particles->nghost - (list->locals_packed ? list->particles : 0);
	struct placing g = { sim->particles, list };

	ts_parallel(ts_team(sim, n), n, place_others, &g);
	if (list->active_chosen) {
		list->max_displacement = list->displacement;
		list->approach += 2 * list->displacement;
	}
	list->displacement = 0;
	list->locals_packed = false;
}

/* Rounding of places counts for much less than the rest of the gap. */
bool ts_active_pairs_outdated(const struct ts_contact_list *list)
{
	return !list->active_chosen || !(list->approach <= 0.999 * list->inner_skin);
}

/* ---- which rows are near */

/* Rows are sorted by laws so many at a time: FEW, or where that would make blocks of few rows ALIKE for
 * each law, up to GROUP. */
enum { FEW = 512, ALIKE = 128, GROUP = 4096 };

struct choice {
	struct ts_contact_list *list;
	const struct ts_particles *p;
	size_t kinds; /* of pairs of types */
	size_t group;
};

/* The next near ones of the rows *r .. end-1; those that touched are looked at once more. */
static size_t collect(const struct choice *c, size_t *r, size_t end, uint32_t *chosen)
{
	const struct ts_contact_list *list = c->list;
	size_t n = 0, k = *r;

	for (; k < end && n < c->group; k++) {
		const double *a = list->sphere[list->i[k]].position, *b = list->sphere[list->j[k]].position;
		double x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2],
		       reach = a[3] + b[3] + list->inner_skin;

		chosen[n] = (uint32_t)k;
		list->active_index[k] = TS_PAIR_INACTIVE;
		n += (x * x + y * y + z * z < reach * reach) | list->touching[k];
	}
	*r = k;
	return n;
}

/* Brings those of the listed rows whose partners are of these types to the front; returns how many. Which
 * partner is of which type is all the same to the laws. */
static size_t alike(const struct choice *c, const int32_t type[2], uint32_t *chosen, size_t n)
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

/* Those that touch come first; returns how many. Both parts stay in order. */
static size_t touching_first(const struct ts_contact_list *list, uint32_t *chosen, size_t n)
{
	uint32_t waiting[GROUP];
	size_t active = 0;

	for (size_t k = 0; k < n; k++) {
		uint32_t r = chosen[k];

		chosen[active] = waiting[k - active] = r;
		active += list->touching[r];
	}
	memcpy(chosen + active, waiting, (n - active) * sizeof *chosen);
	return active;
}

static void add_near(struct ts_contact_list *list, struct ts_contact_span *span, const uint32_t *chosen,
		     size_t n)
{
	for (size_t k = 0; k < n; k++) {
		uint32_t r = chosen[k];

		list->active_index[r] = (uint32_t)span->active_end;
		list->active[span->active_end++] = (struct ts_active_pair){ r, r, list->i[r], list->j[r] };
	}
}

/* The listed rows, which have one law, as blocks at the end of the span: of so many that touch that some
 * can join them and the columns of a batch are full all the same. */
enum { ACTIVE = TS_BATCH - 8, WAITING = TS_ACTIVE_BLOCK - ACTIVE };

static void add_blocks(struct ts_contact_list *list, struct ts_contact_span *span, const int32_t type[2],
		       uint32_t *chosen, size_t n)
{
	size_t active = touching_first(list, chosen, n), waiting = n - active;
	size_t blocks = (active + ACTIVE - 1) / ACTIVE, least = (waiting + WAITING - 1) / WAITING;

	blocks = blocks > least ? blocks : least;
	for (size_t b = 0; b < blocks; b++) {
		size_t from = active * b / blocks, some = active * (b + 1) / blocks - from;
		size_t rest = waiting * b / blocks, others = waiting * (b + 1) / blocks - rest;

		list->block[span->block_end++] = (struct ts_active_block){
			.first = (uint32_t)span->active_end,
			.n = (uint32_t)(some + others),
			.touching = (uint32_t)some,
			.type = { type[0], type[1] },
		};
		add_near(list, span, chosen + from, some);
		add_near(list, span, chosen + active + rest, others);
	}
}

static void choose(const struct choice *c, size_t share)
{
	struct ts_contact_list *list = c->list;
	struct ts_contact_span *span = &list->span[share];
	uint32_t chosen[GROUP];
	size_t r, end;

	ts_contact_range(list, share, &r, &end);
	while (r < end) {
		size_t n = collect(c, &r, end, chosen);

		for (size_t k = 0, some; k < n; k += some) {
			int32_t type[2] = { c->p->type[list->i[chosen[k]]], c->p->type[list->j[chosen[k]]] };

			some = c->kinds == 1 ? n : alike(c, type, chosen + k, n - k);
			add_blocks(list, span, type, chosen + k, some);
		}
	}
	for (size_t k = 0; k < TS_BLOCKS_AHEAD; k++)
		list->block[span->block_end + k] =
			(struct ts_active_block){ .first = (uint32_t)span->active_end };
}

static void choose_shares(void *context, size_t from, size_t to)
{
	for (size_t k = from; k < to; k++)
		choose(context, k);
}

/* Makes room for the lists of the shares: of near rows as many as there are rows, and of blocks as many as
 * their groups can have, and those behind. */
static enum ts_status spread(const struct choice *c)
{
	struct ts_contact_list *list = c->list;
	size_t most = c->kinds < c->group ? c->kinds : c->group, blocks = 0;

	TS_TRY(TS_RENEW(list->span, list->span_capacity, (size_t)list->shares));
	for (size_t k = 0; k < (size_t)list->shares; k++) {
		size_t from, to;

		ts_contact_range(list, k, &from, &to);
		list->span[k] = (struct ts_contact_span){ from, from, blocks, blocks };
		blocks += (to - from) / ACTIVE + ((to - from) / c->group + 1) * most + TS_BLOCKS_AHEAD;
	}
	TS_TRY(TS_RENEW(list->active, list->active_capacity, list->n));
	TS_TRY(TS_RENEW(list->active_index, list->active_index_capacity,
			list->n + 1)); /* never NULL: offsets are taken of it */
	return TS_RENEW(list->block, list->block_capacity, blocks);
}

/* With a gap g some share g/skin of the rows is looked at in vain in each step, and all are looked at
 * again after g/2 at the present pace, which costs as much as `LOOK` vain looks at all: least of g/skin +
 * LOOK 2 pace/g. */
static const double LOOK = 12;
static const double LEAST = 0.02, MOST = 0.7; /* of the skin; beyond the most it is not worth it */

static double choose_inner_skin(const struct tsim *sim, const struct ts_contact_list *list)
{
	double gap = fmax(sqrt(2 * LOOK * list->max_displacement * list->skin), LEAST * list->skin);

	return list->all_active || sim->full & TS_FULL_LOOKS || !(gap < MOST * list->skin) ? INFINITY : gap;
}

enum ts_status ts_active_pairs_choose(struct tsim *sim, struct ts_contact_list *list)
{
	size_t ntypes = (size_t)sim->particles->ntypes;
	struct choice c = { list, sim->particles, ntypes * (ntypes + 1) / 2, 0 };

	c.group = c.kinds * ALIKE < FEW ? FEW : c.kinds * ALIKE < GROUP ? c.kinds * ALIKE : GROUP;
	list->inner_skin = choose_inner_skin(sim, list);
	list->approach = 0;
	if (spread(&c) != TS_OK)
		return ts_nomem(&sim->error);
	ts_parallel(list->shares, (size_t)list->shares, choose_shares, &c);
	return TS_OK;
}
