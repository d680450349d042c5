/* The loop over bonds that transmit moments by a law of their own, one bond at a time: for laws with branches or
 * transcendental functions, which the vectorised loop (bond_moment_loop.c) does not have. A bond style defines its law,
 * a ts_bond_single_law, and calls ts_bond_compute_singles with it, which is inlined.
 *
 * The order is that of bond_rows.h, so the bits depend neither on threads nor on the order of particles. */
#ifndef TS_BOND_BOND_SINGLE_LOOP_H
#define TS_BOND_BOND_SINGLE_LOOP_H

#include "bond/bond_shares.h"
#include "law/bond_element.h"

TS_INLINE void ts_bond_element_of_lane(const struct ts_bond_row *l, const struct ts_bond_sections *c,
				       const struct ts_bond_dashpots *dashpots, size_t k,
				       struct ts_bond_element *e)
{
	*e = (struct ts_bond_element){ .length = l->length[k],
				       .fraction = l->fraction[k],
				       .k = { c->k[0][k], c->k[1][k], c->k[2][k], c->k[3][k] },
				       .per_area = c->per_area[k],
				       .per_moment = c->per_moment[k],
				       .per_torque = c->per_torque[k],
				       .lever = c->lever[k],
				       .tension = c->tension[k],
				       .shear = c->shear[k],
				       .compression = c->compression[k] };
	for (int m = 0; dashpots && m < TS_BOND_MODES; m++)
		e->c[m] = dashpots->c[m][k];
}

/* State of both partners of the bond of a lane. */
TS_INLINE void ts_bond_ends_of_lane(const struct ts_bond_task *t, const struct ts_bond_row *l, size_t k,
				    struct ts_bond_ends *s)
{
	const struct ts_particles *p = t->p;
	const size_t i = (size_t)l->particle[0][k], j = (size_t)l->particle[1][k];
	const size_t row[2] = { i, j };
	double d[3], v[3] = { 0, 0, 0 };

	for (int c = 0; c < 3; c++) {
		d[c] = p->x[j][c] - p->x[i][c];
		if (t->moving)
			v[c] = p->v[j][c] - p->v[i][c];
	}
	if (t->moving && t->drift)
		ts_bond_add_drift(t, j, i, d, v);
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
	bonds->tension[b] = holds ? a->axial : a->load[TS_BOND_NORMAL] * a->acting;
	bonds->breaks[b] = !holds;
}

/* Computes the bond of a lane; returns whether it breaks. */
TS_INLINE bool ts_bond_compute_lane(const struct ts_bond_task *t, size_t row, size_t lane, size_t begin,
				    ts_bond_single_law *law)
{
	const struct ts_bond_rows *rows = &t->bonds->rows;
	const struct ts_bond_row *l = &rows->row[row];
	const size_t b = l->bond[lane];
	struct ts_bond_element e;
	struct ts_bond_ends ends;
	struct ts_bond_answer a;
	bool holds;

	ts_bond_element_of_lane(l, &rows->sections[rows->sections_of[row]],
				t->moving ? &rows->dashpots[row] : NULL, lane, &e);
	ts_bond_ends_of_lane(t, l, lane, &ends);
	holds = law(ts_coeff(t->coeffs, (size_t)t->bonds->type[b]), &e, &ends, true, &a);
	if ((!holds || t->store) && (size_t)l->particle[0][lane] >= begin &&
	    (size_t)l->particle[1][lane] >= begin)
		ts_bond_store_single(t->bonds, b, &a, holds);
	rows->result[l->slot[lane]] =
		holds ? (struct ts_bond_result){ { a.force.x, a.force.y, a.force.z, 0 },
						 { { a.torque[0].x, a.torque[0].y, a.torque[0].z, 0 },
						   { a.torque[1].x, a.torque[1].y, a.torque[1].z, 0 } } }
		      : (struct ts_bond_result){ .force = { 0 } };
	return !holds;
}

TS_INLINE long ts_bond_compute_single_rows(const struct ts_bond_task *t, size_t from, size_t n, size_t begin,
					   ts_bond_single_law *law)
{
	long broken = 0;

	for (size_t row = from; row < from + n; row++)
		for (size_t lane = 0; lane < TS_BOND_ROW_LANES; lane++)
			if (t->bonds->rows.row[row].bond[lane] != TS_BOND_NONE)
				broken += ts_bond_compute_lane(t, row, lane, begin, law);
	return broken;
}

/* Defines the slot `compute` of a style, `name`, with its law. */
#define TS_BOND_SINGLE_LOOP(name, law)                                                             \
	static long name##_rows(const struct ts_bond_task *t, size_t from, size_t n, size_t begin) \
	{                                                                                          \
		return ts_bond_compute_single_rows(t, from, n, begin, law);                        \
	}                                                                                          \
	static long name(void *task, size_t from, size_t to)                                       \
	{                                                                                          \
		long broken = 0;                                                                   \
                                                                                                   \
		for (size_t k = from; k < to; k++)                                                 \
			broken += ts_bond_compute_share(task, k, 1, name##_rows);                  \
		return broken;                                                                     \
	}

#endif
