#include "core/deferred_loops.h"
#include "core/sim.h"
#include "energy/potential_energy.h"

#include <math.h>

#include "base/clones.h"
#include "force/gravity.h"
#include "math/constants.h"
#include "math/vec3.h"
#include "particle/group_moments.h"
#include "rigid/rigid.h"

#include "base/banned.h"

enum { VECTOR, CHUTE, SPHERICAL };

struct gravity {
	struct ts_gravity base; /* read by other styles */
	int mode;
	double vector[3], angle, phi, theta;
	struct tsim *sim;
};

static void direction_3d(const struct gravity *g, double d[3])
{
	const double degree = TS_PI / 180;
	double theta = g->theta * degree, phi = g->phi * degree, tilt = g->angle * degree;

	if (g->mode == VECTOR) {
		for (int k = 0; k < 3; k++)
			d[k] = g->vector[k];
	} else if (g->mode == CHUTE) {
		d[0] = sin(tilt);
		d[1] = 0;
		d[2] = -cos(tilt);
	} else {
		d[0] = sin(theta) * cos(phi);
		d[1] = sin(theta) * sin(phi);
		d[2] = cos(theta);
	}
}

/* As in LAMMPS, y takes the role of z in two dimensions, and phi has no effect. */
static void reduce_direction_to_2d(const struct gravity *g, double d[3])
{
	if (g->mode == VECTOR) {
		d[2] = 0;
		return;
	}
	d[1] = d[2];
	d[2] = 0;
	if (g->mode == SPHERICAL)
		d[0] = sin(g->theta * TS_PI / 180);
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct gravity *g = self->state;
	double *d = g->base.direction, length;

	g->sim = sim;
	direction_3d(g, d);
	if (sim->dimension == 2)
		reduce_direction_to_2d(g, d);
	length = sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
	if (!(length > 0))
		return ts_fail(&sim->error, TS_RANGE, &self->where,
			       "fix gravity: the direction has no length");
	for (int k = 0; k < 3; k++)
		d[k] /= length;
	return TS_OK;
}

struct task {
	const struct ts_particles *p;
	double a[3];
	int group;
};

/* Members of rigid bodies are skipped: their body is accelerated as a whole. */
static void accelerate_group(void *context, size_t from, size_t to)
{
	const struct task *t = context;
	const struct ts_particles *p = t->p;

	for (size_t i = from; i < to; i++)
		if (ts_in_group(p, i, t->group) && !ts_rigid_member(p, i))
			for (int k = 0; k < 3; k++)
				p->f[i][k] += p->mass[i] * t->a[k];
}

TS_CLONES
static void accelerate_all(void *context, size_t from, size_t to)
{
	const struct task *t = context;
	const double ax = t->a[0], ay = t->a[1], az = t->a[2];
	const double *restrict mass = t->p->mass;
	double *restrict f = t->p->f[0];

#pragma omp simd
	for (size_t i = from; i < to; i++) {
		f[3 * i] += mass[i] * ax;
		f[3 * i + 1] += mass[i] * ay;
		f[3 * i + 2] += mass[i] * az;
	}
}

static enum ts_status add_gravity(struct ts_instance *self, struct tsim *sim)
{
	const struct gravity *g = self->state;
	struct ts_particles *p = sim->particles;
	struct task task = { .p = p, .group = self->group };
	double magnitude;

	if (g->base.magnitude.variable) /* the variable may read forces */
		ts_deferred_loops_run(sim);
	TS_TRY(ts_number_now(sim, &g->base.magnitude, &self->where, &magnitude));
	ts_scale(magnitude, g->base.direction, task.a);
	TS_DEFER_LOOP(sim, p->n, self->group == 0 && !p->body ? accelerate_all : accelerate_group, &task);
	return ts_rigid_accelerate(sim, self->group, task.a); /* rigid bodies only */
}

struct weights {
	double g[3];
};

static void potential_energy_term(const struct tsim *sim, size_t i, void *context, double *out)
{
	const struct ts_body *body = ts_rigid_body_of(sim, i);
	const double *g = ((const struct weights *)context)->g;
	double x[3];

	ts_unwrapped(sim, i, x);
	*out = -sim->particles->mass[i] * ts_dot(g, body ? body->x : x);
}

static enum ts_status eval_energy(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct gravity *g = self->state;
	struct weights weights;
	double magnitude;

	TS_TRY(ts_number_now(g->sim, &g->base.magnitude, &self->where, &magnitude));
	ts_scale(magnitude, g->base.direction, weights.g);
	ts_group_sum(sim, self->group, 1, potential_energy_term, &weights, out->data);
	return TS_OK;
}

static const struct ts_value values[] = {
	{ "energy", "energy", "-sum m g.x over the group, positions unwrapped", TS_SCALAR, 1, NULL,
	  eval_energy },
	{ .name = NULL },
};

static const struct ts_arg vector_rows[] = {
	TS_VEC3("direction", struct gravity, vector, .flags = TS_POSITIONAL,
		.help = "direction of the acceleration; normalised"),
	TS_ARGS_END,
};
static const struct ts_arg chute_rows[] = {
	TS_REAL("angle", struct gravity, angle, .flags = TS_POSITIONAL, .unit = "degree",
		.help = "angle of the direction from -z towards +x"),
	TS_ARGS_END,
};
static const struct ts_arg spherical_rows[] = {
	TS_REAL("phi", struct gravity, phi, .flags = TS_POSITIONAL, .unit = "degree",
		.help = "azimuth: angle in the x-y plane from +x"),
	TS_REAL("theta", struct gravity, theta, .flags = TS_POSITIONAL, .unit = "degree",
		.help = "polar angle from +z"),
	TS_ARGS_END,
};
static const struct ts_mode modes[] = {
	{ "vector", "direction by its components", vector_rows },
	{ "chute", "direction in the x-z plane, by its angle", chute_rows },
	{ "spherical", "direction by azimuth and polar angle", spherical_rows },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_NUMBER("magnitude", struct gravity, base.magnitude, .flags = TS_POSITIONAL, .unit = "acceleration",
		  .help = "magnitude of the acceleration; a number or v_NAME"),
	TS_MODE("mode", struct gravity, mode, modes, .help = "how the direction is given"),
	TS_ARGS_END,
};

TS_STYLE(fix, ts_style, ts_fix_gravity)
const struct ts_style ts_fix_gravity = {
	.name = "gravity",
	.kind = TS_KIND_FIX,
	.summary = "adds gravity: the same acceleration for all particles of the group",
	.doc = "Adds the force f = m g to each particle of the group. The direction of g is given by `vector "
	       "x y z` (normalised), by `chute angle` (in the x-z plane, angle in degrees from -z towards "
	       "+x) or by `spherical phi theta` (degrees). In two dimensions y takes the role of z, and phi "
	       "has no effect.\n\n"
	       "The scalar f_ID is the potential energy -sum m g . x with unwrapped positions x; it counts "
	       "in compute pe if `fix_modify ID energy yes` is set. Rigid bodies with a member in the group "
	       "are accelerated as a whole, with the mass of the body.",
	.example = "fix g all gravity 9.81 vector 0.0 0.0 -1.0",
	.args = args,
	.family = TS_FAMILY_GRAVITY,
	.state_size = sizeof(struct gravity),
	.values = values,
	.init = init,
	.hook = { [TS_STAGE_POST_FORCE] = add_gravity },
	.defers = TS_DEFERS(POST_FORCE),
	.energy = ts_energy_output,
};
