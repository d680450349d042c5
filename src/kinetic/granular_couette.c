#include "kinetic/granular_couette.h"

#include <math.h>
#include <string.h>

#include "base/alloc.h"
#include "kinetic/internal.h"
#include "math/band.h"
#include "math/constants.h"

#include "base/banned.h"

static enum ts_status make_room(struct ts_couette *c, int n)
{
	size_t nodes = (size_t)n + 1;

	TS_TRY(TS_GROW(c->parts, c->parts_capacity, nodes));
	TS_TRY(TS_GROW(c->node, c->capacity, nodes));
	TS_TRY(TS_GROW(c->rate, c->rate_capacity, nodes));
	TS_TRY(TS_GROW(c->step, c->step_capacity, 4 * nodes));
	return TS_GROW(c->matrix, c->matrix_capacity, ts_band_length(4 * nodes, 5, 5));
}

enum ts_status ts_couette_room(struct ts_couette *c, int n)
{
	TS_TRY(make_room(c, n));
	for (int i = 0; i < n; i++)
		c->parts[i] = n;
	c->n = c->equal = n;
	return TS_OK;
}

void ts_couette_release(struct ts_couette *c)
{
	ts_free(c->node);
	ts_free(c->rate);
	ts_free(c->step);
	ts_free(c->matrix);
	ts_free(c->parts);
	c->node = NULL;
	c->rate = NULL;
	c->step = c->matrix = c->parts = NULL;
	c->capacity = c->rate_capacity = c->step_capacity = c->matrix_capacity = c->parts_capacity = 0;
	c->n = c->equal = 0;
}

/* ---- starting values */

void ts_couette_guess(struct ts_couette *c)
{
	double x = ts_couette_x(c, c->solids), loss = 0, slip = 0, s;
	struct ts_couette_at at;

	ts_couette_at(c, x, &at);
	for (int w = 0; w < 2; w++) {
		loss += ts_bumpy_wall_loss(&c->wall[w]);
		slip += ts_bumpy_wall_slip(&c->wall[w]);
	}
	/* work of both walls s (slips + s a H) = dissipation */
	s = sqrt((loss * at.root_t + at.loss * c->gap) / (slip * at.root_t + at.shear * c->gap));
	for (int i = 0; i <= c->n; i++) {
		double *z = c->node[i], y = c->gap * i / c->n;

		z[0] = x;
		z[1] = (s * s * ts_bumpy_wall_slip(&c->wall[0]) - ts_bumpy_wall_loss(&c->wall[0])) *
			       at.root_t * (1 - y / c->gap) -
		       (s * s * ts_bumpy_wall_slip(&c->wall[1]) - ts_bumpy_wall_loss(&c->wall[1])) *
			       at.root_t * y / c->gap;
		z[2] = at.nu * y;
		z[3] = s;
	}
}

/* Follows the solution from the gap `from`, where it is uniform, to the given one. */
static enum ts_status widen(struct ts_couette *c, double from)
{
	double gap = c->gap, ratio = 2;
	size_t bytes = ((size_t)c->n + 1) * sizeof *c->node;
	double(*kept)[4] = ts_alloc(1, bytes);
	enum ts_status status = TS_OK;

	if (!kept)
		return TS_NOMEM;
	c->gap = fmin(gap, from);
	c->reached = 0;
	ts_couette_guess(c);
	while (c->reached < gap && status == TS_OK) {
		memcpy(kept, c->node, bytes);
		status = ts_couette_newton(c);
		if (status == TS_OK) {
			c->reached = c->gap;
		} else if (c->reached > 0 && ratio > 1.02) {
			memcpy(c->node, kept, bytes);
			ratio = sqrt(ratio);
			status = TS_OK;
		}
		c->gap = fmin(gap, c->reached > 0 ? c->reached * ratio : gap);
	}
	c->gap = gap;
	ts_free(kept);
	return status;
}

enum ts_status ts_couette_solve_mesh(struct ts_couette *c, int intervals, bool warm)
{
	static const double narrow[] = { 2, 0.5 };
	enum ts_status status = TS_PHYSICS;
	double most = 0;

	TS_TRY(ts_couette_room(c, intervals));
	if (warm)
		return ts_couette_newton(c);
	for (int k = 0; k < 2 && status == TS_PHYSICS; k++) {
		status = widen(c, narrow[k]);
		most = fmax(most, c->reached);
	}
	c->reached = most;
	return status;
}

/* ---- meshes */

enum { MOST_INTERVALS = 1 << 16 };

/* Halves the intervals that are chosen, by Hermite's cubics. */
static enum ts_status halve(struct ts_couette *c, const bool *chosen)
{
	int n = c->n, to = n;

	for (int i = 0; i < n; i++)
		to += chosen[i];
	TS_TRY(make_room(c, to));
	c->n = to;
	for (int i = 0; i <= n; i++)
		ts_couette_rate(c, c->node[i], &c->rate[i]);
	for (int i = n; i > 0; i--) {
		double high[4], parts = c->parts[i - 1];

		memcpy(high, c->node[i], sizeof high);
		memcpy(c->node[to], high, sizeof high);
		c->parts[to - 1] = parts;
		to--;
		if (!chosen[i - 1])
			continue;
		ts_couette_middle(c->gap / parts, c->node[i - 1], c->rate[i - 1].f, high, c->rate[i].f,
				  c->node[to]);
		c->parts[to] = c->parts[to - 1] = 2 * parts;
		to--;
	}
	return TS_OK;
}

/* Chooses the intervals in which x passes the kink, and those beside it: it is displaced when the finer mesh is solved. */
static bool choose_kink(const struct ts_couette *c, bool *chosen)
{
	enum { BESIDE = 3 };
	const double kink = ts_couette_kink(c), most = c->equal * 0x1p20; /* sums of widths are exact */
	bool any = false;

	for (int i = 0; i < c->n; i++)
		chosen[i] = false;
	for (int i = 0; i < c->n; i++) {
		if ((c->node[i][0] > kink) == (c->node[i + 1][0] > kink))
			continue;
		any = true;
		for (int k = i - BESIDE; k <= i + BESIDE; k++)
			if (k >= 0 && k < c->n)
				chosen[k] = c->parts[k] < most;
	}
	return any;
}

/* Twice as many intervals, and around a kink shorter ones, whose errors, of first order, then decrease as those of fourth order. */
static enum ts_status refine(struct ts_couette *c, bool *kink)
{
	enum { TIMES = 4 };
	bool *chosen = ts_alloc((size_t)c->n << TIMES, sizeof *chosen);
	enum ts_status status = chosen ? TS_OK : TS_NOMEM;

	for (int i = 0; i < c->n && chosen; i++)
		chosen[i] = true;
	if (status == TS_OK)
		status = halve(c, chosen);
	c->equal *= 2;
	*kink = false;
	for (int k = 0; k < TIMES && status == TS_OK && choose_kink(c, chosen); k++) {
		*kink = true;
		status = halve(c, chosen);
	}
	ts_free(chosen);
	return status;
}

static double change(double a, double b)
{
	return fabs(a - b) / fmax(fabs(a), 1e-300);
}

/* Relative error of the finer of two solutions: of fourth order, but with a kink the place of its interval matters, too. */
static double error_of(const struct ts_couette_figures *fine, const struct ts_couette_figures *coarse,
		       bool kink)
{
	double most = fmax(change(fine->speed, coarse->speed), change(fine->traction, coarse->traction));

	for (int k = 0; k < 2; k++) {
		most = fmax(most, change(fine->slip[k], coarse->slip[k]));
		most = fmax(most, change(fine->centre[k], coarse->centre[k]));
	}
	return kink ? most : most / 15;
}

int ts_couette_intervals(double gap, int points)
{
	int n = points - 1;

	while (n < 32 || (n < 2.5 * gap && n < MOST_INTERVALS))
		n *= 2;
	return n;
}

enum ts_status ts_couette_solve(struct ts_couette *c, int intervals, double tolerance)
{
	struct ts_couette_figures fine, coarse;
	bool kink;

	c->iterations = 0;
	TS_TRY(ts_couette_solve_mesh(c, intervals, false));
	ts_couette_figures(c, &fine);
	do {
		coarse = fine;
		TS_TRY(refine(c, &kink));
		TS_TRY(ts_couette_newton(c));
		ts_couette_figures(c, &fine);
		c->error = error_of(&fine, &coarse, kink);
	} while (c->error > tolerance && c->n < MOST_INTERVALS);
	return c->error <= tolerance ? TS_OK : TS_RANGE;
}

/* ---- results */

void ts_couette_profile(const struct ts_couette *c, int points, double (*out)[3])
{
	int stride = c->equal / (points - 1);
	double s = c->node[0][3], u, place = c->equal; /* in equal intervals */
	struct ts_couette_rate low, high;
	struct ts_couette_at at;

	ts_couette_at(c, c->node[c->n][0], &at);
	u = s * ts_bumpy_wall_slip(&c->wall[1]) * at.root_t;
	ts_couette_rate(c, c->node[c->n], &low);
	for (int i = c->n; i >= 0; i--) {
		struct ts_couette_at middle;
		double z[4], before = at.shear;

		ts_couette_at(c, c->node[i][0], &at);
		if (i < c->n) {
			const double width = ts_couette_width(c, i);

			place -= c->equal / c->parts[i];
			high = low;
			ts_couette_rate(c, c->node[i], &low);
			ts_couette_middle(width, c->node[i], low.f, c->node[i + 1], high.f, z);
			ts_couette_at(c, z[0], &middle);
			u += width / 6 * s * (at.shear + 4 * middle.shear + before);
		}
		if (fmod(place, stride) == 0) {
			double *row = out[(int)place / stride];

			row[0] = at.nu;
			row[1] = u;
			row[2] = at.root_t * at.root_t;
		}
	}
}

/* Integrals of the shear rate and of the dissipation over the gap, by the rule of the equations. */
static void integrate(const struct ts_couette *c, double out[2])
{
	double s = c->node[0][3], below = 0;
	struct ts_couette_rate low, high;
	struct ts_couette_at at, middle;

	out[0] = out[1] = 0;
	ts_couette_rate(c, c->node[0], &high);
	for (int i = 0; i <= c->n; i++) {
		const double width = i < c->n ? ts_couette_width(c, i) : 0;
		double end = below / 6 + width / 6, z[4];

		ts_couette_at(c, c->node[i][0], &at);
		out[0] += end * s * at.shear;
		out[1] += end * at.loss;
		if (i == c->n)
			break;
		low = high;
		ts_couette_rate(c, c->node[i + 1], &high);
		ts_couette_middle(width, c->node[i], low.f, c->node[i + 1], high.f, z);
		ts_couette_at(c, z[0], &middle);
		out[0] += width * 2 / 3 * s * middle.shear;
		out[1] += width * 2 / 3 * middle.loss;
		below = width;
	}
}

static double centre_x(const struct ts_couette *c)
{
	struct ts_couette_rate low, high;
	double place = 0, z[4]; /* in equal intervals */
	int i = 0;

	while (place + c->equal / c->parts[i] <= c->equal / 2.0)
		place += c->equal / c->parts[i++];
	if (place == c->equal / 2.0)
		return c->node[i][0];
	ts_couette_rate(c, c->node[i], &low);
	ts_couette_rate(c, c->node[i + 1], &high);
	ts_couette_middle(ts_couette_width(c, i), c->node[i], low.f, c->node[i + 1], high.f, z);
	return z[0];
}

void ts_couette_figures(const struct ts_couette *c, struct ts_couette_figures *out)
{
	double sum[2], s = c->node[0][3], work, most = -INFINITY, least = INFINITY;
	struct ts_couette_at at;

	integrate(c, sum);
	for (int i = 0; i <= c->n; i++) {
		most = fmax(most, c->node[i][0]);
		least = fmin(least, c->node[i][0]);
	}
	ts_couette_at(c, least, &at);
	out->coldest = 1 / (at.root_t * at.root_t);
	ts_couette_at(c, most, &at);
	out->coldest *= at.root_t * at.root_t;
	out->most = at.nu;
	out->traction = s;
	out->speed = sum[0];
	out->dissipation = sum[1];
	for (int w = 0; w < 2; w++) {
		ts_couette_at(c, c->node[w ? c->n : 0][0], &at);
		out->slip[w] = s * ts_bumpy_wall_slip(&c->wall[w]) * at.root_t;
		out->wall_loss[w] = ts_bumpy_wall_loss(&c->wall[w]) * at.root_t;
		out->speed += out->slip[w];
	}
	ts_couette_at(c, centre_x(c), &at);
	out->centre[0] = at.nu;
	out->centre[1] = at.root_t * at.root_t;
	work = s * out->speed;
	out->imbalance = fabs(work - out->dissipation - out->wall_loss[0] - out->wall_loss[1]) / work;
}

/* ---- number of solutions */

/* Whether two solutions on one mesh are the same. */
static bool same(int n, double (*a)[4], double (*b)[4])
{
	for (int i = 0; i <= n; i++)
		if (!(fabs(a[i][0] - b[i][0]) < 1e-5))
			return false;
	return true;
}

/* The profile of the guess, changed in the shape of a cosine with `waves` half waves. */
static void bend(struct ts_couette *c, int waves, double height)
{
	ts_couette_guess(c);
	for (int i = 0; i <= c->n; i++)
		c->node[i][0] += height * cos(TS_PI * waves * i / c->n);
}

enum ts_status ts_couette_count(const struct ts_couette *given, int intervals, int *count)
{
	enum { SHAPES = 4, HEIGHTS = 4, TRIALS = SHAPES * HEIGHTS };
	struct ts_couette c = { .gas = given->gas,
				.wall = { given->wall[0], given->wall[1] },
				.gap = given->gap,
				.solids = given->solids };
	size_t nodes = (size_t)intervals + 1;
	double(*found)[4] = ts_alloc(nodes * (TRIALS + 1), sizeof *found);
	enum ts_status status = found ? ts_couette_room(&c, intervals) : TS_NOMEM;

	*count = 0;
	for (int k = 0; k <= TRIALS && status == TS_OK; k++) {
		static const double heights[HEIGHTS] = { -2, -0.7, 0.7, 2 };
		bool known = false;

		if (k < TRIALS)
			bend(&c, 1 + k / HEIGHTS, heights[k % HEIGHTS]);
		status = k < TRIALS ? ts_couette_newton(&c) : ts_couette_solve_mesh(&c, intervals, false);
		for (int l = 0; l < *count && status == TS_OK; l++)
			known |= same(intervals, c.node, found + (size_t)l * nodes);
		if (status == TS_OK && !known)
			memcpy(found + (size_t)(*count)++ * nodes, c.node, nodes * sizeof *found);
		status = status == TS_PHYSICS ? TS_OK : status;
	}
	ts_couette_release(&c);
	ts_free(found);
	return status;
}
