#include "poisson/direct.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

#include "base/alloc.h"
#include "base/clones.h"
#include "base/parallel.h"
#include "poisson/direct_exchange.h"

#include "base/banned.h"

enum { STRIP = 64 }; /* number of modes eliminated at once */

static bool is_periodic(const struct ts_poisson *problem, int d)
{
	return problem->condition[d][0] == TS_PRESSURE_PERIODIC;
}

/* Whether the modes of an axis are waves. */
static bool is_uniform_axis(const struct ts_poisson *problem, int d)
{
	const enum ts_pressure_condition *end = problem->condition[d];

	return problem->grid->uniform[d] && (end[0] == end[1] || problem->grid->n[d] % 2 == 0);
}

/* Chooses the third axis: of those that can be eliminated the most expensive to transform. */
static int choose_third_axis(const struct ts_poisson *problem)
{
	const struct ts_grid *grid = problem->grid;
	int best = grid->dimensions - 1;
	double most = -1;

	for (int d = grid->dimensions - 1; d >= 0; d--) {
		double price = is_periodic(problem, d) ? -1 : is_uniform_axis(problem, d) ? 0 : grid->n[d];

		if (price > most) {
			most = price;
			best = d;
		}
	}
	return best;
}

/* Measured: per cell 2 ns for wave transforms, forward and backward, 0.11 ns times the number of cells
 * along the axis for a matrix, and 3 ns for the rest; the modes of a matrix take 10 ns times the cube of
 * that number. */
double ts_direct_cost(const struct ts_poisson *problem)
{
	int third = choose_third_axis(problem);
	double cell = 3e-9, once = 0;

	for (int d = 0; d < problem->grid->dimensions; d++) {
		double n = problem->grid->n[d];

		if (d == third && !is_periodic(problem, d))
			continue;
		cell += is_uniform_axis(problem, d) ? 2e-9 : 0.11e-9 * n;
		once += is_uniform_axis(problem, d) ? 0 : 1e-8 * n * n * n;
	}
	return cell * (double)ts_grid_cells(problem->grid) + 1e-3 * once;
}

static void order_axes(struct ts_direct *s, const struct ts_poisson *problem)
{
	int third = choose_third_axis(problem), k = 0;

	s->axis[1] = 2; /* in two dimensions: one cell */
	for (int d = 0; d < problem->grid->dimensions; d++)
		if (d != third)
			s->axis[k++] = d;
	s->axis[2] = third;
	for (k = 0; k < 3; k++)
		s->n[k] = problem->grid->n[s->axis[k]];
}

static void set_third_axis(struct ts_direct *s, const struct ts_poisson *problem)
{
	const double *h = problem->grid->width[s->axis[2]];
	double length = 0;

	for (int k = 0; k < s->n[2]; k++) {
		s->below[k] = ts_poisson_conductance(problem, s->axis[2], k) / h[k];
		s->above[k] = ts_poisson_conductance(problem, s->axis[2], k + 1) / h[k];
		length += h[k];
	}
	for (int k = 0; k < s->n[2]; k++)
		s->width_fraction[k] = h[k] / length;
}

static void fill_modes(struct ts_direct *s, const struct ts_poisson *problem)
{
	const struct ts_transform *t = s->transform;
	size_t first = (size_t)s->n[0];

	for (size_t m = 0; m < first * (size_t)s->n[1]; m++)
		s->eigenvalue[m] =
			t[0].eigenvalue[m % first] +
			(s->n[1] > 1 || problem->grid->dimensions > 2 ? t[1].eigenvalue[m / first] : 0);
	s->singular = SIZE_MAX;
	if (problem->singular)
		s->singular = (size_t)t[0].constant +
			      first * (problem->grid->dimensions > 2 ? (size_t)t[1].constant : 0);
}

static enum ts_status make_transforms(struct ts_direct *s, const struct ts_poisson *problem)
{
	size_t most = 0, longest = 0;

	for (int k = 0; k < 3; k++) {
		if ((k == 1 && problem->grid->dimensions < 3) || (k == 2 && s->eliminates))
			continue;
		TS_TRY(ts_transform_make(&s->transform[k], problem, s->axis[k]));
		longest = (size_t)s->n[k] > longest ? (size_t)s->n[k] : longest;
		most = ts_transform_work_size(&s->transform[k]) > most
			       ? ts_transform_work_size(&s->transform[k])
			       : most;
	}
	/* lines and work memory of their transforms, or coefficients of an elimination */
	s->line_size = longest * TS_LINES;
	most += s->line_size;
	s->spare_size = most > (size_t)s->n[2] * STRIP ? most : (size_t)s->n[2] * STRIP;
	s->spare = ts_alloc_aligned((size_t)s->threads, s->spare_size * sizeof *s->spare);
	return s->spare ? TS_OK : TS_NOMEM;
}

enum ts_status ts_direct_make(struct ts_direct *s, const struct ts_poisson *problem, int threads)
{
	size_t modes, n;

	*s = (struct ts_direct){ .origin = problem->grid->origin, .threads = threads };
	memcpy(s->stride, problem->grid->stride, sizeof s->stride);
	order_axes(s, problem);
	s->eliminates = !is_periodic(problem, s->axis[2]);
	s->strip = s->eliminates ? STRIP : TS_LINES;
	modes = (size_t)s->n[0] * (size_t)s->n[1];
	n = (size_t)s->n[2];
	s->plane = ts_direct_plane(modes);
	s->work = ts_alloc_pages(s->plane * n, sizeof *s->work, problem->grid->sparse);
	s->eigenvalue = ts_alloc_aligned(modes + 3 * n, sizeof *s->eigenvalue);
	if (!s->work || !s->eigenvalue)
		return TS_NOMEM;
	s->below = s->eigenvalue + modes;
	s->above = s->below + n;
	s->width_fraction = s->above + n;
	TS_TRY(make_transforms(s, problem));
	set_third_axis(s, problem);
	fill_modes(s, problem);
	return TS_OK;
}

void ts_direct_release(struct ts_direct *s)
{
	for (int k = 0; k < 3; k++)
		ts_transform_release(&s->transform[k]);
	ts_direct_release_columns(s);
	ts_free_pages(s->work);
	ts_free(s->eigenvalue);
	ts_free(s->spare);
	*s = (struct ts_direct){ 0 };
}

struct task;
/* Of a plane of modes, or a row of all planes. */
typedef void step_fn(const struct task *task, int at, double *lines, double *spare);

struct task {
	const struct ts_direct *s;
	const double *rhs;
	double *p;
	int each;	      /* planes or rows that a share is made of */
	size_t threads;	      /* whose spare is whose */
	size_t shares, first; /* of this rank: number, and the first one */
	step_fn *step[2];     /* NULL: none */
};

/* Rows along the first axis in a field of the grid, and in the work memory. */
struct rows {
	int count;
	ptrdiff_t apart, step; /* from row to row, from cell to cell */
	ptrdiff_t work_apart;
	size_t start, work_start;
};

/* `count` rows from row j of plane c on, which follow each other along axis 1 or 2. */
static struct rows find_rows(const struct ts_direct *s, int j, int c, int across, int count)
{
	return (struct rows){ .count = count,
			      .apart = s->stride[s->axis[across]],
			      .step = s->stride[s->axis[0]],
			      .work_apart = across == 1 ? s->n[0] : (ptrdiff_t)s->plane,
			      .start = (size_t)((ptrdiff_t)s->origin + j * s->stride[s->axis[1]] +
						c * s->stride[s->axis[2]]),
			      .work_start = (size_t)c * s->plane + (size_t)j * (size_t)s->n[0] };
}

static int at_most_lines(int n)
{
	return n < TS_LINES ? n : TS_LINES;
}

/* Those of a plane; in two dimensions of TS_LINES planes. */
static struct rows rows_of_plane(const struct ts_direct *s, int c)
{
	return s->n[1] > 1 ? find_rows(s, 0, c, 1, s->n[1])
			   : find_rows(s, 0, c, 2, at_most_lines(s->n[2] - c));
}

/* Copies rows to interleaved lines, and back. Missing rows are 0. */
static void gather_lines(const double *restrict row, int count, ptrdiff_t apart, int n, ptrdiff_t step,
			 double *restrict lines)
{
	if (count < TS_LINES)
		memset(lines, 0, (size_t)n * TS_LINES * sizeof *lines);
	for (int l = 0; l < count; l++, row += apart)
		for (int i = 0; i < n; i++)
			lines[i * TS_LINES + l] = row[i * step];
}

static void scatter_lines(const double *restrict lines, int count, ptrdiff_t apart, int n, ptrdiff_t step,
			  double *restrict row)
{
	for (int l = 0; l < count; l++, row += apart)
		for (int i = 0; i < n; i++)
			row[i * step] = lines[i * TS_LINES + l];
}

static void forward_rows(const struct task *task, const struct rows *r, double *lines, double *spare)
{
	const struct ts_direct *s = task->s;
	const double *from = task->rhs + r->start;
	double *to = s->work + r->work_start;

	for (int row = 0; row < r->count; row += TS_LINES) {
		int count = at_most_lines(r->count - row);

		gather_lines(from + row * r->apart, count, r->apart, s->n[0], r->step, lines);
		ts_transform_forward(&s->transform[0], lines, spare);
		scatter_lines(lines, count, r->work_apart, s->n[0], 1, to + row * r->work_apart);
	}
}

static void backward_rows(const struct task *task, const struct rows *r, double *lines, double *spare)
{
	const struct ts_direct *s = task->s;
	const double *from = s->work + r->work_start;
	double *to = task->p + r->start;

	for (int row = 0; row < r->count; row += TS_LINES) {
		int count = at_most_lines(r->count - row);

		gather_lines(from + row * r->work_apart, count, r->work_apart, s->n[0], 1, lines);
		ts_transform_backward(&s->transform[0], lines, spare);
		scatter_lines(lines, count, r->apart, s->n[0], r->step, to + row * r->apart);
	}
}

static void first_forward(const struct task *task, int c, double *lines, double *spare)
{
	const struct rows r = rows_of_plane(task->s, c);

	forward_rows(task, &r, lines, spare);
}

static void first_backward(const struct task *task, int c, double *lines, double *spare)
{
	const struct rows r = rows_of_plane(task->s, c);

	backward_rows(task, &r, lines, spare);
}

/* Row j of all planes. */
static void row_forward(const struct task *task, int j, double *lines, double *spare)
{
	const struct rows r = find_rows(task->s, j, 0, 2, task->s->n[2]);

	forward_rows(task, &r, lines, spare);
}

static void row_backward(const struct task *task, int j, double *lines, double *spare)
{
	const struct rows r = find_rows(task->s, j, 0, 2, task->s->n[2]);

	backward_rows(task, &r, lines, spare);
}

typedef void transform_fn(const struct ts_transform *t, double *lines, double *spare);

/* Columns of n values, `stride` apart, adjacent in the work memory. */
static void load_columns(const double *work, size_t stride, int n, int count, double *lines)
{
	for (int j = 0; j < n; j++) {
		memcpy(lines + j * TS_LINES, work + (size_t)j * stride, (size_t)count * sizeof *lines);
		if (count < TS_LINES)
			memset(lines + j * TS_LINES + count, 0, (size_t)(TS_LINES - count) * sizeof *lines);
	}
}

static void store_columns(const double *lines, size_t stride, int n, int count, double *work)
{
	for (int j = 0; j < n; j++)
		memcpy(work + (size_t)j * stride, lines + j * TS_LINES, (size_t)count * sizeof *lines);
}

static void transform_second_axis(const struct task *task, transform_fn *transform, int c, double *lines,
				  double *spare)
{
	const struct ts_direct *s = task->s;
	double *work = s->work + (size_t)c * s->plane;

	for (int i = 0; i < s->n[0]; i += TS_LINES) {
		int count = s->n[0] - i < TS_LINES ? s->n[0] - i : TS_LINES;

		load_columns(work + i, (size_t)s->n[0], s->n[1], count, lines);
		transform(&s->transform[1], lines, spare);
		store_columns(lines, (size_t)s->n[0], s->n[1], count, work + i);
	}
}

/* Threads process ranges of planes; the first plane of a range determines its work memory. */
static double *thread_work_memory(const struct task *task, size_t from)
{
	size_t thread = 0;

	while (task->shares * (thread + 1) / task->threads <= from)
		thread++;
	return task->s->spare + thread * task->s->spare_size;
}

static void second_forward(const struct task *task, int c, double *lines, double *spare)
{
	if (task->s->n[1] > 1)
		transform_second_axis(task, ts_transform_forward, c, lines, spare);
}

static void second_backward(const struct task *task, int c, double *lines, double *spare)
{
	if (task->s->n[1] > 1)
		transform_second_axis(task, ts_transform_backward, c, lines, spare);
}

static void make_steps(void *context, size_t from, size_t to)
{
	const struct task *task = context;
	double *lines = thread_work_memory(task, from), *spare = lines + task->s->line_size;

	for (size_t share = from; share < to; share++)
		for (int k = 0; k < 2 && task->step[k]; k++)
			task->step[k](task, (int)(task->first + share) * task->each, lines, spare);
}

/* One row of the forward elimination: new coefficient to the row above, and new right-hand side. */
TS_CLONES
static void eliminate(const double *restrict eigenvalue, double below, double above,
		      const double *restrict factor_below, const double *restrict row_below,
		      double *restrict factor, double *restrict row, size_t n)
{
#pragma omp simd
	for (size_t m = 0; m < n; m++) {
		double pivot = eigenvalue[m] - below - above - below * factor_below[m];
		double inverse = 1 / pivot;

		factor[m] = above * inverse;
		row[m] = (row[m] - below * row_below[m]) * inverse;
	}
}

TS_CLONES
static void substitute(const double *restrict factor, const double *restrict row_above, double *restrict row,
		       size_t n)
{
#pragma omp simd
	for (size_t m = 0; m < n; m++)
		row[m] -= factor[m] * row_above[m];
}

/* The singular mode: the pivot of the last row would be 0; its value is set, then the mean is subtracted. */
static void fix_mean(const struct ts_direct *s)
{
	double *mode = s->work + s->singular, mean = 0;

	for (int k = 0; k < s->n[2]; k++)
		mean += s->width_fraction[k] * mode[(size_t)k * s->plane];
	for (int k = 0; k < s->n[2]; k++)
		mode[(size_t)k * s->plane] -= mean;
}

static void eliminate_strip(const struct ts_direct *s, size_t mode, size_t n, double *factor)
{
	static const double zero[STRIP];
	int last = s->n[2] - 1;
	double *work = s->work + mode;

	for (int k = 0; k <= last; k++) {
		double *row = work + (size_t)k * s->plane;

		/* a given value beyond the first face is 0, and there is no row below */
		eliminate(s->eigenvalue + mode, s->below[k], s->above[k],
			  k ? factor + (size_t)(k - 1) * STRIP : zero, k ? row - s->plane : zero,
			  factor + (size_t)k * STRIP, row, n);
	}
	if (s->singular >= mode && s->singular < mode + n)
		work[(size_t)last * s->plane + (s->singular - mode)] = 0;
	for (int k = last - 1; k >= 0; k--) {
		double *row = work + (size_t)k * s->plane;

		substitute(factor + (size_t)k * STRIP, row + s->plane, row, n);
	}
	if (s->singular >= mode && s->singular < mode + n)
		fix_mean(s);
}

static void eliminate_strips(void *context, size_t from, size_t to)
{
	const struct task *task = context;
	size_t modes = (size_t)task->s->n[0] * (size_t)task->s->n[1];
	double *factor = thread_work_memory(task, from);

	for (size_t strip = from; strip < to; strip++) {
		size_t mode = (task->first + strip) * STRIP, n = modes - mode < STRIP ? modes - mode : STRIP;

		eliminate_strip(task->s, mode, n, factor);
	}
}

/* Modes of all three axes: each is divided by its eigenvalue. */
TS_CLONES
static void divide_by_eigenvalues(const struct ts_direct *s, size_t mode, int count, double *lines)
{
	const struct ts_transform *t = &s->transform[2];

	for (int k = 0; k < s->n[2]; k++)
#pragma omp simd
		for (int l = 0; l < count; l++)
			lines[k * TS_LINES + l] /= s->eigenvalue[mode + (size_t)l] + t->eigenvalue[k];
	if (s->singular >= mode && s->singular < mode + (size_t)count)
		lines[(size_t)t->constant * TS_LINES + (s->singular - mode)] = 0;
}

static void transform_strips(void *context, size_t from, size_t to)
{
	const struct task *task = context;
	const struct ts_direct *s = task->s;
	size_t modes = (size_t)s->n[0] * (size_t)s->n[1];
	double *lines = thread_work_memory(task, from), *spare = lines + s->line_size;

	for (size_t strip = from; strip < to; strip++) {
		size_t mode = (task->first + strip) * TS_LINES;
		int count = modes - mode < TS_LINES ? (int)(modes - mode) : TS_LINES;

		load_columns(s->work + mode, s->plane, s->n[2], count, lines);
		ts_transform_forward(&s->transform[2], lines, spare);
		divide_by_eigenvalues(s, mode, count, lines);
		ts_transform_backward(&s->transform[2], lines, spare);
		store_columns(lines, s->plane, s->n[2], count, s->work + mode);
	}
}

static void share_among_threads(struct task *task, const struct ts_slabs *slabs, size_t shares,
				ts_range_fn *share)
{
	size_t end;

	ts_slabs_own(slabs, shares, &task->first, &end);
	shares = end - task->first;
	task->shares = shares;
	task->threads = shares < (size_t)task->s->threads ? shares : (size_t)task->s->threads;
	ts_parallel((int)task->threads, shares, share, task);
}

/* Of n planes or rows. */
static void process(struct task *task, const struct ts_slabs *slabs, int n, step_fn *first, step_fn *second)
{
	task->step[0] = first;
	task->step[1] = second;
	share_among_threads(task, slabs, (size_t)((n + task->each - 1) / task->each), make_steps);
}

static void process_strips(struct task *task, const struct ts_slabs *slabs)
{
	const struct ts_direct *s = task->s;
	const size_t modes = (size_t)s->n[0] * (size_t)s->n[1];

	share_among_threads(task, slabs, (modes + s->strip - 1) / s->strip,
			    s->eliminates ? eliminate_strips : transform_strips);
}

static void solve_by_planes(struct task *task)
{
	const struct ts_direct *s = task->s;

	task->each = s->n[1] > 1 ? 1 : TS_LINES;
	process(task, s->slabs, s->n[2], first_forward, second_forward);
	ts_direct_exchange(s, false);
	process_strips(task, s->slabs);
	ts_direct_exchange(s, true);
	process(task, s->slabs, s->n[2], second_backward, first_backward);
}

/* Slabs of ranks are across the second axis: each has rows of all planes, and after the exchange columns. Lines that are
 * transformed together are those of one row, on one rank, too: their rounding depends on each other. */
static void solve_by_rows(struct task *task)
{
	const struct ts_direct *s = task->s;
	struct task columns = { .s = ts_direct_divided(s) ? s->columns : s, .each = 1 };

	task->each = 1;
	process(task, s->slabs, s->n[1], row_forward, NULL);
	ts_direct_exchange(s, false);
	process(&columns, NULL, s->n[2], second_forward, NULL);
	process_strips(&columns, NULL);
	process(&columns, NULL, s->n[2], second_backward, NULL);
	ts_direct_exchange(s, true);
	process(task, s->slabs, s->n[1], row_backward, NULL);
}

void ts_direct_solve(const struct ts_direct *s, const double *rhs, double *p)
{
	struct task task = { .s = s, .rhs = rhs, .p = p };

	if (s->n[1] > 1 && s->axis[1] == 2)
		solve_by_rows(&task);
	else
		solve_by_planes(&task);
}
