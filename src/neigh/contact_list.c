#include "neigh/contact_list.h"

#include <string.h>

#include "base/parallel.h"
#include "neigh/coincide.h"
#include "neigh/contact_history.h"
#include "neigh/contact_search.h"
#include "neigh/force_slots.h"
#include "particle/particles.h"

#include "base/banned.h"

/* x_i - x_j + turns L is the distance of the unwrapped positions: it stays when one is wrapped. */
static int32_t winding_of(const struct ts_particles *p, size_t i, size_t j)
{
	size_t owner = j < p->n ? j : (size_t)p->ghost_owner[j - p->n];
	int32_t turns[3];

	for (int k = 0; k < 3; k++)
		turns[k] = p->image[i][k] - p->image[owner][k] + (j < p->n ? 0 : p->ghost_shift[j - p->n][k]);
	return ts_winding(turns);
}

/* Room for n rows; what was there is lost. */
static enum ts_status reserve(struct ts_contact_list *rows, size_t n)
{
	size_t width = rows->history_width ? rows->history_width : 1;
	size_t held = rows->capacity, wide = held * width, capacity = 0;

	if (n <= held)
		return TS_OK;
	rows->n = rows->capacity = 0; /* should it fail */
#define RENEW_COLUMN(column)                                 \
	do {                                                 \
		capacity = held;                             \
		TS_TRY(TS_RENEW(rows->column, capacity, n)); \
	} while (0)
	RENEW_COLUMN(i);
	RENEW_COLUMN(j);
	RENEW_COLUMN(tag[0]);
	RENEW_COLUMN(tag[1]);
	RENEW_COLUMN(image);
	RENEW_COLUMN(winding);
	RENEW_COLUMN(touching);
#undef RENEW_COLUMN
	if (rows->history_width)
		TS_TRY(TS_RENEW(rows->history, wide, capacity * width));
	rows->capacity = capacity;
	return TS_OK;
}

/* Rows from..to-1 touch nobody and remember nothing. */
static void clear(struct ts_contact_list *rows, size_t from, size_t n)
{
	size_t width = rows->history_width;

	if (!n)
		return;
	memset(rows->touching + from, 0, n);
	if (width)
		memset(rows->history + from * width, 0, n * width * sizeof *rows->history);
}

static void fill_row(struct ts_contact_list *rows, const struct ts_particles *p, size_t r, size_t i, size_t j)
{
	rows->i[r] = (int32_t)i;
	rows->j[r] = (int32_t)j;
	rows->tag[0][r] = p->tag[i];
	rows->tag[1][r] = p->tag[j];
	rows->image[r] = ts_contact_image(p, j);
	rows->winding[r] = winding_of(p, i, j);
}

struct filling {
	struct ts_contact_list *rows;
	const struct ts_contact_search *found;
};

static void fill_shares(void *context, size_t from, size_t to)
{
	const struct filling *f = context;
	const struct ts_particles *p = f->found->sim->particles;

	for (size_t t = from; t < to; t++) {
		const struct ts_contact_found *share = &f->found->share[t];
		size_t r = share->first, at = 0;

		clear(f->rows, r, share->n);
		for (size_t i = share->from; i < share->to; i++)
			for (size_t k = f->found->count[i]; k; k--)
				fill_row(f->rows, p, r++, i, (size_t)share->partner[at++]);
	}
}

/* Partners of one identity, that is images of one particle, come in the order of images. Seen from j, which
 * is local, i is no image. */
static void order_images(const struct ts_contact_list *rows, size_t from, size_t to)
{
	const struct ts_gather *g = &rows->gather;

	for (size_t k = from + 1; k < to; k++) {
		uint32_t e = g->entry[k];
		int mine = e & 1 ? TS_IMAGE_SELF : rows->image[e >> 1];
		size_t at = k;

		for (; at > from; at--) {
			uint32_t b = g->entry[at - 1];

			if (rows->tag[!(b & 1)][b >> 1] != rows->tag[!(e & 1)][e >> 1] ||
			    (b & 1 ? TS_IMAGE_SELF : rows->image[b >> 1]) <= mine)
				break;
			g->entry[at] = b;
		}
		g->entry[at] = e;
	}
}

static enum ts_status index_rows(struct tsim *sim, struct ts_contact_list *rows)
{
	const struct ts_particles *p = sim->particles;
	const struct ts_gather *g = &rows->gather;
	struct ts_gather_pairs pairs = { rows->n, 1, { rows->i, rows->j }, { rows->tag[0], rows->tag[1] } };

	if (ts_gather_index(sim, &rows->gather, &pairs) != TS_OK)
		return ts_nomem(&sim->error);
	for (size_t i = 0; p->nghost && i < p->n; i++)
		order_images(rows, g->first[i], g->first[i + 1]);
	return TS_OK;
}

static enum ts_status build(struct tsim *sim, struct ts_contact_list *rows, struct ts_contact_search *found,
			    struct ts_contact_history *old)
{
	struct filling filling = { rows, found };

	if (sim->legacy)
		TS_TRY(ts_contact_history_take_memories(sim, rows, sim->run.resuming, old));
	else
		TS_TRY(ts_contact_history_take(sim, rows, sim->run.resuming, old));
	TS_TRY(ts_contact_search(sim, found));
	if (reserve(rows, found->n) != TS_OK ||
	    TS_GROW(rows->sphere, rows->sphere_capacity, sim->particles->n + sim->particles->nghost) != TS_OK)
		return ts_nomem(&sim->error);
	rows->n = found->n;
	rows->skin = found->skin;
	rows->results = TS_RESULTS_NONE;
	rows->looked = false;
	rows->particles = sim->particles->n;
	rows->placed = false;
	rows->step = 0;
	if (rows->sphere) /* the first look at where particles are compares with something */
		memset(rows->sphere, 0, rows->sphere_capacity * sizeof *rows->sphere);
	ts_parallel(found->shares, (size_t)found->shares, fill_shares, &filling);
	if (found->coincide && !rows->both_frozen)
		TS_TRY(ts_coincide_rows(sim, rows));
	TS_TRY(index_rows(sim, rows));
	if (sim->run.resuming) /* shown without being computed */
		TS_TRY(ts_contact_forces_keep(sim, rows));
	return ts_contact_history_give(sim, old, rows);
}

enum ts_status ts_contact_list_build(struct tsim *sim, struct ts_contact_list *rows, double skin,
				     ts_excluded_fn *excluded)
{
	struct ts_contact_search found = {
		.skin = skin, .both_frozen = rows->both_frozen, .excluded = excluded, .expected = rows->n
	};
	struct ts_contact_history old = { 0 };
	enum ts_status status = build(sim, rows, &found, &old);

	ts_contact_history_release(&old);
	ts_contact_search_release(&found);
	return status;
}

void ts_contact_list_set_torques(struct ts_contact_list *rows, bool turn, bool roll)
{
	int parts = roll ? 3 : turn ? 2 : 1;

	if (parts != rows->parts)
		rows->results = TS_RESULTS_NONE;
	rows->parts = parts;
}

size_t ts_contact_list_bytes(const struct ts_contact_list *rows)
{
	size_t entry = sizeof *rows->gather.entry + sizeof *rows->sum;
	size_t row = sizeof *rows->i + sizeof *rows->j + 2 * sizeof *rows->tag[0] + sizeof *rows->image +
		     sizeof *rows->winding + sizeof *rows->touching + sizeof *rows->near + sizeof *rows->at +
		     sizeof *rows->waiting + rows->history_width * sizeof *rows->history + 2 * entry;
	size_t results = rows->n * (size_t)rows->parts; /* at the ends of runs all are kept */

	return rows->n * row + (results > rows->room ? results : rows->room) * sizeof *rows->result +
	       rows->memory_capacity * sizeof *rows->memory;
}

void ts_contact_list_release(struct ts_contact_list *rows)
{
	ts_free(rows->i);
	ts_free(rows->j);
	ts_free(rows->tag[0]);
	ts_free(rows->tag[1]);
	ts_free(rows->image);
	ts_free(rows->winding);
	ts_free(rows->result);
	ts_free(rows->touching);
	ts_free(rows->history);
	ts_free(rows->memory);
	ts_free(rows->sphere);
	ts_free(rows->span);
	ts_free(rows->near);
	ts_free(rows->block);
	ts_free(rows->at);
	ts_free(rows->waiting);
	ts_free(rows->sum_first);
	ts_free(rows->sum);
	ts_free(rows->chunk);
	ts_free(rows->gathered);
	ts_gather_release(&rows->gather);
	*rows = (struct ts_contact_list){ 0 };
}
