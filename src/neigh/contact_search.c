#include "neigh/contact_search.h"

#include "neigh/coincide.h"

#include "base/clones.h"
#include "base/four.h"
#include "base/parallel.h"
#include "base/sort.h"
#include "math/vec3.h"

#include "base/banned.h"

/* Bits of the sort key of a partner, from the lowest: its place in the unsorted list, its image; above them
 * its identity. */
enum { PLACE_BITS = 28, IMAGE_BITS = 5 };

/* Each pair of local particles is to be found once: by the larger one; within one size level, by the first in
 * memory. Pairs with a ghost are found by the local particle; therefore, if there are ghosts, small local
 * particles must search the levels of larger ones, too. Returns the index beyond which particles of the level
 * count. */
static int32_t bound_of(const struct ts_contact_search *s, int level, size_t i)
{
	int own = s->cells.level_of[i];

	if (level == own)
		return (int32_t)i;
	return level > own ? -1 : (int32_t)s->sim->particles->n - 1;
}

/* The particle that searches. */
struct query {
	double position[4], skin; /* x, y, z, radius; skin: lengths */
	int32_t bound;		  /* of bound_of */
	ts_four_marks *same;	  /* set where a partner is coincident */
};

/* Writes those of the list entries from .. to-1 that are within the radii plus the skin; returns their
 * number. Without branches, since most are not near. `out` must have room for TS_CELLS_VECTOR - 1 more. */
TS_INLINE size_t find_partners_in_cells(const struct ts_level *level, int32_t from, int32_t to,
					const struct query *w, int32_t *out)
{
	static const ts_four_marks next = { 0, 1, 2, 3 };
	const ts_four skin = TS_FOUR_BROADCAST(w->skin), radius = TS_FOUR_BROADCAST(w->position[3]);
	const ts_four close = TS_FOUR_BROADCAST(TS_COINCIDE * TS_COINCIDE * w->position[3] * w->position[3]);
	const long long least = w->bound;
	const ts_four_marks bound = { least, least, least, least };
	ts_four_marks same = { 0 };
	size_t n = 0;

	for (int32_t k = from; k < to; k += TS_CELLS_VECTOR) {
		const long long rest = to - k;
		const ts_four_marks left = { rest, rest, rest, rest };
		ts_four reach = radius + TS_FOUR_LOAD(level->position[3] + k) + skin, square = { 0 };
		union {
			ts_four_marks all;
			long long one[TS_CELLS_VECTOR];
		} hit;

		for (int c = 0; c < 3; c++) {
			ts_four d = TS_FOUR_BROADCAST(w->position[c]) - TS_FOUR_LOAD(level->position[c] + k);

			square += d * d;
		}
		hit.all = (square < reach * reach) &
			  (*(const ts_four_marks_anywhere *)(level->list + k) > bound) & (next < left);
		same |= hit.all & (square <= close);
		for (int q = 0; q < TS_CELLS_VECTOR; q++) {
			out[n] = (int32_t)level->list[k + q];
			n -= (size_t)hit.one[q];
		}
	}
	*w->same |= same;
	return n;
}

TS_CLONES static void search_level(const struct ts_contact_search *s, int l, size_t i,
				   struct ts_contact_found *f)
{
	const struct ts_particles *p = s->sim->particles;
	const struct ts_level *level = &s->cells.level[l];
	ts_four_marks same = { 0 };
	const struct query w = { { p->xhold[i][0], p->xhold[i][1], p->xhold[i][2], p->radius[i] },
				 s->skin,
				 bound_of(s, l, i),
				 &same };
	int lo[3], hi[3];

	ts_cells_range(level, w.position, w.position[3] + level->reach + s->skin, lo, hi);
	for (int z = lo[2]; z <= hi[2]; z++) {
		for (int y = lo[1]; y <= hi[1]; y++) {
			/* cells adjacent in x are adjacent in the list, too */
			int row = level->cells[0] * (y + level->cells[1] * z);
			int32_t from = level->start[row + lo[0]], to = level->start[row + hi[0] + 1];
			size_t most = f->n + (size_t)(to - from) + TS_CELLS_VECTOR - 1;

			if (most > f->capacity && TS_GROW(f->partner, f->capacity, most) != TS_OK) {
				f->status = TS_NOMEM;
				return;
			}
			f->n += find_partners_in_cells(level, from, to, &w, f->partner + f->n);
		}
	}
	for (int q = 0; q < TS_CELLS_VECTOR; q++)
		f->coincide |= same[q] != 0;
}

/* Leaves out excluded pairs, and pairs of two immobile particles (or keeps only these, if both_frozen). */
static size_t filter_partners(const struct ts_contact_search *s, size_t i, int32_t *partner, size_t n)
{
	const struct ts_particles *p = s->sim->particles;
	const double *imass = p->imass;
	size_t kept = 0;

	if (!s->excluded && !s->both_frozen && imass[i] > 0)
		return n;
	for (size_t k = 0; k < n; k++) {
		size_t j = (size_t)partner[k];
		double d[3];

		ts_sub(p->xhold[i], p->xhold[j], d);
		if ((imass[i] == 0 && imass[j] == 0) == s->both_frozen &&
		    !(s->excluded && s->excluded(s->sim, i, j, d)))
			partner[kept++] = partner[k];
	}
	return kept;
}

static enum ts_status sort_partners(const struct ts_contact_search *s, struct ts_contact_found *f,
				    int32_t *partner, size_t n)
{
	const struct ts_particles *p = s->sim->particles;

	if (n < 2)
		return TS_OK;
	TS_TRY(TS_GROW(f->key, f->key_capacity, 2 * n));
	TS_TRY(TS_GROW(f->spare, f->spare_capacity, n));
	for (size_t k = 0; k < n; k++) {
		size_t j = (size_t)partner[k];

		f->key[k] = (uint64_t)p->tag[j] << (PLACE_BITS + IMAGE_BITS) |
			    (uint64_t)ts_contact_image_of(p, j) << PLACE_BITS | k;
		f->key[n + k] = j;
	}
	ts_sort_keys(f->key, f->spare, n);
	for (size_t k = 0; k < n; k++)
		partner[k] = (int32_t)f->key[n + (f->key[k] & ((1u << PLACE_BITS) - 1))];
	return TS_OK;
}

static void search_particle(const struct ts_contact_search *s, struct ts_contact_found *f, size_t i)
{
	int l = s->sim->particles->nghost ? 0 : s->cells.level_of[i];
	size_t first = f->n;

	for (; l < s->cells.nlevels && f->status == TS_OK; l++)
		search_level(s, l, i, f);
	if (f->status != TS_OK)
		return;
	f->n = first + filter_partners(s, i, f->partner + first, f->n - first);
	f->status = sort_partners(s, f, f->partner + first, f->n - first);
	s->count[i] = (uint32_t)(f->n - first);
}

/* The shares from .. to-1, each on a thread of its own. */
static void search_shares(void *context, size_t from, size_t to)
{
	const struct ts_contact_search *s = context;

	for (size_t t = from; t < to; t++) {
		struct ts_contact_found *f = &s->share[t];

		for (size_t i = f->from; i < f->to && f->status == TS_OK; i++)
			search_particle(s, f, i);
	}
}

static enum ts_status search_all_shares(struct tsim *sim, struct ts_contact_search *s)
{
	size_t n = sim->particles->n, shares = (size_t)s->shares;
	/* Room that is not used takes no memory, while a list that is too short is copied. */
	size_t room = (s->expected + s->expected / 2) / shares;

	for (size_t t = 0; t < shares; t++) {
		s->share[t].from = n * t / shares;
		s->share[t].to = n * (t + 1) / shares;
		if (TS_RENEW_UNSET(s->share[t].partner, s->share[t].capacity, room) != TS_OK)
			return ts_nomem(&sim->error);
	}
	ts_parallel(s->shares, shares, search_shares, s);
	s->n = 0;
	for (size_t t = 0; t < shares; t++) {
		if (s->share[t].status != TS_OK)
			return ts_nomem(&sim->error);
		s->share[t].first = s->n;
		s->n += s->share[t].n;
		s->coincide |= s->share[t].coincide;
	}
	if (s->n >= (size_t)INT32_MAX)
		return ts_fail(&sim->error, TS_RANGE, NULL,
			       "more than 2^31 pairs of neighbours: the skin is too large");
	return TS_OK;
}

enum ts_status ts_contact_search(struct tsim *sim, struct ts_contact_search *s)
{
	size_t n = sim->particles->n;

	s->sim = sim;
	s->shares = ts_team(sim, 8 * n); /* a search costs as much as several simple loops */
	s->share = ts_alloc_aligned((size_t)s->shares, sizeof *s->share);
	s->count = ts_alloc(n, sizeof *s->count);
	if (!s->share || !s->count)
		return ts_nomem(&sim->error);
	TS_TRY(ts_cells_fill(sim, &s->cells, s->skin));
	return search_all_shares(sim, s);
}

void ts_contact_search_release(struct ts_contact_search *s)
{
	for (int t = 0; s->share && t < s->shares; t++) {
		ts_free(s->share[t].partner);
		ts_free(s->share[t].key);
		ts_free(s->share[t].spare);
	}
	ts_free(s->share);
	ts_free(s->count);
	ts_cells_release(&s->cells);
	*s = (struct ts_contact_search){ 0 };
}
