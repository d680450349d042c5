/* The checks of a scene, by subject; the table is in review/table.c. */
#ifndef TS_REVIEW_CHECKS_H
#define TS_REVIEW_CHECKS_H

#include "core/sim.h"

/* motion.c */
enum ts_status ts_review_integrator(struct tsim *sim);
enum ts_status ts_review_rotation(struct tsim *sim);
/* numbers.c */
enum ts_status ts_review_units(struct tsim *sim);
enum ts_status ts_review_diameter(struct tsim *sim);
enum ts_status ts_review_density(struct tsim *sim);
enum ts_status ts_review_modulus(struct tsim *sim);
/* places.c */
enum ts_status ts_review_reach(struct tsim *sim);
enum ts_status ts_review_floor(struct tsim *sim);
enum ts_status ts_review_mesh_size(struct tsim *sim);
/* overlap.c */
enum ts_status ts_review_overlap(struct tsim *sim);
/* bonds.c */
enum ts_status ts_review_bonds(struct tsim *sim);
/* walls.c */
enum ts_status ts_review_wall_overlap(struct tsim *sim);

extern const struct ts_review_check ts_review_table[]; /* closed by .name NULL */

#endif
