/* Per-particle quantities: copied by name, and stored columns without copying. */
#include "library/library.h"

#include "particle/assign.h"
#include "particle/identity.h"
#include "particle/particles.h"
#include "particle/quantity.h"

#include "base/banned.h"

#define SAME(type) _Static_assert((int)TSIM_##type == (int)TS_SAVED_##type, "types agree")
SAME(F64);
SAME(I32);

size_t tsim_count(struct tsim *sim)
{
	return sim ? sim->particles->n : 0;
}

uint64_t tsim_generation(struct tsim *sim)
{
	return sim ? sim->generation : 0;
}

const char *tsim_quantity_name(size_t k)
{
	return ts_particles_quantity_name(k);
}

static enum ts_status check_count(struct tsim *sim, size_t n)
{
	if (n == tsim_count(sim))
		return TS_OK;
	return ts_fail(&sim->error, TS_RANGE, NULL, "the array has room for %zu particles, there are %zu", n,
		       tsim_count(sim));
}

enum ts_status ts_library_rows(struct tsim *sim, const int32_t *id, size_t n, int32_t **rows)
{
	struct ts_identities map;

	if (!id)
		TS_TRY(check_count(sim, n));
	TS_TRY(ts_identities(sim, !id, &map));
	*rows = ts_alloc(n, sizeof **rows);
	if (!*rows)
		return ts_nomem(&sim->error);
	for (size_t k = 0; !id && k < map.n; k++)
		(*rows)[k] = map.row[k];
	for (size_t k = 0; id && k < n; k++) {
		(*rows)[k] = ts_identity_row(&map, id[k]);
		if ((*rows)[k] < 0) {
			ts_free(*rows);
			*rows = NULL;
			return ts_fail(&sim->error, TS_UNKNOWN, NULL, "there is no particle with identity %d",
				       id[k]);
		}
	}
	return TS_OK;
}

static enum ts_status evaluate_quantity(struct tsim *sim, const char *name, struct ts_table *table)
{
	struct ts_suggest suggest = ts_suggest_start(name);

	if (ts_quantity_has(sim, name))
		return ts_quantity_eval(sim, name, table);
	ts_quantity_suggest(sim, &suggest);
	return ts_fail(&sim->error, TS_UNKNOWN, NULL, "unknown particle column '%s'%s", name,
		       ts_suggest_text(&suggest));
}

/* Copies a quantity. row NULL: in the order of memory. */
static enum ts_status read_quantity(struct tsim *sim, const char *name, const int32_t *row, double *out,
				    size_t n)
{
	struct ts_table table = { 0 };
	enum ts_status status = evaluate_quantity(sim, name, &table);

	for (size_t k = 0; status == TS_OK && k < n; k++)
		out[k] = table.data[row ? (size_t)row[k] : k];
	ts_table_release(&table);
	return status;
}

/* Inside a step ghosts have copies of positions and velocities, and contacts depend on radii, so these
 * cannot be changed. */
static enum ts_status check_writable(struct tsim *sim, const char *name)
{
	enum ts_assign kind = ts_particles_assignable(sim, name);
	int stage = sim->library->stage;

	if (kind == TS_ASSIGN_FORCE && stage < 0)
		return ts_fail(&sim->error, TS_STATE, NULL,
			       "'%s' can be written only by a function of tsim_on_step: a run begins with "
			       "computing forces",
			       name);
	if (kind == TS_ASSIGN_MOTION && stage >= 0 && stage != TSIM_END_OF_STEP)
		return ts_fail(&sim->error, TS_STATE, NULL,
			       "inside a step '%s' can be written only at its end", name);
	if (kind == TS_ASSIGN_PROPERTY && stage >= 0)
		return ts_fail(&sim->error, TS_STATE, NULL, "'%s' can be written only between runs", name);
	return TS_OK;
}

/* Before each run all data that forces depend on are compared with their state after the last one
 * (fingerprint), so new values need not be registered. */
static enum ts_status write_quantity(struct tsim *sim, const char *name, const int32_t *row, const double *in,
				     size_t n)
{
	TS_TRY(check_writable(sim, name));
	if (!sim->run.inside)
		TS_TRY(ts_stepping_watch(&sim->library->stepping, sim));
	return ts_particles_assign(sim, name, row, in, n);
}

int tsim_column_read(struct tsim *sim, const char *name, double *out, size_t n)
{
	TS_LIBRARY_NEEDS(sim, sim);
	TS_LIBRARY_NEEDS(sim, name);
	TS_LIBRARY_NEEDS_ARRAY(sim, out, n);

	enum ts_status status = check_count(sim, n);

	if (status == TS_OK)
		status = read_quantity(sim, name, NULL, out, n);
	return ts_library_result(sim, status);
}

int tsim_column_write(struct tsim *sim, const char *name, const double *in, size_t n)
{
	TS_LIBRARY_NEEDS(sim, sim);
	TS_LIBRARY_NEEDS(sim, name);
	TS_LIBRARY_NEEDS_ARRAY(sim, in, n);

	enum ts_status status = check_count(sim, n);

	if (status == TS_OK)
		status = write_quantity(sim, name, NULL, in, n);
	return ts_library_result(sim, status);
}

int tsim_gather(struct tsim *sim, const char *name, const int32_t *id, double *out, size_t n)
{
	TS_LIBRARY_NEEDS(sim, sim);
	TS_LIBRARY_NEEDS(sim, name);
	TS_LIBRARY_NEEDS_ARRAY(sim, out, n);

	int32_t *rows = NULL;
	enum ts_status status = ts_library_rows(sim, id, n, &rows);

	if (status == TS_OK)
		status = read_quantity(sim, name, rows, out, n);
	ts_free(rows);
	return ts_library_result(sim, status);
}

int tsim_scatter(struct tsim *sim, const char *name, const int32_t *id, const double *in, size_t n)
{
	TS_LIBRARY_NEEDS(sim, sim);
	TS_LIBRARY_NEEDS(sim, name);
	TS_LIBRARY_NEEDS_ARRAY(sim, in, n);

	int32_t *rows = NULL;
	enum ts_status status = ts_library_rows(sim, id, n, &rows);

	if (status == TS_OK)
		status = write_quantity(sim, name, rows, in, n);
	ts_free(rows);
	return ts_library_result(sim, status);
}

int tsim_hold(struct tsim *sim, void *data)
{
	TS_LIBRARY_NEEDS(sim, sim);
	if (!data)
		return TSIM_OK;
	return ts_library_result(sim, ts_shared_buffer(&sim->holds, data));
}

void tsim_release(struct tsim *sim, const void *data)
{
	if (sim && data)
		ts_shared_buffer_release(&sim->holds, data);
}

const char *tsim_column_name(struct tsim *sim, size_t k)
{
	const struct ts_particles *p = sim ? sim->particles : NULL;

	for (size_t c = 0; p && c < p->ncolumns; c++)
		if (p->column[c].active && k-- == 0)
			return p->column[c].name;
	return NULL;
}

static const struct ts_column *find_column(const struct ts_particles *p, const char *name)
{
	for (size_t c = 0; c < p->ncolumns; c++)
		if (p->column[c].active && ts_streq(p->column[c].name, name))
			return &p->column[c];
	return NULL;
}

static enum ts_status fail_no_column(struct tsim *sim, const char *name)
{
	const struct ts_particles *p = sim->particles;
	struct ts_suggest suggest = ts_suggest_start(name);

	for (size_t c = 0; c < p->ncolumns; c++) {
		if (!p->column[c].active && ts_streq(p->column[c].name, name))
			return ts_fail(&sim->error, TS_STATE, NULL,
				       "column '%s' is not stored: no style of the script needs it", name);
		if (p->column[c].active)
			ts_suggest_try(&suggest, p->column[c].name);
	}
	return ts_fail(&sim->error, TS_UNKNOWN, NULL, "there is no stored column '%s'%s", name,
		       ts_suggest_text(&suggest));
}

static bool is_writable(const struct tsim *sim, const struct ts_column *c)
{
	const void *data = c->bound;
	const struct ts_particles *p = sim->particles;
	int stage = sim->library->stage;

	if (c->flags & TS_COL_NAMED || data == &p->x || data == &p->v || data == &p->omega)
		return stage < 0 || stage == TSIM_END_OF_STEP;
	return (data == &p->f || data == &p->torque) && stage >= 0;
}

int tsim_column_view(struct tsim *sim, const char *name, struct tsim_view *out)
{
	TS_LIBRARY_NEEDS(sim, sim);
	TS_LIBRARY_NEEDS(sim, name);
	TS_LIBRARY_NEEDS(sim, out);

	const struct ts_column *c = find_column(sim->particles, name);
	struct ts_stepping *stepping = &sim->library->stepping;
	struct tsim_view full;

	if (!c)
		return (int)fail_no_column(sim, name);
	full = (struct tsim_view){ .data = c->data,
				   .type = ts_streq(name, "mask") ? TSIM_U32 : (int)c->type,
				   .writable = is_writable(sim, c),
				   .element = c->element,
				   .width = c->width,
				   .count = sim->particles->n,
				   .generation = sim->generation };
	if (full.writable && !sim->run.inside) {
		enum ts_status status = ts_stepping_watch(stepping, sim);

		if (status != TS_OK)
			return ts_library_result(sim, status);
		stepping->always = true;
	}
	ts_library_copy_struct(out, &full, sizeof full);
	return TSIM_OK;
}
