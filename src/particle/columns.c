#include "particle/columns.h"

#include <string.h>

#include "base/inline.h"
#include "base/parallel.h"
#include "particle/identity.h"
#include "particle/sphere_shape.h"

#include "base/banned.h"

static void *column_row(const struct ts_column *c, size_t row)
{
	return (char *)c->data + row * c->element * c->width;
}

static void update_bound_pointer(struct ts_column *c)
{
	if (c->bound)
		*c->bound = c->data;
}

/* Keeps the first `rows` rows; those after them up to `needed` become zero; spare ones behind are not written, so that they
 * take no memory. */
static enum ts_status reallocate_column(struct tsim *sim, struct ts_column *c, size_t rows, size_t needed,
					size_t capacity)
{
	size_t row = c->width * c->element;
	char *data = ts_alloc_unset(capacity, row);

	if (!data)
		return ts_nomem(&sim->error);
	rows = c->data ? rows : 0;
	if (rows)
		memcpy(data, c->data, rows * row);
	memset(data + rows * row, 0, (needed - rows) * row);
	ts_shared_buffer_free(&sim->holds, c->data);
	c->data = data;
	update_bound_pointer(c);
	sim->generation++;
	return TS_OK;
}

enum ts_status ts_particles_reserve(struct tsim *sim, size_t rows)
{
	struct ts_particles *p = sim->particles;
	/* by a quarter: columns take about 200 bytes a particle, and most runs need room for a few ghosts only */
	size_t more = p->capacity + p->capacity / 4, capacity = rows > more ? rows : more;

	if (rows <= p->capacity)
		return TS_OK;
	if (capacity < 16)
		capacity = 16;
	for (size_t k = 0; k < p->ncolumns; k++)
		if (p->column[k].active)
			TS_TRY(reallocate_column(sim, &p->column[k], p->n + p->nghost, rows, capacity));
	p->capacity = capacity;
	return TS_OK;
}

enum ts_status ts_particles_reserve_ghosts(struct tsim *sim, size_t n)
{
	struct ts_particles *p = sim->particles;
	size_t capacity = p->ghost_capacity;

	TS_TRY(ts_particles_reserve(sim, p->n + n));
	if (TS_GROW(p->ghost_owner, capacity, n) != TS_OK)
		return ts_nomem(&sim->error);
	capacity = p->ghost_capacity;
	if (TS_GROW(p->ghost_shift, capacity, n) != TS_OK)
		return ts_nomem(&sim->error);
	p->ghost_capacity = capacity;
	return TS_OK;
}

enum ts_status ts_particles_need(struct tsim *sim, unsigned columns)
{
	struct ts_particles *p = sim->particles;

	for (size_t k = 0; k < TS_NCOLUMN_BUILTIN; k++) {
		struct ts_column *c = &p->column[k];

		if (c->active || !((columns >> k) & 1u || c->flags & TS_COL_ALWAYS))
			continue;
		c->active = true;
		if (p->capacity)
			TS_TRY(reallocate_column(sim, c, 0, p->capacity, p->capacity));
	}
	return TS_OK;
}

bool ts_particles_column_orphaned(const struct tsim *sim, const struct ts_column *c)
{
	for (int kind = 0; kind < TS_NKIND; kind++)
		for (size_t k = 0; k < sim->instances[kind].n; k++)
			if (sim->instances[kind].item[k]->serial == c->owner)
				return false;
	return c->owner != 0;
}

static void add_owner(struct tsim *sim, struct ts_column *c)
{
	if (sim->defining && sim->defining != c->owner)
		c->owner = ts_particles_column_orphaned(sim, c) ? sim->defining : 0;
}

enum ts_status ts_particles_add_column(struct tsim *sim, const char *name, size_t width, unsigned flags,
				       size_t *index)
{
	struct ts_particles *p = sim->particles;
	struct ts_column *c;

	for (*index = 0; *index < p->ncolumns; ++*index)
		if (ts_streq(p->column[*index].name, name))
			break;
	if (*index < p->ncolumns) {
		add_owner(sim, &p->column[*index]);
		p->column[*index].flags |= flags & TS_COL_COPIED;
		if (p->column[*index].width == width)
			return TS_OK;
		return ts_fail(&sim->error, TS_STATE, NULL,
			       "there is a column '%s' of %zu numbers per particle already, this one would "
			       "have %zu; use another name",
			       name, p->column[*index].width, width);
	}
	if (TS_GROW(p->column, p->column_capacity, p->ncolumns + 1) != TS_OK)
		return ts_nomem(&sim->error);
	c = &p->column[p->ncolumns];
	*c = (struct ts_column){ .name = ts_pool_get(sim->pool, name),
				 .type = TS_SAVED_F64,
				 .element = sizeof(double),
				 .width = width,
				 .flags = flags,
				 .active = true,
				 .owner = sim->defining };
	if (!c->name || (p->capacity && reallocate_column(sim, c, 0, p->capacity, p->capacity) != TS_OK))
		return ts_nomem(&sim->error);
	p->ncolumns++;
	return TS_OK;
}

enum ts_status ts_particles_column_initial(struct tsim *sim, size_t index, const double *initial)
{
	struct ts_column *c = &sim->particles->column[index];

	if (!c->initial)
		c->initial = ts_alloc(c->width, sizeof *c->initial);
	if (!c->initial)
		return ts_nomem(&sim->error);
	memcpy(c->initial, initial, c->width * sizeof *initial);
	return TS_OK;
}

void ts_particles_fill_initial(struct ts_column *column, size_t from, size_t to)
{
	for (size_t i = from; column->initial && i < to; i++)
		memcpy(column_row(column, i), column->initial, column->width * column->element);
}

/* Copies the numbers saved for each tag to the particle that has the tag; others are skipped. */
static enum ts_status scatter_by_tag(struct tsim *sim, const struct ts_column *c, const int32_t *tag,
				     size_t n, const double *data)
{
	struct ts_identities map;

	TS_TRY(ts_identities(sim, false, &map));
	for (size_t k = 0; k < n; k++)
		if (ts_identity_row(&map, tag[k]) >= 0)
			memcpy(column_row(c, (size_t)ts_identity_row(&map, tag[k])), data + k * c->width,
			       c->width * c->element);
	return TS_OK;
}

enum ts_status ts_particles_archive_column(struct ts_archive *archive, struct tsim *sim, const char *name,
					   size_t index)
{
	struct ts_particles *p = sim->particles;
	const struct ts_column *c = &p->column[index];
	size_t tags = p->n, numbers = p->n * c->width, room = 0, space = 0;
	struct ts_str key = { 0 };
	int32_t *tag = NULL;
	double *data = NULL;
	enum ts_status status;

	if (!ts_archive_writing(archive) && !ts_archive_has(archive, name))
		return TS_OK; /* files of version 1 have no such columns */
	ts_str_addf(&key, "%s of", name);
	if (key.failed)
		return ts_nomem(&sim->error);
	if (ts_archive_writing(archive)) {
		status = ts_archive_fixed(archive, ts_str_text(&key), TS_SAVED_I32, p->tag, p->n);
		if (status == TS_OK)
			status = ts_archive_fixed(archive, name, TS_SAVED_F64, c->data, numbers);
	} else {
		status = ts_archive_array(archive, ts_str_text(&key), TS_SAVED_I32, (void **)&tag, &room,
					  &tags);
		if (status == TS_OK)
			status = ts_archive_array(archive, name, TS_SAVED_F64, (void **)&data, &space,
						  &numbers);
		if (status == TS_OK && numbers != tags * c->width)
			status = ts_fail(&sim->error, TS_DAMAGED, NULL, "'%s' does not fit its particles",
					 name);
		if (status == TS_OK)
			status = scatter_by_tag(sim, c, tag, tags, data);
	}
	ts_str_release(&key);
	ts_free(tag);
	ts_free(data);
	return status;
}

enum ts_status ts_particles_add_some(struct tsim *sim, size_t n, size_t all, size_t *first)
{
	struct ts_particles *p = sim->particles;

	p->nghost = 0;
	if (all > (size_t)(INT32_MAX - p->max_tag))
		return ts_fail(&sim->error, TS_RANGE, NULL, "too many particles");
	TS_TRY(ts_particles_reserve(sim, p->n + n));
	for (size_t k = 0; k < p->ncolumns && n; k++)
		if (p->column[k].active)
			memset(column_row(&p->column[k], p->n), 0,
			       n * p->column[k].width * p->column[k].element);
	for (size_t k = TS_NCOLUMN_BUILTIN; k < p->ncolumns; k++)
		ts_particles_fill_initial(&p->column[k], p->n, p->n + n);
	*first = p->n;
	for (size_t i = p->n; i < p->n + n; i++) {
		p->type[i] = 1;
		p->mask[i] = 1;
		p->radius[i] = 0.5;
		p->mass[i] = ts_particle_volume(sim, 0.5);
	}
	p->n += n;
	p->max_tag += (int32_t)all;
	if (sim->run.inside) /* inserted during a run: the fix has checked overlaps */
		p->max_run_tag = p->max_tag;
	sim->generation++;
	return TS_OK;
}

enum ts_status ts_particles_add(struct tsim *sim, size_t n, size_t *first)
{
	struct ts_particles *p = sim->particles;

	TS_TRY(ts_particles_add_some(sim, n, n, first));
	for (size_t k = 0; k < n; k++)
		p->tag[*first + k] = p->max_tag - (int32_t)(n - 1 - k);
	return TS_OK;
}

/* The rows may overlap. */
static void move_rows(struct ts_particles *p, size_t from, size_t n, size_t to)
{
	for (size_t k = 0; k < p->ncolumns; k++)
		if (p->column[k].active)
			memmove(column_row(&p->column[k], to), column_row(&p->column[k], from),
				n * p->column[k].width * p->column[k].element);
}

enum ts_status ts_particles_delete(struct tsim *sim, const unsigned char *flag)
{
	struct ts_particles *p = sim->particles;
	size_t kept = 0, end = 0;

	p->nghost = 0;
	for (size_t i = 0; i < p->n; i = end + 1) { /* all rows up to the next one that goes */
		for (end = i; end < p->n && !flag[end]; end++)
			;
		if (kept != i && end > i)
			move_rows(p, i, end - i, kept);
		kept += end - i;
	}
	p->n = kept;
	sim->generation++;
	return TS_OK;
}

struct reorder {
	const char *from;
	char *to;
	size_t row; /* bytes */
	const int32_t *order;
};

/* Inlined with rows of known size, for which a copy is a few instructions. */
TS_INLINE void gather_rows(const struct reorder *r, size_t row, size_t from, size_t to)
{
	for (size_t i = from; i < to; i++)
		memcpy(r->to + i * row, r->from + (size_t)r->order[i] * row, row);
}

static void reorder_range(void *context, size_t from, size_t to)
{
	const struct reorder *r = context;

	if (r->row == sizeof(int32_t))
		gather_rows(r, sizeof(int32_t), from, to);
	else if (r->row == sizeof(double))
		gather_rows(r, sizeof(double), from, to);
	else if (r->row == sizeof(double[3]))
		gather_rows(r, sizeof(double[3]), from, to);
	else
		gather_rows(r, r->row, from, to);
}

enum ts_status ts_particles_reorder(struct tsim *sim, const int32_t *order)
{
	struct ts_particles *p = sim->particles;

	p->nghost = 0;
	sim->generation++;
	for (size_t k = 0; k < p->ncolumns; k++) {
		struct ts_column *c = &p->column[k];
		size_t row = c->width * c->element;
		char *data;

		if (!c->active || !p->capacity)
			continue;
		data = ts_alloc_unset(p->capacity, row);
		if (!data)
			return ts_nomem(&sim->error);
		ts_parallel(ts_team(sim, 2 * p->n), p->n, reorder_range,
			    &(struct reorder){ c->data, data, row, order });
		ts_shared_buffer_free(&sim->holds, c->data);
		c->data = data;
		update_bound_pointer(c);
	}
	return TS_OK;
}

void ts_particles_inverse_mass(struct ts_particles *p)
{
	for (size_t i = 0; i < p->n; i++)
		p->imass[i] = 1.0 / p->mass[i];
}
