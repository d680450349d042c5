#include <inttypes.h>
#include <math.h>

#include "base/hash.h"
#include "box/domain.h"
#include "core/report.h"
#include "film/film_plane.h"
#include "film/film_velocity.h"
#include "film/flow_reynolds.h"
#include "flow/flow.h"
#include "flow/flow_arguments.h"
#include "flow/fluid.h"

#include "base/banned.h"

enum { MOST_CELLS = 4000000 };
enum { EACH_STEP, EACH_RUN };
enum { REFUSED, SOLID };

/* Slope of the gap above which the plan of a run says that a film is no model of it. */
static const double STEEP = 0.3;

/* ---- the fluid at a place */

static void velocity(const struct ts_instance *self, const double x[3], double u[3])
{
	const struct ts_film_flow *flow = self->state;
	const struct ts_film_surface *lower = &flow->surface[0];
	struct ts_film_point point;
	double z, slope[2], rate;

	ts_film_sample_with(&flow->film, flow->bottom, x, &point, &z, slope);
	rate = lower->now[2];
	if (!lower->stays)
		rate -= lower->now[0] * slope[0] + lower->now[1] * slope[1];
	ts_film_profile(&point, fmin(fmax((x[2] - z) / point.gap, 0), 1), slope, rate, u);
}

static double viscosity(const struct ts_instance *self)
{
	return ((const struct ts_reynolds *)self->state)->viscosity;
}

static double density(const struct ts_instance *self)
{
	return ((const struct ts_reynolds *)self->state)->density;
}

/* ---- geometry and edges, once */

struct pair {
	int64_t n[2];
};
static const struct ts_arg pair_rows[] = {
	TS_INT("NX", struct pair, n[0], .flags = TS_POSITIONAL, .range = TS_POSITIVE),
	TS_INT("NY", struct pair, n[1], .flags = TS_POSITIONAL, .range = TS_POSITIVE),
	TS_ARGS_END,
};

static enum ts_status make_field(struct ts_instance *self, struct tsim *sim, double **field)
{
	const struct ts_reynolds *s = self->state;

	*field = ts_arena_alloc(&self->arena, ts_film_cells(&s->flow.film), sizeof **field);
	return *field ? TS_OK : ts_nomem(&sim->error);
}

static enum ts_status make_film(struct ts_instance *self, struct tsim *sim)
{
	struct ts_reynolds *s = self->state;
	struct ts_film *f = &s->flow.film;
	struct pair cells = { .n = { 0 } };

	TS_TRY(ts_args_parse(sim, "flow_style reynolds: cells", pair_rows, s->cells,
			     ts_instance_word(self, "cells"), &self->arena, &cells));
	if (cells.n[0] > MOST_CELLS / cells.n[1])
		return ts_fail(&sim->error, TS_RANGE, ts_instance_word(self, "cells"),
			       "flow_style reynolds: %" PRId64 " x %" PRId64
			       " cells are too many: at most %d",
			       cells.n[0], cells.n[1], MOST_CELLS);
	for (int d = 0; d < 2; d++) {
		f->n[d] = (int)cells.n[d];
		if (ts_box_periodic(&sim->domain->box, d) && f->n[d] < 3)
			return ts_fail(&sim->error, TS_RANGE, ts_instance_word(self, "cells"),
				       "flow_style reynolds: %d cells along %s, where the box is periodic; "
				       "expected at least 3",
				       f->n[d], d ? "y" : "x");
	}
	f->viscosity = s->viscosity;
	f->density = s->density;
	f->ambient = s->ambient;
	f->floating = s->floating;
	f->slip[0] = s->slip[0];
	f->slip[1] = s->slip[1];
	f->cavity_pressure = s->cavity;
	f->shape = (enum ts_film_shape)s->shape;
	f->cavitation = (enum ts_film_cavitation)s->cavitation;
	for (int side = 0; side < 2; side++) {
		TS_TRY(make_field(self, sim, &s->flow.surface[side].z));
		TS_TRY(make_field(self, sim, &s->flow.surface[side].rate));
	}
	TS_TRY(make_field(self, sim, &s->flow.bottom));
	TS_TRY(make_field(self, sim, &s->flow.yield));
	TS_TRY(make_field(self, sim, &s->flow.carried));
	if (ts_film_make(f) == TS_OK)
		return TS_OK;
	ts_film_release(f);
	return ts_nomem(&sim->error);
}

/* ---- solution */

/* The fingerprint of a run contains the values of the formulas: coordinates are at rest at 0 between evaluations, so
 * that it is the same in a run that is continued from a restart file. */
static enum ts_status reset_coordinates(struct ts_instance *self, struct tsim *sim)
{
	static const double origin[3] = { 0 };

	return ts_flow_set_coordinates(sim, ((const struct ts_reynolds *)self->state)->flow.set, origin,
				       &self->where);
}

static void set_cells(struct ts_reynolds *s, const struct tsim *sim)
{
	struct ts_film *f = &s->flow.film;
	const struct ts_box *box = &sim->domain->box;

	for (int d = 0; d < 2; d++)
		for (int i = 0; i <= f->n[d]; i++)
			f->face[d][i] =
				i == f->n[d] ? box->hi[d] : box->lo[d] + ts_box_length(box, d) * i / f->n[d];
}

static uint64_t hash_input(const struct ts_film *f)
{
	struct ts_hash hash = ts_hash_start();
	size_t bytes = ts_film_cells(f) * sizeof(double);

	ts_hash_add(&hash, f->gap, bytes);
	ts_hash_add(&hash, f->rate, bytes);
	for (int d = 0; d < 2; d++) {
		ts_hash_add(&hash, f->face[d], (size_t)(f->n[d] + 1) * sizeof(double));
		ts_hash_add(&hash, f->velocity[0][d], sizeof(double));
		ts_hash_add(&hash, f->velocity[1][d], sizeof(double));
	}
	ts_hash_add(&hash, f->edge, sizeof f->edge);
	ts_hash_add(&hash, &f->time_step, sizeof f->time_step);
	ts_hash_add(&hash, f->content, bytes);
	return ts_hash_value(&hash);
}

static enum ts_status check_cell(struct ts_instance *self, struct tsim *sim, size_t c)
{
	const struct ts_reynolds *s = self->state;
	const struct ts_film *f = &s->flow.film;
	double x = ts_film_centre(f, 0, (int)(c % (size_t)f->n[0]));
	double y = ts_film_centre(f, 1, (int)(c / (size_t)f->n[0]));

	if (f->kind[c] == TS_FILM_FLUID && !(f->gap[c] > 0))
		return ts_fail(&sim->error, TS_PHYSICS, &self->where,
			       "flow_style reynolds: the gap is %g at (%g, %g), the surfaces touch or "
			       "overlap; with `touching solid` there is no fluid in such cells",
			       f->gap[c], x, y);
	if (f->cavitation == TS_FILM_JFO && !s->flow.transient && f->rate[c] != 0)
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "flow_style reynolds: the gap changes at (%g, %g) by %g per time; with "
			       "cavitation jfo this needs `transient yes`",
			       x, y, f->rate[c]);
	return TS_OK;
}

/* A plane above the film moves by its own equation, also where nothing drives the flow before its first step. */
static void tell_rest(const struct ts_instance *self, struct tsim *sim)
{
	struct ts_reynolds *s = self->state;
	const bool fluid = ts_film_has_fluid(&s->flow.film);

	if (s->flow.film.report.driven || s->told || (fluid && s->flow.surface[1].plane_fix))
		return;
	s->told = true;
	ts_warn(&sim->log, &self->where, "flow_style reynolds: %s",
		fluid ? "the surfaces neither slide nor approach each other, and the pressure is "
			"the same at all edges: the fluid is at rest"
		      : "the surfaces touch everywhere: there is no fluid");
}

static enum ts_status solve(struct ts_instance *self, struct tsim *sim)
{
	struct ts_reynolds *s = self->state;
	struct ts_error error = { .status = TS_OK };
	uint64_t input = hash_input(&s->flow.film);

	if (s->solved && input == s->input)
		return TS_OK;
	s->solved = false;
	for (size_t c = 0; c < ts_film_cells(&s->flow.film); c++)
		TS_TRY(check_cell(self, sim, c));
	if (ts_film_solve(&s->flow.film, &error) != TS_OK)
		return ts_fail(&sim->error, error.status, &self->where, "%s", error.message);
	s->solved = true;
	s->input = input;
	tell_rest(self, sim);
	return TS_OK;
}

/* Transient: before the first step the film was full. */
static void begin_content(struct ts_reynolds *s, double dt)
{
	struct ts_film *f = &s->flow.film;

	for (size_t c = 0; c < ts_film_cells(f); c++)
		f->content[c] = fmax(f->gap[c] - f->rate[c] * dt, 0);
	f->time_step = dt;
}

/* The lower surface, and the upper one unless it is a plane that moves with the film. */
static enum ts_status find_surfaces(struct ts_instance *self, struct tsim *sim)
{
	struct ts_reynolds *s = self->state;

	set_cells(s, sim);
	for (int side = 0; side < 2; side++)
		TS_TRY(ts_film_surface_evaluate(self, sim, &s->flow, side));
	return reset_coordinates(self, sim);
}

/* Below the plane as it is. */
static enum ts_status solve_below(struct ts_instance *self, struct tsim *sim)
{
	struct ts_reynolds *s = self->state;

	ts_film_plane_evaluate(&s->flow);
	ts_film_combine(&s->flow);
	if (s->flow.transient && !s->began)
		begin_content(s, sim->clock.dt);
	return solve(self, sim);
}

/* Where -check goes on after an error, a fix may have failed. */
static enum ts_status move_plane(struct ts_instance *self, struct tsim *sim, struct ts_instance *fix,
				 enum ts_film_move how)
{
	const struct ts_film_plane *plane = fix->state;

	if (!plane->move)
		return ts_fail(&sim->error, TS_STATE, &fix->where,
			       "fix %s is not ready, so that the film has no upper surface", fix->id);
	return plane->move(fix, sim, self, how);
}

/* At the present time. */
static enum ts_status evaluate(struct ts_instance *self, struct tsim *sim, enum ts_film_move how)
{
	struct ts_reynolds *s = self->state;
	struct ts_instance *fix = s->flow.surface[1].plane_fix;

	if (s->flow.transient && how == TS_FILM_STEP) {
		ts_film_keep_content(&s->flow.film);
		s->flow.film.time_step = sim->clock.dt;
	}
	TS_TRY(find_surfaces(self, sim));
	s->ready = true;
	if (fix)
		TS_TRY(move_plane(self, sim, fix, how));
	ts_film_combine(&s->flow);
	if (s->flow.transient && !s->began)
		begin_content(s, sim->clock.dt);
	s->began = true;
	return solve(self, sim);
}

static enum ts_status check_plane(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_reynolds *s = self->state;
	const struct ts_film_surface *upper = &s->flow.surface[1];
	const char *why = s->update == EACH_RUN		 ? "`update run`: the wafer moves in each step"
			  : fabs(upper->velocity[2]) > 0 ? "a velocity along z: the wafer has its own"
			  : s->flow.film.piezo.law != TS_FILM_CONSTANT
				  ? "a viscosity that depends on the pressure"
			  : s->touching == SOLID ? "`touching solid`: its forces jump; expected `least_gap`"
			  : s->cavitation == TS_FILM_HALF ? "cavitation half, which conserves no volume"
							  : NULL;

	if (!upper->plane_fix || !why)
		return TS_OK;
	return ts_fail(&sim->error, TS_STATE, ts_instance_word(self, upper->plane_id),
		       "flow_style reynolds: `upper_wafer %s` is not possible with %s", upper->plane_id, why);
}

static enum ts_status check_transient(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_reynolds *s = self->state;
	const char *why =
		s->cavitation != TS_FILM_JFO ? "is for cavitation jfo only: other films have no memory"
		: s->update == EACH_RUN	     ? "needs `update step`"
		: s->touching == SOLID ? "conserves the fluid, but `touching solid` removes it from cells"
				       : NULL;

	if (!s->flow.transient || !why)
		return TS_OK;
	return ts_fail(&sim->error, TS_STATE, ts_instance_word(self, "transient"),
		       "flow_style reynolds: `transient yes` %s", why);
}

/* A script that compares kinds of cavitation says `cavitation none`, and keeps the pressure of the others. */
static enum ts_status check_cavity(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_reynolds *s = self->state;
	const struct ts_place *word = ts_instance_word(self, "cavity_pressure");

	if (s->cavitation != TS_FILM_NONE || word == &self->where ||
	    ts_instance_word(self, "cavitation") != &self->where)
		return TS_OK;
	return ts_fail(&sim->error, TS_STATE, word,
		       "flow_style reynolds: `cavity_pressure` has no effect without `cavitation`, whose "
		       "default none lets the pressure fall below it; expected `cavitation` half, reynolds "
		       "or jfo");
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct ts_reynolds *s = self->state;

	if (sim->dimension == 2)
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "flow_style reynolds: the gap is along z, so it needs three dimensions");
	TS_TRY(ts_domain_require(sim, &self->where));
	TS_TRY(ts_reynolds_check_faces(self, sim));
	TS_TRY(check_transient(self, sim));
	TS_TRY(check_cavity(self, sim));
	TS_TRY(ts_flow_read_set(sim, "flow_style reynolds: set", s->set, &self->where, &self->arena,
				s->flow.set));
	if (s->flow.set[2])
		return ts_fail(&sim->error, TS_SYNTAX, ts_instance_word(self, "set"),
			       "flow_style reynolds: heights are functions of x and y, not of z");
	TS_TRY(ts_film_surface_find(self, sim, &s->flow.surface[0], "lower"));
	TS_TRY(ts_film_surface_find(self, sim, &s->flow.surface[1], "upper"));
	if (!s->flow.film.gap)
		TS_TRY(make_film(self, sim));
	TS_TRY(ts_reynolds_read_edges(self, sim));
	TS_TRY(ts_reynolds_read_viscosity(self, sim));
	TS_TRY(ts_reynolds_read_roughness(self, sim));
	TS_TRY(ts_reynolds_read_asperities(self, sim));
	TS_TRY(check_plane(self, sim));
	s->flow.solid = s->touching == SOLID;
	s->flow.solve = solve_below;
	s->ready = false;
	return reset_coordinates(self, sim);
}

static enum ts_status pre_force(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_reynolds *s = self->state;

	return s->ready && s->update == EACH_RUN
		       ? TS_OK
		       : evaluate(self, sim, sim->run.in_setup ? TS_FILM_SETUP : TS_FILM_STEP);
}

/* At the beginning of a run, also of one that resumes with the forces of the last one. After `run N pre no` the first list is
 * built in a step, which evaluates the film in pre_force. */
static enum ts_status post_build(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_reynolds *s = self->state;

	return s->ready || sim->clock.step > sim->clock.first_step ? TS_OK
								   : evaluate(self, sim, TS_FILM_KEEP);
}

static const char *advances(const struct ts_instance *self)
{
	return ((const struct ts_reynolds *)self->state)->flow.transient ? "the fluid in the gap" : NULL;
}

static enum ts_status archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *archive)
{
	const struct ts_reynolds *s = self->state;

	(void)sim;
	return s->flow.transient ? ts_archive_fixed(archive, "content", TS_SAVED_F64, s->flow.film.content,
						    ts_film_cells(&s->flow.film))
				 : TS_OK;
}

static const struct ts_saved saved[] = {
	TS_SAVE_U8(struct ts_reynolds, began),
	TS_SAVE_F64(struct ts_reynolds, flow.film.time_step),
	TS_SAVED_ROWS_END,
};

static void fini(struct ts_instance *self)
{
	ts_film_release(&((struct ts_reynolds *)self->state)->flow.film);
}

static const char *const cavitations[] = { "none", "half", "reynolds", "jfo", NULL };
static const char *const shapes[] = { "linear", "stepped", NULL };
static const char *const updates[] = { "step", "run", NULL };
static const char *const touchings[] = { "stop", "solid", NULL };

/* What the theory of films neglects. A plane that moves with the film is not known yet. */
static enum ts_status tell_validity(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report)
{
	struct ts_reynolds *s = self->state;
	struct ts_film_validity v;

	if (s->flow.surface[1].plane_fix)
		return TS_OK;
	TS_TRY(find_surfaces(self, sim));
	ts_film_combine(&s->flow);
	v = ts_film_validity(&s->flow.film);
	ts_report_line(report, "theory of films",
		       "neglects inertia, rho U h^2/(eta L) = %.2g, and slopes, (h/L)^2 = %.2g, largest "
		       "%.2g; errors are some times these",
		       v.inertia, v.thickness * v.thickness, v.slope);
	if (v.slope > STEEP)
		ts_report_line(report, "", "the surfaces are too steep for a film: flow_style projection");
	return TS_OK;
}

static enum ts_status plan(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report)
{
	const struct ts_reynolds *s = self->state;
	const struct ts_film *f = &s->flow.film;

	if (report->limits_only)
		return TS_OK;
	ts_report_line(report, "fluid", "film of %d x %d cells, viscosity %g, cavitation %s, solved %s",
		       f->n[0], f->n[1], s->viscosity, cavitations[s->cavitation],
		       s->update == EACH_RUN ? "once in each run" : "when its surfaces have changed");
	report->bytes += ts_film_bytes(f);
	report->whole += ts_film_bytes(f);
	return tell_validity(self, sim, report);
}

static const struct ts_arg args[] = {
	TS_LIST_KEYWORD("cells", struct ts_reynolds, cells, .flags = TS_TO_KEYWORD | TS_STATEFUL,
			.help = "NX NY: numbers of cells along x and y"),
	TS_NUMBER("lower", struct ts_reynolds, flow.surface[0].height, .flags = TS_OPTIONAL, .unit = "length",
		  .help = "height of the lower surface, or v_NAME, a function of the coordinates"),
	TS_NUMBER("upper", struct ts_reynolds, flow.surface[1].height, .flags = TS_OPTIONAL, .unit = "length",
		  .help = "height of the upper surface"),
	TS_WORD("lower_voxel", struct ts_reynolds, flow.surface[0].voxel, .flags = TS_OPTIONAL,
		.help = "instead of lower: ID of a fix surface/voxel with normal z"),
	TS_WORD("upper_voxel", struct ts_reynolds, flow.surface[1].voxel, .flags = TS_OPTIONAL,
		.help = "ID of a fix surface/voxel with normal z, whose columns hang down from `upper`"),
	TS_WORD("upper_wafer", struct ts_reynolds, flow.surface[1].plane_id, .flags = TS_OPTIONAL,
		.help = "instead of upper: ID of a fix wafer, which floats on the film"),
	TS_SOME_KEYWORD("set", struct ts_reynolds, set, 0,
			.help = "`x NAME y NAME`: internal-style variables that receive the coordinates for "
				"v_NAME"),
	TS_VEC3("lower_velocity", struct ts_reynolds, flow.surface[0].velocity, .fallback = "0 0 0",
		.unit = "velocity", .help = "of the lower surface; is added to that of the voxel field"),
	TS_VEC3("upper_velocity", struct ts_reynolds, flow.surface[1].velocity, .fallback = "0 0 0",
		.unit = "velocity", .help = "of the upper surface"),
	TS_FLAG("lower_stays", struct ts_reynolds, flow.surface[0].stays,
		.help = "the material of the lower surface slides along its shape, which stays at its place"),
	TS_FLAG("upper_stays", struct ts_reynolds, flow.surface[1].stays,
		.help = "the same for the upper surface"),
	TS_REAL("lower_slip", struct ts_reynolds, slip[0], .range = TS_NOT_NEGATIVE, .fallback = "0",
		.unit = "length", .help = "slip length of the lower surface"),
	TS_REAL("upper_slip", struct ts_reynolds, slip[1], .range = TS_NOT_NEGATIVE, .fallback = "0",
		.unit = "length", .help = "slip length of the upper surface"),
	TS_SOME_KEYWORD("roughness", struct ts_reynolds, roughness, 0,
			.help = "SIGMA_LOWER SIGMA_UPPER GAMMA: standard deviations of the heights of rough "
				"surfaces, and their Peklenik number: 1/9, 1/6, 1/3, 1, 3, 6 or 9"),
	TS_SOME_KEYWORD("asperities", struct ts_reynolds, asperities, 0,
			.help = "DENSITY RADIUS MODULUS FRICTION: of rough surfaces that touch: number per "
				"area, radius, E', coefficient of friction"),
	TS_REAL("viscosity", struct ts_reynolds, viscosity, .range = TS_POSITIVE, .unit = "pressure time",
		.help = "dynamic viscosity; with `barus` or `roelands` that at pressure 0"),
	TS_REAL("barus", struct ts_reynolds, barus, .flags = TS_OPTIONAL, .range = TS_NOT_NEGATIVE,
		.unit = "1/pressure", .help = "coefficient alpha of the viscosity eta exp(alpha p)"),
	TS_SOME_KEYWORD("roelands", struct ts_reynolds, roelands, 0,
			.help = "ETA_R P_R Z: a viscosity, a pressure and an exponent of Roelands' equation"),
	TS_REAL("density", struct ts_reynolds, density, .range = TS_POSITIVE, .unit = "mass/length^3",
		.help = "density of the fluid"),
	TS_REAL("ambient", struct ts_reynolds, ambient, .fallback = "0", .unit = "pressure",
		.help = "pressure around the film, on its edges and on the other sides of the surfaces"),
	TS_REAL("pressure_xlo", struct ts_reynolds, edge[0][0], .flags = TS_OPTIONAL, .unit = "pressure",
		.help = "pressure at this edge; default: ambient"),
	TS_REAL("pressure_xhi", struct ts_reynolds, edge[0][1], .flags = TS_OPTIONAL, .unit = "pressure",
		.help = "the same for the upper edge along x"),
	TS_REAL("pressure_ylo", struct ts_reynolds, edge[1][0], .flags = TS_OPTIONAL, .unit = "pressure",
		.help = "the same for the lower edge along y"),
	TS_REAL("pressure_yhi", struct ts_reynolds, edge[1][1], .flags = TS_OPTIONAL, .unit = "pressure",
		.help = "the same for the upper edge along y"),
	TS_BOOL("floating", struct ts_reynolds, floating, .fallback = "no",
		.help = "whether parts of the film may have a pressure that is determined but for a "
			"constant, where none is given on their border"),
	TS_SOME_KEYWORD("closed", struct ts_reynolds, closed, 0,
			.help = "edges through which nothing flows: walls or planes of symmetry"),
	TS_SOME_KEYWORD("open", struct ts_reynolds, open, 0,
			.help = "edges where the film ends although the box is periodic, both of an axis"),
	TS_ENUM("cavitation", struct ts_reynolds, cavitation, cavitations, .fallback = "none",
		.help = "what happens where the pressure would be below that of the cavity"),
	TS_REAL("cavity_pressure", struct ts_reynolds, cavity, .fallback = "0", .unit = "pressure",
		.help = "pressure in the cavity; needs `cavitation`"),
	TS_BOOL("transient", struct ts_reynolds, flow.transient, .flags = TS_STATEFUL, .fallback = "no",
		.help = "cavitation jfo: the fluid in the gap is followed in time"),
	TS_ENUM("gap", struct ts_reynolds, shape, shapes, .fallback = "linear",
		.help = "the gap between the centres of cells: linear, or constant in each cell"),
	TS_ENUM("update", struct ts_reynolds, update, updates, .fallback = "step",
		.help = "heights are evaluated in each step, or at the beginning of each run"),
	TS_REAL("least_gap", struct ts_reynolds, flow.least, .range = TS_NOT_NEGATIVE, .fallback = "0",
		.unit = "length", .help = "the gap tends to this length where the surfaces touch or overlap"),
	TS_ENUM("touching", struct ts_reynolds, touching, touchings, .fallback = "stop",
		.help = "where the gap is not positive: the run stops, or the cell is solid, without fluid"),
	TS_ARGS_END,
};

static const char doc[] =
	"A thin film between a lower and an upper surface, z = h1 and z = h2: lubrication. The film covers\n"
	"the box along x and y, in NX x NY cells. The pressure p(x, y) in the gap h = h2 - h1 solves the\n"
	"equation of Reynolds, with the velocities U1 and U2 of the surfaces along the film,\n\n"
	"  dh/dt + div q = 0,   q = h (U1 + U2)/2 - h^3/(12 eta) grad p.\n\n"
	"The fluid has the velocity of a Couette flow and a parabola, with s = (z - h1)/h\n\n"
	"  u = (1 - s) U1 + s U2 + 6 s (1 - s) (q/h - (U1 + U2)/2),\n\n"
	"and across the gap the one with which div u = 0 and the fluid follows both surfaces. Drag fixes "
	"use\n"
	"it; particles do not change it. Outside of the gap the fluid moves as at the nearest surface.\n\n"
	"Heights are numbers, v_NAME, or the mean over each cell of the columns of fix surface/voxel. A\n"
	"formula v_NAME is evaluated at the centres, whose coordinates are set in the internal-style\n"
	"variables of `set` (afterwards 0); it may depend on time. The velocity must be consistent with such "
	"a motion: it\n"
	"is not integrated. The shape of a surface moves with its velocity V, dh/dt = V_z - V.grad h, as\n"
	"-div(V h) with the weights of the flow through faces: surfaces with steps may slide, and an "
	"observer\n"
	"who moves along sees the same pressure to round-off. Exceptions are\n"
	"`lower_stays` and `upper_stays`, where the material slides along a shape that stays, as a belt or\n"
	"the shaft of a bearing: dh/dt = V_z. The columns of `upper_voxel` hang down from the height "
	"`upper`.\n\n"
	"The film is solved again in each step in which heights or velocities have changed, with `update "
	"run`\n"
	"only at the beginning of each run. A direct solver is used: 0.04 s for 256 x 64 cells.\n\n"
	"Equations typeset, assumptions, order and limits: doc/theory-film.md.";
static const char *const doc_more[] = {
	"With the slip lengths b1 and b2 of `lower_slip` and `upper_slip` the fluid at the surfaces has the\n"
	"velocities U1' = U1 + b1 du/dz and U2' = U2 - b2 du/dz (Navier), and with H = h + b1 + b2\n\n"
	"  q = h [(h/2 + b2) U1 + (h/2 + b1) U2]/H - h^2 (h^2 + 4 h (b1 + b2) + 12 b1 b2)/(12 eta H) grad "
	"p;\n\n"
	"U1' and U2' then replace U1 and U2 in u.",
	"With `roughness` the surfaces have Gaussian roughness that the grid does not resolve. h is the "
	"mean\n"
	"gap, and with sigma^2 = SIGMA_LOWER^2 + SIGMA_UPPER^2 the mean flow has the flow factors of Patir "
	"and\n"
	"Cheng (J. Lubr. Tech. 100 (1978) 12; 101 (1979) 220),\n\n"
	"  q = h (U1 + U2)/2 + sigma phi_s (U1 - U2)/2 - phi_p h^3/(12 eta) grad p.\n\n"
	"GAMMA is the correlation length along x by that along y: 1 is isotropic, 9 are grooves along x.\n"
	"u is the profile between smooth surfaces with the flow q. The mean shear stresses on the lower and "
	"the upper\n"
	"surface are\n\n"
	"  +-eta (U2 - U1)/h (phi_f -+ phi_fs) - phi_fp h/2 grad p.\n\n"
	"The run stops where h < 3 sigma, where the surfaces touch, unless there are `asperities`: their "
	"elastic\n"
	"contacts (J. A. Greenwood and J. H. Tripp, Proc. Inst. Mech. Eng. 185 (1970) 625) have the mean "
	"pressure\n\n"
	"  16 sqrt(2) pi/15 (DENSITY RADIUS sigma)^2 MODULUS sqrt(sigma/RADIUS) F_5/2(h/sigma),\n\n"
	"1/MODULUS = (1 - nu1^2)/E1 + (1 - nu2^2)/E2, and FRICTION times this as shear stress; `compute "
	"film` has\n"
	"both. h is then the distance of the mean heights, and the mean gap h_T > h takes its place in q and "
	"dh/dt.\n"
	"The factors are known for h > sigma with GAMMA 1/9, 1/6, 6 and 9, 0.75 sigma with 1/3 and 3, 0.5 "
	"sigma with 1. Not\n"
	"with cavitation jfo, slip, `barus` and `roelands`.",
	"The viscosity depends on the pressure p by Barus' equation, eta(p) = eta exp(alpha p), with\n"
	"`barus`, and by Roelands' equation with `roelands`,\n\n"
	"  eta(p) = eta (eta/ETA_R)^((1 + p/P_R)^Z - 1),   0 < Z <= 1.\n\n"
	"For mineral oils ETA_R = 6.31e-5 Pa s and P_R = 1.96e8 Pa are usual; ln(eta/ETA_R) Z/P_R is Barus'\n"
	"alpha at small pressures. Here p is 0 where the viscosity is `viscosity`: usually the ambient "
	"pressure is 0.\n"
	"The equation is solved for the reduced pressure, the integral of eta/eta(p) from 0 to p, which\n"
	"satisfies the equation of constant viscosity, with each kind of cavitation. The reduced pressure "
	"has\n"
	"an upper limit, 1/alpha with Barus' equation; the run stops if the film needs more. Roelands'\n"
	"equation is used for p > -P_R/2. Drag fixes are refused: they have one viscosity for all particles.",
	"With `upper_wafer` the upper surface is the face of a fix wafer, which the film carries: the fix "
	"finds its\n"
	"height, slopes and their rates together with the pressure. `upper_velocity` slides the face in its "
	"plane.\n"
	"With `least_gap` l the gap is l + (d + sqrt(d^2 + l^2))/2, d = h - l, a smooth function of the "
	"distance h of\n"
	"the surfaces that tends to l where they touch or overlap: the fluid between the asperities of a "
	"contact. So\n"
	"the forces of the film are continuous functions of the place of the wafer. It changes gaps h > l by "
	"about\n"
	"l^2/(4 h).",
	"Edges are at the pressure `ambient`, or at one given by pressure_xlo ...; nothing flows through\n"
	"`closed` edges; edges of a periodic box are periodic unless they are `open`. Each part of the film "
	"needs an edge with a\n"
	"given pressure. With `floating yes` parts without one, in a periodic box or closed all around, "
	"have\n"
	"the pressure `ambient` in their first cell: the flow does not depend on that, loads do. The volume "
	"of such\n"
	"a part must not change. Not with cavitation, `barus` and `roelands`.",
	"Cavitation: `none` accepts any pressure. `half` (half-Sommerfeld) replaces pressures below that of\n"
	"the cavity afterwards; `reynolds` finds the film that ends with a smooth pressure; both do not\n"
	"conserve volume in the cavity, which `compute film` reports as imbalance. `jfo` (Jakobsson, "
	"Floberg\n"
	"and Olsson) conserves it: a fraction theta of the gap is void in the cavity. The film is steady, "
	"and\n"
	"its gap must not change; with `transient yes` the fluid h (1 - theta) in each cell is followed in\n"
	"time from a full film at the first step, by the implicit method of first order in the time step.\n"
	"Restart files then contain it.",
	"Accuracy: second order in the width of the cells; the place where a film with `jfo` ruptures or\n"
	"reforms is of first order. With `gap linear` the gap is linear between the centres of cells, and "
	"the\n"
	"pressure of a plane slider is exact; with `gap stepped` it is constant in each cell, for steps and\n"
	"columns. The equation of Reynolds is the limit of thin gaps: it neglects inertia, of order Re h/L, "
	"and\n"
	"terms of order (h/L)^2. For thicker gaps use flow_style projection.",
	"Numbers: doc/film.md. Related: compute film, compute film/atom, fix surface/voxel, fix drag/stokes.",
	NULL,
};

static const struct ts_arg_group groups[] = {
	{ NULL, "cells lower upper viscosity density lower_velocity upper_velocity cavitation" },
	{ "Surfaces", "lower_voxel upper_voxel upper_wafer set lower_stays upper_stays lower_slip upper_slip "
		      "gap update least_gap touching" },
	{ "Rough surfaces", "roughness asperities" },
	{ "The fluid", "barus roelands" },
	{ "Pressure at the edges",
	  "ambient pressure_xlo pressure_xhi pressure_ylo pressure_yhi floating closed open" },
	{ "Cavitation", "cavity_pressure transient" },
	{ .words = NULL },
};

TS_STYLE(flow, ts_flow_style, ts_flow_reynolds)
const struct ts_flow_style ts_flow_reynolds = {
	.style = { .name = "reynolds",
		   .kind = TS_KIND_FLOW,
		   .ranks = TS_RANKS_OWN,
		   .summary = "A thin film between two surfaces, by the Reynolds equation of lubrication",
		   .purpose = "A lubrication film between two surfaces: bearings, sliding pads, polishing. "
			      "It replaces the fluid of flow_style projection where the gap is thin.",
		   .doc = doc,
		   .doc_more = doc_more,
		   .example = "variable cx internal 0\nvariable wedge equal 2e-6-1e-6*v_cx/1e-3\n"
			      "flow_style reynolds cells 100 10 lower 0 lower_velocity 0.1 0 0 upper v_wedge "
			      "set x cx viscosity 1e-3 density 1000 closed ylo yhi",
		   .cite = "O. Reynolds, Phil. Trans. R. Soc. 177 (1886) 157; B. J. Hamrock, S. R. Schmid "
			   "and B. O. Jacobson, Fundamentals of Fluid Film Lubrication, 2nd ed. (2004), "
			   "chapter 7",
		   .args = args,
		   .groups = groups,
		   .family = TS_FAMILY_FILM,
		   .state_size = sizeof(struct ts_reynolds),
		   .saved = saved,
		   .archive = archive,
		   .advances = advances,
		   .init = init,
		   .hook = { [TS_STAGE_POST_BUILD] = post_build, [TS_STAGE_PRE_FORCE] = pre_force },
		   .plan = plan,
		   .fini = fini },
	.velocity = velocity,
	.viscosity = viscosity,
	.density = density,
	.grid = 1 | 2,
};
