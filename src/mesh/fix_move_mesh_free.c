/* Fix move/mesh/free: closed meshes that move as free rigid bodies under contact forces, fluid forces and
 * gravity. */
#include <math.h>
#include <string.h>

#include "core/report.h"
#include "flow/flow.h"
#include "flow/fluid.h"
#include "force/gravity.h"
#include "immersed/virtual_mass_stabilization.h"
#include "math/rigid_turn.h"
#include "mesh/mesh_distance.h"
#include "mesh/mesh_motion.h"
#include "mesh/mesh_volume.h"
#include "rigid/rigid_motion.h"
#include "load/mesh_stress.h"

#include "base/banned.h"

struct state {
	struct ts_mesh_mover mover;
	int what;
	double density, mass, velocity[3], omega[3]; /* one of density and mass is NaN */
	bool falls;				     /* gravity acts on it */
	bool due; /* contact forces have been computed since they were last summed for the body */
	/* saved */
	struct ts_body body;
	double q0[4]; /* initial orientation; the initial centre is mover.origin */
	int64_t made; /* 1: the body has been set up */
	struct ts_net_force net;
	int64_t fluid_steps; /* number of steps of the fluid at the last averaging of `net` */
};

/* ---- before a run */

static enum ts_status fail_mesh(struct ts_instance *self, struct tsim *sim, const char *what)
{
	const struct state *s = self->state;

	return ts_fail(&sim->error, TS_STATE, ts_instance_word(self, s->mover.mesh),
		       "fix move/mesh/free: mesh %s %s", s->mover.mesh, what);
}

static enum ts_status check_arguments(struct ts_instance *self, struct tsim *sim,
				      const struct ts_mesh_surface *surface)
{
	const struct state *s = self->state;
	const struct ts_instance *inst;

	if (!surface->stress)
		return fail_mesh(self, sim,
				 "does not sum the forces of particles; make it by fix mesh/surface/stress");
	for (size_t k = 0; (inst = ts_sim_next_of(sim, TS_KIND_FIX, TS_FAMILY_MESH_MOVER, &k));)
		if (inst != self &&
		    ts_streq(((const struct ts_mesh_mover *)inst->state)->mesh, s->mover.mesh))
			return fail_mesh(self, sim,
					 "is moved by another fix, too; a body that is free is moved by this "
					 "one alone");
	if (isnan(s->density) == isnan(s->mass))
		return ts_fail(&sim->error, TS_SYNTAX, &self->where,
			       "fix move/mesh/free: say either `density` or `mass`");
	return TS_OK;
}

/* Two dimensions: makes z a principal axis, and removes velocity along z and rotation about x and y. */
static void restrict_to_plane(struct state *s, double inertia[6])
{
	inertia[4] = inertia[5] = 0;
	s->velocity[2] = s->omega[0] = s->omega[1] = 0;
}

/* Computes mass, centre of mass and moments of inertia from the volume that the mesh encloses. */
static enum ts_status make_body(struct ts_instance *self, struct tsim *sim,
				const struct ts_mesh_surface *surface)
{
	struct state *s = self->state;
	struct ts_body *b = &s->body;
	struct ts_mesh_volume v;
	size_t t;

	if (!ts_mesh_closed(&surface->mesh, &t))
		return fail_mesh(self, sim, "is not closed: what it encloses has no mass");
	if (!ts_mesh_measure_volume(&surface->mesh, &v))
		return fail_mesh(self, sim,
				 "does not enclose a volume: some of its normals point inwards, others "
				 "outwards, or it is closed through periodic faces only");
	*b = (struct ts_body){ .free = { 1, 1, 1, 1, 1, 1 } };
	b->mass = isnan(s->mass) ? s->density * fabs(v.volume) : s->mass;
	b->density = b->mass / fabs(v.volume);
	for (int k = 0; k < 6; k++)
		v.inertia[k] *= b->mass / v.volume;
	if (sim->dimension == 2)
		restrict_to_plane(s, v.inertia);
	ts_rigid_principal(b, v.inertia);
	memcpy(b->x, v.centre, sizeof b->x);
	memcpy(s->mover.origin, v.centre, sizeof v.centre);
	memcpy(s->q0, b->q, sizeof b->q);
	memcpy(b->v, s->velocity, sizeof b->v);
	memcpy(b->omega, s->omega, sizeof b->omega);
	ts_rigid_angular_momentum(b->q, b->inertia, b->omega, b->spin);
	s->made = 1;
	return TS_OK;
}

static enum ts_status find_surface(struct ts_instance *self, struct tsim *sim, struct ts_mesh_surface **out)
{
	const char *mesh = ((const struct state *)self->state)->mover.mesh;
	struct ts_word id = { .text = mesh, .place = *ts_instance_word(self, mesh) };

	return ts_mesh_surface_require(sim, &id, out);
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	const struct state *s = self->state;
	struct ts_mesh_surface *surface;

	TS_TRY(ts_mesh_mover_check(self, sim));
	TS_TRY(find_surface(self, sim, &surface));
	TS_TRY(check_arguments(self, sim, surface));
	surface->stress->followed = true;
	return s->made ? TS_OK : make_body(self, sim, surface);
}

static enum ts_status plan(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report)
{
	const struct state *s = self->state;
	const struct ts_body *b = &s->body;

	(void)sim;
	ts_report_line(report, "free mesh", "%s: mass %.6g, density %.6g, principal moments %.6g %.6g %.6g",
		       s->mover.mesh, b->mass, b->density, b->inertia[0], b->inertia[1], b->inertia[2]);
	return TS_OK;
}

/* ---- in a step */

static enum ts_status add_gravity(struct ts_instance *self, struct tsim *sim)
{
	struct ts_body *b = &((struct state *)self->state)->body;
	const struct ts_instance *inst;

	for (size_t k = 0; (inst = ts_sim_next_of(sim, TS_KIND_FIX, TS_FAMILY_GRAVITY, &k));) {
		const struct ts_gravity *g = inst->state;
		double magnitude;

		TS_TRY(ts_number_now(sim, &g->magnitude, &inst->where, &magnitude));
		ts_axpy(b->mass * magnitude, g->direction, b->force);
	}
	return TS_OK;
}

/* Sums the forces of particles and fluids, both with torques about the anchor of the mesh, and gravity. */
static enum ts_status sum_forces(struct ts_instance *self, struct tsim *sim, bool in_setup)
{
	struct state *s = self->state;
	struct ts_body *b = &s->body;
	const struct ts_instance *inst;
	struct ts_mesh_surface *surface;
	double load[2][3], arm[3], virtual_density = 0;

	TS_TRY(find_surface(self, sim, &surface));
	s->due = false;
	memcpy(load, surface->stress->sum, sizeof load);
	for (size_t k = 0; (inst = ts_sim_next_of(sim, TS_KIND_FIX, TS_FAMILY_FLOW_PART, &k));) {
		const struct ts_flow_part *part = inst->state;

		if (part->mesh_load)
			part->mesh_load(inst, surface, load, &virtual_density);
	}
	memcpy(b->force, load[0], sizeof b->force);
	ts_sub(surface->anchor, b->x, arm);
	ts_cross(arm, load[0], b->torque);
	ts_add(b->torque, load[1], b->torque);
	if (s->falls)
		TS_TRY(add_gravity(self, sim));
	if (sim->dimension == 2)
		b->force[2] = b->torque[0] = b->torque[1] = 0;
	if (virtual_density > 0) {
		ts_net_force_stabilize(&s->net, ts_virtual_mass_ratio(b->density, 1, virtual_density),
				       b->force, b->torque);
		ts_net_force_record(&s->net, in_setup, b->force, b->torque);
	}
	return TS_OK;
}

/* Velocity of the body at the initial position of its centre, about which the mover rotates it. */
static void origin_velocity(const struct state *s, double drift[3])
{
	double arm[3];

	ts_sub(s->mover.origin, s->body.x, arm);
	ts_cross(s->body.omega, arm, drift);
	ts_add(drift, s->body.v, drift);
}

static enum ts_status initial_integrate(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	struct ts_mesh_motion m = { .now = ts_motion_none() };
	double first[3][3], now[3][3];

	ts_body_kick(&s->body, 0.5 * sim->clock.dt);
	ts_body_move(&s->body, sim->clock.dt);
	ts_quaternion_matrix(s->q0, first);
	ts_quaternion_matrix(s->body.q, now);
	for (int i = 0; i < 3; i++)
		for (int j = 0; j < 3; j++)
			m.now.turn[i][j] = ts_dot(now[i], first[j]);
	memcpy(m.now.origin, s->mover.origin, sizeof m.now.origin);
	ts_sub(s->body.x, s->mover.origin, m.now.shift);
	origin_velocity(s, m.drift);
	memcpy(m.spin, s->body.omega, sizeof m.spin);
	return ts_mesh_mover_move(self, sim, &m);
}

static enum ts_status final_integrate(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	double drift[3];

	TS_TRY(sum_forces(self, sim, false));
	ts_body_kick(&s->body, 0.5 * sim->clock.dt);
	origin_velocity(s, drift);
	return ts_mesh_mover_set_velocity(self, sim, drift, s->body.omega);
}

static enum ts_status post_force(struct ts_instance *self, struct tsim *sim)
{
	(void)sim;
	((struct state *)self->state)->due = true;
	return TS_OK;
}

/* Forces at the start of a run. A run that resumes computes no forces before its first step: the body
 * keeps those of the last step. */
static enum ts_status setup(struct ts_instance *self, struct tsim *sim)
{
	return ((struct state *)self->state)->due ? sum_forces(self, sim, true) : TS_OK;
}

/* Acts after the fluid has made its step. */
static enum ts_status end_of_step(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	const struct ts_fluid *fluid = ts_flow_fluid(sim);

	if (!fluid || fluid->steps == s->fluid_steps)
		return TS_OK;
	s->fluid_steps = fluid->steps;
	ts_net_force_average(&s->net);
	return TS_OK;
}

/* Older restart files do not have these values. */
static enum ts_status archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a)
{
	struct state *s = self->state;

	(void)sim;
	if (!ts_archive_has(a, "net force"))
		return TS_OK;
	TS_TRY(ts_archive_fixed(a, "fluid steps", TS_SAVED_I64, &s->fluid_steps, 1));
	return ts_archive_fixed(a, "net force", TS_SAVED_F64, &s->net, TS_NET_FORCE_NUMBERS);
}

/* ---- outputs */

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct ts_body *b = &((const struct state *)self->state)->body;
	const double *const each[] = { b->x, b->v, b->omega, b->spin, b->force, b->torque };

	(void)sim;
	for (size_t k = 0; k < 18; k++)
		out->data[k] = each[k / 3][k % 3];
	out->data[18] = b->mass;
	out->data[19] = 0.5 * (b->mass * ts_dot(b->v, b->v) + ts_dot(b->spin, b->omega));
	return TS_OK;
}

static const char *const columns[] = { "x",  "y",  "z",	 "vx", "vy", "vz", "wx", "wy",	 "wz", "lx", "ly",
				       "lz", "fx", "fy", "fz", "tx", "ty", "tz", "mass", "ke", NULL };
static const struct ts_value values[] = {
	{ "motion", "",
	  "[1..3] centre of mass, not wrapped, [4..6] velocity, [7..9] angular velocity, [10..12] angular "
	  "momentum about the centre, [13..15] force, [16..18] torque about the centre, [19] mass, [20] "
	  "kinetic energy",
	  TS_VECTOR, 20, columns, eval },
	{ .name = NULL },
};

static const char *const movable[] = { "mesh", NULL };
static const struct ts_arg args[] = {
	TS_ENUM("what", struct state, what, movable, .flags = TS_POSITIONAL, .help = "what moves"),
	TS_WORD("mesh-ID", struct state, mover.mesh, .flags = TS_POSITIONAL,
		.help = "ID of a fix mesh/surface/stress, a closed surface"),
	TS_REAL("density", struct state, density, .flags = TS_OPTIONAL | TS_STATEFUL, .range = TS_POSITIVE,
		.unit = "density", .help = "density of the body"),
	TS_REAL("mass", struct state, mass, .flags = TS_OPTIONAL | TS_STATEFUL, .range = TS_POSITIVE,
		.unit = "mass", .help = "instead of density: mass of the body, distributed homogeneously"),
	TS_VEC3("velocity", struct state, velocity, .fallback = "0 0 0", .unit = "velocity",
		.help = "initial velocity of the centre of mass"),
	TS_VEC3("omega", struct state, omega, .fallback = "0 0 0", .unit = "radian/time",
		.help = "initial angular velocity"),
	TS_BOOL("gravity", struct state, falls, .fallback = "yes",
		.help = "whether each fix gravity, of any group, acts on it"),
	TS_ARGS_END,
};

static const struct ts_saved saved[] = {
	TS_SAVE_I64(struct state, mover.serial), TS_SAVE_F64(struct state, mover.origin),
	TS_SAVED_BODY(struct state, body),	 TS_SAVE_F64(struct state, q0),
	TS_SAVE_I64(struct state, made),	 TS_SAVED_ROWS_END,
};

TS_STYLE(fix, ts_style, ts_fix_move_mesh_free)
const struct ts_style ts_fix_move_mesh_free = {
	.name = "move/mesh/free",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_OWN | TS_RANKS_OUTPUTS,
	.summary = "A closed mesh that moves as a free rigid body",
	.doc = "The body that the mesh of a `fix mesh/surface/stress` encloses moves freely under the forces "
	       "of contacts with particles, of fluids and of gravity:\n\n"
	       "  m dv/dt = F,  dL/dt = T,  omega = R I^-1 R^T L,\n\n"
	       "integrated by velocity Verlet, the orientation as with fix rigid. The mass m, the centre of "
	       "mass and the moments of inertia I are those of a homogeneous body, as sums over the "
	       "tetrahedra of each triangle and a common point, exact to round-off.\n\n"
	       "F and T are those of the particles that touch the mesh by `fix wall/gran ... mesh`; those of "
	       "each `fix immersed/boundary mesh` made of the mesh, at the last step of the fluid, with its "
	       "virtual mass added to that of the body; and the weight. Buoyancy must be in the script, "
	       "unless the force of the fluid contains it: with a body_force of flow_style along an axis "
	       "that is not periodic.\n\n"
	       "A contact is damped as one between the particle and a wall of infinite mass, with the mass "
	       "of the particle alone. With friction, the lever arm of the particle ends between its surface "
	       "and that of the mesh, the arm of the mesh at its own surface; so angular momentum is "
	       "conserved to half an overlap, else to round-off.\n\n"
	       "Meshes do not interact with each other, nor with walls. In two dimensions the motion is "
	       "restricted to the plane, with the mass of the whole mesh, including the part beyond the box "
	       "along z (give `mass` in this case). No other fix may move the mesh.\n\n"
	       "Related: fix mesh/surface/stress, fix wall/gran, fix immersed/boundary, fix rigid.",
	.example = "fix box all mesh/surface/stress file box.stl type 2\n"
		   "fix free all move/mesh/free mesh box density 700 velocity 0.1 0 0",
	.args = args,
	.family = TS_FAMILY_MESH_MOVER,
	.state_size = sizeof(struct state),
	.saved = saved,
	.archive = archive,
	.values = values,
	.init = init,
	.plan = plan,
	.hook = { [TS_STAGE_INITIAL_INTEGRATE] = initial_integrate,
		  [TS_STAGE_POST_FORCE] = post_force,
		  [TS_STAGE_FINAL_INTEGRATE] = final_integrate,
		  [TS_STAGE_END_OF_STEP] = end_of_step,
		  [TS_STAGE_SETUP] = setup },
};
