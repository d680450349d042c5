/* The exchanges of projection_step.c and pressure_projection.c, in their order. */
#include "flow/step_rehearsal.h"

#include "flow/fluid_slabs.h"
#include "flow/implicit_viscosity.h"
#include "flow/near_exchange.h"
#include "flow/slab_step.h"
#include "poisson/pressure_choice.h"
#include "rank/rehearsal.h"

#include "base/banned.h"

static enum ts_status rehearse_viscosity(struct ts_projection *p)
{
	const struct ts_viscous_step step = { .fluid = &p->fluid,
					      .operators = &p->operators,
					      .dt = 1,
					      .threads = 1,
					      .slabs = &p->slabs,
					      .rehearsal = true };

	return p->viscous == TS_VISCOUS_EXPLICIT ? TS_OK : ts_viscous_step(&step, p->work);
}

static enum ts_status rehearse_projection(struct ts_projection *p, int iterations)
{
	const struct ts_pressure_style *style = ts_pressure_style_of(p->pressure);

	if (p->poisson.singular && p->fluid.void_fraction) /* ts_projection_void_rate_integral */
		ts_slabs_share(&p->slabs,
			       &(struct ts_slabs_field){ p->rhs, (size_t)p->fluid.grid.n[1], 0, 0 });
	if (style->divided && style->divided(p->pressure)) {
		if (style->rehearse)
			TS_TRY(style->rehearse(p->pressure, iterations));
		ts_slab_step_solved(p, p->fluid.p);
	} else {
		ts_slab_step_share(p, p->rhs);
	}
	if (p->fluid.incremental)
		ts_slab_step_solved(p, p->fluid.p);
	ts_slab_step_corrected(p);
	return TS_OK;
}

static void rehearse_forces(struct ts_projection *p, const struct tsim *sim)
{
	const bool some = ts_projection_parts_have_forces(sim);
	const struct ts_instance *part;

	ts_slab_step_predicted(p, some);
	for (size_t k = 0; (part = ts_sim_next_of(sim, TS_KIND_FIX, TS_FAMILY_FLOW_PART, &k));) {
		const struct ts_flow_part *flow_part = part->state;

		if (flow_part->rehearse_force)
			flow_part->rehearse_force(part, &p->fluid);
	}
	if (some && ts_fluid_divided(&p->fluid))
		ts_slab_step_predicted(p, false);
}

static enum ts_status rehearse_parts(const struct ts_projection *p, const struct tsim *sim)
{
	const struct ts_instance *part;

	for (size_t k = 0; (part = ts_sim_next_of(sim, TS_KIND_FIX, TS_FAMILY_FLOW_PART, &k));) {
		const struct ts_flow_part *flow_part = part->state;

		if (flow_part->rehearse_step)
			TS_TRY(flow_part->rehearse_step(part, &p->fluid));
	}
	return TS_OK;
}

static enum ts_status rehearse_substep(struct ts_projection *p, const struct tsim *sim, double dt,
				       int iterations)
{
	const struct ts_instance *part;

	for (int s = 0; s < ts_flow_time_schemes[p->time].stages; s++) {
		TS_TRY(rehearse_viscosity(p));
		rehearse_forces(p, sim);
		TS_TRY(rehearse_projection(p, iterations));
	}
	for (size_t k = 0; (part = ts_sim_next_of(sim, TS_KIND_FIX, TS_FAMILY_FLOW_PART, &k));) {
		const struct ts_flow_part *flow_part = part->state;

		if (flow_part->rehearse)
			flow_part->rehearse(part, &p->fluid, dt);
	}
	return TS_OK;
}

/* What particles add comes to the ranks that compute with it: in each step of the simulation. */
static void count_gathers(struct ts_projection *p, const struct tsim *sim)
{
	struct ts_fluid *fluid = &p->fluid;
	const struct ts_instance *part;
	bool reacts = false;
	size_t fields = 0;

	for (size_t k = 0; (part = ts_sim_next_of(sim, TS_KIND_FIX, TS_FAMILY_FLOW_PART, &k));) {
		const struct ts_flow_part_sends *sends = &((const struct ts_flow_part *)part->state)->sends;

		reacts |= sends->particles && sends->reaction;
		for (int f = 0; f < sends->fields + sends->sums && sends->particles; f++)
			ts_fluid_near_count_gather(fluid, 1, f < sends->fields);
	}
	for (int d = 0; d < 3 && reacts; d++)
		fields += (size_t)(fluid->force[d] ? 1 : 0) + (size_t)(fluid->exchange[d] ? 1 : 0);
	ts_fluid_near_count_gather(fluid, fields, false);
}

/* Slabs and solver are those of the ranks of sim->world. */
static enum ts_status use_ranks(struct ts_projection *p, struct tsim *sim)
{
	TS_TRY(ts_slabs_make(&p->slabs, sim->world, p->fluid.grid.n[2]));
	return ts_pressure_style_of(p->pressure)->prepare(p->pressure, sim, &p->poisson);
}

struct rehearsal {
	int ranks, iterations;
	const struct ts_rank_blocks *blocks;
	struct ts_world_counts *sent; /* [ranks] */
	struct ts_rehearsed_planes planes;
	bool near; /* ranks have what is near their particles */
};
typedef enum ts_status rehearsal_fn(struct ts_instance *self, struct tsim *sim, struct rehearsal *of);

/* The rank is that of sim->world. */
static enum ts_status rehearse_step(struct ts_instance *self, struct tsim *sim, struct rehearsal *of)
{
	struct ts_projection *p = self->state;
	const double length = (double)p->every * sim->clock.dt;
	enum ts_status status = TS_OK;

	p->fluid.planes.ranges = 0; /* those of another rank */
	TS_TRY(ts_slab_step_begin(p, sim, of->blocks));
	of->near = p->fluid.near.active;
	for (int64_t k = 0; k < p->every && of->near; k++)
		count_gathers(p, sim);
	for (int64_t k = 0; k < p->done && status == TS_OK; k++)
		status = rehearse_substep(p, sim, length / (double)p->done, of->iterations);
	ts_slab_step_count_spread(p, sim);
	if (status == TS_OK)
		status = rehearse_parts(p, sim);
	ts_slab_step_end(p);
	return status;
}

/* All ranks in turn, with one solver. */
static enum ts_status rehearse_steps(struct ts_instance *self, struct tsim *sim, struct rehearsal *of)
{
	struct ts_world *world = sim->world;

	TS_TRY(use_ranks(self->state, sim));
	for (world->rank = 0; world->rank < world->n; world->rank++) {
		world->counts = of->sent[world->rank];
		TS_TRY(rehearse_step(self, sim, of));
		of->sent[world->rank] = world->counts;
	}
	return TS_OK;
}

/* Those of the rank of sim->world, if they are more. */
static void add_planes_of_rank(const struct ts_fluid *fluid, struct ts_rehearsed_planes *most)
{
	const int n = fluid->grid.n[2];
	struct ts_rehearsed_planes planes = { 0, 0 };

	for (int k = -TS_GRID_GHOSTS; k < n + TS_GRID_GHOSTS; k++) {
		const bool has = ts_fluid_has_plane(fluid, k);

		planes.all += has;
		planes.near += has || (fluid->near.active && ts_fluid_near_has_plane(fluid, k));
	}
	most->all = planes.all > most->all ? planes.all : most->all;
	most->near = planes.near > most->near ? planes.near : most->near;
}

static enum ts_status count_planes(struct ts_instance *self, struct tsim *sim, struct rehearsal *of)
{
	struct ts_projection *p = self->state;
	struct ts_world *world = sim->world;

	TS_TRY(use_ranks(p, sim));
	for (world->rank = 0; world->rank < world->n; world->rank++) {
		p->fluid.planes.ranges = 0;
		TS_TRY(ts_slab_step_begin(p, sim, of->blocks));
		add_planes_of_rank(&p->fluid, &of->planes);
	}
	world->rank = 0;
	return TS_OK;
}

/* Calls the function with a world of so many ranks, which send nothing. */
static enum ts_status with_ranks(struct ts_instance *self, struct tsim *sim, rehearsal_fn *rehearse,
				 struct rehearsal *of)
{
	struct ts_projection *p = self->state;
	const struct ts_fluid_planes planes = p->fluid.planes;
	const struct ts_fluid_near near = p->fluid.near;
	const bool apart = p->poisson.apart;
	struct ts_world *real = sim->world, world;
	enum ts_status status;

	ts_rehearsal_make(&world, 0, of->ranks);
	sim->world = &world;
	p->fluid.planes.ranges = 0;
	p->fluid.near = (struct ts_fluid_near){ .margin = near.margin, .reach = near.reach };
	status = rehearse(self, sim, of);
	sim->world = real;
	ts_slabs_release(&p->slabs);
	ts_fluid_near_release(&p->fluid.near);
	p->fluid.near = near;
	p->fluid.planes = planes; /* no plane has been left to another rank */
	p->poisson.apart = apart;
	if (status == TS_OK)
		status = use_ranks(p, sim);
	ts_slab_step_end(p);
	return status == TS_NOMEM ? ts_nomem(&sim->error) : status;
}

enum ts_status ts_projection_rehearse(struct ts_instance *self, struct tsim *sim,
				      const struct ts_rank_blocks *blocks, int iterations,
				      struct ts_world_counts *sent, bool *near)
{
	struct ts_projection *p = self->state;
	struct rehearsal of = { .ranks = ts_rank_blocks_number(blocks),
				.iterations = iterations,
				.blocks = blocks,
				.sent = sent };

	*near = false;
	TS_TRY(ts_projection_choose_substeps(self, sim, (double)p->every * sim->clock.dt));
	if (!ts_slab_step_divides(p, of.ranks))
		return TS_OK;
	TS_TRY(with_ranks(self, sim, rehearse_steps, &of));
	*near = of.near;
	return TS_OK;
}

enum ts_status ts_projection_rehearse_planes(struct ts_instance *self, struct tsim *sim,
					     const struct ts_rank_blocks *blocks,
					     struct ts_rehearsed_planes *planes)
{
	struct rehearsal of = { .ranks = ts_rank_blocks_number(blocks), .blocks = blocks };

	TS_TRY(with_ranks(self, sim, count_planes, &of));
	*planes = of.planes;
	return TS_OK;
}
