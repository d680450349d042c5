/* Newton's method for the shear flow between rough walls on one mesh. */
#include <math.h>

#include "base/alloc.h"
#include "kinetic/internal.h"
#include "math/band.h"

#include "base/banned.h"

enum { BAND = 5, ITERATIONS = 25 };

/* Adds to the matrix the derivatives of Simpson's rule with the unknowns of one end of an interval: sign (1 of the
 * upper, -1 of the lower end) - width/6 (J + 4 Jm (1/2 - sign width/8 J)). */
static void add_end(double *a, size_t row, size_t column, double width, double sign,
		    const struct ts_couette_rate *end, const struct ts_couette_rate *middle)
{
	for (size_t k = 0; k < 4; k++)
		for (size_t l = 0; l < 4; l++) {
			double through = middle->j[k][l] / 2;

			for (size_t m = 0; m < 4; m++)
				through -= sign * width / 8 * middle->j[k][m] * end->j[m][l];
			*ts_band_at(a, BAND, BAND, row + k, column + l) =
				sign * (k == l) - width / 6 * (end->j[k][l] + 4 * through);
		}
}

static void add_interval(struct ts_couette *c, int i, double width)
{
	const struct ts_couette_rate *low = &c->rate[i], *high = &c->rate[i + 1];
	const double *z0 = c->node[i], *z1 = c->node[i + 1];
	size_t row = 4 * (size_t)i + 2;
	struct ts_couette_rate middle;
	double z[4];

	ts_couette_middle(width, z0, low->f, z1, high->f, z);
	ts_couette_rate(c, z, &middle);
	add_end(c->matrix, row, row - 2, width, -1, low, &middle);
	add_end(c->matrix, row, row + 2, width, 1, high, &middle);
	for (size_t k = 0; k < 4; k++)
		c->step[row + k] = z1[k] - z0[k] - width / 6 * (low->f[k] + 4 * middle.f[k] + high->f[k]);
}

static void add_wall(struct ts_couette *c, int wall)
{
	size_t node = wall ? (size_t)c->n : 0, row = wall ? 4 * node + 2 : 0;
	double j[2][4];

	ts_couette_wall(c, wall, c->node[node], &c->step[row], j);
	for (size_t k = 0; k < 2; k++)
		for (size_t l = 0; l < 4; l++)
			*ts_band_at(c->matrix, BAND, BAND, row + k, 4 * node + l) = j[k][l];
}

/* The step of Newton's method into c->step, with the sign of the residual. */
static bool find_step(struct ts_couette *c)
{
	size_t rows = 4 * (size_t)(c->n + 1);

	for (size_t k = 0; k < ts_band_length(rows, BAND, BAND); k++)
		c->matrix[k] = 0;
	for (int i = 0; i <= c->n; i++)
		ts_couette_rate(c, c->node[i], &c->rate[i]);
	add_wall(c, 0);
	add_wall(c, 1);
	for (int i = 0; i < c->n; i++)
		add_interval(c, i, ts_couette_width(c, i));
	return ts_band_solve(rows, BAND, BAND, c->matrix, c->step);
}

/* Largest change of x and of ln s that the step makes. */
static double step_size(const struct ts_couette *c)
{
	double most = 0;

	for (int i = 0; i <= c->n; i++) {
		most = fmax(most, fabs(c->step[4 * i]));
		most = fmax(most, fabs(c->step[4 * i + 3] / c->node[i][3]));
	}
	return most;
}

enum ts_status ts_couette_newton(struct ts_couette *c)
{
	static const double longest = 0.7, small = 1e-9;

	for (int k = 0, last = 0; k < ITERATIONS; k++) {
		double size, part;

		c->iterations++;
		if (!find_step(c))
			return TS_PHYSICS;
		size = step_size(c);
		if (!isfinite(size))
			return TS_PHYSICS;
		part = size > longest ? longest / size : 1;
		for (int i = 0; i <= c->n; i++)
			for (int m = 0; m < 4; m++)
				c->node[i][m] -= part * c->step[4 * i + m];
		if (last++ && size < small)
			return TS_OK;
		last = size < small; /* one more, so that balances hold to round-off */
	}
	return TS_PHYSICS;
}
