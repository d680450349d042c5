#include "coupling/volume_distribution.h"

#include <math.h>

#include "base/inline.h"
#include "geom/ball_corner.h"
#include "math/constants.h"

#include "base/banned.h"

static double half_width(const struct ts_coupling_volume *how, double radius)
{
	return how->method == TS_VOLUME_KERNEL	  ? 2 * how->reach * radius
	       : how->method == TS_VOLUME_DIVIDED ? radius
						  : 0;
}

int ts_coupling_volume_reach(const struct ts_grid *grid, const struct ts_coupling_volume *how, double radius)
{
	return (int)fmin(ceil(half_width(how, radius) / ts_grid_least_width(grid)), 1e6);
}

/* Cells along an axis that the particle reaches; face: coordinates of their faces relative to the centre
 * of the particle, in units of the reach, from the lower face of cell `first`. */
struct span {
	int first, n;
	double face[TS_VOLUME_MAX_CELLS + 2];
	int cell[TS_VOLUME_MAX_CELLS + 1]; /* in the grid: of those across a periodic face their images */
};

static void find_images(const struct ts_grid *grid, int d, struct span *s)
{
	const int n = grid->n[d];
	int cell = s->first;

	if (cell < 0 || cell >= n)
		cell = (cell % n + n) % n;
	for (int k = 0; k < s->n; k++) {
		s->cell[k] = cell;
		cell = cell + 1 < n ? cell + 1 : 0;
	}
}

/* Width of cell i, which may be a periodic image. */
static double cell_width(const struct ts_grid *grid, int d, int i)
{
	int n = grid->n[d];

	if (grid->uniform[d])
		return grid->width[d][0];
	return grid->width[d][grid->periodic[d] ? (i % n + n) % n : i < 0 ? 0 : i >= n ? n - 1 : i];
}

static void find_cell_range(const struct ts_grid *grid, int d, double x, int cell, double reach,
			    struct span *s)
{
	double low = grid->face[d][cell] - x;
	int first = cell;

	while (low > -reach && (grid->periodic[d] || first > 0) && cell - first < TS_VOLUME_MAX_CELLS / 2)
		low -= cell_width(grid, d, --first);
	s->first = first;
	s->n = 0;
	s->face[0] = low / reach;
	do {
		low += cell_width(grid, d, s->first + s->n++);
		s->face[s->n] = low / reach;
	} while (low < reach && s->n <= TS_VOLUME_MAX_CELLS &&
		 (grid->periodic[d] || s->first + s->n < grid->n[d]));
	/* Cells along a boundary receive the part beyond it. */
	if (s->face[0] > -1)
		s->face[0] = -1;
	if (s->face[s->n] < 1)
		s->face[s->n] = 1;
}

struct visitor {
	ts_coupling_volume_fn *visit;
	void *context;
};

static void add_to_cell(const struct span s[3], int i, int j, int k, double volume, const struct visitor *to)
{
	int index[3] = { s[0].cell[i], s[1].cell[j], s[2].cell[k] };

	to->visit(to->context, index, volume);
}

/* Volume of the unit ball (area of the unit disc) beyond each corner of one layer of faces. */
typedef double layer[TS_VOLUME_MAX_CELLS + 2][TS_VOLUME_MAX_CELLS + 2];

static void corner_volumes(const struct span s[3], bool disc, double z, layer out)
{
	for (int j = 0; j <= s[1].n; j++)
		for (int i = 0; i <= s[0].n; i++)
			out[j][i] = disc ? ts_ball_corner_disc(s[0].face[i], s[1].face[j])
					 : ts_ball_corner(s[0].face[i], s[1].face[j], z);
}

static double cell_difference(double (*a)[TS_VOLUME_MAX_CELLS + 2], int i, int j)
{
	return a[j][i] - a[j][i + 1] - a[j + 1][i] + a[j + 1][i + 1];
}

static void distribute_exactly(const struct span s[3], bool disc, double unit, const struct visitor *to)
{
	layer layers[2];

	corner_volumes(s, disc, s[2].face[0], layers[0]);
	for (int k = 0; k < s[2].n; k++) {
		double(*low)[TS_VOLUME_MAX_CELLS + 2] = layers[k % 2];
		double(*high)[TS_VOLUME_MAX_CELLS + 2] = layers[(k + 1) % 2];

		if (!disc)
			corner_volumes(s, disc, s[2].face[k + 1], high);
		for (int j = 0; j < s[1].n; j++)
			for (int i = 0; i < s[0].n; i++) {
				double part =
					cell_difference(low, i, j) - (disc ? 0 : cell_difference(high, i, j));

				add_to_cell(s, i, j, k, fmax(part, 0) * unit, to);
			}
	}
}

static double kernel_fraction(const struct span *s, int i)
{
	double a = fmax(s->face[i], -1), b = fmin(s->face[i + 1], 1);

	return b > a ? 0.5 * (b - a + (sin(TS_PI * b) - sin(TS_PI * a)) / TS_PI) : 0;
}

static void distribute_by_kernel(const struct span s[3], double volume, const struct visitor *to)
{
	for (int k = 0; k < s[2].n; k++)
		for (int j = 0; j < s[1].n; j++)
			for (int i = 0; i < s[0].n; i++)
				add_to_cell(s, i, j, k,
					    volume * kernel_fraction(&s[0], i) * kernel_fraction(&s[1], j) *
						    kernel_fraction(&s[2], k),
					    to);
}

/* Along an axis of one cell the whole particle is in it. */
static void span_one_cell(int d, struct span s[3])
{
	s[d].first = 0;
	s[d].n = 1;
	s[d].face[0] = -1;
	s[d].face[1] = 1;
}

/* ---- exact volumes of a particle that overlaps at most two cells along each axis, as those smaller than cells do */

/* One or two cells along an axis, and the face between them as in struct span. */
struct few {
	int cell[2];
	bool two;
	double cut;
};

/* The cells of find_cell_range and find_images, and the same bits; false: there are more than two. */
TS_INLINE bool find_few(const struct ts_grid *grid, int d, double x, int cell, double reach, struct few *few)
{
	const int n = grid->n[d];
	const bool periodic = grid->periodic[d];
	double low = grid->face[d][cell] - x, high;
	int first = cell;

	if (low > -reach && (periodic || first > 0)) {
		low -= cell_width(grid, d, --first);
		if (low > -reach && (periodic || first > 0))
			return false;
	}
	low += cell_width(grid, d, first);
	few->two = low < reach && (periodic || first + 1 < n);
	few->cell[0] = first < 0 ? first + n : first;
	few->cell[1] = few->cell[0] + 1 < n ? few->cell[0] + 1 : 0;
	few->cut = 0;
	if (!few->two)
		return true;
	few->cut = low / reach;
	high = low + cell_width(grid, d, first + 1);
	return !(high < reach && (periodic || first + 2 < n));
}

/* Part of the ball in cell i, j, k of two along each axis; corners without a plane are 0. */
TS_INLINE double part_of_corners(const double corner[8], int i, int j, int k)
{
	double beyond[2] = { 0 };

	for (int side = 0; side < 2 && k + side < 2; side++) {
		const double *at = corner + 4 * (k + side);
		double beside = i == 0 ? at[1 + 2 * j] : 0, above = j == 0 ? at[i + 2] : 0;

		beyond[side] = at[i + 2 * j] - beside - above + (i == 0 && j == 0 ? at[3] : 0);
	}
	return beyond[0] - beyond[1];
}

TS_INLINE void distribute_over_few(const struct few few[3], double unit, ts_coupling_volume_fn *visit,
				   void *context)
{
	const double cut[3] = { few[0].cut, few[1].cut, few[2].cut };
	const bool cuts[3] = { few[0].two, few[1].two, few[2].two };
	double corner[8] = { 0 };

	ts_ball_corners(cut, cuts, corner);
#pragma GCC unroll 8
	for (int m = 0; m < 8; m++) {
		const int i = m & 1, j = m >> 1 & 1, k = m >> 2;
		const int cell[3] = { few[0].cell[i], few[1].cell[j], few[2].cell[k] };

		if (i <= few[0].two && j <= few[1].two && k <= few[2].two)
			visit(context, cell, fmax(part_of_corners(corner, i, j, k), 0) * unit);
	}
}

/* False: it overlaps more cells, or is a disc. */
TS_INLINE bool divide_over_few(const struct ts_grid *grid, const struct ts_coupling_volume *how,
			       const double place[3], const int cell[3], double radius,
			       ts_coupling_volume_fn *visit, void *context)
{
	struct few few[3];

	if (how->method != TS_VOLUME_DIVIDED || how->disc)
		return false;
	for (int d = 0; d < 3; d++)
		if (grid->ghosts[d] == 0 || !find_few(grid, d, place[d], cell[d], radius, &few[d]))
			return false;
	distribute_over_few(few, radius * radius * radius, visit, context);
	return true;
}

/* Any particle. */
static void divide_over_many(const struct ts_grid *grid, const struct ts_coupling_volume *how,
			     const double place[3], const int cell[3], double radius,
			     ts_coupling_volume_fn *visit, void *context)
{
	double reach = half_width(how, radius);
	double unit = how->disc ? radius * radius * grid->width[2][cell[2]] : radius * radius * radius;
	double volume = (how->disc ? TS_PI : 4 * TS_PI / 3) * unit;
	const struct visitor to = { visit, context };
	struct span s[3];

	if (how->method == TS_VOLUME_CENTRE) {
		visit(context, cell, volume);
		return;
	}
	for (int d = 0; d < 3; d++) {
		if (grid->ghosts[d] == 0)
			span_one_cell(d, s);
		else
			find_cell_range(grid, d, place[d], cell[d], reach, &s[d]);
		find_images(grid, d, &s[d]);
	}
	if (how->method == TS_VOLUME_DIVIDED)
		distribute_exactly(s, how->disc, unit, &to);
	else
		distribute_by_kernel(s, volume, &to);
}

void ts_coupling_volume_each_cell(const struct ts_grid *grid, const struct ts_coupling_volume *how,
				  const double place[3], const int cell[3], double radius,
				  ts_coupling_volume_fn *visit, void *context)
{
	if (!divide_over_few(grid, how, place, cell, radius, visit, context))
		divide_over_many(grid, how, place, cell, radius, visit, context);
}

struct sum {
	const struct ts_grid *grid;
	double *fraction;
};

static void add_fraction(void *context, const int cell[3], double volume)
{
	const struct sum *sum = context;

	sum->fraction[ts_at(sum->grid, cell[0], cell[1], cell[2])] +=
		volume / ts_grid_volume(sum->grid, cell[0], cell[1], cell[2]);
}

void ts_coupling_volume_add(const struct ts_grid *grid, const struct ts_coupling_volume *how,
			    const double place[3], const int cell[3], double radius, double *fraction)
{
	struct sum sum = { grid, fraction };

	if (!divide_over_few(grid, how, place, cell, radius, add_fraction, &sum))
		divide_over_many(grid, how, place, cell, radius, add_fraction, &sum);
}
