#include "rough/rough_contact.h"

#include <math.h>

#include "base/alloc.h"
#include "math/constants.h"
#include "rough/asperity_theory.h"

#include "base/banned.h"

static size_t cells(const struct ts_rough_problem *problem)
{
	return (size_t)problem->n[0] * (size_t)problem->n[1];
}

/* ---- figures of a solution ---- */

/* Number of borders between cells with and without contact. */
static size_t count_borders(const struct ts_rough_problem *problem, const double *pressure)
{
	size_t n0 = (size_t)problem->n[0], n1 = (size_t)problem->n[1], borders = 0;

	for (size_t j = 0; j < n1; j++)
		for (size_t i = 0; i < n0; i++) {
			bool here = pressure[j * n0 + i] > 0;

			if (i + 1 < n0 || problem->periodic)
				borders += here != (pressure[j * n0 + (i + 1) % n0] > 0);
			if (j + 1 < n1 || problem->periodic)
				borders += here != (pressure[(j + 1) % n1 * n0 + i] > 0);
		}
	return borders;
}

void ts_rough_summarise(const struct ts_rough_problem *problem, struct ts_rough_result *result)
{
	const double excess = (TS_PI - 1 + log(2)) / 24; /* of a cell at a border */
	size_t n = cells(problem), touching = 0, plastic = 0;
	double gap = 0, most = 0;

	for (size_t k = 0; k < n; k++) {
		touching += result->pressure[k] > 0;
		plastic += result->pressure[k] >= problem->hardness;
		gap += fmax(result->gap[k], 0);
		most = fmax(most, result->pressure[k]);
	}
	result->area = (double)touching / (double)n;
	result->smooth_area =
		result->area - excess * (double)count_borders(problem, result->pressure) / (double)n;
	result->plastic_area = (double)plastic / (double)n;
	result->mean_gap = gap / (double)n;
	result->max_pressure = most;
}

/* ---- winkler ---- */

static double spring_pressure(const struct ts_rough_problem *problem, double height, double plane)
{
	return fmin(fmax(problem->stiffness * (height - plane), 0), problem->hardness);
}

static double mean_spring_pressure(const struct ts_rough_problem *problem, double plane)
{
	size_t n = cells(problem);
	double sum = 0;

	for (size_t k = 0; k < n; k++)
		sum += spring_pressure(problem, problem->height[k], plane);
	return sum / (double)n;
}

/* The mean pressure falls as the plane rises: bisection, until the interval has no number between its ends. */
static double spring_plane(const struct ts_rough_problem *problem)
{
	double low = INFINITY, high = -INFINITY;

	for (size_t k = 0; k < cells(problem); k++) {
		low = fmin(low, problem->height[k]);
		high = fmax(high, problem->height[k]);
	}
	low -= problem->mean_pressure / problem->stiffness; /* there all springs carry at least the mean */
	for (;;) {
		double middle = low + 0.5 * (high - low);

		if (!(middle > low && middle < high))
			return low;
		if (mean_spring_pressure(problem, middle) >= problem->mean_pressure)
			low = middle;
		else
			high = middle;
	}
}

enum ts_status ts_rough_winkler(const struct ts_rough_problem *problem, struct ts_rough_result *result)
{
	if (!(problem->mean_pressure < problem->hardness))
		return TS_RANGE;
	result->plane = spring_plane(problem);
	for (size_t k = 0; k < cells(problem); k++) {
		double distance = result->plane - problem->height[k];

		result->pressure[k] = spring_pressure(problem, problem->height[k], result->plane);
		result->gap[k] = fmax(distance, 0);
	}
	result->iterations = 1;
	result->residual = 0;
	ts_rough_summarise(problem, result);
	return TS_OK;
}

/* ---- half space: the pressures of least energy p S p/2 - p h within 0 <= p <= hardness, sum p = load ---- */

struct solver {
	const struct ts_rough_problem *problem;
	struct ts_half_space *half_space;
	size_t n;
	double *p, *gap;	 /* of the result */
	double *gradient;	 /* S p - h: the gap but for a constant */
	double *move, *response; /* change of the pressures, and S times it */
	double deviation;	 /* of the heights */
	double energy, best;	 /* now, and the least so far */
	/* Nonmonotone line search: the energy may rise up to `limit`, which is set to the largest energy of the
	 * last iterations, `largest`, if the best has not improved in PATIENCE of them. */
	double limit, largest;
	int waiting;
};

enum { PATIENCE = 10, REFRESH = 50 /* iterations after which the gradient is computed anew */ };

static bool elastic(const struct solver *s, size_t k)
{
	return s->p[k] > 0 && s->p[k] < s->problem->hardness;
}

/* Mean over the cells in elastic contact. If all contacts yield: the plane is where no cell violates the conditions,
 * midway between the cells without contact and those that yield. */
static double contact_mean(const struct solver *s, const double *value)
{
	double sum = 0, open = INFINITY, yielding = -INFINITY;
	size_t n = 0;

	for (size_t k = 0; k < s->n; k++)
		if (elastic(s, k)) {
			sum += value[k];
			n++;
		} else if (s->p[k] > 0)
			yielding = fmax(yielding, value[k]);
		else
			open = fmin(open, value[k]);
	if (n)
		return sum / (double)n;
	return isfinite(open) ? 0.5 * (open + yielding) : yielding;
}

static enum ts_status find_gradient(struct solver *s)
{
	s->energy = 0;
	TS_TRY(ts_half_space_displace(s->half_space, s->p, s->gradient));
	for (size_t k = 0; k < s->n; k++) {
		s->energy += s->p[k] * (0.5 * s->gradient[k] - s->problem->height[k]);
		s->gradient[k] -= s->problem->height[k];
	}
	return TS_OK;
}

/* Returns the height of the plane. */
static double find_gap(struct solver *s)
{
	double mean = contact_mean(s, s->gradient);

	for (size_t k = 0; k < s->n; k++)
		s->gap[k] = s->gradient[k] - mean;
	return -mean;
}

/* The largest violation of the conditions of contact, in units of the deviation of the heights. */
static double residual(const struct solver *s)
{
	double most = 0;

	for (size_t k = 0; k < s->n; k++) {
		double gap = s->gap[k];

		if (elastic(s, k))
			most = fmax(most, fabs(gap));
		else
			most = fmax(most, s->p[k] > 0 ? gap : -gap);
	}
	return s->deviation > 0 ? most / s->deviation : most;
}

static double within(const struct solver *s, double p)
{
	return fmin(fmax(p, 0), s->problem->hardness);
}

/* The shift for which pressures p + shift, brought within the limits, carry the load: their sum rises with it,
 * piecewise linear; Newton's method, or bisection where it leaves the bracket. */
static double find_shift(const struct solver *s, const double *p)
{
	const double load = s->problem->mean_pressure * (double)s->n;
	double low = -INFINITY, high = INFINITY, shift = 0;

	for (;;) {
		double sum = 0, slope = 0, before = shift;

		for (size_t c = 0; c < s->n; c++) {
			double moved = p[c] + shift, kept = within(s, moved);

			sum += kept;
			slope += kept <= moved && kept >= moved;
		}
		if (fabs(sum - load) <= 1e-13 * load)
			return shift;
		*(sum < load ? &low : &high) = shift;
		shift += (load - sum) / fmax(slope, 1);
		if (!(shift > low && shift < high))
			shift = low + 0.5 * (high - low);
		if (!(shift < before || shift > before)) /* the bracket is as narrow as numbers permit */
			return shift;
	}
}

/* What a move does to the energy: `slope` g d + `curvature` d S d/2. */
struct model {
	double slope, curvature;
	double square, response; /* d d, S d S d */
};

/* The move from p to the projection of p - rate gap. */
static enum ts_status find_move(struct solver *s, double rate, struct model *m)
{
	double shift;

	*m = (struct model){ 0 };
	for (size_t k = 0; k < s->n; k++)
		s->move[k] = s->p[k] - rate * s->gap[k];
	shift = find_shift(s, s->move);
	for (size_t k = 0; k < s->n; k++) {
		s->move[k] = within(s, s->move[k] + shift) - s->p[k];
		m->slope += s->gap[k] * s->move[k];
		m->square += s->move[k] * s->move[k];
	}
	TS_TRY(ts_half_space_displace(s->half_space, s->move, s->response));
	for (size_t k = 0; k < s->n; k++) {
		m->curvature += s->move[k] * s->response[k];
		m->response += s->response[k] * s->response[k];
	}
	return TS_OK;
}

/* The whole move, or as far as the energy falls if it would rise above the limit. */
static void make_move(struct solver *s, const struct model *m)
{
	bool whole = s->energy + m->slope + m->curvature / 2 < s->limit;
	double part = whole || !(m->curvature > 0) ? 1 : fmin(1, -m->slope / m->curvature);

	s->energy += part * m->slope + part * part * m->curvature / 2;
	for (size_t k = 0; k < s->n; k++) {
		s->p[k] += part * s->move[k];
		s->gradient[k] += part * s->response[k];
	}
	if (s->energy < s->best) {
		s->best = s->largest = s->energy;
		s->waiting = 0;
		return;
	}
	s->largest = fmax(s->largest, s->energy);
	if (++s->waiting == PATIENCE) {
		s->limit = s->largest;
		s->largest = s->energy;
		s->waiting = 0;
	}
}

/* The rate of the next move, from the last one, where the response is proportional to the move: the two rates of
 * J. Barzilai, J. M. Borwein, IMA J. Numer. Anal. 8 (1988) 141, each for two iterations. 0: there is none. */
static double find_rate(const struct model *m, int iteration)
{
	if (!(m->curvature > 0))
		return 0;
	return iteration % 4 < 2 ? m->square / m->curvature : m->curvature / m->response;
}

/* A rate that changes pressures by the mean pressure. */
static double first_rate(const struct solver *s)
{
	double most = 0;

	for (size_t k = 0; k < s->n; k++)
		most = fmax(most, fabs(s->gap[k]));
	return s->problem->mean_pressure / most;
}

static enum ts_status iterate(struct solver *s, struct ts_rough_result *result)
{
	double rate = 0;
	struct model m;

	for (int k = 0;; k++) {
		if (k % REFRESH == 0)
			TS_TRY(find_gradient(s));
		result->plane = find_gap(s);
		result->residual = residual(s);
		result->iterations = k;
		if (result->residual <= s->problem->tolerance)
			return TS_OK;
		if (k == s->problem->iterations)
			return TS_PHYSICS;
		TS_TRY(find_move(s, rate > 0 ? rate : first_rate(s), &m));
		make_move(s, &m);
		rate = find_rate(&m, k);
	}
}

static enum ts_status solve(struct solver *s, struct ts_rough_result *result)
{
	const struct ts_rough_problem *p = s->problem;
	const struct ts_half_space_grid grid = {
		{ p->n[0], p->n[1] }, { p->width[0], p->width[1] }, p->modulus, p->periodic
	};
	enum ts_status status = ts_half_space_make(s->half_space, &grid, p->threads);

	s->gradient = ts_alloc(s->n, 3 * sizeof *s->gradient);
	s->move = s->gradient + s->n;
	s->response = s->move + s->n;
	if (status == TS_OK && !s->gradient)
		status = TS_NOMEM;
	for (size_t k = 0; k < s->n; k++)
		s->p[k] = p->mean_pressure;
	if (status == TS_OK)
		status = iterate(s, result);
	ts_free(s->gradient);
	return status;
}

enum ts_status ts_rough_half_space(const struct ts_rough_problem *problem, struct ts_rough_result *result)
{
	struct ts_half_space own = { 0 };
	struct solver s = { .problem = problem,
			    .half_space = problem->half_space ? problem->half_space : &own,
			    .n = cells(problem),
			    .p = result->pressure,
			    .gap = result->gap,
			    .deviation = sqrt(ts_rough_variance(cells(problem), problem->height)),
			    .best = INFINITY,
			    .limit = INFINITY,
			    .largest = -INFINITY };
	enum ts_status status;

	if (!(problem->mean_pressure < problem->hardness))
		return TS_RANGE;
	status = solve(&s, result);
	if (status != TS_NOMEM)
		ts_rough_summarise(problem, result);
	ts_half_space_release(&own);
	return status;
}
