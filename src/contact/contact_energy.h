/* Elastic energy of contacts and bonds; equations: law/elastic_energy.h. */
#ifndef TS_CONTACT_CONTACT_ENERGY_H
#define TS_CONTACT_CONTACT_ENERGY_H

#include "contact/contact_view.h"

struct ts_contact_energy_parts {
	bool pair, bond;
};

/* Total elastic energy: slot `energy` of pair and of bond styles. */
enum ts_status ts_contact_energy_of_pairs(struct ts_instance *self, struct tsim *sim, double *out);
enum ts_status ts_contact_energy_of_bonds(struct ts_instance *self, struct tsim *sim, double *out);

/* Fails for models whose forces have no potential, and if the contacts are not up to date. */
enum ts_status ts_contact_energy_require(struct tsim *sim, const struct ts_instance *self,
					 const struct ts_contact_energy_parts *parts);
/* Of contact r, not one of the other side of a periodic face. */
double ts_contact_energy_of_row(const struct tsim *sim, size_t r);
/* Half the sum of the energies of the contacts and bonds of particle i. */
double ts_contact_energy_of_particle(const struct tsim *sim, size_t i,
				     const struct ts_contact_energy_parts *parts);

#endif
