#include "core/group.h"

#include "core/sim.h"

#include "base/banned.h"

int ts_group_find(const struct tsim *sim, const char *name)
{
	for (int g = 0; g < TS_MAX_GROUPS; g++)
		if (sim->groups.name[g] && ts_streq(sim->groups.name[g], name))
			return g;
	return -1;
}

bool ts_group_exists(const struct tsim *sim, const char *name)
{
	return ts_group_find(sim, name) >= 0;
}

const char *ts_group_name(const struct tsim *sim, int bit)
{
	return sim->groups.name[bit];
}

enum ts_status ts_group_require(struct tsim *sim, const struct ts_word *name, int *bit)
{
	struct ts_suggest suggest = ts_suggest_start(name->text);

	*bit = ts_group_find(sim, name->text);
	if (*bit >= 0)
		return TS_OK;
	for (int g = 0; g < TS_MAX_GROUPS; g++)
		if (sim->groups.name[g])
			ts_suggest_try(&suggest, sim->groups.name[g]);
	return ts_missing(&sim->error, "group", name->text, &name->place, "there is no group '%s'%s",
			  name->text, ts_suggest_text(&suggest));
}

enum ts_status ts_group_make(struct tsim *sim, const char *name, const struct ts_place *where, int *bit)
{
	const char **names = sim->groups.name;

	*bit = ts_group_find(sim, name);
	for (int g = 1; *bit < 0 && g < TS_MAX_GROUPS; g++)
		if (!names[g])
			*bit = g;
	if (*bit < 0)
		return ts_fail(&sim->error, TS_RANGE, where, "no room for group '%s': there can be %d", name,
			       TS_MAX_GROUPS);
	names[*bit] = ts_pool_get(sim->pool, name);
	return names[*bit] ? TS_OK : ts_nomem(&sim->error);
}
