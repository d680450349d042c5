#include "flow/slab_step.h"

#include <string.h>

#include "flow/fluid_slabs.h"

#include "base/banned.h"

/* ---- which steps are divided */

bool ts_slab_step_divides(const struct ts_projection *p, int ranks)
{
	const struct ts_grid *grid = &p->fluid.grid;

	return grid->dimensions == 3 && grid->n[0] > 1 && grid->n[1] > 1 && grid->n[2] >= ranks;
}

/* Whether a style may evaluate a formula, which may read the fluid. */
static bool has_formula(const struct ts_instance *inst)
{
	for (size_t k = 0; k < inst->words.n; k++)
		if (strstr(inst->words.word[k].text, "v_"))
			return true;
	return false;
}

static bool boundary_has_formula(const struct ts_projection *p)
{
	for (int face = 0; face < 6; face++) {
		const struct ts_flow_condition *condition = &p->condition[face / 2][face % 2];

		if (condition->pressure.variable)
			return true;
		for (int d = 0; d < 3; d++)
			if (condition->velocity[d].variable)
				return true;
	}
	return false;
}

/* Whether nothing reads the fluid before all ranks get all particles: no particle feels it, and no formula names it. */
static bool stays_apart(const struct ts_projection *p, const struct tsim *sim)
{
	size_t k = 0;

	if (p->fluid.grid.n[2] / sim->world->n < TS_GRID_GHOSTS || boundary_has_formula(p) ||
	    ts_sim_next_of(sim, TS_KIND_FIX, TS_FAMILY_FLOW_PART, &k))
		return false;
	for (int kind = 0; kind < TS_NKIND; kind++)
		for (k = 0; k < sim->instances[kind].n; k++)
			if (has_formula(sim->instances[kind].item[k]))
				return false;
	return true;
}

void ts_slab_step_begin(struct ts_projection *p, const struct tsim *sim)
{
	struct ts_fluid_planes *planes = &p->fluid.planes;
	const bool some = ts_slab_step_divides(p, sim->world->n) && stays_apart(p, sim);
	size_t from, to;

	if (!some)
		ts_slab_step_complete(p);
	p->slabs.active = ts_slab_step_divides(p, sim->world->n);
	ts_slabs_own(&p->slabs, (size_t)p->slabs.n, &from, &to);
	*planes = (struct ts_fluid_planes){ some, (int)from - TS_GRID_GHOSTS, (int)to + TS_GRID_GHOSTS };
	/* Images of planes at the other end of the grid are made with their ghosts. */
	if (p->fluid.grid.periodic[2] && (from == 0 || to == (size_t)p->slabs.n)) {
		planes->from = -TS_GRID_GHOSTS;
		planes->to = p->slabs.n + TS_GRID_GHOSTS;
	}
}

void ts_slab_step_end(struct ts_projection *p)
{
	p->slabs.active = false;
}

static void complete_fields(struct ts_projection *p)
{
	struct ts_fluid *fluid = &p->fluid;

	if (!fluid->planes.some)
		return;
	p->slabs.active = true;
	for (int d = 0; d < fluid->grid.dimensions; d++)
		ts_slab_step_share(p, fluid->u[d]);
	ts_slab_step_share(p, fluid->p);
	if (p->increment)
		ts_slab_step_share(p, p->increment);
	p->slabs.active = false;
	fluid->planes.some = false;
}

static void complete_history(struct ts_projection *p)
{
	if (!p->history_apart)
		return;
	p->slabs.active = true;
	for (int d = 0; d < p->fluid.grid.dimensions; d++)
		ts_slab_step_share(p, p->history[d]);
	p->slabs.active = p->history_apart = false;
}

void ts_slab_step_complete(struct ts_projection *p)
{
	complete_fields(p);
	complete_history(p);
}

/* ---- in a step */

void ts_slab_step_share(struct ts_projection *p, double *field)
{
	ts_fluid_slabs_share(&p->fluid, field);
}

static void share_beside(struct ts_projection *p, double *field, int below, int above)
{
	const struct ts_slabs_field all = ts_fluid_slabs_field(&p->fluid.grid, field);

	ts_slabs_share_beside(&p->slabs, &all, below, above, p->fluid.grid.periodic[2]);
}

void ts_slab_step_predicted(struct ts_projection *p, bool all)
{
	double *const *u = p->fluid.u;

	if (!p->slabs.active)
		return;
	for (int d = 0; d < 3 && all; d++)
		ts_slab_step_share(p, u[d]);
	if (all)
		return;
	share_beside(p, u[2], 0, 1);
	for (int d = 0; d < 2; d++) {
		if (!ts_fluid_leans_on_images(&p->fluid, d))
			continue;
		if (p->fluid.planes.some)
			share_beside(p, u[d], 1, 0);
		else
			ts_slab_step_share(p, u[d]);
	}
}

void ts_slab_step_solved(struct ts_projection *p, double *pressure)
{
	if (p->fluid.planes.some)
		share_beside(p, pressure, 1, 0);
	else
		ts_slab_step_share(p, pressure);
}

void ts_slab_step_corrected(struct ts_projection *p)
{
	for (int d = 0; d < p->fluid.grid.dimensions && p->slabs.active; d++)
		if (p->fluid.planes.some)
			share_beside(p, p->fluid.u[d], TS_GRID_GHOSTS, TS_GRID_GHOSTS);
		else
			ts_slab_step_share(p, p->fluid.u[d]);
}
