#include "bond/bpm_words.h"

#include "core/life.h"
#include "neigh/neigh.h"

#include "base/banned.h"

/* `fix FIX all bond/store/local N QUANTITIES` */
static enum ts_status make_fix(struct ts_instance *self, struct tsim *sim, struct ts_words words)
{
	const struct ts_word name = { .text = "bond/store/local", .place = words.word[0].place };
	const struct ts_style *style;

	if (words.n < 3)
		return ts_fail(&sim->error, TS_SYNTAX, &words.word[0].place,
			       "bond_style %s: expected store/local FIX N QUANTITIES ..., such as "
			       "`store/local broken 1000 time id1 id2`",
			       self->style->name);
	TS_TRY(ts_style_require(sim, TS_KIND_FIX, &name, &style));
	return ts_sim_create(sim, TS_KIND_FIX, style, words.word[0].text, 0, ts_words_from(words, 1),
			     &words.word[0].place, NULL);
}

enum ts_status ts_bpm_chosen(struct ts_instance *self, struct tsim *sim, struct ts_bpm_words *words)
{
	return words->store.n ? make_fix(self, sim, words->store) : TS_OK;
}

static bool breaks(const struct ts_bpm_words *words)
{
	return words->breaks && !words->unbreakable;
}

enum ts_status ts_bpm_check(const struct ts_instance *self, struct tsim *sim,
			    const struct ts_bpm_words *words)
{
	if (!breaks(words) && words->smooth)
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "bond_style %s: `break no` needs `smooth no`: forces that decrease before "
			       "bonds break belong to bonds that break",
			       self->style->name);
	return TS_OK;
}

enum ts_status ts_bpm_allow(const struct ts_instance *self, struct tsim *sim,
			    const struct ts_bpm_words *words)
{
	if (breaks(words) && ts_sim_only(sim, TS_KIND_PAIR) && words->overlay == sim->neigh->skip_bonded)
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       words->overlay ? "bond_style %s: overlay/pair yes contradicts special_bonds, "
						"which switches the pair style off between bonded particles"
					      : "bond_style %s: overlay/pair no, the default, needs "
						"`special_bonds lj 0 1 1 coul 1 1 1`",
			       self->style->name);
	return TS_OK;
}
