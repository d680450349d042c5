#include "coupling/coupling_force.h"

#include <math.h>
#include <string.h>

#include "core/ranks.h"
#include "core/review.h"
#include "coupling/interpolation_faces.h"
#include "coupling/lagged_inertia.h"
#include "coupling/stencil_batch.h"
#include "coupling/volume_distribution.h"
#include "flow/projection.h"
#include "force/restraint.h"
#include "group/group_members.h"
#include "particle/particles.h"
#include "particle/sphere_shape.h"
#include "rigid/rigid.h"

#include "base/banned.h"

enum { BY_VOLUME = 2 }; /* of interpolation */
static const char *const interpolations[] = { "linear", "cell", "volume", NULL };

struct state {
	struct ts_coupling_force force; /* first */
	int interpolation, how;
	const struct ts_instance *void_fix; /* the fix that computes the void fraction */
	struct ts_restraints restraints;
};

/* ---- interpolation volume: the gradients of cells weighted by the volume of the particle in them
 *
 * A face belongs half to each of its two cells. So the particles together take the fraction (1 - e) of the
 * gradient at each face, and the fluid the rest. */

struct gradient_sum {
	const struct ts_fluid *fluid;
	const double *p;
	double f[3];
};

static double face_gradient(const struct gradient_sum *sum, int d, size_t at, int i)
{
	const struct ts_grid *grid = &sum->fluid->grid;

	return (sum->p[at] - sum->p[at - (size_t)grid->stride[d]]) / grid->gap[d][i];
}

static void add_cell(void *context, const int cell[3], double volume)
{
	struct gradient_sum *sum = context;
	const struct ts_grid *grid = &sum->fluid->grid;
	const size_t at = ts_at(grid, cell[0], cell[1], cell[2]);

	for (int d = 0; d < grid->dimensions; d++) {
		bool low = grid->periodic[d] || cell[d] > 0,
		     high = grid->periodic[d] || cell[d] < grid->n[d] - 1;
		double below = low ? face_gradient(sum, d, at, cell[d]) : 0;
		double above =
			high ? face_gradient(sum, d, at + (size_t)grid->stride[d], cell[d] + 1) : below;

		sum->f[d] -= volume * 0.5 * ((low ? below : above) + above);
	}
}

static void force_by_volume(const struct state *s, const struct tsim *sim, size_t i, const double place[3],
			    const int cell[3], const double *p, double f[3])
{
	const struct ts_fluid *fluid = s->force.fluid;
	struct gradient_sum sum = { .fluid = fluid, .p = p };
	struct ts_coupling_volume how;

	((const struct ts_flow_part *)s->void_fix->state)->volume_distribution(s->void_fix, sim, &how);
	ts_coupling_volume_each_cell(&fluid->grid, &how, place, cell, sim->particles->radius[i], add_cell,
				     &sum);
	for (int d = 0; d < 3; d++)
		f[d] = fluid->grid.by_depth ? sum.f[d] / fluid->grid.width[2][0] : sum.f[d];
}

static void add_force(const struct ts_instance *self, const struct tsim *sim, size_t i,
		      const struct ts_coupling_local_flow *around, double f[3], double torque[3])
{
	const struct state *s = self->state;
	const struct ts_fluid *fluid = s->force.fluid;
	double volume = ts_particle_volume(sim, sim->particles->radius[i]);
	struct ts_coupling_place at = { .how = (enum ts_coupling_interpolation)s->how };
	double gradient[3];

	(void)torque;
	if (s->how == BY_VOLUME) {
		force_by_volume(s, sim, i, around->place, around->cell, fluid->p, f);
		return;
	}
	memcpy(at.x, around->place, sizeof at.x);
	memcpy(at.cell, around->cell, sizeof at.cell);
	ts_coupling_faces_gradient(fluid, &at, fluid->p, gradient);
	for (int c = 0; c < fluid->grid.dimensions; c++)
		f[c] = -volume * gradient[c];
}

/* ---- many particles at once, interpolation linear */

static void add_forces(const struct ts_instance *self, const struct tsim *sim, const size_t *of, size_t n,
		       double (*f)[3], bool *inside)
{
	const struct state *s = self->state;
	const struct ts_particles *p = sim->particles;
	double gradient[3][TS_STENCIL_BATCH];
	struct ts_stencil_batch batch;

	_Static_assert((int)TS_COUPLING_FORCE_BATCH <= (int)TS_STENCIL_BATCH, "all are a batch");
	ts_stencil_batch_find(&batch, &s->force.fluid->grid, (const double(*)[3])p->x, of, n);
	ts_stencil_batch_gradient(&batch, s->force.fluid, s->force.fluid->p, gradient, inside);
	for (size_t k = 0; k < n; k++) {
		const double volume = ts_particle_volume(sim, p->radius[of[k]]);

		for (int c = 0; c < 3; c++)
			f[k][c] = -volume * gradient[c][k];
	}
}

/* ---- correction by the pressure of the step, which is known after it */

static void correct_particle(struct ts_instance *self, const struct tsim *sim, size_t i, double share)
{
	struct state *s = self->state;
	struct ts_particles *p = sim->particles;
	double *note = s->force.total.note[i], place[3], more[3];
	int cell[3];

	if (!ts_coupling_locate(s->force.fluid, p->x[i], place, cell))
		return;
	force_by_volume(s, sim, i, place, cell, s->force.fluid->p_mean, more);
	for (int k = 0; k < 3; k++) {
		more[k] -= note[k];
		note[k] += more[k];
	}
	ts_restraints_apply(&s->restraints, sim, i, more);
	for (int k = 0; k < 3; k++)
		p->f[i][k] += share * more[k];
}

static enum ts_status correct_forces(struct ts_instance *self, struct tsim *sim, struct ts_fluid *fluid,
				     double length)
{
	struct state *s = self->state;
	const struct ts_particles *p = sim->particles;
	const double share = 1 / ts_fluid_kick_fraction(sim);

	(void)fluid;
	(void)length;
	if (s->force.total.n != p->n)
		return TS_OK;
	TS_TRY(ts_restraints_prepare(&s->restraints, sim));
	s->force.total.fresh = true;
#pragma omp parallel for num_threads(ts_team(sim, p->n)) schedule(static)
	for (size_t i = 0; i < p->n; i++)
		if (ts_in_group(p, i, self->group) && p->imass[i] != 0 && !ts_rigid_member(p, i))
			correct_particle(self, sim, i, share);
	return TS_OK;
}

/* ---- set-up */

static const struct ts_instance *find_void_fix(const struct tsim *sim)
{
	const struct ts_instance *part;

	for (size_t k = 0; (part = ts_sim_next_of(sim, TS_KIND_FIX, TS_FAMILY_FLOW_PART, &k));)
		if (((const struct ts_flow_part *)part->state)->volume_distribution)
			return part;
	return NULL;
}

static enum ts_status refuse_another(const struct ts_instance *self, struct tsim *sim)
{
	const struct ts_instance *other;

	for (size_t k = 0; (other = ts_flow_part_named(sim, self->style->name, &k));)
		if (!ts_streq(other->id, self->id) &&
		    ts_ranks_most(sim, ts_groups_meet(sim->particles, other->group, self->group)) > 0)
			return ts_fail(&sim->error, TS_STATE, &self->where,
				       "fix flow/pressure_gradient: the pressure acts on particles of this "
				       "group by fix %s (%s:%d) already: use groups without common "
				       "particles, or leave out one of the two",
				       other->id, TS_FILE_AND_LINE(other->where));
	return TS_OK;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	bool whole;

	TS_TRY(ts_coupling_force_init(self, sim));
	TS_TRY(refuse_another(self, sim));
	s->force.part.sends.pressure = true;
	s->void_fix = find_void_fix(sim);
	whole = s->void_fix && ts_streq(s->force.flow->style->family, TS_FAMILY_PROJECTION) &&
		((const struct ts_projection *)s->force.flow->state)->form == TS_FORM_CONSERVATIVE;
	s->how = s->interpolation >= 0 ? s->interpolation : whole ? BY_VOLUME : TS_INTERPOLATE_LINEAR;
	if (s->how == BY_VOLUME && !s->void_fix)
		return ts_fail(&sim->error, TS_STATE, ts_instance_word(self, "volume"),
			       "fix flow/pressure_gradient: interpolation volume needs a fix void_fraction, "
			       "which says where the volume is");
	s->force.batches = ts_stencil_batch_possible(s->force.fluid, s->how);
	s->force.part.after_step = s->how == BY_VOLUME && whole ? correct_forces : NULL;
	TS_TRY(ts_restraints_find(&s->restraints, sim, self, false));
	return s->force.part.after_step ? ts_fluid_require_fields(s->force.fluid, sim, TS_FLUID_P_MEAN)
					: TS_OK;
}

/* In a box that is periodic on all sides total momentum should be constant: reports settings that do not
 * conserve it. */
static enum ts_status review(struct ts_instance *self, struct tsim *sim)
{
	const struct state *s = self->state;
	const struct ts_grid *grid = &s->force.fluid->grid;

	for (int d = 0; d < grid->dimensions; d++)
		if (!grid->periodic[d])
			return TS_OK;
	if (!s->void_fix || s->force.part.after_step || sim->review.steps <= 1)
		return TS_OK;
	return ts_review_report(sim, "momentum", &self->where,
				"the box is periodic in all directions, but with fix %s and fix %s the total "
				"momentum of particles and fluid drifts by 1e-3 to 1e-2 of the exchanged "
				"momentum; use `flow_style projection ... form conservative` and the default "
				"`interpolation` of this fix, which conserve it to round-off",
				self->style->name, s->void_fix->style->name);
}

static enum ts_status plan(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report)
{
	return ts_lagged_inertia_report(self, sim, true, report);
}

static void fini(struct ts_instance *self)
{
	ts_restraints_release(&((struct state *)self->state)->restraints);
	ts_coupling_force_fini(self);
}

static const struct ts_arg args[] = {
	TS_ENUM("interpolation", struct state, interpolation, interpolations, .flags = TS_OPTIONAL,
		.help = "how the gradient is evaluated at the particle: interpolated between faces, mean of "
			"its cell, or mean over the cells weighted by the volume of the particle in them; "
			"default linear, with form conservative and fix void_fraction volume"),
	TS_ARGS_END,
};

TS_STYLE(fix, ts_coupling_force_style, ts_fix_flow_pressure_gradient)
const struct ts_coupling_force_style ts_fix_flow_pressure_gradient = {
	.style = {
		.name = "flow/pressure_gradient",
		.summary = "force of the fluid's pressure gradient on each particle",
		.doc = "F = -V_p grad p. The gradient is interpolated from the faces of cells; next to a\n"
			"boundary the gradient on the nearest inner face is used. If the weight of the\n"
			"fluid is part of its equations (flow_style projection, keyword `body_force`) and\n"
			"balanced by walls, this force contains the buoyancy; otherwise add fix buoyancy.\n\n"
			"No reaction is applied to the fluid. With fix void_fraction its equation contains\n"
			"-e grad p, and the particles take the rest of -grad p. Without, the fluid also\n"
			"occupies the volume of the particle, and that part of the fluid follows the\n"
			"gradient. With flow_style projection form conservative and fix void_fraction the\n"
			"gradient is the mean over the cells in which the volume of the particle lies\n"
			"(`interpolation volume`), of the pressure that acts on the fluid in the same\n"
			"step: the momentum of particles and fluid together is conserved to round-off.\n"
			"Otherwise its relative error is 1e-3 to 1e-2; doc/coupling.md gives the reason.\n"
			"Particles that are held and members of rigid bodies get the pressure of the\n"
			"previous step. f_ID[1] ... [3] is the total force.\n\n"
			"The gradient is that of the step before. With fix void_fraction the velocities of\n"
			"particles and fluid then grow at any time step where the particles are lighter\n"
			"than phi/(1 - phi) of the fluid, with phi their volume fraction in a cell; a\n"
			"warning tells where, and whether fix added_mass stabilises them. See\n"
			"doc/coupling.md. Two of these fixes on one particle are refused.",
		.example = "flow_style projection cells 10 10 40 viscosity 1.8e-5 density 1.2 body_force 0 0 -9.81\n"
			   "fix lift all flow/pressure_gradient",
		.args = args,
		.state_size = sizeof(struct state),
		.init = init,
		.review = review,
		.plan = plan,
		.archive = ts_coupling_force_archive,
		.fini = fini,
		TS_COUPLING_FORCE_SLOTS,
	},
	.force = add_force,
	.forces = add_forces,
	.at_rest = true,
	.solved = true,
	.internal = true,
};
