/* All pairs of points nearer than a cutoff, periodic images included, whatever the cutoff: beyond half
 * the box a point meets several images of another, and of itself. For outputs; contacts have their own
 * list (neigh/contact_list.h). */
#ifndef TS_GEOM_PAIRS_H
#define TS_GEOM_PAIRS_H

#include <stddef.h>

#include "base/status.h"
#include "geom/box.h"

/* d points from the image of j to i. Each pair comes twice, as (i, j, d) and (j, i, -d). */
typedef void ts_pair_fn(void *context, size_t i, size_t j, const double d[3]);

/* Visits the pairs with |d| < cutoff in an order that depends on the order of the points. */
enum ts_status ts_pairs_visit(const struct ts_box *box, const double (*x)[3], size_t n, double cutoff,
			      ts_pair_fn *visit, void *context);

#endif
