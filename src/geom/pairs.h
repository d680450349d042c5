/* All pairs of points nearer than a cutoff, including periodic images, for any cutoff: beyond half the
 * box length a point has several images of another point, and of itself, as neighbours. For outputs;
 * contacts have their own list (neigh/contact_list.h). */
#ifndef TS_GEOM_PAIRS_H
#define TS_GEOM_PAIRS_H

#include <stddef.h>

#include "base/status.h"
#include "geom/box.h"

/* d: vector from the image of j to i. Each pair is visited twice, as (i, j, d) and (j, i, -d). */
typedef void ts_pair_fn(void *context, size_t i, size_t j, const double d[3]);

/* Visits the pairs with |d| < cutoff; the order depends on the order of the points. dimensions: with 2 points have no
 * images along z. */
enum ts_status ts_pairs_visit(const struct ts_box *box, int dimensions, const double (*x)[3], size_t n,
			      double cutoff, ts_pair_fn *visit, void *context);

#endif
