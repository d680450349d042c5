/* Columns that a style keeps for scripts: they may have been made by the user. */
#ifndef TS_PARTICLE_STYLE_COLUMN_H
#define TS_PARTICLE_STYLE_COLUMN_H

#include "particle/particles.h"

/* Values that are there stay: of the style's own earlier life. A fix property/atom of this name
 * says what particles start with, `initial` otherwise; the width is at most three. */
enum ts_status ts_particles_style_column(struct tsim *sim, const char *name, size_t width, unsigned flags,
					 double initial, size_t *column);

#endif
