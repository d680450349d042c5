/* Time integration of temperatures over one step, with constant contacts:
 *
 *   m c dT_i/dt = sum_j h_ij (T_j - T_i) + sum_w h_iw (T_w - T_i) + S_i
 *
 * for the particles of the group; the others keep their temperature.
 *
 * euler: T += dt r, r the right-hand side over m c. First order; stable and without oscillations for dt
 * below the smallest m c/sum h (see law/conduction.h).
 *
 * exact: the system is linear, dT/dt = A T + b, so r = A T + b obeys dr/dt = A r, and T(t + s) = T + s
 * sum_k (sA)^k r/(k + 1)!. The step is divided into parts s with ||A|| s <= 1, for which a fixed number
 * of terms is exact to double precision. No stability limit. The integral of T - T(t) over s, for the heat that
 * walls have received, is s^2 sum_k (sA)^k r/(k + 2)!. */
#include "heat/heat.h"

#include <inttypes.h>
#include <math.h>
#include <string.h>

#include "base/parallel.h"
#include "core/deferred_loops.h"
#include "core/ranks.h"
#include "core/report.h"
#include "particle/exchange.h"

#include "base/banned.h"

static double heat_capacity(const struct ts_heat *h, const struct ts_particles *p, size_t i)
{
	return p->mass[i] * h->capacity[p->type[i]];
}

/* Smallest m c/sum h of the group, time; infinite without contacts. */
static double stability_limit(const struct ts_instance *self, const struct tsim *sim)
{
	const struct ts_heat *h = self->state;
	const struct ts_particles *p = sim->particles;
	double smallest = INFINITY;

	for (size_t i = 0; i < p->n; i++) {
		double sum;

		if (!ts_in_group(p, i, self->group))
			continue;
		sum = ts_heat_sum_conductances(h, sim, i);
		if (sum > 0)
			smallest = fmin(smallest, heat_capacity(h, p, i) / sum);
	}
	return smallest;
}

/* Of the particles of all ranks. */
static double stability_limit_of_all(const struct ts_instance *self, const struct tsim *sim)
{
	return -ts_ranks_most(sim, -stability_limit(self, sim));
}

enum ts_status ts_heat_plan(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report)
{
	struct ts_heat *h = self->state;
	double limit;

	if (report->limits_only) /* during a run see check_time_step below */
		return TS_OK;
	ts_heat_find_conductances(self, sim);
	if (h->scheme == TS_HEAT_EXACT)
		return TS_OK;
	limit = stability_limit(self, sim);
	h->warned = !(sim->clock.dt < limit);
	return isfinite(limit) ? ts_report_limit(report, limit, false, &self->where,
						 "explicit heat conduction, m c / sum h")
			       : TS_OK;
}

/* ---- explicit Euler ---- */

struct task {
	const struct ts_instance *self;
	struct ts_heat *h;
	struct ts_particles *p;
	double dt;
};

static void euler_range(void *context, size_t from, size_t to)
{
	const struct task t = *(const struct task *)context;
	const struct ts_particles *p = t.p;
	double *temperature = p->column[t.h->temperature].data, bound = t.h->bound;
	const double *flux = p->column[t.h->flux].data, *source = p->column[t.h->source].data;
	long beyond = 0;

	for (size_t i = from; i < to; i++) {
		if (!ts_in_group(p, i, t.self->group))
			continue;
		temperature[i] += (flux[i] + source[i]) * t.dt / heat_capacity(t.h, p, i);
		beyond += !(fabs(temperature[i]) <= bound);
	}
	if (beyond) {
#pragma omp atomic
		t.h->beyond += beyond;
	}
}

static size_t hottest_particle(const struct ts_instance *self, const struct tsim *sim)
{
	const struct ts_heat *h = self->state;
	const double *temperature = ts_heat_column(sim, h->temperature);
	size_t hottest = 0;

	for (size_t i = 0; i < sim->particles->n && isfinite(temperature[hottest]); i++)
		if (ts_in_group(sim->particles, i, self->group) &&
		    !(fabs(temperature[i]) <= fabs(temperature[hottest])))
			hottest = i;
	return hottest;
}

/* Large temperatures are an error only if the time step exceeds the limit, or if they are not finite. */
enum ts_status ts_heat_check_divergence(struct ts_instance *self, struct tsim *sim)
{
	struct ts_heat *h = self->state;
	double limit, temperature;
	size_t i;

	if (!h->beyond || !sim->particles->n)
		return TS_OK;
	h->beyond = 0;
	ts_heat_find_conductances(self, sim);
	limit = stability_limit(self, sim);
	i = hottest_particle(self, sim);
	temperature = ts_heat_column(sim, h->temperature)[i];
	h->bound = 1e6 * fabs(temperature);
	if (isfinite(temperature) && sim->clock.dt < limit)
		return TS_OK;
	return ts_fail(&sim->error, TS_PHYSICS, &self->where,
		       "fix %s: particle %d has reached the temperature %g at step %" PRId64 "; %s",
		       self->style->name, sim->particles->tag[i], temperature, h->advanced,
		       sim->clock.dt < limit
			       ? "a source, a wall or a value that was set is not finite"
			       : "the time step exceeds the stability limit of explicit heat conduction: use "
				 "a smaller one, a smaller thermalConductivity or `scheme exact`");
}

static void check_time_step(struct ts_instance *self, struct tsim *sim)
{
	struct ts_heat *h = self->state;
	double limit;

	h->examine = false;
	if (h->warned)
		return;
	ts_heat_find_conductances(self, sim);
	limit = stability_limit_of_all(self, sim);
	h->warned = !(sim->clock.dt < limit);
	if (h->warned && ts_ranks_first(sim))
		ts_warn(&sim->log, &self->where,
			"fix %s: at step %" PRId64 " the time step %g is larger than %g, the limit of "
			"explicit heat conduction (m c / sum h)",
			self->style->name, sim->clock.step, sim->clock.dt, limit);
}

/* Temperatures are checked when they are available: before the next step, or at once if this step may
 * be the last. */
static enum ts_status advance_euler(struct ts_instance *self, struct tsim *sim)
{
	struct ts_heat *h = self->state;
	struct task task = { self, h, sim->particles, sim->clock.dt };

	if (h->examine)
		check_time_step(self, sim);
	h->advanced = sim->clock.step;
	TS_DEFER_LOOP(sim, sim->particles->n, euler_range, &task);
	if (!sim->run.complete)
		return TS_OK;
	ts_deferred_loops_run(sim);
	return ts_heat_check_divergence(self, sim);
}

/* ---- exact over the step ---- */

/* r = (flux + source)/(m c), temperature/time; 0 outside the group. */
static void compute_rates(const struct ts_instance *self, struct tsim *sim)
{
	const struct ts_heat *h = self->state;
	const struct ts_particles *p = sim->particles;
	const double *flux = ts_heat_column(sim, h->flux);
	const double *source = ts_heat_column(sim, h->source);
	double *rate = ts_heat_column(sim, h->rate);

	for (size_t i = 0; i < p->n; i++)
		rate[i] = ts_in_group(p, i, self->group) ? (flux[i] + source[i]) / heat_capacity(h, p, i) : 0;
}

struct stage {
	struct task task;
	const double *before; /* (sA)^k r/k!, ghosts included */
	double *after;	      /* the next term */
	double factor;	      /* s/(k + 1) */
};

static void compute_next_term(void *context, size_t from, size_t to)
{
	const struct stage s = *(const struct stage *)context;
	const struct ts_heat *h = s.task.h;
	const struct ts_particles *p = s.task.p;
	const double *wall = p->column[h->wall_conductance].data;

	for (size_t i = from; i < to; i++)
		s.after[i] =
			ts_in_group(p, i, s.task.self->group)
				? s.factor *
					  (ts_heat_sum_differences(h, i, s.before) - wall[i] * s.before[i]) /
					  heat_capacity(h, p, i)
				: 0;
}

/* The terms 0 .. LAST_TERM of the exponential series of x <= 1 leave a remainder below 1/(LAST_TERM +
 * 2)! < 2^-62. */
enum { LAST_TERM = 18 };

/* Advances T and r by the time s; adds the integral of T - T(start of the step) to mean_rise. */
static void advance_part(const struct task *task, struct tsim *sim, double s)
{
	const struct ts_heat *h = task->h;
	size_t n = sim->particles->n;
	double *temperature = ts_heat_column(sim, h->temperature);
	double *term = ts_heat_column(sim, h->rate), *sum = h->work, *after = h->work + n,
	       *rise = h->work + 2 * n;

	if (n)
		memcpy(sum, term, n * sizeof *sum);
	for (size_t i = 0; i < n; i++)
		h->mean_rise[i] += rise[i] * s;
	for (int k = 0; k <= LAST_TERM; k++) {
		struct stage stage = { *task, term, after, s / (k + 1) };

		for (size_t i = 0; i < n; i++) {
			double change = term[i] * s / (k + 1);

			temperature[i] += change;
			rise[i] += change;
			h->mean_rise[i] += change * s / (k + 2);
		}
		ts_exchange_forward(sim); /* the terms of the ghosts */
		ts_parallel(ts_team(sim, n), n, compute_next_term, &stage);
		for (size_t i = 0; i < n; i++)
			sum[i] += term[i] = after[i];
	}
	if (n)
		memcpy(term, sum, n * sizeof *term);
}

static enum ts_status advance_exact(struct ts_instance *self, struct tsim *sim)
{
	struct ts_heat *h = self->state;
	struct task task = { self, h, sim->particles, sim->clock.dt };
	/* ||A|| <= 2 / limit */
	double parts = ceil(2 * sim->clock.dt / stability_limit_of_all(self, sim)), s;
	size_t n = sim->particles->n;

	if (!(parts <= 1e6))
		return ts_fail(&sim->error, TS_PHYSICS, &self->where,
			       "fix %s: the time step %g is more than 500000 times the time constant of heat "
			       "conduction between particles",
			       self->style->name, sim->clock.dt);
	parts = fmax(parts, 1);
	s = sim->clock.dt / parts;
	if (TS_GROW(h->work, h->work_capacity, 3 * n) != TS_OK ||
	    TS_GROW(h->mean_rise, h->mean_rise_capacity, n) != TS_OK)
		return ts_nomem(&sim->error);
	ts_deferred_loops_run(sim);
	compute_rates(self, sim);
	for (size_t i = 0; i < n; i++)
		h->mean_rise[i] = h->work[2 * n + i] = 0;
	for (int64_t k = 0; k < (int64_t)parts; k++)
		advance_part(&task, sim, s);
	for (size_t i = 0; i < n; i++)
		h->mean_rise[i] /= sim->clock.dt;
	return TS_OK;
}

/* ---- stages ---- */

/* The temperatures at the start of a run set the bound beyond which stability is checked. */
enum ts_status ts_heat_set_bound(struct ts_instance *self, struct tsim *sim)
{
	struct ts_heat *h = self->state;

	h->bound = 1;
	for (size_t i = 0; i < sim->particles->n; i++)
		h->bound = fmax(h->bound, 1e6 * fabs(ts_heat_column(sim, h->temperature)[i]));
	return TS_OK;
}

enum ts_status ts_heat_advance(struct ts_instance *self, struct tsim *sim)
{
	return ((const struct ts_heat *)self->state)->scheme == TS_HEAT_EXACT ? advance_exact(self, sim)
									      : advance_euler(self, sim);
}
