#include "energy/potential_energy.h"

#include "base/banned.h"

enum ts_status ts_energy_output(struct ts_instance *self, struct tsim *sim, double *out)
{
	TS_TRY(ts_value_eval(self, sim, ts_value_find(self, TS_SCALAR), &self->table));
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

	*parts = (struct ts_energy_parts){ !words.n, !words.n, !words.n };
	for (size_t k = 0; k < words.n; k++) {
		const char *word = words.word[k].text;
		struct ts_suggest suggest = ts_suggest_start(word);
		bool known = false;

		for (const char *const *name = names; *name; name++) {
			known |= ts_streq(word, *name);
			ts_suggest_try(&suggest, *name);
		}
		if (!known)
			return ts_fail(&sim->error, TS_UNKNOWN, &words.word[k].place,
				       "compute %s: unknown keyword '%s'%s", self->style->name, word,
				       ts_suggest_text(&suggest));
		parts->pair |= ts_streq(word, "pair");
		parts->bond |= ts_streq(word, "bond");
		parts->fix |= ts_streq(word, "fix");
	}
	return TS_OK;
}
