/* The pressure of a film: without cavitation, cut off, and with the condition of Reynolds. */
#include <math.h>
#include <string.h>

#include "base/alloc.h"
#include "film/internal.h"

#include "base/banned.h"

enum { MOST_CHANGES = 200, MOST_REFINEMENTS = 4 };
static const double ROUND_OFF = 1e-13;

static double largest_free_residual(const struct ts_film *f)
{
	double most = 0;

	for (size_t c = 0; c < ts_film_cells(f); c++)
		if (f->free[c])
			most = fmax(most, fabs(f->residual[c]));
	return most;
}

/* p += correction that makes the balance of the free cells zero; the others keep theirs. */
static void correct(struct ts_film *f)
{
	for (size_t c = 0; c < ts_film_cells(f); c++)
		f->step[c] = f->free[c] ? -f->residual[c] : 0;
	ts_grid_lu_solve(&f->lu, f->step, f->step);
	for (size_t c = 0; c < ts_film_cells(f); c++)
		if (f->free[c])
			f->p[c] += f->step[c];
	ts_film_set_flow(f);
}

/* Solves for the pressure of the free cells; refines the solution until the balance is at round-off. */
static enum ts_status solve_free(struct ts_film *f, struct ts_error *error)
{
	double last;
	int bad;

	ts_film_set_rows(f, false);
	bad = ts_grid_lu_factorize(&f->lu, f->row);
	if (bad >= 0)
		return ts_fail(error, TS_PHYSICS, NULL,
			       "film: the equations of the pressure are singular at (%g, %g); the gap varies "
			       "too much",
			       ts_film_centre(f, 0, bad % f->n[0]), ts_film_centre(f, 1, bad / f->n[0]));
	f->report.solves++;
	ts_film_set_flow(f);
	correct(f);
	last = largest_free_residual(f);
	for (int k = 0; k < MOST_REFINEMENTS && last > 0; k++) {
		double now;

		correct(f);
		now = largest_free_residual(f);
		if (!(now < last / 2))
			break;
		last = now;
	}
	return TS_OK;
}

static double largest_pressure(const struct ts_film *f)
{
	double most = 0;

	for (size_t c = 0; c < ts_film_cells(f); c++)
		if (f->kind[c] == TS_FILM_FLUID)
			most = fmax(most, fabs(f->p[c] - f->cavity_pressure));
	return most;
}

/* Takes cells with p < pc out of the free ones, and returns those to them where the flow would raise p. */
static size_t change_free(struct ts_film *f)
{
	double low = f->cavity_pressure - ROUND_OFF * largest_pressure(f), inflow;
	size_t changes = 0;

	ts_film_set_report(f);
	inflow = -ROUND_OFF * f->report.throughput;
	for (size_t c = 0; c < ts_film_cells(f); c++) {
		if (f->kind[c] != TS_FILM_FLUID)
			continue;
		if (f->free[c] ? f->p[c] < low : f->residual[c] < inflow) {
			f->free[c] = !f->free[c];
			f->p[c] = f->cavity_pressure;
			changes++;
		}
	}
	return changes;
}

static enum ts_status solve_reynolds(struct ts_film *f, struct ts_error *error)
{
	for (int k = 0; k < MOST_CHANGES; k++) {
		TS_TRY(solve_free(f, error));
		if (!change_free(f))
			return TS_OK;
	}
	return ts_fail(error, TS_PHYSICS, NULL,
		       "film: the extent of the cavity has not converged in %d iterations", MOST_CHANGES);
}

/* Half-Sommerfeld: the flow is computed from the changed pressure and does not balance near the cavity. */
static void clamp(struct ts_film *f)
{
	for (size_t c = 0; c < ts_film_cells(f); c++)
		if (f->kind[c] == TS_FILM_FLUID && f->p[c] < f->cavity_pressure) {
			f->p[c] = f->cavity_pressure;
			f->free[c] = false;
			f->report.cavitated++;
		}
	ts_film_set_flow(f);
}

/* Volume that the replaced pressures create: the largest balance of one sign. */
static void report_clamped(struct ts_film *f)
{
	double made = 0;

	for (size_t c = 0; c < ts_film_cells(f); c++)
		if (f->kind[c] == TS_FILM_FLUID)
			made += fmax(f->residual[c], 0);
	f->report.imbalance = made;
}

static enum ts_status order_unknowns(struct ts_film *f, struct ts_error *error)
{
	const bool periodic[2] = { f->edge[0][0] == TS_FILM_PERIODIC, f->edge[1][0] == TS_FILM_PERIODIC };

	ts_grid_lu_release(&f->lu);
	if (ts_grid_lu_make(&f->lu, f->n, periodic, f->free) != TS_OK)
		return ts_nomem(error);
	return TS_OK;
}

static void start(struct ts_film *f)
{
	for (size_t c = 0; c < ts_film_cells(f); c++) {
		f->free[c] = f->kind[c] == TS_FILM_FLUID;
		f->p[c] = f->kind[c] == TS_FILM_GIVEN ? f->pressure_given[c] : f->cavity_pressure;
		f->empty[c] = 0;
	}
	f->report = (struct ts_film_report){ .solves = 0 };
}

/* Begins with the solution on a coarser grid, if it has one: parts of the coarse film may be closed. */
static enum ts_status guess(struct ts_film *f, bool *found)
{
	struct ts_error ignored = { .status = TS_OK };
	struct ts_film coarse;
	enum ts_status status;

	*found = false;
	if (!ts_film_can_coarsen(f))
		return TS_OK;
	status = ts_film_coarsen(f, &coarse);
	if (status == TS_OK)
		status = ts_film_solve(&coarse, &ignored);
	if (status == TS_OK) {
		ts_film_take_guess(f, &coarse);
		*found = true;
	}
	f->report.solves += coarse.report.solves;
	ts_film_release(&coarse);
	return status == TS_NOMEM ? TS_NOMEM : TS_OK;
}

/* Film and cavity at once. The coarsest grid begins with a film without cavity. */
static enum ts_status solve_cavitated(struct ts_film *f, struct ts_error *error)
{
	bool found;

	if (guess(f, &found) != TS_OK)
		return ts_nomem(error);
	if (f->cavitation == TS_FILM_REYNOLDS || !found)
		TS_TRY(solve_reynolds(f, error));
	return f->cavitation == TS_FILM_JFO ? ts_film_solve_jfo(f, error) : TS_OK;
}

static enum ts_status check_balance(const struct ts_film *f, struct ts_error *error)
{
	const double relative = 1e-7, round_offs = 1e4;

	if (f->report.balance <= relative * f->report.throughput + round_offs * ts_film_round_off(f))
		return TS_OK;
	return ts_fail(error, TS_PHYSICS, NULL,
		       "film: the flows out of a cell add up to %g of the mean flow through a face, expected "
		       "0: the gap varies too much for the solver",
		       f->report.balance / f->report.throughput);
}

static enum ts_status solve_checked(struct ts_film *f, struct ts_error *error)
{
	start(f);
	TS_TRY(order_unknowns(f, error));
	ts_film_set_faces(f);
	f->report.driven = ts_film_is_driven(f);
	if (f->cavitation == TS_FILM_NONE || f->cavitation == TS_FILM_HALF)
		TS_TRY(solve_free(f, error));
	else
		TS_TRY(solve_cavitated(f, error));
	ts_film_set_report(f);
	TS_TRY(check_balance(f, error));
	if (f->cavitation == TS_FILM_HALF) {
		clamp(f);
		report_clamped(f);
	}
	return TS_OK;
}

static enum ts_status solve_pinned(struct ts_film *f, struct ts_error *error)
{
	TS_TRY(ts_film_check(f, error));
	return f->piezo.law == TS_FILM_CONSTANT ? solve_checked(f, error)
						: ts_film_solve_reduced(f, solve_checked, error);
}

enum ts_status ts_film_solve(struct ts_film *f, struct ts_error *error)
{
	enum ts_status status;

	TS_TRY(ts_film_pin_parts(f, error));
	status = solve_pinned(f, error);
	ts_film_unpin_parts(f);
	return status == TS_OK ? ts_film_check_pinned(f, error) : status;
}

void ts_film_keep_content(struct ts_film *f)
{
	for (size_t c = 0; c < ts_film_cells(f); c++)
		f->content[c] = f->gap[c] * (1 - f->empty[c]);
}
