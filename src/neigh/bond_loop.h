/* The loop over bonds, written once. A bond style makes two functions: one calls ts_bond_laws with
 * its law, which as a constant function is inlined, and has no branches; the other ts_bond_share with the first. */
#ifndef TS_NEIGH_BOND_LOOP_H
#define TS_NEIGH_BOND_LOOP_H

#include <math.h>

#include "base/four.h"
#include "base/inline.h"
#include "base/parallel.h"
#include "geom/box.h"
#include "neigh/bonds.h"
#include "particles/particles.h"

struct ts_bond_task {
	const struct ts_particles *p;
	struct ts_bonds *bonds;
	const struct ts_coeffs *coeffs;
	const struct ts_box *box;
};

/* Vector from the second to the first partner, by the nearest image. */
static inline void ts_bond_separation(const struct ts_bond_task *t, size_t i, size_t j, double d[3])
{
	for (int k = 0; k < 3; k++)
		d[k] = t->p->x[i][k] - t->p->x[j][k];
	ts_box_nearest(t->box, d);
}

/* Bonds of one type, worked at in columns as contacts are (row_batch.h): the law is computed for several at once. */
struct ts_bond_batch {
	/* from the second to the first partner, first the vector, then its direction; velocities, force on the first */
	double d[4][TS_COLUMN], v[4][TS_COLUMN], force[4][TS_COLUMN];
	double imass[TS_COLUMN], rest[TS_COLUMN], tension[TS_COLUMN], holds[TS_COLUMN];
} __attribute__((aligned(64)));

/* Bonds from .. from+3, those behind the last being the last, to the places at .. at+3. */
TS_INLINE void ts_bond_load(const struct ts_bond_task *t, size_t from, size_t last, size_t at,
			    struct ts_bond_batch *b)
{
	const struct ts_particles *p = t->p;
	ts_four d[4], v[4];

	for (size_t k = 0; k < 4; k++) {
		size_t bond = from + k < last ? from + k : last;
		size_t i = (size_t)t->bonds->row[bond][0], j = (size_t)t->bonds->row[bond][1];

		d[k] = TS_FOUR_AT(p->x[i]) - TS_FOUR_AT(p->x[j]);
		v[k] = TS_FOUR_AT(p->v[i]) - TS_FOUR_AT(p->v[j]);
		b->imass[at + k] = p->imass[i] + p->imass[j];
		b->rest[at + k] = t->bonds->rest[bond];
	}
	ts_four_columns(d, b->d, at);
	ts_four_columns(v, b->v, at);
}

/* To the nearest image; see ts_box_nearest. */
TS_INLINE void ts_bond_nearest(const struct ts_box *box, size_t n, struct ts_bond_batch *b)
{
	for (int k = 0; k < 3; k++) {
		double length = ts_box_length(box, k);

		if (!ts_box_periodic(box, k))
			continue;
#pragma omp simd
		for (size_t at = 0; at < n; at++)
			b->d[k][at] -= length * rint(b->d[k][at] / length);
	}
}

/* The bonds 0 .. n-1 of a batch by a constant law. */
typedef void ts_bond_batch_fn(struct ts_bond_batch *b, size_t n, const void *coeff);

TS_INLINE void ts_bond_laws(struct ts_bond_batch *restrict b, size_t n, const void *restrict coeff,
			    ts_bond_law *law)
{
#pragma omp simd
	for (size_t k = 0; k < n; k++) {
		double x = b->d[0][k], y = b->d[1][k], z = b->d[2][k];
		double length = sqrt(x * x + y * y + z * z), inverse = length > 0 ? 1 / length : 0, tension;
		struct ts_bond_state state = { .extension = length - b->rest[k], .mass = 1 / b->imass[k] };
		bool holds;

		x *= inverse;
		y *= inverse;
		z *= inverse;
		state.rate = b->v[0][k] * x + b->v[1][k] * y + b->v[2][k] * z;
		holds = law(coeff, &state, &tension);
		b->tension[k] = tension;
		b->holds[k] = holds ? 1 : 0;
		b->force[0][k] = holds ? -tension * x : 0;
		b->force[1][k] = holds ? -tension * y : 0;
		b->force[2][k] = holds ? -tension * z : 0;
		b->force[3][k] = 0;
	}
}

/* Bonds from .. to-1, of one type and not more than a column; returns the number of those that break. */
TS_INLINE long ts_bond_work(const struct ts_bond_task *t, size_t from, size_t to, ts_bond_batch_fn *laws)
{
	struct ts_bonds *bonds = t->bonds;
	struct ts_bond_batch b;
	ts_four force[4];
	long broken = 0;

	for (size_t at = 0; at < to - from; at += 4)
		ts_bond_load(t, from + at, to - 1, at, &b);
	ts_bond_nearest(t->box, (to - from + 3) & ~(size_t)3, &b);
	laws(&b, (to - from + 3) & ~(size_t)3, ts_coeff(t->coeffs, (size_t)bonds->type[from]));
	for (size_t at = 0; at < to - from; at++) {
		if (at % 4 == 0)
			ts_four_rows((const double(*)[TS_COLUMN])b.force, at, force);
		ts_four_keep(&force[at % 4], 3, bonds->force[from + at]);
		bonds->tension[from + at] = b.tension[at];
		bonds->breaks[from + at] = b.holds[at] == 0;
		broken += b.holds[at] == 0;
	}
	return broken;
}

/* Returns the number of bonds that break. */
TS_INLINE long ts_bond_share(const struct ts_bond_task *t, size_t from, size_t to, ts_bond_batch_fn *laws)
{
	const int32_t *type = t->bonds->type;
	long broken = 0;

	for (size_t end; from < to; from = end) {
		for (end = from + 1; end < to && end - from < TS_COLUMN && type[end] == type[from];)
			end++;
		broken += ts_bond_work(t, from, end, laws);
	}
	return broken;
}

#endif
