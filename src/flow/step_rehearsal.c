/* The exchanges of projection_step.c and pressure_projection.c, in their order. */
#include "flow/step_rehearsal.h"

#include "flow/implicit_viscosity.h"
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

static enum ts_status rehearse_substep(struct ts_projection *p, const struct tsim *sim, double dt,
				       int iterations)
{
	const struct ts_instance *part;

	for (int s = 0; s < ts_flow_time_schemes[p->time].stages; s++) {
		TS_TRY(rehearse_viscosity(p));
		ts_slab_step_predicted(p, ts_projection_parts_have_forces(sim));
		TS_TRY(rehearse_projection(p, iterations));
	}
	for (size_t k = 0; (part = ts_sim_next_of(sim, TS_KIND_FIX, TS_FAMILY_FLOW_PART, &k));) {
		const struct ts_flow_part *flow_part = part->state;

		if (flow_part->rehearse)
			flow_part->rehearse(part, &p->fluid, dt);
	}
	return TS_OK;
}

/* Slabs and solver are those of the ranks of sim->world. */
static enum ts_status use_ranks(struct ts_projection *p, struct tsim *sim)
{
	TS_TRY(ts_slabs_make(&p->slabs, sim->world, p->fluid.grid.n[2]));
	return ts_pressure_style_of(p->pressure)->prepare(p->pressure, sim, &p->poisson);
}

/* The rank is that of sim->world. */
static enum ts_status rehearse_step(struct ts_instance *self, struct tsim *sim, int iterations)
{
	struct ts_projection *p = self->state;
	const double length = (double)p->every * sim->clock.dt;
	enum ts_status status = TS_OK;

	ts_slab_step_begin(p, sim);
	for (int64_t k = 0; k < p->done && status == TS_OK; k++)
		status = rehearse_substep(p, sim, length / (double)p->done, iterations);
	ts_slab_step_end(p);
	return status;
}

struct rehearsal {
	int ranks, iterations;
	struct ts_world_counts *sent; /* [ranks] */
	int planes;
};
typedef enum ts_status rehearsal_fn(struct ts_instance *self, struct tsim *sim, struct rehearsal *of);

/* All ranks in turn, with one solver. */
static enum ts_status rehearse_steps(struct ts_instance *self, struct tsim *sim, struct rehearsal *of)
{
	struct ts_world *world = sim->world;

	TS_TRY(use_ranks(self->state, sim));
	for (world->rank = 0; world->rank < world->n; world->rank++) {
		world->counts = of->sent[world->rank];
		TS_TRY(rehearse_step(self, sim, of->iterations));
		of->sent[world->rank] = world->counts;
	}
	return TS_OK;
}

static enum ts_status count_planes(struct ts_instance *self, struct tsim *sim, struct rehearsal *of)
{
	const struct ts_projection *p = self->state;
	const int n = p->fluid.grid.n[2], all = n + 2 * TS_GRID_GHOSTS;

	TS_TRY(use_ranks(self->state, sim));
	ts_slab_step_begin(self->state, sim);
	of->planes = all;
	if (!ts_fluid_divided(&p->fluid))
		return TS_OK;
	/* of a rank at the end of a periodic grid, which has images of the other end */
	of->planes = (n + of->ranks - 1) / of->ranks + (p->fluid.grid.periodic[2] ? 4 : 2) * TS_GRID_GHOSTS;
	of->planes = of->planes < all ? of->planes : all;
	return TS_OK;
}

/* Calls the function with a world of so many ranks, which send nothing. */
static enum ts_status with_ranks(struct ts_instance *self, struct tsim *sim, rehearsal_fn *rehearse,
				 struct rehearsal *of)
{
	struct ts_projection *p = self->state;
	const struct ts_fluid_planes planes = p->fluid.planes;
	struct ts_world *real = sim->world, world;
	enum ts_status status;

	ts_rehearsal_make(&world, 0, of->ranks);
	sim->world = &world;
	p->fluid.planes.ranges = 0;
	status = rehearse(self, sim, of);
	sim->world = real;
	ts_slabs_release(&p->slabs);
	p->fluid.planes = planes; /* no plane has been left to another rank */
	if (status == TS_OK)
		status = use_ranks(p, sim);
	ts_slab_step_end(p);
	return status == TS_NOMEM ? ts_nomem(&sim->error) : status;
}

enum ts_status ts_projection_rehearse(struct ts_instance *self, struct tsim *sim, int ranks, int iterations,
				      struct ts_world_counts *sent)
{
	struct ts_projection *p = self->state;
	struct rehearsal of = { .ranks = ranks, .iterations = iterations, .sent = sent };

	TS_TRY(ts_projection_choose_substeps(self, sim, (double)p->every * sim->clock.dt));
	return ts_slab_step_divides(p, ranks) ? with_ranks(self, sim, rehearse_steps, &of) : TS_OK;
}

enum ts_status ts_projection_rehearse_planes(struct ts_instance *self, struct tsim *sim, int ranks,
					     int *planes)
{
	struct rehearsal of = { .ranks = ranks };

	TS_TRY(with_ranks(self, sim, count_planes, &of));
	*planes = of.planes;
	return TS_OK;
}
