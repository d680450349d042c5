/* Command velocity: sets velocities of particles. */
#include "base/axes.h"
#include "core/sim.h"

#include <math.h>

#include "box/domain.h"
#include "core/ranks_pause.h"
#include "group/group_motion.h"
#include "group/temperature.h"
#include "math/ramp.h"
#include "math/rng.h"
#include "math/vec3.h"
#include "particle/columns.h"
#include "particle/group_moments.h"
#include "particle/particles.h"
#include "region/region.h"
#include "rigid/rigid_change.h"
#include "rigid/rigid_follow.h"

#include "base/banned.h"

enum { SET, CREATE, SCALE, RAMP, ZERO };
enum { LINEAR, ANGULAR, EACH };

struct state {
	int group, mode;
	struct ts_number value[3];
	bool sum;
	double temperature;
	int64_t seed;
	bool momentum, rotation;
	int gaussian, loop;
	int component, dim; /* of ramp */
	double v[2], x[2];  /* of ramp: values and coordinates of both ends */
	int zero, units;
	const char *temp; /* ID of the compute for the temperature; NULL: that of the group */
	bool bias;
};

/* Length of one unit in this dimension: 1, or the lattice spacing with `units lattice`. */
static double unit_length(const struct tsim *sim, const struct state *s, int dim)
{
	return ts_domain_scale(sim, s->units, dim);
}

/* Clumps that are in the group as a whole get the change at once, so that it is that of their centres of mass. */
static enum ts_status zero_momentum(struct tsim *sim, int group)
{
	struct ts_particles *p = sim->particles;
	struct ts_rigid_motion mean = { 0 };

	TS_TRY(ts_rigid_take_clump_velocities(sim, group));
	ts_group_velocity(sim, group, mean.v);
	for (size_t i = 0; i < p->n; i++)
		for (int d = 0; ts_in_group(p, i, group) && d < 3; d++)
			p->v[i][d] -= mean.v[d];
	return ts_rigid_subtract_motion(sim, group, true, &mean);
}

/* Subtracts the rigid rotation with the angular momentum of the group, to which the rotation of clumps belongs. */
static enum ts_status zero_rotation(struct tsim *sim, int group)
{
	struct ts_particles *p = sim->particles;
	struct ts_rigid_motion mean = { 0 };

	TS_TRY(ts_rigid_take_clump_velocities(sim, group));
	ts_group_spin(sim, group, mean.centre, mean.omega);
	for (size_t i = 0; i < p->n; i++) {
		double arm[3], turn[3];

		if (!ts_in_group(p, i, group))
			continue;
		ts_unwrapped(sim, i, arm);
		ts_sub(arm, mean.centre, arm);
		ts_cross(mean.omega, arm, turn);
		ts_sub(p->v[i], turn, p->v[i]);
	}
	return ts_rigid_subtract_motion(sim, group, true, &mean);
}

static double group_temperature(const struct tsim *sim, int group, double *count)
{
	double tensor[7];

	ts_temperature_tensor(sim, group, NULL, tensor);
	*count = tensor[6];
	if (tensor[6] == 1) /* a single particle has all D degrees of freedom: D (N - 1) with N = 2 */
		tensor[6] = 2;
	return ts_temperature(sim, tensor, NULL);
}

static enum ts_status find_temperature_compute(struct tsim *sim, const struct state *s,
					       const struct ts_place *where, struct ts_instance **out)
{
	const struct ts_word id = { .text = s->temp, .place = *ts_sim_word_of(sim, s->temp, where) };
	const struct ts_value *value;

	TS_TRY(ts_sim_require(sim, TS_KIND_COMPUTE, &id, out));
	value = ts_value_find(*out, TS_SCALAR);
	if (!value || !ts_streq(value->unit, "temperature"))
		return ts_fail(&sim->error, TS_RANGE, &id.place, "velocity: compute %s gives no temperature",
			       s->temp);
	if (s->bias && !ts_streq((*out)->style->name, "temp/com"))
		return ts_fail(&sim->error, TS_RANGE, &id.place,
			       "velocity: bias yes needs a temperature of what is left of the velocities "
			       "without a part of them: compute temp/com; %s leaves out nothing",
			       (*out)->style->name);
	return TS_OK;
}

static enum ts_status measure_temperature(struct tsim *sim, const struct state *s,
					  const struct ts_place *where, double *now)
{
	struct ts_instance *inst;

	TS_TRY(find_temperature_compute(sim, s, where, &inst));
	TS_TRY(ts_value_cached(inst, sim, ts_value_find(inst, TS_SCALAR)));
	*now = inst->table.data[0];
	return TS_OK;
}

/* Adds sign * mean, the velocity of the centre of mass that temp/com excludes, to the group of the
 * compute. */
static void add_mean_velocity(struct tsim *sim, const struct state *s, const double mean[3], double sign)
{
	struct ts_particles *p = sim->particles;
	int group = ts_sim_find(sim, TS_KIND_COMPUTE, s->temp)->group;

	for (size_t i = 0; i < p->n; i++)
		if (ts_in_group(p, i, group))
			ts_axpy(sign, mean, p->v[i]);
}

/* Scales velocities to the temperature. `alone`: the present temperature is that of the group, even if `temp`
 * names a compute. */
static enum ts_status rescale_to_temperature(struct tsim *sim, const struct state *s, bool alone,
					     const struct ts_place *where)
{
	struct ts_particles *p = sim->particles;
	double count, now = group_temperature(sim, s->group, &count), factor;

	if (count == 0)
		return TS_OK;
	if (s->temp && !alone)
		TS_TRY(measure_temperature(sim, s, where, &now));
	if (!(now > 0) && s->temperature > 0)
		return ts_fail(&sim->error, TS_STATE, where,
			       "velocity: the group is at rest, so no factor gives it a temperature");
	factor = now > 0 ? sqrt(s->temperature / now) : 0;
	for (size_t i = 0; i < p->n; i++)
		for (int d = 0; ts_in_group(p, i, s->group) && d < 3; d++)
			p->v[i][d] *= factor;
	return TS_OK;
}

static enum ts_status scale_velocities(struct tsim *sim, const struct state *s, const struct ts_place *where)
{
	struct ts_instance *inst;
	double mean[3];
	enum ts_status status;

	if (!s->bias)
		return rescale_to_temperature(sim, s, false, where);
	TS_TRY(find_temperature_compute(sim, s, where, &inst));
	ts_group_velocity(sim, inst->group, mean);
	add_mean_velocity(sim, s, mean, -1);
	status = rescale_to_temperature(sim, s, false, where);
	add_mean_velocity(sim, s, mean, 1);
	return status;
}

static enum ts_status set_velocities(struct tsim *sim, const struct state *s, const struct ts_place *where)
{
	struct ts_particles *p = sim->particles;
	struct ts_table table = { 0 };
	enum ts_status status = TS_OK;

	for (int d = 0; d < 3 && status == TS_OK; d++) {
		const char *variable = s->value[d].variable;
		double constant = 0, scale = unit_length(sim, s, d);
		bool peratom = variable && sim->script_api->is_peratom(sim->script_api_data, variable);

		if (s->value[d].null)
			continue;
		status = peratom ? sim->script_api->peratom(sim->script_api_data, variable, where, &table)
				 : ts_number_now(sim, &s->value[d], where, &constant);
		for (size_t i = 0; i < p->n && status == TS_OK; i++)
			if (ts_in_group(p, i, s->group))
				p->v[i][d] = (s->sum ? p->v[i][d] : 0) +
					     scale * (peratom ? table.data[i] : constant);
	}
	ts_table_release(&table);
	return status;
}

/* Draws components with variance 1/m; rescaling makes the temperature exact. The variance of the uniform
 * distribution on +-1/2 is 1/12. */
static void draw_velocities(struct tsim *sim, const struct state *s)
{
	struct ts_particles *p = sim->particles;

	for (size_t i = 0; i < p->n; i++) {
		struct ts_rng rng = ts_rng_start((uint64_t)s->seed, (uint64_t)p->tag[i]);

		if (!ts_in_group(p, i, s->group))
			continue;
		for (int d = 0; d < 3; d++) {
			double u =
				s->gaussian ? ts_rng_normal(&rng) : sqrt(12) * (ts_rng_uniform(&rng) - 0.5);

			p->v[i][d] = d < sim->dimension ? u / sqrt(p->mass[i]) : 0;
		}
	}
}

/* Random numbers are functions of seed and tag. With `bias` the mean velocity is kept; with `sum` the former
 * velocities are added at the end. */
static enum ts_status create_velocities(struct tsim *sim, const struct state *s, const struct ts_place *where)
{
	struct ts_particles *p = sim->particles;
	double(*old)[3], mean[3] = { 0 };
	struct ts_instance *inst = NULL;
	enum ts_status status;

	if (s->temp)
		TS_TRY(find_temperature_compute(sim, s, where, &inst));
	if (s->bias)
		ts_group_velocity(sim, inst->group, mean);
	old = ts_alloc(p->n, sizeof *old);
	if (!old)
		return ts_nomem(&sim->error);
	for (size_t i = 0; i < p->n; i++)
		for (int d = 0; d < 3; d++)
			old[i][d] = p->v[i][d];
	if (s->bias)
		add_mean_velocity(sim, s, mean, -1);
	draw_velocities(sim, s);
	status = s->momentum && ts_group_count(sim, s->group) > 1 ? zero_momentum(sim, s->group) : TS_OK;
	if (status == TS_OK && s->rotation)
		status = zero_rotation(sim, s->group);
	if (status == TS_OK)
		status = rescale_to_temperature(sim, s, s->bias, where);
	if (s->bias)
		add_mean_velocity(sim, s, mean, 1);
	for (size_t i = 0; s->sum && status == TS_OK && i < p->n; i++)
		for (int d = 0; ts_in_group(p, i, s->group) && d < 3; d++)
			p->v[i][d] += old[i][d];
	ts_free(old);
	return status;
}

static enum ts_status ramp_velocities(struct tsim *sim, const struct state *s, const struct ts_place *where)
{
	struct ts_particles *p = sim->particles;
	double scale = unit_length(sim, s, s->component), along = unit_length(sim, s, s->dim);

	if (s->x[0] == s->x[1])
		return ts_fail(&sim->error, TS_RANGE, where, "velocity ramp: both ends lie at %g", s->x[0]);
	for (size_t i = 0; i < p->n; i++)
		if (ts_in_group(p, i, s->group))
			p->v[i][s->component] = (s->sum ? p->v[i][s->component] : 0) +
						scale * ts_ramp(p->x[i][s->dim] / along, s->x, s->v);
	return TS_OK;
}

/* Whether `set` has only zeros, of which the unit is the same. */
static bool is_zero(const struct state *s)
{
	for (int d = 0; d < 3; d++)
		if (!s->value[d].null && (s->value[d].variable || s->value[d].value != 0))
			return false;
	return true;
}

static enum ts_status set_in_mode(struct tsim *sim, const struct state *s, const struct ts_place *where)
{
	struct ts_particles *p = sim->particles;

	switch (s->mode) {
	case SET:
		return set_velocities(sim, s, where);
	case CREATE:
		return create_velocities(sim, s, where);
	case SCALE:
		return scale_velocities(sim, s, where);
	case RAMP:
		return ramp_velocities(sim, s, where);
	default:
		break;
	}
	if (s->zero == LINEAR)
		return zero_momentum(sim, s->group);
	if (s->zero == ANGULAR)
		return zero_rotation(sim, s->group);
	for (size_t i = 0; s->zero == EACH && p->omega && i < p->n; i++)
		for (int d = 0; ts_in_group(p, i, s->group) && d < 3; d++)
			p->omega[i][d] = 0;
	return TS_OK;
}

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct state *s = state;

	if (s->bias && !s->temp)
		return ts_fail(&sim->error, TS_SYNTAX, ts_sim_word_of(sim, "bias", where),
			       "velocity: bias yes needs `temp` with the name of a compute temp/com");
	if (s->temp || ts_columns_have_bodies(sim->particles)) /* a compute; bodies follow their members */
		TS_TRY(ts_ranks_unite(sim));
	if ((s->mode == SET && !is_zero(s)) || s->mode == RAMP)
		ts_domain_units_said(sim, s->units, where);
	TS_TRY(set_in_mode(sim, s, where));
	return ts_rigid_take_clump_velocities(sim, s->group);
}

#define COMPONENT(name, d)                                                                                \
	TS_NUMBER(name, struct state, value[d], .flags = TS_POSITIONAL | TS_NULLABLE, .unit = "velocity", \
		  .help = "component, v_NAME, or NULL: not changed")
static const struct ts_arg set_args[] = {
	COMPONENT("vx", 0),
	COMPONENT("vy", 1),
	COMPONENT("vz", 2),
	TS_ARGS_END,
};

static const char *const distributions[] = { "uniform", "gaussian", NULL };
static const char *const loops[] = { "all", "local", "geom", NULL };
static const struct ts_arg create_args[] = {
	TS_REAL("temperature", struct state, temperature, .flags = TS_POSITIONAL, .range = TS_NOT_NEGATIVE,
		.unit = "temperature", .help = "temperature of the translational motion"),
	TS_INT("seed", struct state, seed, .flags = TS_POSITIONAL, .range = TS_POSITIVE,
	       .help = "seed of the random numbers"),
	TS_ARGS_END,
};

static const struct ts_arg scale_args[] = {
	TS_REAL("temperature", struct state, temperature, .flags = TS_POSITIONAL, .range = TS_NOT_NEGATIVE,
		.unit = "temperature", .help = "temperature of the translational motion"),
	TS_ARGS_END,
};

static const char *const components[] = { "vx", "vy", "vz", NULL };
static const struct ts_arg ramp_args[] = {
	TS_ENUM("component", struct state, component, components, .flags = TS_POSITIONAL,
		.help = "component that is set"),
	TS_REAL("vlo", struct state, v[0], .flags = TS_POSITIONAL, .unit = "velocity",
		.help = "value at lo and below"),
	TS_REAL("vhi", struct state, v[1], .flags = TS_POSITIONAL, .unit = "velocity",
		.help = "value at hi and above"),
	TS_ENUM("dim", struct state, dim, ts_axis_names, .flags = TS_POSITIONAL,
		.help = "coordinate on which the velocity depends"),
	TS_REAL("lo", struct state, x[0], .flags = TS_POSITIONAL, .unit = "length",
		.help = "lower coordinate"),
	TS_REAL("hi", struct state, x[1], .flags = TS_POSITIONAL, .unit = "length",
		.help = "upper coordinate"),
	TS_ARGS_END,
};

static const char *const zeros[] = { "linear", "angular", "angularIndividual", NULL };
static const struct ts_arg zero_args[] = {
	TS_ENUM("what", struct state, zero, zeros, .flags = TS_POSITIONAL,
		.help = "linear: the momentum of the group; angular: its angular momentum; "
			"angularIndividual: the angular velocity of each particle"),
	TS_ARGS_END,
};

static const struct ts_mode modes[] = {
	[SET] = { "set", "the same velocity for all, or one from a variable", set_args },
	[CREATE] = { "create", "random velocities with a given temperature", create_args },
	[SCALE] = { "scale", "scale all velocities by one factor to a temperature", scale_args },
	[RAMP] = { "ramp", "a component that varies linearly along a coordinate", ramp_args },
	[ZERO] = { "zero", "remove momentum or rotation", zero_args },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_GROUP("group", struct state, group, .flags = TS_POSITIONAL, .help = "particles that are changed"),
	TS_MODE("style", struct state, mode, modes, .help = "how velocities are set"),
	TS_BOOL("sum", struct state, sum, .fallback = "no",
		.help = "add to the present velocities (not for scale and zero)"),
	TS_ENUM("dist", struct state, gaussian, distributions, .fallback = "uniform",
		.help = "create: distribution of each component"),
	TS_BOOL("mom", struct state, momentum, .fallback = "yes",
		.help = "create: remove the momentum of the group"),
	TS_BOOL("rot", struct state, rotation, .fallback = "no",
		.help = "create: remove the angular momentum of the group"),
	TS_ENUM("loop", struct state, loop, loops, .fallback = "all",
		.help = "no effect: random numbers are functions of seed and atom ID"),
	TS_WORD("temp", struct state, temp, .flags = TS_OPTIONAL,
		.help = "ID of a compute whose temperature create and scale set; without it the temperature "
			"of the group"),
	TS_BOOL("bias", struct state, bias, .fallback = "no",
		.help = "create and scale keep the velocity that the compute temp/com of `temp` excludes: "
			"that of the centre of mass"),
	TS_ENUM("units", struct state, units, ts_region_units, .flags = TS_OPTIONAL,
		.help = "whether lengths of set and ramp are in lattice spacings or in units of length"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_velocity)
const struct ts_command_style ts_command_velocity = {
	.style = {
		.name = "velocity",
		.kind = TS_KIND_COMMAND,
		.ranks = TS_RANKS_ROWS,
		.summary = "Sets velocities of particles",
		.doc = "create draws each velocity component with the variance 1/m, from a uniform or\n"
		       "Gaussian distribution; the random numbers are functions of seed and atom ID. It\n"
		       "then removes the momentum (unless `mom no`) and scales the velocities to the\n"
		       "exact temperature\n\n"
		       "    T = sum m v^2 / (D (N - 1) k)\n\n"
		       "with D dimensions, N particles and the Boltzmann constant k. scale multiplies\n"
		       "all velocities by one factor to that temperature.\n\n"
		       "ramp interpolates linearly between lo and hi; the velocity is constant outside\n"
		       "of them. zero angular subtracts the rigid-body rotation omega x (x - x_cm) that\n"
		       "has the angular momentum of the group.",
		.example = "velocity all set 0 0 -1.5\n"
			   "velocity gas create 300 86028157 dist gaussian\n"
			   "velocity gas scale 250 temp drifting bias yes\n"
			   "velocity all ramp vx 0 1 z 0 0.1\n"
			   "velocity all zero linear",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.needs_box = true,
	.run = run,
};
