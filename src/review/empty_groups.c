/* Check of the review: fixes that act on the particles of a group that has none. */
#include "core/ranks.h"
#include "insert/template.h"
#include "particle/particles.h"
#include "review/internal.h"

#include "base/banned.h"

/* Whether it exerts forces on its particles, or moves them. Others, such as averages and meshes, are no mistake: they show
 * nothing, or their group has no meaning. */
static bool acts(const struct ts_style *style)
{
	return style->integrates || style->restraint || style->hook[TS_STAGE_POST_FORCE] ||
	       style->late[TS_LATE_RELAX] || style->late[TS_LATE_INERTIA];
}

static uint32_t dynamic_groups(const struct ts_particles *p)
{
	uint32_t groups = 0;

	for (int bit = 0; bit < TS_MAX_GROUPS; bit++)
		groups |= p->dynamic[bit].every ? (uint32_t)1 << bit : 0;
	return groups;
}

/* The groups that have particles on any rank, as bits. */
static uint32_t inhabited_groups(const struct tsim *sim)
{
	const struct ts_particles *p = sim->particles;
	double found[TS_MAX_GROUPS];
	uint32_t groups = 0;

	for (size_t i = 0; i < p->n; i++)
		groups |= p->mask[i];
	for (int bit = 0; bit < TS_MAX_GROUPS; bit++)
		found[bit] = groups >> bit & 1;
	ts_ranks_most_of(sim, found, TS_MAX_GROUPS);
	for (int bit = 0; bit < TS_MAX_GROUPS; bit++)
		groups |= found[bit] > 0 ? (uint32_t)1 << bit : 0;
	return groups;
}

enum ts_status ts_review_group(struct tsim *sim)
{
	const struct ts_instances *fixes = &sim->instances[TS_KIND_FIX];
	uint32_t groups = 1u; /* all */

	/* A host program may make particles, and so may a run that -check has not made. */
	if (sim->review.steps <= TS_REVIEW_SET_UP || sim->outside || sim->review.stale)
		return TS_OK;
	groups |= inhabited_groups(sim) | dynamic_groups(sim->particles) | ts_template_groups(sim);
	for (size_t k = 0; k < fixes->n; k++) {
		const struct ts_instance *fix = fixes->item[k];

		if (!acts(fix->style) || groups >> fix->group & 1)
			continue;
		TS_TRY(ts_review_report(sim, "group", &fix->where,
					"fix %s (%s) acts on nothing: its group '%s' has no particle; a "
					"group keeps the particles that it had when the script defined it, "
					"and inserted particles are members of all and of the groups of the "
					"fixes that insert them",
					fix->id, fix->style->name, ts_group_name(sim, fix->group)));
	}
	return TS_OK;
}
