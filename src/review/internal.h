/* The checks of the review; they are listed in review/table.c. */
#ifndef TS_REVIEW_INTERNAL_H
#define TS_REVIEW_INTERNAL_H

#include "core/sim.h"

/* Runs of at most one step serve as a set-up: insertion, a first output. */
enum { TS_REVIEW_SET_UP = 1 };

/* empty_groups.c */
enum ts_status ts_review_group(struct tsim *sim);
/* integration.c */
enum ts_status ts_review_integrator(struct tsim *sim);
enum ts_status ts_review_rotation(struct tsim *sim);
/* material_values.c */
enum ts_status ts_review_units(struct tsim *sim);
enum ts_status ts_review_diameter(struct tsim *sim);
enum ts_status ts_review_density(struct tsim *sim);
enum ts_status ts_review_modulus(struct tsim *sim);
/* placement.c */
enum ts_status ts_review_reach(struct tsim *sim);
enum ts_status ts_review_floor(struct tsim *sim);
enum ts_status ts_review_mesh_size(struct tsim *sim);
/* overlap.c */
enum ts_status ts_review_overlap(struct tsim *sim);
/* held_contacts.c */
enum ts_status ts_review_held_contacts(struct tsim *sim);
/* bond_rigidity.c */
enum ts_status ts_review_bonds(struct tsim *sim);
/* wall_overlap.c */
enum ts_status ts_review_wall_overlap(struct tsim *sim);

#endif
