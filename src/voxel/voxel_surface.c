#include "voxel/voxel_surface.h"

#include "base/banned.h"

struct ts_voxel_surface *ts_voxel_surface_next(const struct tsim *sim, size_t *k, struct ts_instance **by)
{
	struct ts_instance *inst = ts_sim_next_of(sim, TS_KIND_FIX, TS_FAMILY_VOXEL, k);

	if (by)
		*by = inst;
	return inst ? inst->state : NULL;
}

enum ts_status ts_voxel_surface_require(struct tsim *sim, const struct ts_word *id,
					struct ts_voxel_surface **out)
{
	struct ts_suggest suggest = ts_suggest_start(id->text);
	const struct ts_instance *fix = ts_sim_find(sim, TS_KIND_FIX, id->text);
	struct ts_voxel_surface *surface;
	struct ts_instance *by;

	for (size_t k = 0; (surface = ts_voxel_surface_next(sim, &k, &by));) {
		*out = surface;
		if (ts_streq(by->id, id->text))
			return TS_OK;
		ts_suggest_try(&suggest, by->id);
	}
	if (fix)
		return ts_fail(&sim->error, TS_STATE, &id->place,
			       "fix %s is no height field, but of style %s; height fields come from `fix ID "
			       "all surface/voxel ...`",
			       id->text, fix->style->name);
	return ts_fail(&sim->error, TS_UNKNOWN, &id->place,
		       "there is no height field '%s' of `fix %s all surface/voxel ...`%s", id->text,
		       id->text, ts_suggest_text(&suggest));
}
