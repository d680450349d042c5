/* The loop over bonds that transmit moments, a row of eight bonds at a time. */
#include "base/clones.h"
TS_UNROLLED

#include "bond/bond_loop.h"
#include "bond/bond_moment.h"

#include "base/banned.h"

enum { LANES = TS_BOND_LANES };

/* The two ends of the bonds of a row: differences partner minus particle, and states of both. */
struct row {
	double d[3][LANES], v[3][LANES];
	double q[2][4][LANES], omega[2][4][LANES];
	double force[3][LANES], torque[3][LANES]; /* on the particle */
	double axial[LANES], holds[LANES];
} __attribute__((aligned(64)));

TS_INLINE void load_columns(const double (*x)[3], const int32_t *particle, double (*to)[LANES])
{
	ts_four column[4];

	for (size_t half = 0; half < 2; half++) {
		ts_bond_load_columns(x, particle + 4 * half, column);
		for (int c = 0; c < 3; c++)
			*(ts_four *)&to[c][4 * half] = column[c];
	}
}

TS_INLINE void load_orientations(const double (*q)[4], const int32_t *particle, double (*to)[LANES])
{
	for (size_t half = 0; half < 2; half++) {
		ts_four column[4];

		for (size_t k = 0; k < 4; k++)
			column[k] = TS_FOUR_LOAD(q[particle[4 * half + k]]);
		ts_four_transpose(column);
		for (int c = 0; c < 4; c++)
			*(ts_four *)&to[c][4 * half] = column[c];
	}
}

/* own: x or v of the particles; changed to that of the partners minus own. */
TS_INLINE void load_difference(const double (*x)[3], const int32_t *partner, double (*own)[LANES],
			       double (*to)[LANES])
{
	load_columns(x, partner, to);
	for (int c = 0; c < 3; c++)
#pragma omp simd
		for (size_t k = 0; k < LANES; k++)
			to[c][k] -= own[c][k];
}

TS_INLINE void apply_nearest_image(const struct ts_box *box, struct row *r)
{
	for (int c = 0; c < 3; c++) {
		double length = ts_box_length(box, c);

		if (!ts_box_periodic(box, c))
			continue;
#pragma omp simd
		for (size_t k = 0; k < LANES; k++)
			r->d[c][k] -= length * rint(r->d[c][k] / length);
	}
}

/* Both copies of a bond are computed from the point of view of its first partner, so that their bits are the
 * same. */
TS_INLINE void ends_of(const struct row *r, const struct ts_bond_lanes *e, size_t k, bool moving,
		       struct ts_bond_ends *s)
{
	const double second = e->second[k], sign = 1 - 2 * second;
	double q[2][4];

	for (int c = 0; c < 4; c++) {
		q[0][c] = second > 0 ? r->q[1][c][k] : r->q[0][c][k];
		q[1][c] = second > 0 ? r->q[0][c][k] : r->q[1][c][k];
	}
	s->d = (struct ts_xyz){ sign * r->d[0][k], sign * r->d[1][k], sign * r->d[2][k] };
	for (int p = 0; p < 2; p++)
		s->q[p] = ts_wxyz_product((struct ts_wxyz){ q[p][0], q[p][1], q[p][2], q[p][3] },
					  (struct ts_wxyz){ e->frame[p][0][k], e->frame[p][1][k],
							    e->frame[p][2][k], e->frame[p][3][k] });
	if (!moving)
		return;
	s->v = (struct ts_xyz){ sign * r->v[0][k], sign * r->v[1][k], sign * r->v[2][k] };
	for (int p = 0; p < 2; p++) {
		double w[3];

		for (int c = 0; c < 3; c++)
			w[c] = second > 0 ? r->omega[1 - p][c][k] : r->omega[p][c][k];
		s->omega[p] = (struct ts_xyz){ w[0], w[1], w[2] };
	}
}

TS_INLINE long evaluate(struct row *r, const struct ts_bond_lanes *l, size_t k, bool moving)
{
	const struct ts_bond_element e = { .length = l->length[k],
					   .fraction = l->fraction[k],
					   .k = { l->k[0][k], l->k[1][k], l->k[2][k], l->k[3][k] },
					   .c = { moving ? l->c[0][k] : 0, moving ? l->c[1][k] : 0,
						  moving ? l->c[2][k] : 0, moving ? l->c[3][k] : 0 },
					   .per_area = l->per_area[k],
					   .per_moment = l->per_moment[k],
					   .per_torque = l->per_torque[k],
					   .lever = l->lever[k],
					   .tension = l->tension[k],
					   .shear = l->shear[k],
					   .compression = l->compression[k] };
	const double second = l->second[k], sign = 2 * second - 1;
	struct ts_bond_ends s;
	struct ts_bond_answer a;
	bool holds;
	double whole;

	ends_of(r, l, k, moving, &s);
	ts_bond_elastic(&e, &s, &a);
	ts_bond_stress(&e, &a);
	holds = ts_bond_holds(&e, &a);
	if (moving)
		ts_bond_viscous(&e, &s, &a);
	whole = holds ? 1 : 0;
	r->axial[k] = holds ? a.axial : a.load[TS_BOND_NORMAL];
	r->holds[k] = whole;
	r->force[0][k] = whole * (sign * a.force.x);
	r->force[1][k] = whole * (sign * a.force.y);
	r->force[2][k] = whole * (sign * a.force.z);
	r->torque[0][k] = whole * (second > 0 ? a.torque[1].x : a.torque[0].x);
	r->torque[1][k] = whole * (second > 0 ? a.torque[1].y : a.torque[0].y);
	r->torque[2][k] = whole * (second > 0 ? a.torque[1].z : a.torque[0].z);
	return !holds;
}

TS_INLINE long evaluate_row(struct row *restrict r, const struct ts_bond_lanes *restrict l, bool moving)
{
	long broken = 0;

#pragma omp simd reduction(+ : broken)
	for (size_t k = 0; k < LANES; k++)
		broken += evaluate(r, l, k, moving);
	return broken;
}

static void store_loads(const struct row *r, const uint32_t *bond, struct ts_bonds *bonds)
{
	for (size_t k = 0; k < LANES; k++) {
		size_t b = bond[k] >> 1, side = bond[k] & 1;

		if (bond[k] == TS_BOND_NONE)
			continue;
		for (int c = 0; c < 3; c++)
			bonds->load[b].torque[side][c] = r->torque[c][k];
		if (side)
			continue;
		for (int c = 0; c < 3; c++)
			bonds->load[b].force[c] = r->force[c][k];
		bonds->tension[b] = r->axial[k];
		bonds->breaks[b] = r->holds[k] == 0;
	}
}

TS_INLINE void add_row(double (*from)[LANES], ts_four sum[2][4])
{
	for (size_t half = 0; half < 2; half++)
		for (int c = 0; c < 3; c++)
			sum[half][c] += *(const ts_four *)&from[c][4 * half];
}

TS_INLINE long compute_slice(const struct ts_bond_task *t, const struct ts_bond_slice *slice, bool moving)
{
	const struct ts_bond_slices *s = &t->bonds->slices;
	const struct ts_particles *p = t->p;
	const double(*x)[3] = (const double(*)[3])p->x, (*v)[3] = (const double(*)[3])p->v,
	      (*w)[3] = (const double(*)[3])p->omega, (*q)[4] = (const double(*)[4])t->orientation;
	double own[2][3][LANES] __attribute__((aligned(64)));
	ts_four force[2][4] = { { { 0 } } }, torque[2][4] = { { { 0 } } };
	struct row r;
	long broken = 0;

	load_columns(x, slice->particle, own[0]);
	load_orientations(q, slice->particle, r.q[0]);
	if (moving) {
		load_columns(v, slice->particle, own[1]);
		load_columns(w, slice->particle, r.omega[0]);
	}
	for (size_t row = slice->first; row < slice->first + slice->depth; row++) {
		const int32_t *partner = s->partner[row];
		long less;

		load_difference(x, partner, own[0], r.d);
		load_orientations(q, partner, r.q[1]);
		if (moving) {
			load_difference(v, partner, own[1], r.v);
			load_columns(w, partner, r.omega[1]);
		}
		apply_nearest_image(t->box, &r);
		less = evaluate_row(&r, &s->lanes[row], moving);
		if (less || t->store)
			store_loads(&r, s->bond[row], t->bonds);
		add_row(r.force, force);
		add_row(r.torque, torque);
		broken += less;
	}
	ts_bond_add_forces(p->f, slice, force);
	ts_bond_add_forces(p->torque, slice, torque);
	return broken;
}

TS_CLONES static long compute_slices(void *task, size_t from, size_t to)
{
	const struct ts_bond_task *t = task;
	long broken = 0;

	for (size_t k = from; k < to; k++)
		broken += t->moving ? compute_slice(t, &t->bonds->slices.slice[k], true)
				    : compute_slice(t, &t->bonds->slices.slice[k], false);
	return broken;
}

long ts_bond_compute_moments(void *task, size_t from, size_t to)
{
	return compute_slices(task, from, to);
}
