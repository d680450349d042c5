/* The void fraction in the equations of the fluid: ghosts, face values, rate of change. */
#ifndef TS_FLOW_VOID_FRACTION_H
#define TS_FLOW_VOID_FRACTION_H

#include "flow/projection.h"

/* Before a run: without a fix void_fraction the fluid is everywhere, also if there was one before. */
void ts_projection_find_void_fraction(struct ts_projection *projection, const struct tsim *sim);
/* Sets ghosts, face values and rate of the void fraction; `elapsed`: time since the last step of the
 * fluid. */
enum ts_status ts_projection_update_void_fraction(struct ts_projection *projection, double elapsed);
/* Whether e u is stepped forward in place of u. */
static inline bool ts_projection_conservative(const struct ts_projection *projection)
{
	return projection->form == TS_FORM_CONSERVATIVE && projection->fluid.void_fraction;
}
/* form conservative: sets the void fractions in the products e u of stage s of the predictor. */
void ts_projection_stage_void_fraction(struct ts_projection *projection, struct ts_predictor *stage, int s);
/* Integral of de/dt over the grid (volume/time), on all ranks. */
enum ts_status ts_projection_void_rate_integral(const struct ts_projection *projection, double *integral);

#endif
