#include "flow/fluid.h"

#include "base/alloc.h"

#include "base/banned.h"

static void release_vector(double *field[3])
{
	for (int d = 0; d < 3; d++) {
		ts_grid_field_free(field[d]);
		field[d] = NULL;
	}
}

void ts_fluid_release(struct ts_fluid *fluid)
{
	double **const scalars[] = { &fluid->p, &fluid->void_fraction, &fluid->void_fraction_rate,
				     &fluid->p_mean };

	release_vector(fluid->u);
	release_vector(fluid->force);
	release_vector(fluid->exchange);
	release_vector(fluid->exchange_velocity);
	release_vector(fluid->void_fraction_face);
	release_vector(fluid->momentum_void_fraction);
	for (size_t k = 0; k < sizeof scalars / sizeof *scalars; k++) {
		ts_grid_field_free(*scalars[k]);
		*scalars[k] = NULL;
	}
	for (int d = 0; d < 3; d++)
		for (int side = 0; side < 2; side++) {
			for (int c = 0; c < 3; c++) {
				ts_free(fluid->face_velocity[d][side].plane[c]);
				fluid->face_velocity[d][side].plane[c] = NULL;
			}
			ts_free(fluid->pressure[d][side].plane);
			fluid->pressure[d][side].plane = NULL;
		}
	ts_grid_release(&fluid->grid);
	ts_free(fluid->counted);
	fluid->counted = NULL;
	fluid->ncounted = fluid->counted_capacity = 0;
	if (fluid->owners)
		ts_cell_owners_release(fluid->owners);
	ts_free(fluid->owners);
	fluid->owners = NULL;
}

static enum ts_status allocate_field(const struct ts_grid *grid, double **field, double value)
{
	if (*field)
		return TS_OK;
	*field = ts_grid_field(grid);
	for (size_t k = 0; *field && value != 0 && k < grid->size; k++)
		(*field)[k] = value;
	return *field ? TS_OK : TS_NOMEM;
}

static enum ts_status allocate_vector(const struct ts_grid *grid, double *field[3], double value)
{
	for (int d = 0; d < 3; d++)
		TS_TRY(allocate_field(grid, &field[d], value));
	return TS_OK;
}

enum ts_status ts_fluid_make(struct ts_fluid *fluid)
{
	TS_TRY(allocate_vector(&fluid->grid, fluid->u, 0));
	return allocate_field(&fluid->grid, &fluid->p, 0);
}

enum ts_status ts_fluid_require_fields(struct ts_fluid *fluid, struct tsim *sim, unsigned fields)
{
	const struct ts_grid *grid = &fluid->grid;
	enum ts_status status = TS_OK;

	if (fields & TS_FLUID_FORCE)
		status = allocate_vector(grid, fluid->force, 0);
	if (fields & TS_FLUID_EXCHANGE && status == TS_OK)
		status = allocate_vector(grid, fluid->exchange, 0);
	if (fields & TS_FLUID_EXCHANGE && status == TS_OK)
		status = allocate_vector(grid, fluid->exchange_velocity, 0);
	if (fields & TS_FLUID_VOID && status == TS_OK)
		status = allocate_field(grid, &fluid->void_fraction, 1);
	if (fields & TS_FLUID_VOID && status == TS_OK)
		status = allocate_field(grid, &fluid->void_fraction_rate, 0);
	if (fields & TS_FLUID_VOID && status == TS_OK)
		status = allocate_vector(grid, fluid->void_fraction_face, 1);
	if (fields & TS_FLUID_P_MEAN && status == TS_OK)
		status = allocate_field(grid, &fluid->p_mean, 0);
	return status == TS_OK ? TS_OK : ts_nomem(&sim->error);
}

enum ts_status ts_fluid_share_sources(struct ts_fluid *fluid, struct tsim *sim)
{
	double *const field[] = { fluid->force[0],    fluid->force[1],	  fluid->force[2],
				  fluid->exchange[0], fluid->exchange[1], fluid->exchange[2] };

	if (!fluid->apart)
		return TS_OK;
	fluid->apart = false;
	if (ts_cell_owners_share(fluid->owners, sim->world, &fluid->grid, field,
				 sizeof field / sizeof *field) != TS_OK)
		return ts_nomem(&sim->error);
	return TS_OK;
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
