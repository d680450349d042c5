/* A time step of the fluid: substeps, their stages, and the fixes that take part. */
#include <math.h>
#include <string.h>

#include "flow/boundary.h"
#include "flow/flow_limits.h"
#include "flow/fluid_slabs.h"
#include "flow/implicit_viscosity.h"
#include "flow/particle_sources.h"
#include "flow/pressure_projection.h"
#include "flow/slab_step.h"
#include "flow/step_diagnostics.h"
#include "flow/void_fraction.h"

#include "base/banned.h"

static struct ts_predictor make_predictor(const struct ts_projection *p, double dt)
{
	const struct ts_fluid *fluid = &p->fluid;
	struct ts_predictor out = { .fluid = fluid,
				    .operators = &p->operators,
				    .convection = (enum ts_convection)p->convection,
				    .form = (enum ts_flow_form)p->form,
				    .gamma = p->convection == TS_CONVECTION_DONOR ? p->gamma : 0,
				    .nu = p->viscous == TS_VISCOUS_EXPLICIT
						  ? fluid->viscosity / fluid->density
						  : 0,
				    .dt = dt,
				    .threads = p->poisson.threads,
				    .slabs = &p->slabs };

	for (int d = 0; d < 3; d++)
		out.acceleration[d] = fluid->body_force[d];
	return out;
}

/* A body force that varies acts as its mean over a substep, which keeps the second order. */
static void interpolate_force(struct ts_projection *p, double fraction)
{
	for (int d = 0; d < 3; d++)
		p->fluid.body_force[d] =
			ts_flow_interpolate_time(p->force_before[d], p->force_now[d], fraction);
}

static void swap_fields(double *a[3], double *b[3])
{
	for (int d = 0; d < 3; d++) {
		double *keep = a[d];

		a[d] = b[d];
		b[d] = keep;
	}
}

/* ---- fixes that take part */

bool ts_projection_parts_have_forces(const struct tsim *sim)
{
	const struct ts_instance *part;

	for (size_t k = 0; (part = ts_sim_next_of(sim, TS_KIND_FIX, TS_FAMILY_FLOW_PART, &k));)
		if (((const struct ts_flow_part *)part->state)->force)
			return true;
	return false;
}

static enum ts_status apply_part_forces(struct ts_projection *p, struct tsim *sim, double time, double dt)
{
	struct ts_fluid *fluid = &p->fluid;
	struct ts_instance *part;
	bool some = false, fill = false;

	for (size_t k = 0; (part = ts_sim_next_of(sim, TS_KIND_FIX, TS_FAMILY_FLOW_PART, &k));) {
		const struct ts_flow_part *flow_part = part->state;

		if (!flow_part->force)
			continue;
		TS_TRY(flow_part->force(part, sim, fluid, time, dt));
		some = true;
		fill |= !flow_part->keeps_ghosts;
	}
	if (some && ts_fluid_divided(fluid))
		ts_slab_step_predicted(p, false);
	if (fill)
		ts_fluid_fill_velocity(fluid, fluid->u);
	return TS_OK;
}

static enum ts_status call_after_substep(struct tsim *sim, struct ts_fluid *fluid, double dt)
{
	struct ts_instance *part;

	for (size_t k = 0; (part = ts_sim_next_of(sim, TS_KIND_FIX, TS_FAMILY_FLOW_PART, &k));) {
		const struct ts_flow_part *flow_part = part->state;

		if (flow_part->after_substep)
			TS_TRY(flow_part->after_substep(part, sim, fluid, dt));
	}
	return TS_OK;
}

static enum ts_status call_after_step(struct tsim *sim, struct ts_fluid *fluid, double length)
{
	struct ts_instance *part;

	for (size_t k = 0; (part = ts_sim_next_of(sim, TS_KIND_FIX, TS_FAMILY_FLOW_PART, &k));) {
		const struct ts_flow_part *flow_part = part->state;

		if (flow_part->after_step)
			TS_TRY(flow_part->after_step(part, sim, fluid, length));
	}
	return TS_OK;
}

/* Smallest of the limits of the time step by these fixes. */
static double limit_of_parts(const struct tsim *sim, const struct ts_fluid *fluid)
{
	const struct ts_instance *part;
	double least = INFINITY;

	for (size_t k = 0; (part = ts_sim_next_of(sim, TS_KIND_FIX, TS_FAMILY_FLOW_PART, &k));) {
		const struct ts_flow_part *flow_part = part->state;

		if (flow_part->limit)
			least = fmin(least, flow_part->limit(part, fluid));
	}
	return least;
}

/* ---- Adams-Bashforth */

/* Change of the body force since the step before. */
static double change_of_force(const struct ts_projection *p, int d)
{
	double change = p->fluid.body_force[d] - p->history_force[d];

	return isnan(change) ? 0 : change;
}

struct extrapolation {
	struct ts_projection *projection;
	double *const *out; /* [component] */
	double dt;
};

static void extrapolate_row(void *context, int c, int j, int k, int from, int to)
{
	const struct extrapolation *task = context;
	struct ts_projection *p = task->projection;
	const size_t at = ts_at(&p->fluid.grid, 0, j, k);
	const double dt = task->dt, more = p->history_dt > 0 ? 0.5 * dt / p->history_dt : 0;
	const double change = change_of_force(p, c), *u = p->fluid.u[c] + at;
	double *after = task->out[c] + at, *rate = p->history[c] + at;

	for (int i = from; i < to; i++) {
		double now = (after[i] - u[i]) / dt;

		after[i] += dt * more * (now - rate[i] - change);
		rate[i] = now;
	}
}

/* Changes the Euler step u + dt F to u + dt (F + (F - F_old) dt/(2 dt_old)), where it has been made; stores F. The body force
 * is a mean over the step already and is not extrapolated. */
static void add_adams_bashforth(struct ts_projection *p, double *const out[3], double dt)
{
	struct extrapolation task = { p, out, dt };

	ts_flow_visit_rows(&p->fluid, &p->slabs, p->poisson.threads, extrapolate_row, &task);
	memcpy(p->history_force, p->fluid.body_force, sizeof p->history_force);
	p->history_dt = dt;
	p->history_apart = p->slabs.active;
}

/* ---- a step */

static enum ts_status allocate_vector(const struct ts_grid *grid, double *field[3])
{
	/* Three components in two dimensions, too: the third is 0, and these fields are swapped with the
	 * velocities. */
	for (int d = 0; d < 3; d++)
		if (!field[d] && !(field[d] = ts_grid_field(grid)))
			return TS_NOMEM;
	return TS_OK;
}

/* Allocates the fields that only some schemes need. */
static enum ts_status allocate_scheme_fields(struct ts_projection *p,
					     const struct ts_flow_time_scheme *scheme)
{
	if (p->viscous != TS_VISCOUS_EXPLICIT && !p->increment &&
	    !(p->increment = ts_grid_field(&p->fluid.grid)))
		return TS_NOMEM;
	if (scheme->stages > 1)
		TS_TRY(allocate_vector(&p->fluid.grid, p->second_stage));
	return scheme->history ? allocate_vector(&p->fluid.grid, p->history) : TS_OK;
}

/* Implicit viscosity: p->work holds the predictor without viscosity on entry, u* on return. */
static enum ts_status implicit_step(struct ts_projection *p, double dt)
{
	struct ts_fluid *fluid = &p->fluid;
	const struct ts_viscous_step step = { .fluid = fluid,
					      .operators = &p->operators,
					      .nu = fluid->viscosity / fluid->density,
					      .dt = dt,
					      .theta = p->theta,
					      .threads = p->poisson.threads,
					      .slabs = &p->slabs };

	/* Velocities of walls are those of the time at which the viscous term is evaluated. */
	ts_projection_interpolate_boundary(p, ((double)p->now_at + p->theta) / (double)p->done);
	ts_fluid_fill_velocity(fluid, fluid->u);
	return ts_viscous_step(&step, p->work);
}

/* Computes stage s; `old`: velocities at the beginning of the substep. Those of the last stage are in
 * p->work afterwards. */
static enum ts_status make_stage(struct ts_instance *self, struct tsim *sim,
				 const struct ts_flow_time_scheme *scheme, int s, double *const old[3],
				 double dt, double carry)
{
	struct ts_projection *p = self->state;
	struct ts_fluid *fluid = &p->fluid;
	struct ts_predictor stage = make_predictor(p, dt);
	double length = scheme->take[s] * dt;

	stage.keep = scheme->keep[s];
	stage.take = scheme->take[s];
	for (int d = 0; d < 3; d++) {
		stage.u[d] = fluid->u[d];
		stage.old[d] = old[d];
		stage.out[d] = p->work[d];
	}
	if (ts_projection_conservative(p))
		ts_projection_stage_void_fraction(p, &stage, s);
	ts_flow_predict(&stage);
	if (scheme->history)
		add_adams_bashforth(p, p->work, dt);
	if (p->viscous != TS_VISCOUS_EXPLICIT)
		TS_TRY(implicit_step(p, dt) == TS_OK ? TS_OK : ts_nomem(&sim->error));
	swap_fields(fluid->u, p->work);
	ts_projection_apply_particle_forces(p, length);
	ts_projection_interpolate_boundary(p, ((double)p->now_at + scheme->at[s]) / (double)p->done);
	ts_slab_step_predicted(p, ts_projection_parts_have_forces(sim));
	ts_fluid_fill_velocity(fluid, fluid->u);
	TS_TRY(apply_part_forces(p, sim, fluid->time + scheme->at[s] * dt, length));
	p->pressure_time = ((double)p->now_at + scheme->pressure_at[s]) / (double)p->done;
	TS_TRY(ts_projection_project_velocity(self, sim, length, length));
	ts_projection_average_exchange(p, s == 0 ? carry : 1, scheme->take[s]);
	return TS_OK;
}

enum ts_status ts_projection_substep(struct ts_instance *self, struct tsim *sim, double dt, double carry)
{
	struct ts_projection *p = self->state;
	struct ts_fluid *fluid = &p->fluid;
	const struct ts_flow_time_scheme *scheme = &ts_flow_time_schemes[p->time];
	double *old[3] = { fluid->u[0], fluid->u[1], fluid->u[2] };

	if (allocate_scheme_fields(p, scheme) != TS_OK)
		return ts_nomem(&sim->error);
	for (int s = 0; s < scheme->stages; s++) {
		TS_TRY(make_stage(self, sim, scheme, s, old, dt, carry));
		if (s < scheme->stages - 1 && p->work[0] == old[0]) /* `old` is needed until the last stage */
			swap_fields(p->work, p->second_stage);
	}
	fluid->dt = dt;
	fluid->time += dt;
	fluid->steps++;
	TS_TRY(ts_projection_check_substep(self, sim, old, dt));
	return call_after_substep(sim, fluid, dt);
}

/* What limits the stable step of the fluid most. */
static const char *what_limits(const struct ts_projection *p, double parts)
{
	const struct ts_flow_limits limits = ts_flow_limits(p);

	if (parts < fmin(limits.viscous, fmin(limits.courant, limits.growth)))
		return "by a fix that acts on the fluid";
	if (limits.growth < fmin(limits.viscous, limits.courant))
		return "by its time scheme, which does not damp convection without viscosity: use time rk3";
	return limits.viscous < limits.courant
		       ? "by its viscosity: use a smaller `timestep` or viscous implicit"
		       : "by its velocity: use a smaller `timestep`";
}

enum ts_status ts_projection_choose_substeps(struct ts_instance *self, struct tsim *sim, double length)
{
	static const double MOST = 1e6;
	struct ts_projection *p = self->state;
	double limit, parts;

	p->done = p->substeps;
	if (p->substeps)
		return TS_OK;
	parts = limit_of_parts(sim, &p->fluid);
	limit = p->courant * fmin(ts_flow_limit(p), parts);
	if (!(length <= MOST * limit))
		return ts_fail(&sim->error, TS_PHYSICS, &self->where,
			       "the fluid's stable step is %g, less than a millionth of the %g it is to "
			       "make, limited %s",
			       limit / p->courant, length, what_limits(p, parts));
	p->done = length > limit ? (int64_t)ceil(length / limit) : 1;
	return TS_OK;
}

/* In a step of several stages the weight of u in exchange_velocity is multiplied by `take` of all later
 * stages; the sum of the earlier substeps is multiplied by the inverse of all of them, so that substeps
 * have equal weights. */
static double initial_mean_weight(const struct ts_flow_time_scheme *scheme)
{
	double product = 1;

	for (int s = 0; s < scheme->stages; s++)
		product *= scheme->take[s];
	return 1 / product;
}

static void divide_exchange_means(struct ts_projection *p, double by)
{
	for (int d = 0; d < 3 && by > 1 && p->fluid.exchange_velocity[d]; d++)
		ts_fluid_divide_field(&p->fluid, p->fluid.exchange_velocity[d], by);
	if (by > 1 && p->fluid.p_mean)
		ts_fluid_divide_field(&p->fluid, p->fluid.p_mean, by);
}

enum ts_status ts_projection_step(struct ts_instance *self, struct tsim *sim, double length)
{
	struct ts_projection *p = self->state;
	double carry = 0;

	if (p->check_closed)
		TS_TRY(p->check_closed(sim));
	p->source_scale = p->source_steps > 0 ? 1 / (double)p->source_steps : 0;
	if (ts_projection_update_void_fraction(p, length) != TS_OK)
		return ts_nomem(&sim->error);
	if (!p->ghosts_filled) {
		ts_projection_interpolate_boundary(p, 0);
		ts_fluid_fill_velocity(&p->fluid, p->fluid.u);
	}
	p->ghosts_filled = true;
	TS_TRY(ts_projection_choose_substeps(self, sim, length));
	for (int64_t k = 0; k < p->done; k++) {
		p->now_at = k;
		interpolate_force(p, ((double)k + 0.5) / (double)p->done);
		TS_TRY(ts_projection_substep(self, sim, length / (double)p->done, carry));
		carry = initial_mean_weight(&ts_flow_time_schemes[p->time]);
	}
	interpolate_force(p, 0.5); /* for the forces on bodies, which are means over the step */
	divide_exchange_means(p, (double)p->done);
	if (ts_slab_step_spread(p, sim) != TS_OK)
		return ts_nomem(&sim->error);
	TS_TRY(call_after_step(sim, &p->fluid, length));
	if (ts_projection_store_boundary(p) != TS_OK)
		return ts_nomem(&sim->error);
	ts_projection_clear_sources(p);
	return TS_OK;
}
