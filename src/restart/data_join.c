/* Data files of which each of several ranks has read a part of the lines: those of a particle come together. */
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include "base/sort.h"
#include "core/ranks.h"
#include "particle/division.h"
#include "restart/data.h"

#include "base/banned.h"

/* The rank at which the lines of a particle come together: any, but with about the same number for each. */
static int32_t rank_of_tag(const struct ts_data *d, int32_t tag)
{
	return (int32_t)(((uint64_t)tag * 0x9e3779b97f4a7c15u >> 32) % (uint64_t)d->parts);
}

static enum ts_status send_rows(struct tsim *sim, const struct ts_data *d, struct ts_new_rows *rows,
				size_t tag_at)
{
	int32_t *to = ts_alloc(rows->n, sizeof *to), tag;
	enum ts_status status;

	if (!to)
		return ts_nomem(&sim->error);
	for (size_t k = 0; k < rows->n; k++) {
		memcpy(&tag, (const char *)rows->row + k * rows->size + tag_at, sizeof tag);
		to[k] = rank_of_tag(d, tag);
	}
	status = ts_division_send(sim, rows, to);
	ts_free(to);
	return status;
}

static enum ts_status send_lines(struct tsim *sim, struct ts_data *d)
{
	struct ts_new_rows atoms = { d->atom, d->n, d->capacity, sizeof *d->atom };
	struct ts_new_rows motion = { d->motion, d->nmotion, d->motion_capacity, sizeof *d->motion };
	enum ts_status status = send_rows(sim, d, &atoms, offsetof(struct ts_data_atom, tag));

	if (status == TS_OK)
		status = send_rows(sim, d, &motion, offsetof(struct ts_data_motion, tag));
	d->atom = atoms.row;
	d->n = atoms.n;
	d->capacity = atoms.capacity;
	d->motion = motion.row;
	d->nmotion = motion.n;
	d->motion_capacity = motion.capacity;
	return status;
}

static int compare_tags(const void *a, const void *b)
{
	const struct ts_data_atom *p = a, *q = b;

	return (p->tag > q->tag) - (p->tag < q->tag);
}

/* Sorts the particles by id, and gives them their velocities; false: an id occurs twice, or there is none for a velocity. */
static bool join_lines(struct ts_data *d)
{
	struct ts_data_atom wanted = { 0 }, *atom;

	ts_sort(d->atom, d->n, sizeof *d->atom, compare_tags);
	for (size_t k = 1; k < d->n; k++)
		if (d->atom[k].tag == d->atom[k - 1].tag)
			return false;
	for (size_t k = 0; k < d->nmotion; k++) {
		wanted.tag = d->motion[k].tag;
		atom = bsearch(&wanted, d->atom, d->n, sizeof *d->atom, compare_tags);
		if (!atom)
			return false;
		memcpy(atom->v, d->motion[k].v, sizeof atom->v);
		memcpy(atom->omega, d->motion[k].omega, sizeof atom->omega);
	}
	return true;
}

/* Whether it is so on all ranks. */
static bool all_agree(const struct tsim *sim, bool ok)
{
	int64_t bad = !ok;

	ts_ranks_sums(sim, &bad, 1);
	return !bad;
}

enum ts_status ts_data_join(struct tsim *sim, struct ts_data *d, const struct ts_data_options *options,
			    bool *ok)
{
	*ok = all_agree(sim, !d->failed);
	if (!*ok)
		return TS_OK;
	TS_TRY(send_lines(sim, d));
	*ok = all_agree(sim, join_lines(d) && ts_data_check(sim, d, options) == TS_OK);
	ts_error_clear(&sim->error);
	ts_free(d->motion);
	d->motion = NULL;
	d->nmotion = d->motion_capacity = 0;
	return TS_OK;
}
