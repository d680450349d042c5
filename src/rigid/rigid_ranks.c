/* Rigid bodies of several ranks. */
#include <string.h>

#include "base/sort.h"
#include "core/carried.h"
#include "particle/columns.h"
#include "particle/copies.h"
#include "particle/rank_sums.h"
#include "rigid/rigid.h"

#include "base/banned.h"

/* ---- bodies that go to other ranks */

struct row {
	struct ts_body body;
	int64_t owner;
	int32_t id, size;
};

static struct row row_of(const struct ts_rigid *r, size_t b)
{
	struct row row;

	memset(&row, 0, sizeof row);
	row.body = r->body[b];
	row.owner = r->owner[b];
	row.id = r->id[b];
	row.size = r->size[b];
	return row;
}

/* Bodies go with each of their members; if all ranks get them, `join` has given them. */
static enum ts_status give(struct ts_instance *self, struct tsim *sim, bool results,
			   const struct ts_leaving *leaving, struct ts_carried *out)
{
	const struct ts_rigid *r = self->state;
	const struct ts_particles *p = sim->particles;

	out->bytes = sizeof(struct row);
	for (size_t i = 0; !results && r->n && i < p->n; i++) {
		size_t b = ts_rigid_index(r, p, i);
		unsigned char *to;
		struct row row;

		if (b == r->n || (leaving && !ts_carried_leaves(leaving, p->tag[i])))
			continue;
		to = ts_carried_add(out, p->tag[i]);
		if (!to)
			return ts_nomem(&sim->error);
		row = row_of(r, b);
		memcpy(to, &row, sizeof row);
	}
	return TS_OK;
}

static int compare_rows(const void *a, const void *b)
{
	const struct row *p = a, *q = b;

	return (p->id > q->id) - (p->id < q->id);
}

/* Adds bodies to those that this rank has; each once, in the order of their ids. */
static enum ts_status add_rows(struct tsim *sim, struct ts_rigid *r, struct row *row, size_t n)
{
	size_t kept = 0;

	ts_sort(row, n, sizeof *row, compare_rows);
	TS_TRY(ts_rigid_reserve(sim, n));
	for (size_t k = 0; k < n; k++) {
		if (kept && r->id[kept - 1] == row[k].id)
			continue;
		r->body[kept] = row[k].body;
		r->owner[kept] = row[k].owner;
		r->id[kept] = row[k].id;
		r->size[kept++] = row[k].size;
	}
	r->n = kept;
	r->generation = 0;
	return TS_OK;
}

static enum ts_status take(struct ts_instance *self, struct tsim *sim, const struct ts_carried *rows)
{
	struct ts_rigid *r = self->state;
	size_t come = ts_carried_count(rows), n = 0;
	struct row *row;
	enum ts_status status;

	if (!come)
		return TS_OK;
	row = ts_alloc(r->n + come, sizeof *row);
	if (!row)
		return ts_nomem(&sim->error);
	for (; n < r->n; n++)
		row[n] = row_of(r, n);
	for (size_t k = 0; k < come; k++) {
		int32_t tag;

		memcpy(&row[n++], ts_carried_row(rows, k, &tag), sizeof *row);
	}
	status = add_rows(sim, r, row, n);
	ts_free(row);
	return status;
}

/* Other members of bodies that this rank has members of, however far away they are. */
enum ts_status ts_rigid_claim(struct ts_instance *self, struct tsim *sim, const struct ts_copy_map *copies,
			      struct ts_claims *claims)
{
	const struct ts_rigid *r = self->state;
	const struct ts_particles *p = sim->particles;
	int32_t *own, *all;

	claims->any |= ts_columns_have_bodies(p);
	if (!r->n || !p->body)
		return TS_OK;
	own = ts_alloc(2 * r->n, sizeof *own);
	all = own ? own + r->n : NULL;
	if (!own)
		return ts_nomem(&sim->error);
	for (size_t i = 0; i < p->n + copies->n; i++) {
		size_t b = ts_rigid_index(r, p, i);

		if (b == r->n)
			continue;
		all[b]++;
		own[b] += i < p->n;
	}
	for (size_t b = 0; b < r->n; b++)
		if (own[b] && all[b] < r->size[b] && ts_claims_add_body(sim, claims, r->id[b]) != TS_OK) {
			ts_free(own);
			return ts_nomem(&sim->error);
		}
	ts_free(own);
	return TS_OK;
}

const struct ts_carrier ts_rigid_carrier = { .give = give, .take = take };

/* ---- all bodies */

/* Those whose first member is of this rank. */
static enum ts_status pack_bodies(const struct tsim *sim, struct ts_parcel *out)
{
	const struct ts_rigid *r = sim->rigid;

	for (size_t b = 0; b < r->n; b++) {
		struct row row = row_of(r, b);

		if (r->start[b] < r->start[b + 1] && (size_t)r->member[r->start[b]] < sim->particles->n)
			TS_TRY(ts_parcel_add(out, &row, sizeof row));
	}
	return TS_OK;
}

static enum ts_status share_bodies(struct tsim *sim, struct ts_rigid *r)
{
	struct ts_parcel mine = { 0 }, all = { 0 };
	enum ts_status status = pack_bodies(sim, &mine);
	struct row *row;
	size_t n;

	if (status == TS_OK)
		status = ts_world_share(sim->world, &mine, &all);
	n = all.n / sizeof *row;
	row = ts_alloc(n, sizeof *row);
	if (status == TS_OK && row) {
		if (n)
			memcpy(row, all.data, n * sizeof *row);
		status = add_rows(sim, r, row, n);
	}
	ts_parcel_release(&mine);
	ts_parcel_release(&all);
	ts_free(row);
	return status == TS_OK && row ? TS_OK : ts_nomem(&sim->error);
}

enum ts_status ts_rigid_join(struct ts_instance *self, struct tsim *sim)
{
	if (!ts_columns_have_bodies(sim->particles))
		return TS_OK;
	TS_TRY(ts_rigid_list(sim));
	return share_bodies(sim, self->state);
}

/* ---- bodies that have lost members */

struct count {
	int32_t id, members;
};

/* Members among the particles of this rank: copies of others are listed where this rank has not lost or got a particle. */
static int32_t own_members(const struct tsim *sim, const struct ts_rigid *r, size_t b)
{
	int32_t n = 0;

	for (size_t k = r->start[b]; k < r->start[b + 1]; k++)
		n += (size_t)r->member[k] < sim->particles->n;
	return n;
}

/* Counts of the bodies that are not complete on their rank. */
static enum ts_status share_counts(struct tsim *sim, struct ts_parcel *all)
{
	const struct ts_rigid *r = sim->rigid;
	struct ts_parcel mine = { 0 };
	enum ts_status status = TS_OK;

	for (size_t b = 0; b < r->n && status == TS_OK; b++) {
		struct count c = { r->id[b], own_members(sim, r, b) };

		if (c.members < r->size[b])
			status = ts_parcel_add(&mine, &c, sizeof c);
	}
	if (status == TS_OK)
		status = ts_world_share(sim->world, &mine, all);
	ts_parcel_release(&mine);
	return status;
}

/* torn[b]: members of the body that all ranks have are not as many as it had; returns whether there are any. */
static bool find_torn(const struct ts_rigid *r, const struct ts_parcel *counts, int32_t *members,
		      unsigned char *torn)
{
	bool any = false;

	for (size_t b = 0; b < r->n; b++)
		members[b] = 0;
	for (size_t k = 0; k < counts->n / sizeof(struct count); k++) {
		struct count c;
		size_t b;

		memcpy(&c, counts->data + k * sizeof c, sizeof c);
		b = ts_rigid_find(r, c.id);
		if (b < r->n)
			members[b] += c.members;
	}
	for (size_t b = 0; b < r->n; b++) {
		torn[b] = members[b] && members[b] < r->size[b];
		any |= torn[b];
	}
	return any;
}

static enum ts_status drop_torn(struct tsim *sim)
{
	struct ts_rigid *r = sim->rigid;
	struct ts_parcel counts = { 0 };
	int32_t *members = ts_alloc(r->n, sizeof *members);
	unsigned char *torn = ts_alloc(r->n, 1);
	enum ts_status status = members && torn ? share_counts(sim, &counts) : TS_NOMEM;

	if (status != TS_OK)
		status = ts_nomem(&sim->error);
	else if (find_torn(r, &counts, members, torn))
		status = ts_rigid_delete(sim, torn);
	ts_parcel_release(&counts);
	ts_free(members);
	ts_free(torn);
	return status;
}

enum ts_status ts_rigid_exchange_own(struct tsim *sim)
{
	struct ts_rigid *r = sim->rigid;
	const struct ts_particles *p = sim->particles;

	if (!ts_columns_have_bodies(p))
		return TS_OK;
	TS_TRY(ts_rigid_list(sim));
	if (r->lost != p->lost)
		TS_TRY(drop_torn(sim));
	r->lost = p->lost;
	if (r->n)
		TS_TRY(r->check_members(sim, r->member, r->start[r->n]));
	for (size_t b = 0; b < r->n; b++)
		for (size_t k = r->start[b]; k < r->start[b + 1]; k++)
			p->imass[r->member[k]] = 1 / r->body[b].mass;
	return TS_OK;
}
