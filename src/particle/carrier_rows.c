#include "particle/carrier_rows.h"

#include "core/ranks.h"
#include "particle/identity.h"

#include "base/banned.h"

void ts_carrier_rows_release(struct ts_division *d)
{
	for (size_t k = 0; k < d->ncarried; k++)
		ts_parcel_release(&d->carried[k].rows);
	d->ncarried = 0;
}

struct ts_instance *ts_carrier_next(const struct tsim *sim, int *kind, size_t *k)
{
	for (; *kind < TS_NKIND; ++*kind, *k = 0)
		while (*k < sim->instances[*kind].n) {
			struct ts_instance *inst = sim->instances[*kind].item[(*k)++];

			if (inst->style->carrier)
				return inst;
		}
	return NULL;
}

enum ts_status ts_carrier_rows_give(struct tsim *sim, struct ts_division *d, bool results,
				    const struct ts_leaving *leaving)
{
	struct ts_instance *inst;
	int kind = 0;
	size_t k = 0;

	ts_carrier_rows_release(d);
	while ((inst = ts_carrier_next(sim, &kind, &k))) {
		if (TS_GROW(d->carried, d->carried_capacity, d->ncarried + 1) != TS_OK)
			return ts_nomem(&sim->error);
		d->carried[d->ncarried] = (struct ts_carried){ 0 };
		TS_TRY(inst->style->carrier->give(inst, sim, results, leaving, &d->carried[d->ncarried++]));
	}
	return TS_OK;
}

enum ts_status ts_carrier_rows_take(struct tsim *sim, struct ts_division *d)
{
	struct ts_instance *inst;
	int kind = 0;
	size_t k = 0, n = 0;

	while ((inst = ts_carrier_next(sim, &kind, &k)))
		TS_TRY(inst->style->carrier->take(inst, sim, &d->carried[n++]));
	ts_carrier_rows_release(d);
	return TS_OK;
}

enum ts_status ts_carrier_rows_sort(struct tsim *sim, const struct ts_carried *rows, const int32_t *to,
				    struct ts_parcel *out, struct ts_carried *away)
{
	size_t n = ts_carried_count(rows);
	struct ts_identities map;

	TS_TRY(ts_identities(sim, false, &map));
	for (size_t k = 0; k < n; k++) {
		int32_t tag, i;
		const unsigned char *row = ts_carried_row(rows, k, &tag);
		struct ts_parcel *parcel;

		i = ts_identity_row(&map, tag);
		if (i < 0 && !away)
			continue;
		parcel = i < 0 ? &away->rows : &out[to ? to[i] : 0];
		if (ts_parcel_add(parcel, row - sizeof tag, sizeof tag + rows->bytes) != TS_OK)
			return ts_nomem(&sim->error);
	}
	return TS_OK;
}

enum ts_status ts_carrier_rows_keep_local(struct tsim *sim, struct ts_carried *rows)
{
	struct ts_parcel kept = { 0 };
	enum ts_status status = ts_carrier_rows_sort(sim, rows, NULL, &kept, NULL);

	ts_parcel_release(&rows->rows);
	rows->rows = kept;
	return status;
}

enum ts_status ts_carrier_rows_deliver(struct tsim *sim, struct ts_carried *rows, struct ts_parcel *out)
{
	struct ts_parcel *in = sim->division->copies.in;
	enum ts_status status;

	status = ts_world_deliver(sim->world, out, in);
	rows->rows.n = 0;
	for (int r = 0; r < sim->world->n; r++) {
		if (status == TS_OK)
			status = ts_parcel_add(&rows->rows, in[r].data, in[r].n);
	}
	return status == TS_OK ? TS_OK : ts_nomem(&sim->error);
}

struct ts_parcel *ts_carrier_rows_parcels(const struct tsim *sim)
{
	struct ts_parcel *out = sim->division->copies.out;

	for (int r = 0; r < sim->world->n; r++)
		out[r].n = 0;
	return out;
}

enum ts_status ts_carrier_rows_send_home(struct tsim *sim, struct ts_carried *rows,
					 const struct ts_copy_map *copy)
{
	struct ts_carried local = { .bytes = rows->bytes }, away = { .bytes = rows->bytes };
	struct ts_parcel *out = ts_carrier_rows_parcels(sim);
	enum ts_status status = ts_carrier_rows_sort(sim, rows, NULL, &local.rows, &away);
	size_t n = status == TS_OK ? ts_carried_count(&away) : 0;

	for (size_t k = 0; k < n && status == TS_OK; k++) {
		int32_t tag;
		const unsigned char *row = ts_carried_row(&away, k, &tag);
		int32_t found = ts_copy_map_find(copy, tag);

		if (found >= 0 && ts_parcel_add(&out[ts_copies_rank(&sim->division->copies, (size_t)found)],
						row - sizeof tag, sizeof tag + rows->bytes) != TS_OK)
			status = ts_nomem(&sim->error);
	}
	if (status == TS_OK)
		status = ts_carrier_rows_deliver(sim, rows, out);
	if (status == TS_OK && ts_parcel_add(&rows->rows, local.rows.data, local.rows.n) != TS_OK)
		status = ts_nomem(&sim->error);
	ts_parcel_release(&local.rows);
	ts_parcel_release(&away.rows);
	return status;
}
