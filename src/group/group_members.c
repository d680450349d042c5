#include "group/group_members.h"

#include "base/clones.h"

#include "base/banned.h"

TS_CLONES static size_t count_members(const uint32_t *mask, int group, size_t from, size_t to)
{
	uint32_t members = 0;

#pragma omp simd reduction(+ : members)
	for (size_t i = from; i < to; i++)
		members += mask[i] >> group & 1u;
	return members;
}

size_t ts_group_members(const struct ts_particles *p, int group, size_t from, size_t to)
{
	return count_members(p->mask, group, from, to);
}

bool ts_groups_meet(const struct ts_particles *p, int a, int b)
{
	bool meet = a == b || a == 0 || b == 0;

	for (size_t i = 0; i < p->n && !meet; i++)
		meet = ts_in_group(p, i, a) && ts_in_group(p, i, b);
	return meet;
}
