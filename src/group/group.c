/* Groups: named sets of particles, kept as bits of the mask column. */
#include "particle/particles.h"

#include "base/clones.h"

#include "base/banned.h"

TS_CLONES static size_t count(const uint32_t *mask, int group, size_t from, size_t to)
{
	uint32_t members = 0;

#pragma omp simd reduction(+ : members)
	for (size_t i = from; i < to; i++)
		members += mask[i] >> group & 1u;
	return members;
}

size_t ts_group_members(const struct ts_particles *p, int group, size_t from, size_t to)
{
	return count(p->mask, group, from, to);
}

bool ts_groups_meet(const struct ts_particles *p, int a, int b)
{
	bool meet = a == b || a == 0 || b == 0;

	for (size_t i = 0; i < p->n && !meet; i++)
		meet = ts_in_group(p, i, a) && ts_in_group(p, i, b);
	return meet;
}

int ts_group_find(const struct ts_particles *p, const char *name)
{
	for (int g = 0; g < TS_MAX_GROUPS; g++)
		if (p->group[g] && ts_streq(p->group[g], name))
			return g;
	return -1;
}

bool ts_group_exists(const struct tsim *sim, const char *name)
{
	return ts_group_find(sim->particles, name) >= 0;
}

const char *ts_group_name(const struct tsim *sim, int bit)
{
	return sim->particles->group[bit];
}

enum ts_status ts_group_require(struct tsim *sim, const struct ts_word *name, int *bit)
{
	const struct ts_particles *p = sim->particles;
	struct ts_suggest suggest = ts_suggest_start(name->text);

	*bit = ts_group_find(p, name->text);
	if (*bit >= 0)
		return TS_OK;
	for (int g = 0; g < TS_MAX_GROUPS; g++)
		if (p->group[g])
			ts_suggest_try(&suggest, p->group[g]);
	return ts_missing(&sim->error, "group", name->text, &name->place, "there is no group '%s'%s",
			  name->text, ts_suggest_text(&suggest));
}

enum ts_status ts_group_make(struct tsim *sim, const char *name, const struct ts_place *where,
			     int *bit)
{
	struct ts_particles *p = sim->particles;

	*bit = ts_group_find(p, name);
	for (int g = 1; *bit < 0 && g < TS_MAX_GROUPS; g++)
		if (!p->group[g])
			*bit = g;
	if (*bit < 0)
		return ts_fail(&sim->error, TS_RANGE, where, "no room for group '%s': there can be %d",
			       name, TS_MAX_GROUPS);
	p->group[*bit] = ts_pool_get(sim->pool, name);
	return p->group[*bit] ? TS_OK : ts_nomem(&sim->error);
}
