/* Batches of wall contacts, as contact/contact_batch.h for pairs: the inputs of the contact law are copied
 * into columns, so that a law written for one contact is computed for several contacts at once by vector
 * instructions. All contacts of a batch have the same law. Results equal those of the computation contact
 * by contact, bit for bit. */
#ifndef TS_WALL_WALL_BATCH_H
#define TS_WALL_WALL_BATCH_H

#include "base/four.h"
#include "law/granular_force.h"

/* Inputs of the contact law from particle and wall. */
struct ts_wall_ends {
	double n[3], distance; /* from the surface to the centre of the particle */
	double curvature;      /* of the surface, see struct ts_wall_contact_point */
	double v[3];	       /* velocity of the particle relative to the surface */
	double omega[3], radius, mass;
	double liquid; /* volume of liquid on the particle divided by its own volume */
};

/* R* = R/(1 + R kappa) at a surface of mean curvature kappa. */
TS_INLINE double ts_wall_effective_radius(double radius, double curvature)
{
	return radius / (1 + radius * curvature);
}

/* The wall is the limit of a partner of infinite mass: m* = m. */
TS_INLINE void ts_wall_ends_touch(const struct ts_wall_ends *e, const struct ts_granular_model *m,
				  struct ts_touch *t)
{
	static const double at_rest[3] = { 0 };

	*t = (struct ts_touch){ .wall = true, .distance = e->distance };
	for (int k = 0; k < 3; k++)
		t->n[k] = e->n[k];
	t->radius[0] = e->radius;
	t->r_eff = ts_wall_effective_radius(e->radius, e->curvature);
	t->mass[0] = t->m_eff = e->mass;
	t->liquid[0] = e->liquid;
	t->overlap = e->radius - e->distance;
	ts_granular_arms(m, t);
	ts_touch_motion(t, e->v, e->omega, at_rest);
}

struct ts_wall_batch {
	/* the inputs, see struct ts_wall_ends; the fourth columns: distance, mass, radius */
	double n[4][TS_BATCH], v[4][TS_BATCH], omega[4][TS_BATCH];
	double curvature[TS_BATCH];
	double memory[TS_GRANULAR_MEMORY][TS_BATCH];
	/* the results; the fourth columns: overlap, R*, 0 */
	double force[4][TS_BATCH], torque[4][TS_BATCH], roll[4][TS_BATCH];
} __attribute__((aligned(64)));

/* Computes contacts 0 .. n-1 of a batch for a model, which may be a compile-time constant; dt > 0, and the
 * history is updated. */
typedef void ts_wall_batch_fn(struct ts_wall_batch *b, size_t n, const struct ts_granular_model *m,
			      const struct ts_granular_pair *law, double dt);

/* The vectorised loop for a model; NULL: there is none. */
ts_wall_batch_fn *ts_wall_batch_of(const struct ts_granular_model *model);

TS_INLINE void ts_wall_batch_ends(const struct ts_wall_batch *b, size_t k, struct ts_wall_ends *e)
{
	*e = (struct ts_wall_ends){
		.n = { b->n[0][k], b->n[1][k], b->n[2][k] },
		.distance = b->n[3][k],
		.curvature = b->curvature[k],
		.v = { b->v[0][k], b->v[1][k], b->v[2][k] },
		.omega = { b->omega[0][k], b->omega[1][k], b->omega[2][k] },
		.radius = b->omega[3][k],
		.mass = b->v[3][k],
	};
}

TS_INLINE void ts_wall_batch_contact(struct ts_wall_batch *b, size_t k, const struct ts_granular_model *m,
				     const struct ts_granular_pair *law, double dt)
{
	double memory[TS_GRANULAR_MEMORY];
	struct ts_granular_force f;
	struct ts_wall_ends e;
	struct ts_touch t;

	ts_wall_batch_ends(b, k, &e);
	for (int c = 0; c < ts_granular_memory(m); c++)
		memory[c] = b->memory[c][k];
	ts_wall_ends_touch(&e, m, &t);
	ts_granular_contact(m, law, &t, dt, true, memory, &f);
	for (int c = 0; c < ts_granular_memory(m); c++)
		b->memory[c][k] = memory[c];
	for (int c = 0; c < 3; c++) {
		b->force[c][k] = f.force[c];
		b->torque[c][k] = t.arm[0] * f.turn[c] + f.roll[c];
		b->roll[c][k] = f.roll[c];
	}
	b->force[3][k] = t.overlap;
	b->torque[3][k] = t.r_eff;
	b->roll[3][k] = 0;
}

TS_INLINE void ts_wall_batch_contacts(struct ts_wall_batch *restrict b, size_t n,
				      const struct ts_granular_model *m,
				      const struct ts_granular_pair *restrict law, double dt)
{
	if (!(dt > 0)) /* never true, but tells the compiler that dt > 0 */
		return;
#pragma omp simd
	for (size_t k = 0; k < n; k++)
		ts_wall_batch_contact(b, k, m, law, dt);
}

#endif
