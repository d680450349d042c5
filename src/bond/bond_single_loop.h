/* The loop over bonds that transmit moments by a law of their own, one bond at a time: for laws with branches or
 * transcendental functions, which the vectorised loop (bond_moment_loop.c) does not have. A bond style defines its law,
 * a ts_bond_single_law, and calls ts_bond_compute_singles with it, which is inlined.
 *
 * Each bond is computed for both partners, from the point of view of the first, so the bits depend neither on
 * threads nor on the order of particles. */
#ifndef TS_BOND_BOND_SINGLE_LOOP_H
#define TS_BOND_BOND_SINGLE_LOOP_H

#include "bond/bond_loop.h"
#include "law/bond_element.h"

TS_INLINE void ts_bond_element_of_lane(const struct ts_bond_lanes *l, size_t k, struct ts_bond_element *e)
{
	*e = (struct ts_bond_element){ .length = l->length[k],
				       .fraction = l->fraction[k],
				       .k = { l->k[0][k], l->k[1][k], l->k[2][k], l->k[3][k] },
				       .c = { l->c[0][k], l->c[1][k], l->c[2][k], l->c[3][k] },
				       .per_area = l->per_area[k],
				       .per_moment = l->per_moment[k],
				       .per_torque = l->per_torque[k],
				       .lever = l->lever[k],
				       .tension = l->tension[k],
				       .shear = l->shear[k],
				       .compression = l->compression[k] };
}

/* State of both partners of bond b; l, k: its lane. */
TS_INLINE void ts_bond_ends_of(const struct ts_bond_task *t, size_t b, const struct ts_bond_lanes *l,
			       size_t k, struct ts_bond_ends *s)
{
	const struct ts_particles *p = t->p;
	const size_t i = (size_t)t->bonds->row[b][0], j = (size_t)t->bonds->row[b][1];
	const size_t row[2] = { i, j };
	double d[3], v[3] = { 0, 0, 0 };

	for (int c = 0; c < 3; c++) {
		d[c] = p->x[j][c] - p->x[i][c];
		if (t->moving)
			v[c] = p->v[j][c] - p->v[i][c];
	}
	ts_box_nearest(t->box, d);
	s->d = (struct ts_xyz){ d[0], d[1], d[2] };
	s->v = (struct ts_xyz){ v[0], v[1], v[2] };
	for (int side = 0; side < 2; side++) {
		const double *q = t->orientation[row[side]], *w = p->omega[row[side]];

		s->q[side] = ts_wxyz_product((struct ts_wxyz){ q[0], q[1], q[2], q[3] },
					     (struct ts_wxyz){ l->frame[side][0][k], l->frame[side][1][k],
							       l->frame[side][2][k], l->frame[side][3][k] });
		s->omega[side] = t->moving ? (struct ts_xyz){ w[0], w[1], w[2] } : (struct ts_xyz){ 0, 0, 0 };
	}
}

TS_INLINE void ts_bond_store_single(struct ts_bonds *bonds, size_t b, const struct ts_bond_answer *a,
				    bool holds)
{
	const double whole = holds ? 1 : 0;
	const struct ts_bond_load load = {
		{ -whole * a->force.x, -whole * a->force.y, -whole * a->force.z },
		{ { whole * a->torque[0].x, whole * a->torque[0].y, whole * a->torque[0].z },
		  { whole * a->torque[1].x, whole * a->torque[1].y, whole * a->torque[1].z } }
	};

	bonds->load[b] = load;
	bonds->tension[b] = holds ? a->axial : a->load[TS_BOND_NORMAL];
	bonds->breaks[b] = !holds;
}

/* Computes the bonds of one particle of a slice; returns how many of them break. */
TS_INLINE long ts_bond_compute_lane(const struct ts_bond_task *t, const struct ts_bond_slice *slice,
				    size_t lane, ts_bond_single_law *law)
{
	const struct ts_bond_slices *s = &t->bonds->slices;
	double *f = t->p->f[slice->particle[lane]], *torque = t->p->torque[slice->particle[lane]];
	long broken = 0;

	for (size_t row = slice->first; row < slice->first + slice->depth; row++) {
		const uint32_t entry = s->bond[row][lane];
		const size_t b = entry >> 1, side = entry & 1;
		struct ts_bond_element e;
		struct ts_bond_ends ends;
		struct ts_bond_answer a;
		double sign = side ? 1 : -1;
		bool holds;

		if (entry == TS_BOND_NONE)
			continue;
		ts_bond_element_of_lane(&s->lanes[row], lane, &e);
		ts_bond_ends_of(t, b, &s->lanes[row], lane, &ends);
		holds = law(ts_coeff(t->coeffs, (size_t)t->bonds->type[b]), &e, &ends, true, &a);
		broken += !holds;
		if (!side && (!holds || t->store))
			ts_bond_store_single(t->bonds, b, &a, holds);
		if (!holds)
			continue;
		f[0] += sign * a.force.x;
		f[1] += sign * a.force.y;
		f[2] += sign * a.force.z;
		torque[0] += a.torque[side].x;
		torque[1] += a.torque[side].y;
		torque[2] += a.torque[side].z;
	}
	return broken;
}

TS_INLINE long ts_bond_compute_singles(const struct ts_bond_task *t, size_t from, size_t to,
				       ts_bond_single_law *law)
{
	long broken = 0;

	for (size_t k = from; k < to; k++)
		for (size_t lane = 0; lane < t->bonds->slices.slice[k].n; lane++)
			broken += ts_bond_compute_lane(t, &t->bonds->slices.slice[k], lane, law);
	return broken;
}

#endif
