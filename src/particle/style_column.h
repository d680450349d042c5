/* Columns that a style shares with the script: the user may have defined them by fix property/atom. */
#ifndef TS_PARTICLE_STYLE_COLUMN_H
#define TS_PARTICLE_STYLE_COLUMN_H

#include "particle/particles.h"

/* Adds or finds the column; width <= 3. Values of an existing column are kept. New particles start with the
 * values of the fix property/atom of this name if there is one, else with `initial`. */
enum ts_status ts_particles_style_column(struct tsim *sim, const char *name, size_t width, unsigned flags,
					 double initial, size_t *column);

#endif
