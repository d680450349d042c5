/* Dynamic groups: their members are assigned again at regular intervals. */
#include "group/group_dynamic.h"

#include <string.h>

#include "core/deferred_loops.h"
#include "core/value.h"
#include "particle/particles.h"
#include "region/region.h"

#include "base/banned.h"

static struct ts_instance *find_region(struct tsim *sim, int bit)
{
	return ts_sim_find(sim, TS_KIND_REGION, sim->particles->dynamic[bit].region);
}

enum ts_status ts_group_variable(struct tsim *sim, const char *name, const struct ts_place *where,
				 struct ts_table *out)
{
	struct ts_str text = { 0 };
	struct ts_ref ref;
	enum ts_status status;

	/* LAMMPS scripts give the bare name */
	ts_str_addf(&text, "%s%s", strncmp(name, "v_", 2) == 0 ? "" : "v_", name);
	status = text.failed ? ts_nomem(&sim->error) : ts_ref_resolve(sim, ts_str_text(&text), where, &ref);
	if (status == TS_OK)
		status = ts_ref_peratom(sim, &ref, where, out);
	ts_str_release(&text);
	return status;
}

static enum ts_status check_definition(struct tsim *sim, int bit)
{
	const struct ts_dynamic_group *g = &sim->particles->dynamic[bit];

	if (!ts_group_name(sim, g->parent))
		return ts_conflict(&sim->error, NULL, "dynamic group %s: its parent group was deleted",
				   ts_group_name(sim, bit));
	if (g->region && !find_region(sim, bit))
		return ts_conflict(&sim->error, NULL, "dynamic group %s: there is no region %s",
				   ts_group_name(sim, bit), g->region);
	return TS_OK;
}

enum ts_status ts_group_choose(struct tsim *sim, int bit)
{
	struct ts_particles *p = sim->particles;
	const struct ts_dynamic_group *g = &p->dynamic[bit];
	struct ts_instance *region;
	struct ts_table value = { 0 };
	enum ts_status status = TS_OK;

	TS_TRY(check_definition(sim, bit));
	region = g->region ? find_region(sim, bit) : NULL;
	TS_TRY(ts_region_update(region, sim));
	if (g->variable)
		status = ts_group_variable(sim, g->variable, NULL, &value);
	for (size_t i = 0; status == TS_OK && i < p->n; i++) {
		bool in = ts_in_group(p, i, g->parent) && (!region || ts_region_contains(region, p->x[i])) &&
			  (!g->variable || value.data[i] != 0);

		p->mask[i] = (p->mask[i] & ~(1u << bit)) | (uint32_t)in << bit;
	}
	ts_table_release(&value);
	return status;
}

enum ts_status ts_group_choose_due(struct tsim *sim, bool all)
{
	const struct ts_particles *p = sim->particles;

	for (int bit = 1; bit < TS_MAX_GROUPS; bit++)
		if (p->dynamic[bit].every && (all || sim->clock.step % p->dynamic[bit].every == 0)) {
			ts_deferred_loops_run(sim);
			TS_TRY(ts_group_choose(sim, bit));
		}
	return TS_OK;
}
