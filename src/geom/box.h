/* The simulation box: an axis-aligned cuboid, faces, periodic wrapping. */
#ifndef TS_GEOM_BOX_H
#define TS_GEOM_BOX_H

#include <math.h>
#include <stdbool.h>
#include <stdint.h>

/* Behaviour of a face, by the letter of the `boundary` command. */
enum ts_face {
	TS_FACE_PERIODIC, /* p */
	TS_FACE_FIXED,	  /* f: particles that leave are deleted */
	TS_FACE_SHRINK,	  /* s: follows the particles */
	TS_FACE_MINIMUM	  /* m: follows them, never inside the first box */
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

/* The most lengths of the box that a particle is followed over: differences still fit an int32_t. */
enum { TS_TURNS_MOST = 1 << 29 };

/* Wraps a coordinate into a periodic box and counts the lengths it had to be moved by. False if these
 * cannot be counted, as for what is not a number: nothing is done then. */
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

/* The k-th (0..26) image of x across periodic faces, itself for k = 13; false if there is none within
 * reach of the box. */
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

/* Turns the difference of two positions into the one to the nearest periodic image. */
static inline void ts_box_nearest(const struct ts_box *box, double d[3])
{
	for (int k = 0; k < 3; k++)
		if (ts_box_periodic(box, k))
			d[k] -= ts_box_length(box, k) * rint(d[k] / ts_box_length(box, k));
}

#endif
