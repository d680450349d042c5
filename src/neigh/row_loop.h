/* The loop over contact rows, written once. A pair style makes a share function that calls
 * ts_row_share with a constant model: the compiler keeps only what that model has. With the model
 * of the style's state the same loop is the generic instance. Both give the same bits. */
#ifndef TS_NEIGH_ROW_LOOP_H
#define TS_NEIGH_ROW_LOOP_H

#include <math.h>

#include "base/parallel.h"
#include "law/granular_force.h"
#include "neigh/pair.h"

struct ts_row_task {
	const struct ts_particles *p;
	struct ts_rows *rows;
	const struct ts_pair *pair;
	double dt;
	bool advance; /* contacts remember: false in the set-up of a run */
	bool keep;    /* a pair that parts remembers until the next rebuild */
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

/* A row that does not touch has no force and no history; the gather adds it all the same. `keep`: the
 * history stays until the next rebuild. */
static inline void ts_row_part(struct ts_rows *rows, size_t r, bool keep)
{
	rows->touching[r] = 0;
	for (int k = 0; k < 3; k++) {
		rows->force[r][k] = 0;
		if (rows->turn)
			rows->turn[r][k] = rows->roll[r][k] = 0;
	}
	for (size_t k = 0; k < rows->history_width && !keep; k++)
		rows->history[r * rows->history_width + k] = 0;
}

/* How far beyond their touch the partners of a row still pull. */
static inline double ts_row_beyond(const struct ts_particles *p, const struct ts_pair *pair,
				   const struct ts_rows *rows, size_t r)
{
	size_t i = (size_t)rows->i[r], j = (size_t)rows->j[r];
	double a = p->radius[i], b = p->radius[j];

	return ts_granular_beyond(ts_pair_model(pair, p->type[i], p->type[j]),
				  ts_pair_law(pair, p->type[i], p->type[j]), a * b / (a + b),
				  rows->history + r * rows->history_width);
}

/* Lists the touching ones of the rows from .. to-1; returns how many. `each`: rows have models of their own. */
static inline __attribute__((always_inline)) size_t
ts_row_find(const struct ts_particles *p, const struct ts_pair *pair, bool each,
	    struct ts_rows *rows, size_t from, size_t to, bool keep, uint32_t list[TS_ROW_BLOCK])
{
	size_t n = 0;

	for (size_t r = from; r < to; r++) {
		size_t i = (size_t)rows->i[r], j = (size_t)rows->j[r];
		double d[3], sum = p->radius[i] + p->radius[j] +
				   (each ? ts_row_beyond(p, pair, rows, r) : 0);
		bool touching = ts_row_distance2(p, i, j, d) < sum * sum;

		list[n] = (uint32_t)r;
		n += touching;
		if (rows->touching[r] > touching)
			ts_row_part(rows, r, keep);
	}
	return n;
}

/* What the laws need to know of the partners, as far as the model has laws that ask. */
static inline __attribute__((always_inline)) void ts_row_touch(const struct ts_particles *p,
							       size_t i, size_t j,
							       const struct ts_granular_model *m,
							       struct ts_touch *t)
{
	const double *vi = p->v[i], *vj = p->v[j];
	double d[3], v[3], distance = sqrt(ts_row_distance2(p, i, j, d));
	/* coincident centres: no direction, no force */
	double inverse = distance > 0 ? 1 / distance : 0;

	t->wall = false;
	t->distance = distance;
	t->radius[0] = p->radius[i];
	t->radius[1] = p->radius[j];
	t->overlap = t->radius[0] + t->radius[1] - distance;
	t->r_eff = t->radius[0] * t->radius[1] / (t->radius[0] + t->radius[1]);
	t->m_eff = 1 / (p->imass[i] + p->imass[j]);
	t->mass[0] = p->mass[i];
	t->mass[1] = p->mass[j];
	for (int k = 0; k < 3; k++) {
		t->n[k] = d[k] * inverse;
		v[k] = vi[k] - vj[k];
	}
	ts_granular_arms(m, t);
	t->vn = ts_dot(v, t->n);
	for (int k = 0; k < 3; k++)
		t->slip[k] = t->roll[k] = t->spin[k] = 0;
	if (ts_granular_turns(m))
		ts_touch_motion(t, v, p->omega[i], p->omega[j]);
}

static inline __attribute__((always_inline)) void ts_row_store(struct ts_rows *rows, size_t r,
							       const struct ts_granular_model *m,
							       const struct ts_touch *t,
							       const struct ts_granular_force *f)
{
	rows->touching[r] = 1;
	for (int k = 0; k < 3; k++)
		rows->force[r][k] = f->force[k];
	if (!ts_granular_turns(m))
		return;
	rows->half[r] = ts_granular_short(m, t);
	for (int k = 0; k < 3; k++) {
		rows->turn[r][k] = f->turn[k];
		rows->roll[r][k] = f->roll[k];
	}
}

/* `all`: the model of all rows; NULL: each has its own. */
static inline __attribute__((always_inline)) void ts_row_share(const struct ts_row_task *task,
							       size_t from, size_t to,
							       const struct ts_granular_model *all)
{
	/* copies, so that the compiler knows that the stores below leave the pointers alone */
	const struct ts_particles p = *task->p;
	const struct ts_pair pair = *task->pair;
	struct ts_rows rows = *task->rows;
	uint32_t list[TS_ROW_BLOCK];
	size_t width = rows.history_width;

	for (; from < to; from += TS_ROW_BLOCK) {
		size_t end = to - from < TS_ROW_BLOCK ? to : from + TS_ROW_BLOCK;
		size_t n = ts_row_find(&p, &pair, !all, &rows, from, end, task->keep, list);

		for (size_t k = 0; k < n; k++) {
			size_t r = list[k], i = (size_t)rows.i[r], j = (size_t)rows.j[r];
			const struct ts_granular_model *m =
				all ? all : ts_pair_model(&pair, p.type[i], p.type[j]);
			struct ts_granular_force f;
			struct ts_touch t;

			ts_row_touch(&p, i, j, m, &t);
			ts_granular_contact(m, ts_pair_law(&pair, p.type[i], p.type[j]), &t,
					    task->dt, task->advance,
					    width ? rows.history + r * width : NULL, &f);
			ts_row_store(&rows, r, m, &t, &f);
		}
	}
}

/* The generic instance: for any model, that of the pair. */
void ts_row_share_generic(void *task, size_t from, size_t to);
/* For pairs of types that each have a model of their own. */
void ts_row_share_each(void *task, size_t from, size_t to);

/* Forces of all rows by the shares, then the sum of each particle. */
static inline void ts_row_loop(struct tsim *sim, const struct ts_pair *pair, ts_share_fn *share)
{
	struct ts_rows *rows = &sim->neigh->rows;
	struct ts_row_task task = { sim->particles, rows, pair, sim->clock.dt, !sim->in_setup,
				    sim->legacy && !pair->mixes }; /* LAMMPS forgets at once */

	ts_parallel(ts_team(sim, rows->n), rows->n, share, &task);
	ts_gather_forces(sim, &rows->gather, (const double(*)[3])rows->force);
	if (rows->turn)
		ts_rows_gather_torques(sim, rows);
}

#endif
