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

/* A sheared periodic box (Lees, Edwards 1972): the periodic images across the faces of dimension `gradient` are
 * displaced along dimension `flow` < gradient, the upper ones by turns * length + offset. */
struct ts_shear {
	bool on;
	int flow, gradient;
	double offset; /* within half a length of the box in `flow` at each rebuild */
	int64_t turns;
};

struct ts_box {
	double lo[3], hi[3];
	enum ts_face face[3][2]; /* [dimension][0 low, 1 high] */
	struct ts_shear shear;
};

static inline bool ts_box_periodic(const struct ts_box *box, int dim)
{
	return box->face[dim][0] == TS_FACE_PERIODIC;
}

static inline double ts_box_length(const struct ts_box *box, int dim)
{
	return box->hi[dim] - box->lo[dim];
}

/* Displacement of the image that is shifted by shift[] lengths of the box, along dim; of a sheared box without
 * the `turns` of the images across its sheared faces. */
static inline double ts_box_shift(const struct ts_box *box, const double shift[3], int dim)
{
	double d = shift[dim] * ts_box_length(box, dim);

	return box->shear.on && dim == box->shear.flow ? d + shift[box->shear.gradient] * box->shear.offset
						       : d;
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

/* In a sheared box, after x[gradient] was wrapped by this number of turns: displaces x[flow]. Returns false
 * if an image count would exceed its limit. */
static inline bool ts_box_wrap_shear(const struct ts_box *box, double x[3], int32_t image[3], int32_t turns)
{
	const struct ts_shear *s = &box->shear;

	if (!turns)
		return true;
	if (!(fabs((double)image[s->flow] - (double)turns * (double)s->turns) <= TS_TURNS_MOST))
		return false;
	x[s->flow] -= turns * s->offset;
	image[s->flow] -= (int32_t)(turns * s->turns);
	return true;
}

/* Adds the displacements by which a sheared box has moved the images that a particle came through. */
static inline void ts_unwrap_shear(const struct ts_box *box, const int32_t image[3], double x[3])
{
	const struct ts_shear *s = &box->shear;

	if (s->on)
		x[s->flow] +=
			image[s->gradient] * (s->offset + (double)s->turns * ts_box_length(box, s->flow));
}

/* The k-th (0..26) periodic image of x; k = 13 is x itself. False if there is no such image within the
 * distance `reach` of the box. */
static inline bool ts_box_image(const struct ts_box *box, const double x[3], int k, double reach,
				double image[3])
{
	const double shift[3] = { k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1 };
	bool sheared = box->shear.on && shift[box->shear.gradient] != 0;

	for (int d = 0; d < 3; d++) {
		image[d] = x[d] + ts_box_shift(box, shift, d);
		if (shift[d] != 0 && !ts_box_periodic(box, d))
			return false;
		if ((shift[d] != 0 || (sheared && d == box->shear.flow)) &&
		    (image[d] <= box->lo[d] - reach || image[d] >= box->hi[d] + reach))
			return false;
	}
	return true;
}

/* Minimum image convention for the difference of two positions. */
static inline void ts_box_nearest(const struct ts_box *box, double d[3])
{
	for (int k = 2; k >= 0; k--) { /* `gradient` before `flow` */
		double turns;

		if (!ts_box_periodic(box, k))
			continue;
		turns = rint(d[k] / ts_box_length(box, k));
		d[k] -= ts_box_length(box, k) * turns;
		if (box->shear.on && k == box->shear.gradient)
			d[box->shear.flow] -= box->shear.offset * turns;
	}
}

#endif
