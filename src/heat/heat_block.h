/* Conductances of batches of contacts, computed side by side: inputs are copied into columns, as in
 * contact_batch.h. */
#ifndef TS_HEAT_HEAT_BLOCK_H
#define TS_HEAT_HEAT_BLOCK_H

#include <math.h>

#include "base/four.h"
#include "base/inline.h"
#include "heat/heat.h"
#include "law/conduction.h"
#include "math/constants.h"

/* Inputs of the loops, copied out of the structures so that the compiler knows that stores do not
 * change them. */
struct ts_heat_task {
	const struct ts_heat *h;
	const struct ts_particles *p;
	const struct ts_heat_pairs *pairs;
	int group;
	const double *temperature;
	const double (*x)[3];
	const double *radius;
	const int *type;
	bool keeps; /* store the conductances */
};

/* list 0: contact list, 1: pairs of frozen particles. */
static inline struct ts_heat_task ts_heat_task(const struct ts_instance *self, int list)
{
	const struct ts_heat *h = self->state;
	const struct ts_particles *p = h->sim->particles;

	return (struct ts_heat_task){ h,
				      p,
				      &h->pairs[list],
				      self->group,
				      ts_heat_column(h->sim, h->temperature),
				      (const double(*)[3])p->x,
				      p->radius,
				      p->type,
				      h->keeps };
}

TS_INLINE size_t ts_heat_type_pair(const struct ts_heat_task *t, size_t i, size_t j)
{
	return (size_t)(t->type[i] * (t->h->ntypes + 1) + t->type[j]);
}

/* Contact area, length^2; 0 if the particles are not in contact. */
TS_INLINE double ts_heat_area(const struct ts_heat_task *t, size_t i, size_t j)
{
	double sum = t->radius[i] + t->radius[j], d[3], d2;

	for (int k = 0; k < 3; k++)
		d[k] = t->x[i][k] - t->x[j][k];
	d2 = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
	return d2 < sum * sum
		       ? ts_heat_area_of_spheres(&t->h->contact, sqrt(d2), t->radius[i], t->radius[j],
						 t->h->softening ? t->h->softening[ts_heat_type_pair(t, i, j)]
								 : 1)
		       : 0;
}

/* A batch of pairs, padded to whole vectors with copies of the last one. */
struct ts_heat_block {
	double d[4][TS_BATCH], other[TS_BATCH]; /* d: vector from j to i, radius of i; other: radius of j */
	double pair[TS_BATCH], softening[TS_BATCH]; /* constants of the pair of types */
	double h[TS_BATCH], rise[TS_BATCH];	    /* conductance h; temperature difference T_j - T_i */
	double flow[4][TS_BATCH];
	const struct ts_active_pair *near; /* the pairs, n */
	size_t n, whole;
	struct ts_active_pair tail[8]; /* the last incomplete vector, padded */
} __attribute__((aligned(64)));

TS_INLINE const struct ts_active_pair *ts_heat_batch_pair(const struct ts_heat_block *b, size_t k)
{
	size_t full = b->n & ~(size_t)7;

	return k < full ? &b->near[k] : &b->tail[k - full];
}

/* Starts a batch with the pairs near[0 .. n-1], n at least 1. */
TS_INLINE void ts_heat_batch_start(struct ts_heat_block *b, const struct ts_active_pair *near, size_t n)
{
	size_t full = n & ~(size_t)7;

	b->near = near;
	b->n = n;
	b->whole = (n + 7) & ~(size_t)7;
	for (size_t k = full; k < b->whole; k++)
		b->tail[k - full] = near[k < n ? k : n - 1];
}

/* Sets the constants of pair k of the batch from its pair of types. */
TS_INLINE void ts_heat_batch_constants(const struct ts_heat_task *t, size_t types, struct ts_heat_block *b,
				       size_t k)
{
	b->pair[k] = t->h->pair[types];
	b->softening[k] = t->h->softening ? t->h->softening[types] : 1;
}

/* Loads distances, radii and temperatures; `placed`: the packed positions of the contact list are those
 * of this step. */
TS_INLINE void ts_heat_batch_load(const struct ts_heat_task *t, bool placed, struct ts_heat_block *b)
{
	const struct ts_contact_sphere *sphere = t->pairs->rows->sphere;

	for (size_t at = 0; at < b->whole; at += 4) {
		const struct ts_active_pair *near = ts_heat_batch_pair(b, at);
		ts_four d[4];

		for (size_t k = 0; k < 4; k++) {
			size_t i = (size_t)near[k].i, j = (size_t)near[k].j;

			if (placed) {
				const ts_four *place = (const ts_four *)sphere[i].position;

				d[k] = TS_FOUR_LAST(*place - *(const ts_four *)sphere[j].position, *place);
			} else {
				d[k] = TS_FOUR_LOAD(t->x[i]) - TS_FOUR_LOAD(t->x[j]);
				d[k][3] = t->radius[i];
			}
			b->other[at + k] = placed ? sphere[j].position[3] : t->radius[j];
			b->rise[at + k] = t->temperature[j] - t->temperature[i];
		}
		ts_four_columns(d, b->d, at);
	}
}

/* Conductances for the circle of intersection, in a loop without branches; the same bits as
 * ts_heat_area. */
TS_INLINE void ts_heat_batch_overlaps(struct ts_heat_block *b)
{
#pragma omp simd
	for (size_t k = 0; k < b->whole; k++) {
		double ri = b->d[3][k], rj = b->other[k], sum = ri + rj;
		double square = b->d[0][k] * b->d[0][k] + b->d[1][k] * b->d[1][k] + b->d[2][k] * b->d[2][k];
		double distance = sum - b->softening[k] * (sum - sqrt(square));
		double larger = ri > rj ? ri : rj, smaller = ri > rj ? rj : ri;
		double lens = ts_lens_of_spheres(distance, ri, rj);
		double area = distance < larger ? TS_PI * smaller * smaller : lens;

		area = square < sum * sum ? area : 0;
		b->h[k] = ts_heat_conductance(b->pair[k], area > 0 ? area : 0);
	}
}

/* Whether a partner is in the group: only its temperature changes, but it exchanges heat with all
 * particles. */
TS_INLINE bool ts_heat_any_in_group(const struct ts_heat_task *t, const struct ts_active_pair *near)
{
	return ts_in_group(t->p, (size_t)near->i, t->group) || ts_in_group(t->p, (size_t)near->j, t->group);
}

TS_INLINE void ts_heat_batch_conductances(const struct ts_heat_task *t, struct ts_heat_block *b)
{
	if (t->h->contact.kind == TS_HEAT_OVERLAP) {
		ts_heat_batch_overlaps(b);
	} else {
		for (size_t k = 0; k < b->whole; k++) {
			const struct ts_active_pair *row = ts_heat_batch_pair(b, k);

			b->h[k] = ts_heat_conductance(b->pair[k],
						      ts_heat_area(t, (size_t)row->i, (size_t)row->j));
		}
	}
	for (size_t k = 0; k < b->whole && t->group; k++)
		b->h[k] = ts_heat_any_in_group(t, ts_heat_batch_pair(b, k)) ? b->h[k] : 0;
	for (size_t k = 0; k < b->n && t->keeps; k++)
		t->pairs->conductance[b->near[k].row] = b->h[k];
}

/* Called for each batch once its conductances are known. */
typedef void ts_heat_block_fn(const struct ts_heat_task *t, struct ts_heat_block *b);

/* Computes the pairs from .. to-1 of a list, in contact or not; the slot of a pair is its index. */
TS_INLINE void ts_heat_compute_range(const struct ts_heat_task *t, size_t from, size_t to,
				     ts_heat_block_fn *then)
{
	const struct ts_contact_list *rows = t->pairs->rows;
	struct ts_active_pair near[TS_BATCH];
	struct ts_heat_block b;

	for (size_t n; from < to; from += n) {
		n = to - from < TS_BATCH ? to - from : TS_BATCH;
		for (size_t k = 0; k < n; k++)
			near[k] = (struct ts_active_pair){ (uint32_t)(from + k), (uint32_t)(from + k),
							   rows->i[from + k], rows->j[from + k] };
		ts_heat_batch_start(&b, near, n);
		for (size_t k = 0; k < b.whole; k++) {
			const struct ts_active_pair *row = ts_heat_batch_pair(&b, k);

			ts_heat_batch_constants(t, ts_heat_type_pair(t, (size_t)row->i, (size_t)row->j), &b,
						k);
		}
		ts_heat_batch_load(t, false, &b);
		ts_heat_batch_conductances(t, &b);
		if (then)
			then(t, &b);
	}
}

#endif
