/* Particles that commands make before the first run: each rank keeps its own of them. */
#include <string.h>

#include "box/domain.h"
#include "core/ranks.h"
#include "core/ranks_pause.h"
#include "core/recorder.h"
#include "particle/columns.h"
#include "particle/division_blocks.h"
#include "particle/identity.h"
#include "particle/shared_rows.h"

#include "base/banned.h"

bool ts_division_can_make(const struct tsim *sim)
{
	/* after a run there are lists */
	const bool begins = !sim->run.paused && !sim->division && !sim->run.looks && !sim->run.epochs &&
			    !sim->particles->n;

	return sim->world && sim->world->n > 1 && sim->run.pauses && sim->dimension == 3 && !sim->legacy &&
	       !(sim->recorder && sim->recorder->records(sim->recorder)) && (begins || sim->run.made);
}

/* All ranks get the particles of all, in the order in which they were made. */
static enum ts_status share_made(struct tsim *sim, void *data)
{
	struct ts_identities map;

	(void)data;
	TS_TRY(ts_shared_rows(sim, TS_SHARED_BY_RANK, NULL));
	TS_TRY(ts_identities(sim, true, &map));
	return ts_particles_reorder(sim, map.row);
}

static enum ts_status begin_making(struct tsim *sim, struct ts_placed placed)
{
	struct ts_plan none = { 0 };
	struct ts_division *d;

	TS_TRY(ts_division_new(sim));
	TS_TRY(ts_ranks_pause(sim, &none));
	d = sim->particles->division;
	ts_division_start(sim, &(struct ts_reread){ .all = share_made });
	sim->run.made = true;
	if (d->held && ts_division_blocks_fit(sim, d, placed.lo, placed.hi))
		return TS_OK;
	d->held = false;
	d->cut_most = (size_t)ts_division_sum(sim, (int64_t)placed.n) / (size_t)d->ranks;
	return ts_division_cut_space(sim, d->ranks, placed, &d->blocks);
}

enum ts_status ts_division_make(struct tsim *sim, double (*x)[3], size_t n)
{
	const struct ts_box *box = &sim->domain->box;

	return sim->division ? TS_OK : begin_making(sim, (struct ts_placed){ x, NULL, n, box->lo, box->hi });
}

enum ts_status ts_division_count(struct tsim *sim, size_t n, size_t *before, size_t *all)
{
	uint64_t *size = ts_alloc((size_t)sim->world->n, sizeof *size);

	*before = *all = 0;
	if (!size)
		return ts_nomem(&sim->error);
	ts_world_sizes(sim->world, n, size);
	for (int r = 0; r < sim->world->n; r++) {
		*before += r < sim->world->rank ? size[r] : 0;
		*all += size[r];
	}
	ts_free(size);
	return TS_OK;
}

int32_t ts_division_owner(const struct tsim *sim, const double x[3])
{
	return (int32_t)ts_rank_blocks_owner(&sim->particles->division->blocks, x);
}

static enum ts_status pack_rows(const struct ts_new_rows *rows, const int32_t *to, struct ts_parcel *out)
{
	for (size_t k = 0; k < rows->n; k++)
		TS_TRY(ts_parcel_add(&out[to[k]], (const char *)rows->row + k * rows->size, rows->size));
	return TS_OK;
}

static enum ts_status make_room(struct ts_new_rows *rows, size_t n)
{
	void *row;

	if (n <= rows->capacity)
		return TS_OK;
	row = ts_alloc_unset(n, rows->size);
	if (!row)
		return TS_NOMEM;
	ts_free(rows->row);
	rows->row = row;
	rows->capacity = n;
	return TS_OK;
}

static enum ts_status unpack_rows(const struct tsim *sim, struct ts_new_rows *rows,
				  const struct ts_parcel *in)
{
	size_t bytes = 0;

	for (int r = 0; r < sim->world->n; r++)
		bytes += in[r].n;
	TS_TRY(make_room(rows, bytes / rows->size));
	rows->n = bytes / rows->size;
	bytes = 0;
	for (int r = 0; r < sim->world->n; r++) {
		if (in[r].n)
			memcpy((char *)rows->row + bytes, in[r].data, in[r].n);
		bytes += in[r].n;
	}
	return TS_OK;
}

enum ts_status ts_division_send(struct tsim *sim, struct ts_new_rows *rows, const int32_t *to)
{
	const int ranks = sim->world->n;
	struct ts_parcel *out = ts_alloc(2 * (size_t)ranks, sizeof *out);
	enum ts_status status;

	if (!out)
		return ts_nomem(&sim->error);
	status = pack_rows(rows, to, out);
	if (status == TS_OK)
		status = ts_world_deliver(sim->world, out, out + ranks);
	for (int r = 0; r < ranks; r++)
		ts_parcel_release(&out[r]);
	if (status == TS_OK)
		status = unpack_rows(sim, rows, out + ranks);
	for (int r = ranks; r < 2 * ranks; r++)
		ts_parcel_release(&out[r]);
	ts_free(out);
	return status == TS_OK ? TS_OK : ts_nomem(&sim->error);
}

enum ts_status ts_division_made(struct tsim *sim)
{
	struct ts_division *d = sim->division;

	if (!ts_division_is_uneven(sim, d))
		return TS_OK;
	TS_TRY(ts_division_cut_again(sim, d));
	return ts_division_migrate(sim);
}
