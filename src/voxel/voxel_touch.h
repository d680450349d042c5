/* Contact points of a sphere with a voxel height field.
 *
 * The solid U is the union of the closed boxes of the columns. Its contact points with a sphere of centre c
 * are the local minima of the distance |c - p|, p in U: a sphere on a top has one, one in a corner of three
 * faces three, one on a ridge that it crosses one.
 *
 * A box B is convex, so |c - p| has one minimum in it, the nearest point p_B, and no other local minimum. A
 * point p of U is a local minimum in U if and only if it is one in each box that contains p, since near p the
 * set U is the union of these boxes (there are finitely many, and they are closed). Hence
 *
 *   p is a contact point <=> p = p_B for every box B that contains p.
 *
 * So p_B is a contact point unless another box B' contains p_B and has a nearer point p_B' (if it contains p_B
 * and its nearest point is another one, this is nearer, as the nearest point is unique). Only the columns
 * whose footprint contains the lateral coordinates of p_B can: B itself if these are inside of its footprint;
 * across a border on which they lie the neighbour there; at a corner of the footprint three neighbours. If c
 * is beyond the border, the neighbour there has a nearer point whenever it contains p_B. If c is on the
 * border itself, it has a nearer point only if it is higher; if both tops have the same height, p_B = p_B' is
 * one contact point, which belongs to the column that comes last in the order of (j, i): where c is above both
 * it is the one whose half-open interval [x_i, x_i+1) contains c. So each contact point is found in exactly
 * one column, and a flat field has one contact point for any c: below c, with the normal along the axis of the
 * heights. All of this is decided by comparisons of coordinates and heights, without rounding.
 *
 * An edge is a contact point of its own however small its step is: round-off of heights would double the force. So p_B
 * on a top counts as a point of B' beyond the border towards c, too, if it is above B' by no more than 1e-9 of the width
 * of a column or the rounding of heights. One contact point remains at least: each one left out has a column that is
 * nearer across the heights.
 *
 * A centre in the solid has the distance 0 and no normal. */
#ifndef TS_VOXEL_VOXEL_TOUCH_H
#define TS_VOXEL_VOXEL_TOUCH_H

#include "voxel/voxel_field.h"

struct ts_voxel_contact {
	int64_t column[2]; /* i, j; outside of 0 .. n-1: a periodic image */
	double n[3];	 /* unit vector from the contact point to the centre; 0: the centre is in the solid */
	double distance; /* length */
};

/* Finds the contact points nearer than `reach` to the point x (in the frame of the field), in an order that
 * depends on the field and x alone. Returns their number, and stores the first `most` of them. */
size_t ts_voxel_contacts(const struct ts_voxel_field *f, const double x[3], double reach,
			 struct ts_voxel_contact *out, size_t most);
/* The same for any number of them: calls `take` for each. */
typedef void ts_voxel_contact_fn(void *context, const struct ts_voxel_contact *contact);
void ts_voxel_contacts_visit(const struct ts_voxel_field *f, const double x[3], double reach,
			     ts_voxel_contact_fn *take, void *context);
/* Distance of x from the solid, 0 inside of it; infinite if it is not less than `reach`. */
double ts_voxel_distance(const struct ts_voxel_field *f, const double x[3], double reach);
/* Finds the point of the solid nearest to x, which may be no contact point if x is in the solid (distance 0, no
 * normal); false: it is not nearer than `reach`. Of equally near ones that of the column of x, else the first in an
 * order that depends on the field and x alone. */
bool ts_voxel_nearest(const struct ts_voxel_field *f, const double x[3], double reach,
		      struct ts_voxel_contact *out);

#endif
