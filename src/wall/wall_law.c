#include "wall/wall_law.h"

#include "base/banned.h"

enum { GRANULAR = 3 };
static const struct {
	const char *name;
	int normal, tangential;
} laws[TS_WALL_LAWS] = {
	{ "hooke", TS_NORMAL_HOOKE_STIFFNESS, TS_TANGENTIAL_NO_HISTORY },
	{ "hooke/history", TS_NORMAL_HOOKE_STIFFNESS, TS_TANGENTIAL_SLIDER },
	{ "hertz/history", TS_NORMAL_HERTZ_STIFFNESS, TS_TANGENTIAL_SLIDER },
	[GRANULAR] = { "granular", 0, 0 },
};

/* `hooke/history kn kt gamma_n gamma_t xmu dampflag` */
static enum ts_status read_numbers(struct ts_instance *self, struct tsim *sim, const char *what, int k,
				   struct ts_wall_law *law, struct ts_wall *wall)
{
	static const struct ts_arg rows[] = { TS_GRAN_NUMBERS_ARGS(struct ts_wall_law, numbers),
					      TS_ARGS_END };
	bool limit_damping = law->numbers.limit_damping;

	TS_TRY(ts_args_parse(sim, what, rows, law->words[k], ts_instance_word(self, laws[k].name),
			     &self->arena, law));
	law->numbers.limit_damping = limit_damping;
	wall->model = ts_gran_numbers_model(laws[k].normal, laws[k].tangential, &law->numbers);
	return ts_gran_numbers_law(sim, &law->numbers, &self->where, &wall->numbers);
}

/* `granular hertz/material E d nu tangential ...` */
static enum ts_status read_coeff(struct ts_instance *self, struct tsim *sim, const char *what,
				 struct ts_wall_law *law, struct ts_wall *wall)
{
	const struct ts_place *where = ts_instance_word(self, laws[GRANULAR].name);

	TS_TRY(ts_args_parse(sim, what, ts_gran_coeff_rows, law->words[GRANULAR], where, &self->arena,
			     &law->coeff));
	law->coeff.limit_damping |= law->numbers.limit_damping;
	TS_TRY(ts_gran_coeff_complete(sim, &law->coeff, where));
	if (sim->legacy)
		ts_gran_coeff_legacy_wall(&law->coeff);
	wall->model = law->coeff.model;
	wall->model.full_arms = true;
	wall->numbers = law->coeff.law;
	return TS_OK;
}

enum ts_status ts_wall_law_choose(struct ts_instance *self, struct tsim *sim, struct ts_wall_law *law,
				  struct ts_wall *wall)
{
	int given = wall->words.normal != TS_NORMAL_OFF;
	char what[64];

	for (int k = 0; k < TS_WALL_LAWS; k++) {
		if (!law->words[k].n)
			continue;
		snprintf(what, sizeof what, "fix %s %s", self->style->name, laws[k].name);
		if (given++)
			return ts_fail(&sim->error, TS_SYNTAX, ts_instance_word(self, laws[k].name),
				       "%s: there is another law on this line", what);
		wall->given = true;
		TS_TRY(k == GRANULAR ? read_coeff(self, sim, what, law, wall)
				     : read_numbers(self, sim, what, k, law, wall));
	}
	return TS_OK;
}
