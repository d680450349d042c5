/* Fix langevin: Langevin thermostat, friction and random forces. */
#include "core/report.h"

#include <math.h>
#include <string.h>

#include "base/clones.h"
#include "core/deferred_loops.h"
#include "core/units.h"
#include "math/rng.h"
#include "particle/group_moments.h"
#include "particle/type_factors.h"

#include "base/banned.h"

struct state {
	struct ts_number start;
	double stop, damp;
	int64_t seed;
	bool zero, angmom, omega;
	struct ts_words scale;
	double *factor; /* of the damping time, by atom type */
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	if (s->factor)
		return TS_OK;
	if (s->angmom || s->omega)
		return ts_fail(&sim->error, TS_RANGE, &self->where,
			       "fix langevin: rotations are not thermostatted: angmom and omega can only be "
			       "no");
	return ts_type_factors(sim, "fix langevin", &self->arena, s->scale, &s->factor);
}

/* Target temperature: linear in time from start to stop over the run. */
static enum ts_status target_temperature(struct ts_instance *self, struct tsim *sim, double *t)
{
	const struct state *s = self->state;
	const struct ts_clock *c = &sim->clock;
	double steps = (double)(c->ramp_last - c->ramp_first);

	TS_TRY(ts_number_now(sim, &s->start, &self->where, t));
	if (!s->start.variable && steps > 0)
		*t += (s->stop - *t) * (double)(c->step - c->ramp_first) / steps;
	if (*t >= 0)
		return TS_OK;
	return ts_fail(&sim->error, TS_RANGE, &self->where, "fix langevin: the temperature would be %g", *t);
}

static double damping_time(const struct state *s, const struct ts_particles *p, size_t i)
{
	return s->damp * s->factor[p->type[i]];
}

struct bath {
	const struct tsim *sim;
	const struct state *s;
	double kt, mean[3]; /* mean: of the random forces, which is subtracted */
	double dt;	    /* of the step, as the loop may be executed after its end */
	uint64_t counter;
	int group;
};

/* Random forces of this step: variance 2 k T m/(damp dt) per component, uniformly distributed (B. Duenweg, W. Paul, Int. J.
 * Mod. Phys. C 2 (1991) 817). */
TS_CLONES static void random_forces(const struct tsim *sim, size_t from, size_t n, const void *context,
				    double (*f)[TS_TERM_BLOCK])
{
	const struct bath *bath = context;
	const struct ts_particles *p = sim->particles;
	double amplitude[TS_TERM_BLOCK];

	for (size_t i = 0; i < n; i++)
		amplitude[i] = sqrt(24 * bath->kt * p->mass[from + i] /
				    (damping_time(bath->s, p, from + i) * bath->dt));
	memset(f, 0, 3 * sizeof *f);
	for (int k = 0; k < sim->dimension; k++) {
		ts_rng_uniform_of_streams((uint64_t)bath->s->seed, bath->counter + (uint64_t)k, p->tag + from,
					  n, f[k]);
		for (size_t i = 0; i < n; i++)
			f[k][i] = amplitude[i] * (f[k][i] - 0.5);
	}
}

static void add_block(const struct bath *bath, size_t from, size_t n)
{
	const struct ts_particles *p = bath->sim->particles;
	double random[3][TS_TERM_BLOCK];

	random_forces(bath->sim, from, n, bath, random);
	for (size_t k = 0; k < n; k++) {
		const size_t i = from + k;
		const double rate = p->mass[i] / damping_time(bath->s, p, i);

		for (int d = 0; d < 3 && ts_in_group(p, i, bath->group); d++)
			p->f[i][d] += random[d][k] - rate * p->v[i][d] - bath->mean[d];
	}
}

static void add_range(void *context, size_t from, size_t to)
{
	for (size_t n; from < to; from += n) {
		n = to - from < TS_TERM_BLOCK ? to - from : TS_TERM_BLOCK;
		add_block(context, from, n);
	}
}

static enum ts_status add_langevin_force(struct ts_instance *self, struct tsim *sim)
{
	const struct state *s = self->state;
	struct bath bath = { .sim = sim, .s = s, .group = self->group };
	double t, n = s->zero ? ts_group_count(sim, self->group) : 0;

	if (s->start.variable) /* it may read particles */
		ts_deferred_loops_run(sim);
	TS_TRY(target_temperature(self, sim, &t));
	bath.kt = ts_boltzmann(sim) * t;
	bath.dt = sim->clock.dt;
	bath.counter = ts_clock_counter(&sim->clock, 3);
	if (n > 0)
		ts_group_sum_blocks(sim, self->group, 3, random_forces, &bath, bath.mean);
	for (int k = 0; k < 3 && n > 0; k++)
		bath.mean[k] /= n;
	TS_DEFER_LOOP(sim, sim->particles->n, add_range, &bath);
	return TS_OK;
}

static void add_ground(const struct ts_instance *self, const struct tsim *sim, size_t i,
		       struct ts_ground_springs *sum)
{
	for (int d = 0; d < 3; d++)
		sum->rate[d] += 1 / damping_time(self->state, sim->particles, i);
}

static const struct ts_arg args[] = {
	TS_NUMBER("Tstart", struct state, start, .flags = TS_POSITIONAL, .unit = "temperature",
		  .help = "temperature at the start of the run; v_NAME: a variable, evaluated in each step"),
	TS_REAL("Tstop", struct state, stop, .flags = TS_POSITIONAL, .range = TS_NOT_NEGATIVE,
		.unit = "temperature", .help = "temperature at the end of the run"),
	TS_REAL("damp", struct state, damp, .flags = TS_POSITIONAL, .range = TS_POSITIVE, .unit = "time",
		.help = "damping time: relaxation time of velocities"),
	TS_INT("seed", struct state, seed, .flags = TS_POSITIONAL, .range = TS_POSITIVE,
	       .help = "seed of the random number generator"),
	TS_BOOL("zero", struct state, zero, .fallback = "no",
		.help = "subtract the mean random force, so that the total random force on the group is "
			"zero"),
	TS_TYPE_FACTORS(struct state, scale, "the time"),
	TS_BOOL("angmom", struct state, angmom, .fallback = "no",
		.help = "only no, as is the default of LAMMPS"),
	TS_BOOL("omega", struct state, omega, .fallback = "no",
		.help = "only no, as is the default of LAMMPS"),
	TS_ARGS_END,
};

TS_STYLE(fix, ts_style, ts_fix_langevin)
const struct ts_style ts_fix_langevin = {
	.name = "langevin",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_OWN,
	.summary = "Langevin thermostat: friction and random forces",
	.doc = "Adds to each particle of the group a friction force and a random force,\n\n"
	       "  f = -m v/damp + sqrt(24 k T m/(damp dt)) u\n\n"
	       "with Boltzmann's constant k, the time step dt and u uniformly distributed in (-1/2, 1/2) in "
	       "each component, so that the translational degrees of freedom approach the temperature T. T "
	       "changes linearly from Tstart to Tstop over each run (see `run N start S stop E`). The random "
	       "numbers are functions of seed, time step and particle ID only, so results do not depend on "
	       "the number of threads.\n\n"
	       "This fix does not integrate the motion: use it with fix nve. The time step must be less than "
	       "2 damp.",
	.example = "fix bath all langevin 300 300 0.1 86028157",
	.args = args,
	.state_size = sizeof(struct state),
	.init = init,
	.hook[TS_STAGE_POST_FORCE] = add_langevin_force,
	.defers = TS_DEFERS(POST_FORCE),
	.ground = add_ground,
};
