#include "grid/grid.h"

#include <math.h>
#include <string.h>

#include "base/alloc.h"
#include "grid/grid_halves.h"

#include "base/banned.h"

enum { FACES, CENTRES, WIDTHS, GAPS, NARRAYS };

/* Width of a ghost cell: that of its periodic image, or of the cell it mirrors. */
static double ghost_width(const double *width, int n, bool periodic, int i)
{
	if (periodic)
		return width[((i % n) + n) % n];
	i = i < 0 ? -i - 1 : 2 * n - 1 - i;
	return width[i < 0 ? 0 : i >= n ? n - 1 : i];
}

static bool is_uniform(const double *face, int n)
{
	double mean = (face[n] - face[0]) / n;

	for (int i = 0; i < n; i++)
		if (!(fabs(face[i + 1] - face[i] - mean) <= 1e-12 * mean + 4e-16 * fabs(face[i])))
			return false;
	return true;
}

static void make_axis(struct ts_grid *grid, int d, const double *face, double *memory)
{
	int n = grid->n[d], g = grid->ghosts[d], length = n + 2 * g + 1;
	double *f = grid->face[d] = memory + FACES * length + g;
	double *c = grid->centre[d] = memory + CENTRES * length + g;
	double *w = grid->width[d] = memory + WIDTHS * length + g;
	double *gap = grid->gap[d] = memory + GAPS * length + g;

	grid->uniform[d] = is_uniform(face, n);
	for (int i = 0; i < n; i++)
		w[i] = grid->uniform[d] ? (face[n] - face[0]) / n : face[i + 1] - face[i];
	for (int i = 1; i <= g; i++) {
		w[-i] = ghost_width(w, n, grid->periodic[d], -i);
		w[n - 1 + i] = ghost_width(w, n, grid->periodic[d], n - 1 + i);
	}
	memcpy(f, face, ((size_t)n + 1) * sizeof *f);
	for (int i = 1; i <= g; i++) {
		f[-i] = f[1 - i] - w[-i];
		f[n + i] = f[n + i - 1] + w[n + i - 1];
	}
	for (int i = -g; i < n + g; i++)
		c[i] = 0.5 * (f[i] + f[i + 1]);
	for (int i = -g + 1; i < n + g; i++)
		gap[i] = grid->uniform[d] ? w[0] : c[i] - c[i - 1];
	gap[-g] = w[-g];
	c[n + g] = f[n + g];
	w[n + g] = gap[n + g] = w[n + g - 1];
}

enum ts_status ts_grid_make(struct ts_grid *grid, int dimensions, const int n[3], const double *const face[3],
			    const bool periodic[3])
{
	size_t lengths[3], total = 0;

	*grid = (struct ts_grid){ .dimensions = dimensions };
	for (int d = 0; d < 3; d++) {
		grid->n[d] = n[d];
		grid->periodic[d] = periodic[d];
		grid->ghosts[d] = d < dimensions ? TS_GRID_GHOSTS : 0;
		lengths[d] = (size_t)(n[d] + 2 * grid->ghosts[d] + 1);
		total += NARRAYS * lengths[d];
	}
	grid->stride[0] = 1;
	/* One layer more than cells, for the faces beyond the upper boundary. Rows of a multiple of 8
	 * doubles begin on lines of the cache. */
	grid->stride[1] = (n[0] + 2 * grid->ghosts[0] + 1 + 7) / 8 * 8;
	grid->stride[2] = grid->stride[1] * (n[1] + 2 * grid->ghosts[1] + 1);
	grid->size = (size_t)(grid->stride[2] * (n[2] + 2 * grid->ghosts[2] + (dimensions == 3)));
	grid->origin = (size_t)(grid->ghosts[0] + grid->ghosts[1] * grid->stride[1] +
				grid->ghosts[2] * grid->stride[2]);
	grid->memory = ts_alloc(total, sizeof *grid->memory);
	if (!grid->memory)
		return TS_NOMEM;
	for (int d = 0, at = 0; d < 3; at += NARRAYS * (int)lengths[d++])
		make_axis(grid, d, face[d], grid->memory + at);
	return ts_grid_halves_make(grid);
}

void ts_grid_release(struct ts_grid *grid)
{
	ts_free(grid->memory);
	ts_free(grid->halves);
	*grid = (struct ts_grid){ 0 };
}

double ts_grid_least_width(const struct ts_grid *grid)
{
	double least = INFINITY;

	for (int d = 0; d < grid->dimensions; d++)
		for (int i = 0; i < grid->n[d]; i++)
			least = fmin(least, grid->width[d][i]);
	return least;
}

int ts_grid_bisect(const struct ts_grid *grid, int d, double x)
{
	const double *face = grid->face[d];
	int low = 0, high = grid->n[d];

	while (high - low > 1) {
		int middle = (low + high) / 2;

		*(x >= face[middle] ? &low : &high) = middle;
	}
	return low;
}

double *ts_grid_field(const struct ts_grid *grid)
{
	return ts_alloc_pages(grid->size, sizeof(double), grid->sparse);
}

void ts_grid_field_free(double *field)
{
	ts_free_pages(field);
}

void ts_grid_field_clear(double *field, size_t first, size_t end)
{
	if (end > first)
		ts_alloc_clear(field + first, (end - first) * sizeof *field);
}
