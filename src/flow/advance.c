/* A time step of the fluid. */
#include <math.h>

#include "flow/projection.h"

#include "base/banned.h"

static struct ts_predictor predictor(const struct ts_projection *p, double dt)
{
	const struct ts_fluid *fluid = &p->fluid;
	struct ts_predictor out = { .fluid = fluid,
				    .operators = &p->operators,
				    .convection = (enum ts_convection)p->convection,
				    .form = (enum ts_form)p->form,
				    .gamma = p->gamma,
				    .nu = fluid->viscosity / fluid->density,
				    .dt = dt,
				    .keep = 0,
				    .take = 1,
				    .threads = p->poisson.threads };

	for (int d = 0; d < 3; d++) {
		out.acceleration[d] = fluid->body_force[d];
		out.u[d] = out.old[d] = fluid->u[d];
		out.out[d] = p->work[d];
	}
	return out;
}

static void exchange_fields(double *a[3], double *b[3])
{
	for (int d = 0; d < 3; d++) {
		double *keep = a[d];

		a[d] = b[d];
		b[d] = keep;
	}
}

static enum ts_status parts_force(struct tsim *sim, struct ts_fluid *fluid, double time, double dt)
{
	struct ts_instance *part;

	for (size_t k = 0; (part = ts_sim_next_of(sim, TS_KIND_FIX, TS_FAMILY_FLOW_PART, &k));) {
		const struct ts_flow_part *flow_part = part->state;

		if (flow_part->force)
			TS_TRY(flow_part->force(part, sim, fluid, time, dt));
	}
	return TS_OK;
}

static enum ts_status parts_carry(struct tsim *sim, struct ts_fluid *fluid, double dt)
{
	struct ts_instance *part;

	for (size_t k = 0; (part = ts_sim_next_of(sim, TS_KIND_FIX, TS_FAMILY_FLOW_PART, &k));) {
		const struct ts_flow_part *flow_part = part->state;

		if (flow_part->carry)
			TS_TRY(flow_part->carry(part, sim, fluid, dt));
	}
	return TS_OK;
}

enum ts_status ts_projection_advance(struct ts_instance *self, struct tsim *sim, double dt)
{
	struct ts_projection *p = self->state;
	struct ts_fluid *fluid = &p->fluid;
	struct ts_predictor step = predictor(p, dt);

	ts_predict(&step);
	exchange_fields(fluid->u, p->work);
	ts_fluid_fill_velocity(fluid, fluid->u);
	TS_TRY(parts_force(sim, fluid, fluid->time + dt, dt));
	TS_TRY(ts_projection_project(self, sim, dt));
	fluid->dt = dt;
	fluid->time += dt;
	fluid->steps++;
	return parts_carry(sim, fluid, dt);
}
