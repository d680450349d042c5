/* Contact laws in stages: normal force, cohesion, tangential force, rolling, twisting. Each law is a loop of
 * its own over columns of contacts, and any law of one stage can follow any of the stage before. So all
 * combinations of laws are vectorised, though only the most frequent ones have one loop for the whole law
 * (granular_models.h). The results are those of ts_granular_contact for single contacts, bit for bit. */
#ifndef TS_CONTACT_LAW_STAGES_H
#define TS_CONTACT_LAW_STAGES_H

#include "base/four.h"
#include "law/granular_force.h"

/* Columns of contacts of one law; quantities and units as in struct ts_touch, ts_normal and
 * ts_granular_force. */
struct ts_stages {
	/* inputs */
	const double *radius[2], *mass[2]; /* of i and j; at a wall [1] is not read */
	double *const *memory;		   /* history columns, which the stages advance */
	/* 0: does not touch, the history stays; else all bits are set. With sub-step detection those of contacts that
	 * begin or end are cleared if `postpones`: they are to be computed later, with others. */
	long long *touch;
	bool wall, postpones;

	/* geometry and kinematics of the contacts: ts_stages_store_touch */
	double n[3][TS_BATCH], distance[TS_BATCH], overlap[TS_BATCH], r_eff[TS_BATCH], m_eff[TS_BATCH];
	double less[TS_BATCH]; /* radius - lever arm: ts_granular_arm_reduction */
	double vn[TS_BATCH], slip[3][TS_BATCH], roll[3][TS_BATCH], spin[3][TS_BATCH];

	/* results of a stage that later ones read */
	double solved[TS_BATCH];
	double kn[TS_BATCH], kt[TS_BATCH], gamman[TS_BATCH], gammat[TS_BATCH], area[TS_BATCH];
	double normal[TS_BATCH], limit[TS_BATCH];
	double tangential[3][TS_BATCH], rolling[3][TS_BATCH], twist[TS_BATCH];
} __attribute__((aligned(64)));

/* Whether all laws of the model have stages: not so with restitution by the Stokes number, `surface multicontact` or
 * liquid bridges. */
bool ts_stages_for(const struct ts_granular_model *m);

/* Computes contacts 0 .. n-1, n a multiple of the vector length; dt > 0. */
void ts_stages_compute(struct ts_stages *s, size_t n, const struct ts_granular_model *m,
		       const struct ts_granular_pair *law, double dt);

TS_INLINE void ts_stages_store_touch(struct ts_stages *s, size_t k, const struct ts_granular_model *m,
				     const struct ts_touch *t)
{
	for (int c = 0; c < 3; c++) {
		s->n[c][k] = t->n[c];
		s->slip[c][k] = t->slip[c];
		s->roll[c][k] = t->roll[c];
		s->spin[c][k] = t->spin[c];
	}
	s->distance[k] = t->distance;
	s->overlap[k] = t->overlap;
	s->r_eff[k] = t->r_eff;
	s->m_eff[k] = t->m_eff;
	s->vn[k] = t->vn;
	s->less[k] = ts_granular_arm_reduction(m, t);
}

/* Force and torques of contact k; f->normal is not set. */
TS_INLINE void ts_stages_force(const struct ts_stages *s, size_t k, bool twists, struct ts_granular_force *f)
{
	const double tangential[3] = { s->tangential[0][k], s->tangential[1][k], s->tangential[2][k] };
	const double n[3] = { s->n[0][k], s->n[1][k], s->n[2][k] };

	ts_cross(tangential, n, f->turn);
	for (int c = 0; c < 3; c++) {
		f->force[c] = s->normal[k] * n[c] + tangential[c];
		f->roll[c] = -s->rolling[c][k];
		if (twists)
			f->roll[c] += s->twist[k] * n[c];
	}
}

/* The loops before and after the laws, for a file that defines touch_at(b, s, k, m), which calls
 * ts_stages_store_touch, and finish_at(b, s, k, twists), which calls ts_stages_force. The convention for
 * lever arms is a constant of each loop. */
#define TS_STAGES_TOUCH(batch, name, arms, slips)                                                    \
	TS_CLONES static void name(struct batch *restrict b, struct ts_stages *restrict s, size_t n) \
	{                                                                                            \
		const struct ts_granular_model m = { .tangential = TS_TANGENTIAL_HISTORY,            \
						     .full_arms = (arms),                            \
						     .full_slip = (slips) };                         \
                                                                                                     \
		_Pragma("omp simd") for (size_t k = 0; k < n; k++) touch_at(b, s, k, &m);            \
	}
#define TS_STAGES_FINISH(batch, name, twists)                                                        \
	TS_CLONES static void name(struct batch *restrict b, struct ts_stages *restrict s, size_t n) \
	{                                                                                            \
		_Pragma("omp simd") for (size_t k = 0; k < n; k++) finish_at(b, s, k, twists);       \
	}
#define TS_STAGES_LOOPS(batch)                                                                     \
	TS_STAGES_TOUCH(batch, touch, false, false)                                                \
	TS_STAGES_TOUCH(batch, touch_full_slip, false, true)                                       \
	TS_STAGES_TOUCH(batch, touch_full_arms, true, false)                                       \
	TS_STAGES_TOUCH(batch, touch_full, true, true)                                             \
	TS_STAGES_FINISH(batch, finish, false)                                                     \
	TS_STAGES_FINISH(batch, finish_twist, true)                                                \
	static void (*const touches[2][2])(struct batch *restrict b, struct ts_stages *restrict s, \
					   size_t n) = { { touch, touch_full_slip },               \
							 { touch_full_arms, touch_full } };

#endif
