#include "flow/slab_step.h"

#include <string.h>

#include "flow/fluid_slabs.h"
#include "poisson/poisson.h"

#include "base/banned.h"

/* ---- which steps are divided */

bool ts_slab_step_divides(const struct ts_projection *p, int ranks)
{
	const struct ts_grid *grid = &p->fluid.grid;

	return grid->dimensions == 3 && grid->n[0] > 1 && grid->n[1] > 1 && grid->n[2] >= ranks;
}

/* Whether a style may evaluate a formula, which may read the fluid, while the particles are divided. Outputs do when all ranks
 * have all of them, and get the fluid then (ts_flow_require_fields). */
static bool has_formula(const struct ts_instance *inst)
{
	const bool is_output = (inst->style->ranks & (TS_RANKS_WHOLE | TS_RANKS_OWN)) == TS_RANKS_WHOLE;

	if (is_output || inst->style->kind == TS_KIND_COMPUTE)
		return false;
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

/* Whether ranks divide the pressure solver; one that is not chosen yet, or may have been removed, may be divided. */
static bool solver_divides(struct ts_projection *p, const struct tsim *sim)
{
	const bool chosen = p->pressure && p->removals == sim->removals;
	const struct ts_pressure_style *style = chosen ? ts_pressure_style_of(p->pressure) : NULL;
	const bool was = p->slabs.active;
	bool divides;

	p->slabs.active = true; /* as it will be */
	divides = !style || (style->divided && style->divided(p->pressure));
	p->slabs.active = was;
	return divides;
}

/* Fields of fixes that take part; they stay when the fix is removed. */
static bool has_fields_of_parts(const struct ts_fluid *fluid)
{
	return fluid->force[0] || fluid->exchange[0] || fluid->void_fraction || fluid->p_mean;
}

/* Whether nothing reads the fluid before all ranks get all particles: no particle feels it, and no formula names it. */
static bool stays_apart(struct ts_projection *p, const struct tsim *sim)
{
	size_t k = 0;

	if (p->fluid.grid.n[2] / sim->world->n < TS_GRID_GHOSTS || boundary_has_formula(p) ||
	    !solver_divides(p, sim) || has_fields_of_parts(&p->fluid) ||
	    ts_sim_next_of(sim, TS_KIND_FIX, TS_FAMILY_FLOW_PART, &k))
		return false;
	for (int kind = 0; kind < TS_NKIND; kind++)
		for (k = 0; k < sim->instances[kind].n; k++)
			if (has_formula(sim->instances[kind].item[k]))
				return false;
	return true;
}

/* The planes of this rank and their ghosts. Those of a rank at an end of a periodic grid are made from planes at the other end. */
static struct ts_fluid_planes choose_planes(const struct ts_projection *p)
{
	enum { G = TS_GRID_GHOSTS };
	const int n = p->slabs.n;
	struct ts_fluid_planes planes = { .ranges = 1 };
	struct ts_fluid_range *low = &planes.range[0], *high = &planes.range[1];
	size_t from, to;

	ts_slabs_own(&p->slabs, (size_t)n, &from, &to);
	*low = *high = (struct ts_fluid_range){ (int)from - G, (int)to + G };
	if (!p->fluid.grid.periodic[2] || (from > 0 && (int)to < n))
		return planes;
	if (from == 0)
		*high = (struct ts_fluid_range){ n - G, n + G };
	else
		*low = (struct ts_fluid_range){ -G, G };
	if (low->to < high->from)
		planes.ranges = 2;
	else
		low->to = high->to;
	return planes;
}

enum { FIELDS = 15 };

/* All fields of a fluid that ranks divide; NULL: not used. */
static void list_fields(struct ts_projection *p, double *field[FIELDS])
{
	size_t n = 0;

	for (int d = 0; d < 3; d++) {
		field[n++] = p->fluid.u[d];
		field[n++] = p->work[d];
		field[n++] = p->second_stage[d];
		field[n++] = p->history[d];
	}
	field[n++] = p->fluid.p;
	field[n++] = p->rhs;
	field[n++] = p->increment;
}

void ts_slab_step_forget(struct ts_projection *p)
{
	const struct ts_fluid *fluid = &p->fluid;
	size_t behind = 0, first, end;
	double *field[FIELDS];

	list_fields(p, field);
	p->history_apart = p->history[0];
	for (int range = 0; range <= fluid->planes.ranges; range++, behind = end) {
		first = end = fluid->grid.size;
		if (range < fluid->planes.ranges)
			ts_fluid_range_values(fluid, range, &first, &end);
		for (size_t k = 0; k < FIELDS; k++)
			if (field[k])
				ts_grid_field_clear(field[k], behind, first);
	}
}

bool ts_slab_step_begin(struct ts_projection *p, const struct tsim *sim)
{
	const bool divides = sim->world && ts_slab_step_divides(p, sim->world->n),
		   some = divides && stays_apart(p, sim), were = ts_fluid_divided(&p->fluid);

	if (!some)
		ts_slab_step_complete(p);
	p->slabs.active = divides;
	if (some)
		p->fluid.planes = choose_planes(p);
	return some && !were;
}

void ts_slab_step_check_solver(struct ts_projection *p, const struct tsim *sim)
{
	if (ts_fluid_divided(&p->fluid) && !solver_divides(p, sim))
		ts_slab_step_complete(p);
}

void ts_slab_step_end(struct ts_projection *p)
{
	p->slabs.active = ts_fluid_divided(&p->fluid);
}

/* With the layer of faces behind the last ghosts, as restart files have it. */
static void share_with_faces(const struct ts_projection *p, double *field)
{
	struct ts_slabs_field all = ts_fluid_slabs_field(&p->fluid.grid, field);

	all.behind++;
	ts_slabs_share(&p->slabs, &all);
}

static void complete_fields(struct ts_projection *p)
{
	struct ts_fluid *fluid = &p->fluid;

	if (!ts_fluid_divided(fluid))
		return;
	p->slabs.active = true;
	for (int d = 0; d < fluid->grid.dimensions; d++)
		share_with_faces(p, fluid->u[d]);
	share_with_faces(p, fluid->p);
	if (p->increment)
		share_with_faces(p, p->increment);
	p->slabs.active = false;
	fluid->planes.ranges = 0;
	ts_fluid_fill_periodic(fluid, fluid->p);
}

static void complete_history(struct ts_projection *p)
{
	if (!p->history_apart)
		return;
	p->slabs.active = true;
	for (int d = 0; d < p->fluid.grid.dimensions; d++)
		share_with_faces(p, p->history[d]);
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
		if (ts_fluid_divided(&p->fluid))
			share_beside(p, u[d], 1, 0);
		else
			ts_slab_step_share(p, u[d]);
	}
}

void ts_slab_step_solved(struct ts_projection *p, double *pressure)
{
	if (ts_fluid_divided(&p->fluid))
		share_beside(p, pressure, 1, 0);
	else
		ts_slab_step_share(p, pressure);
}

void ts_slab_step_corrected(struct ts_projection *p)
{
	for (int d = 0; d < p->fluid.grid.dimensions && p->slabs.active; d++)
		if (ts_fluid_divided(&p->fluid))
			share_beside(p, p->fluid.u[d], TS_GRID_GHOSTS, TS_GRID_GHOSTS);
		else
			ts_slab_step_share(p, p->fluid.u[d]);
}
