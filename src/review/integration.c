/* Checks of the review: integration of positions and rotations. */
#include "review/internal.h"

#include <stdio.h>

#include "bond/bonds.h"
#include "heat/heat.h"
#include "insert/template.h"
#include "integrate/integrators.h"
#include "particle/identity.h"
#include "rigid/rigid.h"
#include "wall/wall.h"

#include "base/banned.h"

enum ts_status ts_review_integrator(struct tsim *sim)
{
	const struct ts_particles *p = sim->particles;
	uint32_t moved = ts_integrated_groups(sim, TS_MOVES);
	size_t idle = 0, first = 0;

	if (sim->review.steps <= TS_REVIEW_SET_UP || sim->outside || (!moved && ts_heat_of(sim)))
		return TS_OK; /* a host program moves them; or conduction in a packing at rest */
	if (!p->n && !moved && ts_template_of_spheres(sim))
		return ts_review_report(sim, "integrator", NULL,
					"no fix integrates the particles that will be inserted: they will "
					"not move; add `fix ID all nve/sphere`");
	for (size_t i = 0; i < p->n; i++) {
		if (p->mask[i] & moved || !(p->imass[i] > 0) || ts_rigid_member(p, i))
			continue;
		if (!idle++ || p->tag[i] < p->tag[first])
			first = i;
	}
	if (!idle)
		return TS_OK;
	return ts_review_report(sim, "integrator", NULL,
				"%zu of %zu particles are not integrated by any fix; the first is particle "
				"%d (type %d) at (%g %g %g); add `fix ID GROUP nve/sphere`, or `fix ID GROUP "
				"freeze` for fixed particles",
				idle, p->n, p->tag[first], p->type[first], p->x[first][0], p->x[first][1],
				p->x[first][2]);
}

/* ---- rotation ---- */

static bool has_type(const struct ts_particles *p, int group, int type)
{
	for (size_t i = 0; i < p->n; i++)
		if (p->type[i] == type && ts_in_group(p, i, group))
			return true;
	return false;
}

static bool will_be_inserted(const struct tsim *sim, int group, int type)
{
	return group == 0 && ts_template_inverse_mass(sim, type, NULL) > 0;
}

static bool has_friction(const struct ts_granular_model *model, const struct ts_granular_pair *law)
{
	return model->tangential != TS_TANGENTIAL_OFF && law->friction > 0;
}

/* Coefficient of friction of particles of this type with other particles, or with walls that have their own
 * contact law; 0: no friction. */
static double friction_of(const struct tsim *sim, int type)
{
	const struct ts_instance *pair = ts_sim_only(sim, TS_KIND_PAIR);
	const struct ts_particles *p = sim->particles;
	const struct ts_wall *w;

	for (int t = 1; pair && t <= p->ntypes; t++)
		if (has_friction(ts_pair_model(pair->state, type, t), ts_pair_law(pair->state, type, t)))
			return ts_pair_law(pair->state, type, t)->friction;
	for (size_t k = 0; (w = ts_walls_next(sim, &k, NULL));)
		for (int t = 0; w->own_model && w->law && t <= w->ntypes; t++)
			if (has_friction(&w->model, ts_wall_law(w, sim, t, type)))
				return ts_wall_law(w, sim, t, type)->friction;
	return 0;
}

static enum ts_status check_fix(struct tsim *sim, const struct ts_instance *fix)
{
	const struct ts_particles *p = sim->particles;

	for (int t = 1; t <= p->ntypes; t++) {
		double friction = friction_of(sim, t);

		if (friction > 0 && (has_type(p, fix->group, t) || will_be_inserted(sim, fix->group, t)))
			return ts_review_report(sim, "rotation", &fix->where,
						"fix %s does not integrate rotation, but contacts of type %d "
						"have friction (coefficient %g), which exerts torques; use "
						"`fix %s %s nve/sphere`",
						fix->style->name, t, friction, fix->id,
						ts_group_name(sim, fix->group));
	}
	return TS_OK;
}

/* Bonds that transmit moments turn particles. */
static enum ts_status check_bonds(struct tsim *sim, const struct ts_instance *fix)
{
	const struct ts_bonds *b = sim->bonds;
	struct ts_identities map;

	if (!b->transmits || !b->n || !ts_sim_only(sim, TS_KIND_BOND))
		return TS_OK;
	TS_TRY(ts_identities(sim, false, &map));
	for (size_t k = 0; k < b->n; k++)
		for (int s = 0; s < 2; s++) {
			int32_t row = ts_identity_row(&map, b->tag[k][s]);

			if (row >= 0 && ts_in_group(sim->particles, (size_t)row, fix->group))
				return ts_review_report(sim, "rotation", &fix->where,
							"fix %s does not integrate rotation, but the bonds "
							"of particle %d (bond style %s) exert torques; use "
							"`fix %s %s nve/sphere`",
							fix->style->name, b->tag[k][s],
							ts_sim_only(sim, TS_KIND_BOND)->style->name, fix->id,
							ts_group_name(sim, fix->group));
		}
	return TS_OK;
}

enum ts_status ts_review_rotation(struct tsim *sim)
{
	const struct ts_instances *fixes = &sim->instances[TS_KIND_FIX];

	if (sim->run.clamped ||
	    sim->review.steps <= TS_REVIEW_SET_UP) /* clamped: fix nve/limit relaxes overlaps */
		return TS_OK;
	for (size_t k = 0; k < fixes->n; k++)
		if (fixes->item[k]->style->integrates == (TS_MOVES | TS_OBEYS)) {
			TS_TRY(check_fix(sim, fixes->item[k]));
			TS_TRY(check_bonds(sim, fixes->item[k]));
		}
	return TS_OK;
}
