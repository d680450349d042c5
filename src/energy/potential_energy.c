#include "energy/potential_energy.h"

#include <stdio.h>

#include "core/name_list.h"

#include "base/banned.h"

enum ts_status ts_energy_output(struct ts_instance *self, struct tsim *sim, double *out)
{
	TS_TRY(ts_value_cached(self, sim, ts_value_find(self, TS_SCALAR)));
	*out = self->table.data[0];
	return TS_OK;
}

static enum ts_status add_energy_of_style(struct tsim *sim, struct ts_instance *inst, double *out)
{
	double energy;

	if (!inst)
		return TS_OK;
	if (!inst->style->energy)
		return ts_fail(&sim->error, TS_STATE, &inst->where, "%s style %s has no potential energy",
			       ts_kind_name(inst->style->kind), inst->style->name);
	TS_TRY(inst->style->energy(inst, sim, &energy));
	*out += energy;
	return TS_OK;
}

enum ts_status ts_potential_energy(struct tsim *sim, const struct ts_energy_parts *parts, double *out)
{
	const struct ts_instances *fixes = &sim->instances[TS_KIND_FIX];

	*out = 0;
	if (parts->pair)
		TS_TRY(add_energy_of_style(sim, ts_sim_only(sim, TS_KIND_PAIR), out));
	if (parts->bond)
		TS_TRY(add_energy_of_style(sim, ts_sim_only(sim, TS_KIND_BOND), out));
	for (size_t k = 0; parts->fix && k < fixes->n; k++)
		if (fixes->item[k]->counts_energy)
			TS_TRY(add_energy_of_style(sim, fixes->item[k], out));
	return TS_OK;
}

enum ts_status ts_energy_parse_parts(struct tsim *sim, const struct ts_instance *self, struct ts_words words,
				     struct ts_energy_parts *parts)
{
	/* the last four contribute nothing */
	static const char *const names[] = { "pair",	 "bond",     "fix",    "angle",
					     "dihedral", "improper", "kspace", NULL };
	char what[80];

	snprintf(what, sizeof what, "compute %s", self->style->name);
	TS_TRY(ts_name_list_check_keywords(sim, what, words, names));
	*parts = (struct ts_energy_parts){ !words.n, !words.n, !words.n };
	for (size_t k = 0; k < words.n; k++) {
		const char *word = words.word[k].text;

		parts->pair |= ts_streq(word, "pair");
		parts->bond |= ts_streq(word, "bond");
		parts->fix |= ts_streq(word, "fix");
	}
	return TS_OK;
}
