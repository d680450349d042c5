/* Per-particle quantities by the names that scripts use (x, vy, fz, radius, mass, id, type, diameter,
 * density ...), and the columns of styles that scripts read by name. */
#ifndef TS_PARTICLE_QUANTITY_H
#define TS_PARTICLE_QUANTITY_H

#include "particle/particles.h"

/* One value for each local particle. The name is known: ts_particles_has_quantity. */
enum ts_status ts_particles_quantity(struct tsim *sim, const char *name, struct ts_table *out);
/* The value of a particle, one after the other, without a table of all; NULL: the name is that of a column. */
typedef double ts_quantity_fn(const struct tsim *sim, size_t i);
ts_quantity_fn *ts_particles_quantity_fn(const struct tsim *sim, const char *name);
/* The name is a built-in quantity or a named column. */
bool ts_particles_has_quantity(const struct tsim *sim, const char *name);
/* The name is a named column, and not a built-in quantity. */
bool ts_particles_keeps_quantity(const struct tsim *sim, const char *name);
/* Offers the built-in names as corrections of an unknown name. */
void ts_particles_suggest_quantity(struct ts_suggest *suggest);
/* Name, unit and description of built-in quantity k, or its name alone; NULL: k is beyond the last. */
const struct ts_quantity *ts_particles_quantity_text(size_t k);
const char *ts_particles_quantity_name(size_t k);

/* The column with TS_COL_NAMED that the script calls NAME or NAME[k]; *component is counted from 0. NULL if
 * there is none. */
const struct ts_column *ts_particles_named_column(const struct ts_particles *p, const char *name,
						  size_t *component);

#endif
