/* Fix flow/scalar: transport of heat or another scalar by the fluid. */
#include "scalar/scalar_transport.h"

#include <math.h>
#include <string.h>

#include "core/report.h"
#include "coupling/cell_order.h"
#include "coupling/near_particles.h"
#include "coupling/interpolation_weights.h"
#include "coupling/sphere_rows.h"
#include "flow/boundary.h"
#include "flow/flow.h"
#include "flow/fluid_slabs.h"
#include "flow/flow_arguments.h"
#include "flow/projection.h"
#include "heat/heat.h"
#include "law/drag.h"
#include "law/lift.h"
#include "math/constants.h"
#include "math/exactsum.h"
#include "particle/rank_sums.h"

#include "base/banned.h"

enum { EXCHANGE_NONE, RANZ_MARSHALL };
static const char *const exchanges[] = { "none", "ranz_marshall", NULL };
enum { FACES = 6 };
static const char *const faces[FACES] = { "xlo", "xhi", "ylo", "yhi", "zlo", "zhi" };

struct condition {
	int kind; /* enum ts_scalar_condition */
	struct ts_number number;
};

struct state {
	struct ts_flow_part part; /* first */
	int scheme, exchange;
	double conductivity, capacity;
	struct ts_number initial, source;
	struct ts_words set, face_words[FACES];
	struct condition condition[FACES];
	/* What is given now and was at the last step of the fluid: on faces, then the source, as the transport takes it. It is
	 * interpolated between them. */
	double given_now[FACES + 1], given_before[FACES + 1];
	bool before_known;
	int32_t before_kind[FACES]; /* of the conditions */
	int64_t before_resets;	    /* clock.resets then */

	struct ts_fluid *fluid;
	const struct ts_projection *projection;
	struct ts_heat *heat;
	struct ts_transport transport;
	struct ts_cell_order order;
	bool arguments_read, known; /* known: the field T has values */
	bool given;		    /* those of `initial`, in the grid of this number */
	uint64_t grids;
	bool told;	   /* that bodies conduct as the fluid does */
	int64_t steps;	   /* number of steps of the simulation whose heat is in transport.source */
	double *heat_rate; /* heat flux into each particle (energy/time); owned */
	size_t heat_rate_capacity;
	double exchanged; /* sum of heat_rate in the last step */
	size_t size;	  /* of the fields, in doubles */
	struct tsim *sim; /* evaluation may fail */
};

/* ---- arguments */

static const struct ts_arg number_rows[] = {
	TS_NUMBER("number", struct condition, number, .flags = TS_POSITIONAL, .help = "number or v_NAME"),
	TS_ARGS_END,
};

static const struct ts_arg no_rows[] = { TS_ARGS_END };

static const struct ts_mode conditions[] = {
	[TS_SCALAR_NONE] = { "none", "no conduction through the face", no_rows },
	[TS_SCALAR_VALUE] = { "value", "T on the face", number_rows },
	[TS_SCALAR_FLUX] = { "flux", "heat per area and time into the fluid", number_rows },
	{ .name = NULL },
};

static const struct ts_arg condition_rows[] = {
	TS_MODE("condition", struct condition, kind, conditions, .help = "what is given"),
	TS_ARGS_END,
};

static enum ts_status read_face_conditions(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	for (int k = 0; k < FACES; k++)
		if (s->face_words[k].n)
			TS_TRY(ts_args_parse(sim, "fix flow/scalar", condition_rows, s->face_words[k],
					     &self->where, &self->arena, &s->condition[k]));
	s->arguments_read = true;
	return TS_OK;
}

static enum ts_status check_face(struct ts_instance *self, struct tsim *sim, int k)
{
	const struct ts_grid *grid = &((const struct state *)self->state)->fluid->grid;
	const struct ts_place *where = ts_instance_word(self, faces[k]);

	if (grid->periodic[k / 2])
		return ts_fail(&sim->error, TS_STATE, where,
			       "fix flow/scalar: the grid is periodic there, it has no face %s", faces[k]);
	if (k / 2 >= grid->dimensions)
		return ts_fail(&sim->error, TS_STATE, where,
			       "fix flow/scalar: %s: with one cell along z nothing varies there: none only; "
			       "leave it out, or give heat per volume as `source`",
			       faces[k]);
	return TS_OK;
}

/* Evaluates the conditions on faces and the source; fluxes are converted to T times velocity. */
static enum ts_status evaluate_conditions(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	double amount = s->fluid->density * s->capacity;

	for (int k = 0; k < FACES; k++) {
		const struct condition *c = &s->condition[k];

		s->transport.face[k / 2][k % 2].condition = c->kind;
		if (c->kind == TS_SCALAR_NONE)
			continue;
		TS_TRY(check_face(self, sim, k));
		TS_TRY(ts_number_now(sim, &c->number, &self->where, &s->given_now[k]));
		if (c->kind == TS_SCALAR_FLUX)
			s->given_now[k] /= amount;
	}
	TS_TRY(ts_number_now(sim, &s->source, &self->where, &s->given_now[FACES]));
	s->given_now[FACES] /= amount;
	return TS_OK;
}

/* Sets what is given to that at a fraction of the step of the fluid. */
static void interpolate_conditions(struct state *s, double fraction)
{
	for (int k = 0; k <= FACES; k++) {
		double *to = k < FACES ? &s->transport.face[k / 2][k % 2].now : &s->transport.constant;

		*to = ts_flow_interpolate_time(s->given_before[k], s->given_now[k], fraction);
	}
}

static void store_conditions(struct state *s, const struct tsim *sim)
{
	memcpy(s->given_before, s->given_now, sizeof s->given_before);
	for (int k = 0; k < FACES; k++)
		s->before_kind[k] = s->condition[k].kind;
	s->before_known = true;
	s->before_resets = sim->clock.resets;
}

/* At the beginning of a run, in which T is that after the last step of the fluid. */
static enum ts_status begin_conditions(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	TS_TRY(evaluate_conditions(self, sim));
	s->before_known &= s->before_resets == sim->clock.resets; /* else the last step had another time */
	for (int k = 0; k < FACES; k++)				  /* a restart file may have others */
		s->before_known &= s->before_kind[k] == s->condition[k].kind;
	if (!s->before_known || ts_projection_not_started(s->projection))
		store_conditions(s, sim);
	interpolate_conditions(s, 0);
	return TS_OK;
}

static enum ts_status set_initial_field(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	const struct ts_grid *grid = &s->fluid->grid;
	const char *set[3] = { NULL };
	struct ts_arena arena = { 0 };
	enum ts_status status =
		ts_flow_read_set(sim, "fix flow/scalar: set", s->set, &self->where, &arena, set);

	if (status == TS_OK && s->set.n && !s->initial.variable)
		status = ts_fail(&sim->error, TS_SYNTAX, &s->set.word[0].place,
				 "fix flow/scalar: set %s: `initial` is the number %g, which does not depend "
				 "on coordinates; give it as v_NAME, or leave out set",
				 s->set.word[0].text, s->initial.value);
	for (int k = 0; k < grid->n[2] && status == TS_OK; k++) {
		if (!ts_fluid_has_plane(s->fluid, k))
			continue;
		for (int j = 0; j < grid->n[1] && status == TS_OK; j++)
			for (int i = 0; i < grid->n[0] && status == TS_OK; i++) {
				const double x[3] = { grid->centre[0][i], grid->centre[1][j],
						      grid->centre[2][k] };

				status = ts_flow_set_coordinates(sim, set, x, &self->where);
				if (status == TS_OK)
					status = ts_number_now(sim, &s->initial, &self->where,
							       &s->transport.value[ts_at(grid, i, j, k)]);
			}
	}
	ts_arena_release(&arena);
	s->known = s->given = status == TS_OK;
	s->grids = s->fluid->grids;
	return status;
}

/* Evaluates `initial` in the present grid, or warns that it has changed since. */
static enum ts_status begin_field(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	if (!s->known || (s->given && s->grids != s->fluid->grids))
		return set_initial_field(self, sim);
	if (!s->given && s->fluid->stretched)
		ts_warn(&sim->log, &self->where,
			"fix flow/scalar: the grid has changed (flow_grid, region, change_box or replicate) "
			"after a run or since the restart file was written: each cell keeps its value, so "
			"that the field is stretched with the cells");
	s->grids = s->fluid->grids;
	return TS_OK;
}

/* ---- set-up */

static enum ts_status advance_scalar(struct ts_instance *self, struct tsim *sim, struct ts_fluid *fluid,
				     double dt);
static enum ts_status finish_step(struct ts_instance *self, struct tsim *sim, struct ts_fluid *fluid,
				  double length);

static enum ts_status find_heat(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	s->heat = s->exchange == EXCHANGE_NONE ? NULL : ts_heat_of(sim);
	if (s->exchange == EXCHANGE_NONE)
		return TS_OK;
	if (!s->heat || s->heat->scheme == TS_HEAT_EXACT)
		return ts_fail(&sim->error, TS_STATE, ts_instance_word(self, "exchange"),
			       "fix flow/scalar: exchange needs particles with temperatures: put a fix "
			       "heat/gran with scheme euler before it");
	if (!(s->conductivity > 0 && s->fluid->viscosity > 0))
		return ts_fail(&sim->error, TS_STATE, ts_instance_word(self, "exchange"),
			       "fix flow/scalar: exchange needs a conductivity and a viscosity of the fluid");
	return TS_OK;
}

static enum ts_status make_fields(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	struct ts_transport *t = &s->transport;
	size_t size = s->fluid->grid.size;

	if (t->value && s->size != size) { /* another grid */
		ts_transport_release(t);
		s->known = false;
	}
	if (!t->value && ts_transport_make(t, s->fluid) != TS_OK)
		return ts_nomem(&sim->error);
	if (s->fluid->void_fraction && !t->void_fraction) {
		t->void_fraction = ts_grid_field(&s->fluid->grid);
		if (!t->void_fraction)
			return ts_nomem(&sim->error);
		ts_fluid_copy_field(s->fluid, t->void_fraction, s->fluid->void_fraction);
	}
	if (!s->fluid->void_fraction) { /* the fix that set it is gone */
		ts_grid_field_free(t->void_fraction);
		t->void_fraction = NULL;
	}
	s->size = size;
	return TS_OK;
}

static const double *scalar(struct ts_instance *self)
{
	struct state *s = self->state;

	ts_transport_fill(&s->transport, s->fluid, s->transport.value);
	return s->transport.value;
}

static bool value_given(const struct ts_instance *self, int d, int side)
{
	return ((const struct state *)self->state)->transport.face[d][side].condition == TS_SCALAR_VALUE;
}

static void list_fields(struct ts_instance *self, struct ts_flow_part_fields *out)
{
	struct state *s = self->state;
	struct ts_transport *t = &s->transport;

	if (s->size != s->fluid->grid.size)
		return;
	*out = (struct ts_flow_part_fields){ .near = { s->heat ? t->value : NULL },
					     .sum = { s->heat ? t->source : NULL },
					     .plane = { s->heat ? NULL : t->value, t->void_fraction },
					     .work = { t->rate, t->stage, s->heat ? NULL : t->source } };
}

static void rehearse(const struct ts_instance *self, const struct ts_fluid *fluid, double dt)
{
	ts_transport_rehearse(&((const struct state *)self->state)->transport, fluid, dt);
}

static void warn_of_bodies(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	size_t k = 0;
	const struct ts_instance *body = ts_flow_part_named(sim, "immersed/boundary", &k);

	if (!body || s->told)
		return;
	s->told = true;
	ts_warn(&sim->log, &self->where,
		"fix flow/scalar: inside of the bodies of fix %s (%s:%d) the scalar is transported as in the "
		"fluid: they conduct as it does, and have no temperature of their own",
		body->id, TS_FILE_AND_LINE(body->where));
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	struct ts_projection *projection;
	struct ts_instance *flow;

	TS_TRY(ts_projection_require(sim, "fix flow/scalar", &self->where, &flow, &projection));
	s->fluid = &projection->fluid;
	s->projection = projection;
	if (!s->known)
		TS_TRY(ts_projection_setup(flow, sim)); /* the grid of the present box */
	s->part.scalar = scalar;
	s->part.scalar_given = value_given;
	s->part.after_substep = advance_scalar;
	s->part.after_step = finish_step;
	s->part.rehearse = rehearse;
	s->part.fields = list_fields;
	s->sim = sim;
	if (!s->arguments_read)
		TS_TRY(read_face_conditions(self, sim));
	TS_TRY(find_heat(self, sim));
	s->part.sends = (struct ts_flow_part_sends){
		.particles = s->heat, .numbers = s->heat != NULL, .sums = s->heat != NULL, .nearby = true
	};
	TS_TRY(make_fields(self, sim));
	s->transport.scheme = (enum ts_scalar_scheme)s->scheme;
	s->transport.diffusivity = s->conductivity / (s->fluid->density * s->capacity);
	TS_TRY(begin_conditions(self, sim));
	TS_TRY(begin_field(self, sim));
	warn_of_bodies(self, sim);
	ts_transport_fill(&s->transport, s->fluid, s->transport.value);
	s->fluid->near.stale = true;
	return TS_OK;
}

/* ---- exchange with particles */

static double heat_conductance(const struct state *s, const struct tsim *sim, size_t i, const double place[3])
{
	const struct ts_particles *p = sim->particles;
	const struct ts_fluid *fluid = s->fluid;
	struct ts_slip slip = { .diameter = 2 * p->radius[i],
				.empty = 1,
				.density = fluid->density,
				.viscosity = fluid->viscosity };
	double u[3], square = 0;

	ts_fluid_velocity(fluid, place, u);
	for (int k = 0; k < 3; k++)
		square += (u[k] - p->v[i][k]) * (u[k] - p->v[i][k]);
	slip.speed = sqrt(square);
	if (fluid->void_fraction)
		slip.empty = ts_fluid_value(fluid, fluid->void_fraction, place, NULL);
	return ts_spheres_in_row(sim, slip.diameter) * TS_PI * slip.diameter * s->conductivity *
	       ts_nusselt_ranz_marshall(ts_slip_reynolds(&slip),
					fluid->viscosity * s->capacity / s->conductivity);
}

struct context {
	struct state *state;
	struct ts_cell_numbers rate; /* heat_rate */
};

static void add_heat_source(void *data, size_t row)
{
	const struct context *c = data;
	struct state *s = c->state;
	struct ts_coupling_weights weights;
	double place[3];
	int cell[3];

	if (!ts_cell_order_locate(&s->order, s->fluid, row, place, cell))
		return;
	ts_coupling_weights_centre(s->fluid, place, cell, TS_INTERPOLATE_LINEAR, &weights);
	ts_coupling_distribute_force(&s->fluid->grid, &weights, -1, s->transport.value,
				     *ts_cell_numbers_of(&c->rate, row) / (s->fluid->density * s->capacity),
				     0, s->transport.source, NULL);
}

static enum ts_status post_force(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	const struct ts_particles *p = sim->particles;
	struct context context = { .state = s };

	if (!s->heat || sim->run.in_setup)
		return TS_OK;
	TS_TRY(ts_near_particles_ready(s->fluid, sim));
	if (TS_GROW(s->heat_rate, s->heat_rate_capacity, p->n) != TS_OK)
		return ts_nomem(&sim->error);
#pragma omp parallel for num_threads(ts_team(sim, p->n)) schedule(static)
	for (size_t i = 0; i < p->n; i++) {
		double place[3], there, k;
		int cell[3];

		s->heat_rate[i] = 0;
		if (!ts_in_group(p, i, self->group) || !ts_coupling_locate(s->fluid, p->x[i], place, cell))
			continue;
		k = heat_conductance(s, sim, i, place);
		there = ts_fluid_value(s->fluid, s->transport.value, place, NULL);
		ts_heat_from_outside(s->heat, sim, i, k, there);
		s->heat_rate[i] = k * (there - ts_heat_column(sim, s->heat->temperature)[i]);
	}
	TS_TRY(ts_rank_sums(sim, s->heat_rate, p->n, 1, 1, &s->exchanged));
	TS_TRY(ts_cell_order_make(&s->order, sim, s->fluid, self->group, 1));
	TS_TRY(ts_cell_order_share(&s->order, sim, s->heat_rate, 1, 1, &context.rate));
	ts_cell_order_each(&s->order, ts_team(sim, s->order.sort->of.n), add_heat_source, &context);
	s->steps++;
	return ts_cell_order_gather(&s->order, sim, s->transport.source);
}

/* ---- with each step of the fluid */

/* The number of substeps over dt; fails if there are too many. */
static enum ts_status count_substeps(struct ts_instance *self, struct tsim *sim, double dt, long *n)
{
	static const double MOST = 1e6;
	const struct state *s = self->state;
	const double parts = ts_transport_parts(&s->transport, s->fluid, dt);

	*n = (long)fmin(parts, MOST);
	if (parts <= MOST)
		return TS_OK;
	return ts_fail(&sim->error, TS_PHYSICS, &self->where,
		       "fix flow/scalar: its stable step is %g, so that a step of the fluid, %g, would be %g "
		       "substeps, %g at most: use a smaller `timestep`, larger cells or a smaller "
		       "conductivity",
		       ts_transport_limit(&s->transport, s->fluid), dt, parts, MOST);
}

/* Rate at which the volume of the fluid changes, 1/time; 0 if its change over dt may be round-off. */
static double excess_of(const struct ts_fluid *fluid, double dt)
{
	static const double ROUND_OFF = 1e-14;

	return fabs(fluid->excess) * dt > ROUND_OFF ? fluid->excess : 0;
}

static enum ts_status advance_scalar(struct ts_instance *self, struct tsim *sim, struct ts_fluid *fluid,
				     double dt)
{
	struct state *s = self->state;
	const double at = (double)s->projection->now_at, substeps = (double)s->projection->done;
	long n;

	s->given = false;
	TS_TRY(evaluate_conditions(self, sim));
	interpolate_conditions(s, (at + 0.5) / substeps); /* the mean, which keeps the second order */
	s->transport.excess = excess_of(fluid, dt);
	if (s->steps > 1) /* the mean over these steps */
		ts_fluid_divide_field(fluid, s->transport.source, (double)s->steps);
	s->steps = s->steps ? 1 : 0;
	TS_TRY(count_substeps(self, sim, dt, &n));
	ts_transport_advance(&s->transport, fluid, dt, n, ts_team(sim, s->size));
	interpolate_conditions(s, (at + 1) / substeps);
	ts_transport_fill(&s->transport, fluid, s->transport.value);
	return TS_OK;
}

static enum ts_status finish_step(struct ts_instance *self, struct tsim *sim, struct ts_fluid *fluid,
				  double length)
{
	struct state *s = self->state;

	(void)length;
	store_conditions(s, sim);
	if (s->heat)
		ts_fluid_clear(fluid, s->transport.source);
	s->steps = 0;
	if (fluid->void_fraction)
		ts_fluid_copy_field(fluid, s->transport.void_fraction, fluid->void_fraction);
	return TS_OK;
}

/* ---- state and outputs */

/* Older files do not have them. */
static enum ts_status archive_conditions(struct state *s, struct ts_archive *a)
{
	if (ts_archive_writing(a) ? !s->before_known : !ts_archive_has(a, "given_before"))
		return TS_OK;
	s->before_known = true;
	TS_TRY(ts_archive_fixed(a, "before_resets", TS_SAVED_I64, &s->before_resets, 1));
	TS_TRY(ts_archive_fixed(a, "before_kind", TS_SAVED_I32, s->before_kind, FACES));
	return ts_archive_fixed(a, "given_before", TS_SAVED_F64, s->given_before, FACES + 1);
}

static enum ts_status archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a)
{
	struct state *s = self->state;
	struct ts_transport *t = &s->transport;

	ts_flow_complete(sim);
	TS_TRY(ts_archive_fixed(a, "value", TS_SAVED_F64, t->value, s->size));
	TS_TRY(ts_archive_fixed(a, "source", TS_SAVED_F64, t->source, s->size));
	TS_TRY(archive_conditions(s, a));
	s->given &= ts_archive_writing(a);
	return t->void_fraction ? ts_archive_fixed(a, "empty", TS_SAVED_F64, t->void_fraction, s->size)
				: TS_OK;
}

static const struct ts_saved saved[] = {
	TS_SAVE_U8(struct state, known),
	TS_SAVE_I64(struct state, steps),
	TS_SAVE_F64(struct state, exchanged),
	TS_SAVED_ROWS_END,
};

/* The grid that the field is on. */
static enum ts_status find_grid(const struct ts_instance *self, const struct ts_grid **grid)
{
	const struct state *s = self->state;
	const struct ts_fluid *fluid = ts_flow_fluid(s->sim);

	*grid = fluid ? &fluid->grid : NULL;
	if (fluid && fluid->grid.size == s->size) {
		ts_flow_complete(s->sim);
		return TS_OK;
	}
	return ts_fail(&s->sim->error, TS_STATE, &self->where,
		       "fix flow/scalar: the flow style has been replaced, its scalar is not defined before "
		       "the next run");
}

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct state *s = self->state;
	const struct ts_grid *grid;
	struct ts_exactsum sum = ts_exactsum_start();
	double least = INFINITY, most = -INFINITY;

	TS_TRY(find_grid(self, &grid));
	for (int k = 0; k < grid->n[2]; k++)
		for (int j = 0; j < grid->n[1]; j++)
			for (int i = 0; i < grid->n[0]; i++) {
				size_t at = ts_at(grid, i, j, k);
				double value = s->transport.value[at];

				ts_exactsum_add(&sum,
						(s->transport.void_fraction ? s->transport.void_fraction[at]
									    : 1) *
							value * ts_grid_volume(grid, i, j, k));
				least = fmin(least, value);
				most = fmax(most, value);
			}
	out->data[0] = ts_exactsum_value(&sum) * ts_flow_fluid(sim)->density * s->capacity;
	out->data[1] = s->exchanged;
	out->data[2] = least;
	out->data[3] = most;
	return TS_OK;
}

static enum ts_status eval_cells(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct state *s = self->state;
	const struct ts_grid *grid;
	double *row;

	(void)sim;
	TS_TRY(find_grid(self, &grid));
	if (ts_table_resize(out, ts_grid_cells(grid), 4) != TS_OK)
		return ts_nomem(&s->sim->error);
	row = out->data;
	for (int k = 0; k < grid->n[2]; k++)
		for (int j = 0; j < grid->n[1]; j++)
			for (int i = 0; i < grid->n[0]; i++, row += 4) {
				row[0] = grid->centre[0][i];
				row[1] = grid->centre[1][j];
				row[2] = grid->centre[2][k];
				row[3] = s->transport.value[ts_at(grid, i, j, k)];
			}
	return TS_OK;
}

static const char *const columns[] = { "heat", "exchange", "least", "most" };
static const char *const cell_columns[] = { "x", "y", "z", "T" };
static const struct ts_value values[] = {
	{ "scalar", "", "heat in the fluid, heat per time into the particles, minimum and maximum of T",
	  TS_VECTOR, 4, columns, eval },
	{ "cells", "", "for each cell: its centre and T", TS_ARRAY, 4, cell_columns, eval_cells },
	{ .name = NULL },
};

/* Sums the conductances of particles, per volume, in the cells that give them heat. */
static void sum_conductances(const struct ts_instance *self, const struct tsim *sim, double *sum)
{
	const struct state *s = self->state;
	const struct ts_particles *p = sim->particles;

	for (size_t i = 0; i < p->n; i++) {
		struct ts_coupling_weights weights;
		double place[3];
		int cell[3];

		if (!ts_in_group(p, i, self->group) || !ts_coupling_locate(s->fluid, p->x[i], place, cell))
			continue;
		ts_coupling_weights_centre(s->fluid, place, cell, TS_INTERPOLATE_LINEAR, &weights);
		ts_coupling_distribute_force(&s->fluid->grid, &weights, -1, s->transport.value,
					     -heat_conductance(s, sim, i, place), 0, sum, NULL);
	}
}

/* Largest rate k/(rho c e) of dT/dt = -k (T - T_p)/(rho c e). Weights sum to 1, so no mode of T relaxes faster. */
static enum ts_status exchange_rate(const struct ts_instance *self, struct tsim *sim, double *rate)
{
	const struct state *s = self->state;
	const struct ts_fluid *fluid = s->fluid;
	double *k = ts_grid_field(&fluid->grid);

	if (!k)
		return ts_nomem(&sim->error);
	sum_conductances(self, sim, k);
	for (size_t at = 0; at < fluid->grid.size; at++)
		if (k[at] > 0)
			*rate = fmax(*rate, k[at] / (fluid->void_fraction ? fluid->void_fraction[at] : 1));
	*rate /= fluid->density * s->capacity;
	ts_grid_field_free(k);
	return TS_OK;
}

/* The fluid gives the heat of `every` steps with the T that it has at their beginning. */
static enum ts_status limit_exchange(struct ts_instance *self, struct tsim *sim,
				     struct ts_plan_report *report)
{
	static const double BLOCKS = 8; /* of ranks that may meet in a cell */
	const struct state *s = self->state;
	struct ts_fluid *fluid = s->fluid;
	double rate = 0;

	if (!s->heat)
		return TS_OK;
	if (!sim->division)
		TS_TRY(ts_flow_require_fields(sim, "fix flow/scalar", &self->where, &fluid));
	TS_TRY(ts_near_particles_ready(fluid, sim));
	TS_TRY(exchange_rate(self, sim, &rate));
	rate *= (double)s->projection->every;
	report->undecided |= sim->division && BLOCKS * rate * sim->clock.dt > 1;
	return ts_report_limit(report, rate > 0 ? 1 / rate : INFINITY, false, &self->where,
			       "explicit heat exchange of fix flow/scalar, rho c e V/sum(pi d k Nu) of a "
			       "cell divided by `every`");
}

static enum ts_status plan(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report)
{
	const struct state *s = self->state;
	const struct ts_projection *p = s->projection;
	long n;

	TS_TRY(limit_exchange(self, sim, report));
	if (report->limits_only)
		return TS_OK;
	if (p->substeps) /* else the fluid chooses its steps later */
		TS_TRY(count_substeps(self, sim, (double)p->every * sim->clock.dt / (double)p->substeps, &n));
	ts_report_line(report, "scalar",
		       "convection %s, diffusivity %g, stable at present up to %g (divided into substeps "
		       "automatically)",
		       ts_scalar_schemes[s->scheme], s->transport.diffusivity,
		       ts_transport_limit(&s->transport, s->fluid));
	report->bytes += 4 * 8.0 * (double)s->size;
	return TS_OK;
}

static void fini(struct ts_instance *self)
{
	struct state *s = self->state;

	ts_transport_release(&s->transport);
	ts_cell_order_release(&s->order);
	ts_free(s->heat_rate);
}

#define FACE(name, k)                                                                                       \
	TS_SOME_KEYWORD(name, struct state, face_words[k], 0,                                               \
			.help = "condition on this face: value T, flux Q (heat per area and time into the " \
				"fluid), or none; numbers or v_NAME")
static const struct ts_arg args[] = {
	TS_REAL("conductivity", struct state, conductivity, .range = TS_NOT_NEGATIVE, .fallback = "0",
		.unit = "", .help = "thermal conductivity k of the fluid"),
	TS_REAL("capacity", struct state, capacity, .range = TS_POSITIVE, .fallback = "1", .unit = "",
		.help = "specific heat capacity c of the fluid"),
	TS_NUMBER("initial", struct state, initial, .fallback = "0", .unit = "temperature",
		  .help = "initial T: a number or v_NAME"),
	TS_SOME_KEYWORD("set", struct state, set, TS_REPEAT,
			.help = "x|y|z name: internal-style variable that is set to the coordinate of each "
				"cell before `initial` is evaluated; may be repeated"),
	TS_NUMBER("source", struct state, source, .fallback = "0", .unit = "",
		  .help = "heat source per volume and time, uniform: a number or v_NAME"),
	FACE("xlo", 0),
	FACE("xhi", 1),
	FACE("ylo", 2),
	FACE("yhi", 3),
	FACE("zlo", 4),
	FACE("zhi", 5),
	TS_ENUM("convection", struct state, scheme, ts_scalar_schemes, .fallback = "vanleer",
		.help = "convection scheme; all but central keep T within its bounds"),
	TS_ENUM("exchange", struct state, exchange, exchanges, .fallback = "none",
		.help = "heat exchange with the particles of the group, whose temperature is that of fix "
			"heat/gran"),
	TS_ARGS_END,
};

TS_STYLE(fix, ts_style, ts_fix_flow_scalar)
const struct ts_style ts_fix_flow_scalar = {
	.name = "flow/scalar",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_OWN | TS_RANKS_OUTPUTS | TS_RANKS_ROWLESS,
	.summary = "Transport of temperature or another scalar by the fluid",
	.doc = "rho c (d(e T)/dt + div(e u T)) = div(e k grad T) + source + exchange, with e the void "
	       "fraction (of fix void_fraction, else 1). With capacity 1 and conductivity rho D, T is any "
	       "concentration with diffusivity D. The finite-volume scheme is conservative. Steps of the "
	       "fluid are divided into substeps if the stability of the scheme requires it. The time scheme "
	       "is Heun's, with `convection central` the Runge-Kutta scheme of third order, because central "
	       "differences without conduction are unstable with Heun's. Bodies of fix immersed/boundary "
	       "conduct as the fluid does, which is warned of.\n\n"
	       "`initial` is evaluated in the cells of the grid with which the first run begins. After a run "
	       "each cell keeps its T if the grid changes, with a warning. `set` needs an `initial` "
	       "v_NAME.\n\n"
	       "On a face of the grid either T is given (`value`), or the heat flux by conduction (`flux`), "
	       "or there is no conduction (`none`, the default). An inflow should have a value; otherwise "
	       "the fluid enters with the T of the first cell. Values, fluxes and a source that vary are "
	       "linear in time within a step of the fluid, which is of second order. In two dimensions the "
	       "faces zlo and zhi have no conditions.\n\n"
	       "If particles are inserted into a closed grid or removed from it, the volume of the "
	       "incompressible fluid changes without flow across the faces. What vanishes or appears has the "
	       "T of the cell: T does not change, and the heat in the fluid changes with its volume.\n\n"
	       "`exchange ranz_marshall` transfers to each particle of the group the heat per time Q = pi "
	       "d^2 h (T - T_p), with h = Nu k/d, Nu = 2 + 0.6 Re^(1/2) Pr^(1/3), Re = rho e |u - v| d/mu, "
	       "and takes it from the fluid; T_p is the temperature of fix heat/gran. In two dimensions, "
	       "where heat is per unit depth, Q is that of a row of 3/(2 d) spheres per unit depth, whose "
	       "volume is that of the disc. The exchange is explicit: a warning is given if the time step "
	       "exceeds rho c e V/sum(pi d k Nu), the sum over the particles in a cell of volume V, divided "
	       "by N with `every N` of the flow style. T oscillates beyond it, and diverges beyond twice of "
	       "it.\n\n"
	       "f_ID[1] is the heat in the fluid, the integral of rho c e T over the grid, in two dimensions "
	       "with the depth of the box, f_ID[2] the heat per time into all particles, per unit depth, "
	       "f_ID[3] and f_ID[4] are the minimum and maximum of T. In the first step of the fluid de/dt "
	       "is not known and taken as 0: T is kept while e becomes that of the particles after the step, "
	       "and f_ID[1] changes accordingly; from then on heat is conserved. f_ID[i][j] is for cell i "
	       "the centre (j = 1, 2, 3) and T (j = 4).",
	.example =
		"flow_style projection cells 32 32 1 viscosity 1.8e-5 density 1.2\n"
		"fix T all flow/scalar conductivity 0.026 capacity 1005 initial 300 xlo value 320 xhi flux 5",
	.cite = "W. E. Ranz, W. R. Marshall, Chem. Eng. Prog. 48 (1952) 141",
	.family = TS_FAMILY_FLOW_PART,
	.args = args,
	.state_size = sizeof(struct state),
	.saved = saved,
	.archive = archive,
	.values = values,
	.init = init,
	.hook = { [TS_STAGE_POST_FORCE] = post_force },
	.plan = plan,
	.fini = fini,
};
