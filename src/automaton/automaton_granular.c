#include <inttypes.h>
#include <math.h>

#include "automaton/automaton.h"
#include "automaton/step.h"
#include "base/alloc.h"
#include "box/domain.h"
#include "core/report.h"
#include "core/unclaimed_state.h"
#include "region/region.h"

#include "base/banned.h"

enum { LEAST_ALONG = 3, LEAST_ACROSS = 2 };

struct granular {
	struct ts_automaton automaton;
	struct ts_instance *obstacles;
	double cell, fill, restitution, wall_restitution, roughness, wall[2], start;
	int64_t seed;
	int order, contact, directions, partner, normal;
	bool defined; /* granules are in their places */
};

static struct ts_automaton *automaton_of(const struct ts_instance *self)
{
	return &((struct granular *)self->state)->automaton;
}

/* ---- the lattice in the box */

static enum ts_status check_box(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_box *box = &sim->domain->box;

	if (sim->dimension != 2)
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "automaton_style granular: its eight directions are those of a plane: "
			       "expected `dimension 2`");
	if (!ts_box_periodic(box, 0) || box->face[1][0] != TS_FACE_FIXED || box->face[1][1] != TS_FACE_FIXED)
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "automaton_style granular: the lattice is periodic along x and has walls at "
			       "ylo and yhi: expected `boundary p f p`");
	return TS_OK;
}

/* The box is a whole number of cells. */
static enum ts_status count_cells(struct ts_instance *self, struct tsim *sim, int64_t n[2])
{
	const struct granular *s = self->state;
	const struct ts_box *box = &sim->domain->box;

	for (int d = 0; d < 2; d++) {
		const double cells = ts_box_length(box, d) / s->cell, least = d ? LEAST_ACROSS : LEAST_ALONG;

		if (!(fabs(cells - nearbyint(cells)) <= 1e-6 * fmax(1, 1e-3 * cells)))
			return ts_fail(&sim->error, TS_RANGE, ts_instance_word(self, "cell"),
				       "automaton_style granular: the box has %g cells along %c; expected a "
				       "whole number, as cells are squares",
				       cells, "xy"[d]);
		if (cells < least - 0.5)
			return ts_fail(&sim->error, TS_RANGE, ts_instance_word(self, "cell"),
				       "automaton_style granular: the box has %.0f cell%s along %c; expected "
				       "at least %.0f",
				       cells, cells < 1.5 ? "" : "s", "xy"[d], least);
		n[d] = cells < 4e9 ? (int64_t)nearbyint(cells) : INT64_C(4000000000);
	}
	if (s->order == TS_AUTOMATON_BLOCKS && n[0] < TS_AUTOMATON_BLOCKS_LEAST)
		return ts_fail(&sim->error, TS_RANGE, ts_instance_word(self, "blocks"),
			       "automaton_style granular: `order blocks` needs %d cells along x, the box has "
			       "%" PRId64 ": use `order exact`",
			       TS_AUTOMATON_BLOCKS_LEAST, n[0]);
	if (ts_automaton_bytes(n[0], n[1]) / sizeof(uint32_t) >= 0x7fffffff)
		return ts_fail(&sim->error, TS_RANGE, ts_instance_word(self, "cell"),
			       "automaton_style granular: %" PRId64 " x %" PRId64
			       " cells are too many; expected less than 2147483647",
			       n[0], n[1]);
	return TS_OK;
}

/* Cells whose centre is in the region. */
static enum ts_status set_obstacles(struct ts_instance *self, struct tsim *sim)
{
	const struct granular *s = self->state;
	struct ts_automaton_lattice *l = &automaton_of(self)->lattice;
	const struct ts_box *box = &sim->domain->box;
	double x[3] = { 0, 0, 0.5 * (box->lo[2] + box->hi[2]) };

	if (s->obstacles) {
		TS_TRY(ts_region_update(s->obstacles, sim));
		for (int j = 0; j < l->ny; j++)
			for (int i = 0; i < l->nx; i++) {
				x[0] = box->lo[0] + (i + 0.5) * s->cell;
				x[1] = box->lo[1] + (j + 0.5) * s->cell;
				if (ts_region_contains(s->obstacles, x))
					l->cell[ts_automaton_at(l, i, j)] = ts_cell_fixed(TS_CELL_OBSTACLE);
			}
	}
	l->open = ts_automaton_count_open(l);
	if (l->open == 0)
		return ts_fail(&sim->error, TS_STATE, ts_instance_word(self, "obstacles"),
			       "automaton_style granular: the obstacles fill all cells; expected space for "
			       "granules");
	return TS_OK;
}

static enum ts_status count_granules(struct ts_instance *self, struct tsim *sim, int64_t *granules)
{
	const struct granular *s = self->state;
	const int64_t open = s->automaton.lattice.open;

	if (s->fill > 1)
		return ts_fail(&sim->error, TS_RANGE, ts_instance_word(self, "fill"),
			       "automaton_style granular: fill %g would be %.0f granules in %" PRId64
			       " cells, which hold one each; expected at most 1",
			       s->fill, s->fill * (double)open, open);
	*granules = (int64_t)floor(s->fill * (double)open + 0.5);
	if (*granules == 0)
		return ts_fail(&sim->error, TS_RANGE, ts_instance_word(self, "fill"),
			       "automaton_style granular: fill %g of %" PRId64
			       " cells is not one granule; expected at least %g",
			       s->fill, open, 0.5 / (double)open);
	return TS_OK;
}

static enum ts_status make_lattice(struct ts_instance *self, struct tsim *sim, const int64_t n[2])
{
	struct granular *s = self->state;
	struct ts_automaton *a = &s->automaton;
	int64_t granules;

	if (!ts_automaton_make(&a->lattice, (int)n[0], (int)n[1]))
		return ts_nomem(&sim->error);
	TS_TRY(set_obstacles(self, sim));
	TS_TRY(count_granules(self, sim, &granules));
	a->lattice.granules = granules;
	if (!ts_automaton_step_make(&a->lattice, (enum ts_automaton_order)s->order))
		return ts_nomem(&sim->error);
	return TS_OK;
}

/* ---- speeds in cells a step */

static double fastest_wall(const struct granular *s)
{
	return fmax(fabs(s->wall[0]), fabs(s->wall[1]));
}

static double start_speed(const struct granular *s)
{
	return isnan(s->start) ? 0.1 * fastest_wall(s) : s->start;
}

static int speed_in_cells(const struct granular *s, double dt, double speed)
{
	return (int)nearbyint(fmin(fmax(speed * dt / s->cell, -1), 1) * TS_CELL_ONE);
}

static void set_laws(const struct granular *s, double dt, struct ts_laws *laws)
{
	const double one = 1 << TS_LAWS_FRACTION;

	*laws = (struct ts_laws){ .pair = (uint32_t)nearbyint(one * (1 + s->restitution) / 2),
				  .wall_restitution = (uint32_t)nearbyint(one * s->wall_restitution),
				  .roughness = (uint32_t)nearbyint(one * s->roughness),
				  .contact = s->contact,
				  .directions = s->directions,
				  .partner = s->partner,
				  .normal = s->normal };
	for (int w = 0; w < 2; w++)
		laws->wall[w] = speed_in_cells(s, dt, s->wall[w]);
}

/* Another time step: the speeds in cells a step change with it. */
static void rescale(struct ts_automaton *a, double dt)
{
	struct ts_automaton_lattice *l = &a->lattice;

	for (int y = 0; y < l->ny; y++)
		for (int x = 0; x < l->nx; x++) {
			uint32_t *w = &l->cell[ts_automaton_at(l, x, y)];
			double speed;

			if (!ts_cell_is_granule(*w))
				continue;
			speed = nearbyint(ts_cell_speed(*w) * (dt / a->dt));
			a->count.clipped += speed > TS_CELL_ONE;
			*w = ts_cell_turned(*w, (int)fmin(speed, TS_CELL_ONE), ts_cell_direction(*w));
		}
	a->dt = dt;
}

/* Before the first step the granules are put anew in each run: the time step may have been set in between. */
static void place_granules(struct granular *s, double dt)
{
	struct ts_automaton_lattice *l = &s->automaton.lattice;

	for (int y = 0; y < l->ny; y++)
		for (int x = 0; x < l->nx; x++)
			if (ts_cell_is_granule(l->cell[ts_automaton_at(l, x, y)]))
				l->cell[ts_automaton_at(l, x, y)] = TS_CELL_EMPTY;
	ts_automaton_place(l, (uint64_t)s->seed, l->granules, speed_in_cells(s, dt, start_speed(s)));
	s->automaton.dt = dt;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct granular *s = self->state;
	struct ts_automaton *a = &s->automaton;
	int64_t n[2];

	TS_TRY(ts_domain_require(sim, &self->where));
	TS_TRY(check_box(self, sim));
	TS_TRY(count_cells(self, sim, n));
	if (!a->lattice.cell)
		TS_TRY(make_lattice(self, sim, n));
	if (n[0] != a->lattice.nx || n[1] != a->lattice.ny)
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "automaton_style granular: the box has changed from %d x %d to %" PRId64
			       " x %" PRId64 " cells: define the automaton again",
			       a->lattice.nx, a->lattice.ny, n[0], n[1]);
	for (int d = 0; d < 3; d++) {
		a->lo[d] = sim->domain->box.lo[d];
		a->hi[d] = sim->domain->box.hi[d];
	}
	a->cell = s->cell;
	a->wall[0] = s->wall[0];
	a->wall[1] = s->wall[1];
	if (a->steps == 0 && (!s->defined || a->dt != sim->clock.dt))
		place_granules(s, sim->clock.dt);
	s->defined = true;
	return TS_OK;
}

static enum ts_status step(struct ts_instance *self, struct tsim *sim)
{
	struct granular *s = self->state;
	struct ts_automaton *a = &s->automaton;
	const size_t cells = (size_t)a->lattice.nx * (size_t)a->lattice.ny;
	struct ts_laws laws;

	if (a->dt != sim->clock.dt)
		rescale(a, sim->clock.dt);
	set_laws(s, a->dt, &laws);
	ts_automaton_step(&a->lattice, &laws, (enum ts_automaton_order)s->order, (uint64_t)s->seed,
			  a->steps + 1, ts_team(sim, cells), &a->count);
	a->steps++;
	return TS_OK;
}

/* ---- reports, restart */

/* A speed that is not 0, but rounded to 0. */
static enum ts_status check_speed(struct ts_instance *self, struct tsim *sim, const char *word, double speed)
{
	const struct granular *s = self->state;

	if (speed == 0 || speed_in_cells(s, sim->clock.dt, speed) != 0)
		return TS_OK;
	return ts_fail(&sim->error, TS_RANGE, ts_instance_word(self, word),
		       "automaton_style granular: the speed %g (%s) is %.2g cells a step, less than the "
		       "smallest one, 1/%d: expected a timestep of about %g, with which the fastest wall "
		       "moves by one cell a step",
		       speed, word, fabs(speed) * sim->clock.dt / s->cell, TS_CELL_ONE,
		       s->cell / fmax(fastest_wall(s), fabs(speed)));
}

static enum ts_status plan(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report)
{
	const struct granular *s = self->state;
	const struct ts_automaton_lattice *l = &s->automaton.lattice;
	const double fastest = fmax(fastest_wall(s), start_speed(s));
	double bytes = ts_automaton_bytes(l->nx, l->ny);

	TS_TRY(check_speed(self, sim, "lower", s->wall[0]));
	TS_TRY(check_speed(self, sim, "upper", s->wall[1]));
	TS_TRY(check_speed(self, sim, "start", start_speed(s)));
	if (s->automaton.steps == 0 && start_speed(s) == 0)
		return ts_fail(&sim->error, TS_RANGE, ts_instance_word(self, "start"),
			       "automaton_style granular: all granules are at rest, and a granule at rest "
			       "never collides: expected start > 0");
	if (fastest * sim->clock.dt > s->cell * (1 + 1e-9))
		return ts_fail(&sim->error, TS_RANGE, &self->where,
			       "automaton_style granular: the speed %g is %g cells a step; granules move by "
			       "at most one: expected a timestep of at most %g",
			       fastest, fastest * sim->clock.dt / s->cell, s->cell / fastest);
	if (report->limits_only)
		return TS_OK;
	ts_report_line(report, "automaton",
		       "%d x %d cells, %" PRId64 " granules, fastest %g cells a step, order %s", l->nx, l->ny,
		       l->granules, fastest * sim->clock.dt / s->cell,
		       s->order == TS_AUTOMATON_BLOCKS ? "blocks" : "exact");
	ts_report_line(report, "",
		       "left out by its rules: positions within cells, contacts that last, forces");
	if (s->order == TS_AUTOMATON_EXACT)
		bytes += sizeof(uint32_t) * (double)l->granules;
	report->bytes += bytes;
	report->whole += bytes;
	return TS_OK;
}

static enum ts_status archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *archive)
{
	struct ts_automaton_lattice *l = &automaton_of(self)->lattice;

	TS_TRY(ts_archive_fixed(archive, "cells", TS_SAVED_I32, l->cell, l->stride * ((size_t)l->ny + 2)));
	if (ts_archive_writing(archive))
		return TS_OK;
	if (!ts_automaton_accept(l))
		return ts_fail(&sim->error, TS_DAMAGED, &self->where,
			       "automaton_style granular: the cells in the restart file are damaged");
	/* there may be other obstacles than those of the script, and so another number of granules */
	return ts_automaton_step_make(l,
				      (enum ts_automaton_order)((const struct granular *)self->state)->order)
		       ? TS_OK
		       : ts_nomem(&sim->error);
}

static const struct ts_saved saved[] = {
	TS_SAVE_F64(struct granular, automaton.dt),
	TS_SAVE_I64(struct granular, automaton.steps),
	TS_SAVE_I64(struct granular, automaton.count.due),
	TS_SAVE_I64(struct granular, automaton.count.moved),
	TS_SAVE_I64(struct granular, automaton.count.collided),
	TS_SAVE_I64(struct granular, automaton.count.clipped),
	TS_SAVED_ROWS_END,
};

static void fini(struct ts_instance *self)
{
	ts_automaton_release(&automaton_of(self)->lattice);
}

static const char *const orders[] = { "exact", "blocks", NULL };
static const char *const contacts[] = { "offset", "centre", "any", NULL };
static const char *const direction_names[] = { "random", "nearest", "table", NULL };
static const char *const partners[] = { "turns", "keeps", NULL };
static const char *const normals[] = { "speed", "velocity", NULL };

static const struct ts_arg args[] = {
	TS_REAL("cell", struct granular, cell, .flags = TS_STATEFUL, .range = TS_POSITIVE, .unit = "length",
		.help = "edge of the cells, which is the diameter of the granules"),
	TS_REAL("fill", struct granular, fill, .flags = TS_STATEFUL, .range = TS_POSITIVE,
		.help = "granules by cells without obstacle, at most 1"),
	TS_REAL("restitution", struct granular, restitution, .range = TS_FRACTION,
		.help = "coefficient of restitution e_p between granules"),
	TS_REAL("wall_restitution", struct granular, wall_restitution, .range = TS_FRACTION,
		.help = "coefficient of restitution e_w between granules and walls"),
	TS_REAL("roughness", struct granular, roughness, .range = TS_FRACTION,
		.help = "roughness factor R of the walls: 0 smooth, 1 without slip in a collision"),
	TS_REAL("lower", struct granular, wall[0], .fallback = "0", .unit = "velocity",
		.help = "velocity of the wall at ylo along x"),
	TS_REAL("upper", struct granular, wall[1], .fallback = "0", .unit = "velocity",
		.help = "velocity of the wall at yhi along x"),
	TS_REAL("start", struct granular, start, .flags = TS_OPTIONAL, .range = TS_NOT_NEGATIVE,
		.unit = "velocity",
		.help = "speed of all granules at the beginning; default: 0.1 of that of the faster wall"),
	TS_INT("seed", struct granular, seed, .flags = TS_STATEFUL, .range = TS_POSITIVE,
	       .help = "seed of the random numbers"),
	TS_REGION("obstacles", struct granular, obstacles, .flags = TS_OPTIONAL,
		  .help = "cells whose centre is in this region are fixed, at rest, with the laws of walls"),
	TS_ENUM("order", struct granular, order, orders, .flags = TS_STATEFUL, .fallback = "exact",
		.help = "exact: all orders of the granules have the same probability; blocks: within blocks "
			"of cells, which are updated in parallel"),
	TS_ENUM("contact", struct granular, contact, contacts, .fallback = "offset",
		.help = "line of centres of granules that collide: at 45 degrees to the direction of motion, "
			"to either side; along it; or any of these three"),
	TS_ENUM("directions", struct granular, directions, direction_names, .fallback = "random",
		.help = "how a velocity becomes one of the eight directions: at random, with the right mean, "
			"or the nearest one; table: directions by a table, laws for speeds without sign"),
	TS_ENUM("partner", struct granular, partner, partners, .fallback = "turns",
		.help = "whether the granule that is hit takes its new direction, or only its new speed"),
	TS_ENUM("wall_normal", struct granular, normal, normals, .fallback = "speed",
		.help = "U in the law of the velocity normal to a wall: its speed, or its velocity along the "
			"normal, which is 0"),
	TS_ARGS_END,
};

static const char doc[] =
	"Granules that lubricate the gap between two plates, by the rules of Jasti and Higgs. The box is a\n"
	"lattice of square cells; a cell holds one granule or none. It is periodic along x; the walls at "
	"ylo\n"
	"and yhi move along x. A granule has one of eight directions (dx, dy), along an axis or a diagonal,\n"
	"and a speed s of at most one cell a step: its velocity is s (dx, dy) cell/dt, and it is due to "
	"move\n"
	"in every 1/s-th step, its time factor.\n\n"
	"In each step the granules that are due are updated one after the other, in a new random order. A\n"
	"granule moves if the cell in its direction is empty. If not, it collides with what is there, which\n"
	"changes its speed and direction, and tries again, until it has moved or has tried the direction\n"
	"already. The laws of a collision are\n\n"
	"  with a wall of velocity U:  u' = u + R (U - u) along the wall               (6)\n"
	"                              u' = U - e_w (U - u) normal to it, reversed     (7)\n"
	"  of two granules:            u1' = ((1 - e_p) u1 + (1 + e_p) u2)/2           (8)\n"
	"                              u2' = ((1 - e_p) u2 + (1 + e_p) u1)/2           (9)\n\n"
	"(8) and (9) hold along the line of centres, if the granules approach; the components across it do\n"
	"not change. The new velocity (u, v) becomes the speed max(|u|, |v|) and a direction.\n\n"
	"Equations typeset, assumptions, order and limits: doc/theory-granular-film.md.";
static const char *const doc_more[] = {
	"Where the paper leaves a choice there is an option; doc/granular-film.md shows what each does to "
	"the\n"
	"flow:\n\n"
	"contact - the positions of granules within their cells are not known, so one granule may hit\n"
	"another on either side: `offset` turns the line of centres by 45 degrees to the left or to the\n"
	"right. With `centre` collisions are central, and the flow freezes.\n\n"
	"directions - a velocity is between an axis and a diagonal. `random` chooses the diagonal with the\n"
	"probability min(|u|, |v|)/max(|u|, |v|), so that the mean velocity is exact. This adds kinetic\n"
	"energy. `nearest` conserves momentum less well. With `table` u1, u2 and u in the laws are speeds\n"
	"without sign; the granule that is updated turns back from another one, to one of the two "
	"directions\n"
	"beside the opposite one, the other one keeps its direction; walls reflect, with (7) for directions\n"
	"normal to the wall and (6) for diagonals. No momentum along x comes from the walls then.\n\n"
	"partner - `keeps`: the granule that is hit keeps its direction and only its speed changes. "
	"Momentum\n"
	"is not conserved then, and layers may begin to move against the wall.\n\n"
	"wall_normal - with `speed` a moving wall throws granules off, as U in (7) is the speed of the wall.",
	"Results of (8) and (9) beyond one cell a step are reduced to it; output 6 of compute\n"
	"automaton/profile counts them. The time step must be at most the cell by the largest speed of the\n"
	"walls; with a smaller one the walls move by less than a cell a step. Another time step in a later\n"
	"run changes the speeds in cells a step, not the velocities, except those above a cell by the new\n"
	"time step, which are reduced to it and counted in output 6.\n\n"
	"Random numbers are functions of the seed, the step and the block: results are the same bits with\n"
	"any number of threads and after a restart. Speeds and phases have 13 bits, the smallest speed is\n"
	"1/8192 cell a step; a cell is 4 bytes, and with `order exact` a granule 4 bytes more.\n\n"
	"Three dimensions would need 26 directions, for which the paper has no rules.",
	"Related: compute automaton/profile, dump automaton/png, dump automaton/vtk. Numbers:\n"
	"doc/granular-film.md.",
	NULL,
};

TS_STYLE(automaton, ts_automaton_style, ts_automaton_granular)
const struct ts_automaton_style ts_automaton_granular = {
	.style = { .name = "granular",
		   .kind = TS_KIND_AUTOMATON,
		   .ranks = TS_RANKS_OWN,
		   .summary = "Granular lubrication on a lattice, by rules for collisions",
		   .doc = doc,
		   .doc_more = doc_more,
		   .example = "automaton_style granular cell 1 fill 0.85 restitution 0.85 wall_restitution "
			      "0.65 roughness 0.65 lower 1 seed 1",
		   .cite = "V. K. Jasti and C. F. Higgs, J. Tribol. 128 (2006) 358, doi 10.1115/1.2164466",
		   .args = args,
		   .state_size = sizeof(struct granular),
		   .saved = saved,
		   .archive = archive,
		   .init = init,
		   .hook = { [TS_STAGE_INITIAL_INTEGRATE] = step },
		   .plan = plan,
		   .fini = fini },
	.of = automaton_of,
};
