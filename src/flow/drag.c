#include "flow/drag.h"

#include <math.h>
#include <string.h>

#include "core/plan.h"
#include "flow/added_mass.h"
#include "flow/projection.h"
#include "particles/body.h"
#include "particles/particles.h"
#include "particles/rigid.h"

#include "base/banned.h"

enum { EXPLICIT, EXACT, IMPLICIT };
const char *const ts_drag_schemes[] = { "explicit", "exact", "implicit", NULL };
const char *const ts_drag_axes[] = { "x", "y", "z", "xy", "xz", "yz", "xyz", NULL };
static const int axes_bits[] = { 1, 2, 4, 3, 5, 6, 7 };

static const struct ts_drag_style *style_of(const struct ts_instance *self)
{
	return (const struct ts_drag_style *)self->style;
}

static enum ts_status check_numbers(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_drag *s = self->state;
	const struct ts_drag_style *style = style_of(self);
	const struct ts_flow_style *flow = ts_flow_style_of(s->flow);
	const char *name = self->style->name;
	size_t k = 0;

	if (style->inertial && !(flow->density(s->flow) > 0))
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "fix %s needs a fluid with a density: give flow_style %s one", name,
			       s->flow->style->name);
	if (style->inertial && !(flow->viscosity(s->flow) > 0))
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "fix %s needs a fluid with a viscosity: give flow_style %s one", name,
			       s->flow->style->name);
	if (style->crowded && isnan(s->fraction) &&
	    !(s->fluid && s->fluid->empty && ts_flow_part_named(sim, "void_fraction", &k)))
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "fix %s needs the void fraction: put a fix void_fraction before it (with "
			       "flow_style projection), or give one with `void`",
			       name);
	return TS_OK;
}

static enum ts_status settle(struct ts_instance *self, struct tsim *sim, struct ts_fluid *fluid,
			     double length);

enum ts_status ts_drag_init(struct ts_instance *self, struct tsim *sim)
{
	struct ts_drag *s = self->state;

	s->flow = ts_sim_only(sim, TS_KIND_FLOW);
	if (!s->flow)
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "fix %s needs a fluid: use flow_style before it", self->style->name);
	s->fluid = NULL;
	if (ts_flow_style_of(s->flow)->fluid)
		TS_TRY(ts_flow_require_fluid(sim, self->style->name, &self->where, &s->fluid));
	s->part.settle = s->fluid && s->two_way && !s->lagged ? settle : NULL;
	if (s->fluid && s->two_way)
		TS_TRY(ts_fluid_want(s->fluid, sim,
				     s->lagged ? TS_FLUID_FORCE : TS_FLUID_FORCE | TS_FLUID_EXCHANGE));
	s->added = ts_added_density(sim, self->group);
	return check_numbers(self, sim);
}

static double void_at(const struct ts_drag *s, const double place[3], const int cell[3])
{
	const struct ts_fluid *fluid = s->fluid;

	if (!isnan(s->fraction))
		return s->fraction;
	if (s->interpolation == TS_INTERPOLATE_CELL)
		return fluid->empty[ts_at(&fluid->grid, cell[0], cell[1], cell[2])];
	return ts_fluid_value(fluid, fluid->empty, place, NULL);
}

static double mean(double wa, double wb, double a, double b)
{
	return (wa * a + wb * b) / (wa + wb);
}

/* Velocity of the cell: the mean of its faces; in a bed that of the flow e u through them, so that the slip in
 * a layer of the bed is the flow through it by its own void fraction. */
static void cell_velocity(const struct ts_fluid *fluid, const int cell[3], double u[3])
{
	const struct ts_grid *grid = &fluid->grid;
	const size_t at = ts_at(grid, cell[0], cell[1], cell[2]);
	const double *e = fluid->empty;

	for (int c = 0; c < 3; c++) {
		size_t s = c < grid->dimensions ? (size_t)grid->stride[c] : 0;
		double low = fluid->u[c][at], high = fluid->u[c][at + s];

		if (e && s) {
			const double *width = grid->width[c] + cell[c];

			low *= mean(width[-1], width[0], e[at - s], e[at]) / e[at];
			high *= mean(width[0], width[1], e[at], e[at + s]) / e[at];
		}
		u[c] = 0.5 * (low + high);
	}
}

/* The fluid where particle i is; false: there is none. */
static bool sample(const struct ts_instance *self, const struct ts_particles *p, size_t i,
		   struct ts_slip *slip, double w[3])
{
	const struct ts_drag *s = self->state;
	double place[3];
	int cell[3];

	if (!s->fluid) {
		ts_flow_style_of(s->flow)->velocity(s->flow, p->x[i], w);
	} else {
		if (!ts_fluid_place(s->fluid, p->x[i], place, cell))
			return false;
		if (s->interpolation == TS_INTERPOLATE_CELL)
			cell_velocity(s->fluid, cell, w);
		else
			ts_fluid_velocity(s->fluid, place, w);
	}
	for (int k = 0; k < 3; k++)
		w[k] -= p->v[i][k];
	slip->diameter = 2 * p->radius[i];
	slip->speed = sqrt(w[0] * w[0] + w[1] * w[1] + w[2] * w[2]);
	slip->empty = style_of(self)->crowded ? void_at(s, place, cell) : 1;
	return true;
}

/* Force of one component, given the others f; *slope is B. */
static double component(int scheme, double c, double w, double f, double mass, double h, double *slope)
{
	double rate = c / mass;

	*slope = c;
	if (scheme == EXPLICIT || !(c > 0))
		return c * w;
	*slope = scheme == EXACT ? mass * -expm1(-h * rate) / h : c / (1 + h * rate);
	if (scheme == EXACT)
		return *slope * (w + f / c) - f;
	return *slope * (w - h * f / mass);
}

/* The fluid takes the mean over so many steps of the simulation; 0: it does not make its step in this one, and
 * what it gets now is the force as it is. */
static double steps_to_fluid(const struct ts_drag *s)
{
	const struct ts_projection *p = s->flow->state;

	return p->waited + 1 >= p->every ? (double)p->every : 0;
}

struct findings {
	double reynolds, stiffness; /* the largest Re, and c h/m where the force is explicit */
};

static void drag_on(const struct ts_instance *self, struct tsim *sim, size_t i, struct ts_slip *slip,
		    struct findings *found)
{
	struct ts_drag *s = self->state;
	struct ts_particles *p = sim->particles;
	double h = sim->clock.dt, w[3], c, mass;
	double steps = s->part.settle ? steps_to_fluid(s) : 0;
	bool held = p->imass[i] == 0, member = ts_rigid_member(p, i);

	if (!sample(self, p, i, slip, w))
		return;
	c = style_of(self)->coefficient(s, slip);
	mass = p->mass[i] + s->added * ts_body_volume(sim, p->radius[i]);
	for (int k = 0; k < 3; k++) {
		double slope, force;

		if (!(axes_bits[s->axes] >> k & 1))
			continue;
		force = component(held || member ? EXPLICIT : s->scheme, c, w[k], p->f[i][k], mass, h,
				  &slope);
		p->f[i][k] += force;
		s->total.note[i][k] = force;
		if (s->part.settle && !member) /* never more than takes the particle to the fluid's velocity */
			s->note[i].slope = fmin(steps * slope, held ? INFINITY : fmax(slope, mass / h));
	}
	if (slip->viscosity > 0)
		found->reynolds = fmax(found->reynolds, ts_slip_reynolds(slip));
	if (s->scheme == EXPLICIT && !held)
		found->stiffness = fmax(found->stiffness, c * h / mass);
}

/* What the fluid gets of one particle. */
static void lay(void *context, size_t i)
{
	struct ts_instance *self = ((struct ts_instance **)context)[0];
	struct tsim *sim = ((struct tsim **)context)[1];
	struct ts_drag *s = self->state;
	struct ts_fluid *fluid = s->fluid;
	double place[3];
	int cell[3];

	if (!ts_fluid_place(fluid, sim->particles->x[i], place, cell))
		return;
	for (int c = 0; c < fluid->grid.dimensions; c++) {
		struct ts_share st;

		if (!(axes_bits[s->axes] >> c & 1))
			continue;
		ts_share_face(fluid, c, place, cell, (enum ts_interpolation)s->interpolation, &st);
		s->note[i].held[c] = ts_share_react(&fluid->grid, &st, c, fluid->u[c],
						      s->total.note[i][c], s->note[i].slope,
						      fluid->force[c],
						      s->lagged ? NULL : fluid->exchange[c]);
	}
}

static enum ts_status react(struct ts_instance *self, struct tsim *sim)
{
	struct ts_drag *s = self->state;
	void *context[2] = { self, sim };

	TS_TRY(ts_cell_order_make(&s->order, sim, s->fluid, self->group, 1));
	ts_cell_order_each(&s->order, ts_team(sim, sim->particles->n), lay, context);
	s->noted = sim->particles->n;
	return TS_OK;
}

static enum ts_status make_room(struct ts_drag *s, struct tsim *sim)
{
	size_t n = sim->particles->n;

	TS_TRY(ts_tally_start(sim, &s->total));
	s->noted = 0;
	if (!s->fluid || !s->two_way)
		return TS_OK;
	if (TS_GROW(s->note, s->capacity, n) != TS_OK)
		return ts_nomem(&sim->error);
	if (n)
		memset(s->note, 0, n * sizeof *s->note);
	return TS_OK;
}

enum ts_status ts_drag_post_force(struct ts_instance *self, struct tsim *sim)
{
	struct ts_drag *s = self->state;
	const struct ts_flow_style *flow = ts_flow_style_of(s->flow);
	double density = flow->density(s->flow), viscosity = flow->viscosity(s->flow);
	double reynolds = 0, stiffness = 0;
	const struct ts_particles *p = sim->particles;

	TS_TRY(make_room(s, sim));
	if (!(viscosity > 0))
		return TS_OK;
#pragma omp parallel for num_threads(ts_team(sim, p->n)) schedule(static)                         \
	reduction(max : reynolds, stiffness)
	for (size_t i = 0; i < p->n; i++) {
		struct ts_slip slip = { .density = density, .viscosity = viscosity };
		struct findings found = { 0, 0 };

		if (!ts_in_group(p, i, self->group))
			continue;
		drag_on(self, sim, i, &slip, &found);
		reynolds = fmax(reynolds, found.reynolds);
		stiffness = fmax(stiffness, found.stiffness);
	}
	s->reynolds = reynolds;
	if (stiffness > 2 && style_of(self)->inertial && !sim->unsafe)
		return ts_fail(&sim->error, TS_PHYSICS, &self->where,
			       "fix %s: a particle's velocity relaxes in %g, the explicit drag is stable for "
			       "steps below twice that, and the step is %g: use scheme exact, or a smaller "
			       "`timestep`",
			       self->style->name, sim->clock.dt / stiffness, sim->clock.dt);
	return s->fluid && s->two_way && !sim->in_setup ? react(self, sim) : TS_OK;
}

/* How much of a force added now the velocities get before the next forces: velocity Verlet has given half of
 * the kick already. */
static double kicks_left(const struct tsim *sim)
{
	const struct ts_instances *fixes = &sim->instances[TS_KIND_FIX];

	for (size_t k = 0; k < fixes->n; k++)
		if (fixes->item[k]->style->hook[TS_STAGE_INITIAL_INTEGRATE] &&
		    fixes->item[k]->style->hook[TS_STAGE_FINAL_INTEGRATE])
			return 0.5;
	return 1;
}

/* The fluid has made its step with the new velocity: the particles get what it has felt. */
static enum ts_status settle(struct ts_instance *self, struct tsim *sim, struct ts_fluid *fluid, double length)
{
	struct ts_drag *s = self->state;
	struct ts_particles *p = sim->particles;
	double share = 1 / kicks_left(sim);

	(void)length;
	if (s->noted != p->n)
		return TS_OK;
	s->total.fresh = true;
#pragma omp parallel for num_threads(ts_team(sim, p->n)) schedule(static)
	for (size_t i = 0; i < p->n; i++) {
		double place[3];
		int cell[3];

		if (s->note[i].slope == 0 || !ts_fluid_place(fluid, p->x[i], place, cell))
			continue;
		for (int c = 0; c < fluid->grid.dimensions; c++) {
			struct ts_share st;
			double more;

			if (!(axes_bits[s->axes] >> c & 1))
				continue;
			ts_share_face(fluid, c, place, cell, (enum ts_interpolation)s->interpolation,
					&st);
			more = s->note[i].slope *
			       (ts_share_gather(&fluid->grid, &st, fluid->used[c]) - s->note[i].held[c]);
			s->total.note[i][c] += more;
			if (p->imass[i] != 0)
				p->f[i][c] += share * more;
		}
	}
	s->noted = 0;
	return TS_OK;
}

enum ts_status ts_drag_archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a)
{
	struct ts_drag *s = self->state;

	(void)sim;
	TS_TRY(ts_tally_archive(a, &s->total));
	if (!ts_archive_writing(a) && !ts_archive_has(a, "reynolds"))
		return TS_OK;
	return ts_archive_fixed(a, "reynolds", TS_SAVED_F64, &s->reynolds, 1);
}

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	struct ts_drag *s = self->state;

	(void)sim;
	memcpy(out->data, ts_tally_sums(&s->total), 3 * sizeof *out->data);
	out->data[3] = s->reynolds;
	return TS_OK;
}

static const char *const columns[] = { "x", "y", "z", "Re" };
const struct ts_value ts_drag_values[] = {
	{ "drag", "force", "total drag on the particles (x y z), the largest Reynolds number", TS_VECTOR,
	  4, columns, eval },
	{ .name = NULL },
};

/* Unresolved drag supposes that a cell holds the particle. */
static void warn_of_cells(const struct ts_instance *self, struct tsim *sim, double diameter)
{
	const struct ts_drag *s = self->state;
	const struct ts_grid *grid = &s->fluid->grid;
	double least = INFINITY;

	for (int d = 0; d < grid->dimensions; d++)
		for (int i = 0; i < grid->n[d]; i++)
			least = fmin(least, grid->width[d][i]);
	if (least < diameter)
		ts_warn(&sim->log, &self->where,
			"fix %s: cells of the fluid are down to %g wide and particles up to %g: laws of drag "
			"hold for cells of several diameters",
			self->style->name, least, diameter);
}

/* k at the faces across c: the sum of the coefficients by volume. */
static void sum_coefficients(const struct ts_instance *self, const struct tsim *sim, int c, double *k)
{
	const struct ts_drag *s = self->state;
	const struct ts_fluid *fluid = s->fluid;
	const struct ts_particles *p = sim->particles;

	memset(k, 0, fluid->grid.size * sizeof *k);
	for (size_t i = 0; i < p->n; i++) {
		struct ts_slip slip = { .density = fluid->density, .viscosity = fluid->viscosity };
		struct ts_share st;
		double w[3], place[3];
		int cell[3];

		if (!ts_in_group(p, i, self->group) || !sample(self, p, i, &slip, w) ||
		    !ts_fluid_place(fluid, p->x[i], place, cell))
			continue;
		ts_share_face(fluid, c, place, cell, (enum ts_interpolation)s->interpolation, &st);
		ts_share_react(&fluid->grid, &st, c, fluid->u[c], -style_of(self)->coefficient(s, &slip), 0, k,
			       NULL);
	}
}

/* The fluid gets the force as it is, du/dt = -k (u - v)/(e rho): the largest k/(e rho). Weights sum to 1, so no mode
 * of the velocities relaxes faster. */
static enum ts_status lagged_rate(const struct ts_instance *self, struct tsim *sim, double *rate)
{
	const struct ts_drag *s = self->state;
	const struct ts_fluid *fluid = s->fluid;
	double *k = ts_grid_field(&fluid->grid);

	if (!k)
		return ts_nomem(&sim->error);
	for (int c = 0; c < fluid->grid.dimensions; c++) {
		size_t stride = (size_t)fluid->grid.stride[c];

		if (!(axes_bits[s->axes] >> c & 1))
			continue;
		sum_coefficients(self, sim, c, k);
		for (size_t at = stride; at < fluid->grid.size; at++) {
			double e = fluid->empty ? 0.5 * (fluid->empty[at] + fluid->empty[at - stride]) : 1;

			if (k[at] > 0)
				*rate = fmax(*rate, k[at] / (e * fluid->density));
		}
	}
	ts_grid_field_free(k);
	return TS_OK;
}

/* Explicit drag makes the velocity of the particle relax as well: the slip decays at no more than both rates. The fluid
 * takes its steps with the force of `every` steps before. */
static enum ts_status limit_lagged(struct ts_instance *self, struct tsim *sim, double relaxation,
				   struct ts_plan_report *report)
{
	const struct ts_drag *s = self->state;
	const struct ts_projection *p = s->flow->state;
	double rate = 0;

	if (!s->fluid || !s->two_way || !s->lagged || !(s->fluid->viscosity > 0))
		return TS_OK;
	TS_TRY(lagged_rate(self, sim, &rate));
	rate *= (double)p->every;
	if (s->scheme == EXPLICIT)
		rate += 1 / relaxation;
	return ts_report_limit(report, rate > 0 ? 2 / rate : INFINITY, false, &self->where,
			       "what lagged fix %s gives to the fluid, 2 e rho/k (lagged no has no such limit)",
			       self->style->name);
}

enum ts_status ts_drag_plan(struct ts_instance *self, struct tsim *sim,
			    struct ts_plan_report *report)
{
	const struct ts_drag *s = self->state;
	const struct ts_flow_style *flow = ts_flow_style_of(s->flow);
	const struct ts_particles *p = sim->particles;
	double least = INFINITY, largest = 0;

	for (size_t i = 0; i < p->n; i++) {
		struct ts_slip slip = { .density = flow->density(s->flow),
					.viscosity = flow->viscosity(s->flow) };
		double w[3], mass = p->mass[i] + s->added * ts_body_volume(sim, p->radius[i]);

		if (!ts_in_group(p, i, self->group) || !(slip.viscosity > 0) ||
		    !sample(self, p, i, &slip, w))
			continue;
		largest = fmax(largest, slip.diameter);
		if (p->imass[i] != 0)
			least = fmin(least, mass / style_of(self)->coefficient(s, &slip));
	}
	if (s->fluid && s->two_way && !report->limits_only)
		warn_of_cells(self, sim, largest);
	TS_TRY(limit_lagged(self, sim, least, report));
	if (isinf(least))
		return TS_OK;
	ts_report_line(report, "drag", "%s along %s, least relaxation time %g", self->style->name,
		       ts_drag_axes[s->axes], least);
	if (s->scheme != EXPLICIT)
		return TS_OK;
	return ts_report_limit(report, 2 * least, true, &self->where,
			       "explicit fix %s, 2 tau (scheme exact has no limit)", self->style->name);
}

void ts_drag_fini(struct ts_instance *self)
{
	struct ts_drag *s = self->state;

	ts_cell_order_release(&s->order);
	ts_tally_release(&s->total);
	ts_free(s->note);
}
