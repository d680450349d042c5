/* Fix spring: a spring between the centre of mass of a group and a point or another group. */
#include "core/report.h"
#include "energy/potential_energy.h"

#include <math.h>

#include "group/group_motion.h"
#include "math/vec3.h"
#include "particle/group_moments.h"
#include "rigid/rigid_share.h"

#include "base/banned.h"

enum { TETHER, COUPLE };

struct state {
	int mode, partner;
	double stiffness, rest;
	struct ts_number at[3];	 /* NULL: no force in this direction */
	double force[4], energy; /* saved; force on the group, and its magnitude, > 0 attractive */
	double mass;		 /* as in the limit of the step, at the start of a run */
};

/* Adds a force on particle i; of a sphere of a clump it acts at the centre of mass of the clump, not at that of the sphere. */
static void add_force(struct tsim *sim, size_t i, const double force[3])
{
	const struct ts_body *clump = ts_rigid_clump_of(sim, i);
	struct ts_particles *p = sim->particles;
	double arm[3], torque[3];

	ts_add(p->f[i], force, p->f[i]);
	if (!clump)
		return;
	ts_unwrapped(sim, i, arm);
	ts_sub(arm, clump->x, arm);
	ts_cross(arm, force, torque);
	ts_sub(p->torque[i], torque, p->torque[i]);
}

/* Distributes a force over a group in proportion to mass: all particles get the same acceleration. */
static void distribute_force(struct tsim *sim, int group, const double force[3], double sign)
{
	struct ts_particles *p = sim->particles;
	double mass = ts_group_mass(sim, group);

#pragma omp parallel for num_threads(ts_team(sim, p->n)) schedule(static)
	for (size_t i = 0; i < p->n; i++) {
		double part[3];

		if (!ts_in_group(p, i, group))
			continue;
		for (int k = 0; k < 3; k++)
			part[k] = sign * force[k] * (p->mass[i] / mass);
		add_force(sim, i, part);
	}
}

/* Vector from the fixed end of the spring to the centre of mass of the group; 0 in free directions. */
static enum ts_status spring_vector(struct ts_instance *self, struct tsim *sim, double d[3])
{
	const struct state *s = self->state;
	double other[3];

	ts_group_centre(sim, self->group, d);
	if (s->mode == COUPLE)
		ts_group_centre(sim, s->partner, other);
	for (int k = 0; k < 3; k++) {
		double at = 0;

		if (!s->at[k].null)
			TS_TRY(ts_number_now(sim, &s->at[k], &self->where, &at));
		d[k] -= s->mode == COUPLE ? other[k] - at : at;
		if (s->at[k].null)
			d[k] = 0;
	}
	return TS_OK;
}

static enum ts_status add_spring_force(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	double d[3], length, stretch;

	TS_TRY(spring_vector(self, sim, d));
	length = ts_norm(d);
	stretch = length - s->rest;
	for (int k = 0; k < 3; k++)
		s->force[k] = length > 0 ? -s->stiffness * stretch * d[k] / length : 0;
	s->force[3] = length > 0 ? s->stiffness * stretch : 0;
	s->energy = 0.5 * s->stiffness * stretch * stretch;
	distribute_force(sim, self->group, s->force, 1);
	if (s->mode == COUPLE)
		distribute_force(sim, s->partner, s->force, -1);
	return TS_OK;
}

/* Of the group, or the reduced mass of both groups; 0: empty. */
static double oscillating_mass(const struct ts_instance *self, const struct tsim *sim)
{
	const struct state *s = self->state;
	double mass = ts_group_mass(sim, self->group), other;

	if (s->mode == TETHER)
		return mass;
	other = ts_group_mass(sim, s->partner);
	return mass + other > 0 ? mass * other / (mass + other) : 0;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	((struct state *)self->state)->mass = oscillating_mass(self, sim);
	return TS_OK;
}

/* Where the group is more than the particle, an upper bound: the whole spring acts in its motion. */
static void add_ground(const struct ts_instance *self, const struct tsim *sim, size_t i,
		       struct ts_ground_springs *sum)
{
	const struct state *s = self->state;

	if (!(s->mass > 0))
		return;
	for (int k = 0; k < 3; k++)
		if (!s->at[k].null)
			sum->frequency2[k] += s->stiffness / s->mass;
	sum->estimated |= s->mode == COUPLE || s->rest > 0 || s->mass != sim->particles->mass[i];
}

static enum ts_status report_limit(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report)
{
	const struct state *s = self->state;
	double mass = oscillating_mass(self, sim);

	if (!(mass > 0))
		return TS_OK;
	return ts_report_limit(report, 2 * sqrt(mass / s->stiffness), true, &self->where,
			       "fix spring, 2 sqrt(m/K)");
}

static enum ts_status eval_energy(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	(void)sim;
	out->data[0] = ((const struct state *)self->state)->energy;
	return TS_OK;
}

static enum ts_status eval_force(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	(void)sim;
	for (int k = 0; k < 4; k++)
		out->data[k] = ((const struct state *)self->state)->force[k];
	return TS_OK;
}

#define K_ROW                                                                               \
	TS_REAL("K", struct state, stiffness, .flags = TS_POSITIONAL, .range = TS_POSITIVE, \
		.unit = "force/length", .help = "stiffness of the spring")
#define END_ROWS(help_)                                                                                     \
	TS_NUMBER("x", struct state, at[0], .flags = TS_POSITIONAL | TS_NULLABLE, .unit = "length",         \
		  .help = help_ ", a number or v_NAME; NULL: no force in x"),                               \
		TS_NUMBER("y", struct state, at[1], .flags = TS_POSITIONAL | TS_NULLABLE, .unit = "length", \
			  .help = "y"),                                                                     \
		TS_NUMBER("z", struct state, at[2], .flags = TS_POSITIONAL | TS_NULLABLE, .unit = "length", \
			  .help = "z"),                                                                     \
		TS_REAL("R0", struct state, rest, .flags = TS_POSITIONAL, .range = TS_NOT_NEGATIVE,         \
			.unit = "length", .help = "rest length")
static const struct ts_arg tether_args[] = { K_ROW, END_ROWS("x of the anchor point"), TS_ARGS_END };
static const struct ts_arg couple_args[] = {
	TS_GROUP("partner", struct state, partner, .flags = TS_POSITIONAL, .help = "group at the other end"),
	K_ROW,
	END_ROWS("x of the partner relative to the group at rest"),
	TS_ARGS_END,
};

static const struct ts_mode modes[] = {
	[TETHER] = { "tether", "spring to a point", tether_args },
	[COUPLE] = { "couple", "spring between two groups", couple_args },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_MODE("style", struct state, mode, modes, .help = "what the spring connects the group to"),
	TS_ARGS_END,
};

static const char *const components[] = { "x", "y", "z", "size" };
static const struct ts_value values[] = {
	{ "energy", "energy", "energy of the spring", TS_SCALAR, 1, NULL, eval_energy },
	{ "force", "force", "force on the group, and its magnitude, < 0 if repulsive", TS_VECTOR, 4,
	  components, eval_force },
	{ .name = NULL },
};

static const struct ts_saved saved[] = {
	TS_SAVE_F64(struct state, force),
	TS_SAVE_F64(struct state, energy),
	TS_SAVED_ROWS_END,
};

TS_STYLE(fix, ts_style, ts_fix_spring)
const struct ts_style ts_fix_spring = {
	.name = "spring",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_OWN | TS_RANKS_OUTPUTS,
	.summary = "adds a spring between the centre of mass of a group and a point or another group",
	.doc = "The force on the group is\n\n"
	       "  F = -K (|d| - R0) d/|d|\n\n"
	       "where d is the vector to the centre of mass of the group from the point (tether), or from "
	       "the centre of mass of the partner minus (x, y, z) (couple). Centres of mass are those of "
	       "unwrapped positions. The force is distributed over the particles in proportion to their "
	       "mass, so it accelerates the group as a whole and exerts no torque about its centre of mass; "
	       "the partner gets the opposite force. Velocity Verlet is stable for time steps below 2 "
	       "sqrt(m/K), with the mass m of the group, or the reduced mass of both groups.",
	.example = "fix tow ball spring tether 25 0.5 NULL v_height 0.0\n"
		   "fix rope left spring couple right 25 0 0 0 2.385",
	.args = args,
	.state_size = sizeof(struct state),
	.saved = saved,
	.values = values,
	.energy = ts_energy_output,
	.init = init,
	.hook[TS_STAGE_POST_FORCE] = add_spring_force,
	.ground = add_ground,
	.plan = report_limit,
};
