#include "core/standard.h"

#include "base/banned.h"

static const char *const units[TS_NSTANDARD] = { "temperature", "pressure" };

enum ts_status ts_standard_set(struct tsim *sim, enum ts_standard which, const struct ts_word *id)
{
	const struct ts_value *value;
	struct ts_instance *inst;

	sim->standard[which] = NULL;
	if (!id)
		return TS_OK;
	TS_TRY(ts_sim_require(sim, TS_KIND_COMPUTE, id, &inst));
	value = ts_value_find(inst, TS_SCALAR);
	if (!value || !ts_streq(value->unit, units[which]))
		return ts_fail(&sim->error, TS_RANGE, &id->place, "compute %s gives no %s", id->text,
			       units[which]);
	sim->standard[which] = ts_pool_get(sim->pool, id->text);
	return sim->standard[which] ? TS_OK : ts_nomem(&sim->error);
}

enum ts_status ts_standard_value(struct tsim *sim, enum ts_standard which, int k, bool *replaced, double *out)
{
	const struct ts_word id = { .text = sim->standard[which] };
	const struct ts_value *value;
	struct ts_instance *inst;

	*replaced = id.text != NULL;
	if (!id.text)
		return TS_OK;
	TS_TRY(ts_sim_require(sim, TS_KIND_COMPUTE, &id, &inst));
	value = ts_value_find(inst, k < 0 ? TS_SCALAR : TS_VECTOR);
	if (!value)
		return ts_fail(&sim->error, TS_STATE, &inst->where,
			       "compute %s replaces the %s, but has no components", id.text, units[which]);
	TS_TRY(ts_value_cached(inst, sim, value));
	*out = inst->table.data[k < 0 ? 0 : k];
	return TS_OK;
}
