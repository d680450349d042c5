/* The periodic images of a body that come near a place, however far from the box the body itself is: a mesh may be longer
 * than the box, or have moved through it. */
#ifndef TS_GEOM_BOX_IMAGES_H
#define TS_GEOM_BOX_IMAGES_H

#include "geom/box.h"

struct ts_box_images {
	int range[3][2]; /* first and last image along each axis, in box lengths */
	int shift[3];	 /* the present one */
};

/* Those of a body between lo and hi that come within r of the box between from and to. Along an axis that is not periodic
 * there is the body itself only, near or not. A sheared box is refused by all bodies that have images. */
struct ts_box_images ts_box_images(const struct ts_box *box, const double lo[3], const double hi[3],
				   const double from[3], const double to[3], double r);
/* Goes to the next one, in the beginning to the first; false: there are no more. */
bool ts_box_images_next(struct ts_box_images *images);
bool ts_box_images_have(const struct ts_box_images *images, const int shift[3]);

/* A way in a step, length, as far as images are looked for that may be met on it: what moves by more than three boxes is an error
 * in any case. */
static inline double ts_box_images_way(const struct ts_box *box, double way)
{
	return fmin(way, 3 * fmax(fmax(ts_box_length(box, 0), ts_box_length(box, 1)), ts_box_length(box, 2)));
}

/* The place x as the present image sees it, in the frame of the body itself. */
static inline void ts_box_images_place(const struct ts_box *box, const int shift[3], const double x[3],
				       double out[3])
{
	for (int d = 0; d < 3; d++)
		out[d] = x[d] - shift[d] * ts_box_length(box, d);
}

#endif
