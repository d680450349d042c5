/* The simulation box: an axis-aligned cuboid, faces, periodic wrapping. */
#ifndef TS_GEOM_BOX_H
#define TS_GEOM_BOX_H

#include <stdbool.h>

/* Behaviour of a face, by the letter of the `boundary` command. */
enum ts_face {
	TS_FACE_PERIODIC, /* p */
	TS_FACE_FIXED,    /* f: particles that leave are deleted */
	TS_FACE_SHRINK,   /* s: follows the particles */
	TS_FACE_MINIMUM   /* m: follows them, never inside the first box */
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

#endif
