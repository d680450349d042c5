/* Bodies in the fluid, as slices see them. */
#ifndef TS_IMAGE_IMAGE_BODY_H
#define TS_IMAGE_IMAGE_BODY_H

#include "core/sim.h"

/* Distances of places from all bodies in the fluid, < 0 inside; `reach` where there is none near. */
enum ts_status ts_image_body_distances(struct tsim *sim, size_t n, const double (*place)[3], double reach,
				       double *distance);

#endif
