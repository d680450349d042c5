/* Command velocity: gives particles velocities. */
#include "core/units.h"

#include <math.h>

#include "math/exactsum.h"
#include "math/rng.h"
#include "particles/domain.h"
#include "particles/particles.h"
#include "particles/region.h"

#include "base/banned.h"

enum { SET, CREATE, RAMP, ZERO };

struct state {
	int group, mode;
	struct ts_number value[3];
	bool sum;
	double temperature;
	int64_t seed;
	bool momentum;
	int component, dim; /* of ramp */
	double v[2], x[2];
	int zero, units;
};

/* Lengths of `units lattice` are lattice spacings. */
static double scale_of(const struct tsim *sim, const struct state *s, int dim)
{
	return ts_domain_scale(sim, s->units, dim);
}

static double group_sum(const struct ts_particles *p, int group, int dim)
{
	struct ts_exactsum sum = ts_exactsum_start();

	for (size_t i = 0; i < p->n; i++)
		if (ts_in_group(p, i, group))
			ts_exactsum_add(&sum, dim < 3 ? p->mass[i] * p->v[i][dim] : p->mass[i]);
	return ts_exactsum_value(&sum);
}

static void zero_momentum(struct ts_particles *p, int group)
{
	double mass = group_sum(p, group, 3);

	for (int d = 0; d < 3 && mass > 0; d++) {
		double v = group_sum(p, group, d) / mass;

		for (size_t i = 0; i < p->n; i++)
			if (ts_in_group(p, i, group))
				p->v[i][d] -= v;
	}
}

static enum ts_status set(struct tsim *sim, const struct state *s, const struct ts_place *where)
{
	struct ts_particles *p = sim->particles;
	struct ts_table table = { 0 };
	enum ts_status status = TS_OK;

	for (int d = 0; d < 3 && status == TS_OK; d++) {
		const char *variable = s->value[d].variable;
		double constant = 0, scale = scale_of(sim, s, d);
		bool each = variable && sim->host->is_peratom(sim->host_data, variable);

		if (s->value[d].null)
			continue;
		status = each ? sim->host->peratom(sim->host_data, variable, where, &table)
			      : ts_number_now(sim, &s->value[d], where, &constant);
		for (size_t i = 0; i < p->n && status == TS_OK; i++)
			if (ts_in_group(p, i, s->group))
				p->v[i][d] = (s->sum ? p->v[i][d] : 0) +
					     scale * (each ? table.data[i] : constant);
	}
	ts_table_release(&table);
	return status;
}

/* Maxwell's distribution; the numbers belong to the identities of the particles. Then the momentum
 * is taken away and the temperature, (sum m v^2) / (dof k), made exact. */
static enum ts_status create(struct tsim *sim, const struct state *s)
{
	struct ts_particles *p = sim->particles;
	struct ts_exactsum energy = ts_exactsum_start();
	double kt = ts_boltzmann(sim) * s->temperature, factor, dof;
	size_t count = 0;

	for (size_t i = 0; i < p->n; i++) {
		struct ts_rng rng = ts_rng_start((uint64_t)s->seed, (uint64_t)p->tag[i]);

		if (!ts_in_group(p, i, s->group))
			continue;
		count++;
		for (int d = 0; d < sim->dimension; d++)
			p->v[i][d] = sqrt(kt / p->mass[i]) * ts_rng_normal(&rng);
	}
	dof = (double)sim->dimension * ((double)count - (s->momentum ? 1 : 0));
	if (s->momentum)
		zero_momentum(p, s->group);
	for (size_t i = 0; i < p->n; i++)
		for (int d = 0; d < 3; d++)
			if (ts_in_group(p, i, s->group))
				ts_exactsum_add(&energy, p->mass[i] * p->v[i][d] * p->v[i][d]);
	factor = ts_exactsum_value(&energy);
	factor = factor > 0 ? sqrt(dof * kt / factor) : 0;
	for (size_t i = 0; i < p->n; i++)
		for (int d = 0; d < 3; d++)
			if (ts_in_group(p, i, s->group))
				p->v[i][d] *= factor;
	return TS_OK;
}

static enum ts_status ramp(struct tsim *sim, const struct state *s, const struct ts_place *where)
{
	struct ts_particles *p = sim->particles;
	double scale = scale_of(sim, s, s->component), along = scale_of(sim, s, s->dim);

	if (s->x[0] == s->x[1])
		return ts_fail(&sim->error, TS_RANGE, where, "velocity ramp: both ends lie at %g",
			       s->x[0]);
	for (size_t i = 0; i < p->n; i++) {
		double at = (p->x[i][s->dim] / along - s->x[0]) / (s->x[1] - s->x[0]);

		at = fmin(1, fmax(0, at));
		if (ts_in_group(p, i, s->group))
			p->v[i][s->component] = (s->sum ? p->v[i][s->component] : 0) +
						scale * (s->v[0] + at * (s->v[1] - s->v[0]));
	}
	return TS_OK;
}

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct state *s = state;
	struct ts_particles *p = sim->particles;

	switch (s->mode) {
	case SET:
		return set(sim, s, where);
	case CREATE:
		return create(sim, s);
	case RAMP:
		return ramp(sim, s, where);
	default:
		if (s->zero == 0)
			zero_momentum(p, s->group);
		for (size_t i = 0; s->zero == 1 && p->omega && i < p->n; i++)
			for (int d = 0; d < 3; d++)
				if (ts_in_group(p, i, s->group))
					p->omega[i][d] = 0;
		return TS_OK;
	}
}

#define COMPONENT(name, d)                                                                         \
	TS_NUMBER(name, struct state, value[d], .flags = TS_POSITIONAL | TS_NULLABLE,              \
		  .unit = "velocity", .help = "component, v_name, or NULL: leave it")
static const struct ts_arg set_args[] = {
	COMPONENT("vx", 0),
	COMPONENT("vy", 1),
	COMPONENT("vz", 2),
	TS_ARGS_END,
};

static const struct ts_arg create_args[] = {
	TS_REAL("temperature", struct state, temperature, .flags = TS_POSITIONAL,
		.range = TS_NOT_NEGATIVE, .unit = "temperature",
		.help = "temperature of the translation"),
	TS_INT("seed", struct state, seed, .flags = TS_POSITIONAL, .range = TS_POSITIVE,
	       .help = "seed of the random numbers"),
	TS_BOOL("mom", struct state, momentum, .fallback = "yes",
		.help = "take away the momentum of the group"),
	TS_ARGS_END,
};

static const char *const components[] = { "vx", "vy", "vz", NULL };
static const char *const dims[] = { "x", "y", "z", NULL };
static const struct ts_arg ramp_args[] = {
	TS_ENUM("component", struct state, component, components, .flags = TS_POSITIONAL,
		.help = "component that is set"),
	TS_REAL("vlo", struct state, v[0], .flags = TS_POSITIONAL, .unit = "velocity",
		.help = "its value at the low end"),
	TS_REAL("vhi", struct state, v[1], .flags = TS_POSITIONAL, .unit = "velocity",
		.help = "its value at the high end"),
	TS_ENUM("dim", struct state, dim, dims, .flags = TS_POSITIONAL,
		.help = "coordinate along which it changes"),
	TS_REAL("lo", struct state, x[0], .flags = TS_POSITIONAL, .unit = "length",
		.help = "the low end"),
	TS_REAL("hi", struct state, x[1], .flags = TS_POSITIONAL, .unit = "length",
		.help = "the high end"),
	TS_ARGS_END,
};

static const char *const zeros[] = { "linear", "angular", NULL };
static const struct ts_arg zero_args[] = {
	TS_ENUM("what", struct state, zero, zeros, .flags = TS_POSITIONAL,
		.help = "linear: the momentum of the group; angular: the spin of each particle"),
	TS_ARGS_END,
};

static const struct ts_mode modes[] = {
	[SET] = { "set", "the same velocity for all, or one from a variable", set_args },
	[CREATE] = { "create", "random velocities of a temperature", create_args },
	[RAMP] = { "ramp", "a component that changes linearly in space", ramp_args },
	[ZERO] = { "zero", "take away momentum or spin", zero_args },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_GROUP("group", struct state, group, .flags = TS_POSITIONAL,
		 .help = "particles that are changed"),
	TS_MODE("style", struct state, mode, modes, .help = "which velocities they get"),
	TS_BOOL("sum", struct state, sum, .fallback = "no",
		.help = "add to the velocities they have (set and ramp)"),
	TS_ENUM("units", struct state, units, ts_region_units, .fallback = "lattice",
		.help = "whether set and ramp count lengths in lattice spacings or as they are"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_velocity)
const struct ts_command_style ts_command_velocity = {
	.style = {
		.name = "velocity",
		.kind = TS_KIND_COMMAND,
		.summary = "Gives particles velocities",
		.doc = "create draws each component from a normal distribution of variance k T / m, keyed by\n"
		       "seed and identity, takes away the momentum and scales to the exact temperature\n"
		       "sum m v^2 / (dof k). ramp interpolates linearly between the ends and is constant beyond\n"
		       "them.",
		.example = "velocity all set 0 0 -1.5\n"
			   "velocity gas create 300 86028157\n"
			   "velocity all ramp vx 0 1 z 0 0.1\n"
			   "velocity all zero linear",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.needs_box = true,
	.run = run,
};
