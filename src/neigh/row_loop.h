/* The loop over contact rows, written once. Included by pair styles, which call ts_row_loop with
 * their law: as a constant function it is inlined, through the style's pointer it is the generic
 * instance. Both give the same bits. */
#ifndef TS_NEIGH_ROW_LOOP_H
#define TS_NEIGH_ROW_LOOP_H

#include <math.h>

#include "neigh/pair.h"

/* Geometry of row r; false if the particles do not touch. */
static inline bool ts_row_contact(const struct ts_particles *p, const struct ts_rows *rows, size_t r,
				  struct ts_contact *c)
{
	size_t i = (size_t)rows->i[r], j = (size_t)rows->j[r];
	double d[3] = { p->x[i][0] - p->x[j][0], p->x[i][1] - p->x[j][1], p->x[i][2] - p->x[j][2] };
	double d2 = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
	double sum = p->radius[i] + p->radius[j], distance, inverse;

	if (!(d2 < sum * sum))
		return false;
	distance = sqrt(d2);
	inverse = distance > 0 ? 1 / distance : 0; /* coincident centres: no direction, no force */
	for (int k = 0; k < 3; k++)
		c->n[k] = d[k] * inverse;
	c->overlap = sum - distance;
	c->vn = (p->v[i][0] - p->v[j][0]) * c->n[0] + (p->v[i][1] - p->v[j][1]) * c->n[1] +
		(p->v[i][2] - p->v[j][2]) * c->n[2];
	c->mass = 1 / (p->imass[i] + p->imass[j]);
	return true;
}

static inline __attribute__((always_inline)) void ts_row_loop(struct tsim *sim,
							      const struct ts_pair *pair,
							      ts_contact_law *law)
{
	struct ts_rows *rows = &sim->neigh->rows;
	const struct ts_particles *p = sim->particles;
	size_t width = rows->history_width;

#pragma omp parallel for num_threads(sim->threads) schedule(static)
	for (size_t r = 0; r < rows->n; r++) {
		struct ts_contact c;
		double *history = width ? rows->history + r * width : NULL;
		double fn;

		if (!ts_row_contact(p, rows, r, &c)) {
			for (size_t k = 0; rows->touching[r] && k < width; k++)
				history[k] = 0;
			rows->touching[r] = 0;
			continue;
		}
		fn = law(ts_pair_coeff(pair, p->type[rows->i[r]], p->type[rows->j[r]]), &c, history);
		for (int k = 0; k < 3; k++)
			rows->force[r][k] = fn * c.n[k];
		rows->touching[r] = 1;
	}
	ts_rows_gather(sim, rows);
}

#endif
