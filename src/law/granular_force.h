/* The complete contact force: normal, cohesion, tangential, rolling, twisting. With a constant model
 * the compiler keeps only the laws of that model. */
#ifndef TS_LAW_GRANULAR_FORCE_H
#define TS_LAW_GRANULAR_FORCE_H

#include "law/cohesion.h"
#include "law/rolling.h"
#include "law/substep.h"
#include "law/tangential.h"
#include "law/twisting.h"

/* Force and torques on i; on j: -force, arm_j * turn, -roll. */
struct ts_granular_force {
	double force[3];
	/* -n x F_t: the torque of the tangential force on a partner is this times its lever arm */
	double turn[3];
	double roll[3]; /* torque of rolling and twisting friction on i */
	double normal;	/* F_n including cohesion */
};

/* Whether contacts have torques; `wide`: those of other types may have them. */
TS_INLINE bool ts_granular_turns(const struct ts_granular_model *m)
{
	return m->wide || m->tangential != TS_TANGENTIAL_OFF || m->rolling != TS_ROLLING_OFF ||
	       m->twisting != TS_TWISTING_OFF || ts_cohesion_bridges(m);
}

/* Whether contacts have torques of rolling or twisting friction, which are opposite on both partners. */
TS_INLINE bool ts_granular_rolls(const struct ts_granular_model *m)
{
	return m->wide || m->rolling != TS_ROLLING_OFF || m->twisting != TS_TWISTING_OFF;
}

/* Whether a law needs the two masses, not only m*. */
TS_INLINE bool ts_granular_needs_masses(const struct ts_granular_model *m)
{
	return m->rolling > TS_ROLLING_CDT && m->rolling < TS_ROLLING_SDS;
}

/* Whether contacts attract beyond touch: adhesive surfaces after their first contact, or liquid
 * bridges. */
TS_INLINE bool ts_granular_reaches(const struct ts_granular_model *m)
{
	return ts_normal_sticks(m) || ts_cohesion_bridges(m);
}

/* Difference between the radii and the lever arms of the contact. */
TS_INLINE double ts_granular_arm_reduction(const struct ts_granular_model *m, const struct ts_touch *t)
{
	if (m->multi) /* displaced surfaces meet at the same point */
		return m->full_arms ? 0 : 0.5 * (t->overlap - t->bulge);
	if (ts_cohesion_bridges(m) && !(t->overlap > 0))
		return 0;
	return m->full_arms ? 0 : 0.5 * t->overlap;
}

TS_INLINE void ts_granular_arms(const struct ts_granular_model *m, struct ts_touch *t)
{
	double less = ts_granular_arm_reduction(m, t);

	t->arm[0] = t->radius[0] - less;
	t->arm[1] = t->wall ? 0 : t->radius[1] - less;
	t->lever[0] = m->full_slip ? t->radius[0] : t->arm[0];
	t->lever[1] = m->full_slip ? t->radius[1] : t->arm[1];
}

/* The history of a contact: the offset of the part of each law, and the total size. Vectors come first. */
TS_INLINE int ts_granular_rolling_at(const struct ts_granular_model *m)
{
	return m->wide || ts_tangential_remembers(m) ? 3 : 0;
}

/* Offset of the history of the normal law. */
TS_INLINE int ts_granular_depth_at(const struct ts_granular_model *m)
{
	return ts_granular_rolling_at(m) + (m->wide || m->rolling > TS_ROLLING_CDT ? 3 : 0);
}

/* The history of the normal law, of the contact whose history is `memory`; zeros where the law keeps none. */
static inline void ts_granular_normal_memory(const struct ts_granular_model *m, const double *memory,
					     double own[TS_NORMAL_MEMORY])
{
	for (int k = 0; k < TS_NORMAL_MEMORY; k++)
		own[k] = k < ts_normal_memory(m) ? memory[ts_granular_depth_at(m) + k] : 0;
}

/* Offset of the twisting angle. */
TS_INLINE int ts_granular_twist_at(const struct ts_granular_model *m)
{
	return ts_granular_depth_at(m) + ts_normal_memory(m);
}

/* Offset of the radius of the contact area in the last step. */
TS_INLINE int ts_granular_area_at(const struct ts_granular_model *m)
{
	return ts_granular_twist_at(m) + (m->wide || m->twisting != TS_TWISTING_OFF);
}

/* Offset of the flag that surfaces have been in contact, for laws that attract beyond touch. */
TS_INLINE int ts_granular_met_at(const struct ts_granular_model *m)
{
	return ts_granular_area_at(m) + (m->wide || ts_tangential_rescales(m));
}

/* Offset of the data of sub-step contact detection: law/substep.h. */
static inline int ts_granular_located_at(const struct ts_granular_model *m)
{
	return ts_granular_met_at(m) + (m->wide || ts_granular_reaches(m));
}

/* History of the multi-contact model; not available with sub-step detection. */
enum {
	TS_MULTI_FORCE, /* F_n in the last step */
	TS_MULTI_BULGE, /* displacement of the surfaces; R* including it, each radius with its own part */
	TS_MULTI_RADIUS,
	TS_MULTI_ARM, /* n times the distance of the centres */
	TS_MULTI_MEMORY = TS_MULTI_ARM + 3
};
static inline int ts_granular_multi_at(const struct ts_granular_model *m)
{
	return ts_granular_located_at(m) + (m->multi ? 0 : ts_substep_memory(m));
}

/* Applies the surface displacement that is stored in the history. */
static inline void ts_granular_add_bulge(const struct ts_granular_model *m, const double *memory,
					 struct ts_touch *t)
{
	if (!m->multi || !memory)
		return;
	t->bulge = memory[ts_granular_multi_at(m) + TS_MULTI_BULGE];
	t->overlap += t->bulge;
	t->r_eff = memory[ts_granular_multi_at(m) + TS_MULTI_RADIUS];
}

static inline void ts_granular_store_load(const struct ts_granular_model *m, const struct ts_touch *t,
					  double force, double *memory)
{
	double *own = memory + ts_granular_multi_at(m);

	own[TS_MULTI_FORCE] = force;
	for (int k = 0; k < 3; k++)
		own[TS_MULTI_ARM + k] = t->distance * t->n[k];
}

enum { TS_GRANULAR_MEMORY = 9 + TS_LOCATED_MEMORY }; /* upper bound */
_Static_assert((int)TS_MULTI_MEMORY <= (int)TS_LOCATED_MEMORY, "models with `multi` are not located");
static inline int ts_granular_memory(const struct ts_granular_model *m)
{
	return ts_granular_multi_at(m) + (m->multi ? TS_MULTI_MEMORY : 0);
}

/* Signs by which the history is multiplied when i and j are swapped: tangential springs and rolling
 * torques change sign; the rolling displacement of sds, w x n, does not. */
TS_INLINE void ts_granular_memory_signs(const struct ts_granular_model *m, signed char sign[])
{
	bool turns = !m->wide && m->rolling != TS_ROLLING_SDS;
	int odd = turns ? ts_granular_depth_at(m) : ts_granular_rolling_at(m);

	for (int k = 0; k < TS_GRANULAR_MEMORY; k++)
		sign[k] = k < odd ? -1 : 1;
	for (int k = 0; k < 3 && ts_substep_memory(m) > TS_LOCATED_SLIP; k++)
		sign[ts_granular_located_at(m) + TS_LOCATED_SLIP + k] = -1;
	for (int k = 0; k < 3 && m->multi; k++)
		sign[ts_granular_multi_at(m) + TS_MULTI_ARM + k] = -1;
}

/* Gap at which a contact ends: > 0 for adhesive surfaces that have been in contact. */
TS_INLINE double ts_granular_pull_off_reach(const struct ts_granular_model *m,
					    const struct ts_granular_pair *c, double r_eff,
					    const double *memory)
{
	if (!ts_normal_sticks(m) || !(memory[ts_granular_met_at(m)] > 0))
		return 0;
	return ts_jkr_reach(c, r_eff);
}

/* The same for liquid bridges: those of easo form at contact, those of washino whenever the gap is
 * small enough. */
TS_INLINE double ts_granular_bridge_reach(const struct ts_granular_model *m, const struct ts_granular_pair *c,
					  const double liquid[2], const double radius[2], bool wall,
					  const double *memory)
{
	if (m->cohesion == TS_COHESION_EASO && !(memory[ts_granular_met_at(m)] > 0))
		return 0;
	return ts_bridge_reach(m, c, liquid, radius, wall);
}

/* Normal force and slip velocity at the time of the positions, with sub-step contact detection. */
static inline void ts_granular_locate(const struct ts_granular_model *m, const struct ts_touch *t, double dt,
				      bool advance, double *memory, struct ts_normal *n, struct ts_touch *now)
{
	double *own = memory + ts_granular_located_at(m), stage = own[TS_LOCATED_STAGE];
	struct ts_substep l = ts_substep_force(m, t, dt, advance, own, n);

	*now = *t;
	if (m->tangential != TS_TANGENTIAL_OFF)
		ts_substep_advance_slip(m, n, &l, stage, ts_tangential_remembers(m), advance ? dt : 0, own,
					memory, now);
}

/* A liquid bridge between surfaces that are not in contact: all springs are reset. */
TS_INLINE void ts_granular_bridge_contact(const struct ts_granular_model *m, const struct ts_granular_pair *c,
					  const struct ts_touch *t, double *memory,
					  struct ts_granular_force *out)
{
	double tangential[3] = { 0 };

	for (int k = 0; k < ts_granular_memory(m); k++)
		memory[k] = k == ts_granular_met_at(m) ? 1 : 0;
	out->normal = ts_cohesion_force(m, c, t);
	ts_bridge_slip(c, t, tangential);
	ts_cross(tangential, t->n, out->turn);
	for (int k = 0; k < 3; k++) {
		out->force[k] = out->normal * t->n[k] + tangential[k];
		out->roll[k] = 0;
	}
}

/* Force of a contact. `dt`: the time step; `advance`: false in the set-up of a run, when the history
 * does not change, but for the largest overlap, which depends on positions only. */
TS_INLINE void ts_granular_contact(const struct ts_granular_model *m, const struct ts_granular_pair *c,
				   const struct ts_touch *t, double dt, bool advance, double *memory,
				   struct ts_granular_force *out)
{
	struct ts_normal n;
	struct ts_touch now;
	const double *slip = t->slip; /* slip velocity of the given velocities */
	double tangential[3], roll[3], pull, twist;

	if (ts_cohesion_bridges(m) && !(t->overlap > 0)) {
		ts_granular_bridge_contact(m, c, t, memory, out);
		return;
	}
	ts_normal_force(m, c, t, memory + ts_granular_depth_at(m), &n);
	if (m->located) {
		ts_granular_locate(m, t, dt, advance, memory, &n, &now);
		t = &now;
	}
	pull = ts_cohesion_force(m, c, t);
	out->normal = n.force + pull;
	if (m->reduce)
		n.limit += pull;
	ts_tangential_force(m, c, t, &n, advance ? dt : 0, memory, memory + ts_granular_area_at(m),
			    tangential);
	if (ts_cohesion_bridges(m))
		ts_bridge_slip(c, t, tangential);
	if (m->located && m->tangential != TS_TANGENTIAL_OFF)
		ts_substep_store_slip_target(m, t, slip, advance ? dt : 0.5 * dt, tangential,
					     memory + ts_granular_located_at(m));
	ts_rolling_torque(m, c, t, &n, dt, advance, memory + ts_granular_rolling_at(m), roll);
	twist = ts_twisting_torque(m, c, t, &n, advance ? dt : 0, memory + ts_granular_twist_at(m));
	if (ts_granular_reaches(m))
		memory[ts_granular_met_at(m)] = 1;
	if (m->multi && advance)
		ts_granular_store_load(m, t, out->normal, memory);
	ts_cross(tangential, t->n, out->turn);
	for (int k = 0; k < 3; k++) {
		out->force[k] = out->normal * t->n[k] + tangential[k];
		out->roll[k] = -roll[k];
		if (m->twisting != TS_TWISTING_OFF)
			out->roll[k] += twist * t->n[k];
	}
}

#endif
