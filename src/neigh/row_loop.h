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

/* Geometry of row r; false if the particles do not touch. */
static inline __attribute__((always_inline)) bool
ts_row_contact(const struct ts_particles *p, size_t i, size_t j, struct ts_contact *c)
{
	const double *xi = p->x[i], *xj = p->x[j], *vi = p->v[i], *vj = p->v[j];
	double d[3] = { xi[0] - xj[0], xi[1] - xj[1], xi[2] - xj[2] };
	double d2 = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
	double sum = p->radius[i] + p->radius[j], distance, inverse;

	if (!(d2 < sum * sum))
		return false;
	distance = sqrt(d2);
	inverse = distance > 0 ? 1 / distance : 0; /* coincident centres: no direction, no force */
	for (int k = 0; k < 3; k++)
		c->n[k] = d[k] * inverse;
	c->overlap = sum - distance;
	c->vn = (vi[0] - vj[0]) * c->n[0] + (vi[1] - vj[1]) * c->n[1] + (vi[2] - vj[2]) * c->n[2];
	c->mass = 1 / (p->imass[i] + p->imass[j]);
	return true;
}

/* A row that does not touch has no force and no history; the gather adds it all the same. */
static inline void ts_row_part(struct ts_rows *rows, size_t r)
{
	if (!rows->touching[r])
		return;
	rows->touching[r] = 0;
	for (int k = 0; k < 3; k++)
		rows->force[r][k] = 0;
	for (size_t k = 0; k < rows->history_width; k++)
		rows->history[r * rows->history_width + k] = 0;
}

static inline __attribute__((always_inline)) void
ts_row_share(const struct ts_row_task *task, size_t from, size_t to, ts_contact_law *law)
{
	/* copies, so that the compiler knows that the stores below leave the pointers alone */
	const struct ts_particles p = *task->p;
	const struct ts_pair pair = *task->pair;
	struct ts_rows rows = *task->rows;
	size_t width = rows.history_width;

	for (size_t r = from; r < to; r++) {
		size_t i = (size_t)rows.i[r], j = (size_t)rows.j[r];
		double *history = width ? rows.history + r * width : NULL;
		struct ts_contact c;
		double fn;

		if (!ts_row_contact(&p, i, j, &c)) {
			ts_row_part(&rows, r);
			continue;
		}
		fn = law(ts_pair_coeff(&pair, p.type[i], p.type[j]), &c, history);
		for (int k = 0; k < 3; k++)
			rows.force[r][k] = fn * c.n[k];
		rows.touching[r] = 1;
	}
}

/* Forces of all rows by the shares, then the sum of each particle. */
static inline void ts_row_loop(struct tsim *sim, const struct ts_pair *pair, ts_contact_law *law,
			       ts_share_fn *share)
{
	struct ts_rows *rows = &sim->neigh->rows;
	struct ts_row_task task = { sim->particles, rows, pair, law };

	ts_parallel(sim->threads, rows->n, share, &task);
	ts_rows_gather(sim, rows);
}

#endif
