/* Order of the words of contact models, and which keywords need which model: as in LIGGGHTS. */
#include "contact/material_words.h"

#include <string.h>

#include "base/banned.h"

const char *const ts_normal_names[] = { "off",
					"spring",
					"hooke",
					"hertz",
					"hooke/stiffness",
					"hooke/modulus",
					"hertz/stiffness",
					"hooke/hysteresis",
					"edinburgh",
					"jkr",
					NULL };
const char *const ts_tangential_names[] = { "off",     "history", "no_history", "incremental_history",
					    "jkr_tan", NULL };
const char *const ts_rolling_names[] = { "off", "cdt", "epsd", "epsd2", "epsd3", NULL };
const char *const ts_cohesion_names[] = {
	"off", "sjkr", "sjkr2", "easo/capillary/viscous", "washino/capillary/viscous", "bond", NULL
};
const char *const ts_surface_names[] = { "default", "multicontact", NULL };

static const char *const order[] = { "model", "tangential", "cohesion", "rolling_friction", "surface", NULL };

/* Models that a keyword needs. */
static bool has_normal(const struct ts_granular_words *w)
{
	return w->normal != TS_NORMAL_OFF;
}

static bool is_hertz(const struct ts_granular_words *w)
{
	return w->normal == TS_NORMAL_HERTZ;
}

static bool is_hooke(const struct ts_granular_words *w)
{
	return w->normal == TS_NORMAL_HOOKE || w->normal == TS_NORMAL_HOOKE_HYSTERESIS;
}

static bool is_hertz_or_hooke(const struct ts_granular_words *w)
{
	return is_hertz(w) || is_hooke(w);
}

static bool is_stiffness(const struct ts_granular_words *w)
{
	return w->normal == TS_NORMAL_HOOKE_STIFFNESS;
}

static bool has_tangential_history(const struct ts_granular_words *w)
{
	return w->tangential == TS_TANGENTIAL_HISTORY;
}

static bool has_bonds(const struct ts_granular_words *w)
{
	return w->cohesion == TS_WORD_BOND;
}

static bool has_bridges(const struct ts_granular_words *w)
{
	return w->cohesion == TS_COHESION_EASO || w->cohesion == TS_COHESION_WASHINO;
}

static bool can_be_located(const struct ts_granular_words *w)
{
	return has_normal(w) && w->normal < TS_NORMAL_EDINBURGH &&
	       w->tangential < TS_TANGENTIAL_INCREMENTAL && !has_bridges(w);
}

static bool can_be_multicontact(const struct ts_granular_words *w)
{
	return is_hertz_or_hooke(w) && (w->cohesion == TS_COHESION_OFF || has_bonds(w)) && !w->located;
}

static bool has_rolling(const struct ts_granular_words *w)
{
	return w->rolling != TS_ROLLING_OFF;
}

static bool has_cohesion(const struct ts_granular_words *w)
{
	return w->cohesion != TS_COHESION_OFF && !has_bonds(w);
}

static bool is_washino(const struct ts_granular_words *w)
{
	return w->cohesion == TS_COHESION_WASHINO;
}

static const struct {
	const char *name, *of;
	bool (*fits)(const struct ts_granular_words *words);
} keywords[] = {
	{ "limitForce", "a normal model", has_normal },
	{ "tangential_damping", "a normal model", has_normal },
	{ "located",
	  "a normal model without adhesion or liquid bridges, and tangential off, history or no_history",
	  can_be_located },
	{ "absolute_damping", "model hooke/stiffness", is_stiffness },
	{ "ktToKnUser", "model hooke or hooke/hysteresis", is_hooke },
	{ "viscous", "model hooke or hooke/hysteresis", is_hooke },
	{ "tangential_reduce", "a cohesion model", has_cohesion },
	{ "modifyLbVolume", "cohesion washino/capillary/viscous", is_washino },
	{ "limitLiquidContent", "cohesion washino/capillary/viscous", is_washino },
	{ "torsionTorque", "a rolling_friction model", has_rolling },
	{ "heating_normal_hertz", "model hertz", is_hertz },
	{ "heating_tangential_history", "tangential history", has_tangential_history },
	{ "disableNormalWhenBonded", "model hertz or hooke", is_hertz_or_hooke },
};

/* Checks laws that require or exclude each other. */
static enum ts_status check_laws(struct tsim *sim, const struct ts_instance *self, const char *who,
				 const struct ts_granular_words *w)
{
	bool jkr = w->normal == TS_WORD_JKR;

	if (w->surface == TS_SURFACE_MULTICONTACT && !can_be_multicontact(w))
		return ts_fail(&sim->error, TS_SYNTAX, ts_instance_word(self, "multicontact"),
			       "%s: surface multicontact goes with model hertz, hooke or hooke/hysteresis, "
			       "without cohesion and located",
			       who);
	if (w->tangential == TS_WORD_JKR_TAN && !jkr)
		return ts_fail(&sim->error, TS_SYNTAX, ts_instance_word(self, "jkr_tan"),
			       "%s: 'jkr_tan' belongs to model jkr, which is not chosen here", who);
	if (jkr && has_cohesion(w))
		return ts_fail(&sim->error, TS_SYNTAX, ts_instance_word(self, "cohesion"),
			       "%s: model jkr has its own adhesion (workOfAdhesion); leave cohesion out",
			       who);
	if (w->limit_liquid)
		return ts_fail(&sim->error, TS_STATE, ts_instance_word(self, "limitLiquidContent"),
			       "%s: limitLiquidContent on is not supported: the liquid content of particles "
			       "is not limited; use `limitLiquidContent off`",
			       who);
	if (has_bridges(w) && !has_normal(w))
		return ts_fail(&sim->error, TS_SYNTAX, ts_instance_word(self, "cohesion"),
			       "%s: liquid bridges need a normal model: `model hertz`", who);
	if (has_bonds(w) && w->unbonded)
		return ts_fail(&sim->error, TS_STATE, ts_instance_word(self, "disableNormalWhenBonded"),
			       "%s: disableNormalWhenBonded on is not supported with cohesion bond: "
			       "`special_bonds lj 0 1 1` switches all contact forces between bonded "
			       "particles off",
			       who);
	if ((jkr || w->normal == TS_NORMAL_EDINBURGH) && w->limit_force)
		return ts_fail(&sim->error, TS_SYNTAX, ts_instance_word(self, "limitForce"),
			       "%s: 'limitForce' does not go with model %s, which attracts", who,
			       ts_normal_names[w->normal]);
	return TS_OK;
}

static int rank_of(const char *text)
{
	for (int k = 0; order[k]; k++)
		if (ts_streq(order[k], text))
			return k;
	return -1;
}

static enum ts_status refuse_order(struct tsim *sim, const char *who, const struct ts_word *word,
				   const char *before)
{
	return ts_fail(&sim->error, TS_SYNTAX, &word->place,
		       "%s: '%s' must stand before '%s'; the order is model, tangential, cohesion, "
		       "rolling_friction, surface, then the keywords",
		       who, word->text, before);
}

enum ts_status ts_granular_words_check(struct tsim *sim, const struct ts_instance *self, const char *who,
				       const struct ts_granular_words *words)
{
	int last = -1;
	const char *keyword = NULL;

	for (size_t k = 0; k < self->words.n; k++) {
		const struct ts_word *word = &self->words.word[k];
		int rank = rank_of(word->text);

		if (rank >= 0 && keyword)
			return refuse_order(sim, who, word, keyword);
		if (rank >= 0 && rank < last)
			return refuse_order(sim, who, word, order[last]);
		last = rank >= 0 ? rank : last;
		if (ts_cohesive_word(word->text)) {
			keyword = word->text;
			if (!has_bonds(words))
				return ts_fail(&sim->error, TS_SYNTAX, &word->place,
					       "%s: '%s' belongs to cohesion bond, which is not chosen here",
					       who, word->text);
		}
		for (size_t n = 0; n < sizeof keywords / sizeof *keywords; n++) {
			if (!ts_streq(word->text, keywords[n].name))
				continue;
			keyword = word->text;
			if (!keywords[n].fits(words))
				return ts_fail(&sim->error, TS_SYNTAX, &word->place,
					       "%s: '%s' belongs to %s, which is not chosen here", who,
					       word->text, keywords[n].of);
		}
	}
	return check_laws(sim, self, who, words);
}
