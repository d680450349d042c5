#include "flow/slab_step.h"

#include <string.h>

#include "core/ranks.h"
#include "flow/boundary.h"
#include "flow/fluid_fields.h"
#include "flow/fluid_slabs.h"
#include "flow/near_exchange.h"
#include "poisson/poisson.h"

#include "base/banned.h"

/* ---- which steps are divided */

bool ts_slab_step_divides(const struct ts_projection *p, int ranks)
{
	const struct ts_grid *grid = &p->fluid.grid;

	return grid->dimensions == 3 && grid->n[0] > 1 && grid->n[1] > 1 && grid->n[2] >= ranks;
}

/* Whether a style evaluates a formula that reads the fluid while the particles are divided. Outputs do when all ranks have all
 * of them, and get the fluid then (ts_flow_require_fields). */
static bool has_formula(const struct tsim *sim, const struct ts_instance *inst)
{
	const bool is_output = (inst->style->ranks & (TS_RANKS_WHOLE | TS_RANKS_OWN)) == TS_RANKS_WHOLE;

	if (is_output || inst->style->kind == TS_KIND_COMPUTE)
		return false;
	for (size_t k = 0; k < inst->words.n; k++) {
		const char *at = strstr(inst->words.word[k].text, "v_");

		/* a word that has one inside it is a formula of its own sort */
		if (at && (at > inst->words.word[k].text || ts_ranks_variable_reads_fluid(sim, at)))
			return true;
	}
	return false;
}

static bool boundary_has_formula(const struct ts_projection *p, const struct tsim *sim)
{
	for (int face = 0; face < 6; face++) {
		const struct ts_flow_condition *condition = &p->condition[face / 2][face % 2];

		if (ts_ranks_variable_reads_fluid(sim, condition->pressure.variable))
			return true;
		for (int d = 0; d < 3; d++)
			if (ts_ranks_variable_reads_fluid(sim, condition->velocity[d].variable))
				return true;
	}
	return false;
}

static bool some_formulas_read(const struct ts_projection *p, const struct tsim *sim)
{
	if (boundary_has_formula(p, sim))
		return true;
	for (int kind = 0; kind < TS_NKIND; kind++)
		for (size_t k = 0; k < sim->instances[kind].n; k++)
			if (has_formula(sim, sim->instances[kind].item[k]))
				return true;
	return false;
}

/* Whether ranks divide the pressure solver; one that is not chosen yet, or may have been removed, may be divided. */
static bool solver_divides(struct ts_projection *p, const struct tsim *sim)
{
	const bool chosen = p->pressure && p->removals == sim->removals;
	const struct ts_pressure_style *style = chosen ? ts_pressure_style_of(p->pressure) : NULL;
	bool (*ask)(const struct ts_instance *) = style && style->always_divided ? style->always_divided
						  : style			 ? style->divided
										 : NULL;
	const bool was = p->slabs.active;
	bool divides;

	p->slabs.active = true; /* as it will be */
	divides = !style || (ask && ask(p->pressure));
	p->slabs.active = was;
	return divides;
}

/* What the fixes that take part read and change of the fluid. */
struct parts {
	bool near;  /* some of them: near particles */
	bool all;   /* some: all planes */
	int beside; /* planes beside those of the rank, at least the ghosts */
};

static struct parts find_parts(const struct ts_projection *p, const struct tsim *sim)
{
	struct parts out = { .near = p->fluid.near.wanted, .beside = TS_GRID_GHOSTS };
	const struct ts_instance *part;

	for (size_t k = 0; (part = ts_sim_next_of(sim, TS_KIND_FIX, TS_FAMILY_FLOW_PART, &k));) {
		const struct ts_flow_part *flow_part = part->state;

		out.near |= flow_part->sends.nearby;
		out.all |= !flow_part->sends.nearby && flow_part->planes_beside == 0;
		if (flow_part->planes_beside > out.beside)
			out.beside = flow_part->planes_beside;
	}
	return out;
}

/* The flow through faces along z depends on the void fraction of all planes, where the fluid has no open face. */
static bool flow_is_of_all_planes(const struct ts_projection *p)
{
	return p->fluid.void_fraction && p->poisson.singular && !ts_projection_is_tight(p);
}

/* Whether nothing reads the fluid before all ranks get all particles but these, each near its own ones, and no formula names it.
 * blocks NULL: each rank has all particles. */
static bool stays_apart(struct ts_projection *p, const struct tsim *sim, const struct ts_rank_blocks *blocks,
			const struct parts *parts)
{
	return p->fluid.grid.n[2] / sim->world->n >= parts->beside && !p->read_by_formulas &&
	       solver_divides(p, sim) && !flow_is_of_all_planes(p) && !parts->all && (!parts->near || blocks);
}

/* The planes of this rank, and those beside them. Ghosts of a rank at an end of a periodic grid are made from planes at the other
 * end. */
static struct ts_fluid_planes choose_planes(const struct ts_projection *p, int beside)
{
	enum { G = TS_GRID_GHOSTS };
	const int n = p->slabs.n;
	struct ts_fluid_planes planes = { .ranges = 1 };
	struct ts_fluid_range *low = &planes.range[0], *high = &planes.range[1];
	size_t from, to;

	ts_slabs_own(&p->slabs, (size_t)n, &from, &to);
	*low = *high = (struct ts_fluid_range){ from == 0 ? -G : (int)from - beside,
						(int)to == n ? n + G : (int)to + beside };
	if (!p->fluid.grid.periodic[2] || (from > 0 && (int)to < n))
		return planes;
	if (from == 0)
		*high = (struct ts_fluid_range){ n - beside, n + G };
	else
		*low = (struct ts_fluid_range){ -G, beside };
	if (low->to < high->from)
		planes.ranges = 2;
	else
		low->to = high->to;
	return planes;
}

static size_t plane_start(const struct ts_grid *grid, int k)
{
	return (size_t)(k + grid->ghosts[2]) * (size_t)grid->stride[2];
}

/* `near`: planes near the particles of this rank are kept. */
static void forget_planes(const struct ts_fluid *fluid, double *field, bool near)
{
	const struct ts_grid *grid = &fluid->grid;
	const int end = grid->n[2] + grid->ghosts[2];
	int from = -grid->ghosts[2];

	for (int k = from; k <= end; k++) { /* behind the last ghosts there is a layer of faces */
		const int plane = k < end ? k : end - 1;

		if (!ts_fluid_has_plane(fluid, plane) && !(near && ts_fluid_near_has_plane(fluid, plane)))
			continue;
		ts_grid_field_clear(field, plane_start(grid, from), plane_start(grid, k));
		from = k + 1;
	}
	if (from <= end)
		ts_grid_field_clear(field, plane_start(grid, from), grid->size);
}

static void forget(struct ts_projection *p, const struct tsim *sim)
{
	double *field[TS_FIELDS_MOST];

	for (int near = 0; near < 2; near++) {
		const size_t n = ts_fluid_fields_list(p, sim, TS_FIELDS_NEAR, !near, field);

		for (size_t k = 0; k < n; k++)
			forget_planes(&p->fluid, field[k], near && p->fluid.near.active);
	}
	p->history_apart = p->history[0];
}

/* ---- near particles */

enum ts_status ts_slab_step_renew(struct ts_projection *p, const struct tsim *sim,
				  const struct ts_rank_blocks *blocks)
{
	double *field[TS_FIELDS_MOST];
	size_t n;
	bool made;

	TS_TRY(ts_fluid_near_make(&p->fluid, blocks, &made));
	if (!made && !p->fluid.near.stale)
		return TS_OK;
	p->fluid.near.stale = false;
	n = ts_fluid_fields_list(p, sim, TS_FIELDS_SUM, false, field);
	for (size_t k = 0; k < n; k++) /* what was near before, and is not any more, holds parts of sums */
		forget_planes(&p->fluid, field[k], false);
	n = ts_fluid_fields_list(p, sim, TS_FIELDS_PLACE, false, field);
	return ts_fluid_near_spread(&p->fluid, field, n);
}

enum ts_status ts_slab_step_spread(struct ts_projection *p, const struct tsim *sim)
{
	double *field[TS_FIELDS_MOST];

	if (!p->fluid.near.active)
		return TS_OK;
	return ts_fluid_near_spread(&p->fluid, field,
				    ts_fluid_fields_list(p, sim, TS_FIELDS_STEP, false, field));
}

void ts_slab_step_count_spread(struct ts_projection *p, const struct tsim *sim)
{
	double *field[TS_FIELDS_MOST];

	if (p->fluid.near.active)
		ts_fluid_near_count_spread(&p->fluid,
					   ts_fluid_fields_list(p, sim, TS_FIELDS_STEP, false, field));
}

static bool some_read_pressure(const struct tsim *sim)
{
	const struct ts_instance *part;
	bool some = false;

	for (size_t k = 0; (part = ts_sim_next_of(sim, TS_KIND_FIX, TS_FAMILY_FLOW_PART, &k));)
		some |= ((const struct ts_flow_part *)part->state)->sends.pressure;
	return some;
}

/* The ranks keep their planes, and what is near their particles. */
static enum ts_status take_planes(struct ts_projection *p, const struct tsim *sim,
				  const struct ts_rank_blocks *blocks, bool were, const struct parts *parts)
{
	struct ts_fluid *fluid = &p->fluid;

	p->slabs.active = p->poisson.apart = true;
	fluid->planes = choose_planes(p, parts->beside);
	fluid->near.active = parts->near;
	fluid->near.pressure = some_read_pressure(sim);
	if (!fluid->near.active)
		return TS_OK;
	return were ? ts_slab_step_renew(p, sim, blocks) : ts_fluid_near_make(fluid, blocks, NULL);
}

enum ts_status ts_slab_step_begin(struct ts_projection *p, const struct tsim *sim,
				  const struct ts_rank_blocks *blocks)
{
	const struct parts parts = find_parts(p, sim);
	const bool divides = sim->world && ts_slab_step_divides(p, sim->world->n),
		   some = divides && stays_apart(p, sim, blocks, &parts), were = ts_fluid_divided(&p->fluid);

	if (some)
		return take_planes(p, sim, blocks, were, &parts);
	ts_slab_step_complete(p, sim);
	p->slabs.active = divides;
	return TS_OK;
}

enum ts_status ts_slab_step_begin_apart(struct ts_projection *p, const struct tsim *sim,
					const struct ts_rank_blocks *blocks)
{
	const bool had_all = !ts_fluid_divided(&p->fluid);

	TS_TRY(ts_slab_step_begin(p, sim, blocks));
	if (had_all && ts_fluid_divided(&p->fluid))
		forget(p, sim);
	return TS_OK;
}

enum ts_status ts_slab_step_set_up(struct ts_projection *p, const struct tsim *sim,
				   const struct ts_rank_blocks *blocks)
{
	p->read_by_formulas = some_formulas_read(p, sim);
	p->fluid.near.wanted = false;
	TS_TRY(ts_slab_step_begin_apart(p, sim, blocks));
	p->fluid.near.stale = true;
	p->fluid.near.begun = sim->clock.step;
	return TS_OK;
}

bool ts_slab_step_check_solver(struct ts_projection *p, const struct tsim *sim)
{
	const bool needs_all = ts_fluid_divided(&p->fluid) && !solver_divides(p, sim);

	if (needs_all)
		ts_slab_step_complete(p, sim);
	return needs_all;
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

/* Sums of particles are 0 behind a step of the fluid. */
static void complete_fields(struct ts_projection *p, const struct tsim *sim)
{
	struct ts_fluid *fluid = &p->fluid;
	const unsigned uses = TS_FIELDS_LASTING | (p->source_steps > 0 ? TS_FIELDS_SUM : 0);
	double *field[TS_FIELDS_MOST];
	size_t n;

	if (!ts_fluid_divided(fluid))
		return;
	n = ts_fluid_fields_list(p, sim, uses, false, field);
	p->slabs.active = true;
	for (size_t k = 0; k < n; k++)
		share_with_faces(p, field[k]);
	p->slabs.active = p->poisson.apart = fluid->near.active = false;
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

void ts_slab_step_complete(struct ts_projection *p, const struct tsim *sim)
{
	complete_fields(p, sim);
	complete_history(p);
}

/* ---- in a step */

void ts_slab_step_share(struct ts_projection *p, double *field)
{
	ts_fluid_slabs_share(&p->fluid, field);
}

void ts_slab_step_predicted(struct ts_projection *p, bool to_change)
{
	const bool all = to_change && !ts_fluid_divided(&p->fluid);
	double *const *u = p->fluid.u;

	if (!p->slabs.active)
		return;
	for (int d = 0; d < 3 && all; d++)
		ts_slab_step_share(p, u[d]);
	if (all)
		return;
	ts_fluid_slabs_share_beside(&p->fluid, u[2], 0, 1);
	for (int d = 0; d < 2; d++) {
		if (!ts_fluid_leans_on_images(&p->fluid, d))
			continue;
		if (ts_fluid_divided(&p->fluid))
			ts_fluid_slabs_share_beside(&p->fluid, u[d], 1, 0);
		else
			ts_slab_step_share(p, u[d]);
	}
}

void ts_slab_step_solved(struct ts_projection *p, double *pressure)
{
	if (ts_fluid_divided(&p->fluid))
		ts_fluid_slabs_share_beside(&p->fluid, pressure, 1, 0);
	else
		ts_slab_step_share(p, pressure);
}

void ts_slab_step_corrected(struct ts_projection *p)
{
	for (int d = 0; d < p->fluid.grid.dimensions && p->slabs.active; d++)
		if (ts_fluid_divided(&p->fluid))
			ts_fluid_slabs_share_beside(&p->fluid, p->fluid.u[d], TS_GRID_GHOSTS, TS_GRID_GHOSTS);
		else
			ts_slab_step_share(p, p->fluid.u[d]);
}
