#include "coupling/drag_force.h"

#include <math.h>
#include <string.h>

#include "core/ranks.h"
#include "core/sim.h"
#include "coupling/drag_exchange.h"
#include "coupling/drag_slip.h"
#include "coupling/near_particles.h"
#include "coupling/outside_grid.h"
#include "integrate/integrators.h"
#include "particle/particles.h"
#include "particle/sphere_shape.h"
#include "rigid/rigid.h"

#include "base/banned.h"

const char *const ts_drag_schemes[] = { "explicit", "exact", "implicit", NULL };

static enum ts_status check_numbers(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_drag *s = self->state;
	const struct ts_drag_style *style = ts_drag_style_of(self);
	const struct ts_flow_style *flow = ts_flow_style_of(s->flow);
	const char *name = self->style->name;
	size_t k = 0;

	if (style->inertial && !(flow->density(s->flow) > 0))
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "fix %s needs a fluid with a density: give flow_style %s one", name,
			       s->flow->style->name);
	if (style->inertial)
		TS_TRY(ts_flow_require_viscosity(sim, self, s->flow));
	if (style->crowded && isnan(s->fraction) &&
	    !(s->fluid && s->fluid->void_fraction && ts_flow_part_named(sim, "void_fraction", &k)))
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "fix %s needs the void fraction: put a fix void_fraction before it (with "
			       "flow_style projection), or give one with `void`",
			       name);
	return TS_OK;
}

/* ---- set-up. Schemes exact and implicit act after all other forces */

bool ts_drag_is_late(const struct ts_instance *self)
{
	return ((const struct ts_drag *)self->state)->scheme != TS_DRAG_EXPLICIT;
}

/* Lists all drags with schemes exact or implicit: several of them on one particle are combined. */
static enum ts_status find_relaxing_drags(struct ts_instance *self, struct tsim *sim)
{
	struct ts_drag *s = self->state;
	struct ts_instance *part;

	s->nlate = 0;
	for (size_t k = 0; (part = ts_sim_next_of(sim, TS_KIND_FIX, TS_FAMILY_FLOW_PART, &k));) {
		if (part->style->late[TS_LATE_RELAX] != ts_drag_relax || !ts_drag_is_late(part))
			continue;
		if (TS_GROW(s->late, s->late_capacity, s->nlate + 1) != TS_OK)
			return ts_nomem(&sim->error);
		s->late[s->nlate++] = part->state;
	}
	return TS_OK;
}

enum ts_status ts_drag_init(struct ts_instance *self, struct tsim *sim)
{
	struct ts_drag *s = self->state;

	s->flow = ts_sim_only(sim, TS_KIND_FLOW);
	if (!s->flow)
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "fix %s needs a fluid: use flow_style before it", self->style->name);
	s->fluid = NULL;
	s->part.order = NULL;
	s->sorted = false;
	if (ts_flow_style_of(s->flow)->fluid)
		TS_TRY(ts_flow_require_fluid(sim, self->style->name, &self->where, &s->fluid));
	s->part.after_step = s->fluid && s->two_way && !s->lagged ? ts_drag_correct : NULL;
	if (s->fluid && s->two_way)
		TS_TRY(ts_fluid_require_fields(s->fluid, sim,
					       s->lagged ? TS_FLUID_FORCE
							 : TS_FLUID_FORCE | TS_FLUID_EXCHANGE));
	s->part.sends = (struct ts_flow_part_sends){ .nearby = true };
	if (s->fluid && s->two_way) {
		s->part.order = &s->order;
		s->part.sends = (struct ts_flow_part_sends){
			.particles = true, .numbers = s->lagged ? 3 : 6, .reaction = true, .nearby = true
		};
	}
	s->added = ts_added_mass_find(sim);
	TS_TRY(find_relaxing_drags(self, sim));
	TS_TRY(ts_restraints_find(&s->restraints, sim, self, ts_drag_is_late(self)));
	s->moving_groups = ts_integrated_groups(sim, TS_MOVES);
	return check_numbers(self, sim);
}

/* ---- explicit part, before all forces are known */

struct drag_diagnostics {
	double reynolds, stiffness; /* Re; c h/m if the force is explicit */
	struct ts_coupling_outside outside;
};

/* Slope of the force for the exchange over several steps: not larger than `most`, which takes the particle
 * to the velocity of the fluid; `part`: fraction of the force that is effective, the rest of the motion is
 * prescribed. */
static double exchange_slope(double steps, double slope, double most, double c, double part)
{
	const double limit = most > slope ? most : slope;
	const double moving = steps * slope < limit ? steps * slope : limit;

	return part == 1 ? moving : part * moving + (1 - part) * steps * c;
}

/* Fraction of a force along each axis that is effective along it after the restraints. */
static void unrestrained_fractions(const struct ts_drag *s, const struct tsim *sim, size_t i, double part[3])
{
	for (int k = 0; k < 3; k++) {
		double f[3] = { k == 0, k == 1, k == 2 };

		ts_restraints_apply(&s->restraints, sim, i, f);
		part[k] = f[k];
	}
}

static double greater(double a, double b)
{
	return b > a ? b : a;
}

/* Called with each particle just before its numbers are set, so that they are in the cache. */
static inline void clear_numbers(struct ts_drag *s, size_t i)
{
	memset(s->total.note[i], 0, sizeof *s->total.note);
	if (s->fluid && s->two_way)
		s->exchange[i] = (struct ts_drag_exchange){ .slope = { 0 } };
}

static bool acts_alone(const struct ts_drag *s)
{
	return s->nlate == 1 && !s->restraints.n && ts_drag_acts_along(s, 0) && ts_drag_acts_along(s, 1) &&
	       ts_drag_acts_along(s, 2);
}

/* Applies the explicit force to particle i; most: its mass by the time step. */
static void apply_explicitly(struct ts_drag *s, const struct tsim *sim, size_t i, double c, const double w[3],
			     double most, bool held)
{
	struct ts_particles *p = sim->particles;
	const double steps = s->part.after_step ? ts_drag_steps_to_fluid(s) : 0;
	double part[3] = { 0 };

	if (s->part.after_step && !held)
		unrestrained_fractions(s, sim, i, part);
	for (int k = 0; k < 3; k++) {
		const double f = c * w[k];

		if (!ts_drag_acts_along(s, k))
			continue;
		p->f[i][k] += f;
		s->total.note[i][k] = f;
		if (s->part.after_step && !ts_rigid_member(p, i))
			s->exchange[i].slope[k] = exchange_slope(steps, c, most, c, part[k]);
	}
}

/* Of the force of a drag that relaxes particle i only the part that restraints remove is applied, so that the fix that
 * removes it accounts for it. */
static void apply_restrained(struct ts_drag *s, const struct tsim *sim, size_t i, double c, const double w[3])
{
	struct ts_particles *p = sim->particles;
	double f[3], later[3];

	for (int k = 0; k < 3; k++)
		later[k] = f[k] = ts_drag_acts_along(s, k) ? c * w[k] : 0;
	ts_restraints_apply(&s->restraints, sim, i, later);
	for (int k = 0; k < 3; k++)
		if (ts_drag_acts_along(s, k) && later[k] != f[k]) {
			p->f[i][k] += f[k] - later[k];
			s->total.note[i][k] = f[k] - later[k];
		}
}

static void apply_drag(const struct ts_instance *self, const struct tsim *sim, size_t i,
		       const struct ts_slip *slip, const double w[3], struct drag_diagnostics *found)
{
	struct ts_drag *s = self->state;
	const double c = ts_drag_coefficient(self, sim, slip);
	const bool held = ts_drag_motion_prescribed(s, sim, i);
	double most;

	if (slip->viscosity > 0)
		found->reynolds = greater(found->reynolds, ts_slip_reynolds(slip));
	if (s->scheme != TS_DRAG_EXPLICIT && !held && !ts_rigid_member(sim->particles, i)) {
		s->relaxation[i] = (struct ts_drag_relaxation){ c, { w[0], w[1], w[2] } };
		if (!s->alone || c == 0)
			clear_numbers(s, i);
		if (s->restraints.n)
			apply_restrained(s, sim, i, c, w);
		return;
	}
	clear_numbers(s, i);
	most = ts_drag_mass(s, sim, i) / sim->clock.dt;
	apply_explicitly(s, sim, i, c, w, most, held);
	if (!held)
		found->stiffness = greater(found->stiffness, c / most);
}

static enum ts_status allocate_work(struct ts_drag *s, struct tsim *sim)
{
	size_t n = sim->particles->n;

	s->nexchange = 0;
	if (s->scheme != TS_DRAG_EXPLICIT && TS_GROW(s->relaxation, s->relaxation_capacity, n) != TS_OK)
		return ts_nomem(&sim->error);
	if (!s->fluid || !s->two_way)
		return TS_OK;
	return TS_GROW(s->exchange, s->exchange_capacity, n) == TS_OK ? TS_OK : ts_nomem(&sim->error);
}

static enum ts_status pass_to_fluid(struct ts_instance *self, struct tsim *sim)
{
	struct ts_drag *s = self->state;
	enum ts_status status = TS_OK;

	if (s->fluid && s->two_way && !sim->run.in_setup)
		status = ts_drag_add_to_fluid(self, sim);
	s->sorted = false;
	return status;
}

/* Of the particles of the group from .. on, TS_DRAG_BATCH at most. */
static void apply_drags(const struct ts_instance *self, const struct tsim *sim, size_t from,
			struct ts_drag_slips *slips, struct drag_diagnostics *found)
{
	struct ts_drag *s = self->state;
	const struct ts_particles *p = sim->particles;

	slips->n = 0;
	for (size_t i = from; i < p->n && i < from + TS_DRAG_BATCH; i++) {
		if (s->scheme != TS_DRAG_EXPLICIT)
			s->relaxation[i] = (struct ts_drag_relaxation){ .c = 0 };
		if (ts_in_group(p, i, self->group))
			slips->of[slips->n++] = i;
		else
			clear_numbers(s, i);
	}
	ts_drag_find_slips(self, p, slips);
	for (size_t k = 0; k < slips->n; k++) {
		const size_t i = slips->of[k];

		if (slips->inside[k]) {
			apply_drag(self, sim, i, &slips->slip[k], slips->w[k], found);
			continue;
		}
		clear_numbers(s, i);
		ts_coupling_outside_add(&found->outside, p, i);
	}
}

static struct drag_diagnostics apply_all_drags(const struct ts_instance *self, struct tsim *sim)
{
	const struct ts_drag *s = self->state;
	const struct ts_flow_style *flow = ts_flow_style_of(s->flow);
	const double density = flow->density(s->flow), viscosity = flow->viscosity(s->flow);
	const size_t n = sim->particles->n;
	double reynolds = 0, stiffness = 0;
	int64_t tag = INT64_MAX;
	size_t outside = 0;

#pragma omp parallel for num_threads(ts_team(sim, n)) schedule(static) \
	reduction(max : reynolds, stiffness) reduction(+ : outside) reduction(min : tag)
	for (size_t i = 0; i < n; i += TS_DRAG_BATCH) {
		struct drag_diagnostics found = { reynolds, stiffness, { 0, tag } };
		struct ts_drag_slips slips;

		slips.density = density;
		slips.viscosity = viscosity;
		apply_drags(self, sim, i, &slips, &found);
		reynolds = found.reynolds;
		stiffness = found.stiffness;
		outside += found.outside.n;
		tag = found.outside.tag;
	}
	return (struct drag_diagnostics){ reynolds, stiffness, { outside, tag } };
}

enum ts_status ts_drag_post_force(struct ts_instance *self, struct tsim *sim)
{
	struct ts_drag *s = self->state;
	struct drag_diagnostics found;

	TS_TRY(allocate_work(s, sim));
	if (!(ts_flow_style_of(s->flow)->viscosity(s->flow) > 0))
		return ts_particle_tally_start(sim, &s->total);
	if (s->fluid && s->two_way) {
		TS_TRY(ts_cell_order_make(&s->order, sim, s->fluid, self->group, 1));
		s->sorted = true;
	}
	TS_TRY(ts_near_particles_ready(s->fluid, sim));
	TS_TRY(ts_restraints_prepare(&s->restraints, sim));
	TS_TRY(ts_particle_tally_start_unset(sim, &s->total)); /* set with each particle */
	s->alone = acts_alone(s);
	found = apply_all_drags(self, sim);
	if (s->fluid)
		TS_TRY(ts_coupling_count_outside(s->fluid, sim, self, found.outside.n, found.outside.tag));
	s->reynolds = found.reynolds;
	if (found.stiffness > 2 && ts_drag_style_of(self)->inertial && !sim->run.unsafe)
		return ts_fail(&sim->error, TS_PHYSICS, &self->where,
			       "fix %s: a particle's velocity relaxes in %g, the explicit drag is stable for "
			       "steps below twice that, and the step is %g: use scheme exact, or a smaller "
			       "`timestep`",
			       self->style->name, sim->clock.dt / found.stiffness, sim->clock.dt);
	return ts_drag_is_late(self) ? TS_OK : pass_to_fluid(self, sim);
}

/* ---- schemes exact and implicit, after all other forces */

/* B of one drag with the coefficient c, on a particle on which other forces act. */
static double drag_slope(int scheme, double c, double mass, double h)
{
	double rate = c / mass;

	if (!(c > 0))
		return c;
	return scheme == TS_DRAG_EXACT ? mass * -expm1(-h * rate) / h : c / (1 + h * rate);
}

/* Its component for the sum f of the other forces. */
static double drag_component(int scheme, double c, double slope, double w, double f, double mass, double h)
{
	if (!(c > 0))
		return c * w;
	return scheme == TS_DRAG_EXACT ? slope * (w + f / c) - f : slope * (w - h * f / mass);
}

/* Combines several drags on one particle into one with the coefficient C = sum c and the fluid velocity
 * (sum c u)/C. Its force minus sum c (u - v) is C times the change of the mean slip over the step, which
 * is the same for all of them. The scheme is implicit if one of them is. */
static void combine_drags(const struct ts_drag *first, const struct tsim *sim, size_t i)
{
	const struct ts_particles *p = sim->particles;
	struct ts_drag_combined *combined = &first->combined[i];
	double mass = ts_drag_mass(first, sim, i);
	int scheme = TS_DRAG_EXACT;
	bool some = false;

	memset(combined, 0, sizeof *combined);
	for (size_t j = 0; j < first->nlate; j++) {
		bool acts = first->late[j]->relaxation[i].c != 0;

		some |= acts;
		if (acts && first->late[j]->scheme == TS_DRAG_IMPLICIT)
			scheme = TS_DRAG_IMPLICIT;
	}
	for (int k = 0; k < 3 && some; k++) {
		double c = 0, cw = 0, slope, force;

		for (size_t j = 0; j < first->nlate; j++)
			if (ts_drag_acts_along(first->late[j], k)) {
				c += first->late[j]->relaxation[i].c;
				cw += first->late[j]->relaxation[i].c * first->late[j]->relaxation[i].w[k];
			}
		if (c == 0)
			continue;
		slope = drag_slope(scheme, c, mass, sim->clock.dt);
		force = drag_component(scheme, c, slope, cw / c, p->f[i][k], mass, sim->clock.dt);
		combined->slip[k] = (force - cw) / c;
		combined->part[k] = slope / c;
		combined->c[k] = c;
	}
}

static enum ts_status combine_all_drags(struct ts_drag *first, struct tsim *sim)
{
	size_t n = sim->particles->n;

	if (TS_GROW(first->combined, first->combined_capacity, n) != TS_OK)
		return ts_nomem(&sim->error);
#pragma omp parallel for num_threads(ts_team(sim, n)) schedule(static)
	for (size_t i = 0; i < n; i++)
		combine_drags(first, sim, i);
	return TS_OK;
}

/* relax_particle for the only drag, without restraints, along all axes. */
static void relax_alone(struct ts_drag *s, const struct tsim *sim, size_t i, double steps)
{
	struct ts_particles *p = sim->particles;
	const struct ts_drag_relaxation *mine = &s->relaxation[i];
	const double mass = ts_drag_mass(s, sim, i), h = sim->clock.dt;
	const double slope = drag_slope(s->scheme, mine->c, mass, h);
	const double exchange = exchange_slope(steps, slope, mass / h, mine->c, 1);

	for (int k = 0; k < 3; k++) {
		const double force =
			drag_component(s->scheme, mine->c, slope, mine->w[k], p->f[i][k], mass, h);

		p->f[i][k] += force;
		s->total.note[i][k] = 0 + force; /* no -0 */
	}
	s->total.note[i][3] = 0;
	for (int k = 0; k < 3 && s->fluid && s->two_way; k++)
		s->exchange[i].slope[k] = s->part.after_step ? exchange : 0;
}

static void relax_particle(const struct ts_instance *self, struct tsim *sim, size_t i)
{
	struct ts_drag *s = self->state;
	struct ts_particles *p = sim->particles;
	const struct ts_drag_relaxation *mine = &s->relaxation[i];
	const struct ts_drag_combined *combined = s->nlate > 1 ? &s->late[0]->combined[i] : NULL;
	double force[3] = { 0 }, part[3] = { 1, 1, 1 }, mass = ts_drag_mass(s, sim, i), h = sim->clock.dt;
	double steps = s->part.after_step ? ts_drag_steps_to_fluid(s) : 0;
	double alone = combined ? 0 : drag_slope(s->scheme, mine->c, mass, h);

	if (s->part.after_step && s->restraints.n)
		unrestrained_fractions(s, sim, i, part);
	for (int k = 0; k < 3; k++) {
		double slope, all = combined ? combined->c[k] : mine->c;

		if (!ts_drag_acts_along(s, k))
			continue;
		if (combined) {
			force[k] = mine->c * (mine->w[k] + combined->slip[k]);
			slope = mine->c * combined->part[k];
		} else {
			slope = alone;
			force[k] = drag_component(s->scheme, mine->c, slope, mine->w[k], p->f[i][k], mass, h);
		}
		if (s->part.after_step)
			s->exchange[i].slope[k] =
				exchange_slope(steps, slope, mine->c / all * mass / h, mine->c, part[k]);
	}
	ts_restraints_apply(&s->restraints, sim, i, force);
	for (int k = 0; k < 3; k++) {
		p->f[i][k] += force[k];
		s->total.note[i][k] += force[k];
	}
}

enum ts_status ts_drag_relax(struct ts_instance *self, struct tsim *sim)
{
	struct ts_drag *s = self->state;
	const struct ts_particles *p = sim->particles;
	const double steps = s->part.after_step ? ts_drag_steps_to_fluid(s) : 0;

	if (!(ts_flow_style_of(s->flow)->viscosity(s->flow) > 0))
		return TS_OK;
	if (s->nlate > 1 && s->late[0] == s)
		TS_TRY(combine_all_drags(s, sim));
#pragma omp parallel for num_threads(ts_team(sim, p->n)) schedule(static)
	for (size_t i = 0; i < p->n; i++) {
		if (s->relaxation[i].c == 0)
			continue;
		if (s->alone)
			relax_alone(s, sim, i, steps);
		else
			relax_particle(self, sim, i);
	}
	return pass_to_fluid(self, sim);
}

enum ts_status ts_drag_archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a)
{
	struct ts_drag *s = self->state;

	(void)sim;
	TS_TRY(ts_particle_tally_archive(a, &s->total));
	if (!ts_archive_writing(a) && !ts_archive_has(a, "reynolds"))
		return TS_OK;
	return ts_archive_fixed(a, "reynolds", TS_SAVED_F64, &s->reynolds, 1);
}

enum ts_status ts_drag_join(struct ts_instance *self, struct tsim *sim)
{
	struct ts_drag *s = self->state;

	s->reynolds = ts_ranks_most(sim, s->reynolds);
	return ts_particle_tally_merge(&s->total, sim);
}

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	struct ts_drag *s = self->state;

	(void)sim;
	memcpy(out->data, ts_particle_tally_sums(&s->total), 3 * sizeof *out->data);
	out->data[3] = s->reynolds;
	return TS_OK;
}

static const char *const columns[] = { "x", "y", "z", "Re" };
const struct ts_value ts_drag_values[] = {
	{ "drag", "force", "total drag on the particles (x y z), the largest Reynolds number", TS_VECTOR, 4,
	  columns, eval },
	{ .name = NULL },
};

void ts_drag_fini(struct ts_instance *self)
{
	struct ts_drag *s = self->state;

	ts_cell_order_release(&s->order);
	ts_particle_tally_release(&s->total);
	ts_restraints_release(&s->restraints);
	ts_free(s->both);
	ts_free(s->exchange);
	ts_free(s->relaxation);
	ts_free(s->combined);
	ts_free(s->late);
}
