/* Bonds that transmit moments (law/bond_element.h): what all such bond styles share. */
#ifndef TS_BOND_BOND_MOMENT_H
#define TS_BOND_BOND_MOMENT_H

#include "bond/bonds.h"
#include "law/bond_element.h"

/* The loop over the rows of shares: slot `compute` of the style. */
long ts_bond_compute_moments(void *task, size_t from, size_t to);
/* Turns the particles: hook of the style in POST_INTEGRATE. */
enum ts_status ts_bond_turn(struct ts_instance *self, struct tsim *sim);

/* Computes the constants of the rows if they have been rebuilt, with dashpots if any bond is damped; fails if a
 * bond is so long that its periodic image cannot be told. */
enum ts_status ts_bond_moments_fill(struct tsim *sim, bool damped, bool softens);
/* Deletes the bonds whose flag is set; the rows stay, with empty lanes, so that constants are not computed again. */
enum ts_status ts_bond_moments_remove(struct tsim *sim, const unsigned char *broken);
/* Adds the columns. */
enum ts_status ts_bond_moments_require(struct tsim *sim);
/* Refuses bonds of members of rigid bodies. */
enum ts_status ts_bond_moments_allow(struct ts_instance *self, struct tsim *sim);

/* Constants and present state of bond b, without damping. */
struct ts_bond_pair ts_bond_pair_of(const struct tsim *sim, size_t b);
void ts_bond_ends_of(const struct tsim *sim, size_t b, struct ts_bond_ends *out); /* without velocities */
void ts_bond_constants(const struct tsim *sim, size_t b, struct ts_bond_element *out);
void ts_bond_state_of(const struct tsim *sim, size_t b, struct ts_bond_element *element,
		      struct ts_bond_answer *out);
/* Shear stress by strength; infinite if friction (law/bond_softening.h) leaves no strength under a pull. */
double ts_bond_shear_ratio(const struct ts_bond_element *element, const struct ts_bond_answer *state);
/* What fails first: the largest ratio of stress and strength. */
enum ts_bond_failure ts_bond_failure_of(const struct ts_bond_element *element,
					const struct ts_bond_answer *state);
/* Largest stable time step of the bond alone, time. */
double ts_bond_moment_limit(const struct tsim *sim, size_t b);

/* Bonds of any style. Elastic energy by mode (enum TS_BOND_NORMAL ...), that of a central spring is normal. */
void ts_bond_energy(const struct tsim *sim, size_t b, double energy[TS_BOND_MODES]);
/* Their sum. */
double ts_bond_elastic_energy(const struct tsim *sim, size_t b);
/* Force on the first particle and torques of the springs of bond b, without dashpots, in the present state. */
void ts_bond_spring_load(const struct tsim *sim, size_t b, struct ts_bond_load *out);

#endif
