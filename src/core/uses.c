#include "core/uses.h"

#include "base/banned.h"

/* The region searched for; or, if region is NULL, the group. */
struct target {
	const struct ts_instance *region;
	bool retired;
	int bit;
};

/* Regions of style union and intersect have their members as words. */
static bool has_word(struct ts_words rest, const char *id)
{
	for (size_t k = 0; k < rest.n; k++)
		if (ts_streq(rest.word[k].text, id))
			return true;
	return false;
}

static bool arguments_refer_to(const struct ts_arg *row, const struct ts_instance *inst,
			       const struct target *target)
{
	for (; row && row->type != TS_ARG_END; row++) {
		const void *field = (const char *)inst->state + row->offset;

		if (row->type == TS_ARG_REGION && target->region &&
		    *(struct ts_instance *const *)field == target->region)
			return true;
		if (row->type == TS_ARG_GROUP && !target->region && *(const int *)field == target->bit)
			return true;
		if (row->type == TS_ARG_REST && target->region && !target->retired &&
		    inst->style->kind == TS_KIND_REGION &&
		    has_word(*(const struct ts_words *)field, target->region->id))
			return true;
		if (row->type == TS_ARG_MODE)
			for (const struct ts_mode *m = row->modes; m->name; m++)
				if (arguments_refer_to(m->args, inst, target))
					return true;
	}
	return false;
}

static const struct ts_instance *find_user(const struct tsim *sim, const struct target *target)
{
	for (int kind = 0; kind < TS_NKIND; kind++)
		for (size_t k = 0; k < sim->instances[kind].n; k++) {
			const struct ts_instance *inst = sim->instances[kind].item[k];

			if (!target->region && target->bit != 0 && inst->group == target->bit)
				return inst;
			if (arguments_refer_to(inst->style->args, inst, target))
				return inst;
		}
	return NULL;
}

const struct ts_instance *ts_uses_region(const struct tsim *sim, const struct ts_instance *region)
{
	return find_user(sim, &(struct target){ .region = region });
}

const struct ts_instance *ts_uses_retired_region(const struct tsim *sim, const struct ts_instance *region)
{
	return find_user(sim, &(struct target){ .region = region, .retired = true });
}

const struct ts_instance *ts_uses_group(const struct tsim *sim, int bit)
{
	return find_user(sim, &(struct target){ .bit = bit });
}
