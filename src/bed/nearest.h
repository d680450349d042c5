/* The k nearest neighbours of each point, across periodic faces, too; each neighbour once, at its nearest image. */
#ifndef TS_BED_NEAREST_H
#define TS_BED_NEAREST_H

#include <stddef.h>
#include <stdint.h>

#include "base/status.h"
#include "geom/box.h"

/* Finds the k nearest of the other points, 1 <= k < n: row[k * i + m], m = 0 .. k-1 in ascending order of distance,
 * of equally distant ones the one with the smaller tag first. `reach`: about the distance of neighbours, > 0; it
 * affects the time only. */
enum ts_status ts_nearest_find(const struct ts_box *box, int dimensions, const double (*x)[3],
			       const int32_t *tag, size_t n, size_t k, double reach, int32_t *row);

#endif
