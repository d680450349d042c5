#include "impact/exact_sharing.h"

#include <string.h>

#include "base/banned.h"

enum ts_status ts_exact_take(struct tsim *sim, struct ts_exact_impacts *e,
			     const struct ts_exact_impact *impact, const struct ts_contact_node *node)
{
	struct ts_contact_nodes *to = &e->nodes;

	if (TS_GROW(e->item, e->capacity, e->n + 1) != TS_OK ||
	    TS_GROW(to->item, to->capacity, to->n + impact->nnodes) != TS_OK)
		return ts_nomem(&sim->error);
	if (impact->nnodes)
		memcpy(to->item + to->n, node, impact->nnodes * sizeof *to->item);
	e->item[e->n] = *impact;
	e->item[e->n++].first = to->n;
	to->n += impact->nnodes;
	return TS_OK;
}

/* An impact, which its nodes follow, or a notice. */
struct row {
	int32_t target; /* of an impact; -1: a notice */
	struct ts_exact_impact impact;
	struct ts_exact_notice notice;
};

static enum ts_status pack_impacts(const struct ts_exact_impacts *e, int32_t target, struct ts_parcel *out)
{
	for (size_t k = 0; k < e->n; k++) {
		const struct ts_exact_impact *impact = &e->item[k];
		struct row row;

		memset(&row, 0, sizeof row);
		row.target = target;
		row.impact = *impact;
		TS_TRY(ts_parcel_add(out, &row, sizeof row));
		TS_TRY(ts_parcel_add(out, e->nodes.item + impact->first,
				     impact->nnodes * sizeof *e->nodes.item));
	}
	return TS_OK;
}

static enum ts_status pack_notices(const struct ts_exact_notices *notices, struct ts_parcel *out)
{
	for (size_t k = 0; k < notices->n; k++) {
		struct row row;

		memset(&row, 0, sizeof row);
		row.target = -1;
		row.notice = notices->item[k];
		TS_TRY(ts_parcel_add(out, &row, sizeof row));
	}
	return TS_OK;
}

static enum ts_status take_notice(struct tsim *sim, struct ts_exact_notices *notices,
				  const struct ts_exact_notice *notice)
{
	if (TS_GROW(notices->item, notices->capacity, notices->n + 1) != TS_OK)
		return ts_nomem(&sim->error);
	notices->item[notices->n++] = *notice;
	return TS_OK;
}

static enum ts_status take_rows(struct tsim *sim, const struct ts_exact_target *target,
				const struct ts_parcel *all, struct ts_exact_notices *notices)
{
	struct ts_contact_nodes nodes = { 0 };
	enum ts_status status = TS_OK;
	struct row row;

	for (size_t at = 0; at < all->n && status == TS_OK;) {
		size_t bytes;

		memcpy(&row, all->data + at, sizeof row);
		at += sizeof row;
		if (row.target < 0) {
			status = take_notice(sim, notices, &row.notice);
			continue;
		}
		bytes = row.impact.nnodes * sizeof *nodes.item;
		status = TS_GROW(nodes.item, nodes.capacity, row.impact.nnodes) == TS_OK
				 ? TS_OK
				 : ts_nomem(&sim->error);
		if (status == TS_OK && bytes)
			memcpy(nodes.item, all->data + at, bytes);
		at += bytes;
		if (status == TS_OK)
			status = ts_exact_take(sim, target[row.target].wall->exact, &row.impact, nodes.item);
	}
	ts_free(nodes.item);
	return status;
}

enum ts_status ts_exact_share(struct tsim *sim, const struct ts_exact_target *target, size_t targets,
			      struct ts_exact_notices *notices)
{
	struct ts_parcel mine = { 0 }, all = { 0 };
	enum ts_status status = TS_OK;

	for (size_t k = 0; k < targets && status == TS_OK; k++) {
		struct ts_exact_impacts *e = target[k].wall->exact;

		status = pack_impacts(e, (int32_t)k, &mine);
		e->n = e->nodes.n = 0;
	}
	if (status == TS_OK)
		status = pack_notices(notices, &mine);
	notices->n = 0;
	status = status == TS_OK && ts_world_share(sim->world, &mine, &all) == TS_OK
			 ? take_rows(sim, target, &all, notices)
			 : ts_nomem(&sim->error);
	ts_parcel_release(&mine);
	ts_parcel_release(&all);
	return status;
}
