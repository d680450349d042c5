#include "contact/cohesive_bonds.h"

#include <math.h>

#include "bond/bonds.h"
#include "core/life.h"
#include "material/property.h"

#include "base/banned.h"

static const char style[] = "cohesion";
static const char *const names[] = { "stressBreak",	  "createBondAlways",  "tensionStress",
				     "compressionStress", "shearStress",       "normalTorqueStress",
				     "shearTorqueStress", "dampingBond",       "ratioTensionCompression",
				     "temperatureBreak",  "dampingBondSmooth", "dissipationBond",
				     "druckerPrager" };

/* ---- words */

bool ts_cohesive_word(const char *text)
{
	for (size_t k = 0; k < sizeof names / sizeof *names; k++)
		if (ts_streq(names[k], text))
			return true;
	return false;
}

enum ts_status ts_cohesive_words_check(struct tsim *sim, const struct ts_instance *self, const char *who,
				       const struct ts_cohesive_words *w)
{
	const struct {
		bool on;
		const char *name, *why;
	} refused[] = {
		{ w->by_temperature, "temperatureBreak", "bonds do not break by temperature" },
		{ w->smooth, "dampingBondSmooth",
		  "its velocities are defined for the normal force only; bond_style parallel has dashpots" },
		{ w->dissipation, "dissipationBond",
		  "forces of bonds are functions of the present state and do not relax; bond_style parallel "
		  "has dashpots" },
		{ w->drucker_prager, "druckerPrager",
		  "the shear strength does not depend on the normal stress" },
	};

	for (size_t k = 0; k < sizeof refused / sizeof *refused; k++)
		if (refused[k].on)
			return ts_fail(&sim->error, TS_STATE, ts_instance_word(self, refused[k].name),
				       "%s: %s on is not supported: %s", who, refused[k].name,
				       refused[k].why);
	return TS_OK;
}

static bool in_use(const struct tsim *sim)
{
	const struct ts_instance *bond = ts_sim_only(sim, TS_KIND_BOND);

	return bond && ts_streq(bond->style->name, style);
}

/* The words of the bond style among those of the pair style: `cohesion`, then keywords and their values. */
static size_t words_of_bonds(const struct ts_instance *pair, struct ts_word *out)
{
	size_t n = 0;

	for (size_t k = 0; k < pair->words.n; k++) {
		const struct ts_word *word = &pair->words.word[k];
		bool keyword = n > 0 && ts_cohesive_word(word->text);

		if (keyword || (n == 0 && ts_streq(word->text, style)))
			out[n++] = *word;
		if (keyword && k + 1 < pair->words.n)
			out[n++] = pair->words.word[++k];
	}
	return n;
}

enum ts_status ts_cohesive_bonds_choose(struct tsim *sim, const struct ts_instance *pair)
{
	const struct ts_instance *bond = ts_sim_only(sim, TS_KIND_BOND);
	struct ts_word *words;
	enum ts_status status;

	if (bond && !in_use(sim))
		return ts_fail(&sim->error, TS_STATE, ts_instance_word(pair, style),
			       "pair gran: cohesion bond has bonds of its own, but bond_style %s is in use; "
			       "use one of them",
			       bond->style->name);
	words = ts_alloc(pair->words.n + 1, sizeof *words);
	if (!words)
		return ts_nomem(&sim->error);
	status = ts_sim_choose(sim, TS_KIND_BOND, (struct ts_words){ words, words_of_bonds(pair, words) },
			       &pair->where);
	ts_free(words);
	return status;
}

enum ts_status ts_cohesive_bonds_require(struct tsim *sim, const struct ts_instance *pair)
{
	const struct ts_instance *bond = ts_sim_only(sim, TS_KIND_BOND);

	if (in_use(sim))
		return TS_OK;
	return ts_fail(&sim->error, TS_STATE, ts_instance_word(pair, style),
		       "pair gran: cohesion bond has bonds of its own, but they were replaced by bond_style "
		       "%s",
		       bond ? bond->style->name : "none");
}

/* ---- properties */

enum { ALL = 1, STRESS = 2, DISTANCE = 4, RATIO = 8, DAMPING = 16 };

static const struct {
	unsigned needs;
	const char *name;
	size_t offset;
	double least; /* the property is at least this, above it if `above` */
	bool above, finite;
} properties[] = {
#define AT(field) offsetof(struct ts_cohesive_coeff, field)
	{ ALL, "radiusMultiplierBond", AT(radius_multiplier), 0, true, true },
	{ ALL, "normalBondStiffnessPerUnitArea", AT(kn), 0, false, true },
	{ ALL, "tangentialBondStiffnessPerUnitArea", AT(kt), 0, false, true },
	{ ALL, "createDistanceBond", AT(create_distance), 0, false, true },
	{ DISTANCE, "maxDistanceBond", AT(max_distance), 0, false, false },
	{ STRESS, "maxSigmaBond", AT(sigma), 0, false, false },
	{ STRESS, "maxTauBond", AT(tau), 0, false, false },
	{ RATIO, "ratioTensionCompression", AT(ratio), 0, true, false },
	{ DAMPING, "dampingNormalForceBond", AT(damping[TS_BOND_NORMAL]), 0, false, true },
	{ DAMPING, "dampingTangentialForceBond", AT(damping[TS_BOND_SHEAR]), 0, false, true },
	{ DAMPING, "dampingTangentialTorqueBond", AT(damping[TS_BOND_BENDING]), 0, false, true },
	{ DAMPING, "dampingNormalTorqueBond", AT(damping[TS_BOND_TWIST]), 0, false, true },
#undef AT
};

static enum ts_status check_value(struct tsim *sim, size_t k, int a, int b, double value)
{
	const char *name = properties[k].name;
	bool damping = properties[k].needs == DAMPING;
	bool large = damping ? !(value < 1) : properties[k].finite && !isfinite(value);
	bool small = properties[k].above ? !(value > properties[k].least) : !(value >= properties[k].least);

	if (!large && !small)
		return TS_OK;
	return ts_fail(&sim->error, TS_RANGE, ts_property_place(sim, name, a, b),
		       "property/global %s is %.15g, expected a number %s %g%s", name, value,
		       properties[k].above ? ">" : ">=", properties[k].least, damping ? " and < 1" : "");
}

enum ts_status ts_cohesive_read(struct tsim *sim, const struct ts_cohesive_words *words, int a, int b,
				const struct ts_place *where, struct ts_cohesive_coeff *out)
{
	unsigned needs = ALL | (words->by_stress ? STRESS : DISTANCE);

	needs |= (words->ratio_given && words->by_stress ? RATIO : 0) | (words->damping ? DAMPING : 0);
	*out = (struct ts_cohesive_coeff){ .a = a, .b = b, .words = *words, .ratio = 1 };
	for (size_t k = 0; k < sizeof properties / sizeof *properties; k++) {
		double *value = (double *)(void *)((char *)out + properties[k].offset);

		if (!(properties[k].needs & needs))
			continue;
		if (ts_streq(properties[k].name, "radiusMultiplierBond") &&
		    !ts_property_given(sim, properties[k].name)) {
			*value = 1;
			continue;
		}
		TS_TRY(ts_property_value(sim, properties[k].name, a, b, "pair_style gran cohesion bond",
					 where, value));
		TS_TRY(check_value(sim, k, a, b, *value));
	}
	return TS_OK;
}
