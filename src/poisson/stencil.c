#include "poisson/stencil.h"

#include <math.h>
#include <string.h>

#include "base/alloc.h"
#include "base/clones.h"
#include "base/inline.h"

#include "base/banned.h"

enum { LANES = 8 }; /* number of partial sums in a row, on any processor */

/* Number of rows per thread, below which another thread does not pay. */
enum { GHOST_ROWS = 512 };

/* An odd period needs a third colour, for its last cell. */
static void set_colours(struct ts_stencil *s)
{
	s->colours = 2;
	for (int d = 0; d < 3; d++) {
		int n = s->n[d];

		for (int i = 0; i < n; i++)
			s->colour[d][i] = i % 2;
		if (s->periodic[d] && n % 2) {
			s->colours = 3;
			s->colour[d][n - 1] = 2;
		}
	}
}

enum ts_status ts_stencil_shape(struct ts_stencil *s, const int n[3], int axes, const bool periodic[3],
				bool sparse)
{
	size_t lengths = 0;

	*s = (struct ts_stencil){ .axes = axes, .threads = 1, .sparse = sparse };
	for (int d = 0; d < 3; d++) {
		s->n[d] = n[d];
		s->periodic[d] = periodic[d];
		lengths += 3 * (size_t)n[d] + 1;
	}
	/* Rows begin on cache lines, and have a ghost on either side. */
	s->stride[0] = 1;
	s->stride[1] = (n[0] + 1 + 8 + 7) / 8 * 8;
	s->stride[2] = s->stride[1] * (n[1] + 2);
	s->origin = (size_t)(8 + s->stride[1] + (axes > 2 ? s->stride[2] : 0));
	s->size = (size_t)(s->stride[2] * (n[2] + (axes > 2 ? 2 : 0)) + 8);
	s->memory = ts_alloc(lengths + (size_t)ts_stencil_rows(s), sizeof(double));
	s->fields = ts_alloc_pages(((size_t)axes + 1) * s->size, sizeof(double), sparse);
	if (!s->memory || !s->fields)
		return TS_NOMEM;
	s->rows = s->memory;
	lengths = (size_t)ts_stencil_rows(s);
	for (int d = 0; d < 3; d++) {
		s->width[d] = s->memory + lengths;
		s->conductance[d] = s->width[d] + n[d];
		s->link[d] = d < axes ? s->fields + (size_t)d * s->size : NULL;
		s->colour[d] = s->conductance[d] + n[d] + 1;
		lengths += 3 * (size_t)n[d] + 1;
	}
	set_colours(s);
	s->inverse = s->fields + (size_t)axes * s->size;
	return TS_OK;
}

enum ts_status ts_stencil_make(struct ts_stencil *s, const struct ts_poisson *problem)
{
	const struct ts_grid *grid = problem->grid;
	bool periodic[3];

	for (int d = 0; d < 3; d++)
		periodic[d] = d < grid->dimensions && problem->condition[d][0] == TS_PRESSURE_PERIODIC;
	TS_TRY(ts_stencil_shape(s, grid->n, grid->dimensions, periodic, grid->sparse));
	s->threads = problem->threads;
	s->singular = problem->singular;
	for (int d = 0; d < 3; d++) {
		memcpy(s->width[d], grid->width[d], (size_t)grid->n[d] * sizeof(double));
		for (int i = 0; i <= grid->n[d]; i++)
			s->conductance[d][i] = ts_poisson_conductance(problem, d, i);
	}
	return TS_OK;
}

void ts_stencil_release(struct ts_stencil *s)
{
	ts_free(s->memory);
	ts_free_pages(s->fields);
	*s = (struct ts_stencil){ 0 };
}

double *ts_stencil_field(const struct ts_stencil *s)
{
	return ts_alloc_pages(s->size, sizeof(double), s->sparse);
}

void ts_stencil_field_free(double *field)
{
	ts_free_pages(field);
}

void ts_stencil_clear(const struct ts_stencil *s, double *p)
{
	size_t from, to;

	ts_slabs_own(s->slabs, (size_t)s->n[2], &from, &to);
	if (ts_slabs_ranks(s->slabs) == 1) {
		memset(p, 0, s->size * sizeof *p);
		return;
	}
	/* from the ghosts of the plane below to the ghosts of the plane above */
	memset(p + from * (size_t)s->stride[2], 0, ((to + 2 - from) * (size_t)s->stride[2] + 8) * sizeof *p);
}

/* The links of faces across axis d in one row of cells, or of the faces above the last ones. */
static void set_row_links(struct ts_stencil *s, const struct ts_poisson *problem, int d, int j, int k)
{
	const struct ts_grid *grid = problem->grid;
	const double *weight = problem->weight[d];
	int index[3] = { 0, j, k };
	double *link = s->link[d] + ts_stencil_at(s, 0, j, k);
	double area = 1;

	for (int a = 1; a < 3; a++)
		area *= a == d ? s->conductance[a][index[a]] : s->width[a][index[a]];
	if (s->periodic[d] && d > 0 && index[d] == s->n[d])
		index[d] = 0;
	weight = weight ? weight + ts_at(grid, 0, index[1], index[2]) : NULL;
	for (int i = 0; i < s->n[0] + (d == 0); i++) {
		double across = d == 0 ? s->conductance[0][i] : s->width[0][i];
		int face = d == 0 && s->periodic[0] && i == s->n[0] ? 0 : i;

		/* the weight of a face with zero gradient may be undefined (NaN) */
		link[i] = area * across == 0 ? 0 : area * across * (weight ? weight[face] : 1);
	}
}

void ts_stencil_set_weights(struct ts_stencil *s, const struct ts_poisson *problem)
{
	const int more = ts_slabs_ranks(s->slabs) > 1 ? problem->grid->ghosts[2] : 0;
	size_t own, behind;

	ts_slabs_own(s->slabs, (size_t)s->n[2], &own, &behind);
	for (int d = 0; d < s->axes; d++) {
		const int ny = s->n[1] + (d == 1), planes = s->n[2] + (d == 2);
		const int from = (int)own > more ? (int)own - more : 0;
		const int to = (int)behind + more + 1 < planes ? (int)behind + more + 1 : planes;

#pragma omp parallel for num_threads(s->threads) schedule(static)
		for (int row = from * ny; row < to * ny; row++)
			set_row_links(s, problem, d, row % ny, row / ny);
	}
	ts_stencil_invert_diagonal(s);
}

static void invert_row(struct ts_stencil *s, size_t at)
{
	for (size_t i = at; i < at + (size_t)s->n[0]; i++) {
		double sum = 0;

		for (int d = 0; d < s->axes; d++)
			sum += s->link[d][i] + s->link[d][i + (size_t)s->stride[d]];
		s->inverse[i] = sum > 0 ? 1 / sum : 0;
	}
}

void ts_stencil_invert_diagonal(struct ts_stencil *s)
{
	int first, end;

	ts_stencil_own(s, &first, &end);
#pragma omp parallel for num_threads(s->threads) schedule(static)
	for (int row = first; row < end; row++)
		invert_row(s, ts_stencil_row(s, row));
}

static double row_area(const struct ts_stencil *s, int row)
{
	return s->width[1][row % s->n[1]] * s->width[2][row / s->n[1]];
}

void ts_stencil_from_grid(const struct ts_stencil *s, const struct ts_grid *grid, const double *field,
			  bool volumes, double *out)
{
	int first, end;

	ts_stencil_own(s, &first, &end);
#pragma omp parallel for num_threads(s->threads) schedule(static)
	for (int row = first; row < end; row++) {
		const double *from = field + ts_at(grid, 0, row % s->n[1], row / s->n[1]);
		double *to = out + ts_stencil_row(s, row), area = row_area(s, row);

		for (int i = 0; i < s->n[0]; i++)
			to[i] = volumes ? -from[i] * (s->width[0][i] * area) : from[i];
	}
}

void ts_stencil_to_grid(const struct ts_stencil *s, const struct ts_grid *grid, const double *field,
			double *out)
{
	int first, end;

	ts_stencil_own(s, &first, &end);
#pragma omp parallel for num_threads(s->threads) schedule(static)
	for (int row = first; row < end; row++)
		memcpy(out + ts_at(grid, 0, row % s->n[1], row / s->n[1]), field + ts_stencil_row(s, row),
		       (size_t)s->n[0] * sizeof *out);
}

TS_CLONES
static void divide_by_volume(const double *restrict r, const double *restrict width, double area,
			     double *restrict out, int n)
{
#pragma omp simd
	for (int i = 0; i < n; i++)
		out[i] = -r[i] / (width[i] * area);
}

void ts_stencil_per_volume(const struct ts_stencil *s, const double *r, double *out)
{
	int first, end;

	ts_stencil_own(s, &first, &end);
#pragma omp parallel for num_threads(s->threads) schedule(static)
	for (int row = first; row < end; row++) {
		size_t at = ts_stencil_row(s, row);

		divide_by_volume(r + at, s->width[0], row_area(s, row), out + at, s->n[0]);
	}
}

static void copy_row(const struct ts_stencil *s, double *p, size_t to, size_t from)
{
	memcpy(p + to, p + from, (size_t)s->n[0] * sizeof *p);
}

/* Ghosts along x and y of planes from .. to - 1, modulo their number. */
static void set_ghosts_of_planes(const struct ts_stencil *s, double *p, int from, int to)
{
	const int rows = (to - from) * s->n[1], team = 1 + rows / GHOST_ROWS;

#pragma omp parallel num_threads(team < s->threads ? team : s->threads)
	{
#pragma omp for schedule(static) nowait
		for (int row = 0; row < (s->periodic[0] ? rows : 0); row++) {
			const int k = (from + row / s->n[1] + s->n[2]) % s->n[2];
			double *first = p + ts_stencil_at(s, 0, row % s->n[1], k);

			first[-1] = first[s->n[0] - 1];
			first[s->n[0]] = first[0];
		}
#pragma omp for schedule(static) nowait
		for (int plane = from; plane < (s->periodic[1] ? to : from); plane++) {
			const int k = (plane + s->n[2]) % s->n[2];

			copy_row(s, p, ts_stencil_at(s, 0, -1, k), ts_stencil_at(s, 0, s->n[1] - 1, k));
			copy_row(s, p, ts_stencil_at(s, 0, s->n[1], k), ts_stencil_at(s, 0, 0, k));
		}
	}
}

/* Ghosts are set from inner cells only, so that the axes are independent. */
void ts_stencil_ghosts_beside(const struct ts_stencil *s, double *p, int below, int above)
{
	const struct ts_slabs_field planes = { p + ts_stencil_at(s, 0, 0, 0), (size_t)s->stride[2], 0, 0 };
	size_t from, to;

	ts_slabs_share_beside(s->slabs, &planes, below, above, s->periodic[2]);
	if (!s->periodic[0] && !s->periodic[1] && !s->periodic[2])
		return;
	ts_slabs_own(s->slabs, (size_t)s->n[2], &from, &to);
	if (ts_slabs_ranks(s->slabs) == 1)
		below = above = 0;
	if (!s->periodic[2]) {
		below = below < (int)from ? below : (int)from;
		above = above < s->n[2] - (int)to ? above : s->n[2] - (int)to;
	}
	set_ghosts_of_planes(s, p, (int)from - below, (int)to + above);
	for (int j = 0; j < (s->periodic[2] ? s->n[1] : 0); j++) {
		copy_row(s, p, ts_stencil_at(s, 0, j, -1), ts_stencil_at(s, 0, j, s->n[2] - 1));
		copy_row(s, p, ts_stencil_at(s, 0, j, s->n[2]), ts_stencil_at(s, 0, j, 0));
	}
}

void ts_stencil_ghosts(const struct ts_stencil *s, double *p)
{
	ts_stencil_ghosts_beside(s, p, 1, 1);
}

/* out = A p along a row. */
TS_INLINE void apply_axes(const struct ts_stencil *s, size_t at, const double *restrict p,
			  double *restrict out, int axes)
{
	const double *restrict cx = s->link[0] + at, *restrict cy = s->link[1] + at;
	const double *restrict cz = axes > 2 ? s->link[2] + at : NULL;
	const ptrdiff_t sy = s->stride[1], sz = s->stride[2];
	const int n = s->n[0];

	p += at;
	out += at;
#pragma omp simd
	for (int i = 0; i < n; i++) {
		double here = p[i], sum;

		sum = cx[i] * (here - p[i - 1]) + cx[i + 1] * (here - p[i + 1]);
		sum += cy[i] * (here - p[i - sy]) + cy[i + sy] * (here - p[i + sy]);
		if (axes > 2)
			sum += cz[i] * (here - p[i - sz]) + cz[i + sz] * (here - p[i + sz]);
		out[i] = sum;
	}
}

TS_INLINE double dot_row(const double *restrict a, const double *restrict b, int n)
{
	double part[LANES] = { 0 }, sum = 0;
	int i = 0;

	for (; i + LANES <= n; i += LANES)
#pragma omp simd
		for (int l = 0; l < LANES; l++)
			part[l] += a[i + l] * b[i + l];
	for (; i < n; i++)
		part[i % LANES] += a[i] * b[i];
	for (int l = 0; l < LANES; l++)
		sum += part[l];
	return sum;
}

/* NaN if a value is NaN: a comparison with it is false. */
TS_INLINE double largest_row(const double *restrict r, const double *restrict width, int n)
{
	double part[LANES] = { 0 }, most = 0;
	int i = 0;

	for (; i + LANES <= n; i += LANES)
#pragma omp simd
		for (int l = 0; l < LANES; l++) {
			double value = fabs(r[i + l]) / width[i + l];

			part[l] = value <= part[l] ? part[l] : value;
		}
	for (; i < n; i++) {
		double value = fabs(r[i]) / width[i];

		part[i % LANES] = value <= part[i % LANES] ? part[i % LANES] : value;
	}
	for (int l = 0; l < LANES; l++)
		most = part[l] <= most ? most : part[l];
	return most;
}

TS_CLONES
static double apply_row(const struct ts_stencil *s, size_t at, const double *p, double *out)
{
	if (s->axes > 2)
		apply_axes(s, at, p, out, 3);
	else
		apply_axes(s, at, p, out, 2);
	return dot_row(p + at, out + at, s->n[0]);
}

TS_CLONES
static double residual_row(const struct ts_stencil *s, size_t at, const double *p, const double *restrict b,
			   double *restrict out)
{
	if (s->axes > 2)
		apply_axes(s, at, p, out, 3);
	else
		apply_axes(s, at, p, out, 2);
#pragma omp simd
	for (int i = 0; i < s->n[0]; i++)
		out[at + (size_t)i] = b[at + (size_t)i] - out[at + (size_t)i];
	return largest_row(out + at, s->width[0], s->n[0]);
}

/* Gauss-Seidel in the cells of a row that have one colour along it, */
TS_INLINE void sweep_axes(const struct ts_stencil *s, size_t at, double *p, const double *b, double wanted,
			  double omega, int axes)
{
	const double *cx = s->link[0] + at, *cy = s->link[1] + at, *inverse = s->inverse + at;
	const double *cz = axes > 2 ? s->link[2] + at : NULL;
	const ptrdiff_t sy = s->stride[1], sz = s->stride[2];
	const double *colour = s->colour[0];
	const int n = s->n[0];

	p += at;
	b += at;
#pragma omp simd
	for (int i = 0; i < n; i++) {
		double sum = b[i] + cx[i] * p[i - 1] + cx[i + 1] * p[i + 1];

		sum += cy[i] * p[i - sy] + cy[i + sy] * p[i + sy];
		if (axes > 2)
			sum += cz[i] * p[i - sz] + cz[i + sz] * p[i + sz];
		if (colour[i] == wanted)
			p[i] += omega * (sum * inverse[i] - p[i]);
	}
}

TS_CLONES
static void sweep_row(const struct ts_stencil *s, size_t at, double *p, const double *b, double wanted,
		      double omega)
{
	if (s->axes > 2)
		sweep_axes(s, at, p, b, wanted, omega, 3);
	else
		sweep_axes(s, at, p, b, wanted, omega, 2);
}

void ts_stencil_sweep(const struct ts_stencil *s, double *p, const double *b, int colour, double omega)
{
	int first, end;

	ts_stencil_own(s, &first, &end);
#pragma omp parallel for num_threads(s->threads) schedule(static)
	for (int row = first; row < end; row++) {
		int of_row = (int)(s->colour[1][row % s->n[1]] + s->colour[2][row / s->n[1]]);

		sweep_row(s, ts_stencil_row(s, row), p, b, (colour + 6 - of_row) % s->colours, omega);
	}
	ts_stencil_ghosts(s, p);
}

/* The partial results of all ranks. */
static void share_rows(const struct ts_stencil *s)
{
	const struct ts_slabs_field rows = { .first = s->rows, .stride = (size_t)s->n[1] };

	ts_slabs_share(s->slabs, &rows);
}

double ts_stencil_sum_rows(const struct ts_stencil *s)
{
	double sum = 0;

	share_rows(s);
	for (int row = 0; row < ts_stencil_rows(s); row++)
		sum += s->rows[row];
	return sum;
}

double ts_stencil_max_rows(const struct ts_stencil *s)
{
	double most = 0;

	share_rows(s);
	for (int row = 0; row < ts_stencil_rows(s); row++)
		most = s->rows[row] <= most ? most : s->rows[row];
	return most;
}

double ts_stencil_apply(const struct ts_stencil *s, const double *p, double *out)
{
	int first, end;

	ts_stencil_own(s, &first, &end);
#pragma omp parallel for num_threads(s->threads) schedule(static)
	for (int row = first; row < end; row++)
		s->rows[row] = apply_row(s, ts_stencil_row(s, row), p, out);
	return ts_stencil_sum_rows(s);
}

double ts_stencil_residual(const struct ts_stencil *s, const double *p, const double *b, double *out)
{
	int first, end;

	ts_stencil_own(s, &first, &end);
#pragma omp parallel for num_threads(s->threads) schedule(static)
	for (int row = first; row < end; row++)
		s->rows[row] = residual_row(s, ts_stencil_row(s, row), p, b, out) / row_area(s, row);
	return ts_stencil_max_rows(s);
}

double ts_stencil_residual_of_guess(const struct ts_stencil *s, double *p, const double *b, double largest,
				    double *out)
{
	double residual = ts_stencil_residual(s, p, b, out);
	int first, end;

	if (!(residual > largest))
		return residual;
	ts_stencil_clear(s, p);
	ts_stencil_own(s, &first, &end);
	for (int row = first; row < end; row++)
		memcpy(out + ts_stencil_row(s, row), b + ts_stencil_row(s, row),
		       (size_t)s->n[0] * sizeof *out);
	return largest;
}

TS_CLONES
static double largest_of_row(const double *r, const double *width, int n)
{
	return largest_row(r, width, n);
}

double ts_stencil_largest(const struct ts_stencil *s, const double *r)
{
	int first, end;

	ts_stencil_own(s, &first, &end);
#pragma omp parallel for num_threads(s->threads) schedule(static)
	for (int row = first; row < end; row++)
		s->rows[row] =
			largest_of_row(r + ts_stencil_row(s, row), s->width[0], s->n[0]) / row_area(s, row);
	return ts_stencil_max_rows(s);
}

TS_CLONES
static double dot_of_row(const double *a, const double *b, int n)
{
	return dot_row(a, b, n);
}

double ts_stencil_dot(const struct ts_stencil *s, const double *a, const double *b)
{
	int first, end;

	ts_stencil_own(s, &first, &end);
#pragma omp parallel for num_threads(s->threads) schedule(static)
	for (int row = first; row < end; row++)
		s->rows[row] = dot_of_row(a + ts_stencil_row(s, row), b + ts_stencil_row(s, row), s->n[0]);
	return ts_stencil_sum_rows(s);
}

static double total_volume(const struct ts_stencil *s)
{
	double length[3] = { 0 };

	for (int d = 0; d < 3; d++)
		for (int i = 0; i < s->n[d]; i++)
			length[d] += s->width[d][i];
	return length[0] * length[1] * length[2];
}

void ts_stencil_centre(const struct ts_stencil *s, double *p)
{
	double mean;
	int first, end;

	ts_stencil_own(s, &first, &end);
#pragma omp parallel for num_threads(s->threads) schedule(static)
	for (int row = first; row < end; row++)
		s->rows[row] =
			row_area(s, row) * dot_of_row(p + ts_stencil_row(s, row), s->width[0], s->n[0]);
	mean = ts_stencil_sum_rows(s) / total_volume(s);
#pragma omp parallel for num_threads(s->threads) schedule(static)
	for (int row = first; row < end; row++)
		for (int i = 0; i < s->n[0]; i++)
			p[ts_stencil_row(s, row) + (size_t)i] -= mean;
}

void ts_stencil_balance(const struct ts_stencil *s, double *b)
{
	double excess;
	int first, end;

	ts_stencil_own(s, &first, &end);
#pragma omp parallel for num_threads(s->threads) schedule(static)
	for (int row = first; row < end; row++) {
		s->rows[row] = 0;
		for (int i = 0; i < s->n[0]; i++)
			s->rows[row] += b[ts_stencil_row(s, row) + (size_t)i];
	}
	excess = ts_stencil_sum_rows(s) / total_volume(s);
#pragma omp parallel for num_threads(s->threads) schedule(static)
	for (int row = first; row < end; row++)
		for (int i = 0; i < s->n[0]; i++)
			b[ts_stencil_row(s, row) + (size_t)i] -= excess * (row_area(s, row) * s->width[0][i]);
}
