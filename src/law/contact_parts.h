/* Parts of a contact force by cause, and the elastic energy of its springs. The force is that of
 * law/granular_force.h, split after its computation with the contact history at that time:
 *
 *   normal    F_e n: spring and cohesion, without the dependence on velocity
 *   dashpot   the remaining normal force: -gamma_n v_n, or less if no_tension limits it
 *   shear     the tangential spring, -k_t xi; the part of its work that is not stored is dissipated by
 *             slip
 *   viscous   the remaining tangential force
 *   slip      the remaining tangential force at the Coulomb limit mu |F_n|, if the limit applies to
 *             spring and dashpot together
 *   rolling   the torques of rolling and twisting friction
 *
 * hooke/hysteresis stores the energy that it returns on unloading to zero force, F_e^2/(2 k_2). */
#ifndef TS_LAW_CONTACT_PARTS_H
#define TS_LAW_CONTACT_PARTS_H

#include "law/elastic_energy.h"

enum ts_contact_part {
	TS_PART_NORMAL,
	TS_PART_DASHPOT,
	TS_PART_SHEAR,
	TS_PART_VISCOUS,
	TS_PART_SLIP,
	TS_PART_ROLLING,
	TS_NPART
};
enum ts_contact_store { TS_STORE_NORMAL, TS_STORE_SHEAR, TS_STORE_ROLLING, TS_NCONTACT_STORE };

struct ts_contact_parts {
	double force[TS_NPART][3]; /* on i; the opposite on j */
	double turn[TS_NPART][3];  /* the torque on a partner is this times its lever arm */
	double roll[3];		   /* torque on i; the opposite on j */
	double energy[TS_NCONTACT_STORE];
};

/* Elastic energy with the unloading stiffness k_2 at the largest overlap so far. */
static inline double ts_hysteretic_energy(const struct ts_granular_pair *c, const struct ts_touch *t,
					  double k1, double elastic, double deepest)
{
	double k2max = c->unloading * k1;
	double depth = k2max / (k2max - k1) * c->plasticity * 2 * t->r_eff;
	double k2 = deepest >= depth ? k2max : k1 + (k2max - k1) * deepest / depth;

	return k2 > 0 ? 0.5 * elastic * elastic / k2 : 0;
}

static inline void ts_parts_normal(const struct ts_granular_model *m, const struct ts_granular_pair *c,
				   const struct ts_touch *t, const double *memory, double force,
				   struct ts_contact_parts *out)
{
	struct ts_granular_model at_rest = *m;
	struct ts_touch still = *t;
	struct ts_normal n;
	double own[TS_NORMAL_MEMORY], elastic, pull;

	still.vn = 0;
	pull = ts_cohesion_force(m, c, &still);
	at_rest.viscous = false; /* belongs to the dashpot */
	ts_granular_normal_memory(m, memory, own);
	ts_normal_force(&at_rest, c, &still, own, &n);
	elastic = n.force;
	ts_scale(elastic + pull, t->n, out->force[TS_PART_NORMAL]);
	ts_scale(force - elastic - pull, t->n, out->force[TS_PART_DASHPOT]);
	out->energy[TS_STORE_NORMAL] =
		ts_cohesion_energy(m, c, t) + (m->normal == TS_NORMAL_HOOKE_HYSTERESIS
						       ? ts_hysteretic_energy(c, t, n.kn, elastic, own[0])
						       : ts_normal_energy(m, c, t, &n));
	out->energy[TS_STORE_SHEAR] = ts_tangential_energy(m, c, &n, memory);
	out->energy[TS_STORE_ROLLING] = ts_turning_energy(m, c, t, &n, memory);
}

/* Force of the tangential spring. */
static inline void ts_parts_spring(const struct ts_granular_model *m, const struct ts_granular_pair *c,
				   const struct ts_normal *n, const double *memory, double force[3])
{
	struct ts_slider slider = ts_tangential_slider_of(m, c, n);

	if (ts_tangential_remembers(m))
		ts_scale(ts_slider_factor(&slider), memory, force);
}

/* Splits the force `total` on i and its rolling torque `roll`; `memory`: the contact history after the
 * force computation. */
static inline void ts_contact_split(const struct ts_granular_model *m, const struct ts_granular_pair *c,
				    const struct ts_touch *t, const double *memory, const double total[3],
				    const double roll[3], struct ts_contact_parts *out)
{
	double normal = ts_dot(total, t->n), own[TS_NORMAL_MEMORY], limit, friction[3];
	struct ts_normal n;

	*out = (struct ts_contact_parts){ .roll = { roll[0], roll[1], roll[2] } };
	ts_parts_normal(m, c, t, memory, normal, out);
	ts_granular_normal_memory(m, memory, own);
	ts_normal_force(m, c, t, own, &n);
	ts_parts_spring(m, c, &n, memory, out->force[TS_PART_SHEAR]);
	for (int k = 0; k < 3; k++)
		out->force[TS_PART_VISCOUS][k] = total[k] - normal * t->n[k] - out->force[TS_PART_SHEAR][k];
	limit = c->friction * fabs(n.limit + (m->reduce ? ts_cohesion_force(m, c, t) : 0));
	for (int k = 0; k < 3; k++)
		friction[k] = total[k] - normal * t->n[k];
	if (m->tangential != TS_TANGENTIAL_HISTORY && m->tangential != TS_TANGENTIAL_INCREMENTAL &&
	    !(ts_norm(friction) < (1 - 1e-12) * limit)) {
		ts_scale(1, out->force[TS_PART_VISCOUS], out->force[TS_PART_SLIP]);
		ts_scale(0, out->force[TS_PART_VISCOUS], out->force[TS_PART_VISCOUS]);
	}
	for (int part = TS_PART_SHEAR; part <= TS_PART_SLIP; part++)
		ts_cross(out->force[part], t->n, out->turn[part]);
}

/* Energy dissipated by slip in a step: the mean spring force at the beginning and the end of the step
 * times the slip distance, which is the spring elongation without the Coulomb limit minus the actual
 * one. `before`, `after`: the contact history at both times. A spring that was just copied from another
 * contact (of an adjacent triangle) has no such step: 0. */
static inline double ts_slip_loss(const struct ts_granular_model *m, const struct ts_granular_pair *c,
				  const struct ts_touch *t, double dt, const double *before,
				  const double *after)
{
	double start[3], trial[3], own[TS_NORMAL_MEMORY], sum = 0;
	struct ts_slider slider;
	struct ts_normal n;

	if (!ts_tangential_remembers(m))
		return 0;
	ts_granular_normal_memory(m, after, own);
	ts_normal_force(m, c, t, own, &n);
	slider = ts_tangential_slider_of(m, c, &n);
	if (!(n.kt > 0) || (ts_norm(before) == 0 &&
			    ts_norm(after) > 1.001 * dt * ts_norm(t->slip) * (slider.force ? n.kt : 1)))
		return 0;
	ts_scale(1, before, start);
	if (m->tangential < TS_TANGENTIAL_LINEAR)
		ts_project(t->n, start);
	else
		ts_slider_advance(&slider, t->n, (const double[3]){ 0 }, dt, start);
	for (int k = 0; k < 3; k++) {
		trial[k] = start[k] + (slider.force ? -n.kt : 1) * dt * t->slip[k];
		sum += (trial[k] - after[k]) * 0.5 * (start[k] + after[k]);
	}
	return slider.force ? sum / n.kt : sum * n.kt;
}

#endif
