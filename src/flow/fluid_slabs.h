/* The planes of a fluid that a rank computes in a step that ranks divide (fluid->slabs is active); else, or without ranks, all. */
#ifndef TS_FLOW_FLUID_SLABS_H
#define TS_FLOW_FLUID_SLABS_H

#include "flow/fluid.h"

/* Planes of a field with the ghosts of each plane; those across the last axis belong to the first and the last rank. */
struct ts_slabs_field ts_fluid_slabs_field(const struct ts_grid *grid, double *field);
/* The planes that this rank has (fluid->planes): number of ranges, 1 if it has all, the values first .. end - 1 of one of them, and
 * whether a plane is in one. */
int ts_fluid_ranges(const struct ts_fluid *fluid);
void ts_fluid_range_values(const struct ts_fluid *fluid, int range, size_t *first, size_t *end);
bool ts_fluid_has_plane(const struct ts_fluid *fluid, int k);
/* In these planes: a field becomes a copy of another one, or is divided by a number. */
void ts_fluid_copy_field(const struct ts_fluid *fluid, double *to, const double *from);
void ts_fluid_divide_field(const struct ts_fluid *fluid, double *field, double by);
/* Planes of cells, first .. end - 1, that this rank computes. */
void ts_fluid_slabs_planes(const struct ts_fluid *fluid, int *first, int *end);
/* Rows of cells along the first axis, first .. end - 1, of this rank: row = j + k n[1]. */
void ts_fluid_slabs_rows(const struct ts_fluid *fluid, long *first, long *end);
/* The values first .. end - 1 of a field, ghosts included, that are those of this rank. */
void ts_fluid_slabs_values(const struct ts_fluid *fluid, size_t *first, size_t *end);
/* All ranks get all planes of a field. */
void ts_fluid_slabs_share(const struct ts_fluid *fluid, double *field);
/* The same; if it has the fluid in some planes only, each gets those that it has beside its own ones. */
void ts_fluid_slabs_share_halo(const struct ts_fluid *fluid, double *field);
/* Each rank gets so many planes below and above its own ones. */
void ts_fluid_slabs_share_beside(const struct ts_fluid *fluid, double *field, int below, int above);
/* The largest of the values of all ranks. */
double ts_fluid_slabs_most(const struct ts_fluid *fluid, double value);

#endif
