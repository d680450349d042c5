#include "coupling/added_mass.h"

#include <math.h>
#include <string.h>

#include "base/alloc.h"
#include "core/ranks.h"
#include "coupling/lagged_inertia.h"
#include "flow/fluid_slabs.h"
#include "force/restraint.h"
#include "group/group_members.h"
#include "particle/particles.h"
#include "particle/sphere_shape.h"
#include "rigid/rigid.h"

#include "base/banned.h"

struct state {
	struct ts_added_mass mass; /* first */
	struct ts_restraints restraints;
	double *last[3], *rate[3]; /* fields: velocity of the fluid after its last step, and du/dt. Owned */
	size_t size, capacity[2][3];
};

/* Du/Dt at the particle. */
static void fluid_acceleration(const struct state *s, const struct ts_coupling_local_flow *around,
			       double a[3])
{
	const struct ts_fluid *fluid = s->mass.force.fluid;

	struct ts_coupling_weights weights[3];

	if (fluid && s->mass.accelerates && s->size)
		ts_coupling_weights_faces(fluid, around->place, around->cell, TS_INTERPOLATE_LINEAR, weights);
	for (int c = 0; c < 3; c++) {
		a[c] = 0;
		if (!fluid || !s->mass.accelerates)
			continue;
		for (int k = 0; k < 3; k++)
			a[c] += around->u[k] * around->gradient[c][k];
		if (!s->size || c >= fluid->grid.dimensions)
			continue;
		a[c] += ts_coupling_interpolate(&fluid->grid, &weights[c], s->rate[c]);
	}
}

static double added_mass_of(const struct ts_instance *self, const struct tsim *sim, size_t i)
{
	const struct state *s = self->state;

	return s->mass.coefficient * ts_flow_style_of(s->mass.force.flow)->density(s->mass.force.flow) *
	       ts_particle_volume(sim, sim->particles->radius[i]);
}

static void add_ground(const struct ts_instance *self, const struct tsim *sim, size_t i,
		       struct ts_ground_springs *sum)
{
	sum->added += added_mass_of(self, sim, i) * sim->particles->imass[i];
}

/* The part C rho V_p Du/Dt, which does not depend on the motion of the particle. */
static void add_force(const struct ts_instance *self, const struct tsim *sim, size_t i,
		      const struct ts_coupling_local_flow *around, double f[3], double torque[3])
{
	double added = added_mass_of(self, sim, i);

	(void)torque;
	fluid_acceleration(self->state, around, f);
	for (int k = 0; k < 3; k++)
		f[k] *= added;
}

/* The part -M a with (m + M) a = f, M the added mass and f the effective sum of all forces. */
static void add_own_inertia(const struct ts_instance *self, struct tsim *sim, size_t i)
{
	struct state *s = self->state;
	struct ts_particles *p = sim->particles;
	double added = added_mass_of(self, sim, i), f[3];

	memcpy(f, p->f[i], sizeof f);
	ts_restraints_apply(&s->restraints, sim, i, f);
	for (int k = 0; k < 3 && p->imass[i] != 0; k++) {
		double force = -added * f[k] / (p->mass[i] + added);

		p->f[i][k] += force;
		s->mass.force.total.note[i][k] += force;
	}
}

static enum ts_status apply_inertia(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	const struct ts_particles *p = sim->particles;

	TS_TRY(ts_restraints_prepare(&s->restraints, sim));
#pragma omp parallel for num_threads(ts_team(sim, p->n)) schedule(static)
	for (size_t i = 0; i < p->n; i++) {
		double place[3];
		int cell[3];

		if (ts_in_group(p, i, self->group) &&
		    (!s->mass.force.fluid || ts_coupling_locate(s->mass.force.fluid, p->x[i], place, cell)))
			add_own_inertia(self, sim, i);
	}
	return ts_coupling_force_add_to_fluid(self, sim);
}

static void store_acceleration(struct state *s, const struct ts_fluid *fluid, int c, double dt, bool known)
{
	double *last = s->last[c], *rate = s->rate[c];
	const double *u = fluid->u[c];

	for (int range = 0; range < ts_fluid_ranges(fluid); range++) {
		size_t first, end;

		ts_fluid_range_values(fluid, range, &first, &end);
		for (size_t k = first; k < end; k++) {
			rate[k] = known ? (u[k] - last[k]) / dt : 0;
			last[k] = u[k];
		}
	}
}

static enum ts_status store_fluid_acceleration(struct ts_instance *self, struct tsim *sim,
					       struct ts_fluid *fluid, double dt)
{
	struct state *s = self->state;

	(void)sim;
	for (int c = 0; c < 3; c++)
		store_acceleration(s, fluid, c, dt, s->size > 0);
	s->size = fluid->grid.size;
	return TS_OK;
}

/* For another grid: they are not known before the next step of the fluid. */
static enum ts_status make_fields(struct state *s, struct tsim *sim)
{
	const struct ts_fluid *fluid = s->mass.force.fluid;
	const size_t size = fluid && s->mass.accelerates ? fluid->grid.size : 0;

	if (s->size == size)
		return TS_OK;
	s->size = 0;
	for (int c = 0; c < 3; c++) {
		if (TS_GROW(s->last[c], s->capacity[0][c], size) != TS_OK ||
		    TS_GROW(s->rate[c], s->capacity[1][c], size) != TS_OK)
			return ts_nomem(&sim->error);
		ts_grid_field_clear(s->last[c], 0, size);
		ts_grid_field_clear(s->rate[c], 0, size);
	}
	return TS_OK;
}

static void list_fields(struct ts_instance *self, struct ts_flow_part_fields *out)
{
	struct state *s = self->state;

	for (int c = 0; c < 3 && s->mass.force.part.after_substep; c++) {
		out->plane[c] = s->last[c];
		out->near[c] = s->rate[c];
	}
}

/* Refuses two of these fixes on one particle, as each would count the force of the other as an
 * accelerating force; and members of rigid bodies, whose acceleration is not f/m. */
static enum ts_status check_particles(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_particles *p = sim->particles;
	const struct ts_instance *other;
	double member = INFINITY; /* the least of all ranks */

	for (size_t k = 0; (other = ts_flow_part_named(sim, "added_mass", &k));)
		if (!ts_streq(other->id, self->id) &&
		    ts_ranks_most(sim, ts_groups_meet(p, other->group, self->group)) > 0)
			return ts_fail(&sim->error, TS_STATE, &self->where,
				       "fix added_mass: fix %s (%s:%d) gives particles of this group an "
				       "added mass already: a particle can have one",
				       other->id, TS_FILE_AND_LINE(other->where));
	for (size_t i = 0; i < p->n; i++)
		if (ts_in_group(p, i, self->group) && ts_rigid_member(p, i))
			member = fmin(member, p->tag[i]);
	member = -ts_ranks_most(sim, -member);
	if (isinf(member))
		return TS_OK;
	return ts_fail(&sim->error, TS_STATE, &self->where,
		       "fix added_mass: particle %.0f belongs to a rigid body, which does not follow the "
		       "force on one of its spheres: use a group without bodies",
		       member);
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	TS_TRY(ts_coupling_force_init(self, sim));
	TS_TRY(check_particles(self, sim));
	TS_TRY(ts_restraints_find(&s->restraints, sim, self, true));
	s->mass.force.part.after_substep =
		s->mass.force.fluid && s->mass.accelerates ? store_fluid_acceleration : NULL;
	s->mass.force.part.fields = list_fields;
	return make_fields(s, sim);
}

/* fix flow/pressure_gradient reports the limits of both together. */
static enum ts_status plan(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report)
{
	size_t k = 0;

	return ts_flow_part_named(sim, "flow/pressure_gradient", &k)
		       ? TS_OK
		       : ts_lagged_inertia_report(self, sim, false, report);
}

static enum ts_status archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a)
{
	static const char *const names[2][3] = { { "lastx", "lasty", "lastz" },
						 { "ratex", "ratey", "ratez" } };
	struct state *s = self->state;

	ts_flow_complete(sim);
	TS_TRY(ts_coupling_force_archive(self, sim, a));
	for (int c = 0; c < 3; c++) {
		TS_TRY(ts_archive_array(a, names[0][c], TS_SAVED_F64, (void **)&s->last[c],
					&s->capacity[0][c], &s->size));
		TS_TRY(ts_archive_array(a, names[1][c], TS_SAVED_F64, (void **)&s->rate[c],
					&s->capacity[1][c], &s->size));
	}
	return TS_OK;
}

static void fini(struct ts_instance *self)
{
	struct state *s = self->state;

	ts_coupling_force_fini(self);
	ts_restraints_release(&s->restraints);
	for (int c = 0; c < 3; c++) {
		ts_free(s->last[c]);
		ts_free(s->rate[c]);
	}
}

static const struct ts_arg args[] = {
	TS_REAL("coefficient", struct state, mass.coefficient, .fallback = "0.5", .range = TS_NOT_NEGATIVE,
		.unit = "", .help = "added mass as a fraction of the displaced mass of fluid"),
	TS_BOOL("fluid_acceleration", struct state, mass.accelerates, .fallback = "yes",
		.help = "whether Du/Dt is included; no: the fluid is assumed steady and uniform"),
	TS_COUPLING_FORCE_ARGS(struct state, mass.force),
	TS_ARGS_END,
};

TS_STYLE(fix, ts_coupling_force_style, ts_fix_added_mass)
const struct ts_coupling_force_style ts_fix_added_mass = {
	.style = {
		.name = "added_mass",
		.summary = "Added-mass force on accelerated particles",
		.doc = "F = C rho V_p (Du/Dt - dv/dt), with C = 1/2 for a sphere. dv/dt is the\n"
			"acceleration by all forces including this one, (f + C rho V_p Du/Dt)/(m + C rho\n"
			"V_p), so that the particle moves like one of mass m + C rho V_p. This is stable\n"
			"also if the particle is lighter than the fluid. In a dense bed with fix\n"
			"void_fraction the fluid learns the acceleration a step later, and Du/Dt is that of\n"
			"the step before: where velocities grow by it at any time step a warning is given,\n"
			"and `fluid_acceleration no` helps (doc/coupling.md). The force is applied after all\n"
			"others, regardless of the order in the script; drags with scheme exact or\n"
			"implicit take the added mass into account. Du/Dt = du/dt + u grad u at the\n"
			"particle, with du/dt over the last step of the fluid. A fluid that is solved for\n"
			"loses the momentum that the particles gain. f_ID[1] ... [3] is the total force.\n\n"
			"Two of these fixes on one particle, and particles in rigid bodies, are refused.",
		.example = "flow_style uniform velocity 0 0 0 viscosity 1.0e-3 density 1000\n"
			   "fix heavy all added_mass",
		.cite = "T. R. Auton, J. C. R. Hunt, M. Prud'homme, J. Fluid Mech. 197 (1988) 241",
		.args = args,
		.state_size = sizeof(struct state),
		.init = init,
		.archive = archive,
		.fini = fini,
		TS_COUPLING_FORCE_SLOTS,
		.late = { [TS_LATE_INERTIA] = apply_inertia },
		.ground = add_ground,
		.plan = plan,
	},
	.force = add_force,
	.sheared = true,
};
