/* Cavitation that conserves volume, after H. G. Elrod (1981), by Newton's method.
 *
 * A cell has one unknown s: p = pc + P s, theta = 0 where s >= 0, and p = pc, theta = -s where s < 0, P a scale of
 * pressures. So p >= pc, theta >= 0 and (p - pc) theta = 0 hold by construction, and the balances are continuous,
 * piecewise linear functions of s. Each column of each of their Jacobians is that of diffusion (s >= 0) or of upwind
 * transport (s < 0): positive diagonal, other elements not positive, sum not negative. Such matrices have a positive
 * inverse, the solution is unique, and the elimination needs no pivoting. Newton's method usually needs 5 to 25 steps.
 * On gaps that jump from cell to cell it may cycle; therefore each STEPS_AT_ONCE full steps are followed by as many
 * halved ones. */
#include <math.h>

#include "film/internal.h"

#include "base/banned.h"

static const double ROUND_OFF = 1e-12;
enum { MOST_STEPS = 300, STEPS_AT_ONCE = 25 };

static void set_cell(struct ts_film *f, size_t c, double s, double scale)
{
	f->value[c] = s;
	f->free[c] = s >= 0;
	f->p[c] = f->cavity_pressure + scale * fmax(s, 0);
	f->empty[c] = fmax(-s, 0);
}

/* Derivatives by s instead of p in the free columns. */
static void scale_columns(struct ts_film *f, double scale)
{
	for (size_t c = 0; c < ts_film_cells(f); c++) {
		if (f->free[c])
			f->row[c].centre *= scale;
		for (int side = 0; side < TS_GRID_NEIGHBOURS; side++) {
			int other = ts_grid_lu_neighbour(&f->lu, (int)c, side);

			if (other >= 0 && f->free[other])
				f->row[c].side[side] *= scale;
		}
	}
}

static enum ts_status factorize(struct ts_film *f, double scale, struct ts_error *error)
{
	int bad;

	ts_film_set_rows(f, true);
	scale_columns(f, scale);
	bad = ts_grid_lu_factorize(&f->lu, f->row);
	if (bad >= 0)
		return ts_fail(error, TS_STATE, NULL,
			       "film: the void fraction at (%g, %g) is not determined: fluid neither enters "
			       "nor leaves the cavity there; give a pressure above that of the cavity at an "
			       "edge, or a time step",
			       ts_film_centre(f, 0, bad % f->n[0]), ts_film_centre(f, 1, bad / f->n[0]));
	f->report.solves++;
	return TS_OK;
}

static void solve_step(struct ts_film *f)
{
	for (size_t c = 0; c < ts_film_cells(f); c++)
		f->step[c] = -f->residual[c];
	ts_grid_lu_solve(&f->lu, f->step, f->step);
}

/* Cells that change between p and theta in a step. Without any the full step is exact, because the equations are linear
 * between such changes. Where both are zero to round-off a cell may change without end, and it does not matter. */
struct changes {
	size_t all, of_size;
};

/* Makes this fraction of the step. */
static struct changes make_step(struct ts_film *f, double fraction, double scale)
{
	struct changes changes = { 0 };

	for (size_t c = 0; c < ts_film_cells(f); c++)
		if (f->kind[c] == TS_FILM_FLUID) {
			bool was = f->free[c];

			set_cell(f, c, f->value[c] + fraction * f->step[c], scale);
			changes.all += was != f->free[c];
			changes.of_size += was != f->free[c] && fabs(f->value[c]) > ROUND_OFF;
		}
	ts_film_set_flow(f);
	return changes;
}

static void add_scales(struct ts_film *f, int axis, int i, int j, const struct ts_film_sides *s)
{
	size_t at = ts_film_face(f, axis, i, j);

	(void)s;
	f->scale[0] += fabs(f->transport[axis][at]);
	f->scale[1] += f->conductance[axis][at];
}

/* The largest pressure above pc, or if there is none yet, the one whose flow between neighbours is like that of the
 * moving surfaces. */
static double pressure_scale(struct ts_film *f)
{
	double most = 0;

	f->scale[0] = f->scale[1] = 0;
	ts_film_each_face(f, add_scales);
	for (size_t c = 0; c < ts_film_cells(f); c++) {
		f->scale[0] += fabs(f->source[c]);
		if (f->kind[c] == TS_FILM_FLUID)
			most = fmax(most, f->p[c] - f->cavity_pressure);
	}
	if (f->scale[0] > 0 && f->scale[1] > 0)
		most = fmax(most, f->scale[0] / f->scale[1]);
	return most > 0 ? most : 1;
}

enum ts_status ts_film_solve_jfo(struct ts_film *f, struct ts_error *error)
{
	double scale = pressure_scale(f);

	for (size_t c = 0; c < ts_film_cells(f); c++)
		if (f->kind[c] == TS_FILM_FLUID)
			set_cell(f, c,
				 f->free[c] ? fmax(f->p[c] - f->cavity_pressure, 0) / scale
					    : -fmax(f->empty[c], 1e-3),
				 scale);
	ts_film_set_flow(f);
	for (int k = 0; k < MOST_STEPS; k++) {
		bool damped = k / STEPS_AT_ONCE % 2 == 1;
		struct changes changes;

		TS_TRY(factorize(f, scale, error));
		solve_step(f);
		changes = make_step(f, damped ? 0.5 : 1, scale);
		if (changes.of_size > 0 || damped)
			continue;
		if (changes.all == 0) { /* refinement by the same factors */
			solve_step(f);
			make_step(f, 1, scale);
		}
		return TS_OK;
	}
	return ts_fail(error, TS_PHYSICS, NULL,
		       "film: cavitation jfo has not converged in %d steps of Newton's method", MOST_STEPS);
}
