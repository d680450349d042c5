/* Change of the pressure with small changes of gap and rate: Newton's matrix of the solution times the change is the change of
 * the balances at the same pressure. Cells stay in the film or in the cavity. */
#include "film/internal.h"

#include "base/banned.h"

enum ts_status ts_film_begin_response(struct ts_film *f, struct ts_error *error)
{
	int bad;

	for (size_t c = 0; c < ts_film_cells(f); c++)
		f->value[c] = f->residual[c];
	if (f->cavitation != TS_FILM_JFO)
		return TS_OK; /* lu is that of the solution */
	ts_film_set_rows(f, true);
	bad = ts_grid_lu_factorize(&f->lu, f->row);
	if (bad < 0)
		return TS_OK;
	return ts_fail(error, TS_PHYSICS, NULL, "film: its response is not determined at (%g, %g)",
		       ts_film_centre(f, 0, bad % f->n[0]), ts_film_centre(f, 1, bad / f->n[0]));
}

const double *ts_film_respond(struct ts_film *f)
{
	bool all = f->cavitation == TS_FILM_JFO;

	ts_film_set_faces(f);
	ts_film_set_flow(f);
	for (size_t c = 0; c < ts_film_cells(f); c++)
		f->step[c] = f->free[c] || all ? f->value[c] - f->residual[c] : 0;
	ts_grid_lu_solve(&f->lu, f->step, f->step);
	for (size_t c = 0; c < ts_film_cells(f); c++)
		if (!f->free[c])
			f->step[c] = 0;
	return f->step;
}

void ts_film_end_response(struct ts_film *f)
{
	ts_film_set_faces(f);
	ts_film_set_flow(f);
}
