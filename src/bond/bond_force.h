/* Slots of struct ts_style that all bond styles share, and the coefficients of bond types. */
#ifndef TS_BOND_BOND_FORCE_H
#define TS_BOND_BOND_FORCE_H

#include "core/sim.h"

/* Parses the coefficients of the given bond types; types above the present number are added. */
enum ts_status ts_bond_set_coeffs(struct tsim *sim, struct ts_types types, struct ts_words words,
				  const struct ts_place *where);

/* Whether there is a bond style, and bond_coeff has given the coefficients of this type. */
bool ts_bond_has_coeffs(const struct tsim *sim, int64_t type);

enum ts_status ts_bond_init(struct ts_instance *self, struct tsim *sim);
enum ts_status ts_bond_force(struct ts_instance *self, struct tsim *sim);
enum ts_status ts_bond_archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a);
void ts_bond_fingerprint(const struct ts_instance *self, const struct tsim *sim, struct ts_hash *hash);
enum ts_status ts_bond_plan(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report);
void ts_bond_fini(struct ts_instance *self);

/* Fails if the bonds that exist cannot act in this scene. */
enum ts_status ts_bonds_allow(struct tsim *sim);
/* Breaks the bonds whose flag `breaks` is set: records and removes them. */
enum ts_status ts_bonds_break(struct tsim *sim);

/* Largest stable time step of bond b alone, time; infinite if both partners are immobile. */
double ts_bond_limit(const struct tsim *sim, size_t b, bool explicit_euler);
/* 1/omega of the stretching of bond b alone without damping, omega^2 = k_n/m, m the reduced mass; time */
double ts_bond_stretch_time(const struct tsim *sim, size_t b);

#endif
