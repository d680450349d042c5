/* What a contact force is made of, by cause; and the energy its springs hold. The force is that of
 * law/granular_force.h, taken apart after it has been made, with the memory as it is then:
 *
 *   normal     F_e n: spring and cohesion, as without velocity
 *   dashpot    the rest along n: -gamma_n v_n, or less where no_tension cuts it
 *   shear      the spring of slip, -k_t xi; what it does not store is slip
 *   viscous    the rest of the tangential force
 *   slip       the same at the limit mu |F_n|, where this holds for spring and dashpot together: the slider
 *              says what force there is
 *   rolling    the torques of rolling and twisting
 *
 * hooke/hysteresis stores what its spring gives back down to zero force, F_e^2/(2 k_2). */
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
	double force[TS_NPART][3]; /* on i; j gets the opposite */
	double turn[TS_NPART][3];  /* times the arm of a partner its torque */
	double roll[3];		   /* torque on i; j gets the opposite */
	double energy[TS_NCONTACT_STORE];
};

/* The stiffness of unloading at the deepest overlap so far. */
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
	double deepest = 0, elastic, pull;

	still.vn = 0;
	pull = ts_cohesion_force(m, c, &still);
	at_rest.viscous = false; /* a matter of the dashpot */
	if (m->normal == TS_NORMAL_HOOKE_HYSTERESIS)
		deepest = memory[ts_granular_depth_at(m)];
	ts_normal_force(&at_rest, c, &still, true, &deepest, &n);
	elastic = n.force;
	ts_scale(elastic + pull, t->n, out->force[TS_PART_NORMAL]);
	ts_scale(force - elastic - pull, t->n, out->force[TS_PART_DASHPOT]);
	out->energy[TS_STORE_NORMAL] =
		ts_cohesion_energy(m, c, t) + (m->normal == TS_NORMAL_HOOKE_HYSTERESIS
						       ? ts_hysteretic_energy(c, t, n.kn, elastic, deepest)
						       : ts_normal_energy(m, c, t, &n));
	out->energy[TS_STORE_SHEAR] = ts_tangential_energy(m, c, &n, memory);
	out->energy[TS_STORE_ROLLING] = ts_turning_energy(m, c, t, &n, memory);
}

/* The force of the spring of slip. */
static inline void ts_parts_spring(const struct ts_granular_model *m, const struct ts_granular_pair *c,
				   const struct ts_normal *n, const double *memory, double force[3])
{
	struct ts_slider slider = ts_tangential_slider_of(m, c, n);

	if (ts_tangential_remembers(m))
		ts_scale(ts_slider_factor(&slider), memory, force);
}

/* `total` on i, `roll` its torque of rolling; `memory` after the force was made. */
static inline void ts_contact_split(const struct ts_granular_model *m, const struct ts_granular_pair *c,
				    const struct ts_touch *t, const double *memory, const double total[3],
				    const double roll[3], struct ts_contact_parts *out)
{
	double normal = ts_dot(total, t->n), deepest = 0, limit, friction[3];
	struct ts_normal n;

	*out = (struct ts_contact_parts){ .roll = { roll[0], roll[1], roll[2] } };
	ts_parts_normal(m, c, t, memory, normal, out);
	if (m->normal == TS_NORMAL_HOOKE_HYSTERESIS)
		deepest = memory[ts_granular_depth_at(m)];
	ts_normal_force(m, c, t, false, &deepest, &n);
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

/* What slip takes in a step: the mean force of the spring at its ends by what the limit has cut off it,
 * the way that it would have gone less that it has gone. `before`, `after`: the memory at the ends. A
 * spring that a contact has from another one (of the next triangle) has no step. */
static inline double ts_slip_loss(const struct ts_granular_model *m, const struct ts_granular_pair *c,
				  const struct ts_touch *t, double dt, const double *before,
				  const double *after)
{
	double start[3], trial[3], deepest = 0, sum = 0;
	struct ts_slider slider;
	struct ts_normal n;

	if (!ts_tangential_remembers(m))
		return 0;
	if (m->normal == TS_NORMAL_HOOKE_HYSTERESIS)
		deepest = after[ts_granular_depth_at(m)];
	ts_normal_force(m, c, t, false, &deepest, &n);
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
