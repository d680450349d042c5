/* Elastic energy in contacts and bonds; law/elastic_energy.h has the equations. */
#ifndef TS_CONTACT_CONTACT_ENERGY_H
#define TS_CONTACT_CONTACT_ENERGY_H

#include "contact/contact_view.h"

struct ts_contact_energy_parts {
	bool pair, bond;
};

/* Slots of pair and bond styles. */
enum ts_status ts_contact_energy_of_pairs(struct ts_instance *self, struct tsim *sim, double *out);
enum ts_status ts_contact_energy_of_bonds(struct ts_instance *self, struct tsim *sim, double *out);

/* Refuses models whose forces have no potential, and contacts that are not known now. */
enum ts_status ts_contact_energy_require(struct tsim *sim, const struct ts_instance *self,
					 const struct ts_contact_energy_parts *parts);
/* Half the energy of each contact and bond of particle i. */
double ts_contact_energy_of_particle(const struct tsim *sim, size_t i,
				     const struct ts_contact_energy_parts *parts);

#endif
