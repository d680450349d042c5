#include "force/restraint.h"

#include "group/group_members.h"
#include "core/ranks.h"
#include "particle/particles.h"

#include "base/banned.h"

static enum ts_status refuse_distributed_forces(struct tsim *sim, const struct ts_instance *self,
						const struct ts_instance *fix)
{
	if (fix->style->restraint->apply ||
	    !(ts_ranks_most(sim, ts_groups_meet(sim->particles, self->group, fix->group)) > 0))
		return TS_OK;
	return ts_fail(&sim->error, TS_STATE, &self->where,
		       "fix %s: its force depends on how each particle will move by itself, but fix %s %s "
		       "(%s:%d) gives particles of this group a common force: put fix %s before this fix, "
		       "or use a drag of scheme explicit",
		       self->style->name, fix->style->name, fix->id, TS_FILE_AND_LINE(fix->where),
		       fix->style->name);
}

enum ts_status ts_restraints_find(struct ts_restraints *list, struct tsim *sim,
				  const struct ts_instance *self, bool alone)
{
	const struct ts_instances *fixes = &sim->instances[TS_KIND_FIX];
	bool after = false;

	list->n = 0;
	for (size_t k = 0; k < fixes->n; k++) {
		struct ts_instance *fix = fixes->item[k];

		after |= fix == self;
		if (!fix->style->restraint || (!after && fix->style->hook[TS_STAGE_POST_FORCE]))
			continue;
		if (alone)
			TS_TRY(refuse_distributed_forces(sim, self, fix));
		if (!fix->style->restraint->apply)
			continue;
		if (TS_GROW(list->fix, list->capacity, list->n + 1) != TS_OK)
			return ts_nomem(&sim->error);
		list->fix[list->n++] = fix;
	}
	return TS_OK;
}

enum ts_status ts_restraints_prepare(const struct ts_restraints *list, struct tsim *sim)
{
	for (size_t k = 0; k < list->n; k++)
		if (list->fix[k]->style->restraint->prepare)
			TS_TRY(list->fix[k]->style->restraint->prepare(list->fix[k], sim));
	return TS_OK;
}

void ts_restraints_apply(const struct ts_restraints *list, const struct tsim *sim, size_t i, double f[3])
{
	for (size_t k = 0; k < list->n; k++)
		if (ts_in_group(sim->particles, i, list->fix[k]->group))
			list->fix[k]->style->restraint->apply(list->fix[k], sim, i, f);
}

void ts_restraints_release(struct ts_restraints *list)
{
	ts_free(list->fix);
	*list = (struct ts_restraints){ 0 };
}
