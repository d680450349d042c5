/* Creation and deletion of particles by the calling program; groups. */
#include "library/library.h"

#include <math.h>
#include <string.h>

#include "box/domain.h"
#include "core/group.h"
#include "particle/columns.h"
#include "particle/particles.h"

#include "base/banned.h"

static enum ts_status check_position(struct tsim *sim, size_t k, const double x[3])
{
	const struct ts_box *box = &sim->domain->box;

	for (int d = 0; d < 3; d++) {
		if (!isfinite(x[d]))
			return ts_fail(&sim->error, TS_RANGE, NULL,
				       "new particle %zu: coordinate %d is not finite", k, d);
		if (d == 2 && sim->dimension == 2 && !(x[2] == 0))
			return ts_fail(&sim->error, TS_RANGE, NULL,
				       "new particle %zu: z is %g, in two dimensions it is 0", k, x[2]);
		if (box->face[d][0] == TS_FACE_FIXED && !(x[d] >= box->lo[d] && x[d] <= box->hi[d]))
			return ts_fail(&sim->error, TS_RANGE, NULL,
				       "new particle %zu is outside the box: (%g %g %g)", k, x[0], x[1],
				       x[2]);
	}
	return TS_OK;
}

static enum ts_status check_positive(struct tsim *sim, size_t k, const double *value, const char *name)
{
	if (!value || (value[k] > 0 && isfinite(value[k])))
		return TS_OK;
	return ts_fail(&sim->error, TS_RANGE, NULL, "new particle %zu: %s is %g, expected > 0", k, name,
		       value[k]);
}

static enum ts_status check_new(struct tsim *sim, const struct tsim_particles *from)
{
	int ntypes = sim->particles->ntypes;

	for (size_t k = 0; k < from->n; k++) {
		TS_TRY(check_position(sim, k, from->x + 3 * k));
		TS_TRY(check_positive(sim, k, from->radius, "radius"));
		TS_TRY(check_positive(sim, k, from->density, "density"));
		if (from->type && (from->type[k] < 1 || from->type[k] > ntypes))
			return ts_fail(&sim->error, TS_RANGE, NULL,
				       "new particle %zu: type is %d, expected 1 to %d", k, from->type[k],
				       ntypes);
		for (int d = 0; from->v && d < 3; d++)
			if (!isfinite(from->v[3 * k + (size_t)d]))
				return ts_fail(&sim->error, TS_RANGE, NULL,
					       "new particle %zu: velocity is not finite", k);
	}
	return TS_OK;
}

static void set_particle(struct ts_particles *p, size_t i, const struct tsim_particles *from, size_t k)
{
	double volume, mass;

	memcpy(p->x[i], from->x + 3 * k, sizeof p->x[i]);
	if (from->v)
		memcpy(p->v[i], from->v + 3 * k, sizeof p->v[i]);
	if (from->type)
		p->type[i] = from->type[k];
	if (from->radius)
		p->radius[i] = from->radius[k];
	volume = 4.18879020478639098462 * p->radius[i] * p->radius[i] * p->radius[i]; /* 4 pi / 3 */
	mass = p->type_mass ? p->type_mass[p->type[i]] : 0;
	if (from->density)
		p->mass[i] = from->density[k] * volume;
	else
		p->mass[i] = mass > 0 ? mass : volume;
	p->imass[i] = 1 / p->mass[i];
}

static enum ts_status create_particles(struct tsim *sim, const struct tsim_particles *from, int32_t *id)
{
	struct ts_particles *p = sim->particles;
	size_t first;

	TS_TRY(ts_library_refuse_in_step(sim, "tsim_create"));
	if (!ts_sim_has_box(sim))
		return ts_fail(&sim->error, TS_STATE, NULL, "tsim_create needs a simulation box");
	if (from->n && !from->x)
		return ts_fail(&sim->error, TS_RANGE, NULL, "tsim_create needs positions");
	TS_TRY(check_new(sim, from));
	TS_TRY(ts_stepping_end(&sim->library->stepping, sim));
	TS_TRY(ts_particles_add(sim, from->n, &first));
	for (size_t k = 0; k < from->n; k++) {
		set_particle(p, first + k, from, k);
		if (id)
			id[k] = p->tag[first + k];
	}
	return TS_OK;
}

int tsim_create(struct tsim *sim, const struct tsim_particles *particles, int32_t *id)
{
	TS_LIBRARY_NEEDS(sim, sim);
	TS_LIBRARY_NEEDS(sim, particles);

	struct tsim_particles full = { 0 };

	memcpy(&full, particles, particles->size < sizeof full ? particles->size : sizeof full);
	return ts_library_result(sim, create_particles(sim, &full, id));
}

static enum ts_status delete_rows(struct tsim *sim, const int32_t *row, size_t n)
{
	unsigned char *gone = ts_alloc(sim->particles->n, 1);
	enum ts_status status;

	if (!gone)
		return ts_nomem(&sim->error);
	for (size_t k = 0; k < n; k++)
		gone[row[k]] = 1;
	status = ts_particles_delete(sim, gone);
	ts_free(gone);
	return status;
}

int tsim_delete(struct tsim *sim, const int32_t *id, size_t n)
{
	TS_LIBRARY_NEEDS(sim, sim);
	TS_LIBRARY_NEEDS_ARRAY(sim, id, n);

	int32_t *rows = NULL;
	enum ts_status status = ts_library_refuse_in_step(sim, "tsim_delete");

	if (status == TS_OK && n)
		status = ts_library_rows(sim, id, n, &rows);
	if (status == TS_OK)
		status = ts_stepping_end(&sim->library->stepping, sim);
	if (status == TS_OK && n)
		status = delete_rows(sim, rows, n);
	ts_free(rows);
	return ts_library_result(sim, status);
}

static enum ts_status require_group(struct tsim *sim, const char *name, int *bit)
{
	const struct ts_word word = { .text = name };

	return ts_group_require(sim, &word, bit);
}

int tsim_group_bit(struct tsim *sim, const char *name, int *bit)
{
	TS_LIBRARY_NEEDS(sim, sim);
	TS_LIBRARY_NEEDS(sim, name);
	TS_LIBRARY_NEEDS(sim, bit);
	return ts_library_result(sim, require_group(sim, name, bit));
}

const char *tsim_group_name(struct tsim *sim, int bit)
{
	return sim && bit >= 0 && bit < TS_MAX_GROUPS ? ts_group_name(sim, bit) : NULL;
}

static enum ts_status check_members(struct tsim *sim, size_t n)
{
	if (n == sim->particles->n)
		return TS_OK;
	return ts_fail(&sim->error, TS_RANGE, NULL, "the array has room for %zu particles, there are %zu", n,
		       sim->particles->n);
}

int tsim_group_get(struct tsim *sim, const char *name, unsigned char *member, size_t n)
{
	TS_LIBRARY_NEEDS(sim, sim);
	TS_LIBRARY_NEEDS(sim, name);
	TS_LIBRARY_NEEDS_ARRAY(sim, member, n);

	int bit;
	enum ts_status status = require_group(sim, name, &bit);

	if (status == TS_OK)
		status = check_members(sim, n);
	for (size_t i = 0; status == TS_OK && i < n; i++)
		member[i] = ts_in_group(sim->particles, i, bit);
	return ts_library_result(sim, status);
}

static enum ts_status set_group(struct tsim *sim, const char *name, const unsigned char *member, size_t n)
{
	uint32_t *mask = sim->particles->mask;
	int bit;

	TS_TRY(ts_library_refuse_in_step(sim, "tsim_group_set"));
	TS_TRY(check_members(sim, n));
	if (ts_streq(name, "all"))
		return ts_fail(&sim->error, TS_STATE, NULL, "all particles are in group all");
	TS_TRY(ts_stepping_watch(&sim->library->stepping, sim));
	TS_TRY(ts_group_make(sim, name, NULL, &bit));
	for (size_t i = 0; i < n; i++)
		mask[i] = (mask[i] & ~(1u << bit)) | (member[i] ? 1u << bit : 0);
	return TS_OK;
}

int tsim_group_set(struct tsim *sim, const char *name, const unsigned char *member, size_t n)
{
	TS_LIBRARY_NEEDS(sim, sim);
	TS_LIBRARY_NEEDS(sim, name);
	TS_LIBRARY_NEEDS_ARRAY(sim, member, n);
	return ts_library_result(sim, set_group(sim, name, member, n));
}
