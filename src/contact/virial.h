/* The virial of contacts and bonds, for stress and pressure. */
#ifndef TS_CONTACT_VIRIAL_H
#define TS_CONTACT_VIRIAL_H

#include "core/sim.h"

/* Contributions that an output includes: kinetic energy, contacts, bonds. */
struct ts_virial_parts {
	bool kinetic, pair, bond;
};

/* Contribution of particle i, energy: w_ab = 1/2 sum d_a F_b over its contacts and bonds, d the vector from
 * the partner to i and F the force on i, for ab = xx, yy, zz, xy, xz, yz. */
void ts_virial_of_particle(const struct tsim *sim, size_t i, const struct ts_virial_parts *parts,
			   double w[6]);
/* The sum over all particles. */
void ts_virial_total(const struct tsim *sim, const struct ts_virial_parts *parts, double out[6]);
/* With ranks: while the particles are divided, before all ranks look at them, `kept` gets the sum over the particles of all ranks,
 * if the forces of this step are kept; *step becomes that of the sum. All ranks call it. */
enum ts_status ts_virial_join(struct tsim *sim, const struct ts_instance *self,
			      const struct ts_virial_parts *parts, double kept[6], int64_t *step);
/* ts_virial_total, or in such a look what was kept. */
enum ts_status ts_virial_now(struct tsim *sim, const struct ts_instance *self,
			     const struct ts_virial_parts *parts, const double kept[6], int64_t step,
			     double out[6]);
/* The volume of the box, by which pressures divide; in two dimensions its area. */
double ts_virial_box_volume(const struct tsim *sim);
/* The mean of the diagonal of a tensor, over the dimensions. */
double ts_virial_mean_pressure(const struct tsim *sim, const double tensor[6]);
/* Reads the words ke, pair, bond, fix, virial ... of a compute; no words: all contributions. */
enum ts_status ts_virial_read_parts(struct tsim *sim, const struct ts_instance *self, struct ts_words words,
				    struct ts_virial_parts *parts);

#endif
