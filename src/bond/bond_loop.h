/* The loop over bonds, written once for all bond laws. A bond style defines two functions: the first
 * calls ts_bond_compute_batch with its law, a constant function that is inlined and must be free of
 * branches to be vectorised; the second calls ts_bond_compute_slices with the first. */
#ifndef TS_BOND_BOND_LOOP_H
#define TS_BOND_BOND_LOOP_H

#include <math.h>
#include <string.h>

#include "base/four.h"
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
	bool moving;		  /* some bond type is damped: relative velocities are needed */
	bool store;		  /* store the tensions: an output may read them */
	bool softens;		  /* some bond type softens */
	double (*orientation)[4]; /* of the particles, if bonds transmit moments */
};

/* Rows of a slice that are computed at a time; few slices have more. */
enum { TS_BOND_ROWS = 16, TS_BOND_BATCH = TS_BOND_ROWS * TS_BOND_LANES };
struct ts_bond_batch {
	/* d: vector from the partner to the particle; v: relative velocity, if moving; force: on the
	 * particle */
	double d[3][TS_BOND_BATCH], v[3][TS_BOND_BATCH], force[3][TS_BOND_BATCH];
	double tension[TS_BOND_BATCH], holds[TS_BOND_BATCH];
	bool moving;
} __attribute__((aligned(64)));

/* ---- the law, for a batch of bonds of one type */

/* Evaluates a law for the first n bonds of a batch; returns the number of bonds that break. */
typedef long ts_bond_batch_fn(struct ts_bond_batch *b, const double *rest, size_t n, const void *coeff);

/* Evaluates the law of bond k; returns false if it breaks. */
TS_INLINE bool ts_bond_evaluate_law(struct ts_bond_batch *b, const double *rest, size_t k, const void *coeff,
				    ts_bond_law *law, bool moving)
{
	double x = b->d[0][k], y = b->d[1][k], z = b->d[2][k];
	double length = sqrt(x * x + y * y + z * z), inverse = length > 0 ? 1 / length : 0, tension;
	struct ts_bond_state state = { .extension = length - rest[k], .rest = rest[k] };
	bool holds;

	x *= inverse;
	y *= inverse;
	z *= inverse;
	state.rate = moving ? b->v[0][k] * x + b->v[1][k] * y + b->v[2][k] * z : 0;
	holds = law(coeff, &state, &tension);
	b->tension[k] = tension;
	b->holds[k] = holds ? 1 : 0;
	b->force[0][k] = holds ? -tension * x : 0;
	b->force[1][k] = holds ? -tension * y : 0;
	b->force[2][k] = holds ? -tension * z : 0;
	return holds;
}

TS_INLINE long ts_bond_compute_batch(struct ts_bond_batch *restrict b, const double *restrict rest, size_t n,
				     const void *restrict coeff, ts_bond_law *law)
{
	long broken = 0;

	if (b->moving) {
#pragma omp simd reduction(+ : broken)
		for (size_t k = 0; k < n; k++)
			broken += !ts_bond_evaluate_law(b, rest, k, coeff, law, true);
	} else {
#pragma omp simd reduction(+ : broken)
		for (size_t k = 0; k < n; k++)
			broken += !ts_bond_evaluate_law(b, rest, k, coeff, law, false);
	}
	return broken;
}

/* A slice with several bond types: the batch is evaluated with the law of each type, and the results of
 * the bonds of that type are copied. */
static inline long ts_bond_compute_mixed_types(const struct ts_bond_task *t, struct ts_bond_batch *b,
					       const double *rest, const uint32_t *bond, size_t n,
					       ts_bond_batch_fn *laws)
{
	struct ts_bond_batch all = *b;
	long broken = 0;

	memset(b->force, 0, sizeof b->force);
	for (int type = 1; type <= t->bonds->ntypes; type++) {
		if (!t->coeffs->given[type])
			continue;
		laws(&all, rest, n, ts_coeff(t->coeffs, (size_t)type));
		for (size_t k = 0; k < n; k++) {
			if (bond[k] == TS_BOND_NONE || t->bonds->type[bond[k] >> 1] != type)
				continue;
			for (int c = 0; c < 3; c++)
				b->force[c][k] = all.force[c][k];
			b->tension[k] = all.tension[k];
			b->holds[k] = all.holds[k];
			broken += all.holds[k] == 0;
		}
	}
	return broken;
}

/* ---- inputs */

/* Transposes the vectors of four particles: column[c] is component c; column[3] is undefined. */
TS_INLINE void ts_bond_load_columns(const double (*x)[3], const int32_t *particle, ts_four column[4])
{
	for (size_t k = 0; k < 4; k++)
		column[k] = TS_FOUR_LOAD(x[particle[k]]);
	ts_four_transpose(column);
}

/* x of the particle minus x of the partner, for n rows of the slice from `row` on. Later rows are
 * prefetched, as the lists exceed the inner caches. */
TS_INLINE void ts_bond_load_differences(const double (*x)[3], const struct ts_bond_slice *slice,
					const struct ts_bond_slices *s, size_t row, size_t n,
					double (*to)[TS_BOND_BATCH])
{
	const int32_t(*partner)[TS_BOND_LANES] = (const int32_t(*)[TS_BOND_LANES])s->partner + row;
	const double(*rest)[TS_BOND_LANES] = (const double(*)[TS_BOND_LANES])s->rest + row;
	ts_four own[2][4], other[4];

	ts_bond_load_columns(x, slice->particle, own[0]);
	ts_bond_load_columns(x, slice->particle + 4, own[1]);
	for (size_t k = 0; k < n; k++) {
		__builtin_prefetch(partner[TS_BOND_ROWS + k]);
		__builtin_prefetch(rest[TS_BOND_ROWS + k]);
		for (size_t half = 0; half < 2; half++) {
			ts_bond_load_columns(x, partner[k] + 4 * half, other);
			for (int c = 0; c < 3; c++)
				*(ts_four *)&to[c][k * TS_BOND_LANES + 4 * half] = own[half][c] - other[c];
		}
	}
}

/* Minimum image convention; see ts_box_nearest. */
TS_INLINE void ts_bond_apply_nearest_image(const struct ts_box *box, size_t n, struct ts_bond_batch *b)
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

/* ---- results */

/* Sums the forces by particle: sum[0] of lanes 0..3, sum[1] of lanes 4..7. */
TS_INLINE void ts_bond_sum_forces(const struct ts_bond_batch *b, size_t n, ts_four sum[2][4])
{
	for (size_t k = 0; k < n; k++)
		for (size_t half = 0; half < 2; half++)
			for (int c = 0; c < 3; c++)
				sum[half][c] += *(const ts_four *)&b->force[c][k * TS_BOND_LANES + 4 * half];
}

TS_INLINE void ts_bond_add_forces(double (*f)[3], const struct ts_bond_slice *slice, ts_four sum[2][4])
{
	ts_four_transpose(sum[0]);
	ts_four_transpose(sum[1]);
	for (size_t lane = 0; lane < slice->n; lane++) {
		double *to = f[slice->particle[lane]];
		ts_four all = TS_FOUR_LOAD(to) + sum[lane / 4][lane % 4];

		ts_four_store(&all, 3, to);
	}
}

/* Stores tensions and breakage. Each bond is computed for both partners: only the copy of the first
 * partner is stored. */
static inline void ts_bond_store_tensions(const struct ts_bond_batch *b, const uint32_t *bond, size_t n,
					  struct ts_bonds *bonds)
{
	for (size_t k = 0; k < n; k++) {
		if (bond[k] & 1)
			continue;
		bonds->tension[bond[k] >> 1] = b->tension[k];
		bonds->breaks[bond[k] >> 1] = b->holds[k] == 0;
	}
}

/* ---- the loop */

/* Computes n rows of a slice; returns the number of bonds that break. */
TS_INLINE long ts_bond_compute_rows(const struct ts_bond_task *t, const struct ts_bond_slice *slice,
				    size_t row, size_t n, ts_bond_batch_fn *laws, struct ts_bond_batch *b)
{
	const struct ts_bond_slices *s = &t->bonds->slices;
	const uint32_t *bond = s->bond[row];
	const double *rest = s->rest[row];
	size_t numbers = n * TS_BOND_LANES;
	long broken;

	ts_bond_load_differences((const double(*)[3])t->p->x, slice, s, row, n, b->d);
	if (t->moving)
		ts_bond_load_differences((const double(*)[3])t->p->v, slice, s, row, n, b->v);
	ts_bond_apply_nearest_image(t->box, numbers, b);
	if (slice->type)
		broken = laws(b, rest, numbers, ts_coeff(t->coeffs, (size_t)slice->type));
	else
		broken = ts_bond_compute_mixed_types(t, b, rest, bond, numbers, laws);
	if (broken || t->store)
		ts_bond_store_tensions(b, bond, numbers, t->bonds);
	return broken;
}

/* Computes the slices from .. to-1; returns the number of breaking bonds, counted once for each
 * partner. */
TS_INLINE long ts_bond_compute_slices(const struct ts_bond_task *t, size_t from, size_t to,
				      ts_bond_batch_fn *laws)
{
	struct ts_bond_batch b; /* not zeroed: it is large */
	long broken = 0;

	b.moving = t->moving;
	for (size_t k = from; k < to; k++) {
		const struct ts_bond_slice *slice = &t->bonds->slices.slice[k];
		ts_four sum[2][4] = { { { 0 } } };

		for (size_t row = 0; row < slice->depth; row += TS_BOND_ROWS) {
			size_t rest = slice->depth - row, n = rest < TS_BOND_ROWS ? rest : TS_BOND_ROWS;

			broken += ts_bond_compute_rows(t, slice, slice->first + row, n, laws, &b);
			ts_bond_sum_forces(&b, n, sum);
		}
		ts_bond_add_forces(t->p->f, slice, sum);
	}
	return broken;
}

#endif
