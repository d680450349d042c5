#include "integrate/integrators.h"

#include "core/review.h"
#include "particle/particles.h"
#include "rigid/rigid.h"

#include "base/banned.h"

uint32_t ts_integrated_groups(const struct tsim *sim, unsigned what)
{
	const struct ts_instances *fixes = &sim->instances[TS_KIND_FIX];
	uint32_t groups = 0;

	for (size_t k = 0; k < fixes->n; k++)
		if ((fixes->item[k]->style->integrates & what) == what)
			groups |= (uint32_t)1 << fixes->item[k]->group;
	return groups;
}

/* The next fix from *k on that integrates particle i; NULL: there is none. */
static const struct ts_instance *next_integrator(const struct tsim *sim, size_t i, size_t *k)
{
	const struct ts_instances *fixes = &sim->instances[TS_KIND_FIX];

	while (*k < fixes->n) {
		const struct ts_instance *fix = fixes->item[(*k)++];

		if ((fix->style->integrates & TS_MOVES) && ts_in_group(sim->particles, i, fix->group))
			return fix;
	}
	return NULL;
}

static enum ts_status refuse_two_integrators(struct tsim *sim, size_t i, const struct ts_instance *first,
					     const struct ts_instance *second)
{
	return ts_fail(&sim->error, TS_STATE, &second->where,
		       "fix %s (%s) moves particle %d (type %d), which fix %s (%s, %s:%d) moves, too: it "
		       "would be moved twice in each step; give the fixes groups that share no particles, or "
		       "`unfix` one of them",
		       second->id, second->style->name, sim->particles->tag[i], sim->particles->type[i],
		       first->id, first->style->name, TS_FILE_AND_LINE(first->where));
}

/* The body sets the positions of its members in each step, so displacements do not accumulate; but contacts
 * and outputs see what the fix adds within the step. LIGGGHTS and LAMMPS do the same, and scripts with clumps
 * and single particles rely on it. */
static enum ts_status report_member(struct tsim *sim, size_t i, const struct ts_instance *fix)
{
	return ts_review_report(sim, "members", &fix->where,
				"fix %s (%s) integrates particle %d, a member of a rigid body, which also "
				"moves it: within a step the particle is ahead of the body by v dt; use a "
				"group without members of rigid bodies",
				fix->id, fix->style->name, sim->particles->tag[i]);
}

static enum ts_status check_particle(struct tsim *sim, size_t i)
{
	size_t k = 0;
	const struct ts_instance *first = next_integrator(sim, i, &k);
	const struct ts_instance *second = first ? next_integrator(sim, i, &k) : NULL;

	if (second)
		return refuse_two_integrators(sim, i, first, second);
	return first && ts_rigid_member(sim->particles, i) ? report_member(sim, i, first) : TS_OK;
}

/* Whether more than one bit is set. */
static bool has_several_bits(uint32_t bits)
{
	return (bits & (bits - 1)) != 0;
}

/* Whether two fixes integrate the same group. */
static bool two_fixes_same_group(const struct tsim *sim)
{
	const struct ts_instances *fixes = &sim->instances[TS_KIND_FIX];
	uint32_t groups = 0;
	bool twice = false;

	for (size_t k = 0; k < fixes->n; k++) {
		uint32_t bit = (uint32_t)1 << fixes->item[k]->group;

		if (!(fixes->item[k]->style->integrates & TS_MOVES))
			continue;
		twice |= (groups & bit) != 0;
		groups |= bit;
	}
	return twice;
}

static enum ts_status check_all(struct tsim *sim)
{
	const struct ts_particles *p = sim->particles;
	uint32_t groups = ts_integrated_groups(sim, TS_MOVES);
	bool all = two_fixes_same_group(sim);

	if (!groups || (!all && !has_several_bits(groups) && !sim->rigid->n))
		return TS_OK;
	for (size_t i = 0; i < p->n; i++) {
		uint32_t in = p->mask[i] & groups;

		if (in && (all || has_several_bits(in) || ts_rigid_member(p, i)) && p->imass[i] > 0)
			TS_TRY(check_particle(sim, i));
	}
	return TS_OK;
}

static enum ts_status check_members(struct tsim *sim, const int32_t *row, size_t n)
{
	uint32_t groups = ts_integrated_groups(sim, TS_MOVES);

	for (size_t m = 0; m < n && groups; m++)
		if (sim->particles->mask[row[m]] & groups)
			TS_TRY(check_particle(sim, (size_t)row[m]));
	return TS_OK;
}

static void connect_integrators(struct tsim *sim)
{
	sim->particles->check_movers = check_all;
	sim->rigid->check_members = check_members;
}

const struct ts_system_style ts_integrators_system = {
	.style = { .name = "integrators",
		   .kind = TS_KIND_SYSTEM,
		   .summary = "checks that no particle is integrated by two fixes" },
	.no_instance = true,
	.connect = connect_integrators,
};
