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
enum { TS_ROW_BLOCK = 64 };

TS_INLINE double
ts_row_distance2(const struct ts_particles *p, size_t i, size_t j, double d[3])
{
	const double *xi = p->x[i], *xj = p->x[j];

	for (int k = 0; k < 3; k++)
		d[k] = xi[k] - xj[k];
	return d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
}

/* A row that does not touch has no force and no history; the gather adds it all the same. `keep`: the
 * history stays until the next rebuild. */
TS_INLINE void ts_row_part(struct ts_rows *rows, size_t r, bool keep)
{
	rows->touching[r] = 0;
	for (int k = 0; k < 3; k++) {
		rows->force[r][k] = 0;
		if (rows->turn)
			rows->turn[r][k] = 0;
		if (rows->roll)
			rows->roll[r][k] = 0;
	}
	for (size_t k = 0; k < rows->history_width && !keep; k++)
		rows->history[r * rows->history_width + k] = 0;
}

/* How far beyond their touch the partners of a row still pull. */
TS_INLINE double ts_row_beyond(const struct ts_particles *p, const struct ts_pair *pair,
				   const struct ts_rows *rows, size_t r)
{
	size_t i = (size_t)rows->i[r], j = (size_t)rows->j[r];
	double a = p->radius[i], b = p->radius[j];

	return ts_granular_beyond(ts_pair_model(pair, p->type[i], p->type[j]),
				  ts_pair_law(pair, p->type[i], p->type[j]), a * b / (a + b),
				  rows->history + r * rows->history_width);
}

/* Lists the touching ones of the rows from .. to-1; returns how many. `each`: rows have models of their own. */
TS_INLINE size_t
ts_row_find(const struct ts_particles *p, const struct ts_pair *pair, bool each,
	    struct ts_rows *rows, size_t from, size_t to, bool keep, uint32_t *list)
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

/* What the laws need to know of the partners i and j, as far as the model has laws that ask. */
struct ts_row_ends {
	double d[3], v[3]; /* x_i - x_j, v_i - v_j */
	double omega[2][3], radius[2], mass[2];
	double imass; /* 1/m_i + 1/m_j */
};

TS_INLINE void
ts_row_ends(const struct ts_particles *p, size_t i, size_t j, const struct ts_granular_model *m,
	    struct ts_row_ends *e)
{
	for (int c = 0; c < 3; c++) {
		e->d[c] = p->x[i][c] - p->x[j][c];
		e->v[c] = p->v[i][c] - p->v[j][c];
	}
	for (int c = 0; ts_granular_turns(m) && c < 3; c++) {
		e->omega[0][c] = p->omega[i][c];
		e->omega[1][c] = p->omega[j][c];
	}
	e->radius[0] = p->radius[i];
	e->radius[1] = p->radius[j];
	e->mass[0] = p->mass[i];
	e->mass[1] = p->mass[j];
	e->imass = p->imass[i] + p->imass[j];
}

TS_INLINE void ts_ends_touch(const struct ts_row_ends *e,
								const struct ts_granular_model *m,
								struct ts_touch *t)
{
	double distance = sqrt(ts_dot(e->d, e->d));
	/* coincident centres: no direction, no force */
	double inverse = distance > 0 ? 1 / distance : 0;

	t->wall = false;
	t->stiffness = 0; /* not known */
	t->distance = distance;
	t->radius[0] = e->radius[0];
	t->radius[1] = e->radius[1];
	t->overlap = t->radius[0] + t->radius[1] - distance;
	t->r_eff = t->radius[0] * t->radius[1] / (t->radius[0] + t->radius[1]);
	t->m_eff = 1 / e->imass;
	t->mass[0] = e->mass[0];
	t->mass[1] = e->mass[1];
	for (int k = 0; k < 3; k++)
		t->n[k] = e->d[k] * inverse;
	ts_granular_arms(m, t);
	t->vn = ts_dot(e->v, t->n);
	for (int k = 0; k < 3; k++)
		t->slip[k] = t->roll[k] = t->spin[k] = 0;
	if (ts_granular_turns(m))
		ts_touch_motion(t, e->v, e->omega[0], e->omega[1]);
}

TS_INLINE void ts_row_touch(const struct ts_particles *p,
							       size_t i, size_t j,
							       const struct ts_granular_model *m,
							       struct ts_touch *t)
{
	struct ts_row_ends e = { 0 };

	ts_row_ends(p, i, j, m, &e);
	ts_ends_touch(&e, m, t);
}

TS_INLINE void ts_row_store(struct ts_rows *rows, size_t r,
							       const struct ts_granular_model *m,
							       const struct ts_touch *t,
							       const struct ts_granular_force *f)
{
	rows->touching[r] = 1;
	for (int k = 0; k < 3; k++)
		rows->force[r][k] = f->force[k];
	if (!ts_granular_turns(m))
		return;
	rows->force[r][3] = ts_granular_short(m, t);
	for (int k = 0; k < 3; k++) {
		rows->turn[r][k] = f->turn[k];
		if (rows->roll)
			rows->roll[r][k] = f->roll[k];
	}
}

/* `all`: the model of all rows; NULL: each has its own. */
TS_INLINE void ts_row_share(const struct ts_row_task *task,
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
void ts_row_loop(struct tsim *sim, const struct ts_pair *pair, ts_share_fn *share);

#endif
