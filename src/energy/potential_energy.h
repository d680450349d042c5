/* Potential energy of the pair style, the bond style, and the fixes that `fix_modify energy yes`
 * includes. A style provides its own by the slot `energy`. */
#ifndef TS_ENERGY_POTENTIAL_ENERGY_H
#define TS_ENERGY_POTENTIAL_ENERGY_H

#include "core/sim.h"

struct ts_energy_parts {
	bool pair, bond, fix;
};

/* Sum of the energies of the given parts; an error if a style has no potential energy. */
enum ts_status ts_potential_energy(struct tsim *sim, const struct ts_energy_parts *parts, double *out);
/* Slot `energy` of fixes whose scalar output is their energy. */
enum ts_status ts_energy_output(struct ts_instance *self, struct tsim *sim, double *out);
/* Parses the words pair, bond, fix ... of compute pe; none: all. */
enum ts_status ts_energy_parse_parts(struct tsim *sim, const struct ts_instance *self, struct ts_words words,
				     struct ts_energy_parts *parts);

#endif
