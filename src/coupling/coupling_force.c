#include "coupling/coupling_force.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/axes.h"
#include "coupling/near_particles.h"
#include "coupling/outside_grid.h"
#include "coupling/reactions.h"
#include "coupling/sphere_rows.h"
#include "math/vec3.h"
#include "particle/particles.h"

#include "base/banned.h"

static const struct ts_coupling_force_style *style_of(const struct ts_instance *self)
{
	return (const struct ts_coupling_force_style *)self->style;
}

enum ts_status ts_coupling_force_init(struct ts_instance *self, struct tsim *sim)
{
	struct ts_coupling_force *s = self->state;
	const struct ts_coupling_force_style *style = style_of(self);
	char who[64];

	snprintf(who, sizeof who, "fix %s", self->style->name);
	s->flow = ts_sim_only(sim, TS_KIND_FLOW);
	s->fluid = NULL;
	if (style->solved || (s->flow && ts_flow_style_of(s->flow)->fluid))
		TS_TRY(ts_flow_require_fluid(sim, who, &self->where, &s->fluid));
	else if (!s->flow)
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "%s needs a fluid: use flow_style before it", who);
	if (!(ts_flow_style_of(s->flow)->density(s->flow) > 0))
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "%s needs a fluid with a density: give flow_style %s one", who,
			       s->flow->style->name);
	s->part.sends = (struct ts_flow_part_sends){ .nearby = true };
	if (!s->fluid || !s->two_way || style->internal)
		return TS_OK;
	s->part.sends = (struct ts_flow_part_sends){
		.particles = true, .numbers = 3, .reaction = true, .nearby = true
	};
	return ts_fluid_require_fields(s->fluid, sim, TS_FLUID_FORCE);
}

void ts_coupling_curl(const double gradient[3][3], double curl[3])
{
	for (int k = 0; k < 3; k++)
		curl[k] = gradient[(k + 2) % 3][(k + 1) % 3] - gradient[(k + 1) % 3][(k + 2) % 3];
}

static void fluid_velocity(const struct ts_coupling_force *s, const double x[3], double u[3])
{
	if (s->fluid)
		ts_fluid_velocity(s->fluid, x, u);
	else
		ts_flow_style_of(s->flow)->velocity(s->flow, x, u);
}

/* du/dx_a by a difference over the width of a cell, at a boundary over the part of it inside the grid. */
static void gradient_along(const struct ts_coupling_force *s, int a, double radius,
			   struct ts_coupling_local_flow *around)
{
	const struct ts_grid *grid = s->fluid ? &s->fluid->grid : NULL;
	double half = grid ? 0.5 * grid->width[a][around->cell[a]] : radius;
	double low[3], high[3], at_low[3], at_high[3];

	if (grid && grid->ghosts[a] == 0) { /* two dimensions: no gradient along z */
		for (int c = 0; c < 3; c++)
			around->gradient[c][a] = 0;
		return;
	}
	memcpy(low, around->place, sizeof low);
	memcpy(high, around->place, sizeof high);
	low[a] -= half;
	high[a] += half;
	if (grid && !grid->periodic[a]) {
		low[a] = fmax(low[a], grid->face[a][0]);
		high[a] = fmin(high[a], grid->face[a][grid->n[a]]);
	}
	fluid_velocity(s, low, at_low);
	fluid_velocity(s, high, at_high);
	for (int c = 0; c < 3; c++)
		around->gradient[c][a] = (at_high[c] - at_low[c]) / (high[a] - low[a]);
}

/* Finds the flow at particle i; false if it is outside the fluid. */
static bool find_local_flow(const struct ts_instance *self, const struct ts_particles *p, size_t i,
			    struct ts_coupling_local_flow *around)
{
	const struct ts_coupling_force *s = self->state;

	memcpy(around->place, p->x[i], sizeof around->place);
	if (s->fluid && !ts_coupling_locate(s->fluid, p->x[i], around->place, around->cell))
		return false;
	if (style_of(self)->at_rest)
		return true;
	fluid_velocity(s, around->place, around->u);
	for (int k = 0; k < 3; k++)
		around->slip[k] = around->u[k] - p->v[i][k];
	for (int a = 0; a < 3 && style_of(self)->sheared; a++)
		gradient_along(s, a, p->radius[i], around);
	return true;
}

enum ts_status ts_coupling_force_add_to_fluid(struct ts_instance *self, struct tsim *sim)
{
	struct ts_coupling_force *s = self->state;
	struct ts_reactions reactions = { .fluid = s->fluid,
					  .order = &s->order,
					  .how = TS_INTERPOLATE_LINEAR,
					  .along = { true, true, true } };

	if (!s->fluid || !s->two_way || style_of(self)->internal || sim->run.in_setup)
		return TS_OK;
	TS_TRY(ts_cell_order_make(&s->order, sim, s->fluid, self->group, 1));
	TS_TRY(ts_cell_order_share(&s->order, sim, (const double *)s->total.note, TS_PARTICLE_TALLY_MOST, 3,
				   &reactions.force));
	ts_reactions_add(&reactions, ts_team(sim, s->order.sort->of.n));
	s->fluid->apart = sim->division;
	return TS_OK;
}

static void add_to_particle(struct ts_coupling_force *s, struct ts_particles *p, size_t i, const double f[3],
			    const double torque[3])
{
	for (int k = 0; k < 3; k++) {
		p->f[i][k] += f[k];
		s->total.note[i][k] = f[k];
		if (p->torque)
			p->torque[i][k] += torque[k];
	}
}

static void add_force(const struct ts_instance *self, const struct tsim *sim, size_t i,
		      struct ts_coupling_outside *outside)
{
	struct ts_coupling_force *s = self->state;
	const struct ts_flow_style *flow = ts_flow_style_of(s->flow);
	struct ts_coupling_local_flow around = { .density = flow->density(s->flow),
						 .viscosity = flow->viscosity(s->flow) };
	double f[3] = { 0 }, torque[3] = { 0 };

	if (!find_local_flow(self, sim->particles, i, &around)) {
		ts_coupling_outside_add(outside, sim->particles, i);
		return;
	}
	style_of(self)->force(self, sim, i, &around, f, torque);
	if (style_of(self)->row) {
		const double n = ts_spheres_in_row(sim, 2 * sim->particles->radius[i]);

		ts_scale(n, f, f);
		ts_scale(n, torque, torque);
	}
	add_to_particle(s, sim->particles, i, f, torque);
}

static void add_batch(const struct ts_instance *self, const struct tsim *sim, const size_t *of, size_t n,
		      struct ts_coupling_outside *outside)
{
	static const double none[3] = { 0 };
	struct ts_coupling_force *s = self->state;
	double f[TS_COUPLING_FORCE_BATCH][3];
	bool inside[TS_COUPLING_FORCE_BATCH];

	style_of(self)->forces(self, sim, of, n, f, inside);
	for (size_t k = 0; k < n; k++) {
		if (inside[k])
			add_to_particle(s, sim->particles, of[k], f[k], none);
		else
			ts_coupling_outside_add(outside, sim->particles, of[k]);
	}
}

/* On particles of the group among `from` and those after it. */
static void add_forces(const struct ts_instance *self, const struct tsim *sim, size_t from,
		       struct ts_coupling_outside *outside)
{
	const struct ts_coupling_force *s = self->state;
	const struct ts_particles *p = sim->particles;
	size_t of[TS_COUPLING_FORCE_BATCH] = { 0 }, n = 0;

	for (size_t i = from; i < p->n && i < from + TS_COUPLING_FORCE_BATCH; i++) {
		memset(s->total.note[i], 0, sizeof *s->total.note);
		if (ts_in_group(p, i, self->group))
			of[n++] = i;
	}
	if (s->batches)
		add_batch(self, sim, of, n, outside);
	for (size_t k = 0; k < n && !s->batches; k++)
		add_force(self, sim, of[k], outside);
}

enum ts_status ts_coupling_force_post_force(struct ts_instance *self, struct tsim *sim)
{
	struct ts_coupling_force *s = self->state;
	const struct ts_coupling_force_style *style = style_of(self);
	const size_t n = sim->particles->n;
	int64_t tag = INT64_MAX;
	size_t outside = 0;

	TS_TRY(ts_near_particles_ready(s->fluid, sim));
	TS_TRY(ts_particle_tally_start_unset(sim, &s->total));
#pragma omp parallel for num_threads(ts_team(sim, n)) schedule(static) reduction(+ : outside) \
	reduction(min : tag)
	for (size_t i = 0; i < n; i += TS_COUPLING_FORCE_BATCH) {
		struct ts_coupling_outside here = { 0, tag };

		add_forces(self, sim, i, &here);
		outside += here.n;
		tag = here.tag;
	}
	if (s->fluid)
		TS_TRY(ts_coupling_count_outside(s->fluid, sim, self, outside, tag));
	return style->style.late[TS_LATE_INERTIA] ? TS_OK : ts_coupling_force_add_to_fluid(self, sim);
}

enum ts_status ts_coupling_force_archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a)
{
	(void)sim;
	return ts_particle_tally_archive(a, &((struct ts_coupling_force *)self->state)->total);
}

enum ts_status ts_coupling_force_join(struct ts_instance *self, struct tsim *sim)
{
	return ts_particle_tally_merge(&((struct ts_coupling_force *)self->state)->total, sim);
}

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	(void)sim;
	memcpy(out->data, ts_particle_tally_sums(&((struct ts_coupling_force *)self->state)->total),
	       3 * sizeof *out->data);
	return TS_OK;
}

const struct ts_value ts_coupling_force_values[] = {
	{ "force", "force", "total force on the particles", TS_VECTOR, 3, ts_axis_names, eval },
	{ .name = NULL },
};

void ts_coupling_force_fini(struct ts_instance *self)
{
	struct ts_coupling_force *s = self->state;

	ts_cell_order_release(&s->order);
	ts_particle_tally_release(&s->total);
}
