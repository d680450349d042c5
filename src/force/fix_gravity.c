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
	struct ts_number given[3]; /* components; the angle; or phi and theta */
	struct tsim *sim;
};

static void direction_3d(int mode, const double given[3], double d[3])
{
	const double degree = TS_PI / 180;
	double tilt = given[0] * degree, phi = given[0] * degree, theta = given[1] * degree;

	if (mode == VECTOR) {
		for (int k = 0; k < 3; k++)
			d[k] = given[k];
	} else if (mode == CHUTE) {
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
static void reduce_direction_to_2d(int mode, const double given[3], double d[3])
{
	if (mode == VECTOR) {
		d[2] = 0;
		return;
	}
	d[1] = d[2];
	d[2] = 0;
	if (mode == SPHERICAL)
		d[0] = sin(given[1] * TS_PI / 180);
}

/* The present direction, of unit length. */
static enum ts_status set_direction(struct ts_instance *self, struct tsim *sim)
{
	static const int numbers[] = { [VECTOR] = 3, [CHUTE] = 1, [SPHERICAL] = 2 };
	struct gravity *g = self->state;
	double *d = g->base.direction, length, given[3] = { 0 };

	for (int k = 0; k < numbers[g->mode]; k++)
		TS_TRY(ts_number_now(sim, &g->given[k], &self->where, &given[k]));
	direction_3d(g->mode, given, d);
	if (sim->dimension == 2)
		reduce_direction_to_2d(g->mode, given, d);
	length = sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
	if (!(length > 0))
		return ts_fail(&sim->error, TS_RANGE, &self->where,
			       "fix gravity: the direction has no length");
	for (int k = 0; k < 3; k++)
		d[k] /= length;
	return TS_OK;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct gravity *g = self->state;

	g->sim = sim;
	g->base.turns = g->given[0].variable || g->given[1].variable || g->given[2].variable;
	return set_direction(self, sim);
}

struct task {
	const struct ts_particles *p;
	double a[3];
	int group;
};

/* Members of rigid bodies are skipped: see ts_rigid_accelerate. */
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

	if (g->base.magnitude.variable || g->base.turns) /* the variable may read forces */
		ts_deferred_loops_run(sim);
	if (g->base.turns)
		TS_TRY(set_direction(self, sim));
	TS_TRY(ts_number_now(sim, &g->base.magnitude, &self->where, &magnitude));
	ts_scale(magnitude, g->base.direction, task.a);
	TS_DEFER_LOOP(sim, p->n, self->group == 0 && !p->body ? accelerate_all : accelerate_group, &task);
	return ts_rigid_accelerate(sim, self->group, task.a); /* rigid bodies only */
}

struct weights {
	double g[3];
};

static void potential_energy_term(const struct tsim *sim, size_t i, const void *context, double *out)
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

#define GIVEN(name_, k, unit_, help_) \
	TS_NUMBER(name_, struct gravity, given[k], .flags = TS_POSITIONAL, .unit = unit_, .help = help_)
static const struct ts_arg vector_rows[] = {
	GIVEN("x", 0, "", "x component of the direction, which is normalised"),
	GIVEN("y", 1, "", "y component"),
	GIVEN("z", 2, "", "z component"),
	TS_ARGS_END,
};
static const struct ts_arg chute_rows[] = {
	GIVEN("angle", 0, "degree", "angle of the direction from -z towards +x"),
	TS_ARGS_END,
};
static const struct ts_arg spherical_rows[] = {
	GIVEN("phi", 0, "degree", "azimuth: angle in the x-y plane from +x"),
	GIVEN("theta", 1, "degree", "polar angle from +z"),
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
		  .help = "magnitude of the acceleration"),
	TS_MODE("mode", struct gravity, mode, modes, .help = "how the direction is given"),
	TS_ARGS_END,
};

TS_STYLE(fix, ts_style, ts_fix_gravity)
const struct ts_style ts_fix_gravity = {
	.name = "gravity",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_OWN | TS_RANKS_ROWLESS,
	.summary = "adds gravity: the same acceleration for all particles of the group",
	.doc = "Adds the force f = m g to each particle of the group. The direction of g is given by `vector "
	       "x y z` (normalised), by `chute angle` (in the x-z plane, angle in degrees from -z towards "
	       "+x) or by `spherical phi theta` (degrees). In two dimensions y takes the role of z, and phi "
	       "has no effect. With variables the direction is that of each step, as in a box that is "
	       "tilted.\n\n"
	       "The scalar f_ID is the potential energy -sum m g . x with unwrapped positions x; it counts "
	       "in compute pe if `fix_modify ID energy yes` is set. Rigid bodies and clumps with a member in "
	       "the group are accelerated as a whole. In bodies of fix rigid each member gets its weight, "
	       "so that fixes that change the forces on members, as setforce and freeze, change it, too; a "
	       "clump of fix multisphere gets the weight of its mass, which those do not see, as in "
	       "LIGGGHTS.",
	.example = "fix g all gravity 9.81 vector 0.0 0.0 -1.0\n"
		   "fix tilt all gravity 9.81 chute v_angle",
	.args = args,
	.family = TS_FAMILY_GRAVITY,
	.state_size = sizeof(struct gravity),
	.values = values,
	.init = init,
	.hook = { [TS_STAGE_POST_FORCE] = add_gravity },
	.defers = TS_DEFERS(POST_FORCE),
	.energy = ts_energy_output,
};
