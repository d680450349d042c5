#include "mesh/mesh_surface.h"

#include "base/banned.h"

struct ts_mesh_surface *ts_mesh_surface_next(const struct tsim *sim, size_t *k, struct ts_instance **by)
{
	struct ts_instance *inst = ts_sim_next_of(sim, TS_KIND_FIX, TS_FAMILY_MESH, k);

	if (by)
		*by = inst;
	return inst ? inst->state : NULL;
}

struct ts_mesh_surface *ts_mesh_surface_find(const struct tsim *sim, const char *id)
{
	struct ts_instance *by;
	struct ts_mesh_surface *surface;

	for (size_t k = 0; (surface = ts_mesh_surface_next(sim, &k, &by));)
		if (ts_streq(by->id, id))
			return surface;
	return NULL;
}

enum ts_status ts_mesh_surface_require(struct tsim *sim, const struct ts_word *id,
				       struct ts_mesh_surface **out)
{
	struct ts_suggest suggest = ts_suggest_start(id->text);
	const struct ts_instance *fix = ts_sim_find(sim, TS_KIND_FIX, id->text);
	struct ts_instance *by;

	*out = ts_mesh_surface_find(sim, id->text);
	if (*out)
		return TS_OK;
	if (fix)
		return ts_fail(&sim->error, TS_STATE, &id->place,
			       "fix %s is no mesh, but of style %s; meshes come from `fix ID all "
			       "mesh/surface ...`",
			       id->text, fix->style->name);
	for (size_t k = 0; ts_mesh_surface_next(sim, &k, &by);)
		ts_suggest_try(&suggest, by->id);
	return ts_missing(&sim->error, "fix", id->text, &id->place,
			  "there is no mesh '%s' of `fix %s all mesh/surface ...`%s", id->text, id->text,
			  ts_suggest_text(&suggest));
}
