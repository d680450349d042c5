/* Potential energy: of the pair and the bond style, and of the fixes that `fix_modify energy yes` counts
 * in. A style gives its own by the slot `energy`. */
#ifndef TS_ENERGY_POTENTIAL_ENERGY_H
#define TS_ENERGY_POTENTIAL_ENERGY_H

#include "core/sim.h"

struct ts_energy_parts {
	bool pair, bond, fix;
};

/* Their sum. An error where a style has none. */
enum ts_status ts_potential_energy(struct tsim *sim, const struct ts_energy_parts *parts, double *out);
/* The slot of fixes whose scalar output it is. */
enum ts_status ts_energy_output(struct ts_instance *self, struct tsim *sim, double *out);
/* Words pair, bond, fix ..., as those of compute pe; none: all. */
enum ts_status ts_energy_read(struct tsim *sim, const struct ts_instance *self, struct ts_words words,
			      struct ts_energy_parts *parts);

#endif
