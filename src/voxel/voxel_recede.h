/* Recession of height fields (geom/recession.h): a column is lowered by the volume worn from it over its area.
 *
 * With the original height h_0, the present height h and the area A of a column the volume taken so far is A (h_0 - h);
 * each update finds the new height from h_0, so that rounding errors do not add up and the volumes taken sum to
 * A (h_0 - h) to round-off. The material ends at the depth `thickness` below h_0, or at the base of the field if that
 * is higher. */
#ifndef TS_VOXEL_VOXEL_RECEDE_H
#define TS_VOXEL_VOXEL_RECEDE_H

#include "geom/recession.h"
#include "voxel/voxel_surface.h"

/* In init: keeps the original heights, unless it has them. Fails at `where` if the material has no end, or if columns
 * that are to be removed end above the base. */
enum ts_status ts_voxel_recede_check(struct tsim *sim, struct ts_voxel_surface *s,
				     const struct ts_recession *how, const struct ts_place *where);
/* Lowers n columns, each of them once. */
void ts_voxel_recede(struct ts_voxel_surface *s, const struct ts_recession *how,
		     struct ts_recession_element *e, size_t n);

#endif
