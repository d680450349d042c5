/* The whole contact: normal, cohesion, tangential, rolling, in this order. With a constant model
 * the compiler keeps only what the model has. */
#ifndef TS_LAW_GRANULAR_FORCE_H
#define TS_LAW_GRANULAR_FORCE_H

#include "law/cohesion.h"
#include "law/rolling.h"
#include "law/substep.h"
#include "law/tangential.h"
#include "law/twisting.h"

/* What acts on i; on j: -force, arm_j * turn, -roll. */
struct ts_granular_force {
	double force[3];
	double turn[3]; /* -n x F_t: times the arm of a partner its torque by the tangential force
			 */
	double roll[3]; /* torque of rolling friction on i */
	double normal;	/* F_n, with cohesion */
};

TS_INLINE bool ts_granular_turns(const struct ts_granular_model *m)
{
	return m->tangential != TS_TANGENTIAL_OFF || m->rolling != TS_ROLLING_OFF ||
	       m->twisting != TS_TWISTING_OFF || ts_cohesion_bridges(m);
}

/* Whether contacts make torques that are opposite: of rolling, of twisting. */
TS_INLINE bool ts_granular_rolls(const struct ts_granular_model *m)
{
	return m->rolling != TS_ROLLING_OFF || m->twisting != TS_TWISTING_OFF;
}

/* Whether laws ask for the masses one by one. */
TS_INLINE bool ts_granular_weighs(const struct ts_granular_model *m)
{
	return m->rolling > TS_ROLLING_CDT && m->rolling < TS_ROLLING_SDS;
}

/* Whether surfaces pull beyond their touch: those that stick, once they have met, or bridges of liquid. */
TS_INLINE bool ts_granular_reaches(const struct ts_granular_model *m)
{
	return ts_normal_sticks(m) || ts_cohesion_bridges(m);
}

/* By how much the arms of the contact fall short of the radii; then the arms. */
TS_INLINE double ts_granular_short(const struct ts_granular_model *m, const struct ts_touch *t)
{
	if (m->multi) /* surfaces that stand out meet at the same place */
		return m->full_arms ? 0 : 0.5 * (t->overlap - t->bulge);
	if (ts_cohesion_bridges(m) && !(t->overlap > 0))
		return 0;
	return m->full_arms ? 0 : 0.5 * t->overlap;
}

TS_INLINE void ts_granular_arms(const struct ts_granular_model *m, struct ts_touch *t)
{
	double less = ts_granular_short(m, t);

	t->arm[0] = t->radius[0] - less;
	t->arm[1] = t->wall ? 0 : t->radius[1] - less;
	t->lever[0] = m->full_slip ? t->radius[0] : t->arm[0];
	t->lever[1] = m->full_slip ? t->radius[1] : t->arm[1];
}

/* The memory of a contact: where each law keeps its part, and how many numbers in all. First the vectors. */
TS_INLINE int ts_granular_rolling_at(const struct ts_granular_model *m)
{
	return m->wide || ts_tangential_remembers(m) ? 3 : 0;
}

/* Overlap of hysteresis. */
TS_INLINE int ts_granular_depth_at(const struct ts_granular_model *m)
{
	return ts_granular_rolling_at(m) + (m->wide || m->rolling > TS_ROLLING_CDT ? 3 : 0);
}

/* Angle of twisting. */
TS_INLINE int ts_granular_twist_at(const struct ts_granular_model *m)
{
	return ts_granular_depth_at(m) + (m->normal == TS_NORMAL_HOOKE_HYSTERESIS);
}

/* Radius of the contact area in the last step. */
TS_INLINE int ts_granular_area_at(const struct ts_granular_model *m)
{
	return ts_granular_twist_at(m) + (m->wide || m->twisting != TS_TWISTING_OFF);
}

/* Whether surfaces have met that pull beyond their touch then. */
TS_INLINE int ts_granular_met_at(const struct ts_granular_model *m)
{
	return ts_granular_area_at(m) + (m->wide || ts_tangential_rescales(m));
}

/* What contacts that are located remember: law/substep.h. */
static inline int ts_granular_located_at(const struct ts_granular_model *m)
{
	return ts_granular_met_at(m) + (m->wide || ts_granular_reaches(m));
}

/* What contacts remember that others of the same grain know of; they are not located. */
enum {
	TS_MULTI_FORCE, /* F_n in the last step */
	TS_MULTI_BULGE, /* by how much the surfaces stand out; R* with that, of each radius its own part */
	TS_MULTI_RADIUS,
	TS_MULTI_ARM, /* n times the distance */
	TS_MULTI_MEMORY = TS_MULTI_ARM + 3
};
static inline int ts_granular_multi_at(const struct ts_granular_model *m)
{
	return ts_granular_located_at(m) + ts_substep_memory(m);
}

/* The surfaces stand out as the contact remembers it. */
static inline void ts_granular_stand_out(const struct ts_granular_model *m, const double *memory,
					 struct ts_touch *t)
{
	if (!m->multi || !memory)
		return;
	t->bulge = memory[ts_granular_multi_at(m) + TS_MULTI_BULGE];
	t->overlap += t->bulge;
	t->r_eff = memory[ts_granular_multi_at(m) + TS_MULTI_RADIUS];
}

static inline void ts_granular_note_load(const struct ts_granular_model *m, const struct ts_touch *t,
					 double force, double *memory)
{
	double *own = memory + ts_granular_multi_at(m);

	own[TS_MULTI_FORCE] = force;
	for (int k = 0; k < 3; k++)
		own[TS_MULTI_ARM + k] = t->distance * t->n[k];
}

enum { TS_GRANULAR_MEMORY = 9 + TS_LOCATED_MEMORY }; /* at most */
_Static_assert((int)TS_MULTI_MEMORY <= (int)TS_LOCATED_MEMORY, "models with `multi` are not located");
static inline int ts_granular_memory(const struct ts_granular_model *m)
{
	return ts_granular_multi_at(m) + (m->multi ? TS_MULTI_MEMORY : 0);
}

/* What changes sign when i and j change places: slip, and torques of rolling. The way that sds has rolled,
 * w x n, does not. */
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

/* The distance at which a contact ends, less the sum of the radii: > 0 for surfaces that stick and have
 * met. */
TS_INLINE double ts_granular_beyond(const struct ts_granular_model *m, const struct ts_granular_pair *c,
				    double r_eff, const double *memory)
{
	if (!ts_normal_sticks(m) || !(memory[ts_granular_met_at(m)] > 0))
		return 0;
	return ts_jkr_reach(c, r_eff);
}

/* The same of bridges: easo's are made where surfaces touch, washino's wherever they are near enough. */
TS_INLINE double ts_granular_bridged(const struct ts_granular_model *m, const struct ts_granular_pair *c,
				     const double liquid[2], const double radius[2], bool wall,
				     const double *memory)
{
	if (m->cohesion == TS_COHESION_EASO && !(memory[ts_granular_met_at(m)] > 0))
		return 0;
	return ts_bridge_reach(m, c, liquid, radius, wall);
}

/* The normal force and the slip, as of the time of the positions, of a contact that is located. */
static inline void ts_granular_locate(const struct ts_granular_model *m, const struct ts_touch *t, double dt,
				      bool advance, double *memory, struct ts_normal *n, struct ts_touch *now)
{
	double *own = memory + ts_granular_located_at(m), stage = own[TS_LOCATED_STAGE];
	struct ts_substep l = ts_substep_force(m, t, dt, advance, own, n);

	*now = *t;
	if (m->tangential != TS_TANGENTIAL_OFF)
		ts_substep_slip(m, n, &l, stage, ts_tangential_remembers(m), advance ? dt : 0, own, memory,
				now);
}

/* A bridge between surfaces that do not touch: springs are gone. */
TS_INLINE void ts_granular_bridge(const struct ts_granular_model *m, const struct ts_granular_pair *c,
				  const struct ts_touch *t, double *memory, struct ts_granular_force *out)
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

/* `dt`: the time step; `advance`: false in the set-up of a run, when memory stands still. */
TS_INLINE void ts_granular_contact(const struct ts_granular_model *m, const struct ts_granular_pair *c,
				   const struct ts_touch *t, double dt, bool advance, double *memory,
				   struct ts_granular_force *out)
{
	struct ts_normal n;
	struct ts_touch now;
	const double *slip = t->slip; /* as the velocities have it */
	double tangential[3], roll[3], pull, twist;

	if (ts_cohesion_bridges(m) && !(t->overlap > 0)) {
		ts_granular_bridge(m, c, t, memory, out);
		return;
	}
	ts_normal_force(m, c, t, advance, memory + ts_granular_depth_at(m), &n);
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
		ts_substep_slips(m, t, slip, advance ? dt : 0.5 * dt, tangential,
				 memory + ts_granular_located_at(m));
	ts_rolling_torque(m, c, t, &n, dt, advance, memory + ts_granular_rolling_at(m), roll);
	twist = ts_twisting_torque(m, c, t, &n, advance ? dt : 0, memory + ts_granular_twist_at(m));
	if (ts_granular_reaches(m))
		memory[ts_granular_met_at(m)] = 1;
	if (m->multi && advance)
		ts_granular_note_load(m, t, out->normal, memory);
	ts_cross(tangential, t->n, out->turn);
	for (int k = 0; k < 3; k++) {
		out->force[k] = out->normal * t->n[k] + tangential[k];
		out->roll[k] = -roll[k];
		if (m->twisting != TS_TWISTING_OFF)
			out->roll[k] += twist * t->n[k];
	}
}

#endif
