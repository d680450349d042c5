#include "flow/implicit_viscosity.h"

#include <string.h>

#include "base/alloc.h"
#include "flow/predictor.h"
#include "rank/transposition.h"

#include "base/banned.h"

/* ---- right-hand side: the change of u by the full viscous term and the pressure gradient at the
 * beginning */

struct second {
	double below, above;
};

static void change_row(const struct ts_viscous_step *s, int c, int j, int k, int from, int to, double *row)
{
	const struct ts_fluid *fluid = s->fluid;
	const struct ts_grid *grid = &fluid->grid;
	const struct ts_operators *o = s->operators;
	const struct ts_operator_line *x = c == 0 ? &o->staggered[0] : &o->centred[0];
	const struct ts_operator_line *y = c == 1 ? &o->staggered[1] : &o->centred[1];
	const struct ts_operator_line *z = c == 2 ? &o->staggered[2] : &o->centred[2];
	const bool solid = grid->dimensions == 3;
	const struct second ty = { y->below[j], y->above[j] };
	const struct second tz = { solid ? z->below[k] : 0, solid ? z->above[k] : 0 };
	const ptrdiff_t sy = grid->stride[1], sz = solid ? grid->stride[2] : 0, sc = grid->stride[c];
	const size_t at = ts_at(grid, 0, j, k);
	const double *u = fluid->u[c] + at, *p = fluid->p + at, *gap = grid->gap[0];
	const double *below = x->below, *above = x->above;
	const double per_gap = c == 0 ? 0 : 1 / grid->gap[c][c == 1 ? j : k];
	const double push = s->dt / fluid->density, spread = s->dt * s->nu;

#pragma omp simd
	for (int i = from; i < to; i++) {
		double slope = (p[i] - p[i - sc]) * (c == 0 ? 1 / gap[i] : per_gap);
		double spread_x = above[i] * (u[i + 1] - u[i]) - below[i] * (u[i] - u[i - 1]);
		double spread_y = ty.above * (u[i + sy] - u[i]) - ty.below * (u[i] - u[i - sy]);
		double spread_z = tz.above * (u[i + sz] - u[i]) - tz.below * (u[i] - u[i - sz]);

		row[i] += spread * (spread_x + spread_y + spread_z) - push * slope - u[i];
	}
}

/* ---- tridiagonal systems */

/* (1 - lambda lap) along one axis for the points of one component, factored. Periodic axes use the
 * Sherman-Morrison formula. Arrays are indexed by point. */
struct system {
	int from, to;
	double *lower, *inverse, *upper; /* of the elimination */
	double *loop;			 /* periodic: the solution for the corners; else NULL */
	double tail, scale;
	double *memory;
};

static void eliminate(struct system *s, const double *diagonal, double *upper)
{
	for (int m = s->from; m < s->to; m++) {
		double pivot = diagonal[m] - (m > s->from ? s->lower[m] * s->upper[m - 1] : 0);

		s->inverse[m] = 1 / pivot;
		s->upper[m] = upper[m] / pivot;
	}
}

/* Eliminates the ghost beyond the end, which is a combination of points inside. */
static void eliminate_ghost(const struct ts_fluid *fluid, int c, int d, enum ts_grid_side side,
			    double coefficient, double *diagonal, double *inner)
{
	enum ts_flow_face kind = fluid->face[d][side];
	const double *mirror = fluid->ghost_weights[d][side];

	if (c == d && !ts_flow_face_open(kind))
		return; /* the velocity on the boundary is given: no change */
	if (kind == TS_FLOW_SLIP || ts_flow_face_open(kind)) {
		*diagonal += coefficient;
		return;
	}
	*diagonal += coefficient * mirror[1];
	*inner += coefficient * mirror[2];
}

/* Adds the corner elements of the periodic matrix. */
static void add_periodic_corners(struct system *s, double *diagonal, double *upper)
{
	int first = s->from, last = s->to - 1;
	double corner = upper[last], gamma = -diagonal[first];

	s->tail = s->lower[first] / gamma;
	diagonal[first] -= gamma;
	diagonal[last] -= corner * s->tail;
	eliminate(s, diagonal, upper);
	memset(s->loop + first, 0, (size_t)(last - first + 1) * sizeof *s->loop);
	s->loop[first] = gamma;
	s->loop[last] += corner;
	for (int m = first; m <= last; m++)
		s->loop[m] = (s->loop[m] - (m > first ? s->lower[m] * s->loop[m - 1] : 0)) * s->inverse[m];
	for (int m = last - 1; m >= first; m--)
		s->loop[m] -= s->upper[m] * s->loop[m + 1];
	s->scale = 1 / (1 + s->loop[first] + s->tail * s->loop[last]);
}

static enum ts_status make_system(const struct ts_viscous_step *step, int c, int d, struct system *s)
{
	const struct ts_fluid *fluid = step->fluid;
	const struct ts_grid *grid = &fluid->grid;
	const struct ts_operator_line *line =
		c == d ? &step->operators->staggered[d] : &step->operators->centred[d];
	const double lambda = step->theta * step->dt * step->nu;
	const size_t n = (size_t)grid->n[d] + 1;
	double *diagonal, *upper;
	int from[3], to[3];

	ts_flow_unknowns(fluid, c, from, to);
	*s = (struct system){ .from = from[d], .to = to[d] };
	s->memory = ts_alloc(6 * n, sizeof *s->memory);
	if (!s->memory)
		return TS_NOMEM;
	s->lower = s->memory;
	s->inverse = s->memory + n;
	s->upper = s->memory + 2 * n;
	diagonal = s->memory + 3 * n;
	upper = s->memory + 4 * n;
	for (int m = s->from; m < s->to; m++) {
		s->lower[m] = -lambda * line->below[m];
		upper[m] = -lambda * line->above[m];
		diagonal[m] = 1 - s->lower[m] - upper[m];
	}
	if (grid->periodic[d] && grid->n[d] > 2) {
		s->loop = s->memory + 5 * n;
		add_periodic_corners(s, diagonal, upper);
		return TS_OK;
	}
	if (grid->periodic[d]) { /* with one or two points the neighbours coincide */
		for (int m = s->from; m < s->to; m++) {
			double both = s->lower[m] + upper[m];

			diagonal[m] += grid->n[d] == 1 ? both : 0;
			s->lower[m] = upper[m] = grid->n[d] == 1 ? 0 : both;
		}
	} else if (s->to > s->from) {
		int last = s->to - 1;

		eliminate_ghost(fluid, c, d, TS_LOW, s->lower[s->from], &diagonal[s->from], &upper[s->from]);
		eliminate_ghost(fluid, c, d, TS_HIGH, upper[last], &diagonal[last], &s->lower[last]);
	}
	eliminate(s, diagonal, upper);
	return TS_OK;
}

enum { BLOCK = 64 };

/* Sherman-Morrison correction of n lines. */
static void correct_periodic_lines(const struct system *sys, double *x, ptrdiff_t s, int n)
{
	const int first = sys->from, last = sys->to - 1;
	double share[BLOCK];

	for (int i = 0; i < n; i++)
		share[i] = (x[first * s + i] + sys->tail * x[last * s + i]) * sys->scale;
	for (int m = first; m <= last; m++)
		for (int i = 0; i < n; i++)
			x[m * s + i] -= share[i] * sys->loop[m];
}

/* Solves along an axis of stride s, for n adjacent lines at once. */
static void solve_lines(const struct system *sys, double *x, ptrdiff_t s, int n)
{
	const int first = sys->from, last = sys->to - 1;

	for (int m = first; m <= last; m++) {
		double *here = x + m * s, lower = m > first ? sys->lower[m] : 0, inverse = sys->inverse[m];
		const double *before = here - (m > first ? s : 0);

#pragma omp simd
		for (int i = 0; i < n; i++)
			here[i] = (here[i] - lower * before[i]) * inverse;
	}
	for (int m = last - 1; m >= first; m--) {
		double *here = x + m * s, upper = sys->upper[m];

#pragma omp simd
		for (int i = 0; i < n; i++)
			here[i] -= upper * here[i + s];
	}
	for (int i = 0; sys->loop && i < n; i += BLOCK)
		correct_periodic_lines(sys, x + i, s, n - i < BLOCK ? n - i : BLOCK);
}

/* The same along x, where the points of a line are adjacent. */
static void solve_row(const struct system *sys, double *x)
{
	const int first = sys->from, last = sys->to - 1;
	double before = 0, share;

	for (int m = first; m <= last; m++)
		x[m] = before = (x[m] - (m > first ? sys->lower[m] : 0) * before) * sys->inverse[m];
	for (int m = last - 1; m >= first; m--)
		x[m] = before = x[m] - sys->upper[m] * before;
	if (!sys->loop)
		return;
	share = (x[first] + sys->tail * x[last]) * sys->scale;
	for (int m = first; m <= last; m++)
		x[m] -= share * sys->loop[m];
}

/* ---- one component */

struct component {
	const struct ts_viscous_step *step;
	int c;
	const struct system *system; /* [3] */
	double *out;
	int low, high; /* planes of this rank */
};

static void solve_plane(const struct component *of, int k)
{
	const struct ts_grid *grid = &of->step->fluid->grid;
	const struct system *x = &of->system[0], *y = &of->system[1];

	for (int j = y->from; j < y->to; j++) {
		double *row = of->out + ts_at(grid, 0, j, k);

		change_row(of->step, of->c, j, k, x->from, x->to, row);
		solve_row(x, row);
	}
	solve_lines(y, of->out + ts_at(grid, x->from, 0, k), grid->stride[1], x->to - x->from);
}

/* Along z. */
static void solve_column(const struct component *of, int j)
{
	const struct ts_grid *grid = &of->step->fluid->grid;
	const struct system *x = &of->system[0];

	if (grid->dimensions == 3)
		solve_lines(&of->system[2], of->out + ts_at(grid, x->from, j, 0), grid->stride[2],
			    x->to - x->from);
}

/* From the change to the velocity. */
static void add_velocity(const struct component *of, int j, int k)
{
	const struct ts_fluid *fluid = of->step->fluid;
	const struct system *x = &of->system[0];
	const size_t at = ts_at(&fluid->grid, 0, j, k);

	for (int i = x->from; i < x->to; i++)
		of->out[at + (size_t)i] += fluid->u[of->c][at + (size_t)i];
}

static void solve_whole(const struct component *of)
{
	const struct system *y = &of->system[1];

#pragma omp parallel num_threads(of->step->threads)
	{
#pragma omp for schedule(static)
		for (int k = of->low; k < of->high; k++)
			solve_plane(of, k);
#pragma omp for schedule(static)
		for (int j = y->from; j < y->to; j++) {
			solve_column(of, j);
			for (int k = of->low; k < of->high; k++)
				add_velocity(of, j, k);
		}
	}
}

/* ---- one component, divided among ranks: each solves along x and y in planes of its own, and along z in rows of its own, of
 * which it gets all planes */

static void rows_of(const struct component *of, int rank, int from[2])
{
	const struct system *y = &of->system[1];

	for (int k = 0; k < 2; k++)
		from[k] = y->from + (int)ts_slabs_part(of->step->slabs, rank + k, (size_t)(y->to - y->from));
}

static void columns_of_rows(const void *component, int rank, size_t from[2])
{
	const struct component *of = component;
	int row[2];

	rows_of(of, rank, row);
	for (int k = 0; k < 2; k++)
		from[k] = (size_t)row[k] * (size_t)of->step->fluid->grid.stride[1];
}

static void solve_own_planes(const struct component *of)
{
#pragma omp parallel for num_threads(of->step->threads) schedule(static)
	for (int k = of->low; k < of->high; k++)
		solve_plane(of, k);
}

static void solve_own_rows(const struct component *of)
{
	int row[2];

	rows_of(of, of->step->slabs->world->rank, row);
#pragma omp parallel for num_threads(of->step->threads) schedule(static)
	for (int j = row[0]; j < row[1]; j++)
		solve_column(of, j);
}

static void add_own_velocity(const struct component *of)
{
	const struct system *y = &of->system[1];

#pragma omp parallel for num_threads(of->step->threads) schedule(static)
	for (int k = of->low; k < of->high; k++)
		for (int j = y->from; j < y->to; j++)
			add_velocity(of, j, k);
}

static enum ts_status solve_divided(const struct component *of)
{
	const struct ts_grid *grid = &of->step->fluid->grid;
	const struct ts_transposition t = { .slabs = of->step->slabs,
					    .field = { of->out + ts_at(grid, -grid->ghosts[0], 0, 0),
						       (size_t)grid->stride[2], 0,
						       of->system[2].to > grid->n[2] },
					    .columns = columns_of_rows,
					    .of = of };

	TS_TRY(ts_transposition_room(&t));
	if (of->step->rehearsal) {
		ts_transpose(&t, false);
		ts_transpose(&t, true);
		return TS_OK;
	}
	solve_own_planes(of);
	ts_transpose(&t, false);
	solve_own_rows(of);
	ts_transpose(&t, true);
	add_own_velocity(of);
	return TS_OK;
}

/* The planes of this rank; the last one has the one behind the grid, too. */
static void find_planes(struct component *of)
{
	const struct ts_grid *grid = &of->step->fluid->grid;
	const struct system *z = &of->system[2];
	size_t from, to;

	of->low = 0;
	of->high = 1;
	if (grid->dimensions < 3)
		return;
	ts_slabs_own(of->step->slabs, (size_t)grid->n[2], &from, &to);
	of->low = z->from > (int)from ? z->from : (int)from;
	of->high = (int)to == grid->n[2] ? z->to : (int)to;
}

static enum ts_status solve_component(const struct ts_viscous_step *step, int c, const struct system sys[3],
				      double *out)
{
	struct component of = { .step = step, .c = c, .system = sys, .out = out };

	find_planes(&of);
	if (ts_slabs_ranks(step->slabs) > 1)
		return solve_divided(&of);
	solve_whole(&of);
	return TS_OK;
}

enum ts_status ts_viscous_step(const struct ts_viscous_step *step, double *const out[3])
{
	const int dimensions = step->fluid->grid.dimensions;
	enum ts_status status = TS_OK;

	for (int c = 0; c < dimensions && status == TS_OK; c++) {
		struct system sys[3] = { { 0 } };

		for (int d = 0; d < dimensions && status == TS_OK; d++)
			status = make_system(step, c, d, &sys[d]);
		if (status == TS_OK)
			status = solve_component(step, c, sys, out[c]);
		for (int d = 0; d < dimensions; d++)
			ts_free(sys[d].memory);
	}
	return status;
}
