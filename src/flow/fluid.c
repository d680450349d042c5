#include "flow/fluid.h"

#include <string.h>

#include "base/alloc.h"
#include "flow/fluid_slabs.h"
#include "flow/near_exchange.h"

#include "base/banned.h"

static void release_vector(double *field[3])
{
	for (int d = 0; d < 3; d++) {
		ts_grid_field_free(field[d]);
		field[d] = NULL;
	}
}

void ts_fluid_face_velocity_release(struct ts_flow_face_velocity *velocity)
{
	for (int c = 0; c < 3; c++) {
		ts_free(velocity->plane[c]);
		velocity->plane[c] = NULL;
	}
}

static void release_scalar(double **field)
{
	ts_grid_field_free(*field);
	*field = NULL;
}

void ts_fluid_release_void_fraction(struct ts_fluid *fluid)
{
	release_scalar(&fluid->void_fraction);
	release_scalar(&fluid->void_fraction_rate);
	release_vector(fluid->void_fraction_face);
	release_vector(fluid->momentum_void_fraction);
}

void ts_fluid_release(struct ts_fluid *fluid)
{
	release_vector(fluid->u);
	release_vector(fluid->force);
	release_vector(fluid->exchange);
	release_vector(fluid->exchange_velocity);
	ts_fluid_release_void_fraction(fluid);
	release_scalar(&fluid->p);
	release_scalar(&fluid->p_mean);
	for (int d = 0; d < 3; d++)
		for (int side = 0; side < 2; side++) {
			ts_fluid_face_velocity_release(&fluid->face_velocity[d][side]);
			ts_free(fluid->pressure[d][side].plane);
			fluid->pressure[d][side].plane = NULL;
		}
	ts_fluid_near_release(&fluid->near);
	ts_grid_release(&fluid->grid);
	ts_free(fluid->counted);
	fluid->counted = NULL;
	fluid->ncounted = fluid->counted_capacity = 0;
	if (fluid->owners)
		ts_cell_owners_release(fluid->owners);
	ts_free(fluid->owners);
	fluid->owners = NULL;
}

/* With this value in the planes of this rank. */
static enum ts_status allocate_field(const struct ts_fluid *fluid, double **field, double value)
{
	if (*field)
		return TS_OK;
	*field = ts_grid_field(&fluid->grid);
	for (int range = 0; *field && value != 0 && range < ts_fluid_ranges(fluid); range++) {
		size_t first, end;

		ts_fluid_range_values(fluid, range, &first, &end);
		for (size_t k = first; k < end; k++)
			(*field)[k] = value;
	}
	return *field ? TS_OK : TS_NOMEM;
}

static enum ts_status allocate_vector(const struct ts_fluid *fluid, double *field[3], double value)
{
	for (int d = 0; d < 3; d++)
		TS_TRY(allocate_field(fluid, &field[d], value));
	return TS_OK;
}

enum ts_status ts_fluid_make(struct ts_fluid *fluid)
{
	TS_TRY(allocate_vector(fluid, fluid->u, 0));
	return allocate_field(fluid, &fluid->p, 0);
}

enum ts_status ts_fluid_require_fields(struct ts_fluid *fluid, struct tsim *sim, unsigned fields)
{
	enum ts_status status = TS_OK;

	if (fields & TS_FLUID_FORCE)
		status = allocate_vector(fluid, fluid->force, 0);
	if (fields & TS_FLUID_EXCHANGE && status == TS_OK)
		status = allocate_vector(fluid, fluid->exchange, 0);
	if (fields & TS_FLUID_EXCHANGE && status == TS_OK)
		status = allocate_vector(fluid, fluid->exchange_velocity, 0);
	if (fields & TS_FLUID_VOID && status == TS_OK)
		status = allocate_field(fluid, &fluid->void_fraction, 1);
	if (fields & TS_FLUID_VOID && status == TS_OK)
		status = allocate_field(fluid, &fluid->void_fraction_rate, 0);
	if (fields & TS_FLUID_VOID && status == TS_OK)
		status = allocate_vector(fluid, fluid->void_fraction_face, 1);
	if (fields & TS_FLUID_P_MEAN && status == TS_OK)
		status = allocate_field(fluid, &fluid->p_mean, 0);
	return status == TS_OK ? TS_OK : ts_nomem(&sim->error);
}

/* Where ranks have planes, and no particles, they are zero. */
void ts_fluid_clear(const struct ts_fluid *fluid, double *field)
{
	if (fluid->near.active)
		ts_fluid_near_clear(fluid, field);
	else if (!ts_fluid_divided(fluid))
		memset(field, 0, fluid->grid.size * sizeof *field);
}

enum ts_status ts_fluid_share_sources(struct ts_fluid *fluid, struct tsim *sim)
{
	double *field[6];
	enum ts_status status;
	size_t n = 0;

	if (!fluid->apart)
		return TS_OK;
	fluid->apart = false;
	for (int d = 0; d < 6; d++) {
		double *of = d < 3 ? fluid->force[d] : fluid->exchange[d - 3];

		if (of)
			field[n++] = of;
	}
	status = fluid->near.active ? ts_fluid_near_gather(fluid, field, n, false)
				    : ts_cell_owners_share(fluid->owners, sim->world, &fluid->grid, field, n);
	return status == TS_OK ? TS_OK : ts_nomem(&sim->error);
}

double ts_fluid_kick_fraction(const struct tsim *sim)
{
	const struct ts_instances *fixes = &sim->instances[TS_KIND_FIX];

	for (size_t k = 0; k < fixes->n; k++)
		if (fixes->item[k]->style->hook[TS_STAGE_INITIAL_INTEGRATE] &&
		    fixes->item[k]->style->hook[TS_STAGE_FINAL_INTEGRATE])
			return 0.5;
	return 1;
}
