/* The simulation box: axis-aligned, with boundary styles of faces and periodic wrapping. */
#ifndef TS_GEOM_BOX_H
#define TS_GEOM_BOX_H

#include <math.h>
#include <stdbool.h>
#include <stdint.h>

/* Behaviour of a face, by the letter of the `boundary` command. */
enum ts_face {
	TS_FACE_PERIODIC, /* p */
	TS_FACE_FIXED,	  /* f: particles that cross it are deleted */
	TS_FACE_SHRINK,	  /* s: shrink-wrapped, follows the particles */
	TS_FACE_MINIMUM	  /* m: shrink-wrapped, never inside the initial box */
};

struct ts_box {
	double lo[3], hi[3];
	enum ts_face face[3][2]; /* [dimension][0 low, 1 high] */
};

static inline bool ts_box_periodic(const struct ts_box *box, int dim)
{
	return box->face[dim][0] == TS_FACE_PERIODIC;
}

static inline double ts_box_length(const struct ts_box *box, int dim)
{
	return box->hi[dim] - box->lo[dim];
}

/* Limit of the image count: differences of two counts must fit an int32_t. */
enum { TS_TURNS_MOST = 1 << 29 };

/* Wraps a coordinate into a periodic box and updates its image count. Returns false, and changes
 * nothing, if the count would exceed its limit or x is not finite. */
static inline bool ts_box_wrap(const struct ts_box *box, int dim, double *x, int32_t *image)
{
	double length = ts_box_length(box, dim), turns = floor((*x - box->lo[dim]) / length);

	if (turns == 0)
		return true;
	if (!(fabs(turns + *image) <= TS_TURNS_MOST))
		return false;
	*x -= turns * length;
	if (*x < box->lo[dim]) /* rounding */
		*x = box->lo[dim];
	*image = (int32_t)(*image + turns);
	return true;
}

/* The k-th (0..26) periodic image of x; k = 13 is x itself. False if there is no such image within the
 * distance `reach` of the box. */
static inline bool ts_box_image(const struct ts_box *box, const double x[3], int k, double reach,
				double image[3])
{
	const int shift[3] = { k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1 };

	for (int d = 0; d < 3; d++) {
		image[d] = x[d] + shift[d] * ts_box_length(box, d);
		if (shift[d] && (!ts_box_periodic(box, d) || image[d] <= box->lo[d] - reach ||
				 image[d] >= box->hi[d] + reach))
			return false;
	}
	return true;
}

/* Minimum image convention for the difference of two positions. */
static inline void ts_box_nearest(const struct ts_box *box, double d[3])
{
	for (int k = 0; k < 3; k++)
		if (ts_box_periodic(box, k))
			d[k] -= ts_box_length(box, k) * rint(d[k] / ts_box_length(box, k));
}

#endif
