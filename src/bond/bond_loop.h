/* The loop over bonds, written once for all bond laws. A bond style defines a function that calls
 * ts_bond_compute_slices with its law, a constant function that is inlined and must be free of branches to be
 * vectorised.
 *
 * A row of eight bonds is loaded, computed and summed before the next: roots and divisions, which limit the loop, then
 * overlap with the loading of later rows. */
#ifndef TS_BOND_BOND_LOOP_H
#define TS_BOND_BOND_LOOP_H

#include <math.h>
#include <string.h>

#include "base/eight.h"
#include "base/inline.h"
#include "base/parallel.h"
#include "bond/bonds.h"
#include "geom/box.h"
#include "particle/particles.h"

struct ts_bond_task {
	const struct ts_particles *p;
	struct ts_bonds *bonds;
	const struct ts_coeffs *coeffs;
	const struct ts_box *box;
	bool moving;		       /* some bond type is damped: relative velocities are needed */
	bool store;		       /* store the tensions: an output may read them */
	bool softens;		       /* some bond type softens */
	double (*orientation)[4];      /* of the particles, if bonds transmit moments */
	const struct ts_domain *drift; /* whose periodic images have velocities of their own; or NULL */
};

/* A row of a slice. d: vectors from the partners to the particles; v: relative velocities, if moving; force: on the
 * particles. All are written and read as whole vectors, since loads of eight numbers that follow stores of four wait
 * for these. */
struct ts_bond_lanes {
	double d[3][TS_BOND_LANES], v[3][TS_BOND_LANES], force[3][TS_BOND_LANES];
	double tension[TS_BOND_LANES], breaks[TS_BOND_LANES]; /* breaks: 1 or 0 */
} __attribute__((aligned(64)));

/* How a loop is specialised. */
struct ts_bond_kind {
	ts_bond_law *law;
	bool moving; /* relative velocities are needed */
};

/* ---- inputs */

/* x of the particles minus x of their partners, for all lanes of a row. */
TS_INLINE void ts_bond_load_differences(const double (*x)[3], const ts_eight own[3], const int32_t *partner,
					double (*to)[TS_BOND_LANES])
{
	ts_eight other[3];

	ts_eight_gather(x, partner, other);
	for (int c = 0; c < 3; c++)
		*(ts_eight *)to[c] = own[c] - other[c];
}

/* Minimum image convention; see ts_box_nearest. */
TS_INLINE void ts_bond_apply_nearest_image(const struct ts_box *box, struct ts_bond_lanes *l)
{
	for (int c = 0; c < 3; c++) {
		double length = ts_box_length(box, c);

		if (!ts_box_periodic(box, c))
			continue;
#pragma omp simd
		for (size_t k = 0; k < TS_BOND_LANES; k++)
			l->d[c][k] -= length * rint(l->d[c][k] / length);
	}
}

/* v: velocity of particle i relative to particle j; becomes that relative to the image of j which is nearest to i
 * (fix deform remap v). d: x of i minus x of j. Only if task->drift. */
void ts_bond_add_drift(const struct ts_bond_task *t, size_t i, size_t j, const double d[3], double v[3]);

/* The same for the lanes of a row. */
TS_INLINE void ts_bond_add_drifts(const struct ts_bond_task *t, const int32_t *i, const int32_t *j,
				  double (*d)[TS_BOND_LANES], double (*v)[TS_BOND_LANES])
{
	for (size_t k = 0; k < TS_BOND_LANES; k++) {
		double apart[3] = { d[0][k], d[1][k], d[2][k] }, rate[3] = { v[0][k], v[1][k], v[2][k] };

		ts_bond_add_drift(t, (size_t)i[k], (size_t)j[k], apart, rate);
		for (int c = 0; c < 3; c++)
			v[c][k] = rate[c];
	}
}

/* ---- the law */

TS_INLINE void ts_bond_evaluate_lane(struct ts_bond_lanes *l, const double *rest, size_t k, const void *coeff,
				     struct ts_bond_kind kind)
{
	double x = l->d[0][k], y = l->d[1][k], z = l->d[2][k];
	double length = sqrt(x * x + y * y + z * z), inverse = length > 0 ? 1 / length : 0, tension;
	struct ts_bond_state state = { .extension = length - rest[k], .rest = rest[k] };
	bool holds;

	x *= inverse;
	y *= inverse;
	z *= inverse;
	state.rate = kind.moving ? l->v[0][k] * x + l->v[1][k] * y + l->v[2][k] * z : 0;
	holds = kind.law(coeff, &state, &tension);
	l->tension[k] = tension;
	l->breaks[k] = holds ? 0 : 1;
	l->force[0][k] = holds ? -tension * x : 0;
	l->force[1][k] = holds ? -tension * y : 0;
	l->force[2][k] = holds ? -tension * z : 0;
}

TS_INLINE void ts_bond_evaluate(struct ts_bond_lanes *l, const double *rest, const void *coeff,
				struct ts_bond_kind kind)
{
#pragma omp simd
	for (size_t k = 0; k < TS_BOND_LANES; k++)
		ts_bond_evaluate_lane(l, rest, k, coeff, kind);
}

/* A slice with several bond types: the row is evaluated with the law of each type, and the results of the bonds of
 * that type are kept. */
TS_INLINE void ts_bond_evaluate_types(const struct ts_bond_task *t, struct ts_bond_lanes *l,
				      const double *rest, const uint32_t *bond, struct ts_bond_kind kind)
{
	struct ts_bond_lanes all = *l;

	memset(l->force, 0, sizeof l->force);
	memset(l->breaks, 0, sizeof l->breaks);
	for (int type = 1; type <= t->bonds->ntypes; type++) {
		if (!t->coeffs->given[type])
			continue;
		ts_bond_evaluate(&all, rest, ts_coeff(t->coeffs, (size_t)type), kind);
		for (size_t k = 0; k < TS_BOND_LANES; k++) {
			if (bond[k] == TS_BOND_NONE || t->bonds->type[bond[k] >> 1] != type)
				continue;
			for (int c = 0; c < 3; c++)
				l->force[c][k] = all.force[c][k];
			l->tension[k] = all.tension[k];
			l->breaks[k] = all.breaks[k];
		}
	}
}

/* ---- results */

TS_INLINE void ts_bond_add_forces(double (*f)[3], const struct ts_bond_slice *slice, const ts_eight sum[3])
{
	for (size_t lane = 0; lane < slice->n; lane++)
		for (int c = 0; c < 3; c++)
			f[slice->particle[lane]][c] += sum[c][lane];
}

/* Stores tensions and breakage. Each bond is computed for both partners: only the copy of the first partner is stored,
 * of the second one if the first is a particle of another rank. n: particles of this rank. */
static inline void ts_bond_store_tensions(const struct ts_bond_lanes *l, const uint32_t *bond, size_t n,
					  struct ts_bonds *bonds)
{
	for (size_t k = 0; k < TS_BOND_LANES; k++) {
		if (bond[k] == TS_BOND_NONE || (bond[k] & 1 && (size_t)bonds->row[bond[k] >> 1][0] < n))
			continue;
		bonds->tension[bond[k] >> 1] = l->tension[k];
		bonds->breaks[bond[k] >> 1] = l->breaks[k] > 0;
	}
}

/* ---- the loop */

/* Computes a slice and adds the forces to sum; returns the number of bonds that break. `store`: tensions and breakage
 * are stored. */
TS_INLINE long ts_bond_compute_slice(const struct ts_bond_task *t, const struct ts_bond_slice *slice,
				     struct ts_bond_kind kind, bool store, ts_eight sum[3])
{
	const struct ts_bond_slices *s = &t->bonds->slices;
	const double(*x)[3] = (const double(*)[3])t->p->x, (*v)[3] = (const double(*)[3])t->p->v;
	const void *coeff = slice->type ? ts_coeff(t->coeffs, (size_t)slice->type) : NULL;
	ts_eight own[2][3], broken = { 0 };
	double count = 0;

	ts_eight_gather(x, slice->particle, own[0]);
	if (kind.moving)
		ts_eight_gather(v, slice->particle, own[1]);
	for (size_t row = slice->first; row < slice->first + slice->depth; row++) {
		struct ts_bond_lanes l;

		ts_bond_load_differences(x, own[0], s->partner[row], l.d);
		if (kind.moving)
			ts_bond_load_differences(v, own[1], s->partner[row], l.v);
		if (kind.moving && t->drift)
			ts_bond_add_drifts(t, slice->particle, s->partner[row], l.d, l.v);
		ts_bond_apply_nearest_image(t->box, &l);
		if (coeff)
			ts_bond_evaluate(&l, s->rest[row], coeff, kind);
		else
			ts_bond_evaluate_types(t, &l, s->rest[row], s->bond[row], kind);
		for (int c = 0; c < 3; c++)
			sum[c] += *(const ts_eight *)l.force[c];
		broken += *(const ts_eight *)l.breaks;
		if (store)
			ts_bond_store_tensions(&l, s->bond[row], t->p->n, t->bonds);
	}
	for (int k = 0; k < TS_BOND_LANES; k++)
		count += broken[k];
	return (long)count;
}

TS_INLINE long ts_bond_compute_slices_as(const struct ts_bond_task *t, size_t from, size_t to,
					 struct ts_bond_kind kind)
{
	long all = 0;

	for (size_t k = from; k < to; k++) {
		const struct ts_bond_slice *slice = &t->bonds->slices.slice[k];
		ts_eight sum[3] = { { 0 } };
		long broken = t->store ? 0 : ts_bond_compute_slice(t, slice, kind, false, sum);

		if (t->store || broken) { /* once more: bonds break rarely */
			memset(sum, 0, sizeof sum);
			broken = ts_bond_compute_slice(t, slice, kind, true, sum);
		}
		ts_bond_add_forces(t->p->f, slice, sum);
		all += broken;
	}
	return all;
}

/* Computes the slices from .. to-1; returns the number of breaking bonds, counted once for each
 * partner. */
TS_INLINE long ts_bond_compute_slices(const struct ts_bond_task *t, size_t from, size_t to, ts_bond_law *law)
{
	return t->moving ? ts_bond_compute_slices_as(t, from, to, (struct ts_bond_kind){ law, true })
			 : ts_bond_compute_slices_as(t, from, to, (struct ts_bond_kind){ law, false });
}

#endif
