#include <math.h>
#include <stdio.h>
#include <string.h>

#include "core/deferred_loops.h"
#include "core/ranks.h"
#include "core/report.h"
#include "coupling/cell_rehearsal.h"
#include "coupling/outside_grid.h"
#include "flow/boundary.h"
#include "flow/flow_arguments.h"
#include "flow/flow_limits.h"
#include "flow/flow_resolution.h"
#include "flow/fluid_fields.h"
#include "flow/implicit_viscosity.h"
#include "flow/pressure_projection.h"
#include "flow/slab_step.h"
#include "flow/step_rehearsal.h"
#include "flow/void_fraction.h"
#include "particle/division.h"
#include "particle/rank_layout.h"
#include "poisson/pressure_choice.h"

#include "base/banned.h"

static const char *const viscous_names[] = { "explicit", "implicit", "backward", NULL };
static const char *const wall_forms[] = { "quadratic", "linear", NULL };

/* ---- set-up and steps */

static const struct ts_arg cell_rows[] = {
	TS_INT("NX", struct ts_projection, cells[0], .flags = TS_POSITIONAL, .range = TS_WITHIN, .lo = 1,
	       .hi = 1e6, .help = "along x"),
	TS_INT("NY", struct ts_projection, cells[1], .flags = TS_POSITIONAL, .range = TS_WITHIN, .lo = 1,
	       .hi = 1e6, .help = "along y"),
	TS_INT("NZ", struct ts_projection, cells[2], .flags = TS_POSITIONAL, .range = TS_WITHIN, .lo = 1,
	       .hi = 1e6, .help = "along z"),
	TS_ARGS_END,
};

static enum ts_status check_viscous(struct ts_instance *self, struct tsim *sim)
{
	struct ts_projection *p = self->state;
	const char *viscous = viscous_names[p->viscous];
	const struct ts_place *where = ts_instance_word(self, viscous);

	if (p->viscous == TS_VISCOUS_EXPLICIT)
		return TS_OK;
	if (ts_flow_time_schemes[p->time].stages > 1)
		return ts_fail(&sim->error, TS_RANGE, where,
			       "flow_style projection: viscous %s goes with time ab2 or euler, not %s",
			       viscous, ts_flow_time_names[p->time]);
	if (!(p->viscosity > 0))
		return ts_fail(&sim->error, TS_RANGE, where,
			       "flow_style projection: viscous %s needs a viscosity above 0; use viscous "
			       "explicit, which has no stability limit without viscosity",
			       viscous);
	p->theta = p->viscous == TS_VISCOUS_BACKWARD ? 1 : 0.5;
	p->fluid.incremental = true;
	return TS_OK;
}

static enum ts_status read_words(struct ts_instance *self, struct tsim *sim)
{
	struct ts_projection *p = self->state;

	TS_TRY(ts_args_parse(sim, "flow_style projection: cells", cell_rows, p->cell_words, &self->where,
			     &self->arena, p));
	if (p->body_words.n)
		TS_TRY(ts_flow_read_vector(sim, "flow_style projection: body_force", p->body_words,
					   &self->where, &self->arena, p->body_force));
	if (p->body_words.n && p->cells[2] == 1)
		TS_TRY(ts_flow_refuse_depth(sim, "flow_style projection: body_force", p->body_words,
					    p->body_force));
	p->read = true;
	return TS_OK;
}

/* Sets what follows from the present arguments. */
static enum ts_status apply_arguments(struct ts_instance *self, struct tsim *sim)
{
	struct ts_projection *p = self->state;

	if (p->convection < 0)
		p->convection = p->form == TS_FORM_DIFFERENCE ? TS_CONVECTION_DONOR : TS_CONVECTION_QUICK;
	p->substeps = 0;
	if (!ts_streq(p->substeps_word, "auto") &&
	    (!ts_parse_int(p->substeps_word, &p->substeps) || p->substeps < 1))
		return ts_fail(&sim->error, TS_RANGE, ts_instance_word(self, p->substeps_word),
			       "flow_style projection: substeps is a number from 1 on, or auto, not '%s'",
			       p->substeps_word);
	if (p->form == TS_FORM_DIFFERENCE && !ts_convection_schemes[p->convection].difference)
		return ts_fail(&sim->error, TS_RANGE,
			       ts_instance_word(self, ts_convection_names[p->convection]),
			       "flow_style projection: convection %s is for form fv; form fd has donor and "
			       "central",
			       ts_convection_names[p->convection]);
	if (p->form == TS_FORM_CONSERVATIVE && (p->time == TS_TIME_AB2 || p->every > 1))
		return ts_fail(&sim->error, TS_RANGE, ts_instance_word(self, ts_flow_form_names[p->form]),
			       "flow_style projection: form conservative goes with time euler, rk2 or rk3 "
			       "and every 1, not with %s",
			       p->every > 1 ? "every of more than 1" : "time ab2");
	return check_viscous(self, sim);
}

static enum ts_status evaluate_force(struct ts_instance *self, struct tsim *sim)
{
	struct ts_projection *p = self->state;

	for (int d = 0; d < 3; d++)
		TS_TRY(ts_number_now(sim, &p->body_force[d], &self->where, &p->force_now[d]));
	if (!p->force_known)
		memcpy(p->force_before, p->force_now, sizeof p->force_before);
	return ts_number_now(sim, &p->level, &self->where, &p->level_now);
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct ts_projection *p = self->state;
	bool is_run = p->read; /* only in a run are the faces known */

	if (!is_run)
		TS_TRY(read_words(self, sim));
	p->fluid.outside = (struct ts_fluid_outside){ 0 };
	p->moved |= is_run && sim->clock.last_step > sim->clock.step;
	TS_TRY(apply_arguments(self, sim));
	TS_TRY(ts_projection_setup(self, sim));
	if (is_run)
		TS_TRY(ts_projection_begin_on_grid(self, sim));
	ts_projection_find_void_fraction(p, sim);
	if (is_run)
		TS_TRY(ts_projection_solver(self, sim, 0));
	if (ts_projection_not_started(p))
		p->fluid.time = ts_sim_time(sim);
	return TS_OK;
}

/* Counts a step of the simulation for which the fluid waits. The time of equal steps is a product, not a sum. */
static void wait_for_step(struct ts_projection *p, double dt)
{
	/* files of older versions have no time */
	const bool equal = p->waited == 0 || p->elapsed == 0 || dt == p->waited_dt;

	p->waited++;
	p->elapsed = equal ? (double)p->waited * dt : p->elapsed + dt;
	p->waited_dt = equal ? dt : 0;
}

static enum ts_status make_step(struct ts_instance *self, struct tsim *sim)
{
	struct ts_projection *p = self->state;

	p->source_steps++;
	wait_for_step(p, sim->clock.dt);
	if (p->waited < p->every)
		return TS_OK;
	TS_TRY(ts_projection_evaluate_boundary(self, sim));
	TS_TRY(evaluate_force(self, sim));
	TS_TRY(ts_projection_step(self, sim, p->elapsed));
	memcpy(p->force_before, p->force_now, sizeof p->force_before);
	p->force_known = true;
	p->waited = 0;
	return TS_OK;
}

static enum ts_status end_of_step(struct ts_instance *self, struct tsim *sim)
{
	struct ts_projection *p = self->state;

	if (!p->settled) {
		ts_slab_step_complete(p, sim);
		return make_step(self, sim);
	}
	p->settled = false;
	return TS_OK;
}

static const char *advances(const struct ts_instance *self)
{
	(void)self;
	return "the fluid";
}

static bool due(const struct ts_instance *self, const struct tsim *sim)
{
	(void)self;
	(void)sim;
	return true;
}

/* While the particles are divided among ranks: before outputs need all particles, since each rank corrects the forces on its
 * own. The first one tells what all find. */
static enum ts_status settle(struct ts_instance *self, struct tsim *sim)
{
	struct ts_projection *p = self->state;
	struct ts_str *warned = sim->log.warned;
	enum ts_status status;

	ts_deferred_loops_run(sim);
	TS_TRY(ts_coupling_sum_outside(&p->fluid, sim));
	TS_TRY(ts_fluid_share_sources(&p->fluid, sim));
	if (!ts_ranks_first(sim))
		sim->log.warned = NULL;
	status = ts_slab_step_begin_apart(p, sim, &sim->division->blocks) == TS_OK ? make_step(self, sim)
										   : ts_nomem(&sim->error);
	ts_slab_step_end(p);
	sim->log.warned = warned;
	p->settled = true;
	return status;
}

/* Sets the ghosts with which the next run begins, so that a saved state and one that continues are the
 * same. */
static enum ts_status finish(struct ts_instance *self, struct tsim *sim)
{
	struct ts_fluid *fluid = &((struct ts_projection *)self->state)->fluid;

	ts_coupling_report_outside(fluid, sim);
	if (fluid->steps == 0)
		return TS_OK;
	ts_fluid_fill_ghosts(fluid, fluid->u);
	return ts_projection_check_resolution(self, sim);
}

static void fini(struct ts_instance *self)
{
	ts_projection_release(self->state);
}

static enum ts_status archive_field(struct ts_archive *archive, const char *name, char part,
				    const struct ts_grid *grid, double **field, bool now)
{
	char full[32];

	snprintf(full, sizeof full, part ? "%s_%c" : "%s", name, part);
	if (!now || !ts_archive_has(archive, full))
		return TS_OK;
	if (!*field && !(*field = ts_grid_field(grid)))
		return TS_NOMEM;
	return ts_archive_fixed(archive, full, TS_SAVED_F64, *field, grid->size);
}

/* What older files do not have: the time for which the fluid has waited, and the body force of the last step. */
static enum ts_status archive_force_and_wait(struct ts_projection *p, struct ts_archive *archive)
{
	const bool writing = ts_archive_writing(archive);

	if (writing ? p->waited > 0 : ts_archive_has(archive, "elapsed")) {
		TS_TRY(ts_archive_fixed(archive, "elapsed", TS_SAVED_F64, &p->elapsed, 1));
		TS_TRY(ts_archive_fixed(archive, "waited_dt", TS_SAVED_F64, &p->waited_dt, 1));
	}
	if (writing ? p->force_known : ts_archive_has(archive, "force_before")) {
		TS_TRY(ts_archive_fixed(archive, "force_before", TS_SAVED_F64, p->force_before, 3));
		p->force_known = true;
	}
	if (writing ? p->history_dt > 0 : ts_archive_has(archive, "history_force"))
		return ts_archive_fixed(archive, "history_force", TS_SAVED_F64, p->history_force, 3);
	for (int d = 0; d < 3 && !writing; d++)
		p->history_force[d] = NAN;
	return TS_OK;
}

/* The faces of the grid to which the fields belong, which older files do not have. */
static enum ts_status archive_faces(struct ts_projection *p, struct ts_archive *archive)
{
	static const char *const names[] = { "face_x", "face_y", "face_z" };

	for (int d = 0; d < 3; d++) {
		const size_t n = (size_t)p->fluid.grid.n[d] + 1;

		if (ts_archive_writing(archive) ? !p->field_face[d] : !ts_archive_has(archive, names[d]))
			continue;
		if (!p->field_face[d] && !(p->field_face[d] = ts_alloc(n, sizeof *p->field_face[d])))
			return TS_NOMEM;
		TS_TRY(ts_archive_fixed(archive, names[d], TS_SAVED_F64, p->field_face[d], n));
	}
	return TS_OK;
}

/* Saves or restores the fields, ghosts included; optional fields if they are allocated, or in the file. */
static enum ts_status archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *archive)
{
	struct ts_projection *p = self->state;
	struct ts_fluid *fluid = &p->fluid;
	bool writing = ts_archive_writing(archive);
	const struct {
		const char *name;
		double **field;
	} vectors[] = { { "u", fluid->u },
			{ "force", fluid->force },
			{ "exchange", fluid->exchange },
			{ "used", fluid->exchange_velocity },
			{ "history", p->history },
			{ "empty_face", fluid->void_fraction_face },
			{ "inertia", fluid->momentum_void_fraction } },
	  scalars[] = { { "p", &fluid->p },
			{ "empty", &fluid->void_fraction },
			{ "empty_rate", &fluid->void_fraction_rate },
			{ "empty_before", &p->void_fraction_before },
			{ "increment", &p->increment },
			{ "p_mean", &fluid->p_mean } };
	enum ts_status status = TS_OK;

	ts_slab_step_complete(p, sim);
	for (size_t k = 0; k < sizeof vectors / sizeof *vectors; k++)
		for (int d = 0; d < 3 && status == TS_OK; d++)
			status = archive_field(archive, vectors[k].name, "xyz"[d], &fluid -> grid,
					       &vectors[k].field[d], !writing || vectors[k].field[d]);
	for (size_t k = 0; k < sizeof scalars / sizeof *scalars && status == TS_OK; k++)
		status = archive_field(archive, scalars[k].name, '\0', &fluid->grid, scalars[k].field,
				       !writing || *scalars[k].field);
	if (status == TS_OK)
		status = archive_faces(p, archive);
	if (status == TS_OK)
		status = archive_force_and_wait(p, archive);
	if (status == TS_OK)
		status = ts_projection_archive_boundary(p, sim, archive);
	return status == TS_NOMEM ? ts_nomem(&sim->error) : status;
}

static void fingerprint(const struct ts_instance *self, const struct tsim *sim, struct ts_hash *hash)
{
	const struct ts_projection *p = self->state;

	(void)sim;
	for (int d = 0; d < 3; d++)
		ts_hash_add(hash, p->fluid.grid.face[d], (size_t)(p->fluid.grid.n[d] + 1) * sizeof(double));
	for (int d = 0; d < 3; d++)
		for (int side = 0; side < 2; side++) {
			const struct ts_flow_face_velocity *given = &p->velocity_before[d][side];

			ts_hash_add(hash, &p->fluid.face[d][side], sizeof p->fluid.face[d][side]);
			ts_hash_add(hash, given->constant, sizeof given->constant);
		}
}

/* ---- slots of struct ts_flow_style */

static void velocity(const struct ts_instance *self, const double x[3], double u[3])
{
	ts_fluid_velocity(&((const struct ts_projection *)self->state)->fluid, x, u);
}

static double viscosity(const struct ts_instance *self)
{
	return ((const struct ts_projection *)self->state)->viscosity;
}

static double density(const struct ts_instance *self)
{
	return ((const struct ts_projection *)self->state)->density;
}

static struct ts_fluid *fluid(const struct ts_instance *self)
{
	return &((struct ts_projection *)self->state)->fluid;
}

static const struct ts_rank_blocks *blocks(const struct tsim *sim)
{
	return ts_division_blocks_now(sim);
}

static void complete(struct ts_instance *self, const struct tsim *sim)
{
	ts_slab_step_complete(self->state, sim);
}

/* Whether a wall or a body prescribes the tangential velocity on its surface. */
static bool has_no_slip_surface(const struct ts_projection *p, const struct tsim *sim)
{
	const struct ts_instance *inst;

	for (int d = 0; d < p->fluid.grid.dimensions; d++)
		for (int side = 0; side < 2; side++)
			if (p->fluid.face[d][side] == TS_FLOW_WALL)
				return true;
	for (size_t k = 0; (inst = ts_sim_next_of(sim, TS_KIND_FIX, TS_FAMILY_FLOW_PART, &k));)
		if (((const struct ts_flow_part *)inst->state)->force)
			return true;
	return false;
}

/* Without viscosity the boundary layer beside a no-slip wall has the thickness of a cell: an artefact. */
static void warn_of_walls(struct ts_instance *self, struct tsim *sim)
{
	struct ts_projection *p = self->state;

	if (p->viscosity > 0 || p->warned_walls || !has_no_slip_surface(p, sim))
		return;
	p->warned_walls = true;
	ts_warn(&sim->log, ts_instance_word(self, "viscosity"),
		"flow_style projection: a fluid with viscosity 0 does not stick to walls and bodies, but "
		"they set its velocity; use flow_boundary FACE slip, or a viscosity");
}

enum { VOID_FIELDS = 6 }; /* void fraction at centres and on faces, its rate, and that of the last step */

/* `count` of struct ts_report_rehearsal: in the steps of the simulation for one of the fluid. */
static enum ts_status count_sent(struct ts_instance *self, struct tsim *sim,
				 const struct ts_rank_layout *layout, int iterations,
				 struct ts_world_counts *sent)
{
	const struct ts_projection *p = self->state;

	bool near;

	TS_TRY(ts_projection_rehearse(self, sim, &layout->blocks, iterations, sent, &near));
	if (ts_cell_rehearse(sim, &p->fluid, layout, p->every, near, sent) != TS_OK)
		return ts_nomem(&sim->error);
	return TS_OK;
}

/* What ranks send in a step. */
static void report_ranks(struct ts_instance *self, const struct tsim *sim, struct ts_plan_report *report)
{
	const struct ts_projection *p = self->state;
	const struct ts_instance *part;

	for (size_t k = 0; (part = ts_sim_next_of(sim, TS_KIND_FIX, TS_FAMILY_FLOW_PART, &k));) {
		const struct ts_flow_part *flow_part = part->state;

		report->shared.messages += flow_part->shared > 0;
		report->shared.bytes += (double)flow_part->shared;
	}
	if (ts_ranks(sim) > 1 && !ts_slab_step_divides(p, ts_ranks(sim)))
		ts_report_line(report, "fluid's ranks",
			       "each of the %d computes the whole step: they divide grids of three "
			       "dimensions with as many cells along z at least (%d here)",
			       ts_ranks(sim), p->fluid.grid.n[2]);
	if (ts_ranks(sim) > TS_REHEARSED_MOST)
		ts_report_line(report, "fluid's ranks",
			       "what they send for the fluid is counted for up to %d ranks, not here",
			       TS_REHEARSED_MOST);
	if (!p->pressure || ts_ranks(sim) > TS_REHEARSED_MOST)
		return;
	report->rehearsal = (struct ts_report_rehearsal){ .self = self,
							  .count = count_sent,
							  .steps = p->every,
							  .looks = ts_pressure_style_of(p->pressure)->looks };
}

static enum ts_status count_planes(struct ts_instance *self, struct tsim *sim,
				   struct ts_rehearsed_planes *planes)
{
	struct ts_rank_layout layout = { .ranks = ts_ranks(sim) };
	enum ts_status status = ts_rank_layout_make(sim, layout.ranks, 0, &layout);

	if (status == TS_OK)
		status = ts_projection_rehearse_planes(self, sim, &layout.blocks, planes);
	ts_rank_layout_release(&layout);
	return status;
}

/* The part of the memory of fields and solver that a rank has. */
static enum ts_status report_memory_of_rank(struct ts_instance *self, struct tsim *sim, double bytes,
					    struct ts_plan_report *report)
{
	struct ts_projection *p = self->state;
	const int ranks = ts_ranks(sim), all = p->fluid.grid.n[2] + 2 * TS_GRID_GHOSTS;
	struct ts_rehearsed_planes planes = { all, all };
	double *field[TS_FIELDS_MOST], near, own;

	if (ranks > 1 && ranks <= TS_REHEARSED_MOST && p->pressure && sim->reading.explain)
		TS_TRY(count_planes(self, sim, &planes));
	near = 8 * (double)p->fluid.grid.size *
	       (double)ts_fluid_fields_list(p, sim, TS_FIELDS_NEAR, false, field);
	own = ((bytes - near) * planes.all + near * planes.near) / all;
	report->whole += own;
	report->elsewhere += bytes - own;
	report->divides_grid = planes.all < all;
	if (planes.all < all)
		ts_report_line(report, "fluid's planes", "each rank has up to %d of %d in memory",
			       planes.near, all);
	return TS_OK;
}

/* Fields of the steps of this run: velocity, predictor, pressure and right-hand side, those of the time scheme, and of
 * particles: f; k, its velocity, and weights of faces; void fraction; E in form conservative. */
static double count_fields(const struct ts_projection *p)
{
	const struct ts_flow_time_scheme *scheme = &ts_flow_time_schemes[p->time];
	const struct ts_fluid *fluid = &p->fluid;
	int fields = 8 + (scheme->stages > 1) * 3 + scheme->history * 3 + (p->viscous != TS_VISCOUS_EXPLICIT);

	fields += fluid->force[0] ? 3 : 0;
	fields += fluid->exchange[0] ? 9 : 0;
	fields += fluid->void_fraction ? VOID_FIELDS : 0;
	fields += fluid->void_fraction && p->form == TS_FORM_CONSERVATIVE ? 15 : 0;
	return fields + (fluid->p_mean != NULL);
}

static enum ts_status report_plan(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report)
{
	const struct ts_projection *p = self->state;
	const struct ts_grid *grid = &p->fluid.grid;
	double mean, before = report->bytes;

	/* Velocities that a run has left are those of its boundaries: of these, the next step checks the balance. */
	if (ts_projection_not_started(p))
		TS_TRY(ts_projection_net_outflow(self, sim, &mean));
	TS_TRY(ts_projection_check_pressure(self, sim));
	if (p->viscous != TS_VISCOUS_EXPLICIT && p->fluid.void_fraction)
		return ts_fail(&sim->error, TS_STATE, ts_instance_word(self, viscous_names[p->viscous]),
			       "flow_style projection: viscous %s cannot be used with a void fraction (fix "
			       "void_fraction): use viscous explicit, with substeps auto if it limits the "
			       "step",
			       viscous_names[p->viscous]);
	warn_of_walls(self, sim);
	ts_report_line(report, "fluid", "%d x %d x %d cells, convection %s (%s), time %s", grid->n[0],
		       grid->n[1], grid->n[2], ts_convection_names[p->convection],
		       ts_flow_form_names[p->form], ts_flow_time_names[p->time]);
	ts_pressure_explain(sim, &p->poisson, p->fluid.void_fraction || p->fluid.exchange[0], report);
	report->bytes += 8 * count_fields(p) * (double)grid->size;
	TS_TRY(report_memory_of_rank(self, sim, report->bytes - before, report));
	report_ranks(self, sim, report);
	if (!p->fluid.void_fraction)
		ts_report_left_out(report, "void fraction", 0, 8 * VOID_FIELDS * (double)grid->size,
				   "there is no fix void_fraction");
	if (!p->substeps)
		ts_report_line(report, "fluid's steps",
			       "as its stability limits require: %g of the stable step, which is %g",
			       p->courant, ts_flow_limit(p));
	return TS_OK;
}

/* Limits are checked before the step of the fluid. Ranks look at them again, with all particles, after it if they have doubts. */
static struct ts_flow_limits find_limits(struct ts_projection *p, const struct tsim *sim)
{
	double *before = p->limits_before;
	struct ts_flow_limits limits;

	if (p->settled && p->limits_step == sim->clock.step)
		return (struct ts_flow_limits){ before[0], before[1], before[2] };
	limits = ts_flow_limits(p);
	before[0] = limits.viscous;
	before[1] = limits.courant;
	before[2] = limits.growth;
	p->limits_step = sim->clock.step;
	return limits;
}

static enum ts_status plan(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report)
{
	struct ts_projection *p = self->state;
	const struct ts_flow_time_scheme *scheme = &ts_flow_time_schemes[p->time];
	struct ts_flow_limits limits;
	/* steps of the simulation per substep of the fluid */
	double steps = (double)p->every / (double)(p->substeps ? p->substeps : 1);
	size_t before = report->nlimits;

	for (int d = 0; d < 3 && !report->limits_only; d++) /* a variable may have been deleted */
		TS_TRY(ts_sim_defer_error(sim, ts_number_check(sim, &p->body_force[d], &self->where)));
	if (!report->limits_only)
		TS_TRY(report_plan(self, sim, report));
	if (!p->substeps)
		return report->limits_only
			       ? TS_OK
			       : ts_projection_choose_substeps(self, sim, (double)p->every * sim->clock.dt);
	limits = find_limits(p, sim);
	TS_TRY(ts_report_limit(report, limits.viscous / steps, true, &self->where,
			       "the fluid's viscosity and convection (time %s), which `substeps auto` avoids",
			       scheme->name));
	TS_TRY(ts_report_limit(report, limits.courant / steps, true, &self->where,
			       "the fluid's Courant number, %g h/u, which `substeps auto` avoids",
			       scheme->courant));
	ts_report_watched(report, before);
	return ts_report_limit(report, limits.growth / steps, false, &self->where,
			       "slow growth of convected waves that viscosity does not damp (time %s)",
			       scheme->name);
}

static const struct ts_saved saved[] = {
	TS_SAVE_F64(struct ts_projection, fluid.dt),
	TS_SAVE_F64(struct ts_projection, fluid.time),
	TS_SAVE_I64(struct ts_projection, fluid.steps),
	TS_SAVE_F64(struct ts_projection, fluid.courant),
	TS_SAVE_F64(struct ts_projection, fluid.divergence),
	TS_SAVE_F64(struct ts_projection, fluid.residual),
	TS_SAVE_I32(struct ts_projection, fluid.iterations),
	TS_SAVE_F64(struct ts_projection, history_dt),
	TS_SAVE_U8(struct ts_projection, empty_known),
	TS_SAVE_U8(struct ts_projection, before_known),
	TS_SAVE_I64(struct ts_projection, source_steps),
	TS_SAVE_I64(struct ts_projection, done),
	TS_SAVE_I64(struct ts_projection, waited),
	TS_SAVED_ROWS_END,
};

static const struct ts_arg args[] = {
	TS_LIST_KEYWORD("cells", struct ts_projection, cell_words, .flags = TS_TO_KEYWORD | TS_STATEFUL,
			.help = "NX NY NZ: numbers of cells; NZ 1: a two-dimensional flow, "
				"and drag along z acts on the particles alone"),
	TS_REAL("viscosity", struct ts_projection, viscosity, .range = TS_NOT_NEGATIVE,
		.unit = "pressure time", .help = "dynamic viscosity"),
	TS_REAL("density", struct ts_projection, density, .range = TS_POSITIVE, .unit = "mass/length^3",
		.help = "density of the fluid"),
	TS_ENUM("time", struct ts_projection, time, ts_flow_time_names, .fallback = "euler",
		.help = "time integration scheme"),
	TS_ENUM("viscous", struct ts_projection, viscous, viscous_names, .fallback = "explicit",
		.help = "viscous term explicit, implicit (Crank-Nicolson) or backward (Euler); the last two "
			"do not limit the step and need time ab2 or euler"),
	TS_INT("every", struct ts_projection, every, .fallback = "1", .range = TS_POSITIVE, .unit = "steps",
	       .flags = TS_STATEFUL,
	       .help = "number of steps of the simulation in one step of the fluid, which uses the mean of "
		       "their forces"),
	TS_WORD("substeps", struct ts_projection, substeps_word, .fallback = "1",
		.help = "number of steps of the fluid in one step of the simulation; auto: as its stability "
			"limits require"),
	TS_REAL("courant", struct ts_projection, courant, .fallback = "0.5", .range = TS_WITHIN, .lo = 0.001,
		.hi = 1, .help = "with substeps auto: fraction of the largest stable step"),
	TS_REGION("region", struct ts_projection, region, .flags = TS_OPTIONAL,
		  .help = "the grid fills the bounding box of this region; without: the simulation box"),
	TS_ENUM("convection", struct ts_projection, convection, ts_convection_names, .flags = TS_OPTIONAL,
		.help = "scheme for the velocity convected through the sides of control volumes; default: "
			"quick, or donor with form fd"),
	TS_REAL("gamma", struct ts_projection, gamma, .range = TS_FRACTION, .fallback = "0.5",
		.help = "with convection donor: fraction of upwind differences, the rest is central"),
	TS_ENUM("form", struct ts_projection, form, ts_flow_form_names, .fallback = "fv",
		.help = "convection term: finite volumes (fv), finite differences of u grad u (fd), or "
			"finite volumes of the momentum e u (conservative)"),
	TS_ENUM("wall", struct ts_projection, wall, wall_forms, .fallback = "quadratic",
		.help = "velocity profile along the normal between a wall and the points next to it"),
	TS_SOME_KEYWORD("body_force", struct ts_projection, body_words, 0,
			.help = "FX FY FZ: acceleration of the fluid, numbers or equal-style variables"),
	TS_NUMBER("pressure_level", struct ts_projection, level, .fallback = "0", .unit = "pressure",
		  .help = "mean pressure if no face is open: a number or an equal-style variable"),
	TS_ARGS_END,
};

TS_STYLE(flow, ts_flow_style, ts_flow_projection)
const struct ts_flow_style ts_flow_projection = {
	.style = { .name = "projection",
		   .kind = TS_KIND_FLOW,
		   .ranks = TS_RANKS_OWN | TS_RANKS_PARTICLES | TS_RANKS_ROWLESS,
		   .due = due,
		   .settle = settle,
		   .advances = advances,
		   .family = TS_FAMILY_PROJECTION,
		   .summary = "Incompressible flow on a staggered grid by the projection method",
		   .doc = "Solves du/dt + div(u u) = -grad p/rho + nu lap u + g, div u = 0, on a Cartesian\n"
			  "grid that fills the box or the bounding box of a region. Pressures are defined "
			  "at\n"
			  "the centres of cells, velocities on their faces (staggered grid). In each step a\n"
			  "velocity is predicted without pressure and then projected onto a field without\n"
			  "divergence; the command pressure_style selects the solver for the pressure.\n"
			  "flow_grid sets the widths of the cells, flow_boundary the boundary conditions,\n"
			  "flow_set the initial velocity. Without an outlet or an inlet with given "
			  "pressure,\n"
			  "the pressure is known up to a constant: pressure_level is its mean over the "
			  "grid.\n\n"
			  "If fixes require it, the volume-averaged equations are solved: de/dt + div(e u) "
			  "=\n"
			  "0 and e rho (du/dt + u grad u) = -e grad p + div(e mu grad u) + e rho g + f - k\n"
			  "u, with e the void fraction, f and k the explicit and semi-implicit force of the\n"
			  "particles per volume; k u is taken at the new velocity.\n\n"
			  "`convection`: the velocity on the side of a control volume is for `central` the\n"
			  "mean of its neighbours; for `donor` a fraction gamma of the upstream value and\n"
			  "the rest of the mean; for `quick` a parabola; `cubista` is quick, bounded by the\n"
			  "neighbouring values. All are of second order in space except donor, which is of\n"
			  "first order in proportion to gamma. `form fd` computes u grad u by finite\n"
			  "differences instead of div(u u) by finite volumes, and does not conserve\n"
			  "momentum. `form conservative` integrates e u instead of u in time, with fluxes\n"
			  "that satisfy the continuity equation of e on the control volumes of the faces:\n"
			  "together with fix void_fraction and fix flow/pressure_gradient the momentum of\n"
			  "particles and fluid is conserved to round-off (flow_px, flow_py, flow_pz;\n"
			  "doc/coupling.md). Without void fraction it equals fv. It is available with time\n"
			  "euler, rk2 and rk3. With `wall quadratic` the shear stress at walls is of second\n"
			  "order, and the parabolic profile of a channel is exact.\n\n"
			  "`time`: euler is of first order, ab2 (Adams-Bashforth) and rk2 (Runge-Kutta) of\n"
			  "second, rk3 of third. Boundary values and a body_force that vary are linear in\n"
			  "time within a step, which is of second order.\n"
			  "`viscous implicit` (Crank-Nicolson) and `backward` (Euler) are factored by axes\n"
			  "and stable for any viscosity; they are of second and first order.\n\n"
			  "Stability limits of the time step: with explicit viscosity dt <= 2/(nu sum "
			  "4/h^2)\n"
			  "(ab2: half of it, rk3: 1.26 times), reduced by the numerical viscosity of upwind\n"
			  "schemes; Courant number sum |u| dt/h below 1 (ab2 0.7, rk3 1.73); for euler also\n"
			  "dt <= 2 nu/u^2, beyond which waves grow slowly. A run beyond these limits is\n"
			  "refused or a warning is printed; a run that reaches them is stopped and the "
			  "cause\n"
			  "reported. The fluid makes one step in each step of the simulation, one in "
			  "`every`\n"
			  "N steps, or `substeps` in one.\n\n"
			  "Equations typeset, assumptions, order and limits: doc/theory-fluid.md.",
		   .example = "flow_style projection cells 64 64 1 viscosity 0.01 density 1.0\n"
			      "flow_style projection cells 80 10 10 viscosity 1.0e-3 density 1000 convection "
			      "donor gamma 0.5 time rk3 substeps auto body_force 0 0 -9.81",
		   .cite = "A. J. Chorin, Math. Comp. 22 (1968) 745; F. H. Harlow & J. E. Welch, Phys. "
			   "Fluids 8 (1965) 2182",
		   .args = args,
		   .state_size = sizeof(struct ts_projection),
		   .saved = saved,
		   .archive = archive,
		   .fingerprint = fingerprint,
		   .init = init,
		   .hook = { [TS_STAGE_END_OF_STEP] = end_of_step, [TS_STAGE_FINISH] = finish },
		   .plan = plan,
		   .fini = fini },
	.velocity = velocity,
	.viscosity = viscosity,
	.density = density,
	.fluid = fluid,
	.grid = 1 | 2 | 4,
	.complete = complete,
	.blocks = blocks,
};
