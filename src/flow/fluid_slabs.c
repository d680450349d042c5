#include "flow/fluid_slabs.h"

#include "base/banned.h"

struct ts_slabs_field ts_fluid_slabs_field(const struct ts_grid *grid, double *field)
{
	return (struct ts_slabs_field){ field + ts_at(grid, -grid->ghosts[0], -grid->ghosts[1], 0),
					(size_t)grid->stride[2], grid->ghosts[2], grid->ghosts[2] };
}

void ts_fluid_slabs_rows(const struct ts_fluid *fluid, long *first, long *end)
{
	ts_slabs_rows(fluid->slabs, fluid->grid.n[2], fluid->grid.n[1], 0, first, end);
}

void ts_fluid_slabs_values(const struct ts_fluid *fluid, size_t *first, size_t *end)
{
	const struct ts_grid *grid = &fluid->grid;
	size_t n = (size_t)grid->n[2], from, to;

	ts_slabs_own(fluid->slabs, n, &from, &to);
	*first = from == 0 ? 0 : ts_at(grid, -grid->ghosts[0], -grid->ghosts[1], (int)from);
	*end = to == n ? grid->size : ts_at(grid, -grid->ghosts[0], -grid->ghosts[1], (int)to);
}

void ts_fluid_slabs_share(const struct ts_fluid *fluid, double *field)
{
	const struct ts_slabs_field all = ts_fluid_slabs_field(&fluid->grid, field);

	if (ts_slabs_ranks(fluid->slabs) > 1)
		ts_slabs_share(fluid->slabs, &all);
}

double ts_fluid_slabs_most(const struct ts_fluid *fluid, double value)
{
	if (ts_slabs_ranks(fluid->slabs) > 1)
		ts_world_most(fluid->slabs->world, &value, 1);
	return value;
}
