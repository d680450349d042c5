#include "rough/rough_contact.h"

#include <math.h>

#include "math/constants.h"
#include "rough/asperity_theory.h"
#include "rough/contact_sweep.h"

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
	return isfinite(result->plane) && isfinite(result->mean_gap) ? TS_OK : TS_RANGE;
}

/* ---- half space: the pressures of least energy p S p/2 - p h within 0 <= p <= hardness, sum p = load ---- */

struct solver {
	const struct ts_rough_problem *problem;
	struct ts_half_space *half_space;
	struct ts_contact_sweep sweep;
	double deviation;    /* of the heights */
	double energy, best; /* now, and the least so far */
	/* Nonmonotone line search: the energy may rise up to `limit`, which is set to the largest energy of the
	 * last iterations, `largest`, if the best has not improved in PATIENCE of them. */
	double limit, largest;
	int waiting;
};

enum { PATIENCE = 10, REFRESH = 50 /* iterations after which the gradient is computed anew */ };

/* Where all contacts yield: the plane is where no cell violates the conditions, midway between the cells without
 * contact and those that yield. */
static double yielding_mean(const struct ts_contact_sweep *s)
{
	double open = INFINITY, yielding = -INFINITY;

	for (size_t k = 0; k < s->n; k++)
		if (s->p[k] > 0)
			yielding = fmax(yielding, s->gradient[k]);
		else
			open = fmin(open, s->gradient[k]);
	return isfinite(open) ? 0.5 * (open + yielding) : yielding;
}

static enum ts_status find_gradient(struct solver *s)
{
	struct ts_contact_sweep *w = &s->sweep;

	s->energy = 0;
	TS_TRY(ts_half_space_displace(s->half_space, w->p, w->gradient));
	for (size_t k = 0; k < w->n; k++) {
		s->energy += w->p[k] * (0.5 * w->gradient[k] - s->problem->height[k]);
		w->gradient[k] -= s->problem->height[k];
	}
	return TS_OK;
}

/* Sets the height of the plane, and the largest violation of the conditions of contact in units of the deviation of the
 * heights. */
static void find_gap(struct solver *s, struct ts_rough_result *result)
{
	double elastic[2], mean, most;

	ts_contact_sweep_contacts(&s->sweep, elastic);
	mean = elastic[1] > 0 ? elastic[0] / elastic[1] : yielding_mean(&s->sweep);
	most = ts_contact_sweep_gap(&s->sweep, mean);
	result->plane = -mean;
	result->residual = s->deviation > 0 ? most / s->deviation : most;
}

/* The shift for which pressures `move` + shift, brought within the limits, carry the load: their sum rises with it,
 * piecewise linear; Newton's method, or bisection where it leaves the bracket or takes many steps: pressures may be of any
 * size beside the load. */
static double find_shift(struct solver *s)
{
	enum { NEWTON_STEPS = 50 };
	const double load = s->problem->mean_pressure * (double)s->sweep.n;
	double low = -INFINITY, high = INFINITY, shift = 0;

	for (int k = 0;; k++) {
		const int late = k > NEWTON_STEPS ? k - NEWTON_STEPS : 0;
		double sum[2], before = shift; /* of the pressures; its slope */

		ts_contact_sweep_shift(&s->sweep, shift, sum);
		if (fabs(sum[0] - load) <= 1e-13 * load)
			return shift;
		*(sum[0] < load ? &low : &high) = shift;
		shift += ldexp((load - sum[0]) / fmax(sum[1], 1), late);
		if (!(shift > low && shift < high) || (late && isfinite(low) && isfinite(high)))
			shift = low + 0.5 * (high - low);
		if (!(shift < before || shift > before)) /* the bracket is as narrow as numbers permit */
			return shift;
	}
}

/* What a move d does to the energy: `slope` g d + `curvature` d S d/2. */
struct model {
	double slope, curvature;
	double square, response; /* d d, S d S d */
};

/* The move from p to the projection of p - rate gap. */
static enum ts_status find_move(struct solver *s, double rate, struct model *m)
{
	struct ts_contact_sweep *w = &s->sweep;
	double sum[2];

	ts_contact_sweep_descend(w, rate);
	ts_contact_sweep_limit(w, find_shift(s), sum);
	m->slope = sum[0];
	m->square = sum[1];
	TS_TRY(ts_half_space_displace(s->half_space, w->move, w->change));
	ts_contact_sweep_respond(w, sum);
	m->curvature = sum[0];
	m->response = sum[1];
	return TS_OK;
}

/* The whole move, or as far as the energy falls if it would rise above the limit. */
static void make_move(struct solver *s, const struct model *m)
{
	bool whole = s->energy + m->slope + m->curvature / 2 < s->limit;
	double part = whole || !(m->curvature > 0) ? 1 : fmin(1, -m->slope / m->curvature);

	s->energy += part * m->slope + part * part * m->curvature / 2;
	ts_contact_sweep_advance(&s->sweep, part);
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

	for (size_t k = 0; k < s->sweep.n; k++)
		most = fmax(most, fabs(s->sweep.gap[k]));
	return s->problem->mean_pressure / most;
}

static enum ts_status iterate(struct solver *s, struct ts_rough_result *result)
{
	double rate = 0;
	struct model m;

	for (int k = 0;; k++) {
		if (k % REFRESH == 0)
			TS_TRY(find_gradient(s));
		find_gap(s, result);
		result->iterations = k;
		if (!isfinite(result->plane) || !isfinite(result->residual))
			return TS_RANGE;
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

	TS_TRY(ts_half_space_make(s->half_space, &grid, p->threads));
	TS_TRY(ts_contact_sweep_make(&s->sweep));
	for (size_t k = 0; k < s->sweep.n; k++)
		result->pressure[k] = p->mean_pressure;
	return iterate(s, result);
}

/* Squares of numbers of this size, and their products, can be represented. */
static bool moderate(double x)
{
	return x > 1e-140 && x < 1e140;
}

enum ts_status ts_rough_half_space(const struct ts_rough_problem *problem, struct ts_rough_result *result)
{
	struct ts_half_space own = { 0 };
	struct solver s = { .problem = problem,
			    .half_space = problem->half_space ? problem->half_space : &own,
			    .sweep = { .n = cells(problem),
				       .threads = problem->threads,
				       .top = problem->hardness,
				       .p = result->pressure,
				       .gap = result->gap },
			    .deviation = sqrt(ts_rough_variance(cells(problem), problem->height)),
			    .best = INFINITY,
			    .limit = INFINITY,
			    .largest = -INFINITY };
	enum ts_status status;

	if (!(problem->mean_pressure < problem->hardness) || !moderate(problem->mean_pressure) ||
	    !moderate(problem->mean_pressure / problem->modulus * problem->width[0]))
		return TS_RANGE;
	status = solve(&s, result);
	if (status != TS_NOMEM)
		ts_rough_summarise(problem, result);
	ts_contact_sweep_release(&s.sweep);
	ts_half_space_release(&own);
	return status;
}
