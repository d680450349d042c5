/* The loop over contact rows, written once. A pair style makes a share function that calls
 * ts_row_share with its law: as a constant function the law is inlined, through the style's pointer
 * the same loop is the generic instance. Both give the same bits. */
#ifndef TS_NEIGH_ROW_LOOP_H
#define TS_NEIGH_ROW_LOOP_H

#include <math.h>

#include "base/parallel.h"
#include "neigh/pair.h"

struct ts_row_task {
	const struct ts_particles *p;
	struct ts_rows *rows;
	const struct ts_pair *pair;
	ts_contact_law *law; /* of the generic instance */
};

/* Rows are looked at in blocks: first which of them touch, then the forces of those. Whether a row
 * touches cannot be guessed by the processor, so the first loop does not branch on it. */
enum { TS_ROW_BLOCK = 256 };

static inline __attribute__((always_inline)) double
ts_row_distance2(const struct ts_particles *p, size_t i, size_t j, double d[3])
{
	const double *xi = p->x[i], *xj = p->x[j];

	for (int k = 0; k < 3; k++)
		d[k] = xi[k] - xj[k];
	return d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
}

/* A row that does not touch has no force and no history; the gather adds it all the same. */
static inline void ts_row_part(struct ts_rows *rows, size_t r)
{
	rows->touching[r] = 0;
	for (int k = 0; k < 3; k++)
		rows->force[r][k] = 0;
	for (size_t k = 0; k < rows->history_width; k++)
		rows->history[r * rows->history_width + k] = 0;
}

/* Lists the touching ones of the rows from .. to-1; returns how many. */
static inline __attribute__((always_inline)) size_t ts_row_find(const struct ts_particles *p,
								struct ts_rows *rows, size_t from,
								size_t to,
								uint32_t list[TS_ROW_BLOCK])
{
	size_t n = 0;

	for (size_t r = from; r < to; r++) {
		size_t i = (size_t)rows->i[r], j = (size_t)rows->j[r];
		double d[3], sum = p->radius[i] + p->radius[j];
		bool touching = ts_row_distance2(p, i, j, d) < sum * sum;

		list[n] = (uint32_t)r;
		n += touching;
		if (rows->touching[r] > touching)
			ts_row_part(rows, r);
	}
	return n;
}

static inline __attribute__((always_inline)) void
ts_row_contact(const struct ts_particles *p, size_t i, size_t j, struct ts_contact *c)
{
	const double *vi = p->v[i], *vj = p->v[j];
	double d[3], distance = sqrt(ts_row_distance2(p, i, j, d));
	/* coincident centres: no direction, no force */
	double inverse = distance > 0 ? 1 / distance : 0;

	for (int k = 0; k < 3; k++)
		c->n[k] = d[k] * inverse;
	c->overlap = p->radius[i] + p->radius[j] - distance;
	c->vn = (vi[0] - vj[0]) * c->n[0] + (vi[1] - vj[1]) * c->n[1] + (vi[2] - vj[2]) * c->n[2];
	c->mass = 1 / (p->imass[i] + p->imass[j]);
}

static inline __attribute__((always_inline)) void
ts_row_share(const struct ts_row_task *task, size_t from, size_t to, ts_contact_law *law)
{
	/* copies, so that the compiler knows that the stores below leave the pointers alone */
	const struct ts_particles p = *task->p;
	const struct ts_pair pair = *task->pair;
	struct ts_rows rows = *task->rows;
	uint32_t list[TS_ROW_BLOCK];
	size_t width = rows.history_width;

	for (; from < to; from += TS_ROW_BLOCK) {
		size_t end = to - from < TS_ROW_BLOCK ? to : from + TS_ROW_BLOCK;
		size_t n = ts_row_find(&p, &rows, from, end, list);

		for (size_t k = 0; k < n; k++) {
			size_t r = list[k], i = (size_t)rows.i[r], j = (size_t)rows.j[r];
			struct ts_contact c;
			double fn;

			ts_row_contact(&p, i, j, &c);
			fn = law(ts_pair_coeff(&pair, p.type[i], p.type[j]), &c,
				 width ? rows.history + r * width : NULL);
			for (int d = 0; d < 3; d++)
				rows.force[r][d] = fn * c.n[d];
			rows.touching[r] = 1;
		}
	}
}

/* Forces of all rows by the shares, then the sum of each particle. */
static inline void ts_row_loop(struct tsim *sim, const struct ts_pair *pair, ts_contact_law *law,
			       ts_share_fn *share)
{
	struct ts_rows *rows = &sim->neigh->rows;
	struct ts_row_task task = { sim->particles, rows, pair, law };

	ts_parallel(ts_team(sim, rows->n), rows->n, share, &task);
	ts_gather_forces(sim, &rows->gather, (const double(*)[3])rows->force);
}

#endif
