/* The order in which one thread computes its share of the bonds that transmit moments, and the sums of their
 * results by particle (bond_rows.h). */
#ifndef TS_BOND_BOND_SHARES_H
#define TS_BOND_BOND_SHARES_H

#include "bond/bond_loop.h"

/* Computes the rows from .. from + n - 1 and puts their results into their slots; returns how many bonds break. Loads
 * of bonds to particles before `begin` are stored by another share. */
typedef long ts_bond_rows_fn(const struct ts_bond_task *t, size_t from, size_t n, size_t begin);

/* Adds the results of the bonds of particle i. */
TS_INLINE void ts_bond_sum_particle(const struct ts_bonds *b, size_t i, double *f, double *torque)
{
	static const double sign[2] = { -1, 1 };
	ts_four sum[2] = { { 0 } };

	for (size_t k = b->gather.first[i]; k < b->gather.first[i + 1]; k++) {
		const uint32_t side = b->rows.sum[k] & 1;
		const struct ts_bond_result *r = &b->rows.result[b->rows.sum[k] >> 1];

		sum[0] += sign[side] * *(const ts_four *)r->force;
		sum[1] += *(const ts_four *)r->torque[side];
	}
	for (int c = 0; c < 3; c++) {
		f[c] += sum[0][c];
		torque[c] += sum[1][c];
	}
}

/* At most `most` rows at a time. */
TS_INLINE long ts_bond_compute_share(const struct ts_bond_task *t, size_t share, size_t most,
				     ts_bond_rows_fn *compute)
{
	const struct ts_bond_rows *rows = &t->bonds->rows;
	size_t chunk = ts_bond_share_begin(rows, share), end = ts_bond_share_begin(rows, share + 1);
	const size_t begin = chunk * TS_BOND_CHUNK;
	long broken = 0;

	for (size_t c = chunk; c < end; c++) {
		for (size_t r = rows->first[c], n; r < rows->first[c + 1]; r += n) {
			n = rows->first[c + 1] - r < most ? rows->first[c + 1] - r : most;
			broken += compute(t, r, n, begin);
		}
		for (size_t i = c * TS_BOND_CHUNK; i < ts_bond_chunk_end(rows, c); i++)
			ts_bond_sum_particle(t->bonds, i, t->p->f[i], t->p->torque[i]);
	}
	return broken;
}

#endif
