/* Fix void_fraction: volume fraction of the fluid in each cell. */
#include "core/ranks.h"
#include "core/report.h"
#include "core/unclaimed_state.h"

#include <math.h>
#include <string.h>

#include "coupling/cell_order.h"
#include "coupling/interpolation_weights.h"
#include "coupling/near_particles.h"
#include "coupling/volume_batch.h"
#include "coupling/volume_distribution.h"
#include "flow/flow.h"
#include "flow/near_exchange.h"
#include "math/exactsum.h"
#include "particle/particles.h"

#include "base/banned.h"

static const char *const methods[] = { "centre", "divided", "kernel", NULL };

struct state {
	struct ts_flow_part part; /* first */
	int method;
	double reach, least;

	struct ts_fluid *fluid;
	struct ts_cell_order order;
	bool warned;
	bool warned_kernel;	     /* warned that the cells do not resolve the kernel */
	double found;		     /* smallest value of a cell, before the lower limit */
	double (*last_particles)[4]; /* positions and radii from which the field was computed; owned */
	size_t nlast, last_capacity;
	struct tsim *sim; /* evaluation may fail */
};

static struct ts_coupling_volume distribution_of(const struct state *s, const struct tsim *sim)
{
	return (struct ts_coupling_volume){ (enum ts_coupling_volume_method)s->method, sim->dimension == 2,
					    s->reach };
}

static void volume_distribution(const struct ts_instance *self, const struct tsim *sim,
				struct ts_coupling_volume *how)
{
	*how = distribution_of(self->state, sim);
}

struct context {
	const struct state *state;
	struct ts_coupling_volume how;
};

static void add_row(const struct context *c, size_t row)
{
	const struct state *s = c->state;
	double place[3];
	int cell[3];

	if (ts_cell_order_locate(&s->order, s->fluid, row, place, cell))
		ts_coupling_volume_add(&s->fluid->grid, &c->how, place, cell,
				       ts_cell_rows_radius(&s->order.sort->of, row), s->fluid->void_fraction);
}

static void add_rows(void *data, const int32_t *row, size_t n)
{
	for (size_t k = 0; k < n; k++)
		add_row(data, (size_t)row[k]);
}

static void add_to_batch(struct ts_volume_batch *batch, const struct ts_cell_sort *sort, size_t row)
{
	const double *x = ts_cell_rows_x(&sort->of, row);

	for (int d = 0; d < 3; d++)
		batch->x[d][batch->n] = x[d];
	batch->radius[batch->n] = ts_cell_rows_radius(&sort->of, row);
	batch->where[batch->n++] = sort->where[row];
}

static void add_batch(const struct context *c, struct ts_volume_batch *batch)
{
	ts_volume_batch_add(batch, &c->state->fluid->grid, &c->how, c->state->fluid->void_fraction);
	batch->n = 0;
}

/* In batches, that end at particles which are found across a periodic face. */
static void add_rows_in_batches(void *data, const int32_t *row, size_t n)
{
	const struct context *c = data;
	const struct ts_cell_sort *sort = c->state->order.sort;
	struct ts_volume_batch batch;

	_Static_assert((int)TS_CELL_ORDER_ROWS <= (int)TS_VOLUME_BATCH, "all rows of a call are a batch");
	batch.n = 0;
	for (size_t k = 0; k < n; k++) {
		if (!(sort->where[row[k]] & TS_HALVES_ELSEWHERE)) {
			add_to_batch(&batch, sort, (size_t)row[k]);
			continue;
		}
		add_batch(c, &batch);
		add_row(c, (size_t)row[k]);
	}
	add_batch(c, &batch);
}

/* Method centre in a cell narrower than the particle may give a solid fraction above 1. */
static enum ts_status check_centre(struct ts_instance *self, struct tsim *sim, double diameter)
{
	const struct state *s = self->state;
	const double least = ts_grid_least_width(&s->fluid->grid);

	if (s->method != TS_VOLUME_CENTRE || !(least < diameter))
		return TS_OK;
	return ts_fail(&sim->error, TS_RANGE, &self->where,
		       "fix void_fraction: method centre puts all of a particle into one cell, and cells are "
		       "down to %g wide, narrower than the particles of up to %g; use method divided or "
		       "kernel, or cells of several diameters",
		       least, diameter);
}

/* Cells wider than the kernel contain it completely, and the field is the mean over the cell. Warned from
 * two diameters on, where the default kernel of 1.5 diameters lies in one cell for some positions of the
 * centre. */
static void check_kernel(struct ts_instance *self, struct tsim *sim, double diameter)
{
	static const double MOST = 2; /* diameters */
	struct state *s = self->state;
	const struct ts_grid *grid = &s->fluid->grid;
	double most = 0, fits = fmax(MOST, s->reach) * diameter;

	for (int d = 0; d < grid->dimensions; d++)
		for (int i = 0; i < grid->n[d] && grid->n[d] > 1; i++)
			most = fmax(most, grid->width[d][i]);
	if (s->warned_kernel || s->method != TS_VOLUME_KERNEL || !(diameter > 0) || !(most > 1.000001 * fits))
		return;
	s->warned_kernel = true;
	if (!ts_ranks_first(sim))
		return;
	ts_warn(&sim->log, &self->where,
		"fix void_fraction: cells are up to %.4g wide, %.3g diameters of the largest particle, and "
		"do not resolve the kernel, which reaches %.4g to either side: the void fraction is the mean "
		"over cells, as with method divided; use cells of at most %.4g, or method divided (printed "
		"once)",
		most, most / diameter, s->reach * diameter, fits);
}

/* Finds the largest number of cells that a particle reaches; an error if it is too large. */
static enum ts_status check_reach(struct ts_instance *self, struct tsim *sim, double largest, int *reach)
{
	const struct state *s = self->state;
	struct ts_coupling_volume how = distribution_of(s, sim);

	TS_TRY(check_centre(self, sim, 2 * largest));
	check_kernel(self, sim, 2 * largest);
	*reach = ts_coupling_volume_reach(&s->fluid->grid, &how, largest);
	if (2 * *reach + 1 <= TS_VOLUME_MAX_CELLS)
		return TS_OK;
	return ts_fail(&sim->error, TS_RANGE, &self->where,
		       "fix void_fraction: a particle of radius %g covers more than %d cells across: the "
		       "grid is too fine for unresolved drag",
		       largest, TS_VOLUME_MAX_CELLS);
}

struct limited {
	double least;
	int64_t cells;
};

/* In a row of cells: 1 - e, not less than the least. */
static void limit_row(double *e, int n, double lowest, struct limited *found)
{
	for (int i = 0; i < n; i++) {
		e[i] = 1 - e[i];
		found->least = fmin(found->least, e[i]);
		if (e[i] < lowest) {
			e[i] = lowest;
			found->cells++;
		}
	}
}

static struct limited limit_cells(const struct state *s, const struct tsim *sim,
				  const struct ts_cell_box *box)
{
	const struct ts_grid *grid = &s->fluid->grid;
	const int n = box->to[0] - box->from[0], height = box->to[1] - box->from[1];
	const int rows = ts_cell_box_size(box) ? height * (box->to[2] - box->from[2]) : 0;
	double least = 1;
	int64_t cells = 0;

#pragma omp parallel for num_threads(ts_team(sim, ts_cell_box_size(box))) schedule(static)           	reduction(min : least) reduction(+ : cells)
	for (int line = 0; line < rows; line++) {
		struct limited found = { least, 0 };

		limit_row(s->fluid->void_fraction + ts_at(grid, box->from[0], box->from[1] + line % height,
							  box->from[2] + line / height),
			  n, s->least, &found);
		least = found.least;
		cells += found.cells;
	}
	return (struct limited){ least, cells };
}

/* Of the cells to which this rank has added all particles. */
static void limit_void_fraction(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	const struct ts_cell_box box = ts_cell_order_box(&s->order, sim);
	struct limited found = limit_cells(s, sim, &box);

	found.least = -ts_ranks_most(sim, -found.least);
	s->found = found.least;
	if (!(found.least < s->least) || s->warned)
		return;
	s->warned = true;
	if (sim->division && !s->fluid->owners->all)
		ts_ranks_sums(sim, &found.cells, 1);
	if (ts_ranks_first(sim))
		ts_warn(&sim->log, &self->where,
			"fix void_fraction: %lld cells have a void fraction down to %g, below `least` %g, "
			"which is used instead (printed once)",
			(long long)found.cells, found.least, s->least);
}

/* Whether particles have moved or changed since the field was computed: a fixed bed costs nothing. *largest: radius. */
static enum ts_status compare_particles(struct ts_instance *self, struct tsim *sim, bool *moved,
					double *largest)
{
	struct state *s = self->state;
	const struct ts_particles *p = sim->particles;
	bool changed = s->nlast != p->n;
	double radius = 0, most[2];

	if (TS_GROW(s->last_particles, s->last_capacity, p->n) != TS_OK)
		return ts_nomem(&sim->error);
	s->nlast = p->n;
#pragma omp parallel for num_threads(ts_team(sim, p->n)) schedule(static) reduction(||         \
										    : changed) \
	reduction(max                                                                          \
		  : radius)
	for (size_t i = 0; i < p->n; i++) {
		const double now[4] = { p->x[i][0], p->x[i][1], p->x[i][2],
					ts_in_group(p, i, self->group) ? p->radius[i] : -1 };

		radius = fmax(radius, now[3]);
		if (memcmp(now, s->last_particles[i], sizeof now) == 0)
			continue;
		memcpy(s->last_particles[i], now, sizeof now);
		changed = true;
	}
	most[0] = changed;
	most[1] = radius;
	TS_TRY(ts_near_particles_agree(s->fluid, sim, most, 2));
	*moved = most[0] > 0;
	*largest = most[1];
	return TS_OK;
}

static enum ts_status make_field(struct ts_instance *self, struct tsim *sim, double largest)
{
	struct state *s = self->state;
	struct context context = { s, distribution_of(s, sim) };
	const bool batches = ts_volume_batch_possible(&s->fluid->grid, &context.how);
	int reach;

	TS_TRY(check_reach(self, sim, largest, &reach));
	/* with method centre it is 0, but forces that act back on the fluid use the same rows, and reach the next cells */
	reach = reach > 1 ? reach : 1;
	TS_TRY(ts_cell_order_make(&s->order, sim, s->fluid, self->group, reach));
	ts_fluid_clear(s->fluid, s->fluid->void_fraction);
	ts_cell_order_each_rows(&s->order, ts_team(sim, s->order.sort->of.n),
				batches ? add_rows_in_batches : add_rows, &context);
	limit_void_fraction(self, sim);
	TS_TRY(ts_cell_order_spread(&s->order, sim, s->fluid->void_fraction));
	ts_fluid_fill_centred(s->fluid, s->fluid->void_fraction);
	if (s->fluid->near.active)
		ts_fluid_near_fill_centred(s->fluid, s->fluid->void_fraction);
	return TS_OK;
}

static enum ts_status pre_force(struct ts_instance *self, struct tsim *sim)
{
	bool moved = true;
	double largest = 0;

	TS_TRY(compare_particles(self, sim, &moved, &largest));
	return moved ? make_field(self, sim, largest) : TS_OK;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	const struct ts_instance *other;
	const bool first = !s->sim;
	bool moved;
	double largest = 0;

	for (size_t k = 0; (other = ts_flow_part_named(sim, "void_fraction", &k));)
		if (!ts_streq(other->id, self->id))
			return ts_fail(&sim->error, TS_STATE, &self->where,
				       "fix void_fraction: there is one already, fix %s (%s:%d): its group "
				       "has all particles that displace fluid",
				       other->id, TS_FILE_AND_LINE(other->where));
	TS_TRY(ts_flow_require_fluid(sim, "fix void_fraction", &self->where, &s->fluid));
	s->fluid->void_of_fix = true;
	s->fluid->void_anew |= first && !ts_unclaimed_exists(sim, self);
	TS_TRY(ts_fluid_require_fields(s->fluid, sim, TS_FLUID_VOID));
	s->part.volume_distribution = volume_distribution;
	s->part.order = &s->order;
	s->part.sends = (struct ts_flow_part_sends){ .particles = true, .fields = 1, .nearby = true };
	s->sim = sim;
	s->nlast = 0;
	TS_TRY(compare_particles(self, sim, &moved, &largest));
	s->nlast = 0;
	return make_field(self, sim, largest);
}

static const struct ts_saved saved[] = {
	TS_SAVE_U8(struct state, warned),
	TS_SAVE_F64(struct state, found),
	TS_SAVED_ROWS_END,
};

/* Mean over the volume, and smallest value of a cell. */
static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct state *s = self->state;
	struct ts_fluid *fluid = ts_flow_fluid(sim);
	const struct ts_grid *grid;
	struct ts_exactsum empty = ts_exactsum_start(), all = ts_exactsum_start();

	if (!fluid || !fluid->void_fraction)
		return ts_fail(&s->sim->error, TS_STATE, &self->where,
			       "fix void_fraction: the flow style has been replaced, and there is no void "
			       "fraction before the next run");
	TS_TRY(ts_flow_require_fields(s->sim, "fix void_fraction", &self->where, &fluid));
	grid = &fluid->grid;
	for (int k = 0; k < grid->n[2]; k++)
		for (int j = 0; j < grid->n[1]; j++)
			for (int i = 0; i < grid->n[0]; i++) {
				double volume = ts_grid_volume(grid, i, j, k);

				ts_exactsum_add(&all, volume);
				ts_exactsum_add(&empty, fluid->void_fraction[ts_at(grid, i, j, k)] * volume);
			}
	out->data[0] = ts_exactsum_value(&empty) / ts_exactsum_value(&all);
	out->data[1] = s->found;
	return TS_OK;
}

static const char *const columns[] = { "mean", "least" };
static const struct ts_value values[] = {
	{ "void_fraction", "", "mean over the grid, and the smallest value of a cell before it is limited",
	  TS_VECTOR, 2, columns, eval },
	{ .name = NULL },
};

static enum ts_status plan(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report)
{
	const struct state *s = self->state;

	(void)sim;
	ts_report_line(report, "void fraction", "%s, at present down to %g", methods[s->method], s->found);
	return TS_OK;
}

static void fini(struct ts_instance *self)
{
	struct state *s = self->state;

	ts_cell_order_release(&s->order);
	ts_free(s->last_particles);
}

static const struct ts_arg args[] = {
	TS_ENUM("method", struct state, method, methods, .fallback = "divided",
		.help = "how the volume of a particle is distributed: to the cell of its centre, to the "
			"cells that it overlaps, or by a kernel"),
	TS_REAL("reach", struct state, reach, .fallback = "1.5", .range = TS_POSITIVE, .unit = "",
		.help = "half width b of the kernel in particle diameters"),
	TS_REAL("least", struct state, least, .fallback = "0.1", .range = TS_WITHIN, .lo = 1e-3, .hi = 1,
		.unit = "", .help = "lower limit of the void fraction of a cell"),
	TS_ARGS_END,
};

TS_STYLE(fix, ts_style, ts_fix_void_fraction)
const struct ts_style ts_fix_void_fraction = {
	.name = "void_fraction",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_OWN | TS_RANKS_OUTPUTS | TS_RANKS_ROWLESS,
	.summary = "Void fraction: the part of each cell that is not occupied by particles",
	.doc = "e = 1 - (volume of particles in the cell)/(volume of the cell). It enters the equations of "
	       "the fluid, de/dt + div(e u) = 0 and e rho (du/dt + u.grad u) = -e grad p + ..., with u the "
	       "interstitial velocity, and the drags that depend on it, which must be defined after this "
	       "fix.\n\n"
	       "`method divided` computes the exact volume of each sphere in each cell. `centre` assigns the "
	       "whole volume to the cell that contains the centre, so that e jumps when the centre moves to "
	       "another cell. `kernel` distributes the volume along each axis by (1 + cos(pi s/b))/(2 b), "
	       "with b equal to `reach` diameters; choose it if cells are not much larger than particles. "
	       "All methods conserve the volume of the particles. In two dimensions particles are discs, and "
	       "e is a fraction of the area.\n\n"
	       "`method centre` is refused if a cell is narrower than the largest particle. With `kernel`, a "
	       "warning is printed once if cells are wider than 2 diameters and than b, since they do not "
	       "resolve the kernel (an axis with a single cell is exempt). e is limited from below by "
	       "`least`; a warning is printed once when this happens.\n\n"
	       "f_ID[1] is the mean of e over the grid, f_ID[2] the smallest value of a cell before it is "
	       "limited.",
	.example = "flow_style projection cells 10 10 40 viscosity 1.8e-5 density 1.2\n"
		   "fix e all void_fraction method divided\n"
		   "fix drag all drag/gidaspow scheme implicit",
	.cite = "T. B. Anderson, R. Jackson, Ind. Eng. Chem. Fundam. 6 (1967) 527",
	.family = TS_FAMILY_FLOW_PART,
	.args = args,
	.state_size = sizeof(struct state),
	.saved = saved,
	.values = values,
	.init = init,
	.hook = { [TS_STAGE_PRE_FORCE] = pre_force },
	.plan = plan,
	.fini = fini,
};
