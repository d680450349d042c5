/* Enters a frame of a dump in the simulation. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/sort.h"
#include "box/domain.h"
#include "particle/assign.h"
#include "particle/columns.h"
#include "particle/identity.h"
#include "particle/particles.h"
#include "restart/frames.h"

#include "base/banned.h"

struct frame_import {
	struct tsim *sim;
	const struct ts_frames *f;
	const struct ts_frame_use *use;
	const struct ts_place *where;
	int32_t *row;	 /* [row of the frame] index of the particle; -1: none */
	double *value;	 /* [n] values of one quantity for existing particles */
	int32_t *target; /* [n] indices of these particles */
	size_t n;
};

static double frame_value(const struct frame_import *u, size_t row, int column)
{
	return u->f->value[row * u->f->ncolumns + (size_t)column];
}

static enum ts_status find_id(const struct frame_import *u, int *column)
{
	*column = ts_frames_column(u->f, "id");
	for (size_t r = 0; *column >= 0 && r < u->f->n; r++) {
		double id = frame_value(u, r, *column);

		if (!(id >= 1 && id <= INT32_MAX - 1 && id == floor(id)))
			return ts_fail(&u->sim->error, TS_DAMAGED, u->where,
				       "'%s', step %lld: row %zu has no valid id", u->f->lines.file,
				       (long long)u->f->step, r + 1);
	}
	if (*column >= 0)
		return TS_OK;
	return ts_fail(&u->sim->error, TS_DAMAGED, u->where, "'%s', step %lld: there is no column id",
		       u->f->lines.file, (long long)u->f->step);
}

/* Refuses frames in which an id occurs twice. Dumps of tsim are sorted, others are sorted here. */
static enum ts_status refuse_repeated_ids(const struct frame_import *u)
{
	bool sorted = true;
	double *ids, twice = 0;
	int id;

	TS_TRY(find_id(u, &id));
	for (size_t r = 1; r < u->f->n; r++)
		sorted &= frame_value(u, r - 1, id) < frame_value(u, r, id);
	if (sorted)
		return TS_OK;
	ids = ts_alloc(u->f->n, sizeof *ids);
	if (!ids)
		return ts_nomem(&u->sim->error);
	for (size_t r = 0; r < u->f->n; r++)
		ids[r] = frame_value(u, r, id);
	ts_sort(ids, u->f->n, sizeof *ids, ts_compare_double);
	for (size_t r = 1; r < u->f->n && twice == 0; r++)
		if (ids[r - 1] == ids[r])
			twice = ids[r];
	ts_free(ids);
	if (twice == 0)
		return TS_OK;
	return ts_fail(&u->sim->error, TS_DAMAGED, u->where, "'%s', step %lld: id %.0f occurs twice",
		       u->f->lines.file, (long long)u->f->step, twice);
}

/* Finds the particle of each row of the frame; flags particles that are not in the frame as missing. */
static enum ts_status match_ids(struct frame_import *u, unsigned char *missing)
{
	const struct ts_particles *p = u->sim->particles;
	struct ts_identities map;
	int id;

	TS_TRY(find_id(u, &id));
	TS_TRY(ts_identities(u->sim, false, &map));
	for (size_t i = 0; i < p->n; i++)
		missing[i] = 1;
	for (size_t r = 0; r < u->f->n; r++) {
		double tag = frame_value(u, r, id);

		u->row[r] = tag <= p->max_tag ? ts_identity_row(&map, (int32_t)tag) : -1;
		if (u->row[r] >= 0)
			missing[u->row[r]] = 0;
	}
	return TS_OK;
}

/* Deletes all particles, or with `trim` those that are not in the frame. */
static enum ts_status delete_particles(struct frame_import *u, bool all)
{
	struct ts_particles *p = u->sim->particles;
	unsigned char *flag = ts_alloc(p->n, 1);
	enum ts_status status;

	if (!flag)
		return ts_nomem(&u->sim->error);
	status = match_ids(u, flag);
	for (size_t i = 0; i < p->n; i++)
		flag[i] |= all;
	if (status == TS_OK && (all || u->use->trim))
		status = ts_particles_delete(u->sim, flag);
	if (status == TS_OK)
		status = match_ids(u, flag);
	ts_free(flag);
	return status;
}

static enum ts_status add_missing(struct frame_import *u)
{
	struct ts_particles *p = u->sim->particles;
	int id = ts_frames_column(u->f, "id"), type = ts_frames_column(u->f, "type");
	int32_t max_tag = p->max_tag;
	size_t count = 0, next;

	for (size_t r = 0; r < u->f->n; r++)
		count += u->row[r] < 0;
	if (count && type < 0)
		return ts_fail(&u->sim->error, TS_DAMAGED, u->where,
			       "'%s', step %lld: %zu particles are new, but there is no column type",
			       u->f->lines.file, (long long)u->f->step, count);
	TS_TRY(ts_particles_add(u->sim, count, &next));
	p->max_tag = max_tag;
	for (size_t r = 0; r < u->f->n; r++) {
		double kind = type >= 0 ? frame_value(u, r, type) : 1;

		if (u->row[r] >= 0) { /* it stays as it is with `replace no` */
			u->row[r] = u->use->replace ? u->row[r] : -1;
			continue;
		}
		if (!(kind >= 1 && kind <= p->ntypes && kind == floor(kind)))
			return ts_fail(&u->sim->error, TS_RANGE, u->where,
				       "'%s', step %lld: row %zu has the type %g, types go from 1 to %d",
				       u->f->lines.file, (long long)u->f->step, r + 1, kind, p->ntypes);
		p->type[next] = (int32_t)kind;
		p->tag[next] = (int32_t)frame_value(u, r, id);
		if (p->tag[next] > p->max_tag)
			p->max_tag = p->tag[next];
		if (p->type_mass[p->type[next]] > 0)
			p->mass[next] = p->type_mass[p->type[next]];
		u->row[r] = (int32_t)next++;
	}
	ts_particles_inverse_mass(p);
	return TS_OK;
}

/* Column of a quantity: as labelled, of its name, or for positions one of xs, xu, xsu. */
static int find_column(const struct frame_import *u, const char *field, bool *scaled, bool *unwrapped)
{
	static const char *const kinds[] = { "s", "u", "su" };
	const struct ts_words labels = u->use->labels;
	char name[8];
	int column;

	*scaled = *unwrapped = false;
	for (size_t k = 0; k + 1 < labels.n; k += 2)
		if (ts_streq(labels.word[k].text, field))
			return ts_frames_column(u->f, labels.word[k + 1].text);
	column = ts_frames_column(u->f, field);
	if (field[1] || field[0] < 'x' || field[0] > 'z')
		return column;
	for (size_t k = 0; column < 0 && k < 3; k++) {
		snprintf(name, sizeof name, "%s%s", field, kinds[k]);
		column = ts_frames_column(u->f, name);
		*scaled = column >= 0 && kinds[k][0] == 's';
		*unwrapped = column >= 0 && strchr(kinds[k], 'u');
	}
	return column;
}

/* Unwrapped positions count the box lengths from the first image of the box. */
static void clear_images(const struct frame_import *u, int dim)
{
	for (size_t k = 0; k < u->n; k++)
		u->sim->particles->image[u->target[k]][dim] = 0;
}

static bool has_field(const struct frame_import *u, const char *name)
{
	bool has = false;

	for (size_t k = 0; k < u->use->fields.n; k++)
		has |= ts_streq(u->use->fields.word[k].text, name);
	return has;
}

/* Whether the field is the image flag along an axis whose positions are read, and are unwrapped: they contain it. */
static bool is_image_of_unwrapped(const struct frame_import *u, const char *field)
{
	bool scaled, unwrapped = false;

	if (field[0] != 'i' || field[1] < 'x' || field[1] > 'z' || field[2] || !has_field(u, field + 1))
		return false;
	find_column(u, field + 1, &scaled, &unwrapped);
	return unwrapped;
}

static enum ts_status apply_field(struct frame_import *u, const struct ts_word *field)
{
	int dim = field->text[0] - 'x';
	bool scaled, unwrapped;
	int column = find_column(u, field->text, &scaled, &unwrapped);

	if (is_image_of_unwrapped(u, field->text))
		return TS_OK;
	if (column < 0)
		return ts_fail(&u->sim->error, TS_UNKNOWN, &field->place,
			       "'%s', step %lld: there is no column for '%s'", u->f->lines.file,
			       (long long)u->f->step, field->text);
	u->n = 0;
	for (size_t r = 0; r < u->f->n; r++) {
		double value = frame_value(u, r, column);

		if (u->row[r] < 0)
			continue;
		if (!isfinite(value))
			return ts_fail(&u->sim->error, TS_DAMAGED, &field->place,
				       "'%s', step %lld: row %zu has no number for '%s'", u->f->lines.file,
				       (long long)u->f->step, r + 1, field->text);
		u->value[u->n] = scaled ? u->f->lo[dim] + value * (u->f->hi[dim] - u->f->lo[dim]) : value;
		u->target[u->n++] = u->row[r];
	}
	if (unwrapped)
		clear_images(u, dim);
	return ts_particles_assign(u->sim, field->text, u->target, u->value, u->n);
}

static void set_box(struct tsim *sim, const struct ts_frames *f)
{
	for (int d = 0; d < 3; d++) {
		sim->domain->box.lo[d] = f->lo[d];
		sim->domain->box.hi[d] = f->hi[d];
	}
}

static enum ts_status check_box(const struct frame_import *u)
{
	for (int d = 0; u->use->box && d < 3; d++)
		if (!(u->f->lo[d] < u->f->hi[d]))
			return ts_fail(&u->sim->error, TS_DAMAGED, u->where,
				       "'%s', step %lld: the box has no extent in %c", u->f->lines.file,
				       (long long)u->f->step, 'x' + d);
	return TS_OK;
}

static enum ts_status apply_frame(struct frame_import *u)
{
	TS_TRY(check_box(u));
	TS_TRY(refuse_repeated_ids(u));
	TS_TRY(delete_particles(u, u->use->purge));
	if (u->use->box)
		set_box(u->sim, u->f);
	if (u->use->add)
		TS_TRY(add_missing(u));
	if (!u->use->replace && !u->use->add)
		return TS_OK;
	for (int masses = 0; masses < 2; masses++) /* last: a radius or density sets the mass, too */
		for (size_t k = 0; k < u->use->fields.n; k++)
			if (ts_streq(u->use->fields.word[k].text, "mass") == masses)
				TS_TRY(apply_field(u, &u->use->fields.word[k]));
	return TS_OK;
}

enum ts_status ts_frames_apply(struct tsim *sim, const struct ts_frames *f, const struct ts_frame_use *use,
			       const struct ts_place *where)
{
	struct frame_import u = { .sim = sim, .f = f, .use = use, .where = where };
	enum ts_status status = TS_NOMEM;

	u.row = ts_alloc(f->n, sizeof *u.row);
	u.value = ts_alloc(f->n, sizeof *u.value);
	u.target = ts_alloc(f->n, sizeof *u.target);
	if (u.row && u.value && u.target)
		status = apply_frame(&u);
	else
		ts_nomem(&sim->error);
	ts_free(u.row);
	ts_free(u.value);
	ts_free(u.target);
	return status;
}
