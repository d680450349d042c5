/* Fix ave/euler: averages of particles over the cells of a grid that fills the box. */
#include "average/euler.h"
#include "box/domain.h"
#include "contact/contact_view.h"
#include "contact/virial.h"
#include "geom/box.h"
#include "math/constants.h"
#include "particle/group_moments.h"
#include "particle/identity.h"
#include "region/region.h"

#include <math.h>

#include "base/banned.h"

enum { SAMPLES = 16 /* points along an edge of a cell, to measure its part in the region */ };
static const double LEAST = 0.02; /* smallest part of a cell that is its volume, as in LIGGGHTS */

struct state {
	struct ts_euler euler;
	int64_t every;
	double relative;
	bool parallel;
	struct ts_instance *region;
	int64_t done;	       /* 1 + step of the last evaluation, 0: none; written to restart files */
	double lo[3], size[3]; /* lower corner of the grid, edges of a cell (length) */
	double *inside;	       /* [cell] part of the cell that is in basevolume_region, at least LEAST */
	size_t inside_capacity;
	int32_t *start, *list; /* particles of cell c: list[start[c]] .. list[start[c + 1] - 1] */
	size_t start_capacity, list_capacity;
};

/* Number of cells: their edges are at least cell_size_relative diameters of the largest particle. */
static void choose_grid(struct state *s, const struct tsim *sim)
{
	const struct ts_particles *p = sim->particles;
	const struct ts_box *box = &sim->domain->box;
	double most = 0;

	for (size_t i = 0; i < p->n; i++)
		most = fmax(most, p->radius[i]);
	for (int d = 0; d < 3 && most > 0; d++) {
		double n = floor(ts_box_length(box, d) / (s->relative * 2 * most));

		s->euler.n[d] = n < 1 || d >= sim->dimension ? 1 : n > 1e6 ? 1000000 : (int64_t)n;
	}
	s->euler.ncells = (size_t)(s->euler.n[0] * s->euler.n[1] * s->euler.n[2]);
}

/* Part of a cell that is in the region, from SAMPLES^3 points at the centres of equal sub-cells. */
static double region_part(const struct state *s, const double corner[3])
{
	size_t inside = 0;
	double x[3];

	for (int a = 0; a < SAMPLES; a++)
		for (int b = 0; b < SAMPLES; b++)
			for (int c = 0; c < SAMPLES; c++) {
				const int at[3] = { a, b, c };

				for (int d = 0; d < 3; d++)
					x[d] = corner[d] + (at[d] + 0.5) / SAMPLES * s->size[d];
				inside += ts_region_contains(s->region, x);
			}
	return fmax((double)inside / (SAMPLES * SAMPLES * SAMPLES), LEAST);
}

static void place_cells(struct state *s)
{
	for (size_t c = 0; c < s->euler.ncells; c++) {
		double *cell = s->euler.cell + c * TS_EULER_COLUMNS, corner[3];
		size_t rest = c;

		for (int d = 0; d < 3; d++) {
			corner[d] = s->lo[d] + (double)(rest % (size_t)s->euler.n[d]) * s->size[d];
			cell[TS_EULER_X + d] = corner[d] + 0.5 * s->size[d];
			rest /= (size_t)s->euler.n[d];
		}
		s->inside[c] = s->region ? region_part(s, corner) : 1;
	}
}

/* Fits the grid to the current box; the region may move. */
static enum ts_status fit_grid(struct state *s, struct tsim *sim)
{
	const struct ts_box *box = &sim->domain->box;
	bool same = true;

	for (int d = 0; d < 3; d++) {
		double size = ts_box_length(box, d) / (double)s->euler.n[d];

		same &= s->lo[d] == box->lo[d] && s->size[d] == size;
		s->lo[d] = box->lo[d];
		s->size[d] = size;
	}
	s->euler.size = s->euler.ncells * TS_EULER_COLUMNS;
	if (TS_GROW(s->euler.cell, s->euler.capacity, s->euler.size) != TS_OK ||
	    TS_GROW(s->inside, s->inside_capacity, s->euler.ncells) != TS_OK ||
	    TS_GROW(s->start, s->start_capacity, s->euler.ncells + 2) != TS_OK ||
	    TS_GROW(s->list, s->list_capacity, sim->particles->n) != TS_OK)
		return ts_nomem(&sim->error);
	TS_TRY(ts_region_update(s->region, sim));
	if (!same || s->region)
		place_cells(s);
	return TS_OK;
}

static size_t cell_of(const struct state *s, const double x[3])
{
	size_t cell = 0;

	for (int d = 2; d >= 0; d--) {
		double at = floor((x[d] - s->lo[d]) / s->size[d]), last = (double)(s->euler.n[d] - 1);

		at = at >= 0 ? fmin(at, last) : 0; /* x may be NaN */
		cell = cell * (size_t)s->euler.n[d] + (size_t)at;
	}
	return cell;
}

/* Counting sort by cell; within a cell particles are sorted by id, so that sums do not depend on the order in
 * memory. */
static enum ts_status sort_particles(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	const struct ts_particles *p = sim->particles;
	struct ts_identities all;

	TS_TRY(ts_identities(sim, true, &all));
	for (size_t c = 0; c <= s->euler.ncells + 1; c++)
		s->start[c] = 0;
	for (size_t i = 0; i < p->n; i++)
		if (ts_in_group(p, i, self->group))
			s->start[cell_of(s, p->x[i]) + 2]++;
	for (size_t c = 0; c < s->euler.ncells; c++)
		s->start[c + 2] += s->start[c + 1];
	for (size_t k = 0; k < all.n; k++) {
		size_t i = (size_t)all.row[k];

		if (ts_in_group(p, i, self->group))
			s->list[s->start[cell_of(s, p->x[i]) + 1]++] = all.row[k];
	}
	return TS_OK;
}

/* Volume of a sphere, in two dimensions area of a disc. */
static double volume_of(const struct tsim *sim, size_t i)
{
	double r = sim->particles->radius[i];

	return sim->dimension == 2 ? TS_PI * r * r : 4 * TS_PI / 3 * r * r * r;
}

/* Count, mass, mass-weighted velocity, mean radius; the volume of the particles in TS_EULER_FRACTION. */
static void compute_means(const struct state *s, const struct tsim *sim, size_t c, double *cell)
{
	const struct ts_particles *p = sim->particles;

	for (int32_t k = s->start[c]; k < s->start[c + 1]; k++) {
		size_t i = (size_t)s->list[k];

		cell[TS_EULER_COUNT] += 1;
		cell[TS_EULER_MASS] += p->mass[i];
		cell[TS_EULER_RADIUS] += p->radius[i];
		cell[TS_EULER_FRACTION] += volume_of(sim, i);
		for (int d = 0; d < 3; d++)
			cell[TS_EULER_V + d] += p->mass[i] * p->v[i][d];
	}
	if (!(cell[TS_EULER_COUNT] > 0))
		return;
	cell[TS_EULER_RADIUS] /= cell[TS_EULER_COUNT];
	for (int d = 0; d < 3; d++)
		cell[TS_EULER_V + d] /= cell[TS_EULER_MASS];
}

/* stress = -1/V sum (m (v - v_mean)(v - v_mean) + W), W the virial of the particle from contacts and bonds */
static void compute_stress(const struct state *s, const struct tsim *sim, size_t c, double volume,
			   double *cell)
{
	static const struct ts_virial_parts parts = { .pair = true, .bond = true };
	const struct ts_particles *p = sim->particles;

	for (int32_t k = s->start[c]; k < s->start[c + 1]; k++) {
		size_t i = (size_t)s->list[k];
		double w[6];

		ts_virial_of_particle(sim, i, &parts, w);
		for (int j = 0; j < 6; j++) {
			int a = ts_tensor_row[j], b = ts_tensor_column[j];

			cell[TS_EULER_STRESS + j] -= (p->mass[i] * (p->v[i][a] - cell[TS_EULER_V + a]) *
							      (p->v[i][b] - cell[TS_EULER_V + b]) +
						      w[j]) /
						     volume;
		}
	}
	cell[TS_EULER_PRESSURE] = -(cell[TS_EULER_STRESS] + cell[TS_EULER_STRESS + 1] +
				    (sim->dimension == 3 ? cell[TS_EULER_STRESS + 2] : 0)) /
				  sim->dimension;
}

static enum ts_status evaluate_cells(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	s->done = sim->clock.step + 1;
	if (!s->euler.ncells)
		choose_grid(s, sim);
	if (!s->euler.ncells)
		return TS_OK; /* no particles so far: no grid */
	TS_TRY(fit_grid(s, sim));
	TS_TRY(sort_particles(self, sim));
	for (size_t c = 0; c < s->euler.ncells; c++) {
		double *cell = s->euler.cell + c * TS_EULER_COLUMNS, volume = s->inside[c];

		for (int d = 0; d < sim->dimension; d++)
			volume *= s->size[d];
		for (int k = TS_EULER_V; k < TS_EULER_COLUMNS; k++)
			cell[k] = 0;
		compute_means(s, sim, c, cell);
		cell[TS_EULER_FRACTION] /= volume;
		compute_stress(s, sim, c, volume, cell);
	}
	return TS_OK;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	self->every = ((const struct state *)self->state)->every;
	sim->neigh->keep_forces = true;
	return ts_domain_require(sim, &self->where);
}

/* A continued run, or one from a restart file, keeps the values of this step. */
static enum ts_status setup(struct ts_instance *self, struct tsim *sim)
{
	const struct state *s = self->state;

	return s->done == 0 || (s->done != sim->clock.step + 1 && sim->clock.step % s->every == 0)
		       ? evaluate_cells(self, sim)
		       : TS_OK;
}

static enum ts_status end_of_step(struct ts_instance *self, struct tsim *sim)
{
	return sim->clock.step % self->every == 0 ? evaluate_cells(self, sim) : TS_OK;
}

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct ts_euler *e = self->state;

	(void)sim;
	TS_TRY(ts_table_resize(out, e->ncells, TS_EULER_COLUMNS));
	for (size_t k = 0; k < e->ncells * TS_EULER_COLUMNS; k++)
		out->data[k] = e->cell[k];
	return TS_OK;
}

static enum ts_status archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a)
{
	struct state *s = self->state;
	struct ts_euler *e = &s->euler;
	double cells = 1;

	TS_TRY(ts_archive_array(a, "cells", TS_SAVED_F64, (void **)&e->cell, &e->capacity, &e->size));
	for (int d = 0; d < 3; d++)
		cells *= (double)e->n[d];
	if (e->n[0] < 0 || e->n[1] < 0 || cells * TS_EULER_COLUMNS != (double)e->size)
		return ts_fail(&sim->error, TS_DAMAGED, &self->where,
			       "the cells of fix ave/euler are damaged");
	e->ncells = e->size / TS_EULER_COLUMNS;
	if (ts_archive_writing(a))
		return TS_OK;
	return TS_GROW(s->inside, s->inside_capacity, e->ncells) == TS_OK ? TS_OK : ts_nomem(&sim->error);
}

static void fini(struct ts_instance *self)
{
	struct state *s = self->state;

	ts_free(s->euler.cell);
	ts_free(s->inside);
	ts_free(s->start);
	ts_free(s->list);
}

static const char *const names[] = { "x",      "y",	   "z",	    "vx",   "vy",  "vz",  "volumefraction",
				     "radius", "pressure", "count", "mass", "sxx", "syy", "szz",
				     "sxy",    "sxz",	   "syz",   NULL };

static const struct ts_value values[] = {
	{ "cells", "", "a row for each cell, the x index varying fastest", TS_ARRAY, TS_EULER_COLUMNS, names,
	  eval },
	{ .name = NULL },
};

static const struct ts_saved saved[] = { TS_SAVE_I64(struct state, euler.n), TS_SAVE_I64(struct state, done),
					 TS_SAVED_ROWS_END };

static const struct ts_arg args[] = {
	TS_INT("nevery", struct state, every, .flags = TS_STATEFUL, .range = TS_POSITIVE,
	       .help = "steps between evaluations"),
	TS_REAL("cell_size_relative", struct state, relative, .flags = TS_STATEFUL, .range = TS_POSITIVE,
		.unit = "", .help = "smallest edge of a cell, in diameters of the largest particle"),
	TS_BOOL("parallel", struct state, parallel, .fallback = "no",
		.help = "no effect: there is one grid, which fills the box, on any number of ranks"),
	TS_REGION("basevolume_region", struct state, region, .flags = TS_OPTIONAL | TS_STATEFUL,
		  .help = "only the part of a cell inside the region is its volume, but at least 0.02 of the "
			  "cell"),
	TS_ARGS_END,
};

static bool due(const struct ts_instance *self, const struct tsim *sim)
{
	return sim->clock.step % self->every == 0;
}

TS_STYLE(fix, ts_style, ts_fix_ave_euler)
const struct ts_style ts_fix_ave_euler = {
	.name = "ave/euler",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_WHOLE,
	.due = due,
	.summary = "Averages velocity, volume fraction, stress ... over the cells of a grid",
	.doc = "Divides the box into cells of equal size. Their edges are at least cell_size_relative "
	       "diameters of the largest particle present at the first evaluation; after that the number of "
	       "cells is fixed, and their size follows the box. Every nevery steps, for the particles of the "
	       "group whose centres are in a cell of volume V:\n\n"
	       "    v = sum m v_i / sum m\n"
	       "    volumefraction = sum 4/3 pi R^3 / V\n"
	       "    radius = mean R\n"
	       "    stress = -1/V sum (m (v_i - v)(v_i - v) + 1/2 sum (x_i - x_j) F_ij)\n"
	       "    pressure = -1/3 trace of the stress\n\n"
	       "with F_ij the force of a contact or bond with particle j; contacts with walls are not "
	       "included. Cells without particles have 0. In two dimensions areas replace volumes, and the "
	       "pressure is -1/2 of the trace. f_ID[i][k] is quantity k of cell i at the last evaluation, in "
	       "the order centre (3), velocity (3), volumefraction, radius, pressure, number of particles, "
	       "mass, stress xx yy zz xy xz yz. `dump euler/vtk` writes them to files.",
	.example = "fix cells all ave/euler nevery 1000 cell_size_relative 4 parallel no\n"
		   "dump cells all euler/vtk 1000 post/cells*.vtk",
	.args = args,
	.family = TS_FAMILY_EULER,
	.state_size = sizeof(struct state),
	.saved = saved,
	.archive = archive,
	.values = values,
	.init = init,
	.hook = { [TS_STAGE_SETUP] = setup, [TS_STAGE_END_OF_STEP] = end_of_step },
	.fini = fini,
};
